/* Places of a project file in words. */
#include "doc/text/explain.h"

#include "support/room.h"

static void
test_text (void)
{
  QnLaw law = { .name = (char *) "dry_joint" };
  const QnModel model = { .laws = &law, .law_count = 1 };
  static const char *const cases[][2] = {
    { "laws[0].friction", "Law “dry_joint”: friction" },
    { "laws[7].friction", "Law 8: friction" },
    { "walls[0].unit_weight", "Wall 1: unit weight" },
    { "loads.live[1].value[0]", "Growing load 2: value[0]" },
    { "loads.live[0]", "Growing load 1" },
    { "analysis.residual_tolerance", "analysis.residual tolerance" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = qn_path_dup_text (&model, cases[i][0]);
    g_assert_cmpstr (text, ==, cases[i][1]);
  }
}

static void
test_reason (void)
{
  g_autofree char *reason =
    qn_path_dup_reason ("m.quoin: laws[0].friction: number must not be negative (set by "
                        "\"laws[0].friction=-0.42\")",
                        "laws[0].friction");
  g_assert_cmpstr (reason, ==, "number must not be negative");
  g_autofree char *other = qn_path_dup_reason ("dead load is unstable", "gravity");
  g_assert_cmpstr (other, ==, "dead load is unstable");
}

QN_TESTS
{
  g_test_add_func ("/path-text/text", test_text);
  g_test_add_func ("/path-text/reason", test_reason);
}
