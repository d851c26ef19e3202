/* Is the equilibrium under dead load one in which a structure can stand?
 *
 * In large displacements an equilibrium may be unstable: a slender block on soft joints, upright beyond
 * its buckling load, is balanced and falls. Newton's method does not see that; the inertia of the
 * tangent stiffness does (core/linalg/inertia.h):
 *
 *   symmetric       any negative eigenvalue
 *   not symmetric   a negative determinant: an odd number of real negative eigenvalues, of which one
 *                   grows from rest. Negative second-order work alone proves nothing.
 */
#include "core/linalg/inertia.h"
#include "core/path/path.h"

#include <math.h>

/* Bisections of the lowest eigenvalue, and inverse iterations towards its vector from there. */
#define BISECTIONS         30
#define INVERSE_ITERATIONS 8

/* Writes S - shift into ax, whose diagonal was `diagonal`. */
static void
set_shift (QnAssembly *as, const double *diagonal, double shift)
{
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->ax[as->diagonal[i]] = diagonal[i] - shift;
}

/* The motion with the lowest eigenvalue, which is negative; `diagonal` is scratch. */
static bool
find_motion (QnAssembly *as, QnInertia *inertia, double *diagonal, double *motion)
{
  QnInertiaCount count;
  double low = 0, high = 0;

  for (int32_t i = 0; i < as->unknown_count; i++) {
    diagonal[i] = as->ax[as->diagonal[i]];
    low = fmin (low, -2 * fabs (diagonal[i]));
    motion[i] = 1 + 0.5 * sin (1.7 * i); /* no symmetry of a structure has this */
  }
  for (int k = 0; k < BISECTIONS; k++) {
    double middle = 0.5 * (low + high);
    set_shift (as, diagonal, middle);
    if (!qn_inertia_count (inertia, as->ax, &count))
      return false;
    *(count.negative > 0 ? &high : &low) = middle;
  }
  for (int k = 0; k < INVERSE_ITERATIONS; k++) {
    double largest = 0;
    QnFactorStatus solved = qn_inertia_solve (inertia, motion);
    if (solved != QN_FACTOR_OK)
      return solved == QN_FACTOR_SINGULAR;
    for (int32_t i = 0; i < as->unknown_count; i++)
      largest = fmax (largest, fabs (motion[i]));
    for (int32_t i = 0; i < as->unknown_count && largest > 0; i++)
      motion[i] /= largest;
  }
  return true;
}

QnSolveStatus
qn_path_judge_rest (QnPath *path)
{
  QnEquilibrium *eq = &path->equilibrium;
  QnAssembly *as = &eq->assembly;
  QnInertiaCount count;

  if (!as->nonlinear || as->unknown_count == 0)
    return QN_SOLVE_CONVERGED;
  QnInertia *inertia = qn_inertia_new (as->unknown_count, as->ap, as->ai);
  if (inertia == NULL)
    return QN_SOLVE_NO_MEMORY;
  qn_assembly_tangent_held (as, eq->multiplier);
  eq->factored = false;
  eq->statistics.factorizations++;
  eq->statistics.factorization_work++;
  bool ok = qn_inertia_count (inertia, as->ax, &count), unstable = false;
  if (ok && count.negative > 0) {
    unstable = qn_assembly_is_symmetric (as);
    if (!unstable) {
      QnFactorStatus factored = qn_linsys_factor (eq->linsys, as->ax);
      ok = factored != QN_FACTOR_NO_MEMORY;
      unstable = factored == QN_FACTOR_OK && qn_linsys_sign (eq->linsys) < 0;
    }
  }
  if (ok && unstable)
    ok = find_motion (as, inertia, path->displacements, eq->velocity);
  qn_inertia_free (inertia);
  return !ok ? QN_SOLVE_NO_MEMORY : unstable ? QN_SOLVE_MECHANISM : QN_SOLVE_CONVERGED;
}
