#include "core/check/result-check.h"
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <float.h>
#include <glib.h>
#include <math.h>

static void
run (QnModel *model, QnProgressFunc progress, void *data, QnResult *result)
{
  g_auto (QnContacts) contacts;

  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (model, &contacts, progress, data, result, NULL), ==,
                   QN_OK);
  qn_model_clear (model);
}

static void
init_block (QnModel *model)
{
  test_model_init_block_on_plane (model, 2, 0.5);
  test_model_add_weight_loads (model, 1);
}

static void
test_target (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.analysis.max_multiplier = 0.3;
  run (&model, NULL, NULL, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_false (result.has_collapse_multiplier);
  g_assert_cmpfloat (result.steps[0].multiplier, ==, 0);
  g_assert_cmpfloat (result.steps[1].multiplier, ==,
                     0.02); /* of live loads like the dead */
  g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==, 0.3);
  for (size_t s = 1; s < result.step_count; s++)
    g_assert_cmpfloat (result.steps[s].multiplier, >, result.steps[s - 1].multiplier);
}

/* Sizes of steps follow from the structure: every step is the same, whatever the increments. */
static void
test_steps_do_not_depend_on_increments (void)
{
  static const int increments[] = { 5, 100, 500 };
  QnResult results[G_N_ELEMENTS (increments)];

  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
    QnModel model;
    test_model_init_wall (&model, 2, 0);
    model.analysis.increments = increments[i];
    run (&model, NULL, NULL, &results[i]);
    g_assert_cmpint (results[i].outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpuint (results[i].step_count, ==, results[0].step_count);
    for (size_t s = 0; s < results[i].step_count; s++)
      g_assert_cmpfloat (results[i].steps[s].multiplier, ==,
                         results[0].steps[s].multiplier);
  }
  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++)
    qn_result_clear (&results[i]);
}

/* A block that cannot turn and settles by W/k = 1 mm under its dead load slides once it has moved by 0.65 W/k: the
 * displacement of its collapse is the one along its joint, without the settlement. */
static void
test_displacement_of_collapse (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.blocks[1].support[QN_DOF_RZ] = true;
  run (&model, NULL, NULL, &result);
  const QnPathEvent *event = &result.events[result.event_count - 1];
  const double *u =
    qn_result_step_displacements (&result, result.step_count - 1) + QN_DOF_COUNT;
  g_assert_cmpint (event->kind, ==, QN_EVENT_KIND_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (event->multiplier, 0.65, 1e-6);
  g_assert_cmpfloat_with_epsilon (u[QN_DOF_UY], -1e-3, 1e-9);
  g_assert_cmpfloat (u[QN_DOF_UX], >, 0.65e-3 * (1 - 1e-6));
  g_assert_cmpfloat_with_epsilon (event->displacement_before, u[QN_DOF_UX], 1e-9);
}

/* However coarse the increments are, even where the first one is far beyond collapse. */
static void
test_collapse_does_not_depend_on_increments (void)
{
  static const int increments[] = { 1, 2, 10, 1000 };
  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
    QnModel model;
    g_auto (QnResult) result;
    init_block (&model);
    model.analysis.increments = increments[i];
    model.analysis.multiplier_tolerance = 1e-9;
    model.analysis.residual_tolerance = 1e-11;
    run (&model, NULL, NULL, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.65, 1e-9);
    g_assert_cmpint (result.steps[result.step_count - 1].event, ==, QN_EVENT_COLLAPSE);
    g_assert_nonnull (result.mechanism);
  }
}

/* The mechanism tells the multiplier more exactly than the bracket that encloses it. */
static void
test_digits_beyond_the_bracket (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  run (&model, NULL, NULL, &result);
  g_assert_cmpfloat (result.collapse_multiplier, <=, 0.65 * (1 + 4 * DBL_EPSILON));
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.65, 1e-6 * 0.65);
}

