/* The examples by hand of docs/method/capacity.md. */
#include "core/capacity/capacity.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <stdlib.h>

#define G 9.81

static void
check_close (double value, double expected, double tolerance)
{
  g_test_message ("%.6g, by hand %.6g", value, expected);
  g_assert_cmpfloat (fabs (value / expected - 1), <, tolerance);
}

/* A result with these multipliers and horizontal displacements: count rows of the blocks' ux. */
static void
init_result (QnResult *result, const QnModel *model, const double *multipliers,
             const double *ux, size_t count)
{
  g_autofree double *row = g_new0 (double, QN_DOF_COUNT * model->block_count);
  g_assert_cmpint (qn_result_init (result, model->block_count, 0, NULL), ==, QN_OK);
  for (size_t i = 0; i < count; i++) {
    for (size_t b = 0; b < model->block_count; b++)
      row[QN_DOF_COUNT * b] = ux[i * model->block_count + b];
    QnStep step = { .multiplier = multipliers[i] };
    g_assert_true (qn_result_add_step (result, step, row));
  }
}

/* A rigid block of 0.6 x 3 m that turns about its corner: lambda = tan(alpha - theta), its centroid
 * moves by R (sin alpha - sin(alpha - theta)). */
static void
test_rigid_block (void)
{
  enum { COUNT = 401 };
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  QnCapacity capacity;
  double multipliers[COUNT + 1] = { 0 }, ux[2 * (COUNT + 1)] = { 0 };
  const double alpha = atan (0.2), radius = 0.5 * hypot (0.6, 3);
  test_model_init_block_on_plane (&model, 0.6, 3);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  for (int i = 0; i < COUNT;
       i++) { /* the first step is the dead load, then it stands at its peak */
    double theta = alpha * 1.02 * i / (COUNT - 1);
    multipliers[i + 1] = tan (alpha - theta);
    ux[2 * i + 3] = radius * (sin (alpha) - sin (alpha - theta));
  }
  init_result (&result, &model, multipliers, ux, COUNT + 1);
  g_assert_cmpint (qn_capacity_init (&capacity, &model, &result, 1, NULL), ==, QN_OK);
  g_assert_cmpuint (capacity.participating, ==, 1);
  check_close (capacity.share, 1, 1e-12);
  check_close (capacity.mass, 0.6 * 3 * 10000 / G, 1e-6);
  check_close (capacity.points[capacity.peak].acceleration, 0.2 * G, 1e-6);
  g_assert_true (capacity.reaches_zero);
  check_close (capacity.end, 0.3, 1e-4);

  const QnSpectrum spectrum = { .kind = QN_SPECTRUM_EN_1,
                                .ground_acceleration = 0.25 * G,
                                .soil = QN_SOIL_C,
                                .damping = 0.05 };
  QnCapacityState slv = qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV);
  check_close (slv.capacity, 0.12, 1e-4);
  check_close (slv.acceleration, 1.16242, 1e-4);
  check_close (slv.period, 1.69577, 1e-4);
  check_close (slv.demand, 0.181719, 1e-4);
  check_close (slv.ratio, 0.66036, 2e-4);
  QnCapacityState slc = qn_capacity_check_ntc (&capacity, &spectrum, 1.2, QN_NTC_SLC);
  check_close (slc.capacity, 0.18, 1e-4);
  check_close (slc.acceleration, 0.772045 / 1.2, 2e-4);
  check_close (slc.period, 1.56 * G_PI * sqrt (0.18 * 1.2 / 0.772045), 2e-4);
  qn_capacity_clear (&capacity);
}

/* Two equal blocks, the upper one moving twice as far as the lower: e* = 9/10, d* = 5/3 of the lower
 * block's; a multiplier that rises to 0.3 at 0.01 m and falls to zero at 0.16 m. */
