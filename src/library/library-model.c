#include "io/exchange/check-json.h"
#include "io/exchange/drawing-import.h"
#include "io/exchange/record.h"
#include "io/project/project-generate.h"
#include "library/library-private.h"

#include <math.h>
#include <string.h>

/* A model of a project that was read, which it takes over, or else the error of that. The files that a
 * project names lie beside it. */
static QuoinModel *
take (QnProject *project, gboolean read, const char *name, GError *cause,
      QuoinError **error)
{
  QnDiag diag = { 0 };
  if (!read)
    return quoin_library_take_error (error, name, cause);
  g_autoptr (QuoinModel) model = g_new0 (QuoinModel, 1);
  g_atomic_ref_count_init (&model->references);
  model->project = *project;
  model->warnings = g_ptr_array_new_with_free_func (g_free);
  if (qn_contacts_detect (&model->project.model, &model->contacts, &diag) != QN_OK)
    return quoin_library_take_diag (error, &model->project, &diag);
  project = &model->project;
  if (project->path == NULL)
    project->path = g_strdup (name);
  if (project->model.analysis.procedure == QN_PROCEDURE_DYNAMIC
      && !qn_project_read_records (project, NULL, FALSE, &model->unread))
    g_ptr_array_add (model->warnings, g_strdup (model->unread->message));
  for (guint i = 0; i < project->warnings->len; i++)
    g_ptr_array_add (model->warnings,
                     g_strdup (g_ptr_array_index (project->warnings, i)));
  g_ptr_array_extend_and_steal (
    model->warnings, qn_project_dup_finding_texts (project, &model->contacts.findings));
  return g_steal_pointer (&model);
}

QuoinModel *
quoin_model_open (const char *path, const char *const *overrides, QuoinError **error)
{
  if (!quoin_library_given (path, "path", error))
    return NULL;
  QnProject project;
  GError *cause = NULL;
  gboolean read = qn_project_load (path, overrides, &project, &cause);
  return take (&project, read, path, cause, error);
}

QuoinModel *
quoin_model_parse (const char *text, size_t length, const char *name,
                   const char *const *overrides, QuoinError **error)
{
  if (!quoin_library_given (text, "text", error)
      || !quoin_library_given (name, "name", error))
    return NULL;
  QnProject project;
  GError *cause = NULL;
  gboolean read = qn_project_parse (text, length, name, overrides, &project, &cause);
  return take (&project, read, name, cause, error);
}

/* A model of a project that was made, which it clears: it is written and read, so that a model is always
 * what its text and overrides say. NULL with an error. */
static QuoinModel *
take_made (QnProject *project, const char *name, QuoinError **error)
{
  gsize length;
  g_autofree char *text = qn_project_to_text (project, &length);
  qn_project_clear (project);
  return quoin_model_parse (text, length, name, NULL, error);
}

static QuoinModel *
import (const char *path, const QnImportSettings *settings, char **told,
        QuoinError **error)
{
  QnProject project;
  QnImportReport report;
  GError *cause = NULL;
  QuoinModel *model = NULL;
  gboolean done = qn_import_file (path, settings, &project, &report, &cause);
  if (told != NULL && report.lines != NULL) {
    g_ptr_array_add (report.lines, NULL);
    *told = g_strjoinv ("\n", (char **) report.lines->pdata);
  }
  if (done)
    model = take_made (&project, path, error);
  else
    quoin_library_take_error (error, path, cause);
  for (guint i = 0; model != NULL && i < report.warnings->len; i++)
    g_ptr_array_insert (model->warnings, (gint) i,
                        g_strdup (g_ptr_array_index (report.warnings, i)));
  qn_import_report_clear (&report);
  return model;
}

QuoinModel *
quoin_model_import (const char *path, double unit, double thickness, double unit_weight,
                    double friction, QuoinError **error)
{
  if (!quoin_library_given (path, "path", error))
    return NULL;
  return import (path,
                 &(QnImportSettings){ .unit = unit,
                                      .thickness = thickness,
                                      .unit_weight = unit_weight,
                                      .friction = friction },
                 NULL, error);
}

