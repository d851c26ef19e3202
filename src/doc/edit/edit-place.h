/* Edits of where things are, by numbers.
 *
 * As in edit.h: on the draft that qn_document_edit() hands out, whole or refused. Lengths
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
