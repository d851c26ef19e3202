#include "io/exchange/drawing.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <gio/gio.h>
#include <string.h>

static void
parse (const char *text, QnDrawing *drawing)
{
  g_autoptr (GError) error = NULL;
  if (!qn_drawing_read (qn_svg_import, text, strlen (text), "test.svg", drawing, &error))
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

/* What is filled is seen as a shape, closed or not. */
static void
test_filled (void)
{
  g_auto (QnDrawing) drawing;
  parse ("<svg><path d=\"M0 0H1V1H0\"/><polyline points=\"0 0 1 0 1 1\"/>"
         "<g fill=\"none\" stroke=\"black\"><path d=\"M0 0H1V1H0\"/></g></svg>",
         &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 3);
  g_assert_true (path_at (&drawing, 0)->closed);
  g_assert_true (path_at (&drawing, 1)->closed);
  g_assert_false (path_at (&drawing, 2)->closed);
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
  assert_point (curve->points[(curve->count - 1) / 2], 1, 0);
}

static void
test_bad_files (void)
{
  static const struct {
    const char *text, *start;
  } cases[] = { { "<svg>\n<path d=\"M 0 0 L 1\"/></svg>", "bad.svg:2: " },
                { "<svg>\n<path d=\"M 0 0 X 1\"/></svg>", "bad.svg:2: " },
                { "<svg>\n<polygon points=\"0,0 1,0 nan,1\"/></svg>",
                  "bad.svg:2: polygon: " },
                { "<svg>\n\n<g></svg>", "bad.svg:3: " },
                { "<html><svg/></html>", "bad.svg:1: not an SVG drawing" },
                { "", "bad.svg:1: " } };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnDrawing drawing;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_drawing_read (qn_svg_import, cases[i].text, strlen (cases[i].text),
                                     "bad.svg", &drawing, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_true (g_str_has_prefix (error->message, cases[i].start));
    g_assert_null (strchr (error->message, '\n'));
  }
}

/* An arc without an angle ends. */
static void
test_no_arc (void)
{
  g_auto (QnDrawing) drawing;
  qn_drawing_init (&drawing);
  QnDrawingPath *path = qn_drawing_add_path (&drawing, "0", 1);
  qn_drawing_path_add_ellipse (path, qn_vec2 (0, 0), qn_vec2 (1, 0), qn_vec2 (0, 1), 0,
                               NAN);
  qn_drawing_path_add_ellipse (path, qn_vec2 (0, 0), qn_vec2 (1, 0), qn_vec2 (0, 1), 0,
                               1e300);
  g_assert_cmpuint (path->count, ==, 4);
  qn_drawing_drop_unbounded (&drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 0);
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
    g_assert_cmpuint (drawing.paths->len + drawing.notes->len, ==, 1);
    g_assert_true (drawing.paths->len == 0 || path_at (&drawing, 0)->count >= 2);
    qn_drawing_drop_unbounded (&drawing);
    for (gsize k = 0; drawing.paths->len > 0 && k < path_at (&drawing, 0)->count; k++) {
      g_assert_cmpfloat (fabs (path_at (&drawing, 0)->points[k].x), <=, 1e15);
      g_assert_cmpfloat (fabs (path_at (&drawing, 0)->points[k].y), <=, 1e15);
    }
    g_assert_cmpuint (drawing.paths->len + drawing.notes->len, ==, 1);
  }
}

static char *
dup_notes (const QnDrawing *drawing)
{
  GString *text = g_string_new (NULL);
  for (guint i = 0; i < drawing->notes->len; i++) {
    const QnDrawingNote *note = drawing->notes->pdata[i];
    g_string_append_printf (text, "%s: %u; ", note->text, note->count);
  }
  return g_string_free (text, FALSE);
}

