/* All contact pairs of a central path: see central-path.h. Their arithmetic is central-pack.h's. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/equilibrium/central-pack.h"

typedef struct QnCentralPairs {
  QnPool pool;          /* of all that follows */
  QnAssembly *assembly; /* borrowed */
  double force, length; /* units, N and m */
  double products;      /* how many s z there are */
  bool others;          /* there are pairs of other laws */
  bool turned;          /* some slip has gone beyond a corner of its dilation, */
  double *slips;        /* by pair: about which dilation is taken as a straight line, m */
  const QnCentralLoops *loops;
  size_t count; /* of packs; what the last one lacks is like pairs of other laws */
  QnCentralPack *packs;
  QnCentralState *steps; /* the direction, */
  QnCentralState *kept;  /* and that found so far, while a better one is sought */
  QnCentralState *near;  /* a state that was kept */
  double *rates;         /* as many pairs x 2: elongations under a step */
  double *forces;        /* x 2, N, and tangents, x 4, N/m, as handed over */
  double *tangents;
} QnCentralPairs;

/* False when memory runs out; _clear is legal then. */
bool qn_central_pairs_init (QnCentralPairs *pairs, QnAssembly *assembly);

void qn_central_pairs_clear (QnCentralPairs *pairs);

/* All pairs at the state last evaluated, off the boundary of their strength: s z = size everywhere,
 * and s - z what strength is left, or how far they have opened. Slips dilate from what is
 * committed, or `again` along the line where the path before has led those that turned. */
void qn_central_pairs_start (QnCentralPairs *pairs, double size, bool again);

/* Residuals and tangents at the elongations last evaluated; pairs of other laws are evaluated.
 * False where that failed. */
bool qn_central_pairs_prepare (QnCentralPairs *pairs, QnCentralResiduals *residuals);

/* Sets `forces` to those that the pairs exert, or that they would exert if no block moved and they
 * had what is aimed at. A direction that is to be centred is kept. */
void qn_central_pairs_get_forces (QnCentralPairs *pairs);
void qn_central_pairs_aim (QnCentralPairs *pairs, const QnCentralAim *aim);

/* Exchanges the direction for the one that was kept. */
void qn_central_pairs_exchange_steps (QnCentralPairs *pairs);

/* Keeps the state, or comes back to it; only qn_central_pairs_take_flow() may follow then. */
void qn_central_pairs_keep (QnCentralPairs *pairs);
void qn_central_pairs_come_back (QnCentralPairs *pairs);

/* The responses of the laws become the forces as they are, with the plastic elongations that
 * belong to them. False where a law has no answer there, or some pair has turned. */
bool qn_central_pairs_take_flow (QnCentralPairs *pairs);
