/* From the last equilibrium that load control found to collapse.
 *
 * Near collapse a little more load means a lot more motion, so the motion is prescribed: the
 * live load's work grows tenfold from step to step, each solved as a whole along the central
 * path, and the multiplier follows. It settles as the elastic part of the motion becomes
 * nothing beside the mechanism; what is still to come is then a tenth of what the last step
 * gained.
 */
#include "core/path.h"

#include <math.h>
#include <string.h>

/* By which the work grows from step to step, and is cut where a step has no solution. */
#define GROWTH 10.0
#define CUT    3.0

/* Part of the multiplier's tolerance that may be left to gain. */
#define SETTLED 0.1

#define MOST_FAILURES 4

/* Factorisations of one step. */
#define BUDGET 80

typedef struct {
  QnPath *path;
  QnCentralPath *central;
  double advance; /* work to be done by the next step per unit of multiplier, J */
  const double *start;
  double *velocity; /* of the last step */
  int failures;
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
keep_velocity (Approach *approach)
{
  const QnEquilibrium *eq = &approach->path->equilibrium;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    approach->velocity[i] = eq->u[i] - eq->committed.u[i];
}

/* Takes what the step has found. *settled: this is collapse. */
static bool
take_step (Approach *approach, bool *settled)
{
  QnPath *path = approach->path;
  QnEquilibrium *eq = &path->equilibrium;
  double gain = eq->multiplier - eq->committed.multiplier;
  double growth = approach->advance / work_so_far (approach);
  double left = gain / growth; /* lambda(work) = collapse - constant / work */

  keep_velocity (approach);
  *settled =
    qn_equilibrium_elastic_displacements (eq) > QN_RUNAWAY
    || fabs (left) <= SETTLED * path->settings->multiplier_tolerance * eq->multiplier;
  approach->advance *= GROWTH;
  if (gain > 0)
    return qn_path_accept (path, eq->multiplier, QN_EVENT_NONE);
  qn_equilibrium_restore (eq);
  return true;
}

QnStatus
qn_path_approach_collapse (QnPath *path, QnCentralPath *central, const double *start,
                           double end, double *velocity, QnApproach *outcome,
                           QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;
  Approach approach = {
    .path = path, .central = central, .start = start, .velocity = velocity
  };
  bool settled = false;

  *outcome = QN_APPROACH_LOST;
  approach.advance = GROWTH * work_so_far (&approach);
  while (!settled && approach.advance > 0 && approach.failures < MOST_FAILURES) {
    const QnTarget target = { .direction = eq->assembly.live,
                              .advance = approach.advance };
    switch (qn_central_path_solve (central, &target, BUDGET)) {
    case QN_SOLVE_CONVERGED:
      if (eq->multiplier > end) {
        qn_equilibrium_restore (eq);
        return QN_OK;
      }
      if (!take_step (&approach, &settled))
        return qn_diag_no_memory (diag);
      break;
    case QN_SOLVE_FAILED:
    case QN_SOLVE_MECHANISM:
      qn_equilibrium_restore (eq);
      approach.advance /= CUT;
      approach.failures++;
      break;
    case QN_SOLVE_CANCELLED:
      qn_equilibrium_restore (eq);
      *outcome = QN_APPROACH_CANCELLED;
      return QN_OK;
    case QN_SOLVE_NO_MEMORY:
      return qn_diag_no_memory (diag);
    }
  }
  if (settled)
    *outcome = QN_APPROACH_SETTLED;
  return QN_OK;
}
