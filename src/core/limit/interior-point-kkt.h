/* The linear systems of the interior-point engine; private to collapse.c.
 *
 * Solves   [ H+r  B' 0 ] [ y ]   [ ry ]
 *          [ B   -r  f ] [ v ] = [ rv ]      H = Q + F diag (w) G
 *          [ 0    f' 0 ] [ l ]   [ rl ]
 *
 * (F = G' where flow is associative; without the last row and column where there is no load f) by one
 * factorisation of the Schur complement M = B (H+r)^-1 B' + r, f bordered.
 *
 * r is the regularisation: cells with a free direction (H singular), redundant and empty rows
 * (M singular) and forces that wedge each other without end would leave the system singular.
 * It acts as a proximal term of the step, so a step of length 1 leaves r times itself as the
 * residual of the optimality conditions, and that vanishes as steps do.
 *
 * Weights w spread over twenty orders of magnitude near the optimum. What a joint's strength
 * rows do, g = G y, is therefore returned besides y: it is found from the forces along v without
 * the cancellation that forming G y has where a large weight keeps that near 0. The first block
 * row then holds by construction, and iterative refinement looks at the other two.
 */
#pragma once

#include "core/equilibrium/interior-point.h"
#include "core/linalg/block-lu.h"
#include "core/result/result.h"

/* M is symmetric and positive definite where flow is associative; its sparsity is that of the graph of bodies and
 * does not change: the order of elimination is chosen once, every later factorisation is numeric only. It is done
 * in dense fronts (block-lu.h), twice the arithmetic of Cholesky's, of which the processor does far more at a time
 * than of the sparse one's. */
typedef struct QnIpKkt {
  QnPool pool;  /* of all arrays */
  QnIpStep *ip; /* borrowed, with its problem, weights and the inverse of H+r */
  int32_t *columns, *rows; /* pattern of M, both halves */
  double *values;
  QnBlockLu *lu;
  int32_t *slots;       /* group_count x 36: place of each entry in values, or -1 */
  int32_t *diagonal;    /* row_count: place of the diagonal entry */
  QnStatistics *effort; /* borrowed: factorisations and factor_seconds count there */
  double *rates;        /* scratch, cell_count x 2 */
  double *residual_v;
  double residual_lambda;
  double *step_v; /* the last correction */
  double step_lambda;
  bool bordered;       /* the multiplier is an unknown; set by _factorize() */
  double *border;      /* M^-1 f, row_count */
  double border_power; /* f'M^-1 f */
  double error; /* largest relative residual since _factorize(); INFINITY: it failed */
} QnIpKkt;

/* `kkt` is overwritten without being cleared. False when memory runs out; to be cleared all the same. */
bool qn_ip_kkt_init (QnIpKkt *kkt, QnIpStep *ip, QnStatistics *effort);

/* Factorises for the weights; false where the matrix is singular. */
bool qn_ip_kkt_factorize (QnIpKkt *kkt);

/* Solves for y (shear of cells without shear is ignored), v and lambda (ignored without a load) of a right-hand
 * side; `out`, whose s becomes G y, must not overlap it. */
void qn_ip_kkt_solve (QnIpKkt *kkt, const QnIpVector *right, QnIpVector *out);

void qn_ip_kkt_clear (QnIpKkt *kkt);
