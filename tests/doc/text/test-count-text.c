#include "doc/text/explain.h"
#include "support/room.h"

static void
test_plurals (void)
{
  static const char *const words[][2] = {
    { "1 block", "2 blocks" },
    { "1 beam", "2 beams" },
    { "1 contact face", "2 contact faces" },
    { "1 contact pair", "2 contact pairs" },
    { "1 finding", "2 findings" },
    { "1 step", "2 steps" },
    { "1 iteration", "2 iterations" },
    { "1 factorisation", "2 factorisations" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++)
    for (gsize n = 1; n <= 2; n++) {
      const QnCount count = { (QnCounted) i, n };
      g_autofree char *text = qn_counts_dup_text (&count, 1, ", ");
      g_assert_cmpstr (text, ==, words[i][n - 1]);
    }
}

static void
test_several (void)
{
  const QnCount counts[] = { { QN_COUNTED_BLOCKS, 0 },
                             { QN_COUNTED_FACES, 1 },
                             { QN_COUNTED_FINDINGS, 12000 } };
  g_autofree char *text = qn_counts_dup_text (counts, G_N_ELEMENTS (counts), " · ");
  g_assert_cmpstr (text, ==, "0 blocks · 1 contact face · 12000 findings");
  g_autofree char *none = qn_counts_dup_text (counts, 0, " · ");
  g_assert_cmpstr (none, ==, "");
}

QN_TESTS
{
  g_test_add_func ("/doc/count-text/plurals", test_plurals);
  g_test_add_func ("/doc/count-text/several", test_several);
}
