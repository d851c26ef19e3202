#include "core/contacts.h"
#include "core/generate.h"

#include <glib.h>

static void
detect_sound (QnModel *model, QnContacts *contacts)
{
  QnDiag diag;
  g_assert_cmpint (qn_model_prepare (model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_require_sound (model, contacts, &diag), ==, QN_OK);
  g_assert_cmpuint (contacts->findings.count, ==, 0);
}

/* Plain running bond: courses of 4, 5, 4 blocks; every inner joint counted by hand. */
static void
test_plain_wall (void)
{
  QnModel model;
  QnContacts contacts;
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = 4;
  recipe.courses = 3;
  qn_model_init (&model);
  g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
  detect_sound (&model, &contacts);
  g_assert_cmpuint (model.block_count, ==, 1 + 4 + 5 + 4);
  g_assert_cmpuint (contacts.face_count, ==, (3 + 4 + 3) + 4 + 8 + 8);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
}

/* Whatever the seed: sound, without findings, the openings really there. */
static void
test_openings (void)
{
  for (uint64_t seed = 1; seed <= 40; seed++) {
    QnModel model;
    QnContacts contacts;
    QnWallRecipe recipe = qn_wall_recipe_default ();
    recipe.length = 20;
    recipe.courses = 25;
    recipe.openings = (int32_t) (seed % 12);
    recipe.seed = seed;
    qn_model_init (&model);
    g_assert_cmpint (qn_generate_wall (&model, &recipe, NULL), ==, QN_OK);
    detect_sound (&model, &contacts);

    double area = 0, gross = 20 * 25 * 0.4 * 0.175;
    for (size_t i = 1; i < model.block_count; i++)
      area += model.blocks[i].area;
    if (recipe.openings == 0)
      g_assert_cmpfloat_with_epsilon (area, gross, 1e-9);
    else
      g_assert_cmpfloat (area, <, gross - 0.4 * 0.35 + 1e-9);
    qn_contacts_clear (&contacts);
    qn_model_clear (&model);
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

static void
test_arch (void)
{
  const double embraces[] = { G_PI, G_PI / 2, 1 };
  for (int segments = 1; segments <= 4; segments += 3) {
    for (size_t e = 0; e < G_N_ELEMENTS (embraces); e++) {
      QnModel model;
      QnContacts contacts;
      QnArchRecipe recipe = qn_arch_recipe_default ();
      recipe.segments = segments;
      recipe.embrace = embraces[e];
      qn_model_init (&model);
      g_assert_cmpint (qn_generate_arch (&model, &recipe, NULL), ==, QN_OK);
      detect_sound (&model, &contacts);
      g_assert_cmpuint (model.block_count, ==, 29);
      g_assert_cmpuint (contacts.face_count, ==, 28);

      double sum = 0, shift = 0;
      for (size_t i = 1; i + 1 < model.block_count; i++) {
        sum += model.blocks[i].area;
        shift += model.blocks[i].area * model.blocks[i].centroid.x;
      }
      /* Area of a ring of straight pieces: each is sin (a) / a of its sector. */
      double a = recipe.embrace / (27 * segments);
      g_assert_cmpfloat_with_epsilon (sum, recipe.embrace * 0.15 * sin (a) / a, 1e-12);
      g_assert_cmpfloat_with_epsilon (shift, 0, 1e-14);
      for (size_t i = 0; i < contacts.face_count; i++)
        g_assert_cmpfloat_with_epsilon (contacts.faces[i].length, 0.15, 1e-12);
      qn_contacts_clear (&contacts);
      qn_model_clear (&model);
    }
  }
}

static void
test_column (void)
{
  QnModel model;
  QnContacts contacts;
  QnColumnRecipe recipe = qn_column_recipe_default ();
  qn_model_init (&model);
  g_assert_cmpint (qn_generate_column (&model, &recipe, NULL), ==, QN_OK);
  detect_sound (&model, &contacts);
  g_assert_cmpuint (model.block_count, ==, 7);
  g_assert_cmpuint (contacts.face_count, ==, 6);
  g_assert_cmpfloat_with_epsilon (contacts.faces[0].length, 1.0, 1e-14);
  g_assert_cmpfloat_with_epsilon (contacts.faces[3].length, 0.9, 1e-14);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
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
  QnModel model;
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
  qn_model_clear (&model);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/generate/wall/plain", test_plain_wall);
  g_test_add_func ("/generate/wall/openings", test_openings);
  g_test_add_func ("/generate/wall/same-seed", test_same_seed_same_wall);
  g_test_add_func ("/generate/arch", test_arch);
  g_test_add_func ("/generate/column", test_column);
  g_test_add_func ("/generate/refuses", test_refuses);
  return g_test_run ();
}
