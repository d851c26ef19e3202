/* The tangent of the assembled structure.
 *
 * In linear geometry a pair's part of it depends on the pair's phase alone. What blocks have whose
 * pairs all kept theirs since the last time is there already; what the others have is added up
 * again from nothing, in the same order: differences would lose the digits of joints that open.
 */
#include "core/assembly/assembly-parts.h"

#include "core/base/tolerance.h"

#include <string.h>

/* Up to this part of the pairs, assembling single blocks is faster. */
#define FEW 0.25

static void
clear_settling_rows (QnAssembly *as)
{
  for (size_t s = 0; s < as->settling_count; s++) {
    const QnSettling *settling = &as->settling[s];
    int32_t i = settling->unknown, count = as->ap[i + 1] - as->ap[i] - 1;
    for (int32_t k = 0; k < count; k++)
      as->ax[as->settling_entries[settling->first_entry + k]] = 0;
    as->ax[as->diagonal[i]] = as->stiffness;
  }
}

void
qn_assembly_tangent_of (QnAssembly *as, double multiplier, double viscosity,
                        const double *tangents, size_t stride)
{
  as->is_tangent = false;
  memset (as->ax, 0, (size_t) as->ap[as->unknown_count] * sizeof *as->ax);
  qn_assembly_add_face_tangents (as, tangents, stride);
  qn_beam_assembly_add_tangent (&as->beams, as->ax);
  for (int32_t i = 0; i < as->unknown_count; i++)
    as->ax[as->diagonal[i]] += viscosity * as->damping[i];
  if (as->nonlinear)
    qn_assembly_add_load_stiffness (as, multiplier);
  clear_settling_rows (as);
}

/* Takes up the phases of all pairs, and which blocks are stale: those of pairs whose tangent is
 * another than the last time. Returns how many pairs these are. */
static size_t
take_phases (QnAssembly *as)
{
  size_t changed = 0;

  memset (as->stale, 0, qn_model_body_count (as->model) * sizeof *as->stale);
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairResponse *response = &as->responses[p];
    const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[p].face];
    if (!response->varies && response->phase == as->phases[p])
      continue;
    as->stale[face->a] = as->stale[face->b] = true;
    /* no phase at all: what varies is another one the next time */
    as->phases[p] = response->varies ? INT16_MIN : response->phase;
    changed++;
  }
  return changed;
}

void
qn_assembly_tangent (QnAssembly *as, double multiplier, double viscosity)
{
  const double *tangents = as->responses[0].tangent[0];
  size_t stride = sizeof *as->responses / sizeof (double);
  bool keeps = as->is_tangent && as->tangent_viscosity == viscosity && !as->nonlinear
               && as->beams.count == 0 && as->settling_count == 0
               && (as->model->analysis.no_shortcuts & QN_SHORTCUT_UNCHANGED_JOINTS) == 0;

  if ((double) take_phases (as) <= FEW * (double) as->pair_count && keeps)
    qn_assembly_renew_face_tangents (as, tangents, stride, viscosity);
  else
    qn_assembly_tangent_of (as, multiplier, viscosity, tangents, stride);
  as->is_tangent = true;
  as->tangent_viscosity = viscosity;
}

void
qn_assembly_tangent_held (QnAssembly *as, double multiplier)
{
  qn_assembly_tangent (as, multiplier, 0);
  as->is_tangent = false;
  for (size_t s = 0; s < as->settling_count; s++) {
    int32_t i = as->settling[s].unknown;
    for (int32_t k = as->ap[i]; k < as->ap[i + 1]; k++)
      if (as->ai[k] != i)
        as->ax[k] = 0;
  }
}

static bool
lets_go (const QnAssembly *as, size_t pair)
{
  const QnPairSprings *springs = &as->springs[pair];

  return springs->a.kind == QN_LAW_NO_TENSION && springs->b.kind == QN_LAW_NO_TENSION
         && qn_pair_state (springs, as->responses[pair].phase) == QN_PAIR_SLIP;
}

void
qn_assembly_tangent_at_rest (QnAssembly *as, double multiplier)
{
  for (size_t p = 0; p < as->pair_count; p++)
    if (lets_go (as, p))
      memset (as->responses[p].tangent, 0, sizeof as->responses[p].tangent);
  qn_assembly_tangent_held (as, multiplier);
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
