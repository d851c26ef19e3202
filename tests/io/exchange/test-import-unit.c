#include "io/exchange/import-work.h"
#include "support/room.h"

#include <string.h>

static void
test_names (void)
{
  g_assert_cmpfloat (qn_import_unit ("mm"), ==, 0.001);
  g_assert_cmpfloat (qn_import_unit ("cm"), ==, 0.01);
  g_assert_cmpfloat (qn_import_unit ("dm"), ==, 0.1);
  g_assert_cmpfloat (qn_import_unit ("m"), ==, 1);
  g_assert_cmpfloat (qn_import_unit ("in"), ==, 0.0254);
  g_assert_cmpfloat (qn_import_unit ("ft"), ==, 0.3048);
  g_assert_cmpfloat (qn_import_unit ("km"), ==, 0);
  g_assert_cmpfloat (qn_import_unit (""), ==, 0);
}

/* Squares of these sizes in a row, one above the first. */
static void
draw_squares (QnDrawing *drawing, const double *sizes, gsize count)
{
  qn_drawing_init (drawing);
  for (gsize i = 0; i < count; i++) {
    QnDrawingPath *path = qn_drawing_add_path (drawing, "0", 1);
    double x = 2.0 * (double) i * sizes[i];
    qn_drawing_path_add (path, qn_vec2 (x, 0));
    qn_drawing_path_add (path, qn_vec2 (x + sizes[i], 0));
    qn_drawing_path_add (path, qn_vec2 (x + sizes[i], sizes[i]));
    qn_drawing_path_add (path, qn_vec2 (x, sizes[i]));
    path->closed = TRUE;
  }
}

/* A given unit is not questioned, a declared one only where blocks would be of no size that
 * masonry has; the guesses are m, mm, cm, in this order. */
static void
test_choice (void)
{
  static const struct {
    double size, given, declared; /* m per unit; 0: none */
    double expected;
    gboolean warned;
    const char *said;
  } cases[] = {
    { 300, 0.5, 0.001, 0.5, FALSE, "as given" },
    { 300, 0, 0.001, 0.001, FALSE, "as the file declares" },
    { 300, 0, 0.0254, 0.001, TRUE, "declares 0.0254 m" },
    { 0.3, 0, 0, 1, TRUE, "not declared; read as m " },
    { 300, 0, 0, 0.001, TRUE, "not declared; read as mm" },
    { 20, 0, 0, 0.01, TRUE, "not declared; read as cm" },
    { 1e6, 0, 0.0254, 0.0254, TRUE, "not plausible in any unit" },
    { 1e6, 0, 0, 1, TRUE, "not plausible in any unit" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnDrawing) drawing;
    draw_squares (&drawing, &cases[i].size, 1);
    drawing.unit = cases[i].declared;
    QnImportSettings settings = QN_IMPORT_DEFAULTS;
    settings.unit = cases[i].given;
    g_auto (QnImportReport)
      report = { .lines = g_ptr_array_new_with_free_func (g_free),
                 .warnings = g_ptr_array_new_with_free_func (g_free) };
    QnImportWork work = { .drawing = &drawing, .settings = &settings, .report = &report };
    qn_import_choose_unit (&work);
    g_assert_cmpuint (report.lines->len, ==, 1);
    g_test_message ("%s", (const char *) report.lines->pdata[0]);
    g_assert_cmpfloat (work.unit, ==, cases[i].expected);
    g_assert_nonnull (strstr (report.lines->pdata[0], cases[i].said));
    g_assert_cmpint (report.warnings->len > 0, ==, cases[i].warned);
  }
}

static void
test_block_size (void)
{
  static const double sizes[] = { 90, 1, 2, 3, 1000 };
  QnDrawing drawing;
  draw_squares (&drawing, NULL, 0);
  g_assert_cmpfloat (qn_import_block_size (&drawing), ==, 0);
  qn_drawing_clear (&drawing);
  draw_squares (&drawing, sizes, G_N_ELEMENTS (sizes));
  g_assert_cmpfloat (qn_import_block_size (&drawing), ==, 3);
  qn_drawing_clear (&drawing);

  /* Only lines: their own extents. */
  qn_drawing_init (&drawing);
  QnDrawingPath *path = qn_drawing_add_path (&drawing, "0", 1);
  qn_drawing_path_add (path, qn_vec2 (1, 1));
  qn_drawing_path_add (path, qn_vec2 (1, 8));
  g_assert_cmpfloat_with_epsilon (qn_import_block_size (&drawing), 7, 1e-12);
  qn_drawing_clear (&drawing);
}

/* A decimal fraction of a drawing in mm is the nearest number to the same fraction in m. */
static void
test_digits (void)
{
  QnImportWork work = { .unit = 0.001 };
  QnVec2 p = qn_import_to_metres (&work, qn_vec2 (175.3, 3));
  g_assert_cmpfloat (p.x, ==, 0.1753);
  g_assert_cmpfloat (p.y, ==, 0.003);
  work.unit = 0.3048;
  p = qn_import_to_metres (&work, qn_vec2 (10, -1));
  g_assert_cmpfloat (p.x, ==, 3.048);
  g_assert_cmpfloat (p.y, ==, -0.3048);
}

QN_TESTS
{
  g_test_add_func ("/import-unit/names", test_names);
  g_test_add_func ("/import-unit/choice", test_choice);
  g_test_add_func ("/import-unit/block-size", test_block_size);
  g_test_add_func ("/import-unit/digits", test_digits);
}
