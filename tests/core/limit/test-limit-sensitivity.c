/* Derivatives of the multiplier against differences of the multiplier itself, on wall 3 with joints
 * by area, some cohesion, and a force besides the weight. */
#include "core/limit/limit-sensitivity.h"

#include "core/limit/limit.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

/* What is varied, and by how much of itself at each step. */
typedef enum {
  FRICTION,
  COHESION,
  TENSION,
  WEIGHT,
  THICKNESS,
  DEAD_LOAD,
  LIVE_LOAD,
  VARIED_COUNT
} Varied;

static const double size[VARIED_COUNT] = { 0.65, 3000, 1000, 1, 1, 1, 1 };

/* Of the law; one of Mohr and Coulomb is given 50 kPa in compression, which crush it here. */
static QnLawKind kind;

/* Blocks above the middle have a law of their own, and are thinner; weight and thickness are varied of the
 * others. A surcharge presses on what is seen from above. */
static bool two_laws;

/* Wall 3 with one number changed to size (1 + share). */
static void
init_wall (QnModel *model, Varied varied, double share)
{
  double factor[VARIED_COUNT] = { 1, 1, 1, 1, 1, 1, 1 };
  factor[varied] += share;
  test_model_init_wall (model, 3, 0);
  QnLaw *law = &model->laws[0];
  law->kind = kind;
  law->compression = kind == QN_LAW_MOHR_COULOMB ? 5e4 : 0;
  law->basis = QN_BASIS_SURFACE;
  law->friction = size[FRICTION] * factor[FRICTION];
  law->cohesion = size[COHESION] * factor[COHESION];
  law->tension = size[TENSION] * factor[TENSION];
  g_assert_cmpint (qn_model_expand_walls (model, NULL), ==, QN_OK);
  if (two_laws) {
    QnLaw *upper = qn_model_add_law (model, "upper");
    char *name = upper->name;
    *upper = model->laws[0];
    upper->name = name;
    upper->source = NULL;
    upper->friction = 0.7;
    upper->cohesion = 5000;
    upper->tension = 1500;
    QnLoad *surcharge = qn_model_add_dead_load (model);
    surcharge->kind = QN_LOAD_SURCHARGE;
    surcharge->pressure = 500;
  }
  for (size_t b = 0; b < model->block_count; b++) {
    QnBlock *block = &model->blocks[b];
    if (two_laws && b > model->block_count / 2) {
      block->law = 1;
      block->thickness *= 0.7;
      continue;
    }
    block->unit_weight *= factor[WEIGHT];
    block->thickness *= factor[THICKNESS];
  }
  model->dead_loads[0].vector.y *= factor[DEAD_LOAD];
  QnLoad *push = qn_model_add_live_load (model);
  push->kind = QN_LOAD_FORCE;
  push->block = (QnId) model->block_count - 1;
  push->has_at = true;
  push->at = qn_vec2 (1.4, 1.9);
  push->vector = qn_vec2 (300 * factor[LIVE_LOAD], -100 * factor[LIVE_LOAD]);
  push->moment = 20 * factor[LIVE_LOAD];
  model->analysis.procedure = QN_PROCEDURE_LIMIT;
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
}

static double
multiplier_at (Varied varied, double share)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;
  init_wall (&model, varied, share);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  double middle = 0.5 * (solution.lower_bound + solution.upper_bound);
  return middle;
}

/* By four differences, exact to the fourth power of the step: d lambda / d share. */
static double
difference (Varied varied)
{
  const double h = 5e-4; /* another mechanism takes over not far away */
  return (8 * (multiplier_at (varied, h) - multiplier_at (varied, -h))
          - (multiplier_at (varied, 2 * h) - multiplier_at (varied, -2 * h)))
         / (12 * h);
}

static void
check_differences (QnLawKind wanted, bool of_two)
{
  kind = wanted;
  two_laws = of_two;
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnLimitSensitivity s;
  init_wall (&model, FRICTION, 0);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_run (&model, &contacts, INFINITY, NULL, NULL, &result, NULL),
                   ==, QN_OK);
  g_assert_cmpint (qn_limit_sensitivity (&model, &contacts, &result, &s, NULL), ==,
                   QN_OK);
  const double found[VARIED_COUNT] = { s.laws[0].friction,  s.laws[0].cohesion,
                                       s.laws[0].tension,   s.laws[0].weight,
                                       s.laws[0].thickness, s.dead_loads[0],
                                       s.live_loads[1] };
  for (Varied i = 0; i < VARIED_COUNT; i++) {
    double expected = difference (i);
    g_test_message ("%d: %.8f, by differences %.8f", i, found[i] * size[i], expected);
    g_assert_cmpfloat_with_epsilon (found[i] * size[i], expected, 1e-5);
  }
  qn_limit_sensitivity_clear (&s);
}

static void
test_differences (void)
{
  check_differences (QN_LAW_COULOMB, false);
}

static void
test_compression (void)
{
  check_differences (QN_LAW_MOHR_COULOMB, false);
}

static void
test_two_laws (void)
{
  check_differences (QN_LAW_COULOMB, true);
}

/* A block that slides: lambda = mu + c / W, so 1 and 1 / W. */
static void
test_closed_form (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnLimitSensitivity s;
  test_model_init_block_on_plane (&model, 2, 0.5);
  test_model_add_weight_loads (&model, 1);
  model.analysis.procedure = QN_PROCEDURE_LIMIT;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_limit_run (&model, &contacts, INFINITY, NULL, NULL, &result, NULL),
                   ==, QN_OK);
  g_assert_cmpint (qn_limit_sensitivity (&model, &contacts, &result, &s, NULL), ==,
                   QN_OK);
  g_assert_cmpfloat_with_epsilon (s.laws[0].friction, 1, 1e-6);
  /* Two pairs, 1 N each, on 10 kN. */
  g_assert_cmpfloat_with_epsilon (s.laws[0].cohesion, 2 / 1e4, 1e-9);
  g_assert_cmpfloat_with_epsilon (s.laws[0].weight, 0, 1e-6);
  g_assert_cmpfloat_with_epsilon (s.dead_loads[0], 0.65, 1e-6);
  g_assert_cmpfloat_with_epsilon (s.live_loads[0], -0.65, 1e-6);
  qn_limit_sensitivity_clear (&s);
}

QN_TESTS
{
  g_test_add_func ("/limit-sensitivity/differences", test_differences);
  g_test_add_func ("/limit-sensitivity/compression", test_compression);
  g_test_add_func ("/limit-sensitivity/closed-form", test_closed_form);
  g_test_add_func ("/limit-sensitivity/two-laws", test_two_laws);
}
