/* Pieces: what a parametric object consists of before it becomes blocks. Private to this layer. */
#pragma once

#include "core/base/status.h"
#include "stereotomy/ring.h"

typedef struct QnPiece {
  char *name; /* owned, full name of the block */
  QnRing ring;
  bool fixed;          /* a foundation */
  int32_t ring_number; /* of an arch in several rings, from 1 on inside; 0: none */
  bool fabric; /* laid by a bond: may be cut by openings, merged with neighbours */
  bool cut;    /* no longer the whole unit */
  bool lone;   /* a sliver that no neighbour can take */
  int32_t leaf, course, position; /* of fabric */
  double whole_area;              /* of the uncut unit, m2 */
  double whole_width;             /* its smaller side, m */
} QnPiece;

typedef struct QnPieces {
  QnPiece *items;
  size_t count, capacity;
} QnPieces;

/* A new piece with a name, printf-like, and a ring, which it takes over. */
QnPiece *qn_pieces_add (QnPieces *pieces, QnRing ring, const char *format, ...)
  G_GNUC_PRINTF (3, 4);

/* Moves `piece` to the end of the list and zeroes it. */
void qn_pieces_take (QnPieces *pieces, QnPiece *piece);

/* Everything but name and ring. */
void qn_piece_inherit (QnPiece *piece, const QnPiece *from);

/* Removes one and closes the gap, or all. */
void qn_pieces_remove (QnPieces *pieces, size_t index);
void qn_pieces_clear (QnPieces *pieces);

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (QnPieces, qn_pieces_clear)

/* An axis-parallel rectangle, counter-clockwise from the lower left corner. */
static inline QnRing
qn_rectangle (double x0, double y0, double x1, double y1)
{
  const QnVec2 corners[] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
  return qn_ring_of (corners, 4);
}
