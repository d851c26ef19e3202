#include "io/exchange/drawing.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <stdlib.h>
#include <string.h>

/* A box from 0 to w, 0 to d, 0 to h, lifted by z. */
static char *
box (double w, double d, double h, double z)
{
  return g_strdup_printf (
    "{ \"vertex\": { \"0\": {\"x\":0,\"y\":0,\"z\":%g}, \"1\": "
    "{\"x\":%g,\"y\":0,\"z\":%g}, "
    "\"2\": {\"x\":%g,\"y\":%g,\"z\":%g}, \"3\": {\"x\":0,\"y\":%g,\"z\":%g}, "
    "\"4\": {\"x\":0,\"y\":0,\"z\":%g}, \"5\": {\"x\":%g,\"y\":0,\"z\":%g}, "
    "\"6\": {\"x\":%g,\"y\":%g,\"z\":%g}, \"7\": {\"x\":0,\"y\":%g,\"z\":%g} }, "
    "\"face\": { \"0\": [0,3,2,1], \"1\": [4,5,6,7], \"2\": [0,1,5,4], \"3\": "
    "[\"3\",\"7\",\"6\","
    "\"2\"], \"4\": [0,4,7,3], \"5\": [1,2,6,5] } }",
    z, w, z, w, d, z, d, z, z + h, w, z + h, w, d, z + h, d, z + h);
}

static void
assert_blocks (const char *text)
{
  g_auto (QnDrawing) drawing;
  g_autoptr (GError) error = NULL;
  if (!qn_drawing_read (qn_compas_import, text, strlen (text), "test.json", &drawing,
                        &error))
    g_error ("%s", error->message);
  g_assert_cmpuint (drawing.paths->len, ==, 2);
  for (guint i = 0; i < 2; i++) {
    const QnDrawingPath *path = &g_array_index (drawing.paths, QnDrawingPath, i);
    g_assert_cmpint (path->support, ==, i == 0);
    g_assert_cmpuint (path->count, ==, 4);
    double low = INFINITY, high = -INFINITY, right = 0;
    for (gsize k = 0; k < path->count; k++) {
      low = fmin (low, path->points[k].y);
      high = fmax (high, path->points[k].y);
      right = fmax (right, path->points[k].x);
    }
    g_assert_cmpfloat (low, ==, i * 0.5);
    g_assert_cmpfloat (high, ==, i * 0.5 + 0.5);
    g_assert_cmpfloat (right, ==, 2);
  }
}

static void
test_both_forms (void)
{
  g_autofree char *a = box (2, 1, 0.5, 0), *b = box (2, 1, 0.5, 0.5);
  g_autofree char *today =
    g_strdup_printf ("{ \"dtype\": \"compas_assembly.datastructures/Assembly\", "
                     "\"data\": { \"graph\": { \"data\": "
                     "{ \"node\": { \"0\": { \"block\": { \"data\": %s }, "
                     "\"is_support\": true }, \"1\": { "
                     "\"block\": { \"data\": %s } } } } } } }",
                     a, b);
  assert_blocks (today);
  g_autofree char *older =
    g_strdup_printf ("{ \"assembly\": { \"vertex\": { \"0\": { \"is_support\": true }, "
                     "\"1\": {} } }, \"blocks\": "
                     "{ \"0\": %s, \"1\": %s } }",
                     a, b);
  assert_blocks (older);
}