static void
test_no_live_load (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.live_load_count = 0;
  run (&model, NULL, NULL, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (result.step_count, ==, 1);
}

/* A load that presses a block onto its base has no limit. */
static void
test_unbounded (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.live_loads[0].vector = qn_vec2 (0, -1);
  run (&model, NULL, NULL, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_UNBOUNDED);
}

static void
test_dead_load_unstable (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_block (&model);
  model.dead_loads[0].vector = qn_vec2 (0.7, -1);
  run (&model, NULL, NULL, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_DEAD_LOAD_UNSTABLE);
  g_assert_cmpuint (result.step_count, ==, 0);
  g_assert_cmpuint (result.unstable_count, ==, 1);
  g_assert_cmpint (result.unstable_blocks[0], ==, 1);
}

/* Wall 3 loses stability at 0.2604, long before its last equilibrium; but it moves by a thousandth of its
 * displacement there, so that it is no snap, where the path would stop. */
static void
test_no_snap (void)
{
  static const int increments[] = { 10, 37, 100 };
  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
    QnModel model;
    g_auto (QnResult) result;
    test_model_init_wall (&model, 3, 0);
    model.analysis.increments = increments[i];
    model.analysis.snap = QN_SNAP_THROUGH_STOP;
    run (&model, NULL, NULL, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.3558, 3e-4);
    g_assert_false (result.has_first_limit_multiplier);
    g_assert_cmpint (result.events[result.event_count - 1].kind, ==,
                     QN_EVENT_KIND_COLLAPSE);
    g_assert_cmpfloat (result.events[result.event_count - 1].multiplier, ==,
                       result.collapse_multiplier);
  }
}

/* As joints grow stiffer, equilibrium in the deformed configuration becomes equilibrium in the
 * undeformed one; soft joints lose capacity by their own deformation. */
static void
test_nonlinear_geometry (void)
{
  static const double stiffness[] = { 1e6, 1e7, 1e8, 1e10 };
  double before = 0;
  for (size_t i = 0; i < G_N_ELEMENTS (stiffness); i++) {
    QnModel model;
    g_auto (QnResult) result;
    test_model_init_wall (&model, 1, 0);
    model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    model.laws[0].kn = model.laws[0].ks = stiffness[i];
    run (&model, NULL, NULL, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat (result.collapse_multiplier, >, before);
    before = result.collapse_multiplier;
  }
  g_assert_cmpfloat_with_epsilon (before, 0.6415, 3e-4);
}

static bool
stop_after_steps (const QnProgress *progress, void *data)
{
  return progress->steps < *(int *) data;
}

static void
test_cancel_keeps_what_converged (void)
{
  QnModel model;
  g_auto (QnResult) result;
  int steps = 5;
  test_model_init_wall (&model, 1, 0);
  run (&model, stop_after_steps, &steps, &result);
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_CANCELLED);
  g_assert_cmpuint (result.step_count, ==, 5);
  g_assert_cmpfloat (result.pairs[0].normal_force, <, 0);
}

static bool
refuse_at (const QnProgress *progress, void *data)
{
  return progress->iterations < *(int *) data;
}

/* Whenever it is cancelled, a run ends, soon and with steps in order. */
static void
test_cancel_anywhere (void)
{
  QnModel model;
  QnResult result;
  test_model_init_wall (&model, 3, 0);
  run (&model, NULL, NULL, &result);
  int iterations = result.statistics.iterations;
  g_assert_cmpint (iterations, >, 50);
  qn_result_clear (&result);

  for (int at = 1; at < iterations; at += 5) {
    test_model_init_wall (&model, 3, 0);
    run (&model, refuse_at, &at, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_CANCELLED);
    g_assert_cmpint (result.statistics.iterations, ==, at);
    qn_result_clear (&result);
  }
}

