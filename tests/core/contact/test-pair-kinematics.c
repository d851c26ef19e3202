#include "core/contact/pair-kinematics.h"
#include "support/room.h"

#include <glib.h>

static void
random_pair (GRand *random, QnPairKinematics *pair, double v[6], double rotation)
{
  double angle = g_rand_double_range (random, 0, 2 * G_PI);
  QnVec2 arm_a = qn_vec2 (g_rand_double_range (random, -1, 1), 0.4);
  QnVec2 arm_b = qn_vec2 (-0.3, g_rand_double_range (random, -1, 1));

  qn_pair_kinematics_init (pair, qn_vec2 (cos (angle), sin (angle)), arm_a, arm_b, 0.7);
  for (int i = 0; i < 6; i++)
    v[i] = g_rand_double_range (random, -1, 1) * rotation;
}

/* By which factor of the gradient an unknown enters, and with which sign. */
static const int factor[6] = { 1, 2, 0, 1, 2, 3 };
static const double sign[6] = { -1, -1, 1, 1, 1, 1 };

static double
entry (const QnPairKinematics *pair, int row, int unknown)
{
  return sign[unknown] * qn_pair_kinematics_gradient (pair).factors[row][factor[unknown]];
}

/* Gradient against differences of the elongation, geometric stiffness against differences of
 * the gradient, at rotations of any size. */
static void
test_derivatives (void)
{
  const double force[2] = { -3.0, 1.7 }, h = 1e-6;
  g_autoptr (GRand) random = g_rand_new_with_seed (17);

  for (int k = 0; k < 200; k++) {
    QnPairKinematics pair, plus, minus;
    double v[6], k4[QN_PAIR_FACTORS][QN_PAIR_FACTORS] = { { 0 } }, stiffness[6][6];
    random_pair (random, &pair, v, 3);
    if (k % 2 == 1) /* a corner on a side */
      qn_pair_kinematics_set_corner (&pair, qn_vec2 (0.3, -0.8));
    qn_pair_kinematics_update (&pair, 1, v);
    qn_pair_kinematics_add_stiffness (&pair, force, k4);
    for (int i = 0; i < 6; i++)
      for (int j = 0; j < 6; j++)
        stiffness[i][j] = sign[i] * sign[j] * k4[factor[i]][factor[j]];

    for (int j = 0; j < 6; j++) {
      double kept = v[j];
      plus = minus = pair;
      v[j] = kept + h;
      qn_pair_kinematics_update (&plus, 1, v);
      v[j] = kept - h;
      qn_pair_kinematics_update (&minus, 1, v);
      v[j] = kept;
      for (int i = 0; i < 2; i++)
        g_assert_cmpfloat_with_epsilon (
          entry (&pair, i, j), (plus.elongation[i] - minus.elongation[i]) / (2 * h),
          1e-7);
      for (int i = 0; i < 6; i++) {
        double slope = 0;
        for (int c = 0; c < 2; c++)
          slope += force[c] * (entry (&plus, c, i) - entry (&minus, c, i)) / (2 * h);
        g_assert_cmpfloat_with_epsilon (stiffness[i][j], slope, 1e-6);
        g_assert_cmpfloat_with_epsilon (stiffness[i][j], stiffness[j][i], 1e-14);
      }
    }
  }
}

/* A rigid motion of both blocks, however large, strains nothing and turns the frame. */
static void
test_objectivity (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (19);

  for (int k = 0; k < 100; k++) {
    QnPairKinematics pair;
    double v[6], rz = g_rand_double_range (random, -3, 3);
    random_pair (random, &pair, v, 0);
    QnVec2 a = qn_vec2_scale (-1, pair.arm_a), b = qn_vec2_scale (-1, pair.arm_b);
    QnVec2 turned_a = qn_vec2_rotate (a, cos (rz), sin (rz));
    QnVec2 turned_b = qn_vec2_rotate (b, cos (rz), sin (rz));
    v[0] = 5 + turned_a.x - a.x;
    v[1] = -2 + turned_a.y - a.y;
    v[3] = 5 + turned_b.x - b.x;
    v[4] = -2 + turned_b.y - b.y;
    v[2] = v[5] = rz * pair.length;
    qn_pair_kinematics_update (&pair, 1, v);
    g_assert_cmpfloat_with_epsilon (pair.elongation[0], 0, 1e-14);
    g_assert_cmpfloat_with_epsilon (pair.elongation[1], 0, 1e-14);
    g_assert_cmpfloat_with_epsilon (
      qn_vec2_dot (pair.frame, qn_vec2_rotate (pair.normal, cos (rz), sin (rz))), 1,
      1e-14);
  }
}

/* For small displacements both geometries agree, to second order. */
static void
test_small_displacements (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (23);

  for (int k = 0; k < 100; k++) {
    QnPairKinematics pair;
    double v[6];
    random_pair (random, &pair, v, 1e-6);
    QnPairGradient gradient = qn_pair_kinematics_gradient (&pair);
    const double motion[QN_PAIR_FACTORS] = { v[2], v[3] - v[0], v[4] - v[1], v[5] };
    qn_pair_kinematics_update (&pair, 1, v);
    for (int i = 0; i < 2; i++) {
      double linear = 0;
      for (int j = 0; j < QN_PAIR_FACTORS; j++)
        linear += gradient.factors[i][j] * motion[j];
      g_assert_cmpfloat_with_epsilon (linear, pair.elongation[i], 3e-11);
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/pair-kinematics/derivatives", test_derivatives);
  g_test_add_func ("/pair-kinematics/objectivity", test_objectivity);
  g_test_add_func ("/pair-kinematics/small-displacements", test_small_displacements);
}