QuoinModel *
quoin_model_import_with (const char *path, const char *const *options, char **report,
                         QuoinError **error)
{
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  g_autoptr (GPtrArray) layers = g_ptr_array_new ();
  GError *cause = NULL;
  if (report != NULL)
    *report = NULL;
  if (!quoin_library_given (path, "path", error))
    return NULL;
  for (; options != NULL && *options != NULL; options++) {
    const char *value = strchr (*options, '=');
    g_autofree char *name =
      value != NULL ? g_strndup (*options, (gsize) (value - *options)) : NULL;
    if (value != NULL && strcmp (name, "layer") == 0)
      g_ptr_array_add (layers, (gpointer) (value + 1));
    else if (value == NULL)
      return quoin_library_set_error (error, QUOIN_ERROR_USAGE,
                                      "expected OPTION=VALUE, not \"%s\"", *options);
    else if (!qn_import_settings_set (&settings, name, value + 1, &cause))
      return quoin_library_take_error (error, NULL, cause);
  }
  g_ptr_array_add (layers, NULL);
  settings.layers = (char **) layers->pdata;
  return import (path, &settings, report, error);
}

QuoinModel *
quoin_model_new (QuoinError **error)
{
  QnProject project;
  GError *cause = NULL;
  if (qn_project_begin (&project, "dry joint", &cause))
    return take_made (&project, "model", error);
  return quoin_library_take_error (error, NULL, cause);
}

QuoinModel *
quoin_model_generate (const char *kind, const char *const *keys, double friction,
                      QuoinError **error)
{
  static const char *const none[] = { NULL };
  QnProject project;
  GError *cause = NULL;
  if (!quoin_library_given (kind, "kind", error))
    return NULL;
  if (qn_project_generate (kind, keys != NULL ? keys : none, friction, &project, &cause))
    return take_made (&project, kind, error);
  return quoin_library_take_error (error, kind, cause);
}

char *
quoin_model_check (const QuoinModel *model)
{
  if (model == NULL)
    return NULL;
  gsize length;
  const QnProject *project = &model->project;
  QnCheckReport report = {
    .project = project,
    .contacts = &model->contacts,
    .sound =
      model->unread == NULL
      && qn_contacts_require_sound (&project->model, &model->contacts, NULL) == QN_OK,
  };
  return qn_check_report_dup_json (&report, &length);
}

static void
append_all (GPtrArray *list, const char *const *texts)
{
  for (; texts != NULL && *texts != NULL; texts++)
    g_ptr_array_add (list, (gpointer) *texts);
}

QuoinModel *
quoin_library_model_with (const QuoinModel *model, const char *const *before,
                          const char *const *after, QuoinError **error)
{
  const QnProject *project = &model->project;
  g_autoptr (GPtrArray) all = g_ptr_array_new ();
  append_all (all, before);
  append_all (all, (const char *const *) project->overrides);
  append_all (all, after);
  g_ptr_array_add (all, NULL);
  return quoin_model_parse (project->text, project->text_length, project->path,
                            (const char *const *) all->pdata, error);
}

QuoinModel *
quoin_model_with (const QuoinModel *model, const char *const *overrides,
                  QuoinError **error)
{
  if (!quoin_library_given (model, "model", error))
    return NULL;
  return quoin_library_model_with (model, NULL, overrides, error);
}

QuoinModel *
quoin_model_ref (QuoinModel *model)
{
  if (model == NULL)
    return NULL;
  g_atomic_ref_count_inc (&model->references);
  return model;
}

void
quoin_model_unref (QuoinModel *model)
{
  if (model == NULL || !g_atomic_ref_count_dec (&model->references))
    return;
  qn_contacts_clear (&model->contacts);
  qn_project_clear (&model->project);
  g_ptr_array_unref (model->warnings);
  g_clear_error (&model->unread);
  g_free (model);
}

bool
quoin_model_save (const QuoinModel *model, const char *path, QuoinError **error)
{
  if (!quoin_library_given (model, "model", error)
      || !quoin_library_given (path, "path", error))
    return false;
  GError *cause = NULL;
  if (qn_project_save (&model->project, path, &cause))
    return true;
  return quoin_library_take_error (error, path, cause);
}

