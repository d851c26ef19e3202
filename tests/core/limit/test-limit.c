#include "core/limit/limit.h"
#include "support/certificate.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

static void
detect (QnModel *model, QnContacts *contacts)
{
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, NULL), ==, QN_OK);
}

/* Prepares, solves, holds a multiplier found against its certificates where every joint has one
 * law, and clears the model. */
static QnLimitSolution
solve (QnModel *model)
{
  g_auto (QnContacts) contacts;
  QnLimitSolution solution;

  detect (model, &contacts);
  g_assert_cmpint (qn_limit_associative (model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  if (solution.outcome == QN_OUTCOME_COLLAPSE && model->law_count == 1)
    test_assert_certified (model, &contacts, &solution);
  qn_model_clear (model);
  return solution;
}

static void
assert_multiplier (QnModel *model, double expected)
{
  g_auto (QnLimitSolution) solution = solve (model);

  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (solution.lower_bound, expected, 1e-6);
  g_assert_cmpfloat_with_epsilon (solution.upper_bound, expected, 1e-6);
}

static void
assert_outcome (QnModel *model, QnOutcome expected)
{
  g_auto (QnLimitSolution) solution = solve (model);

  g_assert_cmpint (solution.outcome, ==, expected);
}

/* The six walls: value, both certificates recomputed from the model alone. */
static void
test_six_walls (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnLimitSolution) solution;

    test_model_init_wall (&model, number, 0);
    detect (&model, &contacts);
    g_assert_cmpint (
      qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL), ==, QN_OK);
    double expected = test_walls[number - 1].associative;
    g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (solution.lower_bound, expected, 1e-6);
    g_assert_cmpfloat_with_epsilon (solution.upper_bound, expected, 1e-6);
    g_assert_cmpfloat (solution.upper_bound - solution.lower_bound, <, 1e-6);
    g_assert_cmpfloat (solution.check.static_violation, <, 1e-12);

    test_assert_certified (&model, &contacts, &solution);
  }
}

/* Where the model stands, how large it is and how its blocks are numbered change nothing. */
static void
test_invariance (void)
{
  double expected = test_walls[2].associative;
  QnModel model;

  test_model_init_wall (&model, 3, 0);
  test_model_rotate (&model, 0.7);
  assert_multiplier (&model, expected);
  test_model_init_wall (&model, 3, 0);
  test_model_translate (&model, 1e3, -2e3);
  assert_multiplier (&model, expected);
  test_model_init_wall (&model, 3, 0);
  test_model_scale (&model, 1e-3);
  assert_multiplier (&model, expected);
  test_model_init_wall (&model, 3, 0);
  test_model_mirror (&model);
  assert_multiplier (&model, expected);
  test_model_init_wall (&model, 3, 0);
  test_model_renumber (&model, 7);
  assert_multiplier (&model, expected);
}

/* Slides at the friction, overturns at width/height; corners offset make it narrower. */
static void
test_block (void)
{
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  assert_multiplier (&model, 0.65);
  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  assert_multiplier (&model, 0.25);
  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, -1);
  model.contact.pairs.offset = 0.1;
  assert_multiplier (&model, 0.2);
}

static void
test_strengths (void)
{
  QnModel model;
  double weight = 2 * 1 * 1e4;

  /* Cohesion per pair adds to friction. */
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].cohesion = 0.05 * weight;
  assert_multiplier (&model, 0.75);
  /* As a stress, it is multiplied by the area: 2 m2. */
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].basis = QN_BASIS_SURFACE;
  model.laws[0].cohesion = 0.05 * weight;
  assert_multiplier (&model, 0.65 + 0.05 * 2);
  /* Tension at the heel: W h/2 lambda = W b/2 + T b; the cut-off is below the apex. */
  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].cohesion = 1e9;
  model.laws[0].tension = 0.1 * 4e4;
  assert_multiplier (&model, (0.5 + 0.1) / 2);
  /* … and the apex below the cut-off. */
  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  model.laws[0].friction = 10;
  model.laws[0].cohesion = 4e4;
  model.laws[0].tension = 1e9;
  assert_multiplier (&model, (0.5 + 0.1) / 2);
}

