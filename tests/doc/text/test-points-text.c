#include "doc/view/pair-text.h"

#include "core/law/law.h"
#include "support/locale.h"
#include "support/room.h"

static void
test_parse (void)
{
  QnVec2 points[QN_MAX_CURVE_POINTS];
  int32_t count = 0;
  g_assert_true (qn_points_parse (" -0,002  -2e6;0.001 \t1,5e5; ;", points,
                                  QN_MAX_CURVE_POINTS, &count));
  g_assert_cmpint (count, ==, 2);
  g_assert_cmpfloat (points[0].x, ==, -0.002);
  g_assert_cmpfloat (points[0].y, ==, -2e6);
  g_assert_cmpfloat (points[1].x, ==, 0.001);
  g_assert_cmpfloat (points[1].y, ==, 1.5e5);
  g_autofree char *text = qn_points_dup_text (points, count);
  g_autofree char *expected = test_with_decimal_sign ("-0.002 -2000000; 0.001 150000");
  g_assert_cmpstr (text, ==, expected);
}

static void
test_refused (void)
{
  static const char *const wrong[] = { "",        " ; ",      "1",       "1 2 3",
                                       "1 2; 3",  "1 x",      "1 inf",   "1 2, 3 4",
                                       "1 2 m; ", "0.1.1 2;", "1e999 1;" };
  QnVec2 points[QN_MAX_CURVE_POINTS];
  int32_t count = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++)
    g_assert_false (qn_points_parse (wrong[i], points, QN_MAX_CURVE_POINTS, &count));

  g_autoptr (GString) text = g_string_new (NULL);
  for (int i = 0; i < QN_MAX_CURVE_POINTS; i++)
    g_string_append_printf (text, "%d %d;", i, i);
  g_assert_true (qn_points_parse (text->str, points, QN_MAX_CURVE_POINTS, &count));
  g_assert_cmpint (count, ==, QN_MAX_CURVE_POINTS);
  g_string_append (text, "100 100");
  g_assert_false (qn_points_parse (text->str, points, QN_MAX_CURVE_POINTS, &count));
}

QN_TESTS
{
  g_test_add_func ("/points-text/parse", test_parse);
  g_test_add_func ("/points-text/refused", test_refused);
}
