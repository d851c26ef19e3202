#include "stereotomy/pieces.h"
#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

static void
piece_clear (QnPiece *piece)
{
  g_free (piece->name);
  qn_ring_clear (&piece->ring);
  *piece = (QnPiece){ 0 };
}

QnPiece *
qn_pieces_add (QnPieces *pieces, QnRing ring, const char *format, ...)
{
  QnPiece piece = { .ring = ring };
  va_list arguments;
  va_start (arguments, format);
  piece.name = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  qn_pieces_take (pieces, &piece);
  return &pieces->items[pieces->count - 1];
}

void
qn_pieces_take (QnPieces *pieces, QnPiece *piece)
{
  qn_require_memory (
    QN_ARRAY_PUSH (pieces->items, pieces->count, pieces->capacity, *piece));
  *piece = (QnPiece){ 0 };
}

void
qn_piece_inherit (QnPiece *piece, const QnPiece *from)
{
  char *name = piece->name;
  QnRing ring = piece->ring;
  *piece = *from;
  piece->name = name;
  piece->ring = ring;
}

void
qn_pieces_remove (QnPieces *pieces, size_t index)
{
  QN_ASSERT (index < pieces->count);
  piece_clear (&pieces->items[index]);
  memmove (pieces->items + index, pieces->items + index + 1,
           (pieces->count - index - 1) * sizeof *pieces->items);
  pieces->count--;
}

void
qn_pieces_clear (QnPieces *pieces)
{
  for (size_t i = 0; i < pieces->count; i++)
    piece_clear (&pieces->items[i]);
  free (pieces->items);
  *pieces = (QnPieces){ 0 };
}