/* The same while the collapse is sought directly, from two thirds of the path on. */
static void
test_cancel_what_is_sought (void)
{
  QnModel model;
  QnResult result;
  test_model_init_wall (&model, 6, 0);
  run (&model, NULL, NULL, &result);
  int iterations = result.statistics.iterations;
  size_t steps = result.step_count;
  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  qn_result_clear (&result);

  for (int at = 2 * iterations / 3; at < iterations; at += 7) {
    test_model_init_wall (&model, 6, 0);
    run (&model, refuse_at, &at, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_CANCELLED);
    g_assert_cmpint (result.statistics.iterations, ==, at);
    g_assert_cmpuint (result.step_count, <, steps);
    qn_result_clear (&result);
  }
}

static void
init_bond (QnModel *model, double stiffness)
{
  test_bond_init (model, TEST_UNIT, 10, 20, 0, 0);
  model->laws[0].kn = model->laws[0].ks = stiffness;
  model->analysis.geometry = QN_GEOMETRY_LINEAR;
}

/* A wall of 210 blocks creeps, and ends at the collapse that is found directly: that to which its steps lead
 * where each is followed (0.49238), whatever the stiffness, below the associative bound. Forces and
 * mechanism are proved as those of any result. */
static void
test_creeping_ends (void)
{
  for (double stiffness = 1e8; stiffness < 1e11; stiffness *= 100) {
    g_auto (QnModel) model;
    g_auto (QnContacts) contacts;
    g_auto (QnResult) result;
    QnResultFaults faults;
    init_bond (&model, stiffness);
    g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
    g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    g_test_message ("%.5f below %.5f after %d factorisations", result.collapse_multiplier,
                    result.associative_bound, result.statistics.factorizations);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_false (result.mechanism_uncertain);
    g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, 0.49238, 5e-4);
    g_assert_true (result.has_associative_bound);
    g_assert_cmpfloat (result.collapse_multiplier, <, result.associative_bound);
    g_assert_cmpint (result.statistics.factorizations, <=, 250);
    g_assert_true (result.steps[result.step_count - 1].relaxed);
    g_assert_cmpint (qn_result_find_faults (&model, &contacts, &result,
                                            QN_CHECK_RECOMPUTED, &faults, NULL),
                     ==, QN_OK);
    g_assert_cmpint (faults.count, ==, 0);
  }
}

