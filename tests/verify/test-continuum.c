/* Walls cut both ways into cells by a law with an elasticity, against beam theory and the uniform
 * states of a continuum. */
#include "core/path/analysis.h"
#include "io/project/project.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

#define E 30e9

/* A wall of cells on a rigid foundation, under a rigid plate that is loaded at its middle; `turned`
 * is the motion of the plate that is held, or "". Angles turn everything. */
typedef struct Wall {
  const char *cells; /* JSON members of the object */
  const char *arrangement;
  double width, height, poisson, angle;
  gboolean guided; /* the plate cannot turn */
} Wall;

static QnVec2
turn (const Wall *wall, double x, double y)
{
  return qn_vec2_rotate (qn_vec2 (x, y), cos (wall->angle), sin (wall->angle));
}

/* Displacement of the plate by the force, both in the wall's own axes. */
static QnVec2
displacement (const Wall *wall, double fx, double fy)
{
  const double w = wall->width, h = wall->height, d = 0.1;
  const QnVec2 c[] = { turn (wall, 0, h), turn (wall, w, h), turn (wall, w, h + d),
                       turn (wall, 0, h + d) };
  const QnVec2 at = turn (wall, w / 2, h), f = turn (wall, fx, fy);
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"c\", \"kind\": "
    "\"elastic\", \"basis\": \"material\", \"elasticity\": %g, \"poisson\": %g, "
    "\"arrangement\": \"%s\" } ], \"blocks\": [ { \"name\": \"plate\", \"vertices\": "
    "[[%.17g, %.17g], [%.17g, %.17g], [%.17g, %.17g], [%.17g, %.17g]], \"thickness\": 1, "
    "\"unit_weight\": 0, \"rigid\": true, \"support\": [false, false, %s] } ], "
    "\"masonry\": [ { %s, \"rotation\": %.17g, \"thickness\": 1, \"unit_weight\": 0, "
    "\"foundation\": 0.2 } ], \"contact\": { \"law\": \"c\" }, \"loads\": { \"live\": [ "
    "{ "
    "\"kind\": \"force\", \"block\": \"plate\", \"at\": [%.17g, %.17g], \"value\": "
    "[%.17g, %.17g] } ] }, \"analysis\": { \"increments\": 1, \"max_multiplier\": 1 } }",
    E, wall->poisson, wall->arrangement, c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y,
    c[3].x, c[3].y, wall->guided ? "true" : "false", wall->cells, wall->angle, at.x, at.y,
    f.x, f.y);
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  g_autoptr (GError) error = NULL;
  QnDiag diag;
  if (!qn_project_parse (text, strlen (text), "wall", NULL, &project, &error)
      || !qn_project_prepare (&project, &error))
    g_error ("%s", error->message);
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, &diag), ==, QN_OK);
  g_assert_cmpuint (contacts.findings.count, ==, 0);
  g_assert_cmpint (
    qn_analysis_run (&project.model, &contacts, NULL, NULL, &result, &diag), ==, QN_OK);
  const QnStep *last = &result.steps[result.step_count - 1];
  g_assert_cmpfloat_with_epsilon (last->multiplier, 1, 1e-9);
  const QnId plate = qn_model_find_block (&project.model, "plate");
  const double *u = qn_result_step_displacements (&result, result.step_count - 1);
  /* The force acts at the foot of the plate, its centroid moves. */
  const double x = u[3 * plate] + u[3 * plate + 2] * d / 2 * cos (wall->angle);
  const double y = u[3 * plate + 1] + u[3 * plate + 2] * d / 2 * sin (wall->angle);
  return qn_vec2_rotate (qn_vec2 (x, y), cos (wall->angle), -sin (wall->angle));
}

/* Timoshenko's cantilever, or the same with a guided end, under a transverse unit force. Across a
 * grid the shear finds its parabola; the section of a block in a chain stays plane. */
static double
beam (const Wall *wall)
{
  const double h = wall->height, w = wall->width, I = w * w * w / 12;
  const double G = E / (2 * (1 + wall->poisson));
  const double k = g_str_equal (wall->arrangement, "chain") ? 1 : 5.0 / 6.0;
  return h * h * h / ((wall->guided ? 12 : 3) * E * I) + h / (k * G * w);
}

#define GRID(size, cells)                                                                \
  "\"kind\": \"grid\", \"name\": \"g\", \"size\": " size ", \"cells\": " cells
#define VORONOI(size, cell, seed)                                                        \
  "\"kind\": \"voronoi\", \"name\": \"v\", \"size\": " size ", \"cell\": " cell          \
  ", \"seed\": " seed

/* Bending and shear. Cells of Voronoi have neighbours in all directions: without Poisson's ratio they
 * are those of the continuum. */
