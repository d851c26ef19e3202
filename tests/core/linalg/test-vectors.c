#include "core/linalg/vectors.h"
#include "support/room.h"

#include <glib.h>

/* Every processor takes the widest loops that it can, and no wider ones than it is asked to. */
static void
test_processor (void)
{
  int avx2 = 0;

#ifdef __x86_64__
  avx2 = __builtin_cpu_supports ("avx2") ? 1 : 0;
#endif
  g_assert_cmpint (qn_vectors (2), ==, 0);
  g_assert_cmpint (qn_vectors (4), ==, avx2);
  g_assert_cmpint (qn_vectors (8), ==, avx2);
}

QN_TESTS
{
  g_test_add_func ("/vectors/processor", test_processor);
}
