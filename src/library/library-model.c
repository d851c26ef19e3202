#include "io/exchange/drawing-import.h"
#include "io/exchange/record.h"
#include "library/library-private.h"

#include <math.h>
#include <string.h>

static void
free_model (QuoinModel *model)
{
  qn_contacts_clear (&model->contacts);
  qn_project_clear (&model->project);
  g_ptr_array_unref (model->warnings);
  g_clear_error (&model->unread);
  g_free (model);
}

QuoinModel *
quoin_library_model_take (QnProject *project, QuoinError **error)
{
  QnDiag diag = { 0 };
  QuoinModel *model = g_new0 (QuoinModel, 1);
  g_atomic_ref_count_init (&model->references);
  model->project = *project;
  model->warnings = g_ptr_array_new_with_free_func (g_free);
  if (qn_contacts_detect (&model->project.model, &model->contacts, &diag) != QN_OK) {
    quoin_library_take_diag (error, &model->project, &diag);
    free_model (model);
    return NULL;
  }
  if (project->model.analysis.procedure == QN_PROCEDURE_DYNAMIC
      && !qn_project_read_records (&model->project, NULL, FALSE, &model->unread))
    g_ptr_array_add (model->warnings, g_strdup (model->unread->message));
  for (guint i = 0; i < model->project.warnings->len; i++)
    g_ptr_array_add (model->warnings,
                     g_strdup (g_ptr_array_index (model->project.warnings, i)));
  g_ptr_array_extend_and_steal (
    model->warnings,
    qn_project_dup_finding_texts (&model->project, &model->contacts.findings));
  return model;
}

QuoinModel *
quoin_model_open (const char *path, const char *const *overrides, QuoinError **error)
{
  if (!quoin_library_given (path, "path", error))
    return NULL;
  QnProject project;
  GError *cause = NULL;
  if (!qn_project_load (path, overrides, &project, &cause)) {
    quoin_library_take_error (error, path, cause);
    return NULL;
  }
  return quoin_library_model_take (&project, error);
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
  if (!qn_project_parse (text, length, name, overrides, &project, &cause)) {
    quoin_library_take_error (error, name, cause);
    return NULL;
  }
  return quoin_library_model_take (&project, error);
}

QuoinModel *
quoin_model_import (const char *path, double unit, double thickness, double unit_weight,
                    double friction, QuoinError **error)
{
  if (!quoin_library_given (path, "path", error))
    return NULL;
  QnProject project;
  QnImportReport report;
  GError *cause = NULL;
  QnImportSettings settings = {
    .unit = unit, .thickness = thickness, .unit_weight = unit_weight, .friction = friction
  };
  if (!qn_import_file (path, &settings, &project, &report, &cause)) {
    quoin_library_take_error (error, path, cause);
    qn_import_report_clear (&report);
    return NULL;
  }
  QuoinModel *model = quoin_library_model_take (&project, error);
  for (guint i = 0; model != NULL && i < report.warnings->len; i++)
    g_ptr_array_insert (model->warnings, (gint) i,
                        g_strdup (g_ptr_array_index (report.warnings, i)));
  qn_import_report_clear (&report);
  return model;
}

QuoinModel *
quoin_model_with (const QuoinModel *model, const char *const *overrides,
                  QuoinError **error)
{
  if (!quoin_library_given (model, "model", error))
    return NULL;
  gsize length;
  g_autofree char *text = qn_project_to_text (&model->project, &length);
  return quoin_model_parse (text, length, model->project.name, overrides, error);
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
  if (model != NULL && g_atomic_ref_count_dec (&model->references))
    free_model (model);
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
  quoin_library_take_error (error, path, cause);
  return false;
}

char *
quoin_model_to_text (const QuoinModel *model)
{
  if (model == NULL)
    return NULL;
  return qn_project_to_text (&model->project, NULL);
}

const char *
quoin_model_get_title (const QuoinModel *model)
{
  if (model == NULL)
    return NULL;
  const char *title = model->project.model.title;
  return title != NULL ? title : "";
}

size_t
quoin_model_get_warning_count (const QuoinModel *model)
{
  if (model == NULL)
    return 0;
  return model->warnings->len;
}

const char *
quoin_model_get_warning (const QuoinModel *model, size_t index)
{
  if (!(model != NULL && index < model->warnings->len))
    return NULL;
  return g_ptr_array_index (model->warnings, index);
}

size_t
quoin_model_get_block_count (const QuoinModel *model)
{
  if (model == NULL)
    return 0;
  return model->project.model.block_count;
}

/* NULL where there is none. */
static const QnBlock *
get_block (const QuoinModel *model, size_t block)
{
  return model != NULL && block < model->project.model.block_count
           ? &model->project.model.blocks[block]
           : NULL;
}

const char *
quoin_model_get_block_name (const QuoinModel *model, size_t block)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL ? of->name : NULL;
}

double
quoin_model_get_block_area (const QuoinModel *model, size_t block)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL ? of->area : (double) NAN;
}

double
quoin_model_get_block_thickness (const QuoinModel *model, size_t block)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL ? of->thickness : (double) NAN;
}

double
quoin_model_get_block_weight (const QuoinModel *model, size_t block)
{
  const QnBlock *of = get_block (model, block);
  return of != NULL ? of->weight : (double) NAN;
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

size_t
quoin_model_get_face_count (const QuoinModel *model)
{
  if (model == NULL)
    return 0;
  return model->contacts.face_count;
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

size_t
quoin_model_get_pair_count (const QuoinModel *model)
{
  if (model == NULL)
    return 0;
  return model->contacts.pair_count;
}

size_t
quoin_model_get_pair_face (const QuoinModel *model, size_t pair)
{
  if (!(model != NULL && pair < model->contacts.pair_count))
    return SIZE_MAX;
  return (size_t) model->contacts.pairs[pair].face;
}
