#include "support/contacts.h"
#include "support/generate.h"
#include "support/room.h"

#include <glib.h>

/* Plain running bond: courses of 4, 5, 4 blocks; every inner joint counted by hand. */
static void
test_plain_wall (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = 4;
  recipe.courses = 3;
  qn_model_init (&model);
  g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
  test_detect_sound (&model, &contacts);
  g_assert_cmpuint (model.block_count, ==, 1 + 4 + 5 + 4);
  g_assert_cmpuint (contacts.face_count, ==, (3 + 4 + 3) + 4 + 8 + 8);
}

/* Whatever the seed: sound, without findings, the openings really there. */
static void
test_openings (void)
{
  for (uint64_t seed = 1; seed <= 40; seed++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    QnWallRecipe recipe = qn_wall_recipe_default ();
    recipe.length = 20;
    recipe.courses = 25;
    recipe.material.stiffness = 1e9;
    recipe.openings = (int32_t) (seed % 12);
    recipe.seed = seed;
    qn_model_init (&model);
    g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
    test_detect_sound (&model, &contacts);

    double area = 0, gross = 20 * 25 * 0.4 * 0.175;
    for (size_t i = 1; i < model.block_count; i++)
      area += model.blocks[i].area;
    if (recipe.openings == 0)
      g_assert_cmpfloat_with_epsilon (area, gross, 1e-9);
    else
      g_assert_cmpfloat (area, <, gross - 0.4 * 0.35 + 1e-9);
  }
}

static void
test_same_seed_same_wall (void)
{
  QnModel models[3];
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = recipe.courses = 30;
  recipe.openings = 10;
  for (int i = 0; i < 3; i++) {
    recipe.seed = i < 2 ? 5 : 6;
    qn_model_init (&models[i]);
    g_assert_cmpint (qn_generate_wall (&models[i], &recipe, NULL), ==, QN_OK);
    g_assert_cmpint (qn_model_prepare (&models[i], NULL), ==, QN_OK);
  }
  g_assert_cmpmem (models[0].vertices, models[0].vertex_count * sizeof (QnVec2),
                   models[1].vertices, models[1].vertex_count * sizeof (QnVec2));
  g_assert_cmpuint (models[2].vertex_count, !=, models[0].vertex_count);
  for (int i = 0; i < 3; i++)
    qn_model_clear (&models[i]);
}

QN_TESTS
{
  g_test_add_func ("/generate-wall/plain", test_plain_wall);
  g_test_add_func ("/generate-wall/openings", test_openings);
  g_test_add_func ("/generate-wall/same-seed", test_same_seed_same_wall);
}