/* The two sides of a joint may have different laws: the weaker strength counts. */
static void
test_two_laws (void)
{
  QnModel model;
  QnLaw *law;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  law = qn_model_add_law (&model, "smooth");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_COULOMB,
                  .kn = 1,
                  .ks = 1,
                  .friction = 0.3,
                  .cohesion = 2e3 };
  model.blocks[1].law = 1;
  /* 0.3 W + 2 c < 0.65 W: each of the two pairs has the cohesion. */
  assert_multiplier (&model, 0.3 + 2 * 2e3 / 2e4);

  test_model_init_block_on_plane (&model, 1, 4);
  test_model_add_weight_loads (&model, 1);
  law = qn_model_add_law (&model, "rigid");
  *law = (QnLaw){ .name = law->name, .kind = QN_LAW_ELASTIC, .kn = 1, .ks = 1 };
  model.blocks[0].law = 1;
  assert_multiplier (&model, 0.25);
}

/* Friction 0: no block rests on a bed that is pushed. Very rough joints only rock. */
static void
test_friction_extremes (void)
{
  QnModel model;

  test_model_init_wall (&model, 3, 0);
  model.laws[0].friction = 0;
  assert_multiplier (&model, 0);
  test_model_init_wall (&model, 1, 0);
  model.laws[0].friction = 5.5;
  assert_multiplier (&model, 40.0 / 21);
  test_model_init_wall (&model, 1, 0);
  model.laws[0].friction = 1e3;
  assert_multiplier (&model, 40.0 / 21);
}

static void
test_other_laws (void)
{
  QnModel model;

  test_model_init_wall (&model, 1, 0);
  model.laws[0].kind = QN_LAW_NO_TENSION;
  assert_multiplier (&model, 40.0 / 21);
  test_model_init_wall (&model, 1, 0);
  model.laws[0].kind = QN_LAW_ELASTIC;
  assert_outcome (&model, QN_OUTCOME_UNBOUNDED);
}

static void
test_unbounded (void)
{
  QnModel model;
  QnLoad *load;

  test_model_init_stack (&model, 3, 1, 0.5);
  test_model_add_weight_loads (&model, 1);
  load = &model.live_loads[0];
  load->vector = qn_vec2 (0, -1);
  assert_outcome (&model, QN_OUTCOME_UNBOUNDED);
  /* Pulled upwards instead, it lifts off at exactly its own weight. */
  test_model_init_stack (&model, 3, 1, 0.5);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, 1);
  assert_multiplier (&model, 1);
}

/* A block that overhangs by more than half falls, and the certificate says which one. */
static void
test_dead_load_unstable (void)
{
  QnModel model;
  g_auto (QnLimitSolution) solution;

  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 4, 1);
  test_model_add_rectangle (&model, "good", 0, 0, 1, 1);
  test_model_add_rectangle (&model, "bad", 3.6, 0, 1, 1);
  test_model_add_weight_loads (&model, 1);
  solution = solve (&model);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  const double *good = solution.velocities + 3, *bad = solution.velocities + 6;
  g_assert_cmpfloat (bad[1], <, 0);
  g_assert_cmpfloat (bad[2], <, 0);
  g_assert_cmpfloat (hypot (good[0], good[1]), <, 1e-3 * fabs (bad[1]));
}

/* A wall whose dead load is a millionth above what it carries falls; a millionth below it carries a
 * millionth more. */
static void
test_verge (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    double most = test_walls[number - 1].associative;
    QnModel model;
    test_model_init_wall (&model, number, 0);
    model.dead_loads[0].vector.x = (1 + 1e-6) * most;
    assert_outcome (&model, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
    test_model_init_wall (&model, number, 0);
    model.dead_loads[0].vector.x = (1 - 1e-6) * most;
    g_auto (QnLimitSolution) left = solve (&model);
    g_assert_cmpint (left.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (left.lower_bound, 1e-6 * most, 2e-8);
    g_assert_cmpfloat_with_epsilon (left.upper_bound, left.lower_bound,
                                    1e-5 * left.lower_bound);
  }
}

/* With a friction of a millionth the multiplier is that, in all its digits. Strengths of a millionth say little
 * of normal forces: a joint may be pulled by a hundred-millionth of a weight. */
static void
test_little_friction (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnLimitSolution) solution;
    test_model_init_wall (&model, number, 0);
    model.laws[0].friction = 1e-6;
    detect (&model, &contacts);
    g_assert_cmpint (
      qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL), ==, QN_OK);
    g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (solution.lower_bound, 1e-6, 1e-11);
    g_assert_cmpfloat_with_epsilon (solution.upper_bound, 1e-6, 1e-11);
  }
}

