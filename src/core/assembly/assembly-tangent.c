/* The tangent of the assembled structure. */
#include "core/assembly/assembly-parts.h"

#include "core/base/tolerance.h"

#include <math.h>
#include <string.h>

/* A joint without a bond is closed where this part of the largest force presses it together; less is what
 * is left of an iteration. */
#define TOUCH 1e-6

/* The pattern is symmetric: a column says which columns have an entry in its row. */
static void
clear_settling_rows (QnAssembly *as)
{
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    for (int32_t k = as->ap[i]; k < as->ap[i + 1]; k++)
      as->ax[qn_sparse_find (as->ap, as->ai, i, as->ai[k])] =
        as->ai[k] == i ? as->stiffness : 0;
  }
}

void
qn_assembly_tangent_of (QnAssembly *as, double multiplier, double viscosity,
                        const double *tangents, size_t stride)
{
  memset (as->ax, 0, (size_t) as->ap[as->unknown_count] * sizeof *as->ax);
  qn_assembly_add_face_tangents (as, tangents, stride);
  qn_beam_assembly_add_tangent (as);
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->ax[as->diagonal[i]] += viscosity * as->damping[i];
  if (as->nonlinear)
    qn_assembly_add_load_stiffness (as, multiplier);
  clear_settling_rows (as);
}

void
qn_assembly_tangent (QnAssembly *as, double multiplier, double viscosity)
{
  qn_assembly_tangent_of (as, multiplier, viscosity, as->responses[0].tangent[0],
                          sizeof *as->responses / sizeof (double));
}

static void
hold_settling (QnAssembly *as)
{
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    for (int32_t k = as->ap[i]; k < as->ap[i + 1]; k++)
      if (as->ai[k] != i)
        as->ax[k] = 0;
  }
}

void
qn_assembly_tangent_of_vibration (QnAssembly *as, double multiplier, bool sliding,
                                  double *tangents)
{
  double largest = 0;

  for (size_t p = 0; p < as->pair_count; p++)
    largest =
      fmax (largest, hypot (as->responses[p].force[0], as->responses[p].force[1]));
  for (size_t p = 0; p < as->pair_count; p++)
    if (as->inactive[p])
      memset (tangents + 4 * p, 0, 4 * sizeof *tangents);
    else
      qn_pair_vibration_tangent (&as->springs[p], &as->responses[p], TOUCH * largest,
                                 sliding, tangents + 4 * p);
  qn_assembly_tangent_of (as, multiplier, 0, tangents, 4);
  hold_settling (as);
}

static bool
lets_go (const QnAssembly *as, size_t pair)
{
  const QnPairSprings *springs = &as->springs[pair];

  return springs->a.kind == QN_LAW_NO_TENSION && springs->b.kind == QN_LAW_NO_TENSION
         && as->responses[pair].state == QN_PAIR_SLIP;
}

void
qn_assembly_tangent_at_rest (QnAssembly *as, double multiplier)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (lets_go (as, p))
      memset (as->responses[p].tangent, 0, sizeof as->responses[p].tangent);
  qn_assembly_tangent (as, multiplier, 0);
  hold_settling (as);
  for (size_t p = 0; p < as->pair_count; p++)
    if (lets_go (as, p))
      qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                        &as->responses[p]);
}

bool
qn_assembly_is_symmetric (const QnAssembly *as)
{
  double largest = 0, skew = 0;

  for (int32_t j = 0; j < as->unknown_count; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++) {
      int32_t i = as->ai[k], low = as->ap[i];
      while (as->ai[low] != j)
        low++;
      largest = fmax (largest, fabs (as->ax[k]));
      skew = fmax (skew, fabs (as->ax[k] - as->ax[low]));
    }
  return skew <= QN_TOLERANCE_SYMMETRIC * largest;
}
