#include "io/exchange/svg-import.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

static void
parse (const char *text, QnDrawing *drawing)
{
  g_autoptr (GError) error = NULL;
  if (!qn_svg_import (text, strlen (text), "test.svg", drawing, &error))
    g_error ("%s", error->message);
}

static const QnDrawingPath *
path_at (const QnDrawing *drawing, guint index)
{
  g_assert_cmpuint (index, <, drawing->paths->len);
  return &g_array_index (drawing->paths, QnDrawingPath, index);
}

static void
assert_point (QnVec2 p, double x, double y)
{
  g_assert_cmpfloat_with_epsilon (p.x, x, 1e-12);
  g_assert_cmpfloat_with_epsilon (p.y, y, 1e-12);
}

static void
test_shapes (void)
{
  g_auto (QnDrawing) drawing;
  parse (
    "<svg width=\"200mm\" viewBox=\"0 0 100 50\"><g id=\"BLOCKS\" "
    "transform=\"translate(10,20)\"><rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>"
    "<polygon points=\"0,0 1,0 1,1\"/><polyline points=\"0 0 1 0\" "
    "transform=\"rotate(90) scale(2)\"/></g><defs><rect width=\"9\" height=\"9\"/></defs>"
    "<circle cx=\"0\" cy=\"0\" r=\"1\"/><text>x</text></svg>",
    &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 4);
  g_assert_cmpfloat_with_epsilon (drawing.unit, 0.002, 1e-15);
  g_assert_cmpstr (path_at (&drawing, 0)->layer, ==, "BLOCKS");
  assert_point (path_at (&drawing, 0)->points[0], 11, -22);
  assert_point (path_at (&drawing, 0)->points[2], 14, -26);
  g_assert_true (path_at (&drawing, 1)->closed);
  g_assert_false (path_at (&drawing, 2)->closed);
  assert_point (path_at (&drawing, 2)->points[1], 10, -22);
  g_assert_true (path_at (&drawing, 3)->closed);
  g_assert_cmpuint (drawing.notes->len, ==, 1);
}

static void
test_path_commands (void)
{
  g_auto (QnDrawing) drawing;
  parse ("<svg><path d=\"m1,1 2,0 v2h-2z M10 10 L11 10 11,11Z\"/>"
         "<path d=\"M0 0A1 1 0 0 1 2 0\"/><path d=\"M0 0C0 1 1 1 1 0S2-1 2 0\"/></svg>",
         &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 4);
  const QnDrawingPath *square = path_at (&drawing, 0);
  g_assert_cmpuint (square->count, ==, 4);
  g_assert_true (square->closed);
  assert_point (square->points[1], 3, -1);
  assert_point (square->points[3], 1, -3);
  assert_point (path_at (&drawing, 1)->points[2], 11, -11);
  const QnDrawingPath *arc = path_at (&drawing, 2);
  for (gsize i = 0; i < arc->count; i++)
    g_assert_cmpfloat_with_epsilon (hypot (arc->points[i].x - 1, arc->points[i].y), 1,
                                    1e-12);
  g_assert_cmpfloat (arc->points[arc->count / 2].y, >, 0.9);
  const QnDrawingPath *curve = path_at (&drawing, 3);
  assert_point (curve->points[curve->count - 1], 2, 0);
  assert_point (curve->points[12], 1, 0);
}

static void
test_bad_files (void)
{
  static const struct {
    const char *text, *start;
  } cases[] = { { "<svg>\n<path d=\"M 0 0 L 1\"/></svg>", "bad.svg:2: " },
                { "<svg>\n<path d=\"M 0 0 X 1\"/></svg>", "bad.svg:2: " },
                { "<svg>\n\n<g></svg>", "bad.svg:3: " },
                { "", "bad.svg:1: " } };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnDrawing drawing;
    g_autoptr (GError) error = NULL;
    g_assert_false (
      qn_svg_import (cases[i].text, strlen (cases[i].text), "bad.svg", &drawing, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_true (g_str_has_prefix (error->message, cases[i].start));
    g_assert_null (strchr (error->message, '\n'));
  }
}

/* Numbers that arithmetic cannot carry, one at a time in every place where a shape has one. */
static void
test_extreme_numbers (void)
{
  static const char *const shapes[] = {
    "<path d=\"M0 0 A %s %s %s 0 1 %s %s z\"/>",
    "<path d=\"M%s %s C %s %s 1 1 %s 0 z\"/>",
    "<rect x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\" transform=\"scale(%s)\"/>",
    "<ellipse cx=\"%s\" cy=\"%s\" rx=\"%s\" ry=\"%s\" transform=\"rotate(%s)\"/>",
    "<polygon points=\"0,0 %s,%s 1,%s 2,2\" transform=\"translate(%s,%s)\"/>",
  };
  static const char *const extremes[] = { "1e155",  "-1e155", "1e308", "-1.7e308",
                                          "1e-160", "5e-324", "0",     "1e15" };
  for (guint i = 0; i < G_N_ELEMENTS (shapes) * G_N_ELEMENTS (extremes) * 5; i++) {
    const char *numbers[] = { "1", "1", "3", "4", "5" };
    numbers[i % 5] = extremes[i / 5 % G_N_ELEMENTS (extremes)];
    g_auto (GStrv) parts = g_strsplit (shapes[i / 5 / G_N_ELEMENTS (extremes)], "%s", -1);
    g_autoptr (GString) text = g_string_new ("<svg>");
    for (guint k = 0; parts[k] != NULL; k++)
      g_string_append_printf (text, "%s%s", parts[k], k < 5 ? numbers[k] : "");
    g_string_append (text, "</svg>");
    g_auto (QnDrawing) drawing;
    parse (text->str, &drawing);
    g_assert_cmpuint (drawing.paths->len, ==, 1);
    g_assert_cmpuint (path_at (&drawing, 0)->count, >=, 2);
    qn_drawing_drop_unbounded (&drawing);
    for (gsize k = 0; drawing.paths->len > 0 && k < path_at (&drawing, 0)->count; k++) {
      g_assert_cmpfloat (fabs (path_at (&drawing, 0)->points[k].x), <=, 1e15);
      g_assert_cmpfloat (fabs (path_at (&drawing, 0)->points[k].y), <=, 1e15);
    }
    g_assert_cmpuint (drawing.paths->len + drawing.notes->len, ==, 1);
  }
}

QN_TESTS
{
  g_test_add_func ("/svg-import/shapes", test_shapes);
  g_test_add_func ("/svg-import/path-commands", test_path_commands);
  g_test_add_func ("/svg-import/extreme-numbers", test_extreme_numbers);
  g_test_add_func ("/svg-import/bad-files", test_bad_files);
}