/* No load beyond the largest multiplier is applied, wherever collapse is. */
static void
test_creeping_to_a_target (void)
{
  QnModel model;
  g_auto (QnResult) result;
  init_bond (&model, 1e9);
  model.analysis.max_multiplier = 0.49;
  run (&model, NULL, NULL, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat (result.steps[result.step_count - 1].multiplier, ==, 0.49);
}

/* A long step may lead beyond a peak of the path; a load that is held slightly above it rests where the step
 * began. So load control ends no lower than procedures that prescribe the motion. */
static void
test_peak_within_a_step (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  static const guint32 seeds[] = { 23103, 41031 };

  for (size_t i = 0; i < G_N_ELEMENTS (seeds); i++) {
    double by_load = 0;
    for (size_t k = 0; k < G_N_ELEMENTS (procedures); k++) {
      QnModel model;
      g_auto (QnResult) result;
      test_wall_draw_sized (&model, seeds[i], 60, 300);
      model.analysis.geometry = QN_GEOMETRY_LINEAR;
      model.analysis.procedure = procedures[k];
      run (&model, NULL, NULL, &result);
      g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
      by_load = k == 0 ? result.collapse_multiplier : by_load;
      g_test_message ("seed %u: %.5f", seeds[i], result.collapse_multiplier);
      g_assert_cmpfloat (by_load, >=, 0.9999 * result.collapse_multiplier);
      for (size_t s = 1; k == 0 && s < result.step_count; s++)
        g_assert_cmpfloat (result.steps[s].multiplier, >, result.steps[s - 1].multiplier);
    }
  }
}

static void
test_repeatable (void)
{
  QnResult results[2];
  for (int k = 0; k < 2; k++) {
    QnModel model;
    test_model_init_wall (&model, 5, 0);
    run (&model, NULL, NULL, &results[k]);
  }
  size_t numbers = results[0].step_count * results[0].block_count * QN_DOF_COUNT;
  g_assert_cmpuint (results[0].step_count, ==, results[1].step_count);
  g_assert_cmpmem (results[0].displacements, numbers * sizeof (double),
                   results[1].displacements, numbers * sizeof (double));
  g_assert_true (results[0].collapse_multiplier == results[1].collapse_multiplier);
  qn_result_clear (&results[0]);
  qn_result_clear (&results[1]);
}

/* Largest force or moment (about the centroid, over the length of a block) on a free block at a
 * step, its own weight and the live load included, N. */
static double
largest_imbalance (const QnModel *model, const QnContacts *contacts,
                   const QnResult *result, size_t step)
{
  double sums[64][3] = { { 0 } }, largest = 0;
  g_assert_cmpuint (model->block_count, <=, G_N_ELEMENTS (sums));
  for (size_t p = 0; p < contacts->pair_count; p++) {
    const QnContactPair *pair = &contacts->pairs[p];
    const QnContactFace *face = &contacts->faces[pair->face];
    QnPairResult forces = qn_result_pair_at (result, step, p);
    QnVec2 force = qn_vec2_add (qn_vec2_scale (forces.normal_force, face->normal),
                                qn_vec2_scale (forces.shear_force, face->tangent));
    for (int side = 0; side < 2; side++) {
      QnId block = side == 0 ? face->a : face->b;
      QnVec2 f = qn_vec2_scale (side == 0 ? 1 : -1, force);
      QnVec2 arm = qn_vec2_sub (pair->point, model->blocks[block].centroid);
      sums[block][0] += f.x;
      sums[block][1] += f.y;
      sums[block][2] += qn_vec2_cross (arm, f) / model->characteristic_length;
    }
  }
  for (size_t b = 0; b < model->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    sums[b][0] += result->steps[step].multiplier * block->weight;
    sums[b][1] -= block->weight;
    for (int i = 0; i < 3 && !block->support[0]; i++)
      largest = fmax (largest, fabs (sums[b][i]));
  }
  return largest;
}

/* Wall 1 jumps before it collapses. The forces kept of every step balance its loads, those
 * after the jump too. */
static void
test_forces_of_every_step (void)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  test_model_init_wall (&model, 1, 0);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  g_assert_cmpuint (result.step_count, >, 10);
  for (size_t s = 0; s < result.step_count; s++) {
    g_assert_true (qn_result_has_forces (&result, s));
    g_assert_cmpfloat (largest_imbalance (&model, &contacts, &result, s), <, 0.01);
  }
  /* What is kept of the last step is what stands for itself. */
  size_t last = (result.step_count - 1) * result.pair_count;
  for (size_t p = 0; p < result.pair_count; p++) {
    g_assert_cmpfloat (result.step_forces[2 * (last + p)], ==,
                       result.pairs[p].normal_force);
    g_assert_cmpint (result.step_states[last + p], ==, result.pairs[p].state);
  }
}

/* Blocks on points may swing, but a live load that acts along their weight does not ask them to:
 * the path leads to the largest multiplier there is, without end of increments. */
static void
test_idle_live_load (void)
{
  QnModel model;
  g_auto (QnResult) result;
  test_model_init_stack (&model, 30, 1, 1);
  test_model_add_weight_loads (&model, 1);
  model.live_loads[0].vector = qn_vec2 (0, -1);
  model.contact.pairs.placement = QN_PLACEMENT_UNIFORM;
  model.contact.pairs.count = 1;
  run (&model, NULL, NULL, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_UNBOUNDED);
  g_assert_cmpint (result.statistics.iterations, <, 3000);
}

/* Every other block on joints a hundred million times softer: stiffness changes displacements,
 * not what associative joints carry. */
