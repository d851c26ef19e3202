/* Proof that modes of vibration are correct and none below them is missing.
 *
 * (w, x) is a mode of K x = w^2 M x if K x - w^2 M x is small against |K| |x|. Number of modes below a
 * frequency: K - s M has as many negative eigenvalues as there are w^2 < s, M positive definite (Sylvester;
 * Parlett, The Symmetric Eigenvalue Problem, 1998, 3.3).
 */
#pragma once

#include "core/assembly/assembly.h"
#include "core/linalg/inertia.h"

/* Tolerance of a mode's residual over |K| |x|, of orthonormality in the metric of M, and of squares of
 * frequencies that are taken for one. */
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

/* Uses the tangent for small vibrations at the assembly's last evaluation (qn_assembly_tangent_of_vibration()).
 * Refuses blocks without mass; clear it even then. */
QnStatus qn_mode_proof_init (QnModeProof *proof, QnAssembly *assembly, double multiplier,
                             bool sliding, QnDiag *diag);

void qn_mode_proof_clear (QnModeProof *proof);

/* Largest entry of K x - square M x, over that of |K| |x|. x: unknowns. */
double qn_mode_proof_residual (QnModeProof *proof, double square, const double *x);

/* Largest entry of X'MX - 1; X: so many columns of unknowns. */
double qn_mode_proof_skewness (QnModeProof *proof, size_t count, const double *columns);

/* Numbers of modes with w^2 below `square`, and up to `square`, each beyond the tolerance by which two
 * frequencies count as equal. The counts may be off by rounding. False when memory runs out. */
bool qn_mode_proof_count (QnModeProof *proof, double square, int32_t *below,
                          int32_t *up_to);
