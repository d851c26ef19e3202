/* Vehicles on fill: widths and shares by hand, what meets nothing, and what goes through air. */
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

#define AXLE 100e3

/* A block between two x below a level. */
static void
add_block (QnModel *model, const char *name, double from, double to, double top,
           double thickness)
{
  const QnVec2 v[] = { { from, top - 1 }, { to, top - 1 }, { to, top }, { from, top } };
  QnBlock *block = qn_model_add_block (model, name, v, 4);
  block->thickness = thickness;
  block->unit_weight = 1e4;
  block->density = -1;
}

static QnLoad *
add_fill (QnModel *model, const QnVec2 *surface, int count)
{
  QnLoad *fill = qn_model_add_dead_load (model);
  fill->kind = QN_LOAD_FILL;
  fill->unit_weight = 18e3;
  fill->surface_count = count;
  for (int i = 0; i < count; i++)
    fill->surface[i] = surface[i];
  return fill;
}

/* One axle of 100 kN with wheels of 0.3 m, 1.8 m apart. */
static QnLoad *
add_axle (QnModel *model, double x)
{
  QnVehicle *vehicle = qn_model_add_vehicle (model, "axle");
  vehicle->axles[0] = (QnAxle){ 0, AXLE };
  vehicle->axle_count = 1;
  vehicle->patch[0] = vehicle->patch[1] = 0.3;
  vehicle->track = 1.8;
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_VEHICLE;
  load->vehicle = 0;
  load->position = x;
  return load;
}

/* What a block gets of the live loads, N downwards. */
static double
down (const QnModel *model, const char *name)
{
  g_autofree double *forces = g_new (double, QN_DOF_COUNT *qn_model_body_count (model));
  QnId block = qn_model_find_block (model, name);
  qn_model_live_forces (model, forces);
  return -forces[QN_DOF_COUNT * block + QN_DOF_UY];
}

static void
prepare (QnModel *model)
{
  QnDiag diag;
  if (qn_model_prepare (model, &diag) != QN_OK)
    g_error ("%s: %s", qn_problem_text (diag.problem), diag.field);
}

/* At a depth of 1 m below a level surface. */
static void
test_widths (void)
{
  static const QnVec2 surface[] = { { -10, 1 }, { 10, 1 } };
  const double tan30 = 1 / sqrt (3);
  const struct {
    QnDispersal dispersal;
    double along, across;
  } rules[] = {
    { QN_DISPERSAL_HALF, 0.3 + 1, 1.8 + 0.3 + 1 },
    { QN_DISPERSAL_CS_454, 0.3 + 1, 1.8 + 1.5 + 1 },
    { QN_DISPERSAL_NR_025, 0.25 + 1, 1.8 + 2 },
    { QN_DISPERSAL_EN_1991, 0.3 + 2 * tan30, 1.8 + 0.3 + 2 * tan30 },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (rules); i++) {
    g_auto (QnModel) model;
    test_model_init (&model);
    add_block (&model, "b", -10, 10, 0, 1);
    add_fill (&model, surface, 2);
    QnLoad *load = add_axle (&model, 2);
    load->dispersal = rules[i].dispersal;
    prepare (&model);
    g_assert_cmpfloat_with_epsilon (down (&model, "b"), AXLE / rules[i].across,
                                    1e-9 * AXLE);
    size_t count;
    const QnEdgeForce *forces = qn_model_edge_forces_of (&model, 1, &count);
    g_assert_cmpuint (count, ==, 1);
    double low = fmin (forces->ends[0].x, forces->ends[1].x);
    g_assert_cmpfloat_with_epsilon (low, 2 - rules[i].along / 2, 1e-9);
    g_assert_cmpfloat_with_epsilon (fabs (forces->ends[1].x - forces->ends[0].x),
                                    rules[i].along, 1e-9);
    g_assert_cmpfloat_with_epsilon (forces->at.x, 2, 1e-9);
    for (int end = 0; end < 2; end++)
      g_assert_cmpfloat_with_epsilon (forces->intensity[end].y,
                                      -AXLE / rules[i].across / rules[i].along, 1e-3);
  }
}

/* No wider than the structure; an effective width instead; the whole load on a model as wide as it. */
static void
test_across (void)
{
  static const QnVec2 surface[] = { { -10, 1 }, { 10, 1 } };
  const struct {
    double thickness, width, effective, expected;
  } cases[] = { { 1, 2, 0, AXLE / 2 },
                { 1, 0, 2.5, AXLE / 2.5 },
                { 5, 5, 0, AXLE },
                { 3, 3, 0, AXLE },
                { 5, 0, 0, AXLE } };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnModel) model;
    test_model_init (&model);
    add_block (&model, "b", -10, 10, 0, cases[i].thickness);
    add_fill (&model, surface, 2);
    QnLoad *load = add_axle (&model, 0);
    load->dispersal = QN_DISPERSAL_CS_454;
    load->width = cases[i].width;
    load->effective = cases[i].effective;
    prepare (&model);
    g_assert_cmpfloat_with_epsilon (down (&model, "b"), cases[i].expected, 1e-6 * AXLE);
  }
}