static void
test_soft_and_stiff (void)
{
  QnModel model;
  g_auto (QnResult) result;
  test_model_init_wall (&model, 1, 0.65);
  test_model_soften_every_other_block (&model, 1e8);
  run (&model, NULL, NULL, &result);

  g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (result.collapse_multiplier, test_walls[0].associative,
                                  1e-4);
  g_assert_cmpint (result.statistics.iterations, <, 3000);
  g_assert_false (result.mechanism_uncertain);
}

/* A block that a bar holds down at one side is tipped about the other until the bar breaks: the collapse
 * multiplier is what the bar carries, by every procedure, not what the block carries afterwards. */
static void
test_strength_that_is_lost (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  const double area = 1e-4, strength = 5e7, arm = 1.9, weight = 1e4, tolerance = 1e-4;
  double expected = (weight * 1 + strength * area * arm) / (weight * 0.25);

  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    QnModel model;
    g_auto (QnResult) result;
    init_block (&model);
    model.laws[0].friction = 10;
    QnLaw *steel = qn_model_add_law (&model, "steel");
    steel->kind = QN_LAW_STEEL;
    steel->basis = QN_BASIS_MATERIAL;
    steel->kn = 2e11;
    steel->ks = 8e10;
    steel->yield = 4e7;
    steel->strength = strength;
    steel->ultimate_strain = 0.05;
    steel->fracture_energy = 1e6;
    QnBar *bar = qn_model_add_bar (&model);
    *bar = (QnBar){
      .law = 1, .area = area, .start = { 1 - arm, -0.2 }, .end = { 1 - arm, 0.3 }
    };
    model.analysis.procedure = procedures[i];
    model.analysis.multiplier_tolerance = tolerance;
    run (&model, NULL, NULL, &result);
    g_assert_cmpint (result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_false (result.mechanism_uncertain);
    g_assert_cmpfloat (fabs (result.collapse_multiplier / expected - 1), <=, tolerance);
    g_assert_cmpfloat (result.mechanism[QN_DOF_COUNT + QN_DOF_RZ], <, 0);
  }
}

QN_TESTS
{
  g_test_add_func ("/path-load/displacement-of-collapse", test_displacement_of_collapse);
  g_test_add_func ("/path-load/target", test_target);
  g_test_add_func ("/path-load/increments", test_collapse_does_not_depend_on_increments);
  g_test_add_func ("/path-load/steps", test_steps_do_not_depend_on_increments);
  g_test_add_func ("/path-load/digits", test_digits_beyond_the_bracket);
  g_test_add_func ("/path-load/no-live-load", test_no_live_load);
  g_test_add_func ("/path-load/unbounded", test_unbounded);
  g_test_add_func ("/path-load/idle-live-load", test_idle_live_load);
  g_test_add_func ("/path-load/soft-and-stiff", test_soft_and_stiff);
  g_test_add_func ("/path-load/dead-load-unstable", test_dead_load_unstable);
  g_test_add_func ("/path-load/no-snap", test_no_snap);
  g_test_add_func ("/path-load/nonlinear-geometry", test_nonlinear_geometry);
  g_test_add_func ("/path-load/cancel/keeps", test_cancel_keeps_what_converged);
  g_test_add_func ("/path-load/cancel/anywhere", test_cancel_anywhere);
  g_test_add_func ("/path-load/cancel/what-is-sought", test_cancel_what_is_sought);
  g_test_add_func ("/path-load/creeping/ends", test_creeping_ends);
  g_test_add_func ("/path-load/creeping/to-a-target", test_creeping_to_a_target);
  g_test_add_func ("/path-load/peak-within-a-step", test_peak_within_a_step);
  g_test_add_func ("/path-load/repeatable", test_repeatable);
  g_test_add_func ("/path-load/strength-that-is-lost", test_strength_that_is_lost);
  g_test_add_func ("/path-load/forces-of-every-step", test_forces_of_every_step);
}
