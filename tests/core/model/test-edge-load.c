/* Loads on the edges of blocks, against sums by hand. */
#include "core/model/outline.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

#define EXACT 1e-9

static QnLoad *
add_edge_load (QnModel *model, QnId block, QnId edge, double from, double to)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_EDGE;
  load->block = block;
  load->edge = edge;
  load->intensity[0] = from;
  load->intensity[1] = to;
  load->normal = true;
  return load;
}

static QnLoad *
add_surcharge (QnModel *model, double pressure)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_SURCHARGE;
  load->pressure = pressure;
  return load;
}

/* Three numbers of one block. */
static void
assert_forces (const QnModel *model, QnId block, double fx, double fy, double moment)
{
  g_autofree double *forces = g_new (double, QN_DOF_COUNT *qn_model_body_count (model));
  const double expected[] = { fx, fy, moment };
  qn_model_live_forces (model, forces);
  for (int i = 0; i < QN_DOF_COUNT; i++)
    g_assert_cmpfloat_with_epsilon (forces[QN_DOF_COUNT * block + i], expected[i], EXACT);
}

static void
prepare (QnModel *model)
{
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
}

/* Block 2 x 1 whose centroid is (0, 0.5): edges are bottom, right, top, left. */
static void
test_trapezoid (void)
{
  g_auto (QnModel) model;
  test_model_init_block_on_plane (&model, 2, 1);
  add_edge_load (&model, 1, 2, 3, 6); /* the top, from right to left */
  prepare (&model);
  /* Resultant 2 (3 + 6) / 2 downwards at (3 + 12) / 27 of the way from x = 1 to x = -1. */
  assert_forces (&model, 1, 0, -9, -9 * (1 - 2 * 15.0 / 27));

  QnLoad *load = &model.live_loads[0];
  load->normal = false;
  load->vector = qn_vec2 (2, 0);
  prepare (&model);
  assert_forces (&model, 1, 18, 0, -18 * 0.5);

  load->part[0] = 0.5; /* its left half */
  load->intensity[0] = load->intensity[1] = 5;
  prepare (&model);
  assert_forces (&model, 1, 10, 0, -10 * 0.5);
}

/* A couple has no resultant; cut in two it is exact, and so it stays when the block turns. */
static void
test_couple (void)
{
  g_auto (QnModel) model;
  test_model_init_block_on_plane (&model, 2, 1);
  add_edge_load (&model, 1, 2, -3, 3);
  prepare (&model);
  g_assert_cmpuint (model.edge_force_count, ==, 2);
  /* q(s) = 3 s on s = -1 … 1 leftwards of the middle, downwards: M = int 3 s s ds. */
  assert_forces (&model, 1, 0, 0, 2);
}

/* Round a corner, and the same with the vertices given clockwise. */
static void
test_chain (void)
{
  for (int clockwise = 0; clockwise < 2; clockwise++) {
    g_auto (QnModel) model;
    test_model_init_block_on_plane (&model, 2, 1);
    QnLoad *load = add_edge_load (&model, 1, 1, 0, 3);
    load->edge_count = 2; /* right side upwards, then the top to the left */
    if (clockwise) {
      QnVec2 *v = model.vertices + model.blocks[1].first_vertex, second = v[1];
      v[1] = v[3];
      v[3] = second;
      load->intensity[0] = 3; /* the chain runs the other way */
      load->intensity[1] = 0;
    }
    prepare (&model);
    g_assert_cmpint (load->edge, ==, 1);
    /* 0 to 1 over the side of 1 m, 1 to 3 over the top of 2 m. */
    double side = -0.5, top = -4;
    double moment = -side * (2.0 / 3 - 0.5) + top * (1 - 2 * 7.0 / 12);
    assert_forces (&model, 1, side, top, moment);
  }
}

/* A side is a straight part of the outline, through vertices on it. */
static void
test_side (void)
{
  const QnVec2 corners[] = { { -1, 0 }, { 1, 0 }, { 1, 1 }, { 0.25, 1 }, { -1, 1 } };
  g_auto (QnModel) model;
  test_model_init (&model);
  test_model_add_base (&model, -2, -1, 4, 1);
  QnBlock *block = qn_model_add_block (&model, "b", corners, G_N_ELEMENTS (corners));
  block->thickness = 1;
  QnLoad *load = add_edge_load (&model, 1, 0, 0, 6);
  load->has_side = true;
  load->side = QN_BLOCK_SIDE_TOP;
  prepare (&model);
  assert_forces (&model, 1, 0, -6, -6 * (1 - 2 * 2.0 / 3));
  g_assert_cmpuint (model.edge_force_count, ==, 2);
}

