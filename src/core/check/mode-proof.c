#include "core/check/mode-proof.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <math.h>
#include <string.h>

QnStatus
qn_mode_proof_init (QnModeProof *proof, QnAssembly *as, double multiplier, bool sliding,
                    QnDiag *diag)
{
  size_t n = (size_t) as->unknown_count, entries = (size_t) as->ap[n];
  QnPool *pool = &proof->pool;

  *proof = (QnModeProof){ .assembly = as,
                          .n = as->unknown_count,
                          .inertia = qn_inertia_new (as->unknown_count, as->ap, as->ai) };
  proof->stiffness = qn_pool_alloc (pool, entries, sizeof (double));
  proof->mass = qn_pool_alloc (pool, entries, sizeof (double));
  proof->shifted = qn_pool_alloc (pool, entries, sizeof (double));
  proof->product = qn_pool_alloc (pool, n, sizeof (double));
  proof->tangents = qn_pool_alloc (pool, 4 * as->pair_count, sizeof (double));
  if (pool->failed || proof->inertia == NULL)
    return qn_diag_no_memory (diag);
  QnStatus status = qn_assembly_mass (as, proof->mass, diag);
  if (status != QN_OK)
    return status;
  qn_assembly_tangent_of_vibration (as, multiplier, sliding, proof->tangents);
  memcpy (proof->stiffness, as->ax, entries * sizeof *proof->stiffness);
  for (size_t i = 0; i < n; i++) {
    double mass = proof->mass[as->diagonal[i]];
    if (mass > 0)
      proof->largest = fmax (proof->largest, proof->stiffness[as->diagonal[i]] / mass);
  }
  return QN_OK;
}

void
qn_mode_proof_clear (QnModeProof *proof)
{
  qn_pool_clear (&proof->pool);
  qn_inertia_free (proof->inertia);
  *proof = (QnModeProof){ 0 };
}

double
qn_mode_proof_residual (QnModeProof *proof, double square, const double *x)
{
  const QnAssembly *as = proof->assembly;
  double worst = 0, most = 0;

  for (int32_t j = 0; j < proof->n; j++) { /* rows are columns: both are symmetric */
    double sum = 0, size = 0;
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++) {
      sum += (proof->stiffness[k] - square * proof->mass[k]) * x[as->ai[k]];
      size += fabs (proof->stiffness[k] * x[as->ai[k]]);
    }
    worst = qn_worse (worst, fabs (sum));
    most = fmax (most, size);
  }
  return most > 0 ? worst / most : NAN;
}

double
qn_mode_proof_skewness (QnModeProof *proof, size_t count, const double *columns)
{
  size_t n = (size_t) proof->n;
  double worst = 0;

  for (size_t a = 0; a < count; a++) {
    qn_assembly_multiply (proof->assembly, proof->mass, columns + a * n, proof->product);
    for (size_t b = 0; b <= a; b++) {
      double sum = a == b ? -1 : 0;
      for (size_t i = 0; i < n; i++)
        sum += proof->product[i] * columns[b * n + i];
      worst = qn_worse (worst, fabs (sum));
    }
  }
  return worst;
}

static bool
count_below (QnModeProof *proof, double square, int32_t *count)
{
  QnInertiaCount found;

  for (int32_t k = 0; k < proof->assembly->ap[proof->n]; k++)
    proof->shifted[k] = proof->stiffness[k] - square * proof->mass[k];
  if (!qn_inertia_count (proof->inertia, proof->shifted, &found))
    return false;
  *count = found.negative;
  return true;
}

bool
qn_mode_proof_count (QnModeProof *proof, double square, int32_t *below, int32_t *up_to)
{
  double apart = QN_MODE_RESIDUAL * fabs (square) + QN_MODE_ZERO * proof->largest;

  return count_below (proof, square - apart, below)
         && count_below (proof, square + apart, up_to);
}
