/* Stages of loading: a sequence of paths over one state.
 *
 * A stage drives its load sets from the multiplier that they stand at; everything else is held.
 * To the procedures it looks like any analysis: their multiplier mu starts at 0, what is held
 * counts as dead load,
 *
 *   dead + sum over all sets of at[set] F[set] + mu scale F[driven],   lambda = origin + mu scale
 *
 * so that unloading, too, is a path along which mu grows. With a target, mu ends at 1.
 */
#include "core/path/path.h"

/* --- Without stages --------------------------------------------------------------------- */

/* The live loads in one go. A target that a growing load moves away from is an input
 * error. */
static QnStatus
run_live_loads (QnPath *path, QnDiag *diag)
{
  QnAnalysisSettings *settings = &path->own_settings;
  bool reverses = false;

  if (settings->max_multiplier == 0) { /* the dead load alone is asked for */
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    path->result->stop = QN_STOP_MULTIPLIER;
    return QN_OK;
  }
  if (!isfinite (settings->max_multiplier) && path->model->live_load_count > 0
      && !qn_model_sets_have_force (path->model, 1))
    settings->max_multiplier = 1;
  QnStatus status = qn_path_trace (
    path, settings->procedure == QN_PROCEDURE_DISPLACEMENT ? &reverses : NULL, diag);
  if (status == QN_OK && reverses)
    return qn_diag_set_field (diag, QN_PROBLEM_CONTROL_WRONG_SIGN, QN_ENTITY_ANALYSIS,
                              QN_NONE, "control.target", settings->control.target);
  return status;
}

/* --- One stage -------------------------------------------------------------------------- */

/* Loads of the stage with the sets at `at` and those driven growing by `scale` per mu. */
static void
set_loads (QnPath *path, const QnStage *stage, const double *at, double scale)
{
  double driven[QN_MAX_LOAD_SETS] = { 0 };

  path->scale = scale;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    if ((stage->sets >> set & 1) != 0) {
      driven[set] = scale;
      path->origin = at[set];
    }
  qn_assembly_set_loads (&path->equilibrium.assembly, at, driven);
}

/* Puts the solver at mu = 0 under the loads as they stand. *idle is set where the stage would
 * end where it begins. */
static void
begin_stage (QnPath *path, const QnStage *stage, const double *at, bool *idle)
{
  QnEquilibrium *eq = &path->equilibrium;
  bool controlled = qn_control_is_given (&stage->control);
  bool settles = !controlled && !qn_model_sets_have_force (path->model, stage->sets);
  QnAnalysisSettings *settings = &path->own_settings;

  *settings = path->model->analysis;
  settings->procedure = stage->procedure;
  if (stage->increments > 0)
    settings->increments = stage->increments;
  settings->control = stage->control;
  settings->max_multiplier = INFINITY;
  /* Forgets what the stage before found about its own end. */
  path->result->outcome = QN_OUTCOME_NOT_CONVERGED;
  path->result->stop = QN_STOP_UNKNOWN;
  qn_result_clear_collapse (path->result);
  set_loads (path, stage, at, 1);
  eq->multiplier = eq->committed.multiplier = 0;
  *idle = false;
  if (stage->has_target || settles) {
    double way = (stage->has_target ? stage->target : 1) - path->origin;
    path->own_settings.max_multiplier = 1;
    *idle = way == 0;
    set_loads (path, stage, at, way);
  }
  qn_equilibrium_restore (eq);
}

/* Follows the stage. Where a prescribed displacement takes the driven loads back, their multiplier falls. */
static QnStatus
follow_stage (QnPath *path, const QnStage *stage, const double *at, QnDiag *diag)
{
  bool may_reverse =
    qn_control_is_given (&stage->control) && stage->procedure != QN_PROCEDURE_LOAD;
  bool reverses = false;
  QnStatus status = qn_path_trace (path, may_reverse ? &reverses : NULL, diag);

  if (status != QN_OK || !reverses)
    return status;
  set_loads (path, stage, at, -1);
  qn_equilibrium_restore (&path->equilibrium);
  return qn_path_trace (path, NULL, diag);
}

static QnStatus
run_stages (QnPath *path, QnDiag *diag)
{
  const QnModel *model = path->model;
  double at[QN_MAX_LOAD_SETS] = { 0 };
  bool idle = false;

  for (size_t i = 0; i < model->stage_count; i++) {
    const QnStage *stage = &model->stages[i];
    path->stage = path->result->stage = (int32_t) i + 1;
    QnStatus status = QN_OK;
    begin_stage (path, stage, at, &idle);
    if (idle)
      path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    else
      status = follow_stage (path, stage, at, diag);
    if (status != QN_OK)
      return status;
    /* Gives the multipliers that the stage ended with their meaning. */
    QnResult *result = path->result;
    double reached = path->equilibrium.committed.multiplier;

    result->collapse_multiplier =
      path->origin + path->scale * result->collapse_multiplier;
    for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
      if ((stage->sets >> set & 1) != 0)
        at[set] = path->origin + path->scale * reached;
    if (path->result->outcome != QN_OUTCOME_TARGET_REACHED)
      return QN_OK;
  }
  return QN_OK;
}

QnStatus
qn_path_run (QnPath *path, bool *stands, QnDiag *diag)
{
  QnStatus status = qn_path_apply_dead_load (path, stands, diag);

  if (status != QN_OK || !*stands)
    return status;
  path->own_settings = path->model->analysis;
  path->settings = &path->own_settings;
  status = qn_path_begin_to_follow (path, path->model->analysis.follow, diag);
  if (status != QN_OK)
    return status;
  return path->model->stage_count > 0 ? run_stages (path, diag)
                                      : run_live_loads (path, diag);
}
