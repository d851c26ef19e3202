#include "doc/document/underlay.h"

#include "doc/edit/edit.h"
#include "io/project/project-members.h"
#include "io/project/project.h"
#include "io/text/file-read.h"
#include "io/text/json-text.h"
#include "render/drawing/rectify.h"
#include "render/drawing/render-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Corners may lie outside of the photo, so far at most, in its width and height. */
#define MOST_PART 10.0

static const QnMember underlay_members[] = {
  QN_KNOWN ("image"),
  QN_TWO ("origin", WRITTEN, QnUnderlay, origin),
  QN_NUMBER ("width", REQUIRED, POSITIVE, QnUnderlay, width),
  QN_NUMBER ("angle", WRITTEN, FINITE, QnUnderlay, angle),
  QN_NUMBER ("opacity", WRITTEN, NOT_NEGATIVE, QnUnderlay, opacity),
  QN_KNOWN ("rectangle"),
  { 0 },
};

static const QnMember rectangle_members[] = {
  QN_KNOWN ("corners"),
  QN_NUMBER ("height", REQUIRED, POSITIVE, QnUnderlay, height),
  QN_BOOL ("cropped", OPTIONAL, QnUnderlay, cropped),
  { 0 },
};

static gboolean
read_rectangle (const QnJsonValue *object, QnUnderlay *underlay)
{
  QnJsonValue rectangle = qn_json_value_member (object, "rectangle"), corners;
  QnJsonValue corner = { 0 };
  int count = 0;
  if (rectangle.json == NULL)
    return TRUE;
  if (!qn_members_read (&rectangle, rectangle_members, NULL, underlay)
      || !qn_member_array (&rectangle, "corners", QN_REQUIRED, &corners))
    return FALSE;
  while (qn_json_value_next (&corners, &corner)) {
    if (count == 4)
      return qn_json_value_fail (&corners, _ ("must have four points"));
    if (!qn_json_value_vec2 (&corner, &underlay->points[count++]))
      return FALSE;
  }
  if (count < 4)
    return qn_json_value_fail (&corners, _ ("must have four points"));
  if (!qn_rectify_is_convex (underlay->points))
    return qn_json_value_fail (
      &corners, _ ("must be the corners of a convex quadrilateral, counter-clockwise"));
  for (int i = 0; i < 4; i++)
    if (fabs (underlay->points[i].x) > MOST_PART
        || fabs (underlay->points[i].y) > MOST_PART)
      return qn_json_value_fail (&corners, _ ("is too far outside of the photo"));
  underlay->rectified = true;
  return TRUE;
}

static gboolean
read_members (const QnJsonValue *object, const char **image, QnUnderlay *underlay)
{
  if (!qn_members_read (object, underlay_members, NULL, underlay)
      || !qn_member_string (object, "image", QN_REQUIRED, image)
      || !read_rectangle (object, underlay))
    return FALSE;
  if (underlay->opacity > 1) {
    QnJsonValue place = qn_json_value_member (object, "opacity");
    return qn_json_value_fail (&place, _ ("must not be above 1"));
  }
  return TRUE;
}

gboolean
qn_underlay_locate (const QnProject *project, const char *folder, char **path,
                    QnUnderlay *underlay, GError **error)
{
  QnReader reader = qn_project_reader (project);
  const char *image = NULL;
  *path = NULL;
  *underlay = (QnUnderlay){ .width = 1, .opacity = 0.6 };
  if (project->extras == NULL)
    return TRUE;
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue object = qn_json_value_member (&root, "underlay");
  if (object.json == NULL)
    return TRUE;
  if (!read_members (&object, &image, underlay)) {
    g_propagate_error (error, reader.error);
    return FALSE;
  }
  *path = folder == NULL || g_path_is_absolute (image)
            ? g_strdup (image)
            : g_build_filename (folder, image, NULL);
  return TRUE;
}