/* Equilibrium under some live load but not without: no state to start from. */
static void
test_only_with_live_load (void)
{
  QnModel model;

  test_model_init (&model);
  test_model_add_base (&model, 0, -1, 1, 1);
  test_model_add_rectangle (&model, "block", 0.6, 0, 1, 1);
  test_model_add_weight_loads (&model, -1);
  assert_outcome (&model, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
}

/* A block in the air is no equilibrium; one without weight does no harm. */
static void
test_no_joint (void)
{
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_rectangle (&model, "flying", 5, 5, 1, 1);
  test_model_add_weight_loads (&model, 1);
  assert_outcome (&model, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_rectangle (&model, "flying", 5, 5, 1, 1)->unit_weight = 0;
  test_model_add_weight_loads (&model, 1);
  assert_multiplier (&model, 0.65);
}

static void
test_no_live_load (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  QnLimitSolution solution;
  QnDiag diag;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 0);
  detect (&model, &contacts);
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, &diag),
                   ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_LIVE_LOAD);
}

/* One pair per face is a hinge: the rotation rows of the stack are redundant or empty. */
static void
test_redundant_rows (void)
{
  QnModel model;

  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 1);
  model.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 1 };
  /* The load acts half a metre above the hinge: nothing resists its moment. */
  assert_multiplier (&model, 0);
}

/* Pairs between the corners share friction, cohesion and tension by their tributary lengths, and change no
 * multiplier: what they carry the corners could. */
static void
test_pairs_between_corners (void)
{
  static const double strengths[][2] = { { 0, 0 }, { 2e3, 0 }, { 2e3, 1e3 } };
  for (size_t i = 0; i < G_N_ELEMENTS (strengths); i++)
    for (int number = 1; number <= 3; number++) {
      QnModel models[2];
      for (int k = 0; k < 2; k++) {
        test_model_init_wall (&models[k], number, 0);
        models[k].laws[0].basis = QN_BASIS_SURFACE;
        models[k].laws[0].cohesion = strengths[i][0];
        models[k].laws[0].tension = strengths[i][1];
      }
      models[0].contact.pairs.placement = QN_PLACEMENT_ENDS;
      g_auto (QnLimitSolution) ends = solve (&models[0]);
      assert_multiplier (&models[1], ends.lower_bound);
      if (i == 0)
        g_assert_cmpfloat_with_epsilon (ends.lower_bound,
                                        test_walls[number - 1].associative, 1e-6);
    }
}

/* Joints without reserve under the dead load: blocks without weight, whose joints carry nothing,
 * a wall that almost slides, and one that its dead load has almost pushed over. The bounds meet
 * all the same. */
static void
test_no_reserve (void)
{
  QnModel model;

  test_model_init_stack (&model, 5, 1, 1);
  test_model_add_weight_loads (&model, 1);
  for (size_t i = 3; i < model.block_count; i++)
    model.blocks[i].unit_weight = 0;
  assert_multiplier (&model, 0.5);

  test_model_init_wall (&model, 4, 0);
  model.laws[0].friction = 0.05;
  assert_multiplier (&model, 0.05);

  test_model_init_wall (&model, 1, 0);
  model.dead_loads[0].vector.x = 0.9 * test_walls[0].associative;
  assert_multiplier (&model, 0.1 * test_walls[0].associative);
}

