/* The check of a collapse multiplier by a load that advances with the motion.
 *
 * With dry friction several exact solutions may exist on one structure. Where the path turns down, a
 * load that is held lets the structure jump, and load control takes the equilibrium that it finds
 * beyond, though one above what the structure carries while it moves. Held by a jack that prescribes
 * the work of the load, it goes through all equilibria on its way and cannot skip those that are
 * lower. The lower multiplier is the one to count on: of 32 seeded walls of 20 to 80 blocks
 * (bench-paths --seeds 1-32 --least 20 --most 80) load control alone was more than 1 % higher on
 * eleven, at most by a third.
 */
#include "core/path/path.h"

#include <stdlib.h>

/* What load control has found stands unless the check ends below it by more than this part: by less
 * two ways to the same plateau may differ. */
#define LOWER 5e-3

/* Factorisations of the check: as many as load control has taken, and at least so many. A check that
 * takes more has not decided. */
#define LEAST_BUDGET 1000

/* Asks whoever started the analysis, and the budget. */
typedef struct Watch {
  QnProgressFunc report;
  void *report_data;
  int32_t before, budget; /* factorisations */
  int32_t iterations_before;
  bool cancelled; /* by whoever started it */
} Watch;

static bool
go_on (const QnProgress *progress, void *data)
{
  Watch *watch = data;
  QnProgress whole = *progress;

  whole.factorizations += watch->before;
  whole.iterations += watch->iterations_before;
  watch->cancelled = watch->report != NULL && !watch->report (&whole, watch->report_data);
  return !watch->cancelled && progress->factorizations < watch->budget;
}

static QnStatus
follow_by_work (QnPath *check, double end, QnDiag *diag)
{
  bool stands;
  QnStatus status = qn_path_apply_dead_load (check, &stands, diag);

  if (status != QN_OK || !stands)
    return status;
  check->own_settings = check->model->analysis;
  check->own_settings.procedure = QN_PROCEDURE_WORK;
  check->own_settings.snap = QN_SNAP_THROUGH_JUMP;
  check->own_settings.control_block = check->own_settings.control_node = QN_NONE;
  check->own_settings.max_multiplier = end;
  check->settings = &check->own_settings;
  check->ends_at_peak = true;
  return qn_path_motion_control (check, diag);
}

/* Cancelled before it was known whether what load control found stands. */
static void
end_cancelled (QnResult *result)
{
  result->outcome = QN_OUTCOME_CANCELLED;
  result->has_collapse_multiplier = result->mechanism_uncertain = false;
  result->steps[result->step_count - 1].event = QN_EVENT_NONE;
  free (result->mechanism);
  result->mechanism = NULL;
}

/* The path and its result become those of the check. */
static void
adopt (QnPath *path, QnPath *check)
{
  QnResult *result = path->result, *lower = check->result, swapped = *result;
  double first_limit = result->first_limit_multiplier;
  QnPath old = *path;

  if (result->has_first_limit_multiplier && first_limit < lower->collapse_multiplier)
    lower->first_limit_multiplier = first_limit;
  lower->stop = QN_STOP_UNKNOWN;
  *result = *lower;
  *lower = swapped;
  *path = *check;
  *check = old;
  path->result = result;
  path->own_settings = old.own_settings;
  path->settings = &path->own_settings;
  check->result = lower;
}

QnStatus
qn_path_check_collapse (QnPath *path, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  int32_t taken = eq->statistics.factorizations;
  Watch watch = { .report = eq->report,
                  .report_data = eq->report_data,
                  .before = taken,
                  .iterations_before = eq->statistics.iterations,
                  .budget = taken > LEAST_BUDGET ? taken : LEAST_BUDGET };
  double end = (1 - LOWER) * path->result->collapse_multiplier;
  QnResult result = { 0 };
  QnPath check = { 0 };

  QnStatus status = qn_path_setup (&check, path->model, eq->assembly.contacts, go_on,
                                   &watch, &result, diag);
  if (status == QN_OK)
    status = follow_by_work (&check, end, diag);
  if (status == QN_OK) {
    qn_statistics_add (&eq->statistics, &check.equilibrium.statistics);
    check.equilibrium.statistics = eq->statistics;
    if (result.outcome == QN_OUTCOME_COLLAPSE && result.stop == QN_STOP_PLATEAU
        && result.collapse_multiplier < end)
      adopt (path, &check);
    if (watch.cancelled)
      end_cancelled (path->result);
  }
  qn_result_clear (&result);
  qn_path_clear (&check);
  return status;
}
