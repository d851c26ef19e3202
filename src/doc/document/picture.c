#include "doc/document/picture.h"

#include "doc/edit/edit.h"
#include "io/text/file-read.h"
#include "render/drawing/photo.h"
#include "render/drawing/rectify.h"
#include <glib/gi18n-lib.h>

#define MEMBER "underlay"

/* Files allowed in this session, by their whole paths. */
static GHashTable *
allowed_files (QnDocument *document)
{
  static const char key[] = "qn-allowed-files";
  GHashTable *files = g_object_get_data (G_OBJECT (document), key);
  if (files == NULL) {
    files = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
    g_object_set_data_full (G_OBJECT (document), key, files,
                            (GDestroyNotify) g_hash_table_unref);
  }
  return files;
}

char *
qn_document_dup_file (QnDocument *document, const char *file, GError **error)
{
  const char *folder = qn_document_get_folder (document);
  g_autofree char *whole = g_canonicalize_filename (file, folder);
  gboolean allowed = g_hash_table_contains (allowed_files (document), whole);
  return qn_file_inside (folder, file, allowed, error);
}

void
qn_document_allow_file (QnDocument *document, const char *file)
{
  const char *folder = qn_document_get_folder (document);
  g_hash_table_add (allowed_files (document), g_canonicalize_filename (file, folder));
}

void
qn_document_allow_picture (QnDocument *document)
{
  QnUnderlay underlay;
  const char *folder = qn_document_get_folder (document);
  g_autofree char *path = NULL;
  if (qn_underlay_locate (qn_document_get_project (document), folder, &path, &underlay,
                          NULL)
      && path != NULL)
    qn_document_allow_file (document, path);
}

gboolean
qn_document_insert_picture (QnDocument *document, const char *path, QnBox view,
                            GError **error)
{
  cairo_surface_t *image = qn_photo_load (path, error);
  if (image == NULL)
    return FALSE;
  cairo_surface_destroy (image);
  qn_document_allow_file (document, path);
  const QnModel *model = qn_document_get_model (document);
  QnBox box = model->block_count > 0
                ? qn_box_of_points (model->vertices, model->vertex_count)
                : view;
  QnUnderlay underlay = { .origin = box.min,
                          .width = MAX (box.max.x - box.min.x, 1e-3),
                          .opacity = 0.6 };
  const char *folder = qn_document_get_folder (document);
  g_autofree char *name = qn_underlay_dup_name (path, folder);
  g_autofree char *json = qn_underlay_to_json (name, &underlay);
  return qn_document_edit_extra (document, _ ("Add Picture"), NULL, MEMBER, json, error);
}

/* Path of the present picture, or NULL with an error. */
static char *
dup_image (QnDocument *document, const char *folder, QnUnderlay *underlay, GError **error)
{
  char *path = NULL;
  if (qn_underlay_locate (qn_document_get_project (document), folder, &path, underlay,
                          error)
      && path == NULL)
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("There is no picture behind the drawing"));
  return path;
}

gboolean
qn_document_place_picture (QnDocument *document, const char *name, const char *key,
                           const QnUnderlay *underlay, GError **error)
{
  QnUnderlay before;
  g_autofree char *image = dup_image (document, NULL, &before, error);
  if (image == NULL)
    return FALSE;
  if (underlay->rectified && !qn_rectify_is_convex (underlay->points))
    return qn_edit_refuse (error,
                           _ ("These four points cannot be the corners of a rectangle"));
  g_autofree char *json = qn_underlay_to_json (image, underlay);
  return qn_document_edit_extra (document, name, key, MEMBER, json, error);
}

gboolean
qn_document_remove_picture (QnDocument *document, GError **error)
{
  return qn_document_edit_extra (document, _ ("Remove Picture"), NULL, MEMBER, NULL,
                                 error);
}

gboolean
qn_document_carry_picture (QnDocument *document, const char *path, GError **error)
{
  g_autofree char *new_folder = g_path_get_dirname (path);
  QnUnderlay underlay;
  g_autofree char *image = NULL;
  if (!qn_underlay_locate (qn_document_get_project (document),
                           qn_document_get_folder (document), &image, &underlay, error))
    return FALSE;
  if (image == NULL)
    return TRUE;
  g_autofree char *name = qn_underlay_dup_name (image, new_folder);
  g_autofree char *present = dup_image (document, NULL, &underlay, NULL);
  if (g_strcmp0 (present, name) == 0)
    return TRUE;
  g_autofree char *json = qn_underlay_to_json (name, &underlay);
  return qn_document_edit_extra (document, _ ("Rename Picture"), NULL, MEMBER, json,
                                 error);
}
