/* Healing of polygons that should touch but miss each other by a little.
 *
 * All operations take a tolerance in m, do nothing to what fits already (coordinates keep every
 * digit), are deterministic, and report what they did. Rings that collapse are left with
 * fewer than three points, so that indices stay; qn_drop_collapsed() removes them.
 */
#pragma once

#include "stereotomy/ring.h"

typedef struct QnHealing {
  size_t count;    /* vertices moved or inserted */
  double farthest; /* m: longest way a vertex went */
  QnVec2 at;       /* where that was */
} QnHealing;

/* Notes (where `healing` is given) that a vertex went from one place to another. */
void qn_healing_note (QnHealing *healing, QnVec2 from, QnVec2 to);

/* Vertices within the tolerance of each other become one. The place that most vertices already
 * share wins (the one named first among equals), so a single stray end joins the others and
 * not the other way round. Corners and then points on the boundary of `frame` (nullable) win over
 * all others. Differences up to `least` are rounding and stay. `healing` (nullable) is added
 * to. */
void qn_weld_vertices (QnRings *rings, double least, double tolerance,
                       const QnRing *frame, QnHealing *healing);

/* Closes gaps and small overlaps: every ring is fitted to those before it in the list. Its
 * vertices move to a vertex, else onto an edge of theirs, within the tolerance; where one of
 * their vertices lies beside an edge of its own, that edge gets it as a vertex. */
void qn_snap_neighbours (QnRings *rings, double tolerance, QnHealing *healing);

/* Removes rings with fewer than three points. */
void qn_drop_collapsed (QnRings *rings);

/* Length over which the boundaries of two counter-clockwise rings lie on each other, m. */
double qn_joint_length (const QnRing *a, const QnRing *b, double tolerance);
