#include "io/text/nearest-word.h"

#include <string.h>

/* No key is as long; longer words are near none. */
#define MOST 64

static gsize
count_slips (const char *a, gsize a_length, const char *b, gsize b_length)
{
  gsize slips[MOST + 1][MOST + 1];
  for (gsize i = 0; i <= a_length; i++)
    for (gsize j = 0; j <= b_length; j++) {
      if (i == 0 || j == 0) {
        slips[i][j] = i + j;
        continue;
      }
      slips[i][j] = MIN (slips[i - 1][j - 1] + (a[i - 1] != b[j - 1]),
                         MIN (slips[i - 1][j], slips[i][j - 1]) + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        slips[i][j] = MIN (slips[i][j], slips[i - 2][j - 2] + 1);
    }
  return slips[a_length][b_length];
}

const char *
qn_nearest_word (const char *word, const char *const *words, gsize count)
{
  const char *nearest = NULL;
  gsize least = MOST, length = strlen (word);
  for (gsize i = 0; i < count && length <= MOST; i++) {
    gsize other = strlen (words[i]);
    gsize slips = other <= MOST ? count_slips (word, length, words[i], other) : MOST;
    gsize longer = MAX (length, other);
    if (slips < least && slips < longer && (slips == 1 || 3 * slips <= longer)) {
      least = slips;
      nearest = words[i];
    }
  }
  return nearest;
}
