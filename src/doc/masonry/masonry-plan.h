/* From a gesture to masonry: what a drawn rectangle, span or line becomes.
 *
 * Points are m of the model. Sizes are rounded to what the bond can lay. Objects are without a
 * name; qn_edit_add_masonry() gives them one. */
#pragma once

#include "stereotomy/masonry.h"
#include <glib.h>

/* Properties of new masonry. */
typedef struct QnMasonryStyle {
  QnVec2 unit; /* length of a block, height of a course, m */
  QnBond bond;
  double lap;         /* of running bond, part of a unit */
  double thickness;   /* m */
  double unit_weight; /* N/m3 */
  QnId law;           /* or QN_NONE */
  gboolean base;      /* on fixed blocks, one course deep */

  int
    kind; /* of what stands in a rectangle by itself, by name: COLUMN, BUTTRESS, PORTAL, RUBBLE,
               GRID or VORONOI */
  QnHead head; /* of openings */
  QnSpan span;
  QnArchShape shape; /* of arches */
  double ring;       /* m, thickness of arches */
  int32_t voussoirs; /* of arches */
  double
    top_to_foot; /* of columns, buttresses and rubble: width at the top to that at the foot */
} QnMasonryStyle;

/* A wall in the rectangle between two corners, from the first one; at least half a block and a
 * course. */
void qn_plan_wall (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 from,
                   QnVec2 to);

/* An opening of a wall between two corners; with `snap` by half blocks and courses. FALSE
 * where it would be empty. */
gboolean qn_plan_opening (const QnMasonry *wall, const QnMasonryStyle *style, QnVec2 from,
                          QnVec2 to, gboolean snap, QnOpening *opening);

/* An arch from springing to springing, left to right; where the rise does not suit the shape,
 * the shape gives way. */
void qn_plan_arch (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 left,
                   QnVec2 right, double rise);

/* How high a point lies above the chord of an arch, m, positive on the side of the crown. */
double qn_plan_arch_rise (QnVec2 left, QnVec2 right, QnVec2 at);

/* What the style's kind says, as wide and high as the rectangle: drums, and courses of a buttress and of
 * piers, are about a course high, stones of rubble and cells of Voronoi a block long, those of a grid
 * about a block long and a course high. The upright face of a buttress is
 * where the gesture began. A portal has one bay under a lintel of a course, piers a third as wide as
 * their distance. */
void qn_plan_in_box (QnMasonry *masonry, const QnMasonryStyle *style, QnVec2 from,
                     QnVec2 to);

/* Blocks of an object of this size, about: to know what is quick to draw. */
double qn_masonry_estimate_blocks (const QnMasonry *masonry);
