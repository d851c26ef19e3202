/* From double to integer.
 *
 * In C the conversion of a double that the integer type cannot hold, of a NaN among them, is
 * undefined. The whole program converts here: no other place may cast a double to an integer
 * (held by tests/checks/test-conversions.c).
 */
#pragma once

#include <stdint.h>

/* The integer part of a number, between `least` and `most`: the nearer of the two where the
 * number lies outside of them, `least` where it is NaN. Round the number first where the nearest
 * integer is meant. */
static inline int64_t
qn_to_integer (double value, int64_t least, int64_t most)
{
  if (!(value > (double) least))
    return least;
  return value < (double) most ? (int64_t) value : most;
}

/* For qsort() and g_array_sort() of numbers of entities, ascending. */
static inline int
qn_compare_ids (const void *a, const void *b)
{
  int32_t x = *(const int32_t *) a, y = *(const int32_t *) b;

  return (x > y) - (x < y);
}
