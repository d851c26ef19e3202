/* Names of enumerations in files and options. */
#pragma once

#include <stdbool.h>
#include <string.h>

/* Whether a word, which may be NULL, is among names, some of which may be NULL. Its place, an enumeration
 * or int, is left as it is where not. */
static inline bool
qn_find_word (const char *word, const char *const *names, int count, void *place)
{
  for (int i = 0; word != NULL && i < count; i++)
    if (names[i] != NULL && strcmp (word, names[i]) == 0) {
      *(int *) place = i;
      return true;
    }
  return false;
}
