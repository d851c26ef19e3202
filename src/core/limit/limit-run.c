#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/limit/limit.h"

#include <math.h>
#include <stdlib.h>

/* Of the largest strength that a pair has, or force that any pair carries: below it a force is
 * none, and a point is on the surface of the strength. */
#define STATE_TOLERANCE 1e-6

/* A pair without force is open; at a strength that limits shear it slips, at one that limits
 * compression it yields. */
static QnPairState
pair_state (const QnPairSprings *springs, const double *force, double largest)
{
  double tolerance = STATE_TOLERANCE * largest;
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  int count = qn_pair_rigid_strength (springs, rows);
  QnPairState state = QN_PAIR_STICK;

  if (hypot (force[0], force[1]) <= tolerance)
    return QN_PAIR_OPEN;
  for (const QnStrengthRow *row = rows; row < rows + count; row++) {
    if (row->shear * fabs (force[1]) + row->normal * force[0] < row->limit - tolerance)
      continue;
    if (row->shear > 0)
      return QN_PAIR_SLIP;
    if (row->normal < 0)
      state = QN_PAIR_YIELD;
  }
  return state;
}

static QnStatus
keep_solution (QnResult *result, const QnModel *model, const QnContacts *contacts,
               const QnLimitSolution *solution, QnDiag *diag)
{
  QnStatus status = QN_OK;

  result->outcome = solution->outcome;
  qn_statistics_add (&result->statistics, &solution->effort);
  if (solution->outcome != QN_OUTCOME_COLLAPSE
      && solution->outcome != QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    return QN_OK;
  if (solution->outcome == QN_OUTCOME_COLLAPSE) {
    result->has_collapse_multiplier = true;
    result->collapse_multiplier = solution->lower_bound;
    result->limit.given = true;
    result->limit.lower_bound = solution->lower_bound;
    result->limit.upper_bound = solution->upper_bound;
    result->limit.uncertainty = solution->uncertainty;
    for (int32_t i = 0; i < solution->count; i++)
      qn_result_add_solution (result,
                              (QnSolution){ .multiplier = solution->multipliers[i],
                                            .found_by = QN_PROCEDURE_LIMIT,
                                            .displacement = NAN });
    double largest = qn_largest (solution->forces, 2 * contacts->pair_count);
    for (size_t p = 0; p < contacts->pair_count; p++) {
      const double *force = solution->forces + 2 * p;
      QnPairSprings springs = qn_contacts_pair_springs (model, contacts, p);
      result->pairs[p] = (QnPairResult){ .state = pair_state (&springs, force, largest),
                                         .normal_force = force[0],
                                         .shear_force = force[1] };
    }
    /* Rigid blocks have not moved when they collapse: both steps have no displacements. */
    double *none = qn_alloc (result->block_count * QN_DOF_COUNT, sizeof *none);
    QnTieResult *ties = qn_alloc (qn_model_tie_count (model), sizeof *ties);
    for (size_t i = 0; ties != NULL && i < qn_model_tie_count (model); i++) {
      double force = solution->forces[2 * (contacts->pair_count + i)];
      ties[i] = (QnTieResult){
        .force = force,
        .state = qn_tie_state (qn_model_tie (model, i), force, STATE_TOLERANCE * largest),
      };
    }
    result->tie_count = qn_model_tie_count (model);
    QnStep collapse = { .multiplier = solution->lower_bound,
                        .iterations = solution->effort.iterations,
                        .residual = solution->check.static_residual,
                        .event = QN_EVENT_COLLAPSE };
    if (none == NULL || ties == NULL || !qn_result_add_step (result, (QnStep){ 0 }, none)
        || !qn_result_add_ties (result, NULL)
        || !qn_result_add_step (result, collapse, none)
        || !qn_result_add_ties (result, ties))
      status = qn_diag_no_memory (diag);
    free (none);
    free (ties);
  }
  if (!status)
    status = qn_result_set_mechanism (result, solution->velocities,
                                      model->characteristic_length, diag);
  if (!status && solution->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    status = qn_result_name_unstable (result, model->characteristic_length, true, diag);
  return status;
}

QnStatus
qn_limit_run (const QnModel *model, const QnContacts *contacts, double known,
              QnProgressFunc progress, void *user_data, QnResult *result, QnDiag *diag)
{
  double start = qn_clock_seconds ();
  QnLimitSolution solution = { 0 };
  QnStatus status =
    qn_result_init (result, model->block_count, contacts->pair_count, diag);

  result->limit.flow = model->analysis.flow;
  if (!status)
    status =
      model->analysis.flow == QN_FLOW_ASSOCIATIVE
        ? qn_limit_associative (model, contacts, progress, user_data, &solution, diag)
        : qn_limit_non_associative (model, contacts, known, progress, user_data,
                                    &solution, diag);
  if (!status)
    status = keep_solution (result, model, contacts, &solution, diag);
  result->has_associative_bound =
    solution.outcome == QN_OUTCOME_COLLAPSE || solution.associative > 0;
  result->associative_bound = solution.associative;
  qn_limit_solution_clear (&solution);
  result->statistics.seconds = qn_clock_seconds () - start;
  if (status)
    qn_result_clear (result);
  return status;
}
