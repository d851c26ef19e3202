/* What a wall's place, size and numbering must not change: its multiplier. Within 0.5 %
 * without dilatancy, where the path has branches close to each other, and within 0.1 % with
 * dilatancy = friction, where the multiplier is unique. */
#include "solve.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

typedef void (*Change) (QnModel *model);

static void
rotate_a_little (QnModel *model)
{
  test_model_rotate (model, 0.1);
}

static void
rotate_far (QnModel *model)
{
  test_model_rotate (model, 2.4);
}

static void
rotate_by_45_degrees (QnModel *model)
{
  test_model_rotate (model, atan (1));
}

static void
translate (QnModel *model)
{
  test_model_translate (model, 1e6, -1e6);
}

static void
renumber (QnModel *model)
{
  test_model_renumber (model, 7);
}

static void
mirror (QnModel *model)
{
  test_model_mirror (model);
}

static void
shrink (QnModel *model)
{
  test_model_scale (model, 1e-3);
}

static void
enlarge (QnModel *model)
{
  test_model_scale (model, 1e3);
}

static const struct {
  const char *name;
  Change apply;
} changes[] = {
  { "rotated by 0.1", rotate_a_little },
  { "rotated by 2.4", rotate_far },
  { "rotated by 45 degrees", rotate_by_45_degrees },
  { "translated by 1e6 m", translate },
  { "renumbered", renumber },
  { "mirrored", mirror },
  { "scaled by 1e-3", shrink },
  { "scaled by 1e3", enlarge },
};

static void
compare (int number, double dilatancy, double tolerance)
{
  QnModel model;
  test_model_init_wall (&model, number, dilatancy);
  double plain = verify_collapse (&model);
  for (size_t i = 0; i < G_N_ELEMENTS (changes); i++) {
    test_model_init_wall (&model, number, dilatancy);
    changes[i].apply (&model);
    double found = verify_collapse (&model);
    g_test_message ("wall %d, dilatancy %g, %s: %.6f (%+.4f %%)", number, dilatancy,
                    changes[i].name, found, 100 * (found / plain - 1));
    g_assert_cmpfloat (fabs (found / plain - 1), <=, tolerance);
  }
}

static void
test_non_associative (gconstpointer data)
{
  compare (GPOINTER_TO_INT (data), 0, 0.005);
}

static void
test_associative (gconstpointer data)
{
  compare (GPOINTER_TO_INT (data), 0.65, 0.001);
}

QN_TESTS
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_autofree char *non =
      g_strdup_printf ("/verify/invariance/%d/non-associative", number);
    g_autofree char *associative =
      g_strdup_printf ("/verify/invariance/%d/associative", number);
    g_test_add_data_func (non, GINT_TO_POINTER (number), test_non_associative);
    g_test_add_data_func (associative, GINT_TO_POINTER (number), test_associative);
  }
}