/* What is seen from above: a plane, a block in the middle of it, and nothing under a lintel. */
static void
test_surcharge (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  test_model_add_base (&model, -3, -1, 6, 1);
  test_model_add_rectangle (&model, "left", -1, 0, 0.5, 1);
  test_model_add_rectangle (&model, "right", 0.5, 0, 0.5, 1);
  test_model_add_rectangle (&model, "lintel", -1, 1, 2, 0.5)->thickness = 2;
  QnLoad *load = add_surcharge (&model, 10);
  prepare (&model);
  assert_forces (&model, 1, 0, 0, 0);
  assert_forces (&model, 2, 0, 0, 0);
  assert_forces (&model, 3, 0, -10 * 2 * 2, 0);
  /* Two stretches of the base, 2 m each, which balance. */
  assert_forces (&model, 0, 0, -10 * 4, 0);
  g_assert_cmpfloat_with_epsilon (qn_model_load_resultant (&model, 0).y, -80, EXACT);

  load->span[0] = 0;
  load->span[1] = 0.5;
  prepare (&model);
  assert_forces (&model, 3, 0, -10 * 2 * 0.5, -10 * 0.25);
  assert_forces (&model, 0, 0, 0, 0);

  load->span[0] = 10; /* beside everything */
  load->span[1] = 11;
  prepare (&model);
  g_assert_cmpuint (model.edge_force_count, ==, 0);
}

/* Fill over a roof of slope 1 from (0, 0) to (2, 2), up to level 1 and up to level 3. */
static void
test_fill (void)
{
  const QnVec2 roof[] = { { 0, 0 }, { 2, 0 }, { 2, 2 } };
  g_auto (QnModel) model;
  test_model_init (&model);
  qn_model_add_block (&model, "roof", roof, G_N_ELEMENTS (roof))->thickness = 0.5;
  QnLoad *load = add_surcharge (&model, 0);
  load->unit_weight = 20;
  load->level = 1;
  prepare (&model);
  /* A triangle of 1 m x 1 m over x = 0 … 1, its centroid at 1/3. */
  const QnVec2 centroid = model.blocks[0].centroid;
  double weight = -20 * 0.5 * 0.5;
  assert_forces (&model, 0, 0, weight, weight * (1.0 / 3 - centroid.x));

  load->level = 3; /* a trapezoid: 2 x 1 and the triangle */
  load->pressure = 4;
  prepare (&model);
  double strip = -0.5 * 2 * (20 * 1 + 4), triangle = -0.5 * 20 * 2;
  assert_forces (&model, 0, 0, strip + triangle,
                 strip * (1 - centroid.x) + triangle * (2.0 / 3 - centroid.x));
}

/* From either side; a block that stands before the wall takes the pressure of its height. */
static void
test_backfill (void)
{
  for (int right = 0; right < 2; right++) {
    const double sign = right ? -1 : 1;
    g_auto (QnModel) model;
    test_model_init (&model);
    test_model_add_base (&model, -3, -1, 6, 1);
    test_model_add_rectangle (&model, "wall", -0.5, 0, 1, 3);
    test_model_add_rectangle (&model, "step", right ? 0.5 : -1.5, 0, 1, 1);
    QnLoad *load = qn_model_add_live_load (&model);
    load->kind = QN_LOAD_BACKFILL;
    load->side = right ? QN_BLOCK_SIDE_RIGHT : QN_BLOCK_SIDE_LEFT;
    load->span[0] = 0;
    load->span[1] = 3;
    load->unit_weight = 18;
    load->pressure = 5;
    load->earth = QN_EARTH_ACTIVE;
    load->friction_angle = G_PI / 6;
    prepare (&model);
    const double k = 1.0 / 3;
    /* The wall above the step: 5 k at the top, (5 + 36) k at a depth of 2 m. */
    double uniform = 5 * k * 2, triangle = 36 * k * 2 / 2;
    assert_forces (&model, 1, sign * (uniform + triangle), 0,
                   -sign * (uniform * 0.5 + triangle * (1 + 2.0 / 3 - 1.5)));
    double step = (41 + 59) / 2.0 * k;
    g_assert_cmpfloat_with_epsilon (qn_model_load_resultant (&model, 0).x,
                                    sign * (uniform + triangle + step), EXACT);
    assert_forces (&model, 0, 0, 0, 0); /* ends at the base */
  }
}

