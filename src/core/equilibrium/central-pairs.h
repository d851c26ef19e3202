/* All contact pairs of a central path: see central-path.h. Their arithmetic is central-pack.h's. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/equilibrium/central-pack.h"

typedef struct QnCentralPairs {
  QnPool pool;          /* of all that follows */
  QnAssembly *assembly; /* borrowed */
  double force, length; /* units, N and m */
  double products;      /* number of products s z */
  bool others;          /* some pairs have other laws */
  bool turned;          /* some slip has passed a corner of the law's dilation */
  double *slips;        /* by pair: slip about which dilation is linearised, m */
  const QnCentralLoops *loops;
  size_t count; /* of packs; unused places of the last one are like pairs of other laws */
  QnCentralPack *packs;
  QnCentralState *steps; /* the direction */
  QnCentralState *kept;  /* the best direction so far, during centring */
  QnCentralState *near;  /* state saved by qn_central_pairs_keep() */
  double *rates;         /* pairs x 2: elongations by a step */
  double *forces;        /* pairs x 2, N; tangents: x 4, N/m */
  double *tangents;
} QnCentralPairs;

/* False when memory runs out; _clear is legal then. */
bool qn_central_pairs_init (QnCentralPairs *pairs, QnAssembly *assembly);

void qn_central_pairs_clear (QnCentralPairs *pairs);

/* Starts all pairs from the last evaluation inside their strength: s z = size, s - z the remaining strength
 * or minus the opening. Dilation is linear about the committed slip; `again`: about the slip at which the
 * path before left those that turned. */
void qn_central_pairs_start (QnCentralPairs *pairs, double size, bool again);

/* Residuals and tangents at the last elongations; evaluates pairs of other laws, false if that failed. */
bool qn_central_pairs_prepare (QnCentralPairs *pairs, QnCentralResiduals *residuals);

/* Sets `forces` to the present ones; or to those of unmoved blocks at the aim (CENTRE keeps the present
 * direction). */
void qn_central_pairs_get_forces (QnCentralPairs *pairs);
void qn_central_pairs_aim (QnCentralPairs *pairs, const QnCentralAim *aim);

/* Exchanges the direction with the kept one. */
void qn_central_pairs_exchange_steps (QnCentralPairs *pairs);

/* Saves the state; restores it, after which only qn_central_pairs_take_flow() is allowed. */
void qn_central_pairs_keep (QnCentralPairs *pairs);
void qn_central_pairs_come_back (QnCentralPairs *pairs);

/* Writes present forces and their plastic elongations into the assembly's responses. False if a law has no
 * response there or some pair has turned. */
bool qn_central_pairs_take_flow (QnCentralPairs *pairs);
