/* Findings: remarks on a model, shown at their place. Some explain why an analysis refuses the model; none
 * is an error by itself. */
#pragma once

#include "core/base/problem.h"
#include "core/base/status.h"

typedef struct QnFinding {
  QnProblem problem; /* NEAR_MISS_GAP, BLOCKS_OVERLAP, BLOCK_FLOATING, … */
  QnId block_a;      /* block concerned */
  QnId block_b;      /* the other one, or QN_NONE */
  QnVec2 at;         /* place, m */
  /* Width of a gap or depth of an overlap, m; PAIRS_BENDING, PAIRS_CRUSHING: computed over true value; with
   * `range`: the number of the project; else 0. */
  double value;
  /* BEAM_FLOATING, BEAM_END_FREE: beam; TIE_OFF_BLOCK: tie; LOAD_…: load, dead ones first;
   * PAIRS_…: number of such joints, of which this one is the worst; with `range`: entity; else
   * QN_NONE. */
  QnId subject;
  const struct QnUsualRange *range; /* nullable: `value` is outside of it (plausible.h) */
} QnFinding;

typedef struct QnFindings {
  QnFinding *items;
  size_t count, capacity;
} QnFindings;

/* Whether `at` is valid: numbers of laws, loads and settings have no place. */
static inline bool
qn_finding_has_place (const QnFinding *finding)
{
  return finding->block_a != QN_NONE || finding->range == NULL;
}
