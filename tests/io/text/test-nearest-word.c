#include "io/json/json-value.h"
#include "support/room.h"

/* One slip of each kind, the nearer of two, and words that are near none. */
static void
test_nearest (void)
{
  static const char *const words[] = { "friction", "tension", "cohesion", "kn", "ks" };
  static const char *const rows[][2] = {
    { "frictoin", "friction" },
    { "fricton", "friction" },
    { "ffriction", "friction" },
    { "frictiom", "friction" },
    { "tensoin", "tension" },
    { "Cohesion", "cohesion" },
    { "kN", "kn" },
    { "friction", "friction" },
    { "colour", NULL },
    { "", NULL },
    { "phi", NULL },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++)
    g_assert_cmpstr (qn_nearest_word (rows[i][0], words, G_N_ELEMENTS (words)), ==,
                     rows[i][1]);
  g_assert_null (qn_nearest_word ("kn", words, 0));
  g_autofree char *long_word = g_strnfill (5000, 'k');
  g_assert_null (qn_nearest_word (long_word, words, G_N_ELEMENTS (words)));
}

QN_TESTS
{
  g_test_add_func ("/io/nearest-word/nearest", test_nearest);
}
