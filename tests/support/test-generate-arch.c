#include "support/contacts.h"
#include "support/generate.h"
#include "support/room.h"

#include <glib.h>

static void
test_arch (void)
{
  const double embraces[] = { G_PI, G_PI / 2, 1 };
  for (int segments = 1; segments <= 4; segments += 3) {
    for (size_t e = 0; e < G_N_ELEMENTS (embraces); e++) {
      g_auto (QnModel) model;
      g_auto (QnContacts) contacts;
      QnArchRecipe recipe = qn_arch_recipe_default ();
      recipe.segments = segments;
      recipe.embrace = embraces[e];
      qn_model_init (&model);
      g_assert_cmpint (qn_generate_arch (&model, &recipe, NULL), ==, QN_OK);
      test_detect_sound (&model, &contacts);
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
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/generate-arch/semicircle-and-segments", test_arch);
}
