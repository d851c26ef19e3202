#include "pieces.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef enum { BRACKETS, LINE, TWO_LINES, WORD, KIND_COUNT } Kind;

typedef struct {
  size_t start, length;
} Piece;

static bool
is_in (const char *set, uint8_t c)
{
  return c != '\0' && strchr (set, c) != NULL;
}

/* Behind the bracket that closes the one at `start`; of no other kind are counted. */
static size_t
close_bracket (const uint8_t *data, size_t size, size_t start)
{
  static const char pairs[] = "{}[]()<>";
  uint8_t open = data[start], close = (uint8_t) strchr (pairs, open)[1];
  int depth = 0;
  for (size_t i = start; i < size; i++) {
    depth += (data[i] == open) - (data[i] == close);
    if (depth == 0)
      return i + 1;
  }
  return size;
}

/* The first piece of a kind at or after `at`, with the comma behind it; length 0 where there is
 * none. */
static Piece
find_piece (const uint8_t *data, size_t size, size_t at, Kind kind)
{
  size_t i = at;
  if (kind == BRACKETS) {
    while (i < size && !is_in ("{[(<", data[i]))
      i++;
    if (i == size)
      return (Piece){ size, 0 };
    size_t end = close_bracket (data, size, i);
    return (Piece){ i, end + (end < size && data[end] == ',') - i };
  }
  if (kind == WORD) {
    static const char delimiters[] = " \t\r\n,:;=\"'{}[]()<>/";
    while (i < size && is_in (delimiters, data[i]))
      i++;
    size_t end = i;
    while (end < size && !is_in (delimiters, data[end]))
      end++;
    return (Piece){ i, end - i };
  }
  while (i > 0 && data[i - 1] != '\n')
    i--;
  size_t end = i;
  for (int lines = kind == LINE ? 1 : 2; lines > 0 && end < size; end++)
    lines -= data[end] == '\n';
  return (Piece){ i, end - i };
}

size_t
fuzz_splice_piece (uint8_t *data, size_t size, size_t most, const uint8_t *other,
                   size_t other_size, unsigned seed)
{
  Kind kind = (Kind) (seed % KIND_COUNT);
  unsigned what = seed / KIND_COUNT % 3; /* 0: replace, 1: insert, 2: remove */
  unsigned place = seed / (3 * KIND_COUNT);
  if (size == 0 || other_size == 0)
    return 0;
  Piece old = find_piece (data, size, place % size, kind);
  Piece new = find_piece (other, other_size, place / 7 % other_size, kind);
  if (old.length == 0 || new.length == 0)
    return 0;
  size_t inserted = what == 2 ? 0 : new.length;
  size_t removed = what == 1 ? 0 : old.length;
  size_t changed = size - removed + inserted;
  if (changed > most || changed == 0)
    return 0;
  uint8_t *piece = malloc (new.length); /* `other` may be `data` */
  if (piece == NULL)
    return 0;
  memcpy (piece, other + new.start, new.length);
  memmove (data + old.start + inserted, data + old.start + removed,
           size - old.start - removed);
  memcpy (data + old.start, piece, inserted);
  free (piece);
  return changed;
}
