#include "core/limit/limit.h"
#include "io/exchange/drawing-import.h"
#include "io/text/io-error.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <string.h>

/* One wall, the third of Ferris & Tin-Loi with its base, in every way that a drawing comes. */
static const char *const variants[] = {
  "clean", "closed-by-vertex", "overrun",   "collinear-vertices",
  "lines", "inserts",          "clutter",   "mirrored-extrusion",
  "gaps",  "no-unit",          "wrong-unit"
};

static char *
example (const char *name)
{
  return g_strdup_printf ("%s/dxf/wall-%s.dxf", g_getenv ("QUOIN_EXAMPLES"), name);
}

static void
import (const char *name, QnProject *project, QnImportReport *report)
{
  g_autofree char *path = example (name);
  g_autoptr (GError) error = NULL;
  if (!qn_import_file (path, &QN_IMPORT_DEFAULTS, project, report, &error))
    g_error ("%s", error->message);
}

static double
multiplier (const QnModel *model)
{
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_contacts_detect (model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_limit_associative (model, &contacts, NULL, NULL, &solution, &diag),
                   ==, QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  double value = solution.upper_bound;
  return value;
}

/* The block of b whose centroid is where that of block i of a is. */
static QnId
same_block (const QnModel *a, size_t i, const QnModel *b)
{
  for (size_t k = 0; k < b->block_count; k++) {
    QnVec2 way = qn_vec2_sub (a->blocks[i].centroid, b->blocks[k].centroid);
    if (qn_vec2_length (way) < 1e-6)
      return (QnId) k;
  }
  return QN_NONE;
}

static void
test_variants (void)
{
  QnProject clean, project;
  QnImportReport report;
  import ("clean", &clean, &report);
  qn_import_report_clear (&report);
  double expected = multiplier (&clean.model);
  g_assert_cmpfloat_with_epsilon (expected, 0.40369410, 1e-6);
  for (size_t v = 1; v < G_N_ELEMENTS (variants); v++) {
    import (variants[v], &project, &report);
    g_test_message ("%s", variants[v]);

    g_assert_cmpuint (project.model.block_count, ==, clean.model.block_count);
    for (size_t i = 0; i < clean.model.block_count; i++) {
      QnId k = same_block (&clean.model, i, &project.model);
      g_assert_cmpint (k, !=, QN_NONE);
      const QnBlock *a = &clean.model.blocks[i], *b = &project.model.blocks[k];
      g_assert_cmpint (a->vertex_count, ==, b->vertex_count);
      g_assert_cmpfloat_with_epsilon (a->area, b->area, 1e-6 * a->area);
      g_assert_cmpint (a->support[0], ==, b->support[0]);
    }
    g_assert_cmpfloat_with_epsilon (multiplier (&project.model), expected, 1e-6);
    qn_import_report_clear (&report);
    qn_project_clear (&project);
  }
  qn_project_clear (&clean);
}

static gboolean
tells (const GPtrArray *lines, const char *part)
{
  for (guint i = 0; i < lines->len; i++)
    if (strstr (lines->pdata[i], part) != NULL)
      return TRUE;
  return FALSE;
}

static void
test_report (void)
{
  static const char *const expected[][3] = {
    { "closed-by-vertex", "end where they began: 24", NULL },
    { "overrun", "ended beyond their beginning: 47", NULL },
    { "collinear-vertices", "collinear vertices removed: 117", NULL },
    { "lines", "open lines made into faces: 158", "openings cut out: 1" },
    { "clutter", "cross themselves: 1, first at line", "drawn twice: 6" },
    { "clutter", "hatches without a boundary that can be read left out: 1, first at line",
      "3DFACE entities left out: 1" },
    { "gaps", "vertices merged: ", NULL },
    { "no-unit", "not declared; read as mm", "1.6 x 2.1 m" },
    { "wrong-unit", "declares 0.0254 m", "read as mm instead" }
  };
  for (size_t i = 0; i < G_N_ELEMENTS (expected); i++) {
    g_auto (QnProject) project;
    g_auto (QnImportReport) report;
    import (expected[i][0], &project, &report);
    g_assert_true (tells (report.lines, expected[i][1]));
    g_assert_true (expected[i][2] == NULL || tells (report.lines, expected[i][2]));
    g_assert_cmpint (tells (report.warnings, "unit"), ==,
                     strstr (expected[i][0], "unit") != NULL);
  }
}

/* A drawing of boxes, corner by corner. */
static void
add_box (QnDrawing *drawing, const char *layer, double x0, double y0, double x1,
         double y1)
{
  QnDrawingPath *path = qn_drawing_add_path (drawing, layer, 1);
  qn_drawing_path_add (path, qn_vec2 (x0, y0));
  qn_drawing_path_add (path, qn_vec2 (x1, y0));
  qn_drawing_path_add (path, qn_vec2 (x1, y1));
  qn_drawing_path_add (path, qn_vec2 (x0, y1));
  path->closed = TRUE;
}

static void
test_supports_inferred (void)
{
  g_auto (QnDrawing) drawing;
  QnProject project;
  QnImportReport report;
  qn_drawing_init (&drawing);
  add_box (&drawing, "A", 0, 0, 1, 0.5);
  add_box (&drawing, "A", 1, 0.01, 2, 0.5); /* as roughly as by hand */
  add_box (&drawing, "A", 0.5, 0.5, 1.5, 1);
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  g_assert_true (
    qn_drawing_to_project (&drawing, "test", &settings, &project, &report, NULL));
  g_assert_true (tells (report.warnings, "the lowest row is fixed, 2 blocks"));
  g_assert_true (project.model.blocks[0].support[0]);
  g_assert_false (project.model.blocks[2].support[0]);
  qn_import_report_clear (&report);
  qn_project_clear (&project);

  /* A table of layers overrules the names; what is not there is told. */
  char *layers[] = { (char *) "A=ignored", NULL, NULL };
  settings.layers = layers;
  add_box (&drawing, "BASE", 0, -1, 2, 0);
  g_assert_true (
    qn_drawing_to_project (&drawing, "test", &settings, &project, &report, NULL));
  g_assert_cmpuint (project.model.block_count, ==, 1);
  qn_import_report_clear (&report);
  qn_project_clear (&project);
}

/* The voussoirs of a flat arch all begin at one height: it stands on those at its ends. A row of blocks
 * whose joints are upright stands on all. */
static void
test_flat_arch (void)
{
  for (int slanting = 0; slanting < 2; slanting++) {
    g_auto (QnDrawing) drawing;
    g_auto (QnProject) project;
    g_auto (QnImportReport) report;
    qn_drawing_init (&drawing);
    for (int i = -3; i <= 3; i++) {
      QnDrawingPath *path = qn_drawing_add_path (&drawing, "A", 1);
      double left = i - 0.5, right = i + 0.5, lean = slanting ? 1.2 : 1;
      qn_drawing_path_add (path, qn_vec2 (0.3 * left, 0));
      qn_drawing_path_add (path, qn_vec2 (0.3 * right, 0));
      qn_drawing_path_add (path, qn_vec2 (0.3 * lean * right, 0.5));
      qn_drawing_path_add (path, qn_vec2 (0.3 * lean * left, 0.5));
      path->closed = TRUE;
    }
    g_assert_true (qn_drawing_to_project (&drawing, "test", &QN_IMPORT_DEFAULTS, &project,
                                          &report, NULL));
    g_assert_cmpuint (project.model.block_count, ==, 7);
    for (int i = 0; i < 7; i++)
      g_assert_cmpint (project.model.blocks[i].support[0], ==,
                       !slanting || i == 0 || i == 6);
    g_assert_cmpint (
      tells (report.warnings, "voussoirs of a flat arch, and not fixed: 5"), ==,
      slanting);
  }
}

/* Rings of voussoirs of 20 and of 15 degrees on one circle, of arcs or of Bézier curves: blocks touch all
 * along it, and do not overlap. */
static void
test_curves_touch (void)
{
  for (int splines = 0; splines < 2; splines++) {
    g_auto (QnDrawing) drawing;
    g_auto (QnProject) project;
    g_auto (QnImportReport) report;
    qn_drawing_init (&drawing);
    for (int ring = 0; ring < 2; ring++)
      for (int i = 0; i < (ring == 0 ? 9 : 12); i++) {
        QnDrawingPath *path = qn_drawing_add_path (&drawing, "A", 1);
        double step = ring == 0 ? G_PI / 9 : G_PI / 12, from = i * step;
        for (int side = 0; side < 2; side++) {
          double r = 2 + 0.3 * (ring + side), a = side == 0 ? from : from + step,
                 b = side == 0 ? from + step : from, k = 4.0 / 3 * tan ((b - a) / 4) * r;
          QnVec2 p[4] = {
            { r * cos (a), r * sin (a) }, { 0, 0 }, { 0, 0 }, { r * cos (b), r * sin (b) }
          };
          static const double knots[] = { 0, 0, 0, 0, 1, 1, 1, 1 };
          p[1] = qn_vec2 (p[0].x - k * sin (a), p[0].y + k * cos (a));
          p[2] = qn_vec2 (p[3].x + k * sin (b), p[3].y - k * cos (b));
          qn_drawing_path_add (path, p[0]);
          if (splines)
            qn_drawing_path_add_spline (path, 3, knots, 8, p, NULL, 4);
          else
            qn_drawing_path_add_bulge (path, p[3], tan ((b - a) / 4));
        }
        path->closed = TRUE;
      }
    g_assert_true (qn_drawing_to_project (&drawing, "test", &QN_IMPORT_DEFAULTS, &project,
                                          &report, NULL));
    g_auto (QnContacts) contacts = { 0 };
    g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpuint (contacts.findings.count, ==, 0);
    double along = 0;
    for (gsize i = 0; i < contacts.face_count; i++) {
      QnVec2 a = contacts.faces[i].start, b = contacts.faces[i].end;
      if (fabs (qn_vec2_length (a) - 2.3) < 0.001
          && fabs (qn_vec2_length (b) - 2.3) < 0.001)
        along += qn_vec2_length (qn_vec2_sub (b, a));
    }
    g_assert_cmpfloat_with_epsilon (along, 2.3 * G_PI, 0.001);
  }
}

/* Lines that no block is made of are told: a joint across a closed outline, and one that ends before
 * its beginning. A line along an outline, and one that is part of a face, are used. */
static void
test_idle_lines (void)
{
  static const struct {
    QnVec2 points[5];
    guint count;
    const char *told; /* NULL: all is used */
  } paths[] = {
    { { { 0.5, 0 }, { 0.5, 0.5 } },
      2,
      "no block left out: 0.5 m of them, first near (0.5, 0.25)" },
    { { { 0, 0.5 }, { 1, 0.5 } }, 2, NULL },
    { { { 0.1, 0.5 }, { 0.1, 1 }, { 0.9, 1 }, { 0.9, 0.5 } }, 4, NULL },
    { { { 0, 0.5 }, { 1, 0.5 }, { 1, 1 }, { 0, 1 }, { 0, 0.6 } },
      5,
      "no block left out: 1.9 m" },
  };
  for (guint i = 0; i < G_N_ELEMENTS (paths); i++) {
    g_auto (QnDrawing) drawing;
    g_auto (QnProject) project;
    g_auto (QnImportReport) report;
    qn_drawing_init (&drawing);
    add_box (&drawing, "A", 0, 0, 1, 0.5);
    QnDrawingPath *path = qn_drawing_add_path (&drawing, "A", 1);
    for (guint k = 0; k < paths[i].count; k++)
      qn_drawing_path_add (path, paths[i].points[k]);
    QnImportSettings settings = QN_IMPORT_DEFAULTS;
    settings.unit = 1;
    g_assert_true (
      qn_drawing_to_project (&drawing, "test", &settings, &project, &report, NULL));
    if (paths[i].told != NULL)
      g_assert_true (tells (report.warnings, paths[i].told));
    else
      g_assert_false (tells (report.warnings, "no block left out"));
  }
}

static void
test_refuses (void)
{
  g_auto (QnDrawing) drawing;
  QnProject project;
  QnImportReport report;
  g_autoptr (GError) error = NULL;
  qn_drawing_init (&drawing);
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  g_assert_false (
    qn_drawing_to_project (&drawing, "empty.dxf", &settings, &project, &report, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_true (g_str_has_prefix (error->message, "empty.dxf:1: "));
  g_clear_error (&error);
  qn_import_report_clear (&report);
  /* What was left out is told all the same. */
  qn_drawing_note (&drawing, "meshes left out", 3);
  g_assert_false (
    qn_drawing_to_project (&drawing, "empty.dxf", &settings, &project, &report, &error));
  g_assert_true (tells (report.warnings, "meshes left out: 1, first at line 3"));
  qn_import_report_clear (&report);
  g_clear_error (&error);
  char *absent[] = { (char *) "WALL=block", NULL };
  settings.layers = absent;
  add_box (&drawing, "stones", 0, 0, 1, 1);
  g_assert_false (
    qn_drawing_to_project (&drawing, "empty.dxf", &settings, &project, &report, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
  g_assert_nonnull (
    strstr (error->message, "no such layer; those of the drawing: stones"));
  qn_import_report_clear (&report);
  g_clear_error (&error);
  char *layers[] = { (char *) "A=wall", NULL };
  settings.layers = layers;
  g_assert_false (
    qn_drawing_to_project (&drawing, "empty.dxf", &settings, &project, &report, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE);
  qn_import_report_clear (&report);
}

QN_TESTS
{
  g_test_add_func ("/drawing-import/variants", test_variants);
  g_test_add_func ("/drawing-import/report", test_report);
  g_test_add_func ("/drawing-import/supports-inferred", test_supports_inferred);
  g_test_add_func ("/drawing-import/flat-arch", test_flat_arch);
  g_test_add_func ("/drawing-import/curves-touch", test_curves_touch);
  g_test_add_func ("/drawing-import/idle-lines", test_idle_lines);
  g_test_add_func ("/drawing-import/refuses", test_refuses);
}
