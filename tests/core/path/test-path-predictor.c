#include "core/path/path-predictor.h"

#include "support/models.h"
#include "support/room.h"

#include <glib.h>

/* A solver whose states are put on a polynomial of the measure. */
typedef struct {
  QnModel model;
  QnContacts contacts;
  QnEquilibrium eq;
  QnPathPredictor predictor;
} Fixture;

static void
set_up (Fixture *fixture)
{
  QnModel *model = &fixture->model;
  test_model_init_block_on_plane (model, 0.4, 1);
  test_model_add_weight_loads (model, 1);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &fixture->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_equilibrium_setup (&fixture->eq, model, &fixture->contacts, NULL, NULL, NULL), ==,
    QN_OK);
  qn_path_predictor_init (&fixture->predictor, &fixture->eq.assembly, &fixture->eq.pool);
  g_assert_false (fixture->eq.pool.failed);
}

static void
tear_down (Fixture *fixture)
{
  qn_equilibrium_clear (&fixture->eq);
  qn_contacts_clear (&fixture->contacts);
  qn_model_clear (&fixture->model);
}

static double
displacement (double s, int unknown)
{
  return 1e-3 * ((unknown + 1) * s - 0.5 * s * s + 0.1 * unknown * s * s * s);
}

static double
multiplier (double s)
{
  return 0.3 + 0.1 * s - 0.2 * s * s + 0.01 * s * s * s;
}

static void
place (Fixture *fixture, double s)
{
  QnEquilibrium *eq = &fixture->eq;
  for (int i = 0; i < eq->assembly.unknown_count; i++)
    eq->u[i] = displacement (s, i);
  eq->multiplier = multiplier (s);
}

/* Goes on to s, by a step from `from`. */
static void
advance (Fixture *fixture, double from, double s, bool smooth)
{
  place (fixture, s);
  qn_path_predictor_note (&fixture->predictor, &fixture->eq, s - from, smooth);
  qn_equilibrium_commit (&fixture->eq);
}

/* Cubics are continued exactly, from steps of any length; the solver stays where too few equilibria are
 * known, and forgets those before a jump. */
static void
test_polynomial (void)
{
  static const double at[] = { 0.2, 0.5, 0.6, 1.4, 1.5 };
  Fixture fixture;
  set_up (&fixture);
  QnEquilibrium *eq = &fixture.eq;
  place (&fixture, at[0]);
  qn_equilibrium_commit (eq);
  g_assert_false (qn_path_predictor_go (&fixture.predictor, eq, 0.1));
  for (int k = 1; k < (int) G_N_ELEMENTS (at); k++) {
    advance (&fixture, at[k - 1], at[k], true);
    g_assert_cmpint (qn_path_predictor_go (&fixture.predictor, eq, 0.3), ==, k >= 3);
    for (int i = 0; k >= 3 && i < eq->assembly.unknown_count; i++)
      g_assert_cmpfloat_with_epsilon (eq->u[i], displacement (at[k] + 0.3, i), 1e-14);
    if (k >= 3)
      g_assert_cmpfloat_with_epsilon (eq->multiplier, multiplier (at[k] + 0.3), 1e-12);
    qn_equilibrium_restore (eq);
  }
  advance (&fixture, 1.5, 2, false);
  g_assert_false (qn_path_predictor_go (&fixture.predictor, eq, 0.3));
  g_assert_cmpfloat (eq->u[0], ==, displacement (2, 0));
  tear_down (&fixture);
}

QN_TESTS
{
  g_test_add_func ("/core/path-predictor/polynomial", test_polynomial);
}