/* Models with elements that are placed, and older wrappers. */
static void
test_other_forms (void)
{
  g_autofree char *a = box (2, 1, 0.5, 0), *b = box (2, 1, 0.5, 0.1);
  g_autofree char *model = g_strdup_printf (
    "{ \"dtype\": \"compas_dem.models/BlockModel\", \"data\": { \"elements\": [ "
    "{ \"data\": { \"is_support\": true, \"transformation\": null, \"geometry\": { "
    "\"data\": %s } } }, "
    "{ \"data\": { \"transformation\": { \"data\": { \"matrix\": "
    "[[1,0,0,0],[0,1,0,0],[0,0,1,0.4],"
    "[0,0,0,1]] } }, \"geometry\": { \"data\": %s } } } ], \"edge\": { \"0\": { \"1\": { "
    "\"mesh\": %s } } } } }",
    a, b, a);
  assert_blocks (model);
  g_autofree char *c = box (2, 1, 0.5, 0.5);
  g_autofree char *value = g_strdup_printf (
    "{ \"dtype\": \"compas.datastructures/Network\", \"value\": { \"node\": { \"0\": { "
    "\"is_support\": "
    "true, \"block\": { \"value\": %s } }, \"1\": { \"block\": { \"value\": %s } } } } }",
    a, c);
  assert_blocks (value);
  /* What stands beside the nodes of a network is no block, and no support of theirs. */
  g_autofree char *beside = g_strdup_printf (
    "{ \"is_support\": true, \"vertex\": {\"0\": {}}, \"face\": {\"0\": [0]}, "
    "\"node\": { \"0\": { \"is_support\": true, \"block\": %s }, "
    "\"1\": { \"block\": %s } } }",
    a, c);
  assert_blocks (beside);
}

static void
parse (const char *text, const char *expected, guint count)
{
  g_auto (QnDrawing) drawing = { 0 };
  g_autoptr (GError) error = NULL;
  GString *told = g_string_new (NULL);
  if (qn_drawing_read (qn_compas_import, text, strlen (text), "test.obj", &drawing,
                       &error))
    for (guint i = 0; i < drawing.notes->len; i++)
      g_string_append_printf (told, "%s; ",
                              ((QnDrawingNote *) drawing.notes->pdata[i])->text);
  else
    g_string_append (told, error->message);
  g_assert_cmpuint (drawing.paths != NULL ? drawing.paths->len : 0, ==, count);
  g_assert_cmpstr (told->str, ==, expected);
  g_string_free (told, TRUE);
}

#define BOX(name, x0, x1, y0, y1, z0, z1)                                                \
  "o " name "\nv " x0 " " y0 " " z0 "\nv " x1 " " y0 " " z0 "\nv " x1 " " y1 " " z0      \
  "\nv " x0 " " y1 " " z0 "\nv " x0 " " y0 " " z1 "\nv " x1 " " y0 " " z1 "\nv " x1      \
  " " y1 " " z1 "\nv " x0 " " y1 " " z1                                                  \
  "\nf -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8/1 -7/1/2 -3\nf -8 -3 -4\nf -5 -1 -2 -6\n"        \
  "f -8 -4 -1 -5\nf -7 -6 -2 -3\n"

/* Which view is taken, and which block spoils another one: fronts of several faces are one outline. */
static void
test_views (void)
{
  parse (BOX ("a", "0", "1", "0", "1", "0", "1") BOX ("b", "0", "1", "0", "1", "1", "2"),
         "blocks as thick as in the file; seen from the front, along y; blocks; ", 2);
  parse (BOX ("a", "0", "1", "0", "1", "0", "1") BOX ("b", "0", "1", "1", "2", "0", "1"),
         "blocks as thick as in the file; seen from above, along z; blocks; block a lies "
         "behind another one along y; ",
         2);
  parse (BOX ("a", "0", "1", "0", "1", "0",
              "1") "o c\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv .2 .2 1\n"
                   "f 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n",
         "test.obj:1: the blocks are not prisms of one direction: block c is not a prism "
         "along y",
         0);
  /* A floor of one face, and two bodies in one object. */
  parse (
    BOX ("a", "0", "1", "0", "1", "0",
         "1") "v 3 0 0\nv 4 0 0\nv 4 1 0\nv 3 1 0\nv 3 0 1\nv 4 0 1\nv 4 1 1\nv 3 1 1\n"
              "f -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -5 -1 -2 -6\n"
              "f -8 -4 -1 -5\nf -7 -6 -2 -3\n"
              "o floor\nv -9 0 0\nv 9 0 0\nv 9 9 0\nv -9 9 0\nf -4 -3 -2 -1\n",
    "meshes without thickness left out; blocks as thick as in the file; seen from the "
    "front, along y; blocks; ",
    2);
}

