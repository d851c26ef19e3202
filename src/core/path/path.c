#include "core/path/path.h"

#include "core/base/clock.h"
#include "core/base/memory.h"

QnStatus
qn_path_setup (QnPath *path, const QnModel *model, const QnContacts *contacts,
               QnProgressFunc report, void *report_data, QnResult *result, QnDiag *diag)
{
  *path = (QnPath){
    .model = model, .settings = &model->analysis, .scale = 1, .result = result
  };

  QnStatus status =
    qn_result_init (result, model->block_count, contacts->pair_count, diag);
  result->node_count = model->node_count;
  result->element_count = model->element_count;
  result->tie_count = qn_model_tie_count (model);
  if (status == QN_OK)
    status = qn_equilibrium_setup (&path->equilibrium, model, contacts, report,
                                   report_data, diag);
  if (status != QN_OK)
    return status;

  path->displacements = qn_pool_alloc (
    &path->pool, qn_model_body_count (model) * QN_DOF_COUNT, sizeof (double));
  return !path->pool.failed && qn_result_set_supports (result, model)
           ? QN_OK
           : qn_diag_no_memory (diag);
}

QnStatus
qn_path_finish (QnPath *path, QnStatus status, double start)
{
  const QnEquilibrium *eq = &path->equilibrium;
  QnResult *result = path->result;

  if (status == QN_OK) {
    if (path->follows && result->history.width == 0)
      qn_result_keep_steps (result, result->step_count);
    if (!path->follows) /* else the pairs are those of the last step */
      qn_assembly_pair_results (&eq->assembly, eq->u, result->pairs);
    result->statistics = eq->statistics;
    result->statistics.seconds = qn_clock_seconds () - start;
  } else {
    qn_result_clear (result);
  }
  qn_path_clear (path);
  return status;
}

void
qn_path_clear (QnPath *path)
{
  qn_equilibrium_clear (&path->equilibrium);
  if (path->follows)
    qn_moving_contacts_clear (&path->moving);
  qn_inertia_free (path->inertia);
  qn_pool_clear (&path->pool);
  qn_pool_clear (&path->trace_pool);
  *path = (QnPath){ 0 };
}

/* A change of contacts changes forces by those of the pairs that become inactive or active: the
 * next equilibrium takes that up, and counts as one that relaxation found. Without time a step is known by its
 * number. */
QnStatus
qn_path_follow_contacts (QnPath *path, bool *changed)
{
  QnEquilibrium *eq = &path->equilibrium;

  qn_equilibrium_restore (eq);
  QnStatus status = qn_moving_contacts_update (
    &path->moving, eq, 2 * QN_PATH_LARGEST_MOTION * eq->assembly.length,
    (double) path->result->step_count, path->result, changed, NULL);
  if (status != QN_OK || !*changed)
    return status;
  qn_inertia_free (path->inertia);
  path->inertia = NULL;
  qn_equilibrium_renew (eq);
  return QN_OK;
}

QnStatus
qn_path_begin_to_follow (QnPath *path, bool asked, QnDiag *diag)
{
  const QnAssembly *as = &path->equilibrium.assembly;

  if (!asked || !as->nonlinear)
    return QN_OK;
  path->follows = true;
  return qn_moving_contacts_init (&path->moving, as, diag);
}

bool
qn_path_accept (QnPath *path, double multiplier, QnEvent event)
{
  QnEquilibrium *eq = &path->equilibrium;
  QnStep step = { .multiplier = path->origin + path->scale * multiplier,
                  .iterations = eq->statistics.iterations - path->iterations_at_step,
                  .residual = eq->out_of_balance,
                  .event = event,
                  .stage = path->stage,
                  .time = path->follows ? (double) path->result->step_count : 0,
                  .relaxed =
                    eq->keeps_forces || eq->assembly.commits != path->commits_at_step };

  eq->multiplier = multiplier;
  qn_equilibrium_record (eq);
  path->iterations_at_step = eq->statistics.iterations;
  path->commits_at_step = eq->assembly.commits;
  eq->keeps_forces = false;
  eq->progress.multiplier = step.multiplier;
  eq->progress.steps++;
  return qn_record_step (eq, path->follows ? &path->moving : NULL, multiplier, step,
                         path->result);
}

void
qn_path_add_solution (QnPath *path, QnProcedure found_by, double multiplier)
{
  QnResult *result = path->result;
  size_t step = result->step_count - 1;

  while (step > 0 && result->steps[step].multiplier != multiplier)
    step--;
  qn_result_add_solution (
    result, (QnSolution){ .multiplier = multiplier,
                          .found_by = found_by,
                          .displacement = qn_result_motion (result, 0, step) });
}

QnStatus
qn_path_record_mechanism (QnPath *path, const double *velocity, QnDiag *diag)
{
  const QnEquilibrium *eq = &path->equilibrium;

  qn_assembly_expand_rates (&eq->assembly, eq->committed.u, velocity,
                            path->displacements);
  return qn_result_set_mechanism (path->result, path->displacements,
                                  path->model->characteristic_length, diag);
}

bool
qn_path_slips (const QnAssembly *as)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->responses[p].state == QN_PAIR_SLIP)
      return true;
  return false;
}

/* By Newton's method; along the central path where that finds none, and where joints slip without
 * dilatancy: there are many equilibria then, and Newton's method may end in one that the least of load makes
 * jump, the central path amid them. If Newton's method finds none of many, motion comes first. */
