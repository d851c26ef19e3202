#include "io/exchange/drawing-import.h"
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

/* Imports a square of this size, given and declared units in m; returns the length of its side, m. */
static double
import_square (double size, double given, double declared, QnImportReport *report)
{
  g_autoptr (GError) error = NULL;
  g_auto (QnDrawing) drawing;
  g_auto (QnProject) project;
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  qn_drawing_init (&drawing);
  drawing.unit = declared;
  settings.unit = given;
  QnDrawingPath *path = qn_drawing_add_path (&drawing, "0", 1);
  qn_drawing_path_add (path, qn_vec2 (0, 0));
  qn_drawing_path_add (path, qn_vec2 (size, 0));
  qn_drawing_path_add (path, qn_vec2 (size, size));
  qn_drawing_path_add (path, qn_vec2 (0, size));
  path->closed = TRUE;
  qn_drawing_to_project (&drawing, "square", &settings, &project, report, &error);
  g_assert_no_error (error);
  return project.model.vertices[2].x;
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
    g_auto (QnImportReport) report;
    double side =
      import_square (cases[i].size, cases[i].given, cases[i].declared, &report);
    guint line = 0;
    while (!g_str_has_prefix (report.lines->pdata[line], "unit: "))
      line++;
    g_test_message ("%s", (const char *) report.lines->pdata[line]);
    g_assert_cmpfloat_with_epsilon (side / cases[i].size, cases[i].expected, 1e-12);
    g_assert_nonnull (strstr (report.lines->pdata[line], cases[i].said));
    g_assert_cmpint (g_ptr_array_find_with_equal_func (
                       report.warnings, report.lines->pdata[line], g_str_equal, NULL),
                     ==, cases[i].warned);
  }
}

/* A decimal fraction of a drawing in mm is the nearest number to the same fraction in m. */
static void
test_digits (void)
{
  g_auto (QnImportReport) millimetres, feet;
  g_assert_cmpfloat (import_square (175.3, 0.001, 0, &millimetres), ==, 0.1753);
  g_assert_cmpfloat (import_square (10, 0.3048, 0, &feet), ==, 3.048);
}

QN_TESTS
{
  g_test_add_func ("/import-unit/names", test_names);
  g_test_add_func ("/import-unit/choice", test_choice);
  g_test_add_func ("/import-unit/digits", test_digits);
}