/* The mirrored load gives the mirrored mechanism. */
static void
test_symmetry (void)
{
  QnModel right, left;
  g_auto (QnLimitSolution) a, b;

  test_model_init_stack (&right, 4, 1, 1);
  test_model_add_weight_loads (&right, 1);
  test_model_init_stack (&left, 4, 1, 1);
  test_model_add_weight_loads (&left, -1);
  a = solve (&right);
  b = solve (&left);
  g_assert_cmpfloat_with_epsilon (a.upper_bound, 0.25, 1e-7);
  g_assert_cmpfloat_with_epsilon (a.upper_bound, b.upper_bound, 1e-8);
  for (size_t i = 0; i < 5; i++) {
    g_assert_cmpfloat_with_epsilon (a.velocities[3 * i], -b.velocities[3 * i], 1e-6);
    g_assert_cmpfloat_with_epsilon (a.velocities[3 * i + 1], b.velocities[3 * i + 1],
                                    1e-6);
    g_assert_cmpfloat_with_epsilon (a.velocities[3 * i + 2], -b.velocities[3 * i + 2],
                                    1e-6);
  }
}

static bool
arch_stands (double thickness, int count, int segments)
{
  QnModel model;

  test_arch_init (&model, thickness, count, segments);
  model.laws[0].kind = QN_LAW_NO_TENSION;
  g_auto (QnLimitSolution) solution = solve (&model);
  g_assert_true (solution.outcome == QN_OUTCOME_COLLAPSE
                 || solution.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  bool stands = solution.outcome == QN_OUTCOME_COLLAPSE;
  return stands;
}

static double
least_thickness (int count, int segments, double accuracy)
{
  double low = 0.105, high = 0.109;

  g_assert_false (arch_stands (low, count, segments));
  g_assert_true (arch_stands (high, count, segments));
  while (high - low > accuracy) {
    double middle = 0.5 * (low + high);
    if (arch_stands (middle, count, segments))
      high = middle;
    else
      low = middle;
  }
  return 0.5 * (low + high);
}

/* Milankovitch's arch with 27 voussoirs: radial joints, no sliding, ratio of the least
 * thickness to the radius of the middle line. */
static void
test_arch (void)
{
  g_assert_cmpfloat_with_epsilon (least_thickness (27, 1, 1e-6), 0.106721, 2e-6);
  g_assert_cmpfloat_with_epsilon (least_thickness (27, 40, 1e-6), 0.106776, 2e-6);
}

static void
test_fine_arch (void)
{
  double least = least_thickness (360, 1, 2e-5);

  g_assert_cmpfloat (least, >, 0.1074);
  g_assert_cmpfloat (least, <, 0.1075);
}

static bool
stop_at_once (const QnProgress *progress, void *user_data)
{
  (void) progress;
  (void) user_data;
  return false;
}

static void
test_cancel (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnLimitSolution) solution;

  test_model_init_wall (&model, 1, 0);
  detect (&model, &contacts);
  g_assert_cmpint (
    qn_limit_associative (&model, &contacts, stop_at_once, NULL, &solution, NULL), ==,
    QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_CANCELLED);
}

QN_TESTS
{
  g_test_add_func ("/limit/walls", test_six_walls);
  g_test_add_func ("/limit/invariance", test_invariance);
  g_test_add_func ("/limit/block", test_block);
  g_test_add_func ("/limit/strengths", test_strengths);
  g_test_add_func ("/limit/two-laws", test_two_laws);
  g_test_add_func ("/limit/friction-extremes", test_friction_extremes);
  g_test_add_func ("/limit/other-laws", test_other_laws);
  g_test_add_func ("/limit/unbounded", test_unbounded);
  g_test_add_func ("/limit/dead-load-unstable", test_dead_load_unstable);
  g_test_add_func ("/limit/verge", test_verge);
  g_test_add_func ("/limit/little-friction", test_little_friction);
  g_test_add_func ("/limit/only-with-live-load", test_only_with_live_load);
  g_test_add_func ("/limit/no-joint", test_no_joint);
  g_test_add_func ("/limit/no-live-load", test_no_live_load);
  g_test_add_func ("/limit/redundant-rows", test_redundant_rows);
  g_test_add_func ("/limit/pairs-between-corners", test_pairs_between_corners);
  g_test_add_func ("/limit/no-reserve", test_no_reserve);
  g_test_add_func ("/limit/symmetry", test_symmetry);
  g_test_add_func ("/limit/arch", test_arch);
  g_test_add_func ("/limit/fine-arch", test_fine_arch);
  g_test_add_func ("/limit/cancel", test_cancel);
}
