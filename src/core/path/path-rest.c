/* Is an equilibrium one in which a structure can stay?
 *
 * In large displacements an equilibrium may be unstable: a slender block on soft joints, upright beyond
 * its buckling load, is balanced and falls; a straight column is an equilibrium at any load. Newton's
 * method does not see that; the inertia of the tangent stiffness K does (core/linalg/inertia.h). With
 * the loads held,
 *
 *   symmetric       unstable with any negative eigenvalue
 *   not symmetric   unstable with a negative determinant: an odd number of real negative eigenvalues, of
 *                   which one grows from rest. Negative second-order work alone proves nothing.
 *
 * With a measure d . u held, a symmetric K counts on the motions that leave the measure alone, where it
 * has one negative eigenvalue less if d' K^-1 d < 0, and as many if not (the inertia of the bordered
 * matrix; Haynsworth 1968). The sign of its determinant alone would not see an even number. Where K is
 * not symmetric that sign is all there is: see path-step.c.
 */
#include "core/base/numbers.h"
#include "core/path/path.h"

#include <math.h>
#include <string.h>

bool
qn_path_count_inertia (QnPath *path, QnInertiaCount *count)
{
  QnEquilibrium *eq = &path->equilibrium;
  const QnAssembly *as = &eq->assembly;

  if (path->inertia == NULL)
    path->inertia = qn_inertia_new (as->unknown_count, as->ap, as->ai);
  if (path->inertia == NULL || !qn_inertia_count (path->inertia, as->ax, count))
    return false;
  eq->statistics.factorizations++;
  eq->statistics.factorization_work++;
  return true;
}

QnSolveStatus
qn_path_lowest_motion (QnPath *path, double *motion)
{
  const QnAssembly *as = &path->equilibrium.assembly;

  for (int32_t i = 0; i < as->unknown_count; i++)
    motion[i] = 1 + 0.5 * sin (1.7 * i); /* no symmetry of a structure has this */
  for (int k = 0; k < QN_PATH_BISECTIONS; k++) {
    for (size_t s = 0; s < as->settling_count; s++)
      motion[as->settling[s].unknown] = 0;
    QnSolveStatus solved = qn_inertia_solve (path->inertia, motion);
    if (solved != QN_SOLVE_CONVERGED)
      return solved;
    double largest = qn_largest (motion, (size_t) as->unknown_count);
    for (int32_t i = 0; i < as->unknown_count && largest > 0; i++)
      motion[i] /= largest;
  }
  return QN_SOLVE_CONVERGED;
}

/* The motion with the lowest eigenvalue, which is negative; `diagonal` is scratch. MECHANISM, CANCELLED or
 * NO_MEMORY. */
static QnSolveStatus
find_motion (QnPath *path, double *diagonal)
{
  QnEquilibrium *eq = &path->equilibrium;
  QnAssembly *as = &eq->assembly;
  QnInertiaCount count;
  double low = 0, high = 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    diagonal[i] = as->ax[as->diagonal[i]];
    low = fmin (low, -2 * fabs (diagonal[i]));
  }
  for (int k = 0; k < QN_PATH_BISECTIONS; k++) {
    double middle = 0.5 * (low + high);
    for (int32_t i = 0; i < as->unknown_count; i++)
      as->ax[as->diagonal[i]] = diagonal[i] - middle;
    if (!qn_equilibrium_go_on (eq))
      return QN_SOLVE_CANCELLED;
    if (!qn_path_count_inertia (path, &count))
      return QN_SOLVE_NO_MEMORY;
    *(count.negative > 0 ? &high : &low) = middle;
  }
  return qn_path_lowest_motion (path, eq->motion) == QN_SOLVE_NO_MEMORY
           ? QN_SOLVE_NO_MEMORY
           : QN_SOLVE_MECHANISM;
}

/* How many eigenvalues of a symmetric tangent are negative on motions that leave `held` alone; `negative`
 * of all. FAILED where the tangent is singular. */
static QnSolveStatus
count_with_measure (QnEquilibrium *eq, const double *held, double *scratch,
                    int32_t *negative)
{
  int32_t n = eq->assembly.unknown_count;

  memcpy (scratch, held, (size_t) n * sizeof *scratch);
  QnSolveStatus status =
    qn_linsys_factor_and_solve (eq->linsys, eq->assembly.ax, scratch);
  if (status != QN_SOLVE_CONVERGED)
    return status;
  *negative -= qn_dot (held, scratch, (size_t) n) < 0;
  return QN_SOLVE_CONVERGED;
}

QnSolveStatus
qn_path_judge_stability (QnPath *path, const double *held, bool proves)
{
  QnEquilibrium *eq = &path->equilibrium;
  QnAssembly *as = &eq->assembly;
  QnInertiaCount count;

  if (!as->nonlinear || as->unknown_count == 0)
    return QN_SOLVE_CONVERGED;
  qn_assembly_tangent_at_rest (as, eq->multiplier);
  eq->factored = false;
  bool symmetric = qn_assembly_is_symmetric (as);
  if (proves && !symmetric)
    return QN_SOLVE_CONVERGED;
  if (!qn_path_count_inertia (path, &count))
    return QN_SOLVE_NO_MEMORY;
  if (count.negative == 0)
    return QN_SOLVE_CONVERGED;
  if (held != NULL) {
    QnSolveStatus status =
      count_with_measure (eq, held, path->displacements, &count.negative);
    if (status != QN_SOLVE_CONVERGED)
      return status == QN_SOLVE_FAILED ? QN_SOLVE_CONVERGED : status;
    if (count.negative == 0)
      return QN_SOLVE_CONVERGED;
  } else if (!symmetric) {
    QnSolveStatus factored = qn_linsys_factor (eq->linsys, as->ax);
    if (factored == QN_SOLVE_NO_MEMORY)
      return factored;
    if (factored == QN_SOLVE_FAILED || qn_linsys_sign (eq->linsys) > 0)
      return QN_SOLVE_CONVERGED;
  }
  return find_motion (path, path->displacements);
}