/* Between -1 and 1 m at a depth of 1 m under a line load, tan t = 1: 2 (t + sin t cos t) / pi. */
static void
test_boussinesq (void)
{
  static const QnVec2 surface[] = { { -50, 1 }, { 50, 1 } };
  g_auto (QnModel) model;
  test_model_init (&model);
  add_block (&model, "left", -50, -1, 0, 1);
  add_block (&model, "b", -1, 1, 0, 1);
  add_block (&model, "right", 1, 50, 0, 1);
  add_fill (&model, surface, 2);
  QnLoad *load = add_axle (&model, 0);
  model.vehicles[0].patch[0] = 1e-6;
  load->dispersal = QN_DISPERSAL_BOUSSINESQ;
  load->effective = 1;
  prepare (&model);
  g_assert_cmpfloat_with_epsilon (down (&model, "b"), AXLE * 2 * (G_PI / 4 + 0.5) / G_PI,
                                  1e-3);
  g_assert_cmpfloat_with_epsilon (down (&model, "left"), down (&model, "right"), 1e-6);
  /* What 50 m do not catch: 4 / (3 pi) (1 / 50)^3 of the load. */
  double all = down (&model, "left") + down (&model, "b") + down (&model, "right");
  g_assert_cmpfloat_with_epsilon (all, AXLE, 1e-5 * AXLE);
  g_assert_cmpfloat (all, <, AXLE);
}

/* What lies beside the structure is not made up for. */
static void
test_beside (void)
{
  static const QnVec2 surface[] = { { -30, 1 }, { 30, 1 } };
  static const double places[] = { 10, 10.5, 11, -12, 40 };
  static const double parts[] = { 0.5, 0.15 / 1.3, 0, 0, 0 };
  for (size_t i = 0; i < G_N_ELEMENTS (places); i++) {
    g_auto (QnModel) model;
    test_model_init (&model);
    add_block (&model, "b", -10, 10, 0, 1);
    add_fill (&model, surface, 2);
    QnLoad *load = add_axle (&model, places[i]);
    load->dispersal = QN_DISPERSAL_CS_454;
    load->effective = 1;
    prepare (&model);
    g_assert_cmpfloat_with_epsilon (down (&model, "b"), parts[i] * AXLE, 1e-6 * AXLE);
  }
}

/* A high block throws a shadow on a low one; a cut in the surface lets nothing through. */
static void
test_line_of_sight (void)
{
  static const QnVec2 level[] = { { -5, 3 }, { 5, 3 } };
  g_auto (QnModel) model, cut;
  test_model_init (&model);
  add_block (&model, "high", 0, 1, 2, 1);
  add_block (&model, "low", 1, 4, 0, 1);
  add_fill (&model, level, 2);
  add_axle (&model, 0.5)->effective = 1;
  prepare (&model);
  /* Rays meet 0.3 m above the surface; the last has the tangent 1/2, that at the corner 0.5 / 1.3. */
  g_assert_cmpfloat_with_epsilon (down (&model, "high"), 2 * AXLE * 0.5 / 1.3, 1e-3);
  g_assert_cmpfloat_with_epsilon (down (&model, "low"), AXLE * (0.5 - 0.5 / 1.3), 1e-3);
  size_t count;
  const QnEdgeForce *forces = qn_model_edge_forces_of (&model, 1, &count);
  g_assert_cmpuint (count, ==, 2);
  double from = fmin (forces[1].ends[0].x, forces[1].ends[1].x);
  g_assert_cmpfloat_with_epsilon (from, 0.5 + 3.3 * 0.5 / 1.3, 1e-9);

  static const QnVec2 trench[] = { { -5, 3 }, { 0.5, 3 }, { 1, 0.5 }, { 5, 0.5 } };
  test_model_init (&cut);
  add_block (&cut, "b", -5, 5, 0, 1);
  add_fill (&cut, trench, 4);
  add_axle (&cut, 0)->effective = 1;
  prepare (&cut);
  g_assert_cmpfloat_with_epsilon (down (&cut, "b"), AXLE * (0.5 + 1 / 2.8), 1e-3);
}

