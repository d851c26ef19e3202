#include "core/path/bound.h"

#include "core/base/clock.h"
#include "core/base/memory.h"
#include "core/limit/limit.h"

#include <stdlib.h>
#include <string.h>

static bool
wants_bound (const QnModel *model, const QnContacts *contacts, const QnResult *result)
{
  const QnAnalysisSettings *settings = &model->analysis;

  for (size_t i = 0; i < model->live_load_count; i++)
    if (model->live_loads[i].kind == QN_LOAD_SETTLEMENT)
      return false;
  return !result->has_associative_bound && settings->geometry == QN_GEOMETRY_LINEAR
         && model->stage_count == 0 && model->element_count == 0
         && (settings->bound == QN_BOUND_ALWAYS
             || (settings->bound == QN_BOUND_AUTO
                 && contacts->pair_count <= QN_BOUND_PAIRS));
}

QnStatus
qn_path_add_bound (const QnModel *model, const QnContacts *contacts,
                   QnProgressFunc report, void *report_data, QnResult *result,
                   bool *cancelled, QnDiag *diag)
{
  QnLimitSolution solution;
  double start = qn_clock_seconds ();

  if (!wants_bound (model, contacts, result))
    return QN_OK;
  QnStatus status =
    qn_limit_associative (model, contacts, report, report_data, &solution, NULL);
  if (status == QN_OK && solution.outcome == QN_OUTCOME_COLLAPSE) {
    result->has_associative_bound = true;
    result->associative_bound = solution.upper_bound;
  }
  if (cancelled != NULL)
    *cancelled = status == QN_OK && solution.outcome == QN_OUTCOME_CANCELLED;
  qn_limit_solution_clear (&solution);
  result->statistics.seconds += qn_clock_seconds () - start;
  return status == QN_ERROR_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}

QnStatus
qn_path_add_broken_bound (const QnModel *model, const QnContacts *contacts,
                          QnProgressFunc report, void *report_data, QnResult *result,
                          QnDiag *diag)
{
  QnModel dry = *model; /* but for its laws */
  QnLimitSolution solution;
  double start = qn_clock_seconds ();

  if (!qn_model_has_bonds (model) || !result->has_associative_bound
      || model->analysis.bound == QN_BOUND_NEVER)
    return QN_OK;
  dry.laws = qn_alloc (model->law_count, sizeof *dry.laws);
  if (dry.laws == NULL)
    return qn_diag_no_memory (diag);
  memcpy (dry.laws, model->laws, model->law_count * sizeof *dry.laws);
  for (size_t i = 0; i < model->law_count; i++)
    qn_law_break_bond (&dry.laws[i]);
  QnStatus status =
    qn_limit_associative (&dry, contacts, report, report_data, &solution, NULL);
  result->has_broken_bound = status == QN_OK
                             && (solution.outcome == QN_OUTCOME_COLLAPSE
                                 || solution.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  result->broken_bound =
    result->has_broken_bound && solution.outcome == QN_OUTCOME_COLLAPSE
      ? solution.lower_bound
      : 0;
  qn_limit_solution_clear (&solution);
  free (dry.laws);
  result->statistics.seconds += qn_clock_seconds () - start;
  return status == QN_ERROR_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}
