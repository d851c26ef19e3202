/* Events on a path of equilibria with rising and falling multiplier: jumps and collapse.
 *
 * A structure under a growing load leaves the path at a maximum of the multiplier and meets it again where
 * the multiplier exceeds this maximum. An event (QnPathEvent) lies between: the motion of the structure,
 * the energy set free by the load,
 *
 *   integral of (highest multiplier - multiplier) x live load . du,
 *
 * and the moving blocks. Dips within rounding are no events.
 */
#pragma once

#include "core/path/path.h"

typedef struct QnPathEvents {
  QnPath *path;                /* borrowed */
  double *rest;                /* unknowns before the live load acts */
  double *highest_u;           /* unknowns at the highest multiplier */
  double least;                /* multiplier below which jumps are rounding */
  double highest;              /* highest multiplier */
  double highest_displacement; /* largest of a body from `rest` to highest_u, m */
  double displacement; /* largest of a body from `rest` to the last equilibrium, m */
  double energy;       /* set free since highest_u, J */
  bool below;          /* the multiplier is below `highest` */
} QnPathEvents;

/* The path begins at the committed state. `unit`: the multiplier at which live loads are as large as dead
 * ones, 0 without dead load. False when memory runs out. */
bool qn_path_events_init (QnPathEvents *events, QnPath *path, double unit);

/* Whether the current multiplier exceeds the highest one by more than the tolerance of equilibrium; false on
 * a plateau. */
bool qn_path_events_climbs (const QnPathEvents *events);

/* Call with a new equilibrium before it is accepted; jumped: it was not reached along the path. Adds an event
 * if the multiplier exceeds its maximum again; *snap: the event is a SNAP. False when memory runs out. */
bool qn_path_events_observe (QnPathEvents *events, bool jumped, bool *snap);

/* Whether the motion since the highest multiplier is large enough for a snap. */
bool qn_path_events_has_snapped (const QnPathEvents *events);

/* Adds the event of a branch that loses its stability at the last step, which has the highest multiplier;
 * motion (unknowns): buckling mode. False when memory runs out. */
bool qn_path_events_buckle (QnPathEvents *events, const double *motion);

/* Adds the event of collapse, at the highest multiplier. False when memory runs out. */
bool qn_path_events_collapse (QnPathEvents *events);

/* Sets the blocks of the last event by this motion (unknowns): collapse under load control has no step
 * beyond the highest multiplier. */
void qn_path_events_take_mechanism (QnPathEvents *events, const double *velocity);
