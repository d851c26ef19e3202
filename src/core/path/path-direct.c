/* Where the trace ends in linear geometry: a collapse found directly.
 *
 * A path that creeps is a structure that settles in one place after the other, and gains little by
 * it. What it comes to is asked of limit analysis, from its own forces: joints of their own stiffness
 * reach that collapse after a motion beside which all they have done so far is small. It is one more
 * equilibrium of the path, a long step away.
 */
#include "core/base/memory.h"
#include "core/path/path-trace.h"

#include <stdlib.h>
#include <string.h>

/* Whether the structure may settle in one place after the other. Where bonds break, one of them after the
 * other leads to collapse. */
static bool
may_settle (const QnPathTrace *trace)
{
  return trace->load_control && trace->may_jump && !trace->may_soften
         && qn_path_trace_is_linear (trace)
         && trace->measure.procedure == QN_PROCEDURE_WORK;
}

static double
taken (const QnPathTrace *trace)
{
  return trace->path->equilibrium.statistics.factorizations - trace->aside;
}

/* `most`: over the number of blocks, at least, at most. */
static bool
has_taken (const QnPathTrace *trace, const double most[3])
{
  double share = most[0] / (double) trace->path->model->block_count;
  return taken (trace) > fmin (fmax (share, most[1]), most[2]);
}

bool
qn_path_end_is_spent (const QnPathTrace *trace)
{
  return may_settle (trace) && has_taken (trace, (const double[]) QN_PATH_EFFORT);
}

/* Whether limit analysis knows the structure and its loads, and may tell more of it than the path
 * does. Joints without tension carry by their elongation alone, which no force leaves open. */
static bool
applies (const QnPathTrace *trace)
{
  const QnModel *model = trace->path->model;
  const QnAssembly *as = &trace->path->equilibrium.assembly;
  bool known = may_settle (trace) && model->stage_count == 0 && model->element_count == 0
               && model->node_count == 0 && qn_model_tie_count (model) == 0
               && as->settling_count == 0;

  for (size_t p = 0; known && p < as->pair_count; p++)
    known = qn_law_may_bond (as->springs[p].a.kind)
            && qn_pair_is_plastic (&as->springs[p], &as->committed[p]);
  return known;
}

static bool
seek (QnPathTrace *trace)
{
  QnPath *path = trace->path;
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  QnLimitSolution *direct = &trace->direct;
  double *forces = qn_alloc (2 * as->pair_count, sizeof *forces);

  if (forces == NULL)
    return false;
  for (size_t p = 0; p < as->pair_count; p++)
    memcpy (forces + 2 * p, eq->committed.responses[p].force, 2 * sizeof *forces);
  trace->sought = true;
  trace->leads_from = path->result->step_count;
  qn_limit_solution_clear (direct);
  direct->effort = eq->statistics;
  QnStatus status =
    qn_limit_go_on (path->model, as->contacts, forces, eq->committed.multiplier,
                    eq->report, eq->report_data, direct);
  free (forces);
  if (status != QN_OK) /* else nothing is known of joints or loads like these */
    return status != QN_ERROR_NO_MEMORY;
  direct->effort.factorization_work +=
    direct->effort.factorizations - eq->statistics.factorizations;
  eq->statistics = direct->effort;
  if (direct->outcome == QN_OUTCOME_CANCELLED)
    qn_path_end_give_up (trace, QN_SOLVE_CANCELLED);
  return true;
}

/* A pair at the elongation last evaluated, with the force that it has at collapse: slip and opening are
 * what the force leaves of the elongation. False where its law has no answer. */
static bool
take_pair (QnAssembly *as, size_t p, const double force[2], double largest)
{
  const QnSpring *spring = &as->springs[p].a;
  const double *q = as->elongations + 2 * p;
  QnPairResponse *response = &as->responses[p];
  QnPairMemory from = as->committed[p];
  double slip = q[1] - force[1] / spring->ks, ideal[2] = { q[0], q[1] };

  bool slips = qn_pair_state_of_force (&as->springs[p], &from, QN_PAIR_SLIP, force,
                                       QN_NO_FORCE * largest)
               == QN_PAIR_SLIP;
  double crushed = qn_spring_crushed (spring, &from.a);
  from.a.slip = slips ? from.a.slip : slip;
  from.a.opening = crushed + qn_spring_dilation (spring, from.a.slip);
  if (hypot (force[0], force[1]) > QN_NO_FORCE * largest && spring->compression <= 0)
    ideal[0] = from.a.opening + force[0] / spring->kn; /* else by what crushes it, too */
  if (!qn_pair_evaluate (&as->springs[p], &from, ideal, response))
    return false;
  memcpy (response->force, force, sizeof response->force);
  crushed = qn_spring_crushed (spring, &response->memory.a);
  response->memory.a.slip = slip;
  response->memory.a.opening = crushed + qn_spring_dilation (spring, slip);
  return true;
}

