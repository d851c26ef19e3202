/* Two independent theories, one number: the load path of HybriDFEM and the linear program of
 * limit analysis on generated walls. With dilatancy = friction they agree, whether compression is
 * limited or not; with dilatancy 0 the path never passes the associative optimum. */
#include "solve.h"

#include "core/limit/limit.h"
#include "support/auto-clear.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

#define FRICTION 0.65

/* Limit of compression of a pair, N: less than the largest force without it. */
#define COMPRESSION 9000

/* Walls of each kind. */
#define COUNT 5

/* Blocks of random lengths, one half to one and a half units, in every course. */
static void
make_random_bond (QnModel *model, int seed)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed ((guint32) seed);

  test_model_init (model);
  test_model_add_base (model, 0, -0.2, 1.2, 0.2);
  test_model_add_weight_loads (model, 1);
  QnWall *wall = qn_model_add_wall (model, "w");
  wall->unit = qn_vec2 (0.5, 0.25);
  wall->thickness = 1;
  wall->unit_weight = 1e4;
  test_wall_add_courses (wall, rand, 9, 2.4, 0.5, 1.6);
}

static void
make (QnModel *model, int number, double dilatancy, double compression)
{
  if (number < COUNT)
    test_bond_init (model, TEST_UNIT, 5, 7, 2, (guint64) number + 1);
  else
    make_random_bond (model, number + 1);
  for (size_t i = 0; i < model->law_count; i++) {
    model->laws[i].friction = FRICTION;
    model->laws[i].dilatancy = dilatancy;
    model->laws[i].compression = compression;
    if (compression > 0)
      model->laws[i].kind = QN_LAW_MOHR_COULOMB;
  }
}

static double
optimum (int number, double compression)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;

  make (&model, number, 0, compression);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat (fabs (solution.upper_bound - solution.lower_bound), <, 1e-6);
  double found = solution.upper_bound;
  return found;
}

static void
test_wall (gconstpointer data)
{
  int number = GPOINTER_TO_INT (data);
  double bound = optimum (number, 0);
  QnModel model;

  make (&model, number, FRICTION, 0);
  double associative = verify_collapse (&model);
  make (&model, number, 0, 0);
  double allowed = model.analysis.multiplier_tolerance;
  double path = verify_collapse (&model);
  g_test_message ("wall %d: limit %.8f, path %.6f with dilatancy, %.6f without",
                  number + 1, bound, associative, path);
  g_assert_cmpfloat_with_epsilon (associative, bound, 1e-3 * bound);
  g_assert_cmpfloat (path, <=, bound * (1 + allowed));
}

static void
test_crushed (gconstpointer data)
{
  int number = GPOINTER_TO_INT (data);
  double bound = optimum (number, COMPRESSION);
  QnModel model;

  g_assert_cmpfloat (bound, <, 0.98 * optimum (number, 0));
  make (&model, number, FRICTION, COMPRESSION);
  double associative = verify_collapse (&model);
  make (&model, number, 0, COMPRESSION);
  double allowed = model.analysis.multiplier_tolerance;
  double path = verify_collapse (&model);
  g_test_message ("wall %d, crushed: limit %.8f, path %.6f with dilatancy, %.6f without",
                  number + 1, bound, associative, path);
  g_assert_cmpfloat_with_epsilon (associative, bound, 1e-3 * bound);
  g_assert_cmpfloat (path, <=, bound * (1 + allowed));
}

QN_TESTS
{
  for (int number = 0; number < 2 * COUNT; number++) {
    g_autofree char *path = g_strdup_printf ("/verify/limit-agreement/%d", number + 1);
    g_autofree char *crushed =
      g_strdup_printf ("/verify/limit-agreement/crushed/%d", number + 1);
    g_test_add_data_func (path, GINT_TO_POINTER (number), test_wall);
    g_test_add_data_func (crushed, GINT_TO_POINTER (number), test_crushed);
  }
}
