#include "support/auto-clear.h"
#include "support/generate.h"
#include "support/room.h"

#include <glib.h>

/* What all recipes add besides blocks. */
static void
test_material_and_loads (void)
{
  QnModel models[3];
  for (int i = 0; i < 3; i++)
    qn_model_init (&models[i]);
  QnWallRecipe wall = qn_wall_recipe_default ();
  QnArchRecipe arch = qn_arch_recipe_default ();
  QnColumnRecipe column = qn_column_recipe_default ();
  wall.material.friction = arch.material.friction = column.material.friction = 0.5;
  wall.material.thickness = arch.material.thickness = column.material.thickness = 0.3;
  g_assert_cmpint (qn_generate_wall (&models[0], &wall, NULL), ==, QN_OK);
  g_assert_cmpint (qn_generate_arch (&models[1], &arch, NULL), ==, QN_OK);
  g_assert_cmpint (qn_generate_column (&models[2], &column, NULL), ==, QN_OK);

  for (int i = 0; i < 3; i++) {
    QnModel *model = &models[i];
    g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
    g_assert_cmpint (model->contact.law, ==, qn_model_find_law (model, "joint"));
    g_assert_cmpint (model->laws[0].kind, ==, QN_LAW_COULOMB);
    g_assert_cmpfloat (model->laws[0].friction, ==, 0.5);
    g_assert_cmpfloat (model->laws[0].dilatancy, ==, 0);
    g_assert_cmpuint (model->dead_load_count, ==, 1);
    g_assert_cmpuint (model->live_load_count, ==, 1);
    g_assert_cmpfloat (model->dead_loads[0].vector.y, ==, -1);
    g_assert_cmpfloat (model->live_loads[0].vector.x, ==, 1);
    for (size_t b = 0; b < model->block_count; b++) {
      g_assert_cmpfloat (model->blocks[b].thickness, ==, 0.3);
      g_assert_cmpfloat (model->blocks[b].unit_weight, ==, 20000);
    }
    qn_model_clear (model);
  }
}

static void
check_refused (QnStatus status, const QnDiag *diag, QnProblem problem, const char *field,
               QnModel *model)
{
  g_assert_cmpint (status, ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag->problem, ==, problem);
  g_assert_cmpstr (diag->field, ==, field);
  g_assert_cmpuint (model->law_count + model->block_count + model->wall_count, ==, 0);
}

static void
test_refuses (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  qn_model_init (&model);

  QnWallRecipe wall = qn_wall_recipe_default ();
  wall.courses = 0;
  check_refused (qn_generate_wall (&model, &wall, &diag), &diag, QN_PROBLEM_NOT_POSITIVE,
                 "courses", &model);
  wall.courses = 1000000000;
  check_refused (qn_generate_wall (&model, &wall, &diag), &diag,
                 QN_PROBLEM_TOO_MANY_BLOCKS, "courses", &model);
  wall = qn_wall_recipe_default ();
  wall.unit.y = NAN;
  check_refused (qn_generate_wall (&model, &wall, &diag), &diag, QN_PROBLEM_NOT_FINITE,
                 "unit", &model);
  wall = qn_wall_recipe_default ();
  wall.material.friction = -1;
  check_refused (qn_generate_wall (&model, &wall, &diag), &diag, QN_PROBLEM_NEGATIVE,
                 "friction", &model);

  QnArchRecipe arch = qn_arch_recipe_default ();
  arch.ring = 2;
  check_refused (qn_generate_arch (&model, &arch, &diag), &diag, QN_PROBLEM_TOO_LARGE,
                 "ring", &model);
  arch = qn_arch_recipe_default ();
  arch.embrace = 4;
  check_refused (qn_generate_arch (&model, &arch, &diag), &diag, QN_PROBLEM_TOO_LARGE,
                 "embrace", &model);
  arch = qn_arch_recipe_default ();
  arch.segments = INT32_MAX;
  check_refused (qn_generate_arch (&model, &arch, &diag), &diag,
                 QN_PROBLEM_TOO_MANY_BLOCKS, "segments", &model);

  QnColumnRecipe column = qn_column_recipe_default ();
  column.count = INT32_MAX;
  check_refused (qn_generate_column (&model, &column, &diag), &diag,
                 QN_PROBLEM_TOO_MANY_BLOCKS, "count", &model);
  column = qn_column_recipe_default ();
  column.top_width = 0;
  check_refused (qn_generate_column (&model, &column, &diag), &diag,
                 QN_PROBLEM_NOT_POSITIVE, "top_width", &model);
}

QN_TESTS
{
  g_test_add_func ("/generate/material-and-loads", test_material_and_loads);
  g_test_add_func ("/generate/refuses", test_refuses);
}
