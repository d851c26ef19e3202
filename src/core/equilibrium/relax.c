/* Relaxation: pseudo-transient continuation across jumps of the path.
 *
 * Backward Euler steps of C du/dt = R(u, lambda), each solved to convergence, slip committed
 * along the way. The step grows while convergence is quick, so that the motion either dies
 * down in a new equilibrium or goes on for good along a mechanism. (Kelley & Keyes 1998,
 * Convergence analysis of pseudo-transient continuation, SIAM J. Numer. Anal. 35.)
 *
 * Time is counted in units of C / k, with k the mean stiffness of the pairs, so that a
 * viscosity of 1 (a step of 1) is as stiff as the joints themselves.
 */
#include "core/equilibrium/central-path.h"

#include <string.h>

/* Tuning. An easy step lets the next one be LONGER times as long, one that fails is repeated SHORTER times as
 * short. Of FEW steps are the advance of a measure that is held, at least; the wait until a failed viscosity is
 * tried again, no measure held; and the motion before it goes along central paths, for in the first steps small
 * structures rest or fall by Newton's method alone, which is cheaper. */
#define LONGER          4
#define SHORTER         8
#define FIRST_VISCOSITY 0.01 /* soft enough to cross a small jump at once */
#define STIFFEST        1e9 /* joints are nothing beside it: what fails then never converges */
#define FEW             10
#define STEADY          1e-3 /* velocities differ by less, over as long as all that went before */

/* A measure advances at a speed that damping resists with this part of the largest dead load on a block: ten
 * times as fast, and walls take other branches in large than in small steps. */
#define DRIVE 0.001

/* In large displacements motion counts as a fall when it has doubled so often without slowing down: as if to rest
 * within so many characteristic lengths, for slender members bend far under little force, and at first without any
 * hurry to stop. */
#define FALL_DOUBLINGS 4
#define FALL_LENGTHS   1e3
#define FALL_PART      0.25 /* of a kept state: the way gone beside the one after it */

typedef struct {
  bool held;                            /* a measure, while the multiplier is free */
  double duration;                      /* of the measure's advance */
  double viscosity;                     /* of the next step */
  double failed;                        /* that of the last step that failed, and */
  int waits;                            /* for how many steps that is not tried again */
  double elapsed;                       /* time since the start */
  double speed;                         /* of the last step, in the norm of C, */
  double speed_before;                  /* and of the one before */
  double change;                        /* of the velocity in the last step, relative */
  double watched_motion, watched_speed; /* when motion had last doubled */
  int doublings;                        /* since the motion last slowed down */
} Relaxation;

/* eq->motion = velocity = (u - anchor) / time step; its change since the last step, in the norm of C. */
static void
update_velocity (QnEquilibrium *eq, Relaxation *relaxation)
{
  const QnAssembly *as = &eq->assembly;
  double change = 0, norm = 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    double v = relaxation->viscosity * (eq->u[i] - eq->anchor.u[i]);
    double d = v - eq->motion[i];
    change += as->damping[i] * d * d;
    norm += as->damping[i] * v * v;
    eq->motion[i] = v;
  }
  relaxation->speed_before = relaxation->speed;
  relaxation->speed = sqrt (norm);
  relaxation->change = norm > 0 ? sqrt (change / norm) : INFINITY;
}

/* Joints, then ties. */
static size_t
gap_count (const QnAssembly *as)
{
  return as->pair_count + as->beams.count - as->model->element_count;
}

static double
present_gap (const QnAssembly *as, size_t i)
{
  return i < as->pair_count ? qn_assembly_gap (as, i)
                            : qn_beam_assembly_tie_gap (as, i - as->pair_count);
}

void
qn_equilibrium_note_gaps (QnEquilibrium *eq)
{
  for (size_t i = 0; i < gap_count (&eq->assembly); i++)
    eq->gaps[i] = present_gap (&eq->assembly, i);
}

bool
qn_equilibrium_will_close (const QnEquilibrium *eq, double time_step, double horizon)
{
  const QnAssembly *as = &eq->assembly;

  for (size_t i = 0; i < gap_count (as); i++) {
    double gap = present_gap (as, i);
    if (!(i < as->pair_count && as->inactive[i]) && gap > 0
        && gap * time_step < (eq->gaps[i] - gap) * horizon)
      return true;
  }
  return false;
}

double
qn_equilibrium_motion (const QnEquilibrium *eq)
{
  return qn_assembly_largest (&eq->assembly, eq->u, eq->committed.u);
}

