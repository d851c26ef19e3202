/* LU factorisation of sparse matrices made of small dense blocks.
 *
 * The unknowns of one body stand together and meet the same columns, so that a tangent
 * stiffness is a sparse matrix of dense blocks of up to 3 x 3. Working on whole blocks spares
 * most of the index arithmetic of a scalar code and lets the processor work on four numbers
 * at a time.
 *
 * Left-looking, P A P' = L U with L unit lower block triangular; P orders the bodies to keep
 * the factors sparse (approximate minimum degree: Amestoy, Davis & Duff 1996). Rows are
 * exchanged within a diagonal block only, so that a factorisation can lose digits or break
 * down where one with free pivoting would not: the caller is to judge its solutions.
 */
#ifndef QN_CORE_BLOCK_LU_H
#define QN_CORE_BLOCK_LU_H

#include "core/status.h"

typedef struct QnBlockLu QnBlockLu;

/* Orders and analyses an n x n pattern in compressed columns (ap, n + 1; ai sorted), which
 * must be symmetric. The pattern is borrowed and must outlive the object. NULL when memory
 * runs out. */
QnBlockLu *qn_block_lu_new (int32_t n, const int32_t *ap, const int32_t *ai);

void qn_block_lu_free (QnBlockLu *lu);

/* Factorises the matrix with the values ax. Returns the ratio of the smallest to the largest
 * pivot, 0 where one vanished (there is nothing to solve with then). Allocates nothing. */
double qn_block_lu_factor (QnBlockLu *lu, const double *ax);

/* Overwrites b (length n) with the solution. */
void qn_block_lu_solve (QnBlockLu *lu, double *b);

/* Sign of the determinant of the matrix last factorised. */
int qn_block_lu_sign (const QnBlockLu *lu);

#endif
