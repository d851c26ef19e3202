/* From the last equilibrium that load control found towards collapse.
 *
 * Near collapse a little more load means a lot more motion, so the motion is prescribed: the
 * live load's work grows tenfold from step to step, each solved as a whole along the central
 * path, and the multiplier follows. It settles as the elastic part of the motion becomes
 * nothing beside the mechanism; what is still to come is then a tenth of what the last step
 * gained. Without associativity the multiplier may fall instead, for a long step can lose the
 * branch that a shorter one keeps: the step shortens until it gains or is too short to matter.
 */
#include "core/path/path.h"

#include <math.h>
#include <string.h>

/* By which the work grows from step to step: at most, and where the approach gives up. */
#define GROWTH       10.0
#define LEAST_GROWTH 1.5

/* Part of the multiplier's tolerance that may be left to gain. */
#define SETTLED 0.1

/* No step of a structure that may jump need go farther than so many times where it has run away. */
#define FARTHEST 2.0

/* What may slide too early where a central path turns back, as a part of the motion, in
 * tolerances of the multiplier. Ten times as much, and relaxation finds equilibria above the
 * mechanism that moves on for good. */
#define UNDECIDED 0.3

/* Factorisations of one central path. */
#define BUDGET 80

typedef struct {
  QnPath *path;
  const double *start;
  double growth; /* of the work in the next step */
  double left;   /* to gain after the last step, as a part of the multiplier */
  bool may_jump; /* some joint is not associative */
} Approach;

/* Work that the live load has done since it began to act. */
static double
work_so_far (const Approach *approach)
{
  const QnEquilibrium *eq = &approach->path->equilibrium;
  double work = 0;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    work += eq->assembly.live[i] * (eq->committed.u[i] - approach->start[i]);
  return work;
}

static void
keep_velocity (QnEquilibrium *eq)
{
  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    eq->velocity[i] = eq->u[i] - eq->committed.u[i];
}

/* How far the next step may grow after so large a motion: nowhere, once it has run away. */
static double
growth_within_reach (const QnEquilibrium *eq, double motion)
{
  return motion > eq->runaway ? 1 : FARTHEST * eq->runaway / motion;
}

/* Takes what the step has found. *settled: this is collapse. */
static bool
take_step (Approach *approach, bool *settled)
{
  QnPath *path = approach->path;
  QnEquilibrium *eq = &path->equilibrium;
  double gain = eq->multiplier - eq->committed.multiplier;
  double left = gain / (approach->growth - 1); /* lambda = collapse - constant / work */
  double negligible = SETTLED * path->settings->multiplier_tolerance * eq->multiplier;

  if (gain <= 0) {
    /* Where nothing can jump, it falls by rounding only. */
    *settled = !approach->may_jump && -left <= negligible;
    if (*settled)
      keep_velocity (eq);
    approach->growth = sqrt (approach->growth);
    qn_equilibrium_restore (eq);
    return true;
  }
  keep_velocity (eq);
  approach->left = left / eq->multiplier;
  double motion = qn_equilibrium_elastic_displacements (eq);
  /* A motion that closes joints is stopped before the structure has run away. */
  *settled =
    left <= negligible
    && !(approach->may_jump && qn_equilibrium_will_close (eq, 1, eq->runaway / motion));
  approach->growth = fmin (approach->growth * approach->growth, GROWTH);
  if (approach->may_jump)
    approach->growth = fmin (approach->growth, growth_within_reach (eq, motion));
  return qn_path_accept (path, eq->multiplier, QN_EVENT_NONE);
}

QnStatus
qn_path_approach_collapse (QnPath *path, QnCentralPath *central, const double *start,
                           double end, QnApproach *outcome, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  Approach approach = { .path = path,
                        .start = start,
                        .growth = GROWTH,
                        .left = INFINITY,
                        .may_jump = qn_central_path_turns_back (central) };
  double undecided = UNDECIDED * path->settings->multiplier_tolerance;
  bool settled = false;

  *outcome = QN_APPROACH_LOST;
  while (!settled && approach.growth > LEAST_GROWTH) {
    const QnTarget target = { .direction = eq->assembly.live,
                              .advance =
                                (approach.growth - 1) * work_so_far (&approach) };
    if (!(target.advance > 0))
      return QN_OK;
    qn_equilibrium_note_gaps (eq);
    switch (qn_central_path_relax (central, &target, undecided, BUDGET)) {
    case QN_SOLVE_CONVERGED:
      if (eq->multiplier > end) {
        qn_equilibrium_restore (eq);
        *outcome = QN_APPROACH_BEYOND;
        return QN_OK;
      }
      if (!take_step (&approach, &settled))
        return qn_diag_no_memory (diag);
      break;
    case QN_SOLVE_FAILED:
    case QN_SOLVE_MECHANISM:
      qn_equilibrium_restore (eq);
      approach.growth = sqrt (approach.growth);
      break;
    case QN_SOLVE_CANCELLED:
      qn_equilibrium_restore (eq);
      *outcome = QN_APPROACH_CANCELLED;
      return QN_OK;
    case QN_SOLVE_NO_MEMORY:
      return qn_diag_no_memory (diag);
    }
  }
  /* Where nothing can jump, as far as rounding allows is all the way, if that is near enough. */
  bool near = approach.left <= path->settings->multiplier_tolerance;
  if (settled || (near && !approach.may_jump))
    *outcome = QN_APPROACH_SETTLED;
  return QN_OK;
}