/* The state at collapse becomes the current one. FAILED where it is no equilibrium. */
static QnSolveStatus
take_state (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;
  QnAssembly *as = &eq->assembly;
  const QnLimitSolution *direct = &trace->direct;
  const QnTarget target = qn_target_multiplier (direct->lower_bound);
  double largest = as->force_scale;

  qn_equilibrium_restore (eq);
  qn_assembly_collect (as, direct->velocities, eq->u);
  qn_assembly_update_kinematics (as, eq->u);
  for (size_t i = 0; i < 2 * as->pair_count; i++)
    largest = fmax (largest, fabs (direct->forces[i]));
  for (size_t p = 0; p < as->pair_count; p++)
    if (!take_pair (as, p, direct->forces + 2 * p, largest))
      return QN_SOLVE_FAILED;
  return qn_equilibrium_newton (eq, &target, 0, QN_MEASURE_ONLY);
}

/* Whether what was found lies ahead of the path. */
static bool
is_ahead (const QnPathTrace *trace)
{
  const QnLimitSolution *direct = &trace->direct;

  return direct->forces != NULL && direct->outcome == QN_OUTCOME_COLLAPSE
         && direct->lower_bound > trace->events.highest
         && direct->lower_bound <= trace->end;
}

/* The path ends at what was found. Where that is no equilibrium nothing has changed. */
static bool
end_there (QnPathTrace *trace)
{
  QnEquilibrium *eq = &trace->path->equilibrium;

  eq->keeps_forces = take_state (trace) == QN_SOLVE_CONVERGED;
  if (!eq->keeps_forces) {
    qn_limit_solution_clear (&trace->direct);
    qn_equilibrium_restore (eq);
    return true;
  }
  trace->means = QN_FOUND_BY_CENTRAL_PATH;
  trace->jumped = false;
  if (!qn_path_trace_accept (trace))
    return false;
  /* Its mechanism is the whole motion, not that from where the path has come. */
  memset (trace->measure.last_u, 0,
          (size_t) eq->assembly.unknown_count * sizeof (double));
  qn_path_end_finish (trace, QN_OUTCOME_COLLAPSE, QN_STOP_PLATEAU);
  return true;
}

/* Cosine of the angle between the last step and the motion of the collapse found, in the norm of damping. */
static double
alignment (const QnPathTrace *trace)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  double *motion = eq->trial, both = 0, step = 0, collapse = 0;

  qn_assembly_collect (as, trace->direct.velocities, motion);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    double moved = eq->committed.u[i] - trace->measure.last_u[i];
    both += as->damping[i] * motion[i] * moved;
    step += as->damping[i] * moved * moved;
    collapse += as->damping[i] * motion[i] * motion[i];
  }
  return both > 0 ? both / sqrt (step * collapse) : 0;
}

/* Whether the path leads to the collapse found: LEADS_STEPS steps in a row move the same way, and gain, as the
 * last doubling of the motion did, what LEADS_DOUBLINGS more need. Paths that end before gain next to nothing,
 * or turn back, soon after they have taken that way. */
static bool
leads_there (QnPathTrace *trace, double gain_of_doubling)
{
  const QnEquilibrium *eq = &trace->path->equilibrium;
  const QnAssembly *as = &eq->assembly;
  size_t steps = trace->path->result->step_count;
  double multiplier = eq->committed.multiplier;
  double motion = qn_assembly_elastic_displacements (as, eq->committed.u, NULL);
  double before = qn_assembly_elastic_displacements (as, trace->measure.last_u, NULL);
  double gain = (multiplier / trace->last_multiplier - 1) / log2 (motion / before);
  double needs = (trace->direct.lower_bound / multiplier - 1) / QN_PATH_LEADS_DOUBLINGS;

  if (trace->events.below || !(motion > before) || fmin (gain, gain_of_doubling) < needs
      || alignment (trace) < QN_PATH_LEADS_ALIGNED)
    trace->leads_from = steps;
  return steps >= trace->leads_from + QN_PATH_LEADS_STEPS;
}

bool
qn_path_end_direct (QnPathTrace *trace, bool last)
{
  bool ok = true, far = last || has_taken (trace, (const double[]) QN_PATH_PATIENCE);

  if ((!last && taken (trace) <= QN_PATH_DIRECT) || !applies (trace))
    return true;
  double gain = qn_path_end_gain (trace);
  bool leads = is_ahead (trace) && leads_there (trace, gain);
  if (!last && gain > QN_PATH_CREEPS)
    return true;
  if (last ? !is_ahead (trace) : !trace->sought)
    ok = seek (trace);
  return ok && trace->stop == QN_STOP_UNKNOWN && is_ahead (trace)
             && (far || leads
                 || trace->direct.lower_bound
                      <= (1 + QN_PATH_SETTLES) * trace->events.highest)
           ? end_there (trace)
           : ok;
}
