/* Signs of the eigenvalues of a stiffness, from the factors of its symmetric part.
 *
 *   S = (A + A') / 2 = L D L'
 *
 * has as many negative eigenvalues as D has negative entries (Sylvester's law of inertia; Golub &
 * Van Loan, Matrix Computations, 8.1.5). What that proves of an equilibrium whose tangent is A:
 *
 *   A symmetric      none: every small motion takes work, and the equilibrium is stable under the
 *                    loads that it has. k: it is unstable, in k independent ways.
 *   A not symmetric  none: the second-order work v'Av of every motion is positive. Then all
 *                    eigenvalues of A have positive real parts (Bendixson 1902), its determinant is
 *                    positive, and no motion starts by itself from rest (Hill, J. Mech. Phys. Solids
 *                    6 (1958) 236-249). Growing vibrations of such a system are not excluded.
 *                    k: some motion would give off work. That is necessary for instability and not
 *                    sufficient: joints that slide without dilatancy show it long before anything
 *                    falls (Challamel, Nicot, Lerbet & Darve, Int. J. Numer. Anal. Meth. Geomech.
 *                    34 (2010) 1121-1137).
 *
 * Rows are not exchanged in L D L'. "None" needs no exchange: a matrix whose eigenvalues are positive
 * beyond rounding always factorises into positive pivots, and one with positive pivots is within
 * rounding of such a matrix (Higham, Accuracy and Stability of Numerical Algorithms, 10.1). Where
 * there are negative pivots, rounding is that of |L| |D| |L'|, whose diagonal is measured: where it
 * is too large, small matrices are factorised as dense ones with exchanges (Bunch & Kaufman 1977).
 */
#pragma once

#include "core/linalg/linsys.h"

typedef struct QnInertia QnInertia;

typedef struct QnInertiaCount {
  int32_t negative; /* eigenvalues of S below zero */
  int32_t zero;     /* zero to working precision */
  double
    rounding; /* the counts are those of a matrix that differs from S by about this part of
                       its largest entry */
} QnInertiaCount;

/* For an n x n matrix in compressed columns with a full, symmetric pattern (column pointers ap,
 * sorted row indices ai), which is borrowed. NULL where memory runs out. */
QnInertia *qn_inertia_new (int32_t n, const int32_t *ap, const int32_t *ai);

void qn_inertia_free (QnInertia *inertia);

/* Factorises the symmetric part of the matrix with the values ax. False where memory runs out. */
bool qn_inertia_count (QnInertia *inertia, const double *ax, QnInertiaCount *count);

/* Overwrites b (length n) with S \ b of the last matrix, by the factors without exchanges:
 * QN_SOLVE_FAILED where these are not accurate enough. */
QnSolveStatus qn_inertia_solve (QnInertia *inertia, double *b);
