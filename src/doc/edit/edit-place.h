/* Edits of where things are: by numbers, in line with each other, at equal distances.
 *
 * As in edit.h: on the draft that qn_document_edit_project() hands out, whole or refused. Lengths
 * are m, angles rad. A wall or another object of which every block is in the set moves as one
 * thing and stays parametric; other blocks and beams move one by one. */
#pragma once

#include "doc/edit/edit-frame.h"
#include "render/drawing/camera.h"

/* Where a set of blocks and beams is, and what its blocks come to. */
typedef struct QnExtent {
  QnBox box;       /* m */
  QnVec2 centroid; /* of the area of the blocks; of beams alone the middle of the box */
  double area;     /* m2 */
  double weight;   /* N, of blocks */
  /* Of a single block the direction of its longest side, the flattest of several of them, from
   * -90 to 90 degrees; 0 of several. */
  double angle;
} QnExtent;

/* FALSE for an empty set. */
gboolean qn_extent_find (const QnModel *model, QnPartSet set, QnExtent *extent);

typedef enum {
  QN_EXTENT_X,      /* left side of the box */
  QN_EXTENT_Y,      /* its lower side */
  QN_EXTENT_WIDTH,  /* scales about the left side */
  QN_EXTENT_HEIGHT, /* scales about the lower side */
  QN_EXTENT_ANGLE,  /* turns about the centroid, several by this angle */
  QN_EXTENT_COUNT
} QnExtentField;

/* Whether sizes can be set: not of blocks of walls and other objects, which have measures of their
 * own, and not of beams. */
gboolean qn_extent_can_scale (const QnModel *model, QnPartSet set);

gboolean qn_edit_set_extent (QnProject *draft, QnPartSet set, QnExtentField field,
                             double value, GError **error);

typedef enum {
  QN_ALIGN_LEFT,
  QN_ALIGN_CENTER, /* middles below each other */
  QN_ALIGN_RIGHT,
  QN_ALIGN_TOP,
  QN_ALIGN_MIDDLE, /* middles beside each other */
  QN_ALIGN_BOTTOM,
  QN_ALIGN_COUNT
} QnAlign;

/* Names of actions: "left", "center", …; FALSE when unknown. */
gboolean qn_align_parse (const char *name, QnAlign *align);

/* Moves every thing of the set so that it touches the box of all on that side. Refused for fewer
 * than two. */
gboolean qn_edit_align (QnProject *draft, QnPartSet set, QnAlign align, GError **error);

typedef enum {
  QN_SPREAD_CENTERS_X, /* equal distances of middles, from left to right */
  QN_SPREAD_CENTERS_Y,
  QN_SPREAD_GAPS_X, /* equal gaps between neighbours */
  QN_SPREAD_GAPS_Y,
  QN_SPREAD_COUNT
} QnSpreadMode;

/* "centers-x", "centers-y", "gaps-x", "gaps-y". */
gboolean qn_spread_parse (const char *name, QnSpreadMode *spread);

/* The first and the last thing stay where they are. Refused for fewer than three. */
gboolean qn_edit_spread (QnProject *draft, QnPartSet set, QnSpreadMode spread,
                         GError **error);