char *
quoin_model_to_text (const QuoinModel *model)
{
  return model != NULL ? qn_project_to_text (&model->project, NULL) : NULL;
}

const char *
quoin_model_get_title (const QuoinModel *model)
{
  if (model == NULL)
    return NULL;
  const char *title = model->project.model.title;
  return title != NULL ? title : "";
}

const char *
quoin_model_get_source (const QuoinModel *model, size_t *length)
{
  if (length != NULL)
    *length = model != NULL ? model->project.text_length : 0;
  return model != NULL ? model->project.text : NULL;
}

const char *
quoin_model_get_override (const QuoinModel *model, size_t index)
{
  char **overrides = model != NULL ? model->project.overrides : NULL;
  return overrides != NULL && index < g_strv_length (overrides) ? overrides[index] : NULL;
}

QUOIN_GET (const char *, quoin_model_get_path, QuoinModel, NULL, of->project.path)
QUOIN_GET (size_t, quoin_model_get_warning_count, QuoinModel, 0, of->warnings->len)
QUOIN_GET_ITEM (const char *, quoin_model_get_warning, QuoinModel, of->warnings->len,
                NULL, g_ptr_array_index (of->warnings, item))
QUOIN_GET (size_t, quoin_model_get_block_count, QuoinModel, 0,
           of->project.model.block_count)
QUOIN_GET (size_t, quoin_model_get_face_count, QuoinModel, 0, of->contacts.face_count)
QUOIN_GET (size_t, quoin_model_get_pair_count, QuoinModel, 0, of->contacts.pair_count)
QUOIN_GET_ITEM (size_t, quoin_model_get_pair_face, QuoinModel, of->contacts.pair_count,
                SIZE_MAX, (size_t) of->contacts.pairs[item].face)

/* A member of a block. */
#define GET_BLOCK(type, name, none, value)                                               \
  QUOIN_GET_ITEM (type, quoin_model_get_block_##name, QuoinModel,                        \
                  of->project.model.block_count, none,                                   \
                  of->project.model.blocks[item].value)

GET_BLOCK (const char *, name, NULL, name)
GET_BLOCK (double, area, (double) NAN, area)
GET_BLOCK (double, thickness, (double) NAN, thickness)
GET_BLOCK (double, weight, (double) NAN, weight)

/* NULL where there is none. */
static const QnBlock *
get_block (const QuoinModel *model, size_t block)
{
  return model != NULL && block < model->project.model.block_count
           ? &model->project.model.blocks[block]
           : NULL;
}

const double *
quoin_model_get_block_centroid (const QuoinModel *model, size_t block)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL ? &of->centroid.x : NULL;
}

const double *
quoin_model_get_block_vertices (const QuoinModel *model, size_t block, size_t *count)
{
  G_STATIC_ASSERT (sizeof (QnVec2) == 2 * sizeof (double));
  const QnBlock *of = get_block (model, block);
  if (count != NULL)
    *count = of != NULL ? (size_t) of->vertex_count : 0;
  return of != NULL ? &model->project.model.vertices[of->first_vertex].x : NULL;
}

bool
quoin_model_is_block_fixed (const QuoinModel *model, size_t block, int dof)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL && dof >= 0 && dof < QN_DOF_COUNT && of->support[dof];
}

void
quoin_model_get_face_blocks (const QuoinModel *model, size_t face, size_t *a, size_t *b)
{
  if (!(model != NULL && face < model->contacts.face_count && a != NULL && b != NULL))
    return;
  *a = (size_t) model->contacts.faces[face].a;
  *b = (size_t) model->contacts.faces[face].b;
}

void
quoin_model_get_face_ends (const QuoinModel *model, size_t face, double ends[4])
{
  if (!(model != NULL && face < model->contacts.face_count && ends != NULL))
    return;
  const QnContactFace *of = &model->contacts.faces[face];
  const double values[4] = { of->start.x, of->start.y, of->end.x, of->end.y };
  memcpy (ends, values, sizeof values);
}