/* In nonlinear geometry the velocity of a mechanism changes as it moves: a structure falls if
 * it covers twice the way again and again without slowing down. So do blocks that nothing holds any more
 * and that have moved farther than a block is long: what they were in contact with is behind them. */
static bool
is_falling (QnEquilibrium *eq, Relaxation *relaxation)
{
  double moved = qn_equilibrium_motion (eq), way = moved - relaxation->watched_motion;
  double length = eq->assembly.length, far = FALL_LENGTHS * length;

  if (moved > far
      || (moved > length
          && qn_assembly_largest_loose (&eq->assembly, eq->u, eq->committed.u) > length))
    return true;
  if (moved >= 2 * relaxation->watched_motion) {
    double lost = 1 - relaxation->speed / relaxation->watched_speed;
    bool slower = lost * far > way;
    relaxation->doublings = slower ? 0 : relaxation->doublings + 1;
    relaxation->watched_motion = moved;
    relaxation->watched_speed = relaxation->speed;
  }
  return relaxation->doublings > FALL_DOUBLINGS;
}

/* Whether the structure moves on for good after a converged step. Forces that grow as they do now would stop
 * it before it has run away where the velocity, which follows from forces alone as damping is linear, changes
 * so much till then: soft joints give way at one that hardly changes, long before they push back. */
static bool
is_mechanism (QnEquilibrium *eq, Relaxation *relaxation)
{
  const QnAssembly *as = &eq->assembly;
  double speed = qn_assembly_elastic_displacements (as, eq->motion, NULL);
  double time_step = 1 / relaxation->viscosity, left = eq->runaway / speed;

  if (as->nonlinear)
    return !relaxation->held && is_falling (eq, relaxation);
  if (qn_assembly_elastic_displacements (as, eq->u, eq->committed.u) > eq->runaway)
    return true;
  return relaxation->change < STEADY && 2 * time_step >= relaxation->elapsed
         && !(relaxation->change * left > time_step)
         && !qn_equilibrium_will_close (eq, time_step, left);
}

/* Time in which the measure is to advance. The least damping force that any motion of this
 * speed meets is that of the velocity C^-1 direction; what settles, which has no damping, counts as a body of
 * mean mass. */
static double
find_duration (const QnEquilibrium *eq, const QnTarget *target)
{
  const QnAssembly *as = &eq->assembly;
  double yielding = 0;

  if (target->direction == NULL)
    return 0;
  for (int32_t i = 0; i < as->unknown_count; i++)
    if (target->direction[i] != 0)
      yielding += target->direction[i] * target->direction[i]
                  / (as->settles[i] ? as->stiffness : as->damping[i]);
  double largest = qn_assembly_largest (as, target->direction, NULL);
  double force = largest * fabs (target->advance) / yielding; /* at unit duration */
  return as->force_scale > 0 ? force / (DRIVE * as->force_scale) : 0;
}

/* How many times as long the next step may be, by how many iterations the last one of Newton's method took. */
static double
growth (Relaxation *relaxation, int iterations)
{
  bool may_fail = !relaxation->held && relaxation->waits > 0
                  && relaxation->viscosity / LONGER <= relaxation->failed;

  relaxation->waits -= relaxation->waits > 0;
  if (iterations >= QN_NEWTON_BUDGET)
    return 0.5;
  return iterations <= QN_NEWTON_EASY && !may_fail ? LONGER : 1;
}

void
qn_fall_init (QnFall *fall, const QnAssembly *as, QnPool *pool)
{
  *fall = (QnFall){ .first = QN_FALL_STATES };
  for (int i = 0; i < QN_FALL_STATES; i++)
    fall->u[i] = qn_pool_alloc (pool, (size_t) as->unknown_count, sizeof *fall->u[i]);
}

static void
note_fall (const QnEquilibrium *eq, QnFall *fall, double far)
{
  double parts = qn_equilibrium_motion (eq) / far;

  for (; fall->first > 0 && parts > pow (FALL_PART, fall->first - 1); fall->first--)
    memcpy (fall->u[fall->first - 1], eq->u,
            (size_t) eq->assembly.unknown_count * sizeof *eq->u);
}

/* Whether normal forces tell of the way that a spring has come: not those of friction without dilatancy. */
static bool
remembers_way (const QnSpring *spring)
{
  if (!qn_spring_is_plastic (spring))
    return spring->kind != QN_LAW_ELASTIC;
  return spring->dilatancy > 0 || qn_spring_has_bond (spring);
}

/* A structure has come to rest, and its joints may have been strained farther on the way than they are in the
 * end. That strain came from artificial damping and must not stay. A rest is reached straight from the last
 * equilibrium that is recorded, as in every other step, where Newton's method finds one from there: then
 * displacements tell all forces. */
