#include "support/contacts.h"
#include "support/generate.h"
#include "support/room.h"

#include <glib.h>

static void
test_column (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnColumnRecipe recipe = qn_column_recipe_default ();
  recipe.material.stiffness = 1e9; /* as drums of a ton and more need */
  qn_model_init (&model);
  g_assert_cmpint (qn_generate_column (&model, &recipe, NULL), ==, QN_OK);
  test_detect_sound (&model, &contacts);
  g_assert_cmpuint (model.block_count, ==, 7);
  g_assert_cmpuint (contacts.face_count, ==, 6);
  g_assert_cmpfloat_with_epsilon (contacts.faces[0].length, 1.0, 1e-14);
  g_assert_cmpfloat_with_epsilon (contacts.faces[3].length, 0.9, 1e-14);
}

QN_TESTS
{
  g_test_add_func ("/generate-column/tapered", test_column);
}
