#include "core/result/curve-motion.h"

#include "support/models.h"
#include "support/room.h"

#include <glib.h>

enum { STEPS = 3 };

/* A base that is moved far, a block that settles by 9 and moves on by 3 to the left before it comes
 * back, one that settles by more and moves on by less: "base", "b1", "b2". */
static double rows[STEPS][9] = {
  { 0, 0, 0, 0, -5, 0, 0, -9, 0 },
  { 0, -50, 0, -3, -5.5, 0, 0.5, -9.2, 0 },
  { 0, -90, 0, -1, -5.5, 0, 1, -9.5, 0 },
};

static void
init (QnModel *model, QnResult *result)
{
  test_model_init_stack (model, 2, 1.0, 0.5);
  test_model_add_weight_loads (model, 1);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_result_init (result, 3, 0, NULL), ==, QN_OK);
  for (int s = 0; s < STEPS; s++)
    g_assert_true (qn_result_add_step (result, (QnStep){ .multiplier = s }, rows[s]));
}

static void
clear (QnModel *model, QnResult *result)
{
  qn_result_clear (result);
  qn_model_clear (model);
}

/* What moves under the growing load, though the dead load has moved others further. */
static void
test_moves_since_dead_load (void)
{
  QnModel model;
  QnResult result;
  init (&model, &result);
  QnCurveMotion motion = qn_result_curve_motion (&model, &result);
  g_assert_cmpint (motion.body, ==, 1);
  g_assert_cmpint (motion.dof, ==, QN_DOF_UX);
  g_assert_true (motion.since_dead);
  motion.dof = QN_DOF_UY;
  g_assert_cmpfloat (qn_curve_motion_at (&result, motion, 0), ==, 0);
  g_assert_cmpfloat (qn_curve_motion_at (&result, motion, 2), ==, -0.5);
  clear (&model, &result);
}

/* The displacement that the analysis controls is told as its target is. */
static void
test_controlled (void)
{
  QnModel model;
  QnResult result;
  init (&model, &result);
  model.analysis.control.block = 2;
  model.analysis.control.dof = QN_DOF_UY;
  QnCurveMotion motion = qn_result_curve_motion (&model, &result);
  g_assert_cmpint (motion.body, ==, 2);
  g_assert_cmpint (motion.dof, ==, QN_DOF_UY);
  g_assert_cmpfloat (qn_curve_motion_at (&result, motion, 2), ==, -9.5);
  clear (&model, &result);
}

static void
test_nothing (void)
{
  QnModel model;
  QnResult result;
  init (&model, &result);
  result.step_count = 0;
  g_assert_cmpint (qn_result_curve_motion (&model, &result).body, ==, QN_NONE);
  clear (&model, &result);
}

QN_TESTS
{
  g_test_add_func ("/core/curve-motion/since-dead-load", test_moves_since_dead_load);
  g_test_add_func ("/core/curve-motion/controlled", test_controlled);
  g_test_add_func ("/core/curve-motion/nothing", test_nothing);
}
