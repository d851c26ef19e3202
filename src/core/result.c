#include "core/result.h"

#include "core/memory.h"

#include <stdlib.h>
#include <string.h>

const char *
qn_outcome_name (QnOutcome outcome)
{
  static const char *const names[QN_OUTCOME_COUNT] = {
    [QN_OUTCOME_COLLAPSE] = "collapse",
    [QN_OUTCOME_TARGET_REACHED] = "target-reached",
    [QN_OUTCOME_SNAP] = "snap",
    [QN_OUTCOME_UNBOUNDED] = "unbounded",
    [QN_OUTCOME_DEAD_LOAD_UNSTABLE] = "dead-load-unstable",
    [QN_OUTCOME_CANCELLED] = "cancelled",
    [QN_OUTCOME_NOT_CONVERGED] = "not-converged",
  };
  return names[outcome];
}

const char *
qn_pair_state_name (QnPairState state)
{
  static const char *const names[QN_PAIR_STATE_COUNT] = {
    [QN_PAIR_STICK] = "stick",
    [QN_PAIR_SLIP] = "slip",
    [QN_PAIR_OPEN] = "open",
  };
  return names[state];
}

QnStatus
qn_result_init (QnResult *result, size_t block_count, size_t pair_count, QnDiag *diag)
{
  *result = (QnResult){ .outcome = QN_OUTCOME_NOT_CONVERGED,
                        .block_count = block_count,
                        .pair_count = pair_count };
  result->pairs = qn_alloc (pair_count, sizeof *result->pairs);
  return result->pairs != NULL ? QN_OK : qn_diag_no_memory (diag);
}

void
qn_result_clear (QnResult *result)
{
  free (result->steps);
  free (result->displacements);
  free (result->pairs);
  free (result->mechanism);
  free (result->unstable_blocks);
  *result = (QnResult){ 0 };
}

bool
qn_result_add_step (QnResult *result, QnStep step, const double *displacements)
{
  size_t row = result->block_count * QN_DOF_COUNT;
  QnStep *steps = qn_array_grow (result->steps, &result->step_capacity,
                                 result->step_count + 1, sizeof *steps);
  if (steps == NULL)
    return false;
  result->steps = steps;

  double *all = qn_array_grow (result->displacements, &result->displacement_capacity,
                               (result->step_count + 1) * row, sizeof *all);
  if (all == NULL)
    return false;
  result->displacements = all;

  memcpy (all + result->step_count * row, displacements, row * sizeof *all);
  steps[result->step_count++] = step;
  return true;
}

QnStatus
qn_result_set_mechanism (QnResult *result, const double *velocities,
                         double characteristic_length, QnDiag *diag)
{
  size_t count = result->block_count * QN_DOF_COUNT;
  double *mechanism = qn_alloc (count, sizeof *mechanism), translation = 0, rotation = 0;

  if (mechanism == NULL)
    return qn_diag_no_memory (diag);
  for (size_t b = 0; b < result->block_count; b++) {
    const double *v = velocities + QN_DOF_COUNT * b;
    translation = fmax (translation, hypot (v[QN_DOF_UX], v[QN_DOF_UY]));
    rotation = fmax (rotation, fabs (v[QN_DOF_RZ]) * characteristic_length);
  }
  /* Blocks that only turn about their centroids have no displacement to scale by. */
  double largest = translation > 1e-6 * rotation ? translation : rotation;
  for (size_t i = 0; i < count; i++)
    mechanism[i] = largest > 0 ? velocities[i] / largest : 0;

  free (result->mechanism);
  result->mechanism = mechanism;
  return QN_OK;
}
