#include "core/dynamics/ground.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>

static void
init_pulse (QnModel *model, QnPulseKind kind)
{
  qn_model_init (model);
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (2, 1);
  motion->scale = 0.5;
  motion->pulse = (QnPulse){ kind, 3, 0.4, 0.1 };
}

/* The mean is the integral of the acceleration, step by step. */
static void
check_means (const QnModel *model, double end)
{
  QnGround ground;
  g_assert_true (qn_ground_init (&ground, model));
  g_assert_cmpfloat (fabs (ground.end - end), <, 1e-12);
  const int parts = 20000;
  const double h = 0.0317;
  for (double t = 0; t < 2; t += h) {
    double sum = 0;
    for (int i = 0; i < parts; i++)
      sum += qn_ground_acceleration (&ground, t + h * (i + 0.5) / parts).x / parts;
    QnVec2 mean = qn_ground_mean (&ground, t, t + h);
    g_assert_cmpfloat (fabs (mean.x - sum), <, 1e-3);
    g_assert_cmpfloat (fabs (mean.x - 2 * mean.y), <, 1e-12);
  }
  qn_ground_clear (&ground);
}

static void
test_pulses (void)
{
  static const double ends[QN_PULSE_KIND_COUNT] = { 0.5, 0.5, 0.5, 0.9, 1.3 };
  for (int kind = 0; kind < QN_PULSE_KIND_COUNT; kind++) {
    g_auto (QnModel) model;
    init_pulse (&model, kind);
    check_means (&model, ends[kind]);
  }
}

static void
test_points (void)
{
  g_auto (QnModel) model;
  qn_model_init (&model);
  QnGroundMotion *motion = qn_model_add_ground_motion (&model);
  motion->direction = qn_vec2 (2, 1);
  qn_ground_motion_add_point (motion, 0.1, 0);
  qn_ground_motion_add_point (motion, 0.2, 2);
  qn_ground_motion_add_point (motion, 0.45, -1);
  qn_ground_motion_add_point (motion, 1.2, 0.5);
  check_means (&model, 1.2);
  QnGround ground;
  g_assert_true (qn_ground_init (&ground, &model));
  g_assert_cmpfloat (fabs (qn_ground_acceleration (&ground, 0.15).y - 1), <, 1e-12);
  g_assert_cmpfloat (qn_ground_acceleration (&ground, 1.3).y, ==, 0);
  qn_ground_clear (&ground);
}

/* The velocity of the ground does not depend on the steps: a jump inside of one counts in full, and
 * all changes together are the change of the whole. */
static void
test_jump (void)
{
  g_auto (QnModel) model;
  QnGround ground;
  init_pulse (&model, QN_PULSE_STEP_IMPULSE);
  g_assert_true (qn_ground_init (&ground, &model));
  g_assert_cmpfloat (fabs (qn_ground_mean (&ground, 0, 0.3).x - 3 * 0.2 / 0.3), <, 1e-12);
  g_assert_cmpfloat (fabs (qn_ground_mean (&ground, 0, 2).x), <, 1e-12);
  g_assert_cmpfloat (qn_ground_change (&ground, 0, 0.1).x, ==, 0);
  g_assert_cmpfloat (qn_ground_change (&ground, 0.1, 0.2).x, ==, 3);
  qn_ground_clear (&ground);
}

/* The square's integral over triangles and pulses, in closed form. */
static void
test_share_after (void)
{
  g_auto (QnModel) model;
  qn_model_init (&model);
  QnGroundMotion *motion = qn_model_add_ground_motion (&model);
  qn_ground_motion_add_point (motion, 1, 0);
  qn_ground_motion_add_point (motion, 2, -3);
  qn_ground_motion_add_point (motion, 4, 0);
  /* 9/3 s before the peak and twice as much after it; of that (s/2)^3 in the last s seconds. */
  static const double rows[][2] = {
    { 0, 1 }, { 1, 1 }, { 1.5, 1 - 0.125 / 3 }, { 2, 2.0 / 3 }, { 3, 2.0 / 3 / 8 },
    { 4, 0 }, { 9, 0 }
  };
  for (gsize i = 0; i < G_N_ELEMENTS (rows); i++)
    g_assert_cmpfloat_with_epsilon (qn_ground_motion_share_after (motion, rows[i][0]),
                                    rows[i][1], 1e-12);
  motion->points[1].y = 0;
  g_assert_cmpfloat (qn_ground_motion_share_after (motion, 0), ==, 0);
  motion->kind = QN_SIGNAL_PULSE;
  motion->pulse = (QnPulse){ QN_PULSE_HALF_SINE, 2, 0.8, 3 };
  g_assert_cmpfloat_with_epsilon (qn_ground_motion_share_after (motion, 3.4), 0.5, 1e-3);
  g_assert_cmpfloat_with_epsilon (qn_ground_motion_share_after (motion, 2), 1, 1e-3);
  motion->pulse.kind = QN_PULSE_STEP_IMPULSE; /* 1 : 1/4 : 1/4 in thirds */
  g_assert_cmpfloat_with_epsilon (qn_ground_motion_share_after (motion, 3.8), 1.0 / 3,
                                  1e-3);
}

QN_TESTS
{
  g_test_add_func ("/ground/pulses", test_pulses);
  g_test_add_func ("/ground/points", test_points);
  g_test_add_func ("/ground/jump", test_jump);
  g_test_add_func ("/ground/share-after", test_share_after);
}