/* Puts the photo of that file behind the drawing, rectified where the underlay says so. */
static gboolean
load_photo (const char *path, QnUnderlay *underlay, GError **error)
{
  cairo_surface_t *photo = qn_photo_load (path, error);
  underlay->image = photo;
  if (photo == NULL || !underlay->rectified)
    return photo != NULL;
  underlay->image = qn_rectify (
    photo, underlay->points, underlay->cropped ? 0 : QN_RECTIFY_MARGIN, &underlay->seen);
  cairo_surface_destroy (photo);
  if (underlay->image == NULL)
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                         _ ("There is not enough memory to rectify the photo"));
  return underlay->image != NULL;
}

gboolean
qn_underlay_read (const QnProject *project, gboolean allow_outside, QnUnderlay *underlay,
                  GError **error)
{
  g_autofree char *folder =
    g_path_get_dirname (project->path != NULL ? project->path : "");
  g_autofree char *name = NULL;
  if (!qn_underlay_locate (project, folder, &name, underlay, error))
    return FALSE;
  if (name == NULL)
    return TRUE;
  g_autofree char *path = qn_file_inside (folder, name, allow_outside, error);
  return path != NULL && load_photo (path, underlay, error);
}

/* How a project in `folder` (nullable: not saved yet) calls an image: by a path from there
 * where it lies within the folder, by the whole path otherwise. */
static char *
dup_name (const char *path, const char *folder)
{
  g_autofree char *whole = g_canonicalize_filename (path, NULL);
  g_autofree char *base = folder != NULL ? g_canonicalize_filename (folder, NULL) : NULL;
  gsize length = base != NULL ? strlen (base) : 0;
  if (base != NULL && g_str_has_prefix (whole, base) && whole[length] == G_DIR_SEPARATOR)
    return g_strdup (whole + length + 1);
  return g_steal_pointer (&whole);
}

char *
qn_underlay_to_json (const char *image, const QnUnderlay *underlay)
{
  GString *json = g_string_new ("{");
  qn_json_put_string (json, "image", image);
  qn_members_write (json, underlay_members, NULL, underlay, NULL);
  if (underlay->rectified) {
    qn_json_begin_member (json, "rectangle");
    g_string_append_c (json, '{');
    qn_json_put_points (json, "corners", underlay->points, 4);
    qn_members_write (json, rectangle_members, NULL, underlay, &(QnUnderlay){ 0 });
    g_string_append (json, " }");
  }
  g_string_append (json, " }");
  return g_string_free (json, FALSE);
}

bool
qn_underlay_match (QnUnderlay *underlay, const QnVec2 shown[2], const QnVec2 wanted[2])
{
  QnVec2 from = qn_vec2_sub (shown[1], shown[0]), to = qn_vec2_sub (wanted[1], wanted[0]);
  double from_length = qn_vec2_length (from), to_length = qn_vec2_length (to);
  if (!(from_length > 0) || !(to_length > 0))
    return false;
  double scale = to_length / from_length;
  double turn = atan2 (qn_vec2_cross (from, to), qn_vec2_dot (from, to));
  QnVec2 arm = qn_vec2_sub (underlay->origin, shown[0]);
  QnVec2 turned = qn_vec2_rotate (arm, cos (turn), sin (turn));
  underlay->origin = qn_vec2_add_scaled (wanted[0], scale, turned);
  underlay->width *= scale;
  underlay->height *= scale;
  underlay->angle = remainder (underlay->angle + turn, 2 * G_PI);
  return true;
}

/* A place of the model as parts of the photo's width and height. */
static bool
to_photo (const QnUnderlay *u, QnVec2 at, QnVec2 *photo)
{
  QnVec2 arm = qn_vec2_sub (at, u->origin), corners[4];
  if (!qn_underlay_corners (u, corners))
    return false;
  arm = qn_vec2_rotate (arm, cos (u->angle), -sin (u->angle));
  double height =
    u->rectified ? u->height : qn_vec2_length (qn_vec2_sub (corners[3], corners[0]));
  QnVec2 part = { arm.x / u->width, arm.y / height };
  if (u->rectified)
    return qn_rectify_to_photo (u->points, part, photo);
  *photo = part;
  return true;
}

