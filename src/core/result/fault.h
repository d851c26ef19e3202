/* Claims of a result, each checked by core/check. */
#pragma once

#include "core/base/status.h"

typedef enum {
  QN_CLAIM_NUMBERS,
  QN_CLAIM_STEPS,
  QN_CLAIM_DISPLACEMENTS,
  QN_CLAIM_FORCES,
  QN_CLAIM_BEAM_FORCES,
  QN_CLAIM_TIES,
  QN_CLAIM_STRENGTH,
  QN_CLAIM_STATES,
  QN_CLAIM_BALANCE,
  QN_CLAIM_REACTIONS,
  QN_CLAIM_OUTCOME,
  QN_CLAIM_COLLAPSE,
  QN_CLAIM_FIRST_LIMIT,
  QN_CLAIM_OVERLAP, /* of the mechanism, as the next two */
  QN_CLAIM_FLOW,
  QN_CLAIM_WORK,
  QN_CLAIM_STABILITY,
  QN_CLAIM_MODE,
  QN_CLAIM_LOWER_BOUND,
  QN_CLAIM_UPPER_BOUND,
  QN_CLAIM_INTERVAL, /* of the solutions */
  QN_CLAIM_LINEARITY,
  QN_CLAIM_HISTORY,
  QN_CLAIM_COUNT
} QnClaim;

/* A false claim, at the first place where it fails. */
typedef struct QnFault {
  QnClaim claim;
  QnId step;            /* or QN_NONE */
  QnEntity entity;      /* what `index` counts: QN_ENTITY_BLOCK, … */
  QnId index;           /* or QN_NONE */
  double stated, found; /* in the unit of the claim; NAN where it has no number */
} QnFault;
