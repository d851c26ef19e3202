#include "faults/fault-case.h"

#include "core/path/analysis.h"
#include "core/path/stability.h"

const FaultCase fault_cases[] = {
  { "load", "06-arch.quoin", FAULT_SOLVE, { NULL } },
  /* Central path, approach to collapse, a first limit point. */
  { "collapse", "ferris-tin-loi/wall3.quoin", FAULT_SOLVE, { NULL } },
  { "nonlinear",
    "ferris-tin-loi/wall1.quoin",
    FAULT_SOLVE,
    { "analysis.geometry=nonlinear", NULL } },
  /* Relaxation across jumps and into mechanisms. */
  { "relaxation", "03-rounded-block.quoin", FAULT_SOLVE, { NULL } },
  { "plastic", "08-plastic-cantilever.quoin", FAULT_SOLVE, { NULL } },
  { "reinforced", "09-reinforced-cantilever.quoin", FAULT_SOLVE, { NULL } },
  { "displacement", "24-rocking-block.quoin", FAULT_SOLVE, { NULL } },
  { "work",
    "05-stack.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=work", "analysis.geometry=nonlinear", NULL } },
  { "arc-length",
    "05-stack.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=arc-length", "analysis.geometry=nonlinear", NULL } },
  /* Steps taken as a whole along the central path, beyond where the structure has run away. */
  { "work-whole",
    "ferris-tin-loi/wall1.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=work", "laws[0].dilatancy=0.65", NULL } },
  { "stages", "16-load-stages.quoin", FAULT_SOLVE, { NULL } },
  { "unloading", "17-unloading.quoin", FAULT_SOLVE, { NULL } },
  { "settlements", "18-spreading-arch.quoin", FAULT_SOLVE, { NULL } },
  { "beams", "31-beam-elastica.quoin", FAULT_SOLVE, { NULL } },
  { "hybrid", "34-frame-hybrid.quoin", FAULT_SOLVE, { NULL } },
  { "ties", "38-tied-walls.quoin", FAULT_SOLVE, { "analysis.increments=2", NULL } },
  { "limit",
    "ferris-tin-loi/wall1.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=limit", NULL } },
  { "limit-non-associative",
    "06-arch.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=limit", "analysis.flow=non-associative", NULL } },
  /* Where the dead load itself has no equilibrium, the blocks that fall are sought. */
  { "limit-fall",
    "04-block-on-slope.quoin",
    FAULT_SOLVE,
    { "analysis.procedure=limit", "laws[0].friction=0.1", NULL } },
  { "unstable",
    "04-block-on-slope.quoin",
    FAULT_SOLVE,
    { "laws[0].friction=0.1", NULL } },
  { "stability", "20-column-free.quoin", FAULT_STABILITY, { NULL } },
  { "stability-beams", "35-beam-column.quoin", FAULT_STABILITY, { NULL } },
  { "modal", "11-vibrating-beam.quoin", FAULT_MODAL, { NULL } },
  { "modal-beams", "37-beam-vibrating.quoin", FAULT_MODAL, { NULL } },
  { "modal-loaded", "11-vibrating-beam.quoin", FAULT_MODAL_LOADED, { NULL } },
};
const size_t fault_case_count = G_N_ELEMENTS (fault_cases);

void
fault_case_load (const FaultCase *self, QnProject *project, QnContacts *contacts)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), self->example, NULL);
  GError *error = NULL;
  qn_project_load (path, self->overrides, project, &error);
  g_assert_no_error (error);
  g_assert_cmpint (qn_contacts_detect (&project->model, contacts, NULL), ==, QN_OK);
}

QnStatus
fault_case_run (const FaultCase *self, const QnProject *project,
                const QnContacts *contacts, QnProgressFunc progress, void *user_data,
                FaultAnswer *answer, QnDiag *diag)
{
  enum { MODES = 6 };
  const QnModel *model = &project->model;
  *answer = (FaultAnswer){ 0 };
  switch (self->kind) {
  case FAULT_SOLVE:
    return qn_analysis_run (model, contacts, progress, user_data, &answer->result, diag);
  case FAULT_STABILITY:
    return qn_stability_run (model, contacts, progress, user_data, &answer->result, diag);
  case FAULT_MODAL:
  case FAULT_MODAL_LOADED:
    return qn_modal_run (
      model, contacts, self->kind == FAULT_MODAL ? QN_MODAL_DEAD_LOAD : QN_MODAL_LOADED,
      MODES, progress, user_data, &answer->modes, &answer->result, diag);
  }
  g_assert_not_reached ();
}

void
fault_answer_clear (FaultAnswer *answer)
{
  qn_result_clear (&answer->result);
  qn_modes_clear (&answer->modes);
}

static void
add (GChecksum *sum, const void *data, size_t count, size_t size)
{
  if (data != NULL && count > 0)
    g_checksum_update (sum, data, (gssize) (count * size));
}

static void
add_numbers (GChecksum *sum, const double *data, size_t count)
{
  add (sum, data, count, sizeof *data);
}

/* Member by member, as structs have holes. */
static void
add_steps_and_pairs (GChecksum *sum, const QnResult *result)
{
  for (size_t i = 0; i < result->step_count; i++) {
    const QnStep *step = &result->steps[i];
    add_numbers (sum, (const double[]){ step->multiplier, step->residual }, 2);
    add (sum, (const int[]){ step->iterations, (int) step->event, step->stage }, 3,
         sizeof (int));
  }
  for (size_t p = 0; p < result->pair_count; p++) {
    const QnPairResult *pair = &result->pairs[p];
    add_numbers (sum, (const double[]){ pair->normal_force, pair->shear_force }, 2);
    add (sum, (const int[]){ (int) pair->state }, 1, sizeof (int));
  }
}

char *
fault_answer_dup_digest (const FaultAnswer *answer)
{
  const QnResult *result = &answer->result;
  const QnModes *modes = &answer->modes;
  size_t rows = qn_result_body_count (result) * QN_DOF_COUNT, steps = result->step_count;
  GChecksum *sum = g_checksum_new (G_CHECKSUM_SHA256);

  add_numbers (sum,
               (const double[]){ result->outcome, result->stop, result->stage,
                                 result->collapse_multiplier,
                                 result->first_limit_multiplier, (double) steps,
                                 result->limit.lower_bound, result->limit.upper_bound },
               8);
  add_steps_and_pairs (sum, result);
  add_numbers (sum, result->displacements, steps * rows);
  add (sum, result->beam_forces, steps * result->element_count, sizeof (QnBeamForces));
  add_numbers (sum, result->reactions, steps * result->support_count * QN_DOF_COUNT);
  add_numbers (sum, result->step_forces, steps * result->pair_count * 2);
  add_numbers (sum, result->mechanism, rows);
  add (sum, result->unstable_blocks, result->unstable_count, sizeof (QnId));
  for (int32_t i = 0; i < result->solution_count; i++)
    add_numbers (sum, &result->solutions[i].multiplier, 1);
  add_numbers (sum, modes->omega, modes->count);
  add_numbers (sum, modes->shapes,
               modes->count * (modes->block_count + modes->node_count) * QN_DOF_COUNT);

  char *text = g_strdup (g_checksum_get_string (sum));
  g_checksum_free (sum);
  return text;
}
