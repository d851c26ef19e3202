/* Signs of the eigenvalues of a symmetric matrix, from its factors.
 *
 * A = L D L' has as many negative entries in D as A has negative eigenvalues (Sylvester's law of
 * inertia): a stiffness without any is that of a stable equilibrium.
 */
#ifndef QN_CORE_INERTIA_H
#define QN_CORE_INERTIA_H

#include "core/linalg/linsys.h"

typedef struct QnInertia QnInertia;

/* For an n x n symmetric matrix in compressed columns with a full, symmetric pattern (column
 * pointers ap, sorted row indices ai). The pattern is copied. NULL where memory runs out. */
QnInertia *qn_inertia_new (int32_t n, const int32_t *ap, const int32_t *ai);

void qn_inertia_free (QnInertia *inertia);

/* Factorises the matrix with the values ax, whose upper triangle counts. *negative is the
 * number of negative eigenvalues; one that is zero to working precision counts as negative.
 * False where memory runs out. */
bool qn_inertia_count (QnInertia *inertia, const double *ax, int32_t *negative);

/* Overwrites b (length n) with A \ b of the last matrix. */
QnFactorStatus qn_inertia_solve (QnInertia *inertia, double *b);

#endif
