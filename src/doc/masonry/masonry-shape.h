/* The shape of a masonry object under the hand: its frame, size, openings, and the handles by
 * which it is dragged. All points of the interface in m of the model. */
#pragma once

#include "stereotomy/masonry.h"
#include <glib.h>

/* Handles: of an opening its box, of a wall its edges, of arches and columns their measures. */
typedef enum {
  QN_HANDLE_LEFT,
  QN_HANDLE_RIGHT,
  QN_HANDLE_BOTTOM,
  QN_HANDLE_TOP,
  QN_HANDLE_BOTTOM_LEFT,
  QN_HANDLE_BOTTOM_RIGHT,
  QN_HANDLE_TOP_LEFT,
  QN_HANDLE_TOP_RIGHT,
  QN_HANDLE_MIDDLE, /* moves an opening */
  QN_HANDLE_RISE,   /* of an arched head, springing; crown of the intrados of an arch */
  QN_HANDLE_RING,   /* crown of the extrados */
  QN_HANDLE_COUNT
} QnHandleKind;

typedef struct QnHandle {
  QnHandleKind kind;
  QnVec2 at;
} QnHandle;

/* No opening: the object itself. */
#define QN_NO_OPENING (-1)

/* A point of the object's own frame in the model, and back; m. */
QnVec2 qn_masonry_to_model (const QnMasonry *masonry, QnVec2 local);
QnVec2 qn_masonry_to_local (const QnMasonry *masonry, QnVec2 point);

/* The longest course of a wall that is listed, in units. */
double qn_wall_listed_length (const QnWall *listed);

/* Length and height of a wall; in custom bond those of its courses. */
QnVec2 qn_masonry_wall_size (const QnMasonry *masonry);

/* Whether the point lies in the rectangle of a wall, openings included. */
gboolean qn_masonry_wall_contains (const QnMasonry *masonry, QnVec2 point);

/* The opening of a wall around a point, or QN_NO_OPENING. */
int qn_masonry_opening_at (const QnMasonry *masonry, QnVec2 point);

/* Corners of an opening's box, counter-clockwise from the lower left. */
void qn_masonry_opening_corners (const QnMasonry *masonry, int opening,
                                 QnVec2 corners[4]);

/* Makes the opening span the box between two points, in either order; with `snap` by half blocks
 * and courses. False where it would be empty. */
gboolean qn_masonry_set_opening_box (const QnMasonry *masonry, QnOpening *opening,
                                     QnVec2 a, QnVec2 b, gboolean snap);

/* Gives an opening a head and what spans it, with sizes that fit its width where there were
 * none. */
void qn_opening_set_head (QnOpening *opening, QnHead head, QnSpan span,
                          double course_height);

/* Handles of an object or one of its openings; `handles` has room for QN_HANDLE_COUNT. */
guint qn_masonry_get_handles (const QnMasonry *masonry, int opening, QnHandle *handles);

/* Cells of a grid, in both directions, and of Voronoi: as many as before when the outline has changed, which
 * shapes of arches follow too. */
typedef struct QnMasonryCells {
  QnVec2 grid;
  QnRubble rubble;
} QnMasonryCells;
QnMasonryCells qn_masonry_get_cells (const QnMasonry *masonry);
void qn_masonry_keep_cells (QnMasonry *masonry, const QnMasonryCells *cells);

/* Drags a handle from one point to another. What cannot be is stopped at the least size. Grids and cells of
 * Voronoi keep their number of cells. */
void qn_masonry_drag (QnMasonry *masonry, int opening, QnHandleKind handle, QnVec2 from,
                      QnVec2 to, gboolean snap);

/* Lays a listed wall in a bond, or another one in another: size and openings stay. */
void qn_masonry_set_bond (QnMasonry *masonry, QnBond bond, double lap);
