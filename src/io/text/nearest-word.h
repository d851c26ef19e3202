/* The word that was probably meant. */
#pragma once

#include <glib.h>

/* The one of `words` that the fewest slips of typing make of `word`: a letter too many, missing, wrong,
 * or two exchanged, each of them one (optimal string alignment, F. J. Damerau, Communications of the
 * ACM 7 (1964) 171-176; bytes, not characters). NULL where two slips or more would be more than a
 * third of the longer of the two. */
const char *qn_nearest_word (const char *word, const char *const *words, gsize count);
