/* LU factorisation of sparse matrices with a symmetric pattern, in dense fronts.
 *
 * Multifrontal (Duff & Reid 1983): unknowns with mostly the same neighbours are eliminated together as a
 * dense matrix (a front), and the Schur complement of each front is kept. A front is eliminated again only
 * if one of its entries, or a front below it, has changed.
 *
 * Subtrees of a large tree are eliminated and solved with in parallel where threads are lent. Which
 * subtrees depends on the matrix alone, and so do all results, to the bit.
 *
 * Rows are exchanged among the pivots of a front only, so that a factorisation can lose digits
 * or break down where one with free pivoting would not: the caller must test its solutions.
 */
#pragma once

#include "core/base/status.h"
#include "core/base/workers.h"

typedef struct QnBlockLu QnBlockLu;

/* Orders and analyses an n x n pattern in compressed columns (ap, n + 1; ai sorted), which
 * must be symmetric. The pattern is borrowed and must outlive the object. `workers`
 * (nullable) are borrowed as well. NULL when memory runs out. */
QnBlockLu *qn_block_lu_new (int32_t n, const int32_t *ap, const int32_t *ai,
                            const QnWorkers *workers);

void qn_block_lu_free (QnBlockLu *lu);

/* Factorises the matrix with the values ax. Returns the ratio of the smallest to the largest
 * pivot, where one that vanishes counts as QN_FRONT_VANISHED (dense-front.h); 0 where one is no
 * number (there is nothing to solve with then). Allocates nothing. */
double qn_block_lu_factor (QnBlockLu *lu, const double *ax);

/* The same, but eliminates only fronts with new values and those above them; the factors are the same
 * to the bit. *work: share of a whole factorisation; 0: no value was new. */
double qn_block_lu_refactor (QnBlockLu *lu, const double *ax, double *work);

/* Overwrites b (length n) with the solution. */
void qn_block_lu_solve (QnBlockLu *lu, double *b);

/* Sign of the determinant of the matrix last factorised. */
int qn_block_lu_sign (const QnBlockLu *lu);