/* An object of the points (x, z) of `corners`, four outer and four others, at y = 0 and, the others moved
 * to the middle by `taper`, at y = 1; faces of the front and, turned, of the back. */
static char *
dup_extruded (double taper, const char *const *faces, gsize count)
{
  static const double corners[8][2] = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 },
                                        { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } };
  GString *text = g_string_new ("o f\n");
  for (int y = 0; y < 2; y++)
    for (int i = 0; i < 8; i++) {
      double share = y == 1 ? taper : 0;
      g_string_append_printf (text, "v %g %d %g\n",
                              corners[i][0] + share * (1.5 - corners[i][0]), y,
                              corners[i][1] + share * (1.5 - corners[i][1]));
    }
  for (gsize i = 0; i < count; i++) {
    g_auto (GStrv) numbers = g_strsplit (faces[i], " ", -1);
    g_string_append_printf (text, "f %s\nf", faces[i]);
    for (guint k = g_strv_length (numbers); k > 0; k--)
      g_string_append_printf (text, " %d", atoi (numbers[k - 1]) + 8);
    g_string_append (text, "\n");
  }
  return g_string_free (text, FALSE);
}

/* A frame is taken as solid and told; what lies in its hole is no block. A face may have vertices inside;
 * one that tapers is no prism. */
static void
test_holes_and_inner_vertices (void)
{
  static const char *const frame[] = { "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8" };
  static const char *const full[] = { "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8",
                                      "5 6 7 8" };
  g_autofree char *hollow = dup_extruded (0, frame, 4);
  parse (hollow,
         "blocks with holes, which are taken as solid; blocks as thick as in the file; "
         "seen from the front, along y; blocks; ",
         1);
  g_autofree char *inner = dup_extruded (0, full, 5);
  parse (inner, "blocks as thick as in the file; seen from the front, along y; blocks; ",
         1);
  g_autofree char *tapers = dup_extruded (0.1, full, 5);
  parse (tapers,
         "test.obj:1: the blocks are not prisms of one direction: block f is not a prism "
         "along y",
         0);
  g_autofree char *both =
    g_strconcat (hollow, BOX ("in", "1.2", "1.8", "0", "1", "1", "1.5"), NULL);
  parse (both,
         "test.obj:1: the blocks are not prisms of one direction: block in lies behind "
         "another one along y, or in its hole: blocks cannot be hollow",
         0);
}

/* Of the mesh, or of what is nearest around it. */
static void
test_density (void)
{
  g_autofree char *a = box (2, 1, 0.5, 0), *b = box (2, 1, 0.5, 0.5);
  g_autofree char *text = g_strdup_printf (
    "{ \"node\": { \"0\": { \"density\": 1800, \"block\": { \"data\": %s } }, \"1\": { "
    "\"block\": { \"data\": { \"attributes\": { \"density\": 2500 }, %s } } } }",
    a, b + 1);
  g_auto (QnDrawing) drawing;
  g_assert_true (
    qn_drawing_read (qn_compas_import, text, strlen (text), "test.json", &drawing, NULL));
  g_assert_cmpuint (drawing.paths->len, ==, 2);
  g_assert_cmpfloat (g_array_index (drawing.paths, QnDrawingPath, 0).density, ==, 1800);
  g_assert_cmpfloat (g_array_index (drawing.paths, QnDrawingPath, 1).density, ==, 2500);
  g_assert_cmpfloat (g_array_index (drawing.paths, QnDrawingPath, 1).thickness, ==, 1);
}