/* What programs write: entities of Illustrator, other encodings, gzip; never another file. */
static void
test_documents (void)
{
  static const char rest[] =
    "<svg xmlns:i=\"&i;\" width=\"10mm\" viewBox=\"0 0 10 10\">"
    "<g id=\"Öl\" style=\"&s;\"><rect width=\"2\" height=\"1\"/></g></svg>";
  static const char head[] =
    "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"svg11.dtd\" [\n"
    "<!ENTITY i \"http://example.org/\">\n<!ENTITY s \"fill:#000\">\n"
    "<!ENTITY x SYSTEM \"file:///etc/passwd\">\n]>";
  g_autofree char *plain = g_strconcat (head, rest, NULL);
  g_autofree char *marked = g_strconcat ("\xef\xbb\xbf", plain, NULL);
  g_autofree char *outside = g_strdup (plain);
  memcpy (strstr (outside, "&i;"), "&x;", 3);
  gsize wide_size, latin_size;
  g_autofree char *wide =
    g_convert (plain, -1, "UTF-16", "UTF-8", NULL, &wide_size, NULL);
  g_autofree char *declared =
    g_strconcat ("<?xml version='1.0' encoding='ISO-8859-1'?>", plain, NULL);
  g_autofree char *latin =
    g_convert (declared, -1, "ISO-8859-1", "UTF-8", NULL, &latin_size, NULL);
  const struct {
    const char *bytes;
    gsize size;
  } cases[] = { { plain, strlen (plain) },
                { marked, strlen (marked) },
                { wide, wide_size },
                { latin, latin_size } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    for (int packed = 0; packed < 2; packed++) {
      g_auto (QnDrawing) drawing;
      g_autoptr (GError) error = NULL;
      g_autoptr (GZlibCompressor) gzip =
        g_zlib_compressor_new (G_ZLIB_COMPRESSOR_FORMAT_GZIP, 6);
      char buffer[4096];
      gsize read, written;
      g_converter_convert (G_CONVERTER (gzip), cases[i].bytes, cases[i].size, buffer,
                           sizeof buffer, G_CONVERTER_INPUT_AT_END, &read, &written,
                           &error);
      g_assert_no_error (error);
      qn_drawing_read (qn_svg_import, packed ? buffer : cases[i].bytes,
                       packed ? written : cases[i].size, "test.svg", &drawing, &error);
      g_assert_no_error (error);
      g_assert_cmpuint (drawing.paths->len, ==, 1);
      g_assert_cmpstr (path_at (&drawing, 0)->layer, ==, "Öl");
    }
  QnDrawing drawing;
  g_assert_false (qn_drawing_read (qn_svg_import, outside, strlen (outside), "test.svg",
                                   &drawing, NULL));
  g_assert_false (qn_drawing_read (qn_svg_import, "\x1f\x8b\x08garbage", 10, "test.svg",
                                   &drawing, NULL));
}

/* By attribute, property, class, element and id; visible shapes in what is invisible; what is painted
 * neither inside nor along its edge. */
static void
test_hidden (void)
{
  static const struct {
    const char *shape;
    gboolean hidden;
  } cases[] = {
    { "<rect/>", FALSE },
    { "<rect display=\"none\"/>", TRUE },
    { "<rect style=\"fill:#fff; display : none\"/>", TRUE },
    { "<rect visibility=\"hidden\"/>", TRUE },
    { "<g visibility=\"hidden\"><rect style=\"visibility:visible\"/></g>", FALSE },
    { "<g display=\"none\"><rect style=\"display:inline\"/></g>", TRUE },
    { "<g class=\"x off\"><rect/></g>", TRUE },
    { "<rect id=\"gone\" class=\"on\"/>", TRUE },
    { "<rect class=\"off\" style=\"display:inline\"/>", FALSE },
    { "<ellipse/>", TRUE },
    { "<ellipse class=\"on\"/>", FALSE },
    { "<rect fill=\"none\"/>", TRUE },
    { "<g stroke=\"#000\"><rect fill=\"none\"/></g>", FALSE },
    { "<line x2=\"1\"/>", FALSE },
    { "<g opacity=\"0\"><rect opacity=\"1\"/></g>", TRUE },
    { "<rect style=\"Opacity:0%\"/>", TRUE },
    { "<rect opacity=\".5\"/>", FALSE },
    { "<rect fill=\"transparent\"/>", TRUE },
    { "<rect fill-opacity=\"0\"/>", TRUE },
    { "<rect fill-opacity=\"0\" stroke=\"#000\"/>", FALSE },
    { "<rect style=\"DISPLAY:NONE\"/>", TRUE },
    { "<a><switch><rect/></switch></a>", FALSE },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = g_strdup_printf (
      "<svg><style>/* a { } */ .off, #gone {display:none !important} "
      ".on{display:inline}\n"
      "ellipse{visibility:hidden}ellipse.on{visibility:visible}</style>%s</svg>",
      cases[i].shape);
    g_auto (QnDrawing) drawing;
    g_test_message ("%s", cases[i].shape);
    parse (text, &drawing);
    g_assert_cmpuint (drawing.paths->len, ==, 1);
    g_assert_cmpint (path_at (&drawing, 0)->hidden, ==, cases[i].hidden);
  }
}

/* Lengths with units, percentages, view ports in each other, aspect ratios, transformations of style
 * sheets, elements that are used: where the first corner lies and how large the shape is, in user units
 * of the drawing. */
static void
test_places (void)
{
  static const struct {
    const char *svg;
    double unit, x, y, width;
  } cases[] = {
    { "width=\"96\" height=\"96\"><rect x=\"2.54cm\" y=\"1in\" width=\"72pt\" "
      "height=\"6pc\"/>",
      0.0254 / 96, 96, 96, 96 },
    { "width=\"8000Q\" height=\"8000Q\" viewBox=\"0 0 100 100\"><rect x=\"1\" "
      "width=\"3\" "
      "height=\"1\"/>",
      0.02, 1, 0, 3 },
    { "width=\"80mm\"><rect x=\"10mm\" y=\"0\" width=\"50%\" height=\"1\"/>", 0.0254 / 96,
      10 * 96 / 25.4, 0, 40 * 96 / 25.4 },
    { "width=\"2m\" height=\"1m\" viewBox=\"0 0 100 100\"><rect x=\"10%\" width=\"3\" "
      "height=\"1\"/>",
      0.01, 10, 0, 3 },
    { "width=\"2m\" height=\"1m\" viewBox=\"0 0 100 100\" preserveAspectRatio=\"none\">"
      "<rect x=\"1\" y=\"8\" width=\"3\" height=\"1\"/>",
      0.02, 1, 4, 3 },
    { "width=\"2m\" height=\"1m\" viewBox=\"0 0 100 100\" preserveAspectRatio=\"xMidYMid "
      "slice\">"
      "<rect x=\"1\" width=\"3\" height=\"1\"/>",
      0.02, 1, 0, 3 },
    { "><svg x=\"10\" y=\"20\" width=\"40\" height=\"20\" viewBox=\"0 0 10 10\">"
      "<rect width=\"5\" height=\"5\"/></svg>",
      0, 20, 20, 10 },
    { "><svg x=\"10\" y=\"20\" width=\"40\" height=\"20\" viewBox=\"0 0 10 10\" "
      "preserveAspectRatio=\"xMinYMin slice\"><rect width=\"50%\" height=\"5\"/></svg>",
      0, 10, 20, 20 },
    { "><g style=\"transform: translate(3px, 4px) scale(2)\"><rect x=\"1\" width=\"5\" "
      "height=\"5\"/></g>",
      0, 5, 4, 10 },
    { "><g style=\"transform:rotate(0.25turn)\"><rect x=\"1\" y=\"2\" width=\"5\" "
      "height=\"7\"/></g>",
      0, -2, 1, -7 },
    { "><defs><g id=\"a\"><rect x=\"1\" width=\"5\" height=\"5\"/></g></defs>"
      "<use href=\"#a\" x=\"3\" y=\"4\" transform=\"scale(2)\"/>",
      0, 8, 8, 10 },
    { "><symbol id=\"a\" viewBox=\"0 0 2 2\"><rect width=\"1\" height=\"2\"/></symbol>"
      "<use xlink:href=\"#a\" x=\"3\" width=\"8\" height=\"8\"/>",
      0, 3, 0, 4 },
    { "><style>rect{x:3px;width:4px;transform-origin:1px 2px;rotate:180deg}</style>"
      "<rect width=\"9\" height=\"5\"/>",
      0, -1, 4, -4 },
    { "width=\"10\" height=\"20\"><rect width=\"4\" height=\"5\" "
      "transform=\"scale(2)\" transform-origin=\"0 bottom\"/>",
      0, 0, -20, 8 },
    { "><rect width=\"4\" height=\"5\" style=\"translate:1px 2px;scale:3;"
      "transform:translate(1px,0)\"/>",
      0, 4, 2, 12 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" "
      "style=\"transform:translateX(3px)\"/>",
      0, 4, 2, 4 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" "
      "style=\"transform:translateY(3px)\"/>",
      0, 1, 5, 4 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" style=\"transform:scaleX(2)\"/>",
      0, 2, 2, 8 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" style=\"transform:scaleY(2)\"/>",
      0, 1, 4, 4 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"scale(2, 3)\"/>", 0, 2,
      6, 8 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"skewX(45)\"/>", 0, 3,
      2, 9 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"skewY(45)\"/>", 0, 1,
      3, 4 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"matrix(1 2 3 4 5 "
      "6)\"/>",
      0, 12, 16, 19 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"rotate(90 1 2)\"/>", 0,
      1, 2, -5 },
    { "><rect x=\"1\" y=\"2\" width=\"4\" height=\"5\" transform=\"none\"/>", 0, 1, 2,
      4 },
    { "width=\"10\" height=\"20\"><rect width=\"4\" height=\"5\" transform=\"scale(2)\" "
      "transform-origin=\"right\"/>",
      0, -10, -10, 8 },
    { "width=\"10\" height=\"20\"><rect width=\"4\" height=\"5\" transform=\"scale(2)\" "
      "transform-origin=\"center top\"/>",
      0, -5, 0, 8 },
    { "width=\"10\" height=\"20\"><rect width=\"4\" height=\"5\" transform=\"scale(2)\" "
      "transform-origin=\"left 50%\"/>",
      0, 0, -10, 8 },
    { "><svg x=\"10\" y=\"20\" width=\"40\" height=\"20\" viewBox=\"0 0 10 10\" "
      "preserveAspectRatio=\"xMaxYMax\"><rect width=\"5\" height=\"5\"/></svg>",
      0, 30, 20, 10 },
    { "><svg x=\"10\" y=\"20\" width=\"20\" height=\"40\" viewBox=\"0 0 10 10\" "
      "preserveAspectRatio=\"xMidYMax\"><rect width=\"5\" height=\"5\"/></svg>",
      0, 10, 40, 10 },
    { "><svg x=\"10\" y=\"20\" width=\"20\" height=\"40\" viewBox=\"0 0 10 10\" "
      "preserveAspectRatio=\"xMidYMin\"><rect width=\"5\" height=\"5\"/></svg>",
      0, 10, 20, 10 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = g_strdup_printf ("<svg %s</svg>", cases[i].svg);
    g_auto (QnDrawing) drawing;
    g_test_message ("%s", cases[i].svg);
    parse (text, &drawing);
    g_assert_cmpuint (drawing.paths->len, ==, 1);
    g_assert_cmpfloat_with_epsilon (drawing.unit, cases[i].unit, 1e-15);
    const QnVec2 *p = path_at (&drawing, 0)->points;
    assert_point (p[0], cases[i].x, -cases[i].y);
    QnVec2 side = qn_vec2_sub (p[2], p[0]);
    g_assert_cmpfloat_with_epsilon (side.x, cases[i].width, 1e-11);
  }
}

/* A hole at the edge is cut out, one within is told; what lies in it is a block; a part that is covered is
 * none. */
static void
test_holes (void)
{
#define SQUARE "<svg><path %s d=\"M0 0H10V10H0z %s\"/></svg>"
  static const struct {
    const char *rule, *more;
    guint count, corners, notes;
  } cases[] = {
    { "", "M3 0v3h3v-3z", 1, 8, 0 },                            /* turns the other way */
    { "", "M3 0h3v3h-3z", 1, 4, 1 },                            /* covered */
    { "fill-rule=\"evenodd\"", "M3 0h3v3h-3z", 1, 8, 0 },       /* a notch */
    { "style=\"fill-rule:evenodd\"", "M3 3h3v3h-3z", 1, 4, 1 }, /* within */
    { "fill-rule=\"evenodd\"", "M3 3h3v3h-3z M4 4h1v1h-1z", 2, 4, 1 }, /* a block in it */
    { "fill-rule=\"evenodd\"", "M20 0h3v3h-3z", 2, 4, 0 },             /* beside */
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = g_strdup_printf (SQUARE, cases[i].rule, cases[i].more);
    g_auto (QnDrawing) drawing;
    parse (text, &drawing);
    qn_drawing_drop_unbounded (&drawing);
    g_assert_cmpuint (drawing.paths->len, ==, cases[i].count);
    g_assert_cmpuint (path_at (&drawing, 0)->count, ==, cases[i].corners);
    g_assert_cmpuint (drawing.notes->len, ==, cases[i].notes);
  }
}

/* Elements that use themselves, or each other by the million, end, and are told. */
static void
test_endless_uses (void)
{
  g_auto (QnDrawing) drawing;
  parse ("<svg><g id=\"a\"><rect width=\"1\" height=\"1\"/><use href=\"#a\"/></g><use "
         "href=\"#b\"/></svg>",
         &drawing);
  g_autofree char *notes = dup_notes (&drawing);
  g_assert_nonnull (strstr (notes, "uses nested too deeply left out: 1; "));
  g_assert_nonnull (strstr (notes, "uses of unknown elements left out: 1; "));
  g_autoptr (GString) text = g_string_new ("<svg><defs><g id=\"l0\"><rect/></g>");
  for (int i = 1; i < 20; i++) {
    g_string_append_printf (text, "<g id=\"l%d\">", i);
    for (int k = 0; k < 10; k++)
      g_string_append_printf (text, "<use href=\"#l%d\"/>", i - 1);
    g_string_append (text, "</g>");
  }
  g_string_append (text, "</defs><use href=\"#l19\"/></svg>");
  QnDrawing many;
  g_assert_false (
    qn_drawing_read (qn_svg_import, text->str, text->len, "test.svg", &many, NULL));
}

/* What is not followed is told. */
static void
test_told (void)
{
  g_auto (QnDrawing) drawing;
  parse ("<svg><style>@font-face{src:x} g > rect{display:none} [a]{fill:none}</style>"
         "<rect width='1' height='1' style='transform-box:fill-box;rotate:9deg'/></svg>",
         &drawing);
  g_assert_cmpuint (drawing.notes->len, ==, 2);
  const QnDrawingNote *rules = drawing.notes->pdata[0], *box = drawing.notes->pdata[1];
  g_assert_nonnull (strstr (rules->text, "that are not followed"));
  g_assert_cmpuint (rules->count, ==, 2);
  g_assert_nonnull (strstr (box->text, "about a box of their own left out"));
  g_assert_true (path_at (&drawing, 0)->hidden);
}

/* Transformations that cannot be read leave a shape where it is. */
static void
test_no_transformations (void)
{
  g_auto (QnDrawing) drawing;
  parse ("<svg><rect width='1' height='1' transform='rotate(50%) translate() wobble(3)'/>"
         "<rect width='1' height='1' style='transform:translateX(1,2) matrix(1,2);"
         "clip-path:url(#c)'/></svg>",
         &drawing);
  g_autofree char *notes = dup_notes (&drawing);
  g_assert_nonnull (strstr (notes, "transformations that cannot be read: 5; "));
  g_assert_nonnull (strstr (notes, "shapes that are clipped taken whole: 1; "));
  for (guint i = 0; i < 2; i++)
    assert_point (path_at (&drawing, i)->points[0], 0, 0);
}

/* Shapes of negative size are not drawn; a length that is no number counts as not given. Both are told with
 * their place. */
static void
test_lengths (void)
{
  static const struct {
    const char *shape, *note;
    guint count;
  } cases[] = {
    { "<rect width='-1' height='2'/>", "shapes of negative size left out", 0 },
    { "<rect width='1' height='-2mm'/>", "shapes of negative size left out", 0 },
    { "<circle r='-1'/>", "shapes of negative size left out", 0 },
    { "<ellipse rx='1' ry='-1'/>", "shapes of negative size left out", 0 },
    { "<rect x='nan' width='1' height='2'/>",
      "lengths that are no numbers, taken as not given", 1 },
    { "<rect width='1' height='2' rx='auto'/>", NULL, 1 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = g_strdup_printf ("<svg>\n%s</svg>", cases[i].shape);
    g_auto (QnDrawing) drawing;
    parse (text, &drawing);
    g_assert_cmpuint (drawing.paths->len, ==, cases[i].count);
    g_assert_cmpuint (drawing.notes->len, ==, cases[i].note != NULL);
    if (cases[i].note == NULL)
      continue;
    const QnDrawingNote *note = drawing.notes->pdata[0];
    g_assert_cmpstr (note->text, ==, cases[i].note);
    g_assert_cmpuint (note->line, ==, 2);
  }
}

/* Of a switch the first child that applies is read, and nothing else. */
static void
test_switches (void)
{
#define RECT(attributes, width) "<rect " attributes " width='" width "' height='1'/>"
#define SVG11                   "requiredFeatures='http://www.w3.org/TR/SVG11/feature#"
  static const struct {
    const char *children;
    double width; /* of the one that is read; 0: none, which is told */
  } cases[] = {
    { RECT ("", "1") RECT ("", "2"), 1 },
    { RECT ("requiredExtensions='http://ns.adobe.com/AdobeIllustrator/10.0/'", "1")
        RECT ("", "2") RECT ("", "3"),
      2 },
    { RECT (SVG11 "Extensibility'", "1") RECT (SVG11 "Shape'", "2") RECT ("", "3"), 2 },
    { RECT ("requiredFeatures='urn:x'", "1") RECT ("", "2"), 2 },
    { RECT ("systemLanguage='fr, en'", "1") RECT ("systemLanguage='it, de-AT'", "2")
        RECT ("", "3"),
      2 },
    { RECT ("systemLanguage='d'", "1") RECT ("systemLanguage='DE'", "2"), 2 },
    { RECT ("systemLanguage=''", "1") RECT ("systemLanguage='deu'", "2"), 0 },
    { "<title>x</title>\n<defs/><foreignObject/>" RECT ("", "1") RECT ("", "2"), 1 },
    { "<switch>" RECT ("systemLanguage='de'", "1")
        RECT ("", "2") "</switch>" RECT ("", "3"),
      1 },
  };
  g_setenv ("LANGUAGE", "de_CH:de", TRUE);
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text =
      g_strdup_printf ("<svg><switch>%s</switch></svg>", cases[i].children);
    g_auto (QnDrawing) drawing;
    parse (text, &drawing);
    gboolean read = cases[i].width > 0;
    g_assert_cmpuint (drawing.paths->len, ==, read);
    g_assert_cmpuint (drawing.notes->len, ==, !read);
    if (read)
      assert_point (path_at (&drawing, 0)->points[1], cases[i].width, 0);
    else
      g_assert_cmpstr (((QnDrawingNote *) drawing.notes->pdata[0])->text, ==,
                       "switch elements left out");
  }
  g_unsetenv ("LANGUAGE");
#undef RECT
#undef SVG11
}

QN_TESTS
{
  g_test_add_func ("/svg-import/switches", test_switches);
  g_test_add_func ("/svg-import/told", test_told);
  g_test_add_func ("/svg-import/no-transformations", test_no_transformations);
  g_test_add_func ("/svg-import/lengths", test_lengths);
  g_test_add_func ("/svg-import/shapes", test_shapes);
  g_test_add_func ("/svg-import/filled", test_filled);
  g_test_add_func ("/svg-import/path-commands", test_path_commands);
  g_test_add_func ("/svg-import/extreme-numbers", test_extreme_numbers);
  g_test_add_func ("/svg-import/documents", test_documents);
  g_test_add_func ("/svg-import/hidden", test_hidden);
  g_test_add_func ("/svg-import/places", test_places);
  g_test_add_func ("/svg-import/holes", test_holes);
  g_test_add_func ("/svg-import/endless-uses", test_endless_uses);
  g_test_add_func ("/svg-import/no-arc", test_no_arc);
  g_test_add_func ("/svg-import/bad-files", test_bad_files);
}