static void
test_two_blocks (void)
{
  const double multipliers[] = { 0, 0.3, 0 };
  const double ux[] = { 0, 0, 0, 0, 0.01, 0.02, 0, 0.16, 0.32 };
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  QnCapacity capacity;
  test_model_init_stack (&model, 2, 0.5, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  init_result (&result, &model, multipliers, ux, 3);
  g_assert_cmpint (qn_capacity_init (&capacity, &model, &result, 1, NULL), ==, QN_OK);
  check_close (capacity.share, 0.9, 1e-9);
  check_close (capacity.ratio, 5.0 / 3, 1e-9);
  check_close (capacity.end, 0.16 * 5 / 3, 1e-9);
  check_close (capacity.points[1].acceleration, 0.3 * G / 0.9, 1e-9);

  /* EN: a_y = 3.27, d_m = 1/60; E = a_y d_m/2, so d_y = d_m and T = 2 pi sqrt(d_y/a_y) = 0.44858 s,
   * less than TC; with ag = 5 m/s2 on soil B S_e = 15 m/s2, q = 4.5872, d_et = 0.076453 m and
   * d_t = d_et/q (1 + (q - 1) 0.5/T) = 0.083306 m. The multiplier is at four fifths of its peak
   * at a fifth of the way down: 1/60 + 0.2 (0.266667 - 1/60) = 0.0666667 m. */
  const QnSpectrum spectrum = {
    .kind = QN_SPECTRUM_EN_1, .ground_acceleration = 5, .soil = QN_SOIL_B, .damping = 0.05
  };
  QnEnDemand demand = qn_capacity_en_demand (&capacity, &spectrum);
  check_close (demand.yield_acceleration, 3.27, 1e-6);
  check_close (demand.energy, 3.27 / 120, 1e-6);
  check_close (demand.yield, 1.0 / 60, 1e-6);
  check_close (demand.period, 0.44858, 1e-4);
  check_close (demand.q, 4.58716, 1e-5);
  check_close (demand.elastic, 0.0764526, 1e-4);
  check_close (demand.target, 0.083306, 1e-4);
  QnCapacityState nc = qn_capacity_check_en (&capacity, &demand, QN_EN_NC);
  QnCapacityState sd = qn_capacity_check_en (&capacity, &demand, QN_EN_SD);
  check_close (nc.capacity, 1.0 / 15, 1e-9);
  check_close (nc.ratio, 0.80026, 1e-4);
  check_close (sd.capacity, 0.05, 1e-9);
  qn_capacity_clear (&capacity);
}

/* Nine equal blocks that overturn as one: the lowest moves a seventeenth as far as the highest. All of them take part: e* = (sum of odd numbers)^2 / (n sum of their squares). A block
 * beside them springs back as the multiplier falls and takes no part; its mass is told. */
static void
test_all_that_overturn (void)
{
  enum { BLOCKS = 9, ROWS = BLOCKS + 2 };
  const double multipliers[] = { 0, 0.3, 0 };
  double ux[3 * ROWS] = { 0 }, sum = 0, squares = 0;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  QnCapacity capacity;
  test_model_init_stack (&model, BLOCKS + 1, 0.5, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  for (int i = 0; i < BLOCKS; i++) {
    double part = 2 * i + 1;
    ux[ROWS + 1 + i] = 1e-3 * part;
    ux[2 * ROWS + 1 + i] = 1e-2 * part;
    sum += part;
    squares += part * part;
  }
  ux[ROWS + 1 + BLOCKS] = 1e-3;
  init_result (&result, &model, multipliers, ux, 3);
  g_assert_cmpint (qn_capacity_init (&capacity, &model, &result, BLOCKS, NULL), ==,
                   QN_OK);
  g_assert_cmpuint (capacity.participating, ==, BLOCKS);
  check_close (capacity.share, sum * sum / (BLOCKS * squares), 1e-9);
  check_close (capacity.left_out, model.blocks[1].weight / model.gravity, 1e-9);
  qn_capacity_clear (&capacity);
}

/* A period that half the stiffness changes by more than a fifth of it is that of the stiffness: the check is
 * refused. Joints twice as soft let the peak be twice as far: by a root of two for EN 1998-3; where the curve
 * comes back to zero is where it was. */
static void
test_soft_periods (void)
{
  const double multipliers[] = { 0, 0.3, 0 };
  const QnSpectrum spectrum = {
    .kind = QN_SPECTRUM_EN_1, .ground_acceleration = 5, .soil = QN_SOIL_B, .damping = 0.05
  };
  QnCapacity capacity[2];
  for (int soft = 0; soft < 2; soft++) {
    const double peak = soft ? 0.002 : 0.001;
    const double ux[] = { 0, 0, 0, peak, 0, 0.16 };
    g_auto (QnModel) model;
    g_auto (QnResult) result;
    test_model_init_block_on_plane (&model, 0.6, 3);
    test_model_add_weight_loads (&model, 1);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    init_result (&result, &model, multipliers, ux, 3);
    g_assert_cmpint (qn_capacity_init (&capacity[soft], &model, &result, 1, NULL), ==,
                     QN_OK);
  }
  QnEnDemand demand = qn_capacity_en_demand (&capacity[0], &spectrum);
  g_assert_false (qn_capacity_check_en (&capacity[0], &demand, QN_EN_NC).refused);
  capacity[0].softer = malloc (sizeof capacity[1]);
  *capacity[0].softer = capacity[1];
  demand = qn_capacity_en_demand (&capacity[0], &spectrum);
  QnCapacityState nc = qn_capacity_check_en (&capacity[0], &demand, QN_EN_NC);
  g_assert_true (nc.refused && isnan (nc.ratio));
  check_close (nc.softer / nc.period, sqrt (2), 1e-9);
  QnCapacityState slv = qn_capacity_check_ntc (&capacity[0], &spectrum, 1, QN_NTC_SLV);
  g_assert_true (!slv.refused && slv.ratio > 0);
  check_close (slv.softer / slv.period, 1, 0.01);
  qn_capacity_clear (&capacity[0]);
}

/* A block that slips at its peak, and a curve that ends before it has fallen by a fifth: near collapse is its
 * end. A load of another set, that does not grow, counts for nothing. Spectra of points ask for the largest
 * displacement up to the period: here 4 m/s2 at 0.4 s, less at all others. */
static void
test_ends_early (void)
{
  const double multipliers[] = { 0, 0.3, 0.28, 0.26 };
  const double ux[] = { 0, 0, 0, 0.01, 0, 0.01, 0, 0.05 };
  const QnVec2 points[] = { { 0, 0.1 }, { 0.4, 4 }, { 0.42, 0.1 } };
  const QnSpectrum spectrum = {
    .kind = QN_SPECTRUM_POINTS, .points = points, .point_count = 3, .damping = 0.05
  };
  const QnSpectrum weak = {
    .kind = QN_SPECTRUM_EN_1, .ground_acceleration = 1, .soil = QN_SOIL_A, .damping = 0.05
  };
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  QnCapacity capacity;
  test_model_init_block_on_plane (&model, 0.6, 3);
  test_model_add_weight_loads (&model, 1);
  QnLoad *other = qn_model_add_live_load (&model);
  other->kind = QN_LOAD_WEIGHT;
  other->vector = qn_vec2 (0, -1);
  other->set = qn_model_add_load_set (&model, "other");
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  init_result (&result, &model, multipliers, ux, 4);
  g_assert_cmpint (qn_capacity_init (&capacity, &model, &result, 1, NULL), ==, QN_OK);
  g_assert_false (capacity.reaches_zero);
  check_close (capacity.end, 0.05, 1e-12);
  check_close (qn_capacity_acceleration (&capacity, 0.01), 0.3 * G, 1e-12);
  check_close (qn_capacity_acceleration (&capacity, 0.03), 0.27 * G, 1e-12);

  QnEnDemand demand = qn_capacity_en_demand (&capacity, &weak);
  g_assert_cmpfloat (demand.q, <, 1);
  g_assert_cmpfloat (demand.target, ==, demand.elastic); /* it stays elastic */
  QnCapacityState nc = qn_capacity_check_en (&capacity, &demand, QN_EN_NC);
  check_close (nc.capacity, capacity.end, 1e-12);
  QnCapacityState slv = qn_capacity_check_ntc (&capacity, &spectrum, 1, QN_NTC_SLV);
  g_assert_cmpfloat (slv.period, >, 0.4);
  check_close (slv.demand, 4 * 0.16 / (4 * G_PI * G_PI), 1e-9);
  qn_capacity_clear (&capacity);
}

static QnProblem
refusal (QnModel *model, const double *multipliers, const double *ux, QnId control)
{
  g_auto (QnResult) result;
  QnCapacity capacity;
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  init_result (&result, model, multipliers, ux, 2);
  g_assert_cmpint (qn_capacity_init (&capacity, model, &result, control, &diag), ==,
                   QN_ERROR_INVALID);
  g_assert_null (capacity.points);
  qn_model_clear (model);
  return diag.problem;
}

static void
test_refuse (void)
{
  const double multipliers[] = { 0, 1 }, along[] = { 0, 0, 0, 1 },
               against[] = { 0, 0, 0, -1 };
  QnModel model;
  test_model_init_block_on_plane (&model, 1, 1);
  g_assert_cmpint (refusal (&model, multipliers, along, 1), ==, QN_PROBLEM_NO_LIVE_LOAD);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector.y = 0.1;
  g_assert_cmpint (refusal (&model, multipliers, along, 1), ==,
                   QN_PROBLEM_CAPACITY_LOADS);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (refusal (&model, multipliers, against, 1), ==,
                   QN_PROBLEM_CAPACITY_MOTION);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (refusal (&model, multipliers, along, 0), ==,
                   QN_PROBLEM_CAPACITY_MOTION);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].kind = QN_LOAD_FORCE;
  model.live_loads[0].block = 1;
  g_assert_cmpint (refusal (&model, multipliers, along, 1), ==,
                   QN_PROBLEM_CAPACITY_LOADS);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (refusal (&model, multipliers, (double[4]){ 0 }, 1), ==,
                   QN_PROBLEM_CAPACITY_MOTION); /* nothing moves */
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  g_assert_cmpint (refusal (&model, (double[2]){ 1, 0 }, along, 1), ==,
                   QN_PROBLEM_CAPACITY_MOTION); /* the peak is at rest */
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 0); /* in no direction */
  g_assert_cmpint (refusal (&model, multipliers, along, 1), ==,
                   QN_PROBLEM_CAPACITY_MOTION);
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.gravity = 0; /* no mass can be told from a weight */
  g_assert_cmpint (refusal (&model, multipliers, along, 1), ==, QN_PROBLEM_NOT_POSITIVE);
}

/* Beams have no capacity curve; loads of another set do not turn the direction of those that grow. */
static void
test_other_loads (void)
{
  const QnModel beams = { .live_load_count = 1, .beam_count = 1 };
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_capacity_check_model (&beams, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_CAPACITY_BEAMS);
  g_auto (QnModel) model = { 0 };
  test_model_init_block_on_plane (&model, 1, 1);
  test_model_add_weight_loads (&model, 1);
  QnLoad *other = qn_model_add_live_load (&model);
  other->kind = QN_LOAD_WEIGHT;
  other->vector = qn_vec2 (-5, 0);
  other->set = qn_model_add_load_set (&model, "other");
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpfloat (qn_capacity_direction (&model), ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/capacity/other-loads", test_other_loads);
  g_test_add_func ("/capacity/rigid-block", test_rigid_block);
  g_test_add_func ("/capacity/two-blocks", test_two_blocks);
  g_test_add_func ("/capacity/all-that-overturn", test_all_that_overturn);
  g_test_add_func ("/capacity/soft-periods", test_soft_periods);
  g_test_add_func ("/capacity/ends-early", test_ends_early);
  g_test_add_func ("/capacity/refuse", test_refuse);
}
