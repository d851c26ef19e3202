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

#include <stdlib.h>
#include <string.h>

/* A controlled displacement whose rate is below this part of the fastest does not tell which
 * way the load drives it. */
#define CLEAR_RATE 1e-3

/* --- The sense of a controlled displacement ---------------------------------------------- */

static int32_t
controlled_unknown (const QnPath *path)
{
  const QnAnalysisSettings *settings = path->settings;
  size_t body = qn_model_controlled_body (path->model, settings->control_block,
                                          settings->control_node);

  return path->equilibrium.assembly
    .unknown[QN_DOF_COUNT * body + (size_t) settings->control_dof];
}

/* What is left of the way of the controlled displacement to its target. */
static double
way_to_target (const QnPath *path)
{
  const QnEquilibrium *eq = &path->equilibrium;
  const QnAnalysisSettings *settings = path->settings;
  double unit = settings->control_dof == QN_DOF_RZ ? eq->assembly.length : 1;

  return settings->control_target * unit - eq->committed.u[controlled_unknown (path)];
}

/* How the controlled displacement lies to the way that remains to its target: 1 if a growing
 * multiplier drives it there, -1 if away from it, 0 where the tangent does not tell. */
static QnStatus
find_sense (QnPath *path, int *sense, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  int32_t unknown = controlled_unknown (path);
  double way = way_to_target (path);
  double *rate = eq->live_step, fastest = 0;

  *sense = 0;
  switch (qn_equilibrium_rate (eq, rate)) {
  case QN_SOLVE_CONVERGED:
    break;
  case QN_SOLVE_NO_MEMORY:
    return qn_diag_no_memory (diag);
  case QN_SOLVE_MECHANISM:
  case QN_SOLVE_FAILED:
  case QN_SOLVE_CANCELLED:
    return QN_OK;
  }
  for (int32_t i = 0; i < as->unknown_count; i++)
    fastest = fmax (fastest, fabs (rate[i]));
  if (fabs (rate[unknown]) > CLEAR_RATE * fastest)
    *sense = rate[unknown] * way > 0 ? 1 : -1;
  return QN_OK;
}

/* The same by a step towards the target: whether the driven loads do work on it. Unloading a
 * structure that has yielded is another matter than what its tangent tells. */
static QnStatus
probe_sense (QnPath *path, int *sense, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  size_t bytes = (size_t) as->unknown_count * sizeof (double);
  double *direction = eq->motion, work = 0;
  const QnTarget step = { .direction = direction,
                          .advance = way_to_target (path) / path->settings->increments };

  *sense = 0;
  memset (direction, 0, bytes);
  direction[controlled_unknown (path)] = 1;
  QnSolveStatus solved = qn_equilibrium_newton (eq, &step, 0, QN_NEWTON_BUDGET);
  for (int32_t i = 0; i < as->unknown_count; i++)
    work += as->live[i] * (eq->u[i] - eq->committed.u[i]);
  if (solved == QN_SOLVE_CONVERGED)
    *sense = (work > 0) - (work < 0);
  qn_equilibrium_restore (eq);
  return solved == QN_SOLVE_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
}

/* --- Without stages --------------------------------------------------------------------- */

/* The live loads in one go. A target that a growing load moves away from is an input
 * error. */
static QnStatus
run_live_loads (QnPath *path, QnDiag *diag)
{
  QnAnalysisSettings *settings = &path->own_settings;
  int sense = 1;

  if (settings->max_multiplier == 0) { /* the dead load alone is asked for */
    path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    path->result->stop = QN_STOP_MULTIPLIER;
    return QN_OK;
  }
  if (!isfinite (settings->max_multiplier) && path->model->live_load_count > 0
      && !qn_model_sets_have_force (path->model, 1))
    settings->max_multiplier = 1;
  if (settings->procedure == QN_PROCEDURE_DISPLACEMENT) {
    QnStatus status = find_sense (path, &sense, diag);
    if (status != QN_OK)
      return status;
  }
  if (sense < 0)
    return qn_diag_set_field (diag, QN_PROBLEM_CONTROL_WRONG_SIGN, QN_ENTITY_ANALYSIS,
                              QN_NONE, "control.target", settings->control_target);
  return qn_path_trace (path, diag);
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
static QnStatus
begin_stage (QnPath *path, const QnStage *stage, const double *at, bool *idle,
             QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  bool controlled = stage->control_block != QN_NONE || stage->control_node != QN_NONE;
  bool settles = !controlled && !qn_model_sets_have_force (path->model, stage->sets);
  int sense = 1;

  QnAnalysisSettings *settings = &path->own_settings;

  *settings = path->model->analysis;
  settings->procedure = stage->procedure;
  if (stage->increments > 0)
    settings->increments = stage->increments;
  settings->control_block = stage->control_block;
  settings->control_node = stage->control_node;
  settings->control_dof = stage->control_dof;
  settings->control_target = stage->control_target;
  settings->max_multiplier = INFINITY;
  /* Forgets what the stage before found about its own end. */
  path->result->outcome = QN_OUTCOME_NOT_CONVERGED;
  path->result->stop = QN_STOP_UNKNOWN;
  qn_result_clear_collapse (path->result);
  qn_result_clear_events (path->result);
  set_loads (path, stage, at, 1);
  eq->multiplier = eq->committed.multiplier = 0;
  qn_equilibrium_restore (eq);
  *idle = false;
  if (stage->has_target || settles) {
    double way = (stage->has_target ? stage->target : 1) - path->origin;
    path->own_settings.max_multiplier = 1;
    *idle = way == 0;
    set_loads (path, stage, at, way);
  } else if (controlled && stage->procedure != QN_PROCEDURE_LOAD) {
    QnStatus status = probe_sense (path, &sense, diag);
    if (status == QN_OK && sense == 0)
      status = find_sense (path, &sense, diag);
    if (status != QN_OK)
      return status;
    set_loads (path, stage, at, sense < 0 ? -1 : 1);
  }
  qn_equilibrium_restore (eq);
  return QN_OK;
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
    QnStatus status = begin_stage (path, stage, at, &idle, diag);
    if (status == QN_OK && idle)
      path->result->outcome = QN_OUTCOME_TARGET_REACHED;
    else if (status == QN_OK)
      status = qn_path_trace (path, diag);
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
  status = qn_path_begin_to_follow (path, diag);
  if (status != QN_OK)
    return status;
  return path->model->stage_count > 0 ? run_stages (path, diag)
                                      : run_live_loads (path, diag);
}
