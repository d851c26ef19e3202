/* Eigenvalues next to a shift, by Lanczos iteration.
 *
 *   K x = lambda M x,    K symmetric, M symmetric and positive semidefinite
 *
 * iterated with (K - sigma M)^-1 M, whose eigenvalues theta = 1 / (lambda - sigma) are largest
 * where lambda is next to the shift sigma. The vectors are kept orthogonal in the metric of M to
 * the last digit, and a basis that is full shrinks to its best vectors and grows again (thick
 * restart: Wu & Simon, SIAM J. Matrix Anal. Appl. 22 (2000) 602-616). Eigenvalues that come
 * several times are found by starting again from another vector until that brings nothing new.
 *
 * Eigenvalues far from the shift are less accurate, by rounding of the largest theta: to about
 * 1e-15 |lambda - sigma| / (the least of that), relative.
 *
 * Equal input gives equal output, in as many threads as there are.
 */
#pragma once

#include "core/linalg/linsys.h"

typedef struct QnLanczosProblem {
  int32_t n;                                                 /* unknowns */
  double shift;                                              /* sigma */
  void (*multiply) (void *data, const double *x, double *y); /* y = M x */
  void (*solve) (void *data, double *b);                     /* b := (K - sigma M) \ b */
  bool (*go_on) (void *data); /* once per product; false cancels; nullable */
  void *data;
} QnLanczosProblem;

/* Finds the `wanted` (>= 1) eigenvalues next to the shift. *found: how many there are, fewer
 * where M has not the rank. values: ascending, at least `wanted` of room; vectors: the same
 * number of columns of n, of unit length in the metric of M. QN_SOLVE_FAILED: they did not settle. */
QnSolveStatus qn_lanczos_run (const QnLanczosProblem *problem, size_t wanted,
                              size_t *found, double *values, double *vectors);