static void
test_earth (void)
{
  QnLoad load = { .earth = QN_EARTH_GIVEN, .coefficient = 0.4, .friction_angle = 0.5 };
  g_assert_cmpfloat (qn_load_earth_coefficient (&load), ==, 0.4);
  load.earth = QN_EARTH_AT_REST;
  g_assert_cmpfloat_with_epsilon (qn_load_earth_coefficient (&load), 1 - sin (0.5),
                                  EXACT);
  load.earth = QN_EARTH_ACTIVE;
  double t = tan (G_PI / 4 - 0.25);
  g_assert_cmpfloat_with_epsilon (qn_load_earth_coefficient (&load), t * t, EXACT);
}

/* The factor of a case multiplies forces, weights, edges, settlements; once. */
static void
test_cases (void)
{
  QnModel model;
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  add_edge_load (&model, 1, 2, 1000, 1000);
  int32_t number = qn_model_add_load_case (&model, "traffic");
  g_assert_cmpint (number, ==, 1);
  g_assert_cmpint (qn_model_add_load_case (&model, "traffic"), ==, 1);
  g_assert_cmpint (qn_model_find_load_case (&model, "wind"), ==, QN_NONE);
  prepare (&model);
  assert_forces (&model, 1, 20000, -2000, 0);
  model.load_cases[0].factor = 1.5;
  model.live_loads[1].load_case = 1;
  assert_forces (&model, 1, 20000, -3000, 0);
  model.live_loads[0].load_case = 1;
  assert_forces (&model, 1, 30000, -3000, 0);
  g_assert_cmpfloat (qn_model_load_resultant (&model, 2).y, ==, -3000);

  g_auto (QnModel) copy;
  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
  qn_model_clear (&model);
  assert_forces (&copy, 1, 30000, -3000, 0);
  g_assert_cmpstr (copy.load_cases[0].name, ==, "traffic");
}

/* Lengths seen from any side sum up to the extent of the structure there. */
static void
test_seen (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) model;
    test_model_init_wall (&model, number, 0);
    prepare (&model);
    double low = INFINITY, high = -INFINITY, seen_width = 0;
    for (size_t i = 0; i < model.vertex_count; i++) {
      low = fmin (low, model.vertices[i].x);
      high = fmax (high, model.vertices[i].x);
    }
    QnSeenEdges seen;
    QnPool room = { 0 };
    qn_model_find_seen_edges (&model, QN_BLOCK_SIDE_TOP, &seen, &room);
    g_assert_false (room.failed);
    for (size_t i = 0; i < seen.count; i++)
      seen_width += seen.items[i].ends[0].x - seen.items[i].ends[1].x;
    g_assert_cmpfloat_with_epsilon (seen_width, high - low, EXACT);
    qn_pool_clear (&room);
  }
}

/* Too much of it is refused before anything overflows. */
static void
test_refused (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init_block_on_plane (&model, 2, 1);
  QnLoad *load = add_edge_load (&model, 1, 2, 1e308, 1e308);
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_TOO_LARGE);
  g_assert_cmpstr (diag.field, ==, "intensity");

  load->intensity[0] = load->intensity[1] = 1;
  load->load_case = 1;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_LOAD_CASE_UNKNOWN);
  load->load_case = 0;
  load->edge = 4;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_EDGE_UNKNOWN);
}

QN_TESTS
{
  g_test_add_func ("/edge-load/trapezoid", test_trapezoid);
  g_test_add_func ("/edge-load/couple", test_couple);
  g_test_add_func ("/edge-load/chain", test_chain);
  g_test_add_func ("/edge-load/side", test_side);
  g_test_add_func ("/edge-load/surcharge", test_surcharge);
  g_test_add_func ("/edge-load/fill", test_fill);
  g_test_add_func ("/edge-load/backfill", test_backfill);
  g_test_add_func ("/edge-load/earth", test_earth);
  g_test_add_func ("/edge-load/cases", test_cases);
  g_test_add_func ("/edge-load/seen", test_seen);
  g_test_add_func ("/edge-load/refused", test_refused);
}