static QnSolveStatus
come_straight (QnEquilibrium *eq, const QnTarget *target)
{
  QnAssembly *as = &eq->assembly;
  bool remembers = as->beams.count > 0;

  for (size_t p = 0; p < as->pair_count; p++)
    remembers |= remembers_way (&as->springs[p].a) || remembers_way (&as->springs[p].b);
  if (!remembers)
    return QN_SOLVE_CONVERGED;
  qn_equilibrium_save (eq, &eq->anchor);
  memcpy (as->committed, eq->recorded.memory, as->pair_count * sizeof *as->committed);
  for (size_t p = 0; p < as->pair_count; p++) /* but what is broken is broken */
    qn_pair_keep_damage (&as->springs[p], &eq->anchor.memory[p], &as->committed[p]);
  qn_beam_state_set (&eq->recorded.beams, as);
  QnSolveStatus status = qn_assembly_evaluate (as, eq->u)
                           ? qn_equilibrium_newton (eq, target, 0, QN_NEWTON_BUDGET)
                           : QN_SOLVE_FAILED;
  if (status != QN_SOLVE_FAILED)
    return status;
  qn_equilibrium_set_state (eq, &eq->anchor);
  return QN_SOLVE_CONVERGED;
}

QnSolveStatus
qn_equilibrium_relax (QnEquilibrium *eq, QnCentralPath *central, const QnTarget *target,
                      double far, QnFall *fall, int budget)
{
  Relaxation relaxation = { .held = target->direction != NULL,
                            .duration = find_duration (eq, target),
                            .viscosity = FIRST_VISCOSITY };
  if (relaxation.duration > 0)
    relaxation.viscosity = fmin (FIRST_VISCOSITY, FEW / relaxation.duration);

  memset (eq->motion, 0, (size_t) eq->assembly.unknown_count * sizeof *eq->motion);
  if (fall != NULL)
    fall->first = QN_FALL_STATES;
  for (int step = 0; step < budget; step++) {
    int32_t before = eq->statistics.iterations;
    double time = relaxation.elapsed + 1 / relaxation.viscosity;
    QnTarget now = *target;
    if (time < relaxation.duration)
      now.advance *= time / relaxation.duration;
    qn_equilibrium_save (eq, &eq->anchor);
    qn_equilibrium_note_gaps (eq);
    QnSolveStatus status =
      qn_equilibrium_newton (eq, &now, relaxation.viscosity, QN_NEWTON_BUDGET);
    bool by_central = status == QN_SOLVE_FAILED && central != NULL && step >= FEW;

    if (by_central) {
      qn_equilibrium_set_state (eq, &eq->anchor);
      status = qn_central_path_solve (central, &now, relaxation.viscosity);
    }
    if (status == QN_SOLVE_CANCELLED || status == QN_SOLVE_NO_MEMORY)
      return status;
    if (status == QN_SOLVE_FAILED) {
      qn_equilibrium_set_state (eq, &eq->anchor);
      relaxation.failed = relaxation.viscosity;
      relaxation.waits = FEW;
      relaxation.viscosity *= SHORTER;
      if (relaxation.viscosity > STIFFEST)
        return QN_SOLVE_FAILED;
      continue;
    }

    qn_assembly_commit (&eq->assembly);
    relaxation.elapsed += 1 / relaxation.viscosity;
    update_velocity (eq, &relaxation);
    if (fall != NULL)
      note_fall (eq, fall, far);
    if (eq->assembly.nonlinear && qn_equilibrium_motion (eq) > far)
      return QN_SOLVE_MECHANISM;
    if (eq->out_of_balance <= eq->tolerance && relaxation.elapsed >= relaxation.duration)
      return come_straight (eq, target);
    if ((far == INFINITY || !eq->assembly.nonlinear) && is_mechanism (eq, &relaxation))
      return QN_SOLVE_MECHANISM;
    double longer =
      by_central ? LONGER : growth (&relaxation, eq->statistics.iterations - before);
    /* Motion that grows like exp (rate time) is 1 / (1 - rate step) times as fast after an implicit step, and a
     * step of 1 / rate has no solution: it may get LONGER times as fast. Without central paths a step that fails
     * costs two or three factorisations. */
    double slower = relaxation.speed_before / relaxation.speed;
    if (central != NULL && slower > 0 && slower < 1)
      longer = fmin (longer, (1 - 1.0 / LONGER) / (1 - slower));
    relaxation.viscosity /= longer;
  }
  return QN_SOLVE_FAILED;
}
