/* Partial elimination of a dense matrix: the inner work of a multifrontal factorisation.
 *
 * A front is a dense matrix of pivots, which are eliminated, and a rest, eliminated in later fronts:
 *
 *   | D  U |   pivots            D = P' L_1 U_1   rows exchanged among the pivots only
 *   | L  S |   rest              L = L U_1^-1,  U = L_1^-1 P U,  S = S - L U
 *
 * All are stored by columns, U by rows (which makes it as high as L), whose height is a multiple
 * of QN_FRONT_ROWS numbers; the padding must be zero and stays so. The loops work on as many
 * numbers at a time as the SIMD registers hold, in the same order on all processors: results are equal to
 * the bit.
 */
#pragma once

#include "core/base/base.h"

#define QN_FRONT_ROWS 8

/* Stands for a pivot that vanishes: far below any stiffness, far above what its reciprocal could make
 * overflow (products of several may: then elimination and solutions are not finite). The Schur complement
 * of the front is exact if the row and column of the pivot vanish; then solutions are as large as its
 * reciprocal, along the null vector of the matrix. */
#define QN_FRONT_VANISHED 1e-60

/* Height of the columns of a matrix of `rows` rows. */
static inline int32_t
qn_front_height (int32_t rows)
{
  return (rows + QN_FRONT_ROWS - 1) / QN_FRONT_ROWS * QN_FRONT_ROWS;
}

typedef struct QnDenseFront {
  int32_t pivots, rest;
  double *
    diagonal; /* D, then L_1 below and U_1 above the diagonal, and one over U_1's on it */
  double *lower; /* L */
  double *upper; /* U by rows: height of the rest, one column a pivot */
  double *schur; /* out: - L U, padding included; S itself is for the caller to add */
  int32_t *exchanges; /* out, one a pivot: the row it was exchanged with */
} QnDenseFront;

/* Sizes of the pivots of a factorisation so far. */
typedef struct QnPivotRange {
  double smallest, largest;
} QnPivotRange;

/* The loops for one kind of processor. */
typedef struct QnFrontLoops {
  /* Eliminates the pivots; false where one is no number. */
  bool (*eliminate) (const QnDenseFront *front, QnPivotRange *range);
  /* x = L_1 \ P x of the pivots, and below = L x of the rest. Both have the padding of
   * columns, which must be zero in x. */
  void (*forward) (const QnDenseFront *front, double *x, double *below);
  /* x = U_1 \ (x - U above). Both have the padding of columns, which must be zero. */
  void (*backward) (const QnDenseFront *front, double *x, const double *above);
} QnFrontLoops;

/* Those for vectors of two and of four doubles, and the fastest of this processor with at most `width`. */
extern const QnFrontLoops qn_front_loops_2, qn_front_loops_4;
const QnFrontLoops *qn_front_loops (int width);