/* A network and an old assembly with a node that has no block; the graph of a model, whose nodes have none. */
static void
test_nodes_without_block (void)
{
  g_autofree char *a = box (2, 1, 0.5, 0);
  static const char *const forms[] = {
    "{ \"node\": { \"0\": { \"block\": %s }, \"1\": { \"block\": null }, \"2\": {} } }",
    ("{ \"assembly\": { \"vertex\": { \"0\": {}, \"1\": {}, \"2\": {} } }, \"blocks\": { "
     "\"0\": %s } }"),
    "{ \"elements\": [ %s ], \"graph\": { \"node\": { \"0\": {}, \"1\": {} } } }"
  };
  for (guint i = 0; i < G_N_ELEMENTS (forms); i++) {
    g_auto (QnDrawing) drawing;
    g_autoptr (GString) text = g_string_new (forms[i]);
    g_string_replace (text, "%s", a, 1);
    g_assert_true (qn_drawing_read (qn_compas_import, text->str, text->len, "test.json",
                                    &drawing, NULL));
    g_assert_cmpuint (drawing.paths->len, ==, 1);
    const QnDrawingNote *note = drawing.notes->pdata[0];
    g_assert_cmpint (strcmp (note->text, "nodes without a block left out") == 0, ==,
                     i < 2);
    g_assert_cmpuint (note->count, ==, i < 2 ? 2 : 1);
  }
}

/* Lines of OBJ that say less than they should, with their place; a line that goes on on the next one. */
static void
test_objects (void)
{
#define CORNER "expected a face of three or more corners, each one of the vertices"
  static const char *const cases[][2] = {
    { "v nan 0 0\n", "test.obj:1: 1: expected three coordinates of a vertex" },
    { "v 1 2\n", "test.obj:1: 1: expected three coordinates of a vertex" },
    { "o a\nv 0 \\\n0 0\nv 1 inf 0\n",
      "test.obj:4: a: expected three coordinates of a vertex" },
    { "o a\r\nv 0 0 0\r\nv 1 0 0\r\nf 1 2 999\r\n", "test.obj:4: a: " CORNER },
    { "v 0 0 0\nv 1 0 0\nf 0 1 2\n", "test.obj:3: 1: " CORNER },
    { "v 0 0 0\nv 1 0 0\nf -1 -2 -3\n", "test.obj:3: 1: " CORNER },
    { "v 0 0 0\nv 1 0 0\nf 1 \\\n2\n", "test.obj:3: 1: " CORNER },
    { "v 0 0 0\nf 1 1 one\n", "test.obj:2: 1: " CORNER },
  };
  for (guint i = 0; i < G_N_ELEMENTS (cases); i++)
    parse (cases[i][0], cases[i][1], 0);
  g_autoptr (GString) text = g_string_new (BOX ("a", "0", "1", "0", "1", "0", "1"));
  g_string_replace (text, "f -8 -5 ", "f -8 \\\n-5 \\\n", 0);
  parse (text->str,
         "blocks as thick as in the file; seen from the front, along y; blocks; ", 1);
}

static void
test_bad_files (void)
{
  static const char *const texts[] = {
    "{",
    "{}",
    "[]",
    "{ \"assembly\": { \"vertex\": { \"0\": {} } }, \"blocks\": "
    "{ \"0\": { \"vertex\": {}, \"face\": {} } } }",
    "{ \"assembly\": { \"vertex\": { \"0\": {} } }, \"blocks\": "
    "{ \"0\": { \"vertex\": [[0,0],[1]], \"face\": [[0,1,7]] } } "
    "}",
    "{ \"vertex\": [[0,0,0],[1,0,0]], \"face\": [[0,1,7]] }"
  };
  for (size_t i = 0; i < G_N_ELEMENTS (texts); i++) {
    QnDrawing drawing;
    g_autoptr (GError) error = NULL;
    g_assert_false (qn_drawing_read (qn_compas_import, texts[i], strlen (texts[i]),
                                     "bad.json", &drawing, &error));
    g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
    g_assert_true (g_str_has_prefix (error->message, "bad.json:1:"));
  }
}

QN_TESTS
{
  g_test_add_func ("/compas-import/other-forms", test_other_forms);
  g_test_add_func ("/compas-import/views", test_views);
  g_test_add_func ("/compas-import/both-forms", test_both_forms);
  g_test_add_func ("/compas-import/holes", test_holes_and_inner_vertices);
  g_test_add_func ("/compas-import/density", test_density);
  g_test_add_func ("/compas-import/nodes-without-block", test_nodes_without_block);
  g_test_add_func ("/compas-import/objects", test_objects);
  g_test_add_func ("/compas-import/bad-files", test_bad_files);
}
