/* Are these modes of vibration, and is none below them missing?
 *
 * A mode x with the circular frequency w is one of K x = w^2 M x where K x - w^2 M x is nothing beside
 * |K| |x|. How many modes lie below a frequency is told by Sylvester's law of inertia, without knowing
 * them: K - s M has as many negative eigenvalues as there are w^2 below s, where M is positive definite
 * (Parlett, The Symmetric Eigenvalue Problem, 1998, 3.3).
 */
#pragma once

#include "core/assembly/assembly.h"
#include "core/linalg/inertia.h"

/* A mode's residual is below this part of |K| |x|; modes are orthonormal in the metric of M to it. */
#define QN_MODE_RESIDUAL 1e-6

/* Squares of frequencies below this part of the largest stiffness over mass are rounding. */
#define QN_MODE_ZERO 1e-12

typedef struct QnModeProof {
  QnPool pool;                /* of numbers */
  const QnAssembly *assembly; /* borrowed */
  int32_t n;
  double *stiffness, *mass; /* K and M in the pattern of the assembly */
  double *shifted;          /* scratch, K - s M */
  double *product;          /* scratch, unknowns */
  double *tangents;         /* of pairs for small vibrations: pair_count x 4 */
  QnInertia *inertia;
  double largest; /* of K_ii / M_ii, 1/s^2 */
} QnModeProof;

/* Takes the tangent of the assembly's last evaluation: with closed joints elastic, or as they slide,
 * settling supports held. Refuses blocks without mass; to be cleared all the same. */
QnStatus qn_mode_proof_init (QnModeProof *proof, QnAssembly *assembly, double multiplier,
                             bool sliding, QnDiag *diag);

void qn_mode_proof_clear (QnModeProof *proof);

/* Largest entry of K x - square M x, over that of |K| |x|. x: unknowns. */
double qn_mode_proof_residual (QnModeProof *proof, double square, const double *x);

/* Largest entry of X'MX - 1; X: so many columns of unknowns. */
double qn_mode_proof_skewness (QnModeProof *proof, size_t count, const double *columns);

/* How many modes have a square of their frequency that is less than `square` by more, or is greater by
 * less, than what two frequencies are taken for one by: below and up to it. Where rounding leaves the
 * count open it is told as it is. False when memory runs out. */
bool qn_mode_proof_count (QnModeProof *proof, double square, int32_t *below,
                          int32_t *up_to);
