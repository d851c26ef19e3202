#include "stereotomy/pieces.h"
#include "core/base/memory.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined __GNUC__
__attribute__ ((format (printf, 1, 0)))
#endif
static char *
format_name (const char *format, va_list arguments)
{
  va_list again;
  va_copy (again, arguments);
  int length = vsnprintf (NULL, 0, format, again);
  va_end (again);
  char *name = length >= 0 ? qn_alloc ((size_t) length + 1, 1) : NULL;
  if (name != NULL)
    vsnprintf (name, (size_t) length + 1, format, arguments);
  return name;
}

static void
piece_clear (QnPiece *piece)
{
  free (piece->name);
  qn_ring_clear (&piece->ring);
  *piece = (QnPiece){ 0 };
}

/* Takes over name and ring. */
static QnPiece *
add (QnPieces *pieces, char *name, QnRing ring)
{
  QnPiece piece = { .name = name, .ring = ring };
  if (name != NULL && ring.points != NULL
      && QN_ARRAY_PUSH (pieces->items, pieces->count, pieces->capacity, piece))
    return &pieces->items[pieces->count - 1];
  piece_clear (&piece);
  pieces->failed = true;
  return &pieces->spare;
}

QnPiece *
qn_pieces_add (QnPieces *pieces, const QnVec2 *points, size_t count, const char *format,
               ...)
{
  QnRing ring;
  qn_ring_init (&ring, points, count);
  va_list arguments;
  va_start (arguments, format);
  char *name = format_name (format, arguments);
  va_end (arguments);
  return add (pieces, name, ring);
}

QnPiece *
qn_pieces_add_ring (QnPieces *pieces, QnRing ring, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *name = format_name (format, arguments);
  va_end (arguments);
  return add (pieces, name, ring);
}

void
qn_pieces_take (QnPieces *pieces, QnPiece *piece)
{
  if (QN_ARRAY_PUSH (pieces->items, pieces->count, pieces->capacity, *piece))
    *piece = (QnPiece){ 0 };
  else
    pieces->failed = true;
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
