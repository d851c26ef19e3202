#include "doc/view/figures.h"

#include "doc/document/underlay.h"
#include "doc/edit/edit.h"
#include "doc/view/recipe.h"
#include "doc/view/sheet.h"
#include "io/project/project.h"
#include "io/result/result-file.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#define MEMBER "figures"

GPtrArray *
qn_document_get_figures (QnDocument *document, GError **error)
{
  return qn_recipes_read (qn_document_get_project (document), error);
}

static gint64
find (const GPtrArray *recipes, const char *name)
{
  for (guint i = 0; i < recipes->len; i++) {
    if (g_str_equal (((const QnRecipe *) g_ptr_array_index (recipes, i))->name, name))
      return i;
  }
  return -1;
}

gboolean
qn_document_store_figure (QnDocument *document, const QnRecipe *recipe, GError **error)
{
  g_autoptr (GPtrArray) figures = qn_document_get_figures (document, error);
  if (figures == NULL)
    return FALSE;
  qn_document_allow_file (document, recipe->file);
  g_autofree char *digest = qn_model_digest (qn_document_get_project (document), NULL);
  QnRecipe stored = *recipe;
  stored.digest = digest;
  /* The list only lends its members to the writer. */
  g_autoptr (GPtrArray) written = g_ptr_array_new ();
  gint64 place = find (figures, recipe->name);
  for (guint i = 0; i < figures->len; i++)
    g_ptr_array_add (written,
                     i == place ? (gpointer) &stored : g_ptr_array_index (figures, i));
  if (place < 0)
    g_ptr_array_add (written, &stored);
  g_autofree char *json = qn_recipes_to_json (written);
  return qn_document_edit_extra (document, _ ("Store Figure"), NULL, MEMBER, json, error);
}

gboolean
qn_document_remove_figure (QnDocument *document, const char *name, GError **error)
{
  g_autoptr (GPtrArray) figures = qn_document_get_figures (document, error);
  if (figures == NULL)
    return FALSE;
  gint64 place = find (figures, name);
  if (place < 0)
    return TRUE;
  g_ptr_array_remove_index (figures, (guint) place);
  g_autofree char *json = figures->len > 0 ? qn_recipes_to_json (figures) : NULL;
  return qn_document_edit_extra (document, _ ("Remove Figure"), NULL, MEMBER, json,
                                 error);
}

char *
qn_document_dup_figure_name (QnDocument *document, const char *like)
{
  g_autoptr (GPtrArray) figures = qn_document_get_figures (document, NULL);
  char *name = g_strdup (like);
  for (guint i = 2; figures != NULL && find (figures, name) >= 0; i++) {
    g_free (name);
    name = g_strdup_printf ("%s-%u", like, i);
  }
  return name;
}

/* What figures without a result file show. */
static QnRun *
find_own_run (QnDocument *document)
{
  const QnAnalysisSettings *own = &document->project.model.analysis;
  return qn_document_find_run (document, own->procedure, own->flow, TRUE);
}

void
qn_document_allow_figure (QnDocument *document, const QnRecipe *recipe)
{
  qn_document_allow_file (document, recipe->file);
  if (recipe->result != NULL)
    qn_document_allow_file (document, recipe->result);
  qn_document_allow_picture (document);
}

gboolean
qn_document_figure_waits (QnDocument *document, const QnRecipe *recipe)
{
  return recipe->result == NULL && qn_recipe_needs_result (recipe)
         && find_own_run (document) == NULL;
}

/* ---- export ---- */

static gboolean
draw (QnDocument *document, const QnRecipe *recipe, const QnResult *result,
      const char *path, GError **error)
{
  QnFigure figure;
  QnMetadata metadata;
  QnUnderlay underlay;
  if (!qn_document_read_picture (document, &underlay, error))
    return FALSE;
  qn_recipe_fill (recipe, &document->project.model, &document->contacts, result, &figure);
  qn_document_get_metadata (document, &metadata);
  figure.options.underlay = underlay;
  gboolean done = qn_figure_export (&figure, path, &recipe->output, &metadata, error);
  g_clear_pointer (&underlay.image, cairo_surface_destroy);
  return done;
}

static gboolean
draw_with_file (QnDocument *document, const QnRecipe *recipe, const char *path,
                GError **error)
{
  g_autofree char *place = qn_document_dup_file (document, recipe->result, error);
  QnResultFile file;
  if (place == NULL || !qn_result_file_read (place, &file, error))
    return FALSE;
  gboolean done = qn_result_file_match (&file, place, qn_document_get_project (document),
                                        &document->contacts, NULL, error)
                  && draw (document, recipe, &file.result, path, error);
  qn_result_file_clear (&file);
  return done;
}

gboolean
qn_document_export_figure (QnDocument *document, const QnRecipe *recipe, GError **error)
{
  if (document->path == NULL)
    return qn_edit_refuse (
      error, _ ("Save the project first: its figures are written beside it"));
  g_autofree char *place = qn_document_dup_file (document, recipe->file, error);
  gboolean done = FALSE;
  if (place != NULL && recipe->result != NULL)
    done = draw_with_file (document, recipe, place, error);
  else if (place != NULL) {
    const QnRun *run = qn_recipe_needs_result (recipe) ? find_own_run (document) : NULL;
    done = draw (document, recipe, run != NULL ? &run->result : NULL, place, error);
  }
  if (!done)
    g_prefix_error (error, _ ("figure \"%s\": "), recipe->name);
  return done;
}

gboolean
qn_view_state_get_figure_as (QnViewState *state, const QnRecipe *recipe, QnFigure *figure,
                             GError **error)
{
  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  if (!qn_view_state_get_content (state, recipe->view.view, &model, &contacts, &result)) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE,
                         _ ("This view shows a result, and there is none yet"));
    return FALSE;
  }
  QnViewOptions shown = qn_view_state_get_options (state);
  qn_recipe_fill (recipe, model, contacts, result, figure);
  figure->options.underlay = shown.underlay;
  if (shown.view == recipe->view.view)
    figure->options.onion = shown.onion;
  return TRUE;
}

gboolean
qn_view_state_export_as (QnViewState *state, const QnRecipe *recipe, const char *path,
                         GError **error)
{
  QnFigure figure;
  QnMetadata metadata;
  if (!qn_view_state_get_figure_as (state, recipe, &figure, error))
    return FALSE;
  qn_document_get_metadata (state->document, &metadata);
  return qn_figure_export (&figure, path, &recipe->output, &metadata, error);
}

void
qn_document_get_metadata (QnDocument *document, QnMetadata *metadata)
{
  const char *path = document->path;
  const char *slash = path != NULL ? strrchr (path, G_DIR_SEPARATOR) : NULL;
  qn_project_get_metadata (qn_document_get_project (document), metadata);
  metadata->model = slash != NULL ? slash + 1 : path;
}

/* ---- files that go with the project ---- */

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
