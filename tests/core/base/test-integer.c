#include "core/base/integer.h"
#include "support/room.h"

#include <float.h>
#include <glib.h>
#include <math.h>

static void
test_bounds (void)
{
  static const struct {
    double value;
    int64_t least, most, expected;
  } cases[] = {
    { 2.9, 0, 10, 2 },
    { -2.9, -10, 10, -2 },
    { -0.5, 0, 10, 0 },
    { 10, 0, 10, 10 },
    { 11, 0, 10, 10 },
    { -1, 0, 10, 0 },
    { NAN, 1, 10, 1 },
    { INFINITY, 0, 255, 255 },
    { -INFINITY, -128, 127, -128 },
    { DBL_MAX, 0, INT32_MAX, INT32_MAX },
    { -DBL_MAX, INT32_MIN, INT32_MAX, INT32_MIN },
    { DBL_TRUE_MIN, 0, 10, 0 },
    { 2147483647.5, INT32_MIN, INT32_MAX, INT32_MAX },
    { 0x1p53 + 2, 0, INT64_MAX, (INT64_C (1) << 53) + 2 },
    /* INT64_MAX is no double: the next one above it is 2^63, which does not fit. */
    { 0x1p63, 0, INT64_MAX, INT64_MAX },
    { 0x1.fffffffffffffp62, 0, INT64_MAX, INT64_MAX - 1023 },
    { -0x1p63, INT64_MIN, INT64_MAX, INT64_MIN },
    { -0x1p64, INT64_MIN, INT64_MAX, INT64_MIN },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++)
    g_assert_cmpint (qn_to_integer (cases[i].value, cases[i].least, cases[i].most), ==,
                     cases[i].expected);
}

QN_TESTS
{
  g_test_add_func ("/integer/bounds", test_bounds);
}
