#include "io/exchange/drawing.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

#define HEAD "0\nSECTION\n2\nENTITIES\n"
#define TAIL "0\nENDSEC\n0\nEOF\n"

static void
parse (const char *text, QnDrawing *drawing)
{
  g_autoptr (GError) error = NULL;
  if (!qn_drawing_read (qn_dxf_import, text, strlen (text), "test.dxf", drawing, &error))
    g_error ("%s", error->message);
  qn_drawing_drop_unbounded (drawing);
}

/* The reason has a word. */
static void
expect_refused (const char *text, const char *word)
{
  QnDrawing drawing;
  g_autoptr (GError) error = NULL;
  g_assert_false (
    qn_drawing_read (qn_dxf_import, text, strlen (text), "test.dxf", &drawing, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_nonnull (strstr (error->message, word));
}

static const QnDrawingPath *
path_at (const QnDrawing *drawing, guint index)
{
  g_assert_cmpuint (index, <, drawing->paths->len);
  return &g_array_index (drawing->paths, QnDrawingPath, index);
}

static void
test_line_and_layer (void)
{
  g_auto (QnDrawing) drawing;
  parse (HEAD "0\nLINE\n8\nJoints\n10\n1.25\n20\n-2\n11\n3\n21\n4e1\n" TAIL, &drawing);
  const QnDrawingPath *path = path_at (&drawing, 0);
  g_assert_cmpstr (path->layer, ==, "Joints");
  g_assert_cmpuint (path->line, ==, 5);
  g_assert_cmpuint (path->count, ==, 2);
  g_assert_cmpfloat (path->points[0].x, ==, 1.25);
  g_assert_cmpfloat (path->points[1].y, ==, 40);
  g_assert_false (path->closed);
}

/* Of the units of $INSUNITS those by which masonry is not drawn count too. */
static void
test_declared_units (void)
{
  static const struct {
    int code;
    double metres;
  } cases[] = { { 3, 1609.344 }, { 8, 2.54e-8 }, { 9, 2.54e-5 }, { 13, 1e-6 },
                { 15, 10 },      { 16, 100 },    { 4, 0.001 },   { 99, 0 } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnDrawing) drawing;
    g_autofree char *text =
      g_strdup_printf ("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n%d\n0\nENDSEC\n" HEAD
                       "0\nLINE\n8\nJ\n10\n1\n20\n2\n11\n3\n21\n4\n" TAIL,
                       cases[i].code);
    parse (text, &drawing);
    g_assert_cmpfloat (drawing.unit, ==, cases[i].metres);
  }
}

static void
test_bulge (void)
{
  /* Half a circle of radius 1 from (0, 0) to (2, 0), below, and straight back. */
  g_auto (QnDrawing) drawing;
  parse (HEAD
         "0\nLWPOLYLINE\n8\n0\n90\n99\n70\n1\n10\n0\n20\n0\n42\n1\n10\n2\n20\n0\n" TAIL,
         &drawing);
  const QnDrawingPath *path = path_at (&drawing, 0);
  g_assert_true (path->closed);
  g_assert_cmpuint (path->count, >, 20);
  double lowest = 0;
  for (gsize i = 0; i < path->count; i++) {
    g_assert_cmpfloat_with_epsilon (hypot (path->points[i].x - 1, path->points[i].y), 1,
                                    1e-12);
    lowest = fmin (lowest, path->points[i].y);
  }
  g_assert_cmpfloat (lowest, <, -0.99);
}

static void
test_curves (void)
{
  g_auto (QnDrawing) drawing;
  parse (
    HEAD
    "0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n2\n"
    "0\nARC\n8\n0\n10\n0\n20\n0\n40\n1\n50\n90\n51\n180\n"
    "0\nELLIPSE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n0\n40\n0.5\n41\n0\n42\n"
    "6.283185307179586\n"
    "0\nSPLINE\n8\n0\n70\n8\n71\n2\n72\n6\n73\n3\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n"
    "1\n10\n0\n20\n0\n10\n1\n20\n2\n10\n2\n20\n0\n"
    "0\nSPLINE\n8\n0\n70\n12\n71\n2\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n"
    "41\n1\n41\n0."
    "70710678118654757\n41\n1\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n" TAIL,
    &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 5);
  g_assert_true (path_at (&drawing, 0)->closed);
  const QnDrawingPath *arc = path_at (&drawing, 1);
  g_assert_cmpfloat_with_epsilon (arc->points[0].y, 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (arc->points[arc->count - 1].x, -1, 1e-12);
  const QnDrawingPath *ellipse = path_at (&drawing, 2);
  for (gsize i = 0; i < ellipse->count; i++) {
    QnVec2 p = ellipse->points[i];
    g_assert_cmpfloat_with_epsilon (p.x * p.x / 9 + p.y * p.y / 2.25, 1, 1e-12);
  }
  /* A parabola: y = x (2 - x). */
  const QnDrawingPath *spline = path_at (&drawing, 3);
  for (gsize i = 0; i < spline->count; i++)
    g_assert_cmpfloat_with_epsilon (
      spline->points[i].y, spline->points[i].x * (2 - spline->points[i].x), 1e-12);
  g_assert_cmpfloat (spline->points[spline->count - 1].x, ==, 2);
  /* With weights, a quarter of a circle. */
  const QnDrawingPath *quarter = path_at (&drawing, 4);
  g_assert_cmpuint (quarter->count, >, 3);
  for (gsize i = 0; i < quarter->count; i++)
    g_assert_cmpfloat_with_epsilon (hypot (quarter->points[i].x, quarter->points[i].y), 1,
                                    1e-12);
}

static void
test_inserts (void)
{
  /* A unit square in a block, that block twice as large in another, inserted turned and as an
   * array, its layer 0 taking the layer of the insert. */
  g_auto (QnDrawing) drawing;
  parse ("0\nSECTION\n2\nBLOCKS\n"
         "0\nBLOCK\n8\n0\n2\nA\n10\n1\n20\n1\n0\nLWPOLYLINE\n8\n0\n70\n1\n10\n1\n20\n1\n1"
         "0\n2\n20\n"
         "1\n10\n2\n20\n2\n10\n1\n20\n2\n0\nENDBLK\n8\n0\n"
         "0\nBLOCK\n8\n0\n2\nB\n10\n0\n20\n0\n0\nINSERT\n8\n0\n2\nA\n10\n3\n20\n0\n41\n2"
         "\n42\n2\n0\n"
         "ENDBLK\n8\n0\n0\nENDSEC\n"
         "0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\nStones\n2\nB\n10\n0\n20\n0\n50\n90\n70\n"
         "2\n44\n10\n"
         "0\nINSERT\n8\n0\n2\nMissing\n10\n0\n20\n0\n" TAIL,
         &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 2);
  const QnDrawingPath *first = path_at (&drawing, 0), *second = path_at (&drawing, 1);
  g_assert_cmpstr (first->layer, ==, "Stones");
  g_assert_cmpfloat_with_epsilon (first->points[0].x, 0, 1e-12);
  g_assert_cmpfloat_with_epsilon (first->points[0].y, 3, 1e-12);
  g_assert_cmpfloat_with_epsilon (first->points[2].x, -2, 1e-12);
  g_assert_cmpfloat_with_epsilon (first->points[2].y, 5, 1e-12);
  g_assert_cmpfloat_with_epsilon (second->points[0].y, 13, 1e-12);
  g_assert_cmpuint (drawing.notes->len, ==, 1);
}

/* A block that contains itself, twice: ends, and is told. */
static void
test_endless_inserts (void)
{
  static const char text[] = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nA\n10\n0\n20\n0\n"
                             "0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n0\n"
                             "0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n0\n0\nENDBLK\n8\n0\n0\nEN"
                             "DSEC\n0\nSECTION\n2\nENTITIES\n0\n"
                             "INSERT\n8\n0\n2\nA\n10\n0\n20\n0\n" TAIL;
  expect_refused (text, "outlines");
}

/* A million circles have more corners than are read, long before there are too many of them. */
static void
test_many_circles (void)
{
  static const char text[] =
    "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nA\n10\n0\n20\n0\n"
    "0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n2\n0\nENDBLK\n8\n0\n0\nEN"
    "DSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n"
    "0\n70\n1000\n71\n1000\n44\n5\n45\n5\n" TAIL;
  expect_refused (text, "corners");
}

static void
test_bad_files (void)
{
  static const struct {
    const char *text;
    const char *start, *part;
  } cases[] = {
    { "", "bad.dxf:1: ", "empty" },
    { "hello\nworld\n", "bad.dxf:1: ", "not a DXF file" },
    { "AutoCAD Binary DXF\r\n\x1a", "bad.dxf:1: ", "binary" },
    { "AC1027", "bad.dxf:1: ", "a DWG file" },
    { HEAD "0\n3DFACE\n10\n0\n20\n0\n30\n0\n11\n3\n21\n4\n31\n0\n12\n0\n22\n5\n32\n5\n"
           "13\n0\n23\n0\n33\n5\n" TAIL,
      "bad.dxf:1: ", "in no upright plane" },
    { HEAD "0\nLINE\n8\n0\n10\nabc\n20\n0\n" TAIL, "bad.dxf:10: ", "coordinate" },
    { HEAD "0\nLINE\n8\n0\n10\n1e400\n20\n0\n" TAIL, "bad.dxf:10: ", "coordinate" },
    { HEAD "0\nLINE\n8\n0\n10\nnan\n20\n0\n" TAIL, "bad.dxf:10: ", "coordinate" },
    { HEAD "0\nLINE\nlayer\n0\n" TAIL, "bad.dxf:7: ", "group code" },
    { HEAD "0\nLINE\n8", "bad.dxf:7: ", "ends after a group code" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnDrawing drawing;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_drawing_read (qn_dxf_import, cases[i].text, strlen (cases[i].text),
                                     "bad.dxf", &drawing, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_true (g_str_has_prefix (error->message, cases[i].start));
    g_assert_nonnull (strstr (error->message, cases[i].part));
    g_assert_null (strchr (error->message, '\n'));
  }
}

static void
test_large (void)
{
  g_autoptr (GString) text = g_string_new (HEAD);
  for (int i = 0; i < 100000; i++)
    g_string_append_printf (text, "0\nLINE\n8\n0\n10\n%d\n20\n0\n11\n%d\n21\n1\n", i, i);
  g_string_append (text, TAIL);
  g_auto (QnDrawing) drawing;
  parse (text->str, &drawing);
  g_assert_cmpuint (drawing.paths->len, ==, 100000);
}

/* Names are the drawing's own: the program keeps none of them when it has gone. */
static void
test_names (void)
{
  g_autoptr (GString) text = g_string_new (HEAD);
  for (int i = 0; i < 200; i++)
    g_string_append_printf (text, "0\nLINE\n8\nL%d\n10\n0\n20\n0\n11\n1\n21\n1\n", i / 2);
  g_string_append (text, TAIL);
  GQuark before = g_quark_from_string ("before the names");
  g_auto (QnDrawing) drawing;
  parse (text->str, &drawing);
  g_assert_cmpuint (g_quark_from_string ("after the names"), <, before + 50);
  g_assert_cmpstr (path_at (&drawing, 199)->layer, ==, "L99");
  g_assert_true (path_at (&drawing, 0)->layer == path_at (&drawing, 1)->layer);
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

#define SQUARE(layer, more)                                                              \
  "0\nLWPOLYLINE\n8\n" layer "\n" more "70\n1\n10\n0\n20\n0\n10\n2\n20\n0\n10\n2\n20\n1" \
  "\n"

/* What a layer or the entity itself hides is marked or left out, in blocks too. */
static void
test_hidden (void)
{
  g_auto (QnDrawing) drawing;
  parse ("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nOff\n70\n0\n62\n-7\n"
         "0\nLAYER\n2\nIce\n70\n1\n62\n7\n0\nLAYER\n2\nOn\n70\n4\n62\n7\n0\nENDTAB\n0\nEN"
         "DSEC\n"
         "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nB\n" SQUARE ("0", "")
           SQUARE ("On", "")
             SQUARE ("0", "60\n1\n") "0\nENDBLK\n8\n0\n0\nENDSEC\n" HEAD SQUARE ("On", "")
               SQUARE ("OFF", "") SQUARE ("ice", "") "0\nINSERT\n8\nOff\n2\nb\n"
                                                     "0\nINSERT\n8\nIce\n2\nB\n" TAIL,
         &drawing);
  static const gboolean hidden[] = { FALSE, TRUE, TRUE, TRUE, FALSE };
  g_assert_cmpuint (drawing.paths->len, ==, G_N_ELEMENTS (hidden));
  for (guint i = 0; i < G_N_ELEMENTS (hidden); i++)
    g_assert_cmpint (path_at (&drawing, i)->hidden, ==, hidden[i]);
  g_autofree char *notes = dup_notes (&drawing);
  g_assert_cmpstr (notes, ==,
                   "invisible shapes left out: 1; blocks on frozen layers left out: 1; ");
}

/* Encodings as files state them, characters by number, marks of byte order, ends of lines. */
static void
test_text (void)
{
#define PAGE(name) "0\nSECTION\n2\nHEADER\n9\n$DWGCODEPAGE\n3\n" name "\n0\nENDSEC\n"
  static const struct {
    const char *text, *layer;
  } cases[] = {
    { PAGE ("ANSI_1252") HEAD SQUARE ("\xd6"
                                      "ffnung",
                                      "") TAIL,
      "Öffnung" },
    { PAGE ("ANSI_1251") HEAD SQUARE ("\xd1\xf2\xe5\xed\xe0", "") TAIL, "Стена" },
    { PAGE ("mac-roman") HEAD SQUARE ("\x85l", "") TAIL, "Öl" },
    { PAGE ("ascii") HEAD SQUARE ("\x99l", "") TAIL, "Öl" },
    { PAGE ("DOS850") HEAD SQUARE ("\x99", "") TAIL, "Ö" },
    { PAGE ("no such page") HEAD SQUARE ("\xd6l", "") TAIL, "\xef\xbf\xbdl" },
    { HEAD SQUARE ("\xd6l", "") TAIL, "Öl" },
    { PAGE ("ANSI_1252") HEAD SQUARE ("Öl", "") TAIL, "Öl" },
    { HEAD SQUARE ("\\U+00D6l \\U+4E2", "") TAIL, "Öl \\U+4E2" },
    { "\xef\xbb\xbf" HEAD SQUARE ("Öl", "") TAIL, "Öl" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    for (int end = 0; end < 2; end++) {
      g_auto (QnDrawing) drawing;
      g_autofree char *text = g_strdup (cases[i].text);
      if (end == 1)
        g_strdelimit (text, "\n", '\r');
      parse (text, &drawing);
      g_assert_cmpuint (drawing.paths->len, ==, 1);
      g_assert_cmpstr (path_at (&drawing, 0)->layer, ==, cases[i].layer);
    }
}

/* Drawings in an upright plane are seen from the front, whether their coordinates are the world's or
 * those of their own plane; what has depth is told. */
static void
test_views (void)
{
#define UP "210\n0\n220\n-1\n230\n0\n"
  g_auto (QnDrawing) lines, planes, mixed;
  parse (HEAD "0\nLINE\n10\n1\n20\n7\n30\n2\n11\n3\n21\n7\n31\n5\n" TAIL, &lines);
  g_assert_cmpfloat (path_at (&lines, 0)->points[1].y, ==, 5);
  parse (
    HEAD SQUARE ("0", UP
                 "38\n-4\n") "0\nCIRCLE\n10\n5\n20\n6\n30\n-4\n40\n1\n" UP
                             "0\n3DFACE\n10\n0\n20\n4\n30\n3\n11\n1\n21\n4\n31\n3\n" TAIL,
    &planes);
  g_assert_cmpuint (planes.paths->len, ==, 2);
  g_assert_cmpfloat_with_epsilon (path_at (&planes, 0)->points[2].y, 1, 1e-15);
  g_assert_cmpfloat_with_epsilon (path_at (&planes, 1)->points[0].x, 6, 1e-12);
  g_assert_cmpfloat_with_epsilon (path_at (&planes, 1)->points[0].y, 6, 1e-12);
  g_autofree char *notes = dup_notes (&planes);
  g_assert_cmpstr (
    notes, ==,
    "3DFACE entities left out: 1; drawn in the x-z plane and seen from the "
    "front; shapes: 2; ");
  parse (HEAD SQUARE ("0", "") "0\nLINE\n10\n1\n20\n7\n30\n2\n11\n3\n21\n7\n31\n5\n" TAIL,
         &mixed);
  g_autofree char *depth = dup_notes (&mixed);
  g_assert_nonnull (strstr (depth, "drawn in space and seen from above"));
  /* A front at an angle in plan, of two triangles. */
  g_auto (QnDrawing) turned;
#define TRIANGLE(x1, y1, z1)                                                             \
  "0\n3DFACE\n10\n0\n20\n0\n30\n0\n11\n3\n21\n4\n31\n0\n12\n" x1 "\n22\n" y1 "\n32\n" z1 \
  "\n13\n" x1 "\n23\n" y1 "\n33\n" z1 "\n"
  parse (HEAD TRIANGLE ("3", "4", "5") TRIANGLE ("0", "0", "5") TAIL, &turned);
  g_assert_cmpfloat_with_epsilon (path_at (&turned, 0)->points[2].x, 5, 1e-12);
  g_assert_cmpfloat (path_at (&turned, 0)->points[2].y, ==, 5);
  g_autofree char *told = dup_notes (&turned);
  g_assert_nonnull (
    strstr (told, "triangles of meshes, each of which becomes a block: 2"));
  /* Three corners, the fourth not repeated. */
  g_auto (QnDrawing) three;
  parse (HEAD "0\n3DFACE\n10\n0\n20\n0\n30\n0\n11\n3\n21\n4\n31\n0\n"
              "12\n3\n22\n4\n32\n5\n" TAIL,
         &three);
  g_autofree char *one = dup_notes (&three);
  g_assert_nonnull (
    strstr (one, "triangles of meshes, each of which becomes a block: 1"));
  g_assert_nonnull (strstr (told, "seen square to it; shapes: 2"));
}

/* An inner boundary is a hole: told, or cut out at the edge; what lies in it is a block. */
static void
test_holes_of_hatches (void)
{
#define LOOP(x0, y0, x1, y1)                                                             \
  "92\n2\n72\n0\n73\n1\n93\n4\n10\n" x0 "\n20\n" y0 "\n10\n" x1 "\n20\n" y0 "\n10\n" x1  \
  "\n20\n" y1 "\n10\n" x0 "\n20\n" y1 "\n97\n0\n"
  static const struct {
    const char *loops;
    guint paths, corners;
    const char *notes;
  } cases[] = {
    { LOOP ("3", "3", "6", "6"), 1, 4, "shapes with holes, whose blocks are solid: 1; " },
    { LOOP ("3", "3", "6", "6") LOOP ("4", "4", "5", "5"), 2, 4,
      "shapes with holes, whose blocks are solid: 1; " },
    { LOOP ("3", "0", "6", "3"), 1, 8, "" },
    { LOOP ("9", "0", "12", "9"), 2, 4, "" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnDrawing) drawing;
    g_autofree char *text =
      g_strconcat (HEAD "0\nHATCH\n8\n0\n10\n0\n20\n0\n30\n0\n2\nSOLID\n91\n2\n",
                   LOOP ("0", "0", "9", "9"), cases[i].loops,
                   "75\n0\n98\n1\n10\n9\n20\n9\n" TAIL, NULL);
    parse (text, &drawing);
    g_autofree char *notes = dup_notes (&drawing);
    g_autofree char *wanted =
      g_strconcat ("read as outlines: hatches: 1; ", cases[i].notes, NULL);
    g_assert_cmpuint (drawing.paths->len, ==, cases[i].paths);
    g_assert_cmpuint (path_at (&drawing, 0)->count, ==, cases[i].corners);
    g_assert_cmpstr (notes, ==, wanted);
  }
}

/* A block that has nothing but hatches is told. */
static void
test_hatches_in_blocks (void)
{
#define FILLED(more)                                                                     \
  "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n0\n20\n0\n" more                           \
  "0\nHATCH\n8\n0\n91\n1\n" LOOP ("0", "0", "9",                                         \
                                  "9") "75\n0\n0\nENDBLK\n0\nENDSEC\n" HEAD              \
                                       "0\nINSERT\n2\nB\n10\n0\n20\n0\n" TAIL
  for (int outlined = 0; outlined < 2; outlined++) {
    g_auto (QnDrawing) drawing;
    parse (outlined ? FILLED (SQUARE ("0", "")) : FILLED (""), &drawing);
    const QnDrawingNote *note = g_ptr_array_index (drawing.notes, 0);
    g_assert_cmpstr (note->text, ==, "HATCH entities left out");
    g_assert_true (note->minor == outlined);
  }
}

/* Hatches and faces in space are outlines where there are no others. */
static void
test_hatches (void)
{
#define HATCH                                                                            \
  "0\nHATCH\n8\n0\n10\n0\n20\n0\n30\n0\n2\nSOLID\n91\n2\n92\n3\n72\n1\n73\n1\n93\n3\n"   \
  "10\n0\n20\n0\n42\n0\n10\n2\n20\n0\n42\n1\n10\n2\n20\n1\n42\n0\n97\n0\n"               \
  "92\n1\n93\n2\n72\n1\n10\n6\n20\n0\n11\n4\n21\n0\n72\n2\n10\n5\n20\n0\n40\n1\n50\n180" \
  "\n"                                                                                   \
  "51\n360\n73\n1\n97\n0\n75\n0\n98\n1\n10\n9\n20\n9\n"
  g_auto (QnDrawing) alone, beside;
  parse (HEAD HATCH TAIL, &alone);
  g_assert_cmpuint (alone.paths->len, ==, 2);
  g_assert_true (path_at (&alone, 0)->closed);
  g_assert_cmpfloat_with_epsilon (path_at (&alone, 0)->points[2].y, 0, 0.1);
  double lowest = 0;
  for (gsize i = 0; i < path_at (&alone, 1)->count; i++)
    lowest = fmin (lowest, path_at (&alone, 1)->points[i].y);
  g_assert_cmpfloat_with_epsilon (lowest, -1, 1e-12);
  parse (HEAD HATCH SQUARE ("0", "") TAIL, &beside);
  g_assert_cmpuint (beside.paths->len, ==, 1);
  g_autofree char *notes = dup_notes (&beside);
  g_assert_cmpstr (notes, ==, "HATCH entities left out: 1; ");
}

QN_TESTS
{
  g_test_add_func ("/dxf-import/line-and-layer", test_line_and_layer);
  g_test_add_func ("/dxf-import/declared-units", test_declared_units);
  g_test_add_func ("/dxf-import/bulge", test_bulge);
  g_test_add_func ("/dxf-import/curves", test_curves);
  g_test_add_func ("/dxf-import/inserts", test_inserts);
  g_test_add_func ("/dxf-import/endless-inserts", test_endless_inserts);
  g_test_add_func ("/dxf-import/many-circles", test_many_circles);
  g_test_add_func ("/dxf-import/bad-files", test_bad_files);
  g_test_add_func ("/dxf-import/large", test_large);
  g_test_add_func ("/dxf-import/names", test_names);
  g_test_add_func ("/dxf-import/hidden", test_hidden);
  g_test_add_func ("/dxf-import/text", test_text);
  g_test_add_func ("/dxf-import/views", test_views);
  g_test_add_func ("/dxf-import/hatches", test_hatches);
  g_test_add_func ("/dxf-import/holes-of-hatches", test_holes_of_hatches);
  g_test_add_func ("/dxf-import/hatches-in-blocks", test_hatches_in_blocks);
}
