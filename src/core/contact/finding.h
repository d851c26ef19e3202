/* Findings: what is worth telling the user about a model that can nevertheless be analysed,
 * or that shows why it cannot. A list to be shown at the place, never an error by itself. */
#pragma once

#include "core/base/problem.h"
#include "core/base/status.h"

typedef struct QnFinding {
  QnProblem problem; /* NEAR_MISS_GAP, BLOCKS_OVERLAP, BLOCK_FLOATING, … */
  QnId block_a;      /* block concerned */
  QnId block_b;      /* the other one, or QN_NONE */
  QnVec2 at;         /* place, m */
  double
    value; /* width of the gap, depth of the overlap, m; PAIRS_BENDING and PAIRS_CRUSHING:
                   how many times what is right; 0 where there is none */
  QnId
    subject; /* BEAM_FLOATING, BEAM_END_FREE: the beam; TIE_OFF_BLOCK: the tie; LOAD_MEETS_NOTHING: the load, counted through the
                   dead and then the live ones; PAIRS_…: how many joints, of which this one is
                   the worst; of a range: the entity; QN_NONE otherwise */
  const struct QnUsualRange
    *range; /* what `value`, a number of the project, is outside of, or
                                       NULL (plausible.h) */
} QnFinding;

typedef struct QnFindings {
  QnFinding *items;
  size_t count, capacity;
} QnFindings;

/* Whether `at` says where: numbers of laws, loads and settings stand nowhere. */
static inline bool
qn_finding_has_place (const QnFinding *finding)
{
  return finding->block_a != QN_NONE || finding->range == NULL;
}

/* Appends; false when memory runs out. */
bool qn_findings_add (QnFindings *findings, QnFinding finding);

void qn_findings_clear (QnFindings *findings);
