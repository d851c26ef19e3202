/* Direct solution of sparse linear systems A x = b, behind one interface.
 *
 * The pattern of A is fixed for the life of a QnLinsys: ordering and symbolic analysis are
 * done once, each factorisation is numeric only. Nothing is allocated here between calls; the
 * library behind may do so.
 */
#pragma once

#include "core/base/status.h"
#include "core/base/workers.h"

typedef struct QnLinsys QnLinsys;

/* Outcome of a linear system or of an equilibrium iteration (core/equilibrium). */
typedef enum {
  QN_SOLVE_CONVERGED,
  QN_SOLVE_MECHANISM, /* relaxation ended in steady motion: no equilibrium at this load */
  QN_SOLVE_FAILED, /* singular to working precision; iteration budget spent, or the line search found
                         no descent */
  QN_SOLVE_CANCELLED,
  QN_SOLVE_NO_MEMORY
} QnSolveStatus;

/* For an n x n unsymmetric matrix in compressed columns with a structurally symmetric pattern
 * (column pointers ap, n + 1 of them; sorted row indices ai). The pattern is borrowed and
 * must outlive the system. `workers` (nullable) are borrowed as well. Returns NULL when memory runs out. */
QnLinsys *qn_linsys_new (int32_t n, const int32_t *ap, const int32_t *ai,
                         const QnWorkers *workers);

void qn_linsys_free (QnLinsys *system);

/* Factorises the matrix with the values ax. */
QnSolveStatus qn_linsys_factor (QnLinsys *system, const double *ax);

/* The same, and overwrites b (length n) with its solution, whose backward error tests the
 * factorisation. b is undefined unless QN_SOLVE_CONVERGED is returned. */
QnSolveStatus qn_linsys_factor_and_solve (QnLinsys *system, const double *ax, double *b);

/* Work of the last factorisation over that of a complete one. */
double qn_linsys_work (const QnLinsys *system);

/* Sign of the determinant of the matrix last factorised. */
int qn_linsys_sign (const QnLinsys *system);

/* Overwrites b (length n) with the solution of the last factorised system. */
void qn_linsys_solve (QnLinsys *system, double *b);