static QnSolveStatus
find_equilibrium (QnEquilibrium *eq, QnCentralPath *central)
{
  const QnTarget target = qn_target_multiplier (0);
  QnSolveStatus solve = qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
  bool stands = solve == QN_SOLVE_CONVERGED;

  if (central == NULL
      || (qn_assembly_may_jump (&eq->assembly) ? !stands || !qn_path_slips (&eq->assembly)
                                               : solve != QN_SOLVE_FAILED))
    return solve;
  solve = qn_central_path_solve (central, &target, 0);
  if (solve != QN_SOLVE_FAILED || !stands)
    return solve;
  qn_equilibrium_restore (eq);
  return qn_equilibrium_newton (eq, &target, 0, QN_NEWTON_BUDGET);
}

/* The motion from rest under the dead load. Without dilatancy, in linear geometry, it comes to rest at the verge
 * of sliding, and a path is better begun amid all equilibria, which the central path finds. What falls is not
 * for that to say: from no load it may find blocks pressed together by nothing, where no motion leads. So it
 * waits until the motion has told.
 *
 * Where that neither rests nor falls, it is tried again with steps along central paths: these follow a fall
 * that Newton's method does not, but in large displacements may pass a rest. */
static QnSolveStatus
let_settle (QnEquilibrium *eq, QnCentralPath *central)
{
  const QnTarget target = qn_target_multiplier (0);
  int64_t commits = eq->assembly.commits;
  bool linear = !eq->assembly.nonlinear && central != NULL;
  QnSolveStatus solve = qn_equilibrium_relax (eq, NULL, &target, INFINITY, NULL,
                                              linear ? QN_TRIED : QN_RELAX_BUDGET);
  bool rests = solve == QN_SOLVE_CONVERGED;

  if ((!rests && solve != QN_SOLVE_FAILED) || central == NULL)
    return solve;
  if (rests)
    qn_equilibrium_save (eq, &eq->anchor);
  if (linear && qn_assembly_may_jump (&eq->assembly)) {
    qn_equilibrium_restore (eq);
    solve = qn_central_path_solve (central, &target, 0);
    if (solve != QN_SOLVE_FAILED) {
      eq->assembly.commits = commits; /* the motion is undone */
      return solve;
    }
  }
  if (rests) {
    qn_equilibrium_set_state (eq, &eq->anchor);
    return QN_SOLVE_CONVERGED;
  }
  qn_equilibrium_restore (eq);
  return qn_equilibrium_relax (eq, central, &target, INFINITY, NULL, QN_RELAX_BUDGET);
}

/* The equilibrium under dead load, or else that in which relaxation comes to rest. */
static QnSolveStatus
find_rest (QnEquilibrium *eq)
{
  QnCentralPath *central;

  if (!qn_central_path_new (eq, false, &central) || !qn_equilibrium_set_runaway (eq)) {
    qn_central_path_free (central);
    return QN_SOLVE_NO_MEMORY;
  }
  QnSolveStatus solve = find_equilibrium (eq, eq->assembly.nonlinear ? NULL : central);
  if (solve == QN_SOLVE_FAILED) {
    qn_equilibrium_restore (eq);
    solve = let_settle (eq, central);
  }
  qn_central_path_free (central);
  return solve;
}

QnSolveStatus
qn_path_stay (QnPath *path, double far)
{
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  const QnTarget target = qn_target_multiplier (eq->multiplier);
  QnSolveStatus solve = qn_path_judge_stability (path, NULL, false);

  if (solve != QN_SOLVE_MECHANISM)
    return solve;
  qn_equilibrium_commit (eq);
  for (int32_t i = 0; i < as->unknown_count; i++)
    eq->u[i] += QN_PATH_LEAN * far * eq->motion[i];
  solve = qn_assembly_evaluate (&eq->assembly, eq->u)
            ? qn_equilibrium_relax (eq, NULL, &target, far, NULL, QN_RELAX_BUDGET)
            : QN_SOLVE_FAILED;
  bool falls = solve == QN_SOLVE_MECHANISM; /* in this motion */
  if (solve == QN_SOLVE_CONVERGED)
    solve = qn_path_judge_stability (path, NULL, false);
  if (solve == QN_SOLVE_CONVERGED || solve == QN_SOLVE_CANCELLED
      || solve == QN_SOLVE_NO_MEMORY)
    return solve;
  qn_equilibrium_restore (eq);
  return falls ? solve : qn_path_judge_stability (path, NULL, false);
}

QnStatus
qn_path_apply_dead_load (QnPath *path, bool *stands, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  QnSolveStatus solve = find_rest (eq);

  if (solve
      == QN_SOLVE_CONVERGED) /* or near by: no farther than the dead load has moved it */
    solve = qn_path_stay (path, qn_assembly_largest (&eq->assembly, eq->u, NULL));
  *stands = solve == QN_SOLVE_CONVERGED;

  if (*stands) {
    qn_beam_assembly_tension (&eq->assembly);
    return qn_path_accept (path, 0, QN_EVENT_NONE) ? QN_OK : qn_diag_no_memory (diag);
  }
  if (solve == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);
  path->result->outcome = solve == QN_SOLVE_MECHANISM   ? QN_OUTCOME_DEAD_LOAD_UNSTABLE
                          : solve == QN_SOLVE_CANCELLED ? QN_OUTCOME_CANCELLED
                                                        : QN_OUTCOME_NOT_CONVERGED;
  if (solve != QN_SOLVE_MECHANISM)
    return QN_OK;
  QnStatus status = qn_path_record_mechanism (path, eq->motion, diag);
  return status == QN_OK ? qn_result_name_unstable (
           path->result, path->model->characteristic_length, false, diag)
                         : status;
}
