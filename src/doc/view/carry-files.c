#include "doc/view/carry-files.h"

#include "doc/document/underlay.h"
#include "doc/view/figures.h"
#include "doc/view/recipe.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include <glib/gi18n-lib.h>
#include <string.h>

/* Beside the project as it was beside the old one. What is not there stays missing, what lies
 * outside of the folder stays where it is, and nothing is written over. */
static gboolean
carry_file (const char *old_folder, const char *new_folder, const char *name,
            GError **error)
{
  g_autofree char *from = qn_file_inside (old_folder, name, FALSE, NULL);
  g_autofree char *to = g_build_filename (new_folder, name, NULL);
  g_autofree char *content = NULL, *present = NULL;
  gsize length = 0, present_length = 0;
  if (g_path_is_absolute (name) || from == NULL
      || !g_file_get_contents (from, &content, &length, NULL))
    return TRUE;
  if (g_file_get_contents (to, &present, &present_length, NULL)) {
    if (length == present_length && memcmp (content, present, length) == 0)
      return TRUE;
    g_set_error (error, G_IO_ERROR, G_IO_ERROR_EXISTS,
                 _ ("The project needs its file %s, but the folder has another one of "
                    "this name"),
                 name);
    return FALSE;
  }
  g_autofree char *folder = g_path_get_dirname (to);
  return g_mkdir_with_parents (folder, 0777) != 0
         || qn_file_write (to, content, length, error);
}

gboolean
qn_document_carry_files (QnDocument *document, const char *path, GError **error)
{
  const char *old_folder = document->folder;
  const QnProject *project = qn_document_get_project (document);
  gboolean is_copy = document->path == NULL && old_folder != NULL;
  g_autofree char *new_folder = g_path_get_dirname (path);
  if (!is_copy && !qn_document_carry_picture (document, path, error))
    return FALSE;
  if (old_folder == NULL || g_str_equal (old_folder, new_folder))
    return TRUE;
  QnUnderlay underlay;
  g_autofree char *image = NULL;
  if (is_copy
      && (!qn_underlay_locate (project, NULL, &image, &underlay, error)
          || (image != NULL && !carry_file (old_folder, new_folder, image, error))))
    return FALSE;
  for (gsize i = 0; i < project->model.ground_count; i++) {
    const QnGroundMotion *motion = &project->model.ground[i];
    if (motion->kind == QN_SIGNAL_RECORD
        && !carry_file (old_folder, new_folder, motion->record, error))
      return FALSE;
  }
  g_autoptr (GPtrArray) figures = qn_document_get_figures (document, NULL);
  for (guint i = 0; figures != NULL && i < figures->len; i++) {
    const QnRecipe *recipe = g_ptr_array_index (figures, i);
    if (recipe->result != NULL
        && !carry_file (old_folder, new_folder, recipe->result, error))
      return FALSE;
  }
  return TRUE;
}
