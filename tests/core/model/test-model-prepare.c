#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static void
test_derives (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  const QnVec2 clockwise[] = { { 1, 1 }, { 1, 3 }, { 4, 3 }, { 4, 1 } };
  QnBlock *block = qn_model_add_block (&model, "b", clockwise, 4);
  block->thickness = 0.5;
  block->density = 2000;
  test_model_add_rectangle (&model, "c", 10, 0, 2, 2);
  test_model_add_rectangle (&model, "big", 20, 0, 100, 100);
  model.gravity = 10;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);

  block = &model.blocks[0];
  g_assert_cmpfloat (block->area, ==, 6);
  g_assert_cmpfloat (block->centroid.x, ==, 2.5);
  g_assert_cmpfloat (block->centroid.y, ==, 2);
  g_assert_cmpfloat_with_epsilon (block->polar_moment, 6 * (9 + 4) / 12.0, 1e-13);
  g_assert_cmpfloat (block->unit_weight, ==, 20000);
  g_assert_cmpfloat (block->weight, ==, 60000);
  const QnVec2 *v = qn_model_block_vertices (&model, 0);
  g_assert_cmpfloat (v[0].x, ==, 1);
  g_assert_cmpfloat (v[1].x, ==, 4); /* counter-clockwise, from the same vertex */
  g_assert_cmpfloat (model.characteristic_length, ==, sqrt (6));
}

static void
test_twice_is_once (void)
{
  g_auto (QnModel) model;
  test_model_init_wall (&model, 2, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  double weight = model.blocks[7].weight;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpuint (model.block_count, ==, 56);
  g_assert_cmpfloat (model.blocks[7].weight, ==, weight);
}

/* A drawing begins without blocks. */
static void
test_no_blocks (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpfloat (model.characteristic_length, ==, 0);
}

/* What overflows only when multiplied out. */
static void
test_weight_overflows (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init_block_on_plane (&model, 1e3, 1e3);
  model.blocks[1].unit_weight = 1e305;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_TOO_LARGE);
  g_assert_cmpint (diag.index, ==, 1);
  g_assert_cmpstr (diag.field, ==, "unit_weight");
}

QN_TESTS
{
  g_test_add_func ("/model-prepare/derives", test_derives);
  g_test_add_func ("/model-prepare/twice-is-once", test_twice_is_once);
  g_test_add_func ("/model-prepare/no-blocks", test_no_blocks);
  g_test_add_func ("/model-prepare/weight-overflows", test_weight_overflows);
}
