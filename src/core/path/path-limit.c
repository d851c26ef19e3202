/* The collapses of paths as fixed points of limit analysis.
 *
 * In linear geometry the multiplier at which a path collapses does not depend on stiffness: its forces
 * and its mechanism are an exact solution for rigid blocks, too. The sequence of linear programs
 * (limit-non-associative.c) may settle nowhere, or above it. So the paths of load control and of
 * prescribed work are followed as well; friction without dilatancy may lead them to different ends. One
 * that does not know how the structure moves on proves none: it counts only where nothing else does.
 */
#include "core/path/path.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/path/proof.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A collapse above the associative bound by more than this is none. */
#define ABOVE 1e-6

/* The forces and the mechanism of the path take the place of those of the least fixed point so far. */
static QnStatus
take_solution (QnResult *result, QnResult *found, const QnModel *model, QnDiag *diag)
{
  const QnStep *last = &found->steps[found->step_count - 1];
  double *none = qn_alloc (model->block_count * QN_DOF_COUNT, sizeof *none);
  QnStep collapse = { .multiplier = found->collapse_multiplier,
                      .iterations = result->statistics.iterations,
                      .residual = last->residual,
                      .event = QN_EVENT_COLLAPSE };

  result->step_count = 0;
  bool ok = none != NULL && qn_result_add_step (result, (QnStep){ 0 }, none)
            && qn_result_add_step (result, collapse, none);
  free (none);
  if (!ok)
    return qn_diag_no_memory (diag);
  for (size_t p = 0; p < result->pair_count; p++)
    result->pairs[p] = (QnPairResult){ .state = found->pairs[p].state,
                                       .normal_force = found->pairs[p].normal_force,
                                       .shear_force = found->pairs[p].shear_force };
  free (result->mechanism);
  result->mechanism = found->mechanism;
  found->mechanism = NULL;
  result->mechanism_uncertain = found->mechanism_uncertain;
  result->outcome = QN_OUTCOME_COLLAPSE;
  result->has_collapse_multiplier = true;
  result->collapse_multiplier = result->limit.lower_bound = found->collapse_multiplier;
  return QN_OK;
}

static QnStatus
keep_point (QnResult *result, QnResult *found, const QnModel *model, QnDiag *diag)
{
  QnLimitFigures *limit = &result->limit;
  double multiplier = found->collapse_multiplier;

  if (multiplier > result->associative_bound * (1 + ABOVE) + ABOVE
      || (limit->given && found->mechanism_uncertain))
    return QN_OK;
  if (result->mechanism_uncertain) {
    limit->given = false;
    result->solution_count = 0;
  }
  bool least = !limit->given || multiplier < limit->lower_bound;
  for (int32_t i = 0; i < found->solution_count; i++)
    qn_result_add_solution (result, found->solutions[i]);
  limit->upper_bound = limit->given ? fmax (limit->upper_bound, multiplier) : multiplier;
  limit->given = true;
  return least ? take_solution (result, found, model, diag) : QN_OK;
}

/* With the friction of its joints the structure does not stand under its dead load: no fixed point is the
 * end of a path. */
static void
take_fall (QnResult *result, QnResult *found)
{
  result->outcome = QN_OUTCOME_DEAD_LOAD_UNSTABLE;
  result->has_associative_bound = false;
  result->mechanism = found->mechanism;
  result->unstable_blocks = found->unstable_blocks;
  result->unstable_count = found->unstable_count;
  found->mechanism = NULL;
  found->unstable_blocks = NULL;
}

/* Who cancels has no answer: the least fixed point is not known then. */
static void
withdraw (QnResult *result)
{
  result->outcome = QN_OUTCOME_CANCELLED;
  result->step_count = 0;
  result->limit.given = false;
  qn_result_clear_collapse (result);
}

/* The path of rigid blocks by this procedure, as far as to collapse. */
static QnStatus
add_path (QnProcedure procedure, const QnModel *model, const QnContacts *contacts,
          QnProgressFunc report, void *report_data, QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds (), before = result->statistics.seconds;
  QnModel rigid = *model; /* whose arrays stay the model's */
  QnResult found = { 0 };
  QnPath path;
  bool stands;

  rigid.analysis.procedure = procedure;
  rigid.analysis.geometry = QN_GEOMETRY_LINEAR;
  rigid.analysis.snap = QN_SNAP_THROUGH_JUMP;
  rigid.analysis.max_multiplier = INFINITY;
  rigid.stage_count = 0;
  QnStatus status =
    qn_path_setup (&path, &rigid, contacts, report, report_data, &found, diag);
  if (status == QN_OK)
    status = qn_path_run (&path, &stands, diag);
  status = qn_path_finish (&path, status, start);
  if (status == QN_OK) {
    qn_result_judge_linearity (&rigid, &found);
    status = qn_result_prove (&rigid, contacts, &found, diag);
  }
  if (status == QN_OK) {
    qn_statistics_add (&result->statistics, &found.statistics);
    result->statistics.seconds = before + found.statistics.seconds;
    if (found.outcome == QN_OUTCOME_COLLAPSE)
      status = keep_point (result, &found, model, diag);
    else if (found.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE && !result->limit.given)
      take_fall (result, &found);
    else if (found.outcome == QN_OUTCOME_CANCELLED)
      withdraw (result);
  }
  qn_result_clear (&found);
  return status;
}

QnStatus
qn_path_add_fixed_points (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc report, void *report_data, QnResult *result,
                          QnDiag *diag)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK };
  QnStatus status = QN_OK;

  for (size_t i = 0; i < 2 && status == QN_OK && result->has_associative_bound
                     && model->analysis.flow == QN_FLOW_NON_ASSOCIATIVE
                     && result->outcome != QN_OUTCOME_CANCELLED;
       i++)
    status = add_path (procedures[i], model, contacts, report, report_data, result, diag);
  return status;
}
