/* What the solver leaves out must not show: each shortcut turned off, alone and all together, on
 * the six walls and on small random walls. */
#include "solve.h"
#include "support/generate.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

enum { RANDOM_WALLS = 12 };

/* Turned off, these leave the arithmetic as it is: results are equal to the bit. */
static const unsigned exact[] = {
  QN_SHORTCUT_SAME_TANGENT,
  QN_SHORTCUT_PARTIAL_ELIMINATION,
  QN_SHORTCUT_SAME_TANGENT | QN_SHORTCUT_PARTIAL_ELIMINATION,
};

/* These lead along other increments. With dilatancy = friction the multiplier is one number, found
 * to twice its tolerance. Without dilatancy it belongs to the path, and walls that snap know more
 * than one: they may differ as with other numbers of increments (test-six-walls.c). */
static const unsigned other[] = { QN_SHORTCUT_EARLY_FAILURE, ~0u };

typedef void (*MakeModel) (QnModel *model, int number);

static void
solve (Solved *solved, MakeModel make, int number, unsigned no_shortcuts)
{
  QnModel model;
  make (&model, number);
  model.analysis.increments = 20;
  model.analysis.no_shortcuts = no_shortcuts;
  verify_solve (solved, &model);
  g_assert_cmpint (solved->result.outcome, ==, QN_OUTCOME_COLLAPSE);
}

static void
assert_same_bits (const QnResult *a, const QnResult *b)
{
  g_assert_cmpuint (a->step_count, ==, b->step_count);
  g_assert_cmpfloat (a->collapse_multiplier, ==, b->collapse_multiplier);
  g_assert_cmpfloat (a->first_limit_multiplier, ==, b->first_limit_multiplier);
  for (size_t s = 0; s < a->step_count; s++)
    g_assert_cmpfloat (a->steps[s].multiplier, ==, b->steps[s].multiplier);
  size_t count = a->step_count * a->block_count * QN_DOF_COUNT * sizeof (double);
  g_assert_cmpmem (a->displacements, count, b->displacements, count);
}

static void
check (MakeModel make, int number, gboolean snaps)
{
  Solved with, without;
  solve (&with, make, number, 0);
  double tolerance = snaps ? 0.005 : 2 * with.model.analysis.multiplier_tolerance;
  double found = with.result.collapse_multiplier;

  for (size_t i = 0; i < G_N_ELEMENTS (exact); i++) {
    solve (&without, make, number, exact[i]);
    assert_same_bits (&with.result, &without.result);
    g_assert_cmpint (without.result.statistics.factorizations, >=,
                     with.result.statistics.factorizations);
    g_assert_cmpfloat (without.result.statistics.factorization_work, >=,
                       with.result.statistics.factorization_work);
    verify_clear (&without);
  }
  for (size_t i = 0; i < G_N_ELEMENTS (other); i++) {
    solve (&without, make, number, other[i]);
    g_test_message ("%d, %zu: %.7f, %.7f", number, i, found,
                    without.result.collapse_multiplier);
    g_assert_cmpfloat (fabs (without.result.collapse_multiplier / found - 1), <,
                       tolerance);
    verify_clear (&without);
  }
  verify_clear (&with);
}

static void
make_wall (QnModel *model, int number)
{
  test_model_init_wall (model, number, 0.65);
}

static void
make_wall_without_dilatancy (QnModel *model, int number)
{
  test_model_init_wall (model, number, 0);
}

static void
make_random_wall (QnModel *model, int number)
{
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = 2 + number % 3;
  recipe.courses = 6 + number % 7;
  recipe.openings = number % 3;
  recipe.seed = (uint64_t) number;
  qn_model_init (model);
  g_assert_cmpint (qn_generate_wall (model, &recipe, NULL), ==, QN_OK);
  for (size_t law = 0; law < model->law_count; law++)
    model->laws[law].dilatancy = number % 2 == 0 ? model->laws[law].friction : 0;
}

static void
test_wall (gconstpointer data)
{
  check (make_wall, GPOINTER_TO_INT (data), FALSE);
}

static void
test_wall_without_dilatancy (gconstpointer data)
{
  check (make_wall_without_dilatancy, GPOINTER_TO_INT (data), TRUE);
}

static void
test_random_walls (void)
{
  for (int number = 1; number <= RANDOM_WALLS; number++)
    check (make_random_wall, number, number % 2 != 0);
}

QN_TESTS
{
  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++) {
    g_autofree char *associative = g_strdup_printf ("/verify/shortcuts/%d", wall);
    g_autofree char *sliding = g_strdup_printf ("/verify/shortcuts/%d/sliding", wall);
    g_test_add_data_func (associative, GINT_TO_POINTER (wall), test_wall);
    g_test_add_data_func (sliding, GINT_TO_POINTER (wall), test_wall_without_dilatancy);
  }
  g_test_add_func ("/verify/shortcuts/random", test_random_walls);
}