bool
qn_underlay_rectify (QnUnderlay *underlay, const QnVec2 shown[4], double width,
                     double height)
{
  QnVec2 corners[4], points[4];
  memcpy (corners, shown, sizeof corners);
  if (!qn_rectify_sort (corners) || !(width > 0) || !(height > 0))
    return false;
  for (int i = 0; i < 4; i++)
    if (!to_photo (underlay, corners[i], &points[i]) || fabs (points[i].x) > MOST_PART
        || fabs (points[i].y) > MOST_PART)
      return false;
  if (!qn_rectify_is_convex (points))
    return false;
  memcpy (underlay->points, points, sizeof points);
  underlay->rectified = true;
  underlay->origin = corners[0];
  underlay->width = width;
  underlay->height = height;
  underlay->angle = 0;
  return true;
}

void
qn_underlay_show_as_taken (QnUnderlay *underlay)
{
  const double part = fabs (underlay->points[1].x - underlay->points[0].x);
  if (part > 0)
    underlay->width /= part;
  underlay->rectified = false;
  underlay->height = 0;
  underlay->angle = 0;
}

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
  const char *folder = document->folder;
  g_autofree char *whole = g_canonicalize_filename (file, folder);
  gboolean allowed = g_hash_table_contains (allowed_files (document), whole);
  return qn_file_inside (folder, file, allowed, error);
}

gboolean
qn_document_read_picture (QnDocument *document, QnUnderlay *underlay, GError **error)
{
  g_autofree char *name = NULL;
  if (!qn_underlay_locate (qn_document_get_project (document), document->folder, &name,
                           underlay, error))
    return FALSE;
  if (name == NULL)
    return TRUE;
  g_autofree char *path = qn_document_dup_file (document, name, error);
  return path != NULL && load_photo (path, underlay, error);
}

void
qn_document_allow_file (QnDocument *document, const char *file)
{
  const char *folder = document->folder;
  g_hash_table_add (allowed_files (document), g_canonicalize_filename (file, folder));
}

void
qn_document_allow_picture (QnDocument *document)
{
  QnUnderlay underlay;
  const char *folder = document->folder;
  g_autofree char *path = NULL;
  if (qn_underlay_locate (qn_document_get_project (document), folder, &path, &underlay,
                          NULL)
      && path != NULL)
    qn_document_allow_file (document, path);
}

gboolean
qn_document_insert_picture (QnDocument *document, const char *path, GError **error)
{
  cairo_surface_t *image = qn_photo_load (path, error);
  if (image == NULL)
    return FALSE;
  cairo_surface_destroy (image);
  qn_document_allow_file (document, path);
  const QnModel *model = &document->project.model;
  QnUnderlay underlay = { .width = 5, .opacity = 0.6 };
  QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  for (gsize i = 0; i < model->node_count; i++)
    qn_box_add_point (&box, model->nodes[i].at);
  if (!qn_box_is_empty (box)) {
    underlay.origin = box.min;
    underlay.width = MAX (box.max.x - box.min.x, 1e-3);
  }
  const char *folder = document->folder;
  g_autofree char *name = dup_name (path, folder);
  g_autofree char *json = qn_underlay_to_json (name, &underlay);
  return qn_document_edit_extra (document, _ ("Add Picture"), NULL, MEMBER, json, error);
}

/* Path of the present picture, or NULL with an error. */
static char *
dup_image (QnDocument *document, QnUnderlay *underlay, GError **error)
{
  char *path = NULL;
  if (qn_underlay_locate (qn_document_get_project (document), NULL, &path, underlay,
                          error)
      && path == NULL)
    qn_edit_refuse (error, _ ("There is no picture behind the drawing"));
  return path;
}

gboolean
qn_document_place_picture (QnDocument *document, const char *name, const char *key,
                           const QnUnderlay *underlay, GError **error)
{
  QnUnderlay before;
  g_autofree char *image = dup_image (document, &before, error);
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
  if (!qn_underlay_locate (qn_document_get_project (document), document->folder, &image,
                           &underlay, error))
    return FALSE;
  if (image == NULL)
    return TRUE;
  g_autofree char *name = dup_name (image, new_folder);
  g_autofree char *present = dup_image (document, &underlay, NULL);
  if (g_strcmp0 (present, name) == 0)
    return TRUE;
  g_autofree char *json = qn_underlay_to_json (name, &underlay);
  return qn_document_edit_extra (document, _ ("Rename Picture"), NULL, MEMBER, json,
                                 error);
}