/* On slopes nothing is lost, and the mirror image of structure and vehicle has the mirrored forces. */
static void
test_slopes (void)
{
  for (int dispersal = 0; dispersal < QN_DISPERSAL_COUNT; dispersal++) {
    double sums[2], moments[2];
    for (int mirror = 0; mirror < 2; mirror++) {
      g_auto (QnModel) model;
      double s = mirror ? -1 : 1;
      const QnVec2 roof[] = { { s * -200, -1 }, { s * 200, -1 }, { s * 200, 0 },
                              { s * 1, 2 },     { s * -3, 1.5 }, { s * -200, 0 } };
      const QnVec2 surface[] = { { -200, 2.6 }, { 200, 2.6 } };
      test_model_init (&model);
      QnBlock *block = qn_model_add_block (&model, "roof", roof, 6);
      block->thickness = 1;
      block->unit_weight = 1e4;
      add_fill (&model, surface, 2);
      QnLoad *load = add_axle (&model, s * 0.4);
      model.vehicles[0].axles[1] = (QnAxle){ 1.3, 0.5 * AXLE };
      model.vehicles[0].axle_count = 2;
      load->dispersal = (QnDispersal) dispersal;
      load->effective = 1;
      load->reversed = mirror;
      load->convoy = 2;
      load->headway = 1;
      prepare (&model);
      g_autofree double *f = g_new (double, QN_DOF_COUNT);
      qn_model_live_forces (&model, f);
      sums[mirror] = f[QN_DOF_UY];
      moments[mirror] = s * f[QN_DOF_RZ];
    }
    /* Of Boussinesq's rays 4 / (3 pi) (2.6 / 200)^3 pass beside. */
    g_assert_cmpfloat_with_epsilon (sums[0], -3 * AXLE, 3e-6 * AXLE);
    g_assert_cmpfloat_with_epsilon (sums[0], sums[1], 1e-9 * AXLE);
    g_assert_cmpfloat_with_epsilon (moments[0], moments[1], 1e-7 * AXLE);
  }
}

/* 10 kN/m on 4 m, 1 m below the surface: all of it arrives. */
static void
test_lines (void)
{
  static const QnVec2 surface[] = { { -50, 1 }, { 50, 1 } };
  g_auto (QnModel) model;
  test_model_init (&model);
  add_block (&model, "b", -50, 50, 0, 1);
  add_fill (&model, surface, 2);
  QnLoad *load = add_axle (&model, 0);
  model.vehicles[0].axle_count = 0;
  model.vehicles[0].line_count = 1;
  model.vehicles[0].lines[0] = (QnLineLoad){ 1, 5, 10e3 };
  load->effective = 1;
  prepare (&model);
  g_assert_cmpfloat_with_epsilon (down (&model, "b"), 40e3, 1e-6);
  size_t count;
  const QnEdgeForce *forces = qn_model_edge_forces_of (&model, 1, &count);
  g_assert_cmpfloat_with_epsilon (forces->at.x, -3, 1e-9);
}

/* On bare blocks, whose tops rounding does not leave level, all of an axle arrives wherever it stands. Of 10 kN/m
 * on 1.3 m that goes beyond their ends, what stands on them arrives. */
static void
test_bare (void)
{
  for (int i = 0; i < 200; i++) {
    g_auto (QnModel) model;
    test_model_init (&model);
    add_block (&model, "a", 0, 1.2, 0.6, 1);
    add_block (&model, "b", 1.2, 2.7, 0.1 + 0.2 + 0.3, 1);
    QnLoad *load = add_axle (&model, 0.15 + 0.012 * i);
    load->dispersal = i % 2 == 0 ? QN_DISPERSAL_BOUSSINESQ : QN_DISPERSAL_HALF;
    load->effective = 1;
    model.vehicles[0].line_count = 1;
    model.vehicles[0].lines[0] = (QnLineLoad){ -0.65, 0.65, 10e3 };
    prepare (&model);
    double on = fmin (load->position + 0.65, 2.7) - fmax (load->position - 0.65, 0);
    g_assert_cmpfloat_with_epsilon (down (&model, "a") + down (&model, "b"),
                                    AXLE + 10e3 * on, 1e-6 * AXLE);
  }
}

static void
test_refused (void)
{
  static const QnVec2 surface[] = { { 1, 1 }, { -1, 1 } };
  g_auto (QnModel) model, live, empty, before;
  QnDiag diag;
  test_model_init (&model);
  add_block (&model, "b", -1, 1, 0, 1);
  add_fill (&model, surface, 2);
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_SURFACE);

  test_model_init (&live);
  add_block (&live, "b", -1, 1, 0, 1);
  QnLoad *load = qn_model_add_live_load (&live);
  load->kind = QN_LOAD_FILL;
  load->surface_count = 2;
  load->surface[1].x = 1;
  g_assert_cmpint (qn_model_prepare (&live, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_FILL_LIVE);

  test_model_init (&empty);
  add_block (&empty, "b", -1, 1, 0, 1);
  add_axle (&empty, 0);
  empty.vehicles[0].axle_count = 0;
  g_assert_cmpint (qn_model_prepare (&empty, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_VEHICLE_EMPTY);

  test_model_init (&before);
  add_block (&before, "b", -1, 1, 0, 1);
  add_axle (&before, 0);
  before.vehicles[0].axles[0].at = -1.5;
  g_assert_cmpint (qn_model_prepare (&before, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NEGATIVE);
}

QN_TESTS
{
  g_test_add_func ("/disperse/widths", test_widths);
  g_test_add_func ("/disperse/across", test_across);
  g_test_add_func ("/disperse/boussinesq", test_boussinesq);
  g_test_add_func ("/disperse/beside", test_beside);
  g_test_add_func ("/disperse/line-of-sight", test_line_of_sight);
  g_test_add_func ("/disperse/slopes", test_slopes);
  g_test_add_func ("/disperse/lines", test_lines);
  g_test_add_func ("/disperse/bare", test_bare);
  g_test_add_func ("/disperse/refused", test_refused);
}