static void
test_beam (void)
{
  static const struct {
    Wall wall;
    double error;
  } cases[] = {
    { { GRID ("[1, 3]", "[4, 12]"), "grid", 1, 3, 0, 0, FALSE }, 0.001 },
    { { GRID ("[1, 3]", "[8, 24]"), "grid", 1, 3, 0.2, 0, FALSE }, 0.0015 },
    { { GRID ("[1, 3]", "[8, 24]"), "grid", 1, 3, 0.2, 0.5, FALSE }, 0.0015 },
    { { GRID ("[1, 3]", "[1, 24]"), "chain", 1, 3, 0.2, 0, FALSE }, 0.01 },
    { { GRID ("[1, 3]", "[8, 24]"), "grid", 1, 3, 0.2, 0, TRUE }, 0.02 },
    { { VORONOI ("[1, 3]", "0.2", "1"), "grid", 1, 3, 0, 0, FALSE }, 0.02 },
    { { VORONOI ("[1, 3]", "0.2", "2"), "grid", 1, 3, 0, 1, FALSE }, 0.02 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const Wall *wall = &cases[i].wall;
    const double ratio = displacement (wall, 1e3, 0).x / (1e3 * beam (wall));
    g_test_message ("%zu: %.5f", i, ratio);
    g_assert_cmpfloat_with_epsilon (ratio, 1, cases[i].error);
  }
}

/* Uniform compression is exact in a grid, upright and turned, whatever Poisson's ratio: lateral
 * strain is not represented. */
static void
test_compression (void)
{
  static const struct {
    Wall wall;
    double error;
  } cases[] = {
    { { GRID ("[2, 3]", "[5, 7]"), "grid", 2, 3, 0.3, 0, FALSE }, 1e-9 },
    { { GRID ("[2, 3]", "[5, 7]"), "grid", 2, 3, 0.3, 0.7, FALSE }, 1e-9 },
    { { VORONOI ("[2, 3]", "0.3", "1"), "grid", 2, 3, 0, 0, FALSE }, 0.02 },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const Wall *wall = &cases[i].wall;
    const double shortening = 1e3 * wall->height / (E * wall->width);
    const double ratio = -displacement (wall, 0, -1e3).y / shortening;
    g_test_message ("%zu: %.5f", i, ratio);
    g_assert_cmpfloat_with_epsilon (ratio, 1, cases[i].error);
  }
}

/* Two rigid blocks that a joint by material holds together are refused. */
static void
test_rigid_joint (void)
{
  static const char text[] =
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"c\", \"kind\": "
    "\"elastic\", \"basis\": \"material\", \"elasticity\": 3e10 } ], \"blocks\": [ { "
    "\"vertices\": [[0, 0], [1, 0], [1, 1], [0, 1]], \"thickness\": 1, \"unit_weight\": "
    "1, "
    "\"rigid\": true, \"support\": [true, true, true] }, { \"vertices\": [[0, 1], [1, "
    "1], "
    "[1, 2], [0, 2]], \"thickness\": 1, \"unit_weight\": 1, \"rigid\": true } ], "
    "\"contact\": { \"law\": \"c\" } }";
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts = { 0 };
  QnDiag diag;
  g_assert_true (qn_project_parse (text, sizeof text - 1, "two", NULL, &project, NULL));
  g_assert_true (qn_project_prepare (&project, NULL));
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_RIGID_JOINT);
}

/* What an arrangement says is compared with how the blocks lie. */
static void
test_arrangement (void)
{
  static const struct {
    const char *cells, *arrangement;
    QnProblem problem;
  } cases[] = {
    { GRID ("[1, 3]", "[1, 6]"), "chain", QN_PROBLEM_NONE },
    { GRID ("[1, 3]", "[1, 6]"), "grid", QN_PROBLEM_LAW_GRID },
    { GRID ("[1, 3]", "[2, 6]"), "grid", QN_PROBLEM_NONE },
    { GRID ("[1, 3]", "[2, 6]"), "chain", QN_PROBLEM_LAW_CHAIN },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = g_strdup_printf (
      "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"c\", \"kind\": "
      "\"elastic\", \"basis\": \"material\", \"elasticity\": 3e10, \"arrangement\": "
      "\"%s\" "
      "} ], \"masonry\": [ { %s, \"thickness\": 1, \"unit_weight\": 2e4, \"foundation\": "
      "0.2 } ], \"contact\": { \"law\": \"c\" } }",
      cases[i].arrangement, cases[i].cells);
    g_auto (QnProject) project;
    g_auto (QnContacts) contacts;
    QnDiag diag;
    g_assert_true (qn_project_parse (text, strlen (text), "wall", NULL, &project, NULL));
    g_assert_true (qn_project_prepare (&project, NULL));
    g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, &diag), ==, QN_OK);
    const QnFindings *findings = &contacts.findings;
    g_assert_cmpuint (findings->count, ==, cases[i].problem != QN_PROBLEM_NONE);
    if (findings->count > 0)
      g_assert_cmpint (findings->items[0].problem, ==, cases[i].problem);
  }
}

QN_TESTS
{
  g_test_add_func ("/verify/continuum/beam", test_beam);
  g_test_add_func ("/verify/continuum/compression", test_compression);
  g_test_add_func ("/verify/continuum/rigid-joint", test_rigid_joint);
  g_test_add_func ("/verify/continuum/arrangement", test_arrangement);
}
