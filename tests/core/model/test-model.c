#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static void
test_defaults (void)
{
  QnModel model;
  qn_model_init (&model);
  g_assert_cmpfloat (model.gravity, ==, 9.81);
  g_assert_cmpfloat (model.contact.tolerance, ==, 1e-6);
  g_assert_cmpint (model.contact.law, ==, QN_NONE);
  g_assert_cmpint (model.contact.pairs.placement, ==, QN_PLACEMENT_DEFAULT);
  g_assert_cmpfloat (model.contact.pairs.offset, ==, 0);
  g_assert_cmpint (model.analysis.procedure, ==, QN_PROCEDURE_LOAD);
  g_assert_cmpint (model.analysis.increments, ==, 100);
  g_assert_true (isinf (model.analysis.max_multiplier));
  g_assert_cmpfloat (model.analysis.multiplier_tolerance, ==, 1e-4);
  g_assert_cmpfloat (model.analysis.residual_tolerance, ==, 1e-8);
  g_assert_cmpint (model.analysis.control.block, ==, QN_NONE);
  qn_model_clear (&model);
  g_assert_cmpuint (model.block_count, ==, 0);
  qn_model_clear (&model); /* a zeroed model may be cleared */
}

static void
test_find (void)
{
  g_auto (QnModel) model;
  test_model_init_stack (&model, 3, 1, 0.5);
  g_assert_cmpint (qn_model_find_block (&model, "b2"), ==, 2);
  g_assert_cmpint (qn_model_find_block (&model, "b4"), ==, QN_NONE);
  g_assert_cmpint (qn_model_find_law (&model, "joint"), ==, 0);
  g_assert_cmpint (qn_model_find_law (&model, "mortar"), ==, QN_NONE);
}

static void
test_copy_is_deep (void)
{
  QnModel model, copy;
  test_model_init_wall (&model, 3, 0);
  qn_model_add_override (&model);
  model.title = g_strdup ("Wall 3");
  g_assert_cmpint (qn_model_expand_walls (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
  g_assert_true (copy.title != model.title && copy.vertices != model.vertices
                 && copy.blocks[4].name != model.blocks[4].name
                 && copy.walls[0].lengths != model.walls[0].lengths);
  g_assert_cmpuint (copy.block_count, ==, 47);
  g_assert_cmpstr (copy.title, ==, "Wall 3");
  g_free (model.title);
  model.title = NULL;
  qn_model_clear (&model);

  g_assert_cmpint (qn_model_find_block (&copy, "w.2.3"), >, 0);
  g_assert_cmpint (copy.override_count, ==, 1);
  /* The copy grows by itself. */
  const double course[] = { 1, 1 };
  g_assert_true (qn_wall_add_course (&copy.walls[0], course, 2));
  g_assert_nonnull (qn_model_add_law (&copy, "other"));
  test_model_add_rectangle (&copy, "extra", 10, 0, 1, 1);
  g_assert_cmpint (qn_model_find_block (&copy, "extra"), ==, 47);
  qn_model_clear (&copy);
}

static void
test_copy_of_empty (void)
{
  g_auto (QnModel) model, copy;
  qn_model_init (&model);
  g_assert_cmpint (qn_model_copy (&model, &copy, NULL), ==, QN_OK);
}

static void
test_many_blocks (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  for (int i = 0; i < 20000; i++) {
    char name[16];
    g_snprintf (name, sizeof name, "b%d", i);
    test_model_add_rectangle (&model, name, i, 0, 1, 1);
  }
  g_assert_cmpint (qn_model_find_block (&model, "b19999"), ==, 19999);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
}

QN_TESTS
{
  g_test_add_func ("/model/defaults", test_defaults);
  g_test_add_func ("/model/find", test_find);
  g_test_add_func ("/model/copy/deep", test_copy_is_deep);
  g_test_add_func ("/model/copy/empty", test_copy_of_empty);
  g_test_add_func ("/model/many-blocks", test_many_blocks);
}
