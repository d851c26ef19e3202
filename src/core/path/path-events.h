/* What happens on a path of equilibria as its multiplier goes up and down: jumps, and collapse.
 *
 * A structure under a load that keeps growing leaves the path where the multiplier turns down and
 * meets it again where the multiplier climbs above its highest value so far. What lies between is
 * an event (QnPathEvent): how far the structure moves, the energy that the load sets free,
 *
 *   integral of (highest multiplier - multiplier) x live load . du,
 *
 * and the blocks that move. A dip that is not deeper than rounding is none.
 */
#pragma once

#include "core/path/path.h"

typedef struct QnPathEvents {
  QnPath *path;                /* borrowed */
  double *rest;                /* unknowns where the live load began to act */
  double *highest_u;           /* and where the multiplier was highest, */
  double least;                /* multiplier below which jumps are rounding */
  double highest;              /* what it was there, */
  double highest_displacement; /* and the largest of a body since `rest`, m */
  double displacement;         /* the same at the last equilibrium */
  double energy;               /* set free since then, J */
  bool below;                  /* the path has turned down and not climbed back yet */
} QnPathEvents;

/* The path begins at the committed state. `unit`: the multiplier at which live loads are as large as dead
 * ones, 0 without dead load. False when memory runs out. */
bool qn_path_events_init (QnPathEvents *events, QnPath *path, double unit);

/* Whether the current multiplier is above the highest one by more than what equilibrium may lack: on a
 * plateau it is not, however far the structure moves. */
bool qn_path_events_climbs (const QnPathEvents *events);

/* To be called with a new equilibrium just before it is accepted; jumped: the structure did not come
 * here along the path. Adds an event to the result where the path climbs above its highest multiplier
 * again, with *snap whether it is one that a real structure would show. False when memory runs out. */
bool qn_path_events_observe (QnPathEvents *events, bool jumped, bool *snap);

/* Whether the structure, where it is now, has moved as far as a snap takes it since the highest
 * multiplier. */
bool qn_path_events_has_snapped (const QnPathEvents *events);

/* At the highest multiplier, the last step, the branch loses its stability: in this motion (unknowns) the
 * path leaves it. False when memory runs out. */
bool qn_path_events_buckle (QnPathEvents *events, const double *motion);

/* The path does not climb above its highest multiplier again: that is collapse. False when memory runs
 * out. */
bool qn_path_events_collapse (QnPathEvents *events);

/* Names the blocks that move in this motion (unknowns) as those of the last event: of a collapse under load
 * control, what moves beyond the highest multiplier is no step. */
void qn_path_events_take_mechanism (QnPathEvents *events, const double *velocity);
