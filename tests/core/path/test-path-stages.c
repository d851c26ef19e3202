#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

/* A vertical fibre: a block of unit area on a rigid base, elastic-perfectly plastic. The base's
 * spring is a million times as stiff. */
#define STIFFNESS 1e6 /* N/m of the pair of springs */
#define YIELD     1e3 /* N */

static void
init_fibre (QnModel *model, QnLawKind kind, double hardening)
{
  test_model_init (model);
  model->laws[0].kind = kind;
  model->laws[0].kn = 2 * STIFFNESS;
  model->laws[0].ks = 2 * STIFFNESS;
  model->laws[0].yield = YIELD;
  model->laws[0].hardening = hardening;
  model->contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 1 };
  test_model_add_base (model, -0.5, -1, 1, 1);
  test_model_add_rectangle (model, "block", -0.5, 0, 1, 1);
  /* One pair does not hold the rotation. */
  model->blocks[1].support[QN_DOF_RZ] = true;
}

static void
add_force (QnModel *model, const char *set, double fx, double fy)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->set = qn_model_add_load_set (model, set);
  load->block = 1;
  load->vector = qn_vec2 (fx, fy);
}

static void
add_ceiling (QnModel *model)
{
  QnBlock *block = test_model_add_rectangle (model, "ceiling", -0.5, 1, 1, 1);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    block->support[dof] = true;
}

static void
add_stage (QnModel *model, uint32_t sets, double target)
{
  QnStage *stage = qn_model_add_stage (model, "stage");
  stage->sets = sets;
  stage->has_target = true;
  stage->target = target;
  stage->increments = 10;
}

static void
add_controlled_stage (QnModel *model, QnProcedure procedure, uint32_t sets, double target)
{
  QnStage *stage = qn_model_add_stage (model, "controlled");
  stage->sets = sets;
  stage->procedure = procedure;
  stage->control.block = 1;
  stage->control.dof = QN_DOF_UY;
  stage->control.target = target;
  stage->increments = 10;
}

static void
solve (TestRun *run, QnModel *model)
{
  run->model = *model;
  test_run_solve (run);
}

/* Last step of a stage. */
static size_t
end_of (const TestRun *run, int stage)
{
  size_t end = 0;
  for (size_t i = 0; i < run->result.step_count; i++)
    if (run->result.steps[i].stage == stage)
      end = i;
  g_assert_cmpuint (end, >, 0);
  return end;
}

static double
uy (const TestRun *run, size_t step)
{
  return qn_result_step_displacements (&run->result, step)[QN_DOF_COUNT + QN_DOF_UY];
}

/* Loading into the plastic range, unloading, reloading with hardening r: the plastic part of (F -
 * Fy) (1/(r k) - 1/k) stays. Reversal reaches yield at F - 2 Fy. Every procedure ends its stages
 * right at their targets. */
static void
test_cycle_of_loads (const void *procedure)
{
  const double r = 0.25, k = STIFFNESS;
  const double plastic = 0.2 * YIELD * (1 / (r * k) - 1 / k);
  g_auto (TestRun) run;
  QnModel model;
  init_fibre (&model, QN_LAW_BILINEAR, r);
  add_force (&model, "live", 0, YIELD);
  add_stage (&model, 1, 1.2);
  add_stage (&model, 1, 0);
  add_stage (&model, 1, 1.2);
  add_stage (&model, 1, -0.8);
  add_stage (&model, 1, -1.0);
  for (size_t i = 0; i < model.stage_count; i++)
    model.stages[i].procedure = (QnProcedure) GPOINTER_TO_INT (procedure);
  solve (&run, &model);

  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  static const double multipliers[] = { 1.2, 0, 1.2, -0.8, -1.0 };
  const double expected[] = { 1.2 * YIELD / k + plastic, plastic,
                              1.2 * YIELD / k + plastic, -0.8 * YIELD / k + plastic,
                              -0.8 * YIELD / k + plastic - 0.2 * YIELD / (r * k) };
  for (int stage = 1; stage <= 5; stage++) {
    size_t end = end_of (&run, stage);
    g_assert_cmpfloat_with_epsilon (run.result.steps[end].multiplier,
                                    multipliers[stage - 1], 1e-12);
    g_assert_cmpfloat_with_epsilon (uy (&run, end), expected[stage - 1], 1e-10);
  }
  /* Between the ends, elastic all along. */
  for (size_t i = end_of (&run, 1); i <= end_of (&run, 4); i++)
    g_assert_cmpfloat_with_epsilon (
      uy (&run, i), plastic + run.result.steps[i].multiplier * YIELD / k, 1e-10);
  g_assert_cmpint (run.result.steps[0].stage, ==, 0);
}

/* The same to given displacements, without hardening: the load follows the spring, whichever way
 * leads to the target, and ends right there by every procedure. */
static void
test_cycle_of_displacements (const void *data)
{
  const QnProcedure procedure = (QnProcedure) GPOINTER_TO_INT (data);
  const double first = YIELD / STIFFNESS;
  g_auto (TestRun) run;
  QnModel model;
  init_fibre (&model, QN_LAW_ELASTIC_PLASTIC, 0);
  add_force (&model, "live", 0, YIELD);
  add_controlled_stage (&model, procedure, 1, 3 * first);
  add_controlled_stage (&model, procedure, 1, 0);
  add_controlled_stage (&model, procedure, 1, 2.5 * first);
  solve (&run, &model);

  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  static const double ends[] = { 3, 0, 2.5 }, forces[] = { 1, -1, 1 };
  for (int stage = 1; stage <= 3; stage++) {
    size_t end = end_of (&run, stage);
    g_assert_cmpfloat_with_epsilon (uy (&run, end), ends[stage - 1] * first,
                                    1e-9 * first);
    g_assert_cmpfloat_with_epsilon (run.result.steps[end].multiplier, forces[stage - 1],
                                    1e-9);
  }
  for (size_t i = 1; i < run.result.step_count; i++) {
    double u = uy (&run, i) / first, expected = 0;
    if (run.result.steps[i].stage == 1)
      expected = fmin (u, 1);
    else if (run.result.steps[i].stage == 2)
      expected = fmax (u - 2, -1);
    else
      expected = fmin (u - 1, 1);
    g_assert_cmpfloat_with_epsilon (run.result.steps[i].multiplier, expected, 1e-8);
  }
}

/* A vertical load first, then the push: a block on a plane slides at mu (W + N). The held set
 * counts, and the factors of all sets are told. */
static void
test_held_set (void)
{
  g_auto (TestRun) run;
  QnModel model;
  double factors[QN_MAX_LOAD_SETS];
  test_model_init_block_on_plane (&model, 2, 0.5);
  model.analysis.multiplier_tolerance = 1e-8;
  QnLoad *dead = qn_model_add_dead_load (&model);
  dead->vector = qn_vec2 (0, -1);
  add_force (&model, "top", 0, -5000);
  add_force (&model, "push", 10000, 0);
  g_assert_cmpint (model.load_set_count, ==, 2);
  add_stage (&model, 1 << 1, 2);
  QnStage *push = qn_model_add_stage (&model, "push");
  push->sets = 1 << 2;
  solve (&run, &model);

  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  double weight = run.model.blocks[1].weight;
  g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier,
                                  0.65 * (weight + 10000) / 10000, 1e-6);
  qn_result_load_factors (&run.model, &run.result, run.result.step_count - 1, factors);
  g_assert_cmpfloat_with_epsilon (factors[1], 2, 1e-12);
  g_assert_cmpfloat_with_epsilon (factors[2], run.result.collapse_multiplier, 1e-12);
  g_assert_cmpfloat (factors[0], ==, 0);

  /* The base carries weight, top load and push. */
  const double *reaction =
    qn_result_step_reactions (&run.result, run.result.step_count - 1);
  g_assert_cmpuint (run.result.support_count, ==, 1);
  double base = run.model.blocks[0].weight;
  g_assert_cmpfloat_with_epsilon (reaction[0], -10000 * run.result.collapse_multiplier,
                                  1e-3);
  g_assert_cmpfloat_with_epsilon (reaction[1], base + weight + 10000, 1e-3);
}

/* A stage that does not reach its end is the last one. */
static void
test_stops_at_collapse (void)
{
  g_auto (TestRun) run;
  QnModel model;
  test_model_init_block_on_plane (&model, 2, 0.5);
  test_model_add_weight_loads (&model, 1);
  add_stage (&model, 1, 5);
  add_stage (&model, 1, 0);
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, 0.65, 1e-4);
  g_assert_nonnull (run.result.mechanism);
  for (size_t i = 1; i < run.result.step_count; i++)
    g_assert_cmpint (run.result.steps[i].stage, ==, 1);
}

/* A prop in the middle of two unequal springs: the middle block settles with the support by the
 * ratio of stiffnesses, k u = k (s - u). */
static void
test_settlement (void)
{
  const double s = -2e-3;
  g_auto (TestRun) run;
  QnModel model;
  init_fibre (&model, QN_LAW_ELASTIC, 0);
  add_ceiling (&model);
  QnLoad *load = qn_model_add_live_load (&model);
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = 0;
  load->dof = QN_DOF_UY;
  load->value = s;
  solve (&run, &model);

  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat (run.result.steps[run.result.step_count - 1].multiplier, ==, 1);
  for (size_t i = 0; i < run.result.step_count; i++) {
    double m = run.result.steps[i].multiplier;
    const double *u = qn_result_step_displacements (&run.result, i);
    const double *r = qn_result_step_reactions (&run.result, i);
    g_assert_cmpfloat_with_epsilon (u[QN_DOF_UY], m * s, 1e-12);
    g_assert_cmpfloat_with_epsilon (uy (&run, i), m * s / 2, 1e-12);
    /* The ground pulls the sinking base down; the block above holds it back. */
    g_assert_cmpfloat_with_epsilon (r[QN_DOF_UY], STIFFNESS * m * s / 2, 1e-3);
    g_assert_cmpfloat_with_epsilon (r[6 + QN_DOF_UY], -STIFFNESS * m * s / 2, 1e-3);
  }
}

/* A settlement of 0, as one case of a study: the equilibrium under the dead load, at multiplier 1. */
static void
test_settlement_of_nothing (void)
{
  g_auto (TestRun) run;
  QnModel model;
  init_fibre (&model, QN_LAW_ELASTIC, 0);
  add_ceiling (&model);
  QnLoad *load = qn_model_add_live_load (&model);
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = 0;
  load->dof = QN_DOF_UY;
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (run.result.step_count, ==, 2);
  g_assert_cmpfloat (run.result.steps[1].multiplier, ==, 1);
  g_assert_cmpfloat (uy (&run, 1), ==, uy (&run, 0));
}

/* The same as a stage after a load, and taken back: the load stays. */
static void
test_settlement_stage (void)
{
  const double s = -2e-3;
  g_auto (TestRun) run;
  QnModel model;
  init_fibre (&model, QN_LAW_ELASTIC, 0);
  add_ceiling (&model);
  add_force (&model, "live", 0, -600);
  QnLoad *load = qn_model_add_live_load (&model);
  load->kind = QN_LOAD_SETTLEMENT;
  load->set = qn_model_add_load_set (&model, "ground");
  load->block = 0;
  load->dof = QN_DOF_UY;
  load->value = s;
  add_stage (&model, 1, 1);
  add_stage (&model, 2, 1);
  add_stage (&model, 2, 0);
  solve (&run, &model);
  const double loaded = -600 / (2 * STIFFNESS);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpfloat_with_epsilon (uy (&run, end_of (&run, 1)), loaded, 1e-12);
  g_assert_cmpfloat_with_epsilon (uy (&run, end_of (&run, 2)), loaded + s / 2, 1e-12);
  g_assert_cmpfloat_with_epsilon (uy (&run, end_of (&run, 3)), loaded, 1e-12);
}

/* A target that the load moves away from. */
/* Energy set free in the collapse of a block that rocks, in one stage that is to go on to the target, or
 * without stages where that is 0. */
static double
energy_of_rocking (double target)
{
  QnModel model;
  g_auto (TestRun) run;
  double energy;

  test_model_init (&model);
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  test_model_add_base (&model, -1, -1, 3, 1);
  test_model_add_rectangle (&model, "block", 0, 0, 1, 3);
  test_model_add_weight_loads (&model, 1);
  if (target > 0)
    add_stage (&model, 1, target);
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpuint (run.result.event_count, >, 0);
  energy = run.result.events[run.result.event_count - 1].energy;
  return energy;
}

/* It is that of the loads, whatever part of its target a stage has come to. */
static void
test_energy (void)
{
  double energy = energy_of_rocking (0);

  g_assert_cmpfloat (energy, >, 0);
  g_assert_cmpfloat_with_epsilon (energy_of_rocking (1), energy, 1e-3 * energy);
  g_assert_cmpfloat_with_epsilon (energy_of_rocking (10), energy, 1e-3 * energy);
}

/* --- Loads that turn back ---------------------------------------------------------------- */

static void
add_push (QnModel *model, QnId block, double target)
{
  QnStage *stage = qn_model_add_stage (model, "push");
  stage->sets = 1;
  stage->procedure = QN_PROCEDURE_DISPLACEMENT;
  stage->control.block = block;
  stage->control.dof = QN_DOF_UX;
  stage->control.target = target;
  stage->increments = 10;
}

/* Two bricks and one across their joint on a base: the top brick slides at its friction. */
static void
init_three_bricks (QnModel *model)
{
  test_model_init (model);
  model->laws[0].kn = model->laws[0].ks = 1e9;
  test_model_add_base (model, -1, -0.3, 3, 0.3);
  test_model_add_rectangle (model, "left", 0, 0, 0.5, 0.4);
  test_model_add_rectangle (model, "right", 0.5, 0, 0.5, 0.4);
  test_model_add_rectangle (model, "top", 0.25, 0.4, 0.5, 0.4);
  test_model_add_weight_loads (model, 1);
}

/* A structure that yields in one sense and in the other carries as much both ways, in every cycle, and its
 * result is true. */
static void
push_and_pull (QnModel *model, QnId block, double amplitude, double carried)
{
  g_auto (TestRun) run;
  for (int i = 0; i < 6; i++)
    add_push (model, block, (1 + i / 2) * (i % 2 == 0 ? amplitude : -amplitude));
  solve (&run, model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  for (int stage = 1; stage <= 6; stage++)
    g_assert_cmpfloat_with_epsilon (run.result.steps[end_of (&run, stage)].multiplier,
                                    stage % 2 == 1 ? carried : -carried, 1e-4 * carried);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

static void
test_bricks_to_and_fro (void)
{
  QnModel model;
  init_three_bricks (&model);
  push_and_pull (&model, 3, 0.002, 0.65);
  init_three_bricks (&model);
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  push_and_pull (&model, 3, 0.002, 0.65);
}

/* Weights that slide at the foot of a stack. */
static void
test_stack_to_and_fro (void)
{
  QnModel model;
  test_model_init_stack (&model, 5, 0.6, 0.2);
  model.laws[0].kn = model.laws[0].ks = 1e9;
  model.laws[0].friction = 0.35;
  test_model_add_weight_loads (&model, 1);
  push_and_pull (&model, 5, 0.001, 0.35);
}

/* A bond that has softened closes as its load is taken back, whatever prescribes the way, and carries the same
 * load again: it does not soften on to where it is broken, which balances no load too. */
static void
test_softened_bond_unloads (void)
{
  static const QnProcedure ways[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_WORK,
                                      QN_PROCEDURE_ARC_LENGTH };
  for (gsize i = 0; i < 4 * G_N_ELEMENTS (ways); i++) {
    g_auto (TestRun) run;
    QnModel model;
    test_model_init_block_on_plane (&model, 1, 1);
    QnLaw *law = &model.laws[0];
    law->kn = law->ks = 1e8;
    law->cohesion = 1e5;
    law->tension = 5e3;
    law->fracture_energy_tension = 2; /* falls from 0.1 mm to 0.8 mm on a line */
    law->exponential = i % 2 == 1;
    model.analysis.geometry = i % 4 < 2 ? QN_GEOMETRY_LINEAR : QN_GEOMETRY_NONLINEAR;
    model.blocks[1].support[QN_DOF_UX] = model.blocks[1].support[QN_DOF_RZ] = true;
    add_force (&model, "live", 0, 1000);
    add_controlled_stage (&model, QN_PROCEDURE_DISPLACEMENT, 1, 4e-4);
    add_stage (&model, 1, 0);
    model.stages[1].procedure = ways[i / 4];
    add_controlled_stage (&model, QN_PROCEDURE_DISPLACEMENT, 1, 4e-4);
    solve (&run, &model);
    const QnStep *steps = run.result.steps;
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    double carried = steps[end_of (&run, 1)].multiplier;
    if (!law->exponential) /* both pairs: 5 kN (0.8 - 0.4)/(0.8 - 0.1) */
      g_assert_cmpfloat_with_epsilon (carried, 10 * 0.4 / 0.7, 1e-6);
    g_assert_cmpfloat_with_epsilon (uy (&run, end_of (&run, 2)), 0, 1e-9);
    g_assert_cmpfloat_with_epsilon (steps[end_of (&run, 3)].multiplier, carried, 1e-6);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
}

/* The same of two courses in bond, of whose joints some soften and others are whole: where the load alone goes
 * back, more than one motion balances it. */
static void
test_softened_wall_unloads (void)
{
  static const QnProcedure ways[] = { QN_PROCEDURE_LOAD, QN_PROCEDURE_ARC_LENGTH };
  double left[G_N_ELEMENTS (ways)]; /* motion that is left, m */
  for (gsize i = 0; i < G_N_ELEMENTS (ways); i++) {
    g_auto (TestRun) run;
    QnModel model;
    test_model_init (&model);
    model.laws[0] = (QnLaw){ .name = model.laws[0].name,
                             .kind = QN_LAW_COULOMB,
                             .basis = QN_BASIS_SURFACE,
                             .kn = 2e10,
                             .ks = 8e9,
                             .friction = 0.6,
                             .residual_friction = 0.6,
                             .cohesion = 6e4,
                             .tension = 3e4,
                             .fracture_energy_tension = 5,
                             .fracture_energy_shear = 30 };
    model.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_LOBATTO, .count = 5 };
    test_model_add_base (&model, -0.5, -0.3, 3, 0.3);
    for (int b = 0; b < 8; b++) {
      g_autofree char *name = g_strdup_printf ("%d", b);
      double x = b < 4 ? 0.4 * b : fmax (0, 0.4 * (b - 4) - 0.2);
      QnBlock *brick = test_model_add_rectangle (&model, name, x, b < 4 ? 0 : 0.2,
                                                 b == 4 ? 0.2 : 0.4, 0.2);
      brick->thickness = 0.3;
      brick->unit_weight = 20000;
    }
    test_model_add_weight_loads (&model, 1);
    add_controlled_stage (&model, QN_PROCEDURE_DISPLACEMENT, 1, 6e-4);
    model.stages[0].control.block = 8;
    model.stages[0].control.dof = QN_DOF_UX;
    model.stages[0].increments = 20;
    add_stage (&model, 1, 0);
    model.stages[1].procedure = ways[i];
    solve (&run, &model);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    const double *u = qn_result_step_displacements (&run.result, end_of (&run, 2));
    left[i] = u[8 * QN_DOF_COUNT + QN_DOF_UX];
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
  g_assert_cmpfloat (left[0], <, 0.3 * 6e-4);
  g_assert_cmpfloat_with_epsilon (left[0], left[1], 1e-8);
}

/* A block on joints with dilatancy is as high after every cycle as after the first, and no higher
 * than dilation goes: not lifted by one push after the other. */
static void
test_block_comes_down (void)
{
  for (int ends = 0; ends < 2; ends++) {
    g_auto (TestRun) run;
    QnModel model;
    test_model_init_block_on_plane (&model, 2, 0.5);
    model.laws[0].kn = model.laws[0].ks = 1e10;
    model.laws[0].dilatancy = 0.3;
    model.laws[0].dilation_end = ends ? 0.004 : 0;
    test_model_add_weight_loads (&model, 1);
    for (int i = 0; i < 6; i++)
      add_push (&model, 1, i % 2 == 0 ? 0.01 : -0.01);
    solve (&run, &model);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    double rest = qn_result_step_displacements (&run.result, 0)[4], highest = 0;
    for (size_t s = 1; s < run.result.step_count; s++)
      highest = fmax (highest, qn_result_step_displacements (&run.result, s)[4] - rest);
    g_assert_cmpfloat_with_epsilon (highest, 0.3 * (ends ? 0.004 : 0.01), 1e-3 * highest);
    for (int stage = 1; stage <= 6; stage++)
      g_assert_cmpfloat_with_epsilon (
        qn_result_step_displacements (&run.result, end_of (&run, stage))[4] - rest,
        highest, 1e-3 * highest);
    g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  }
}

static void
test_fibre_to_and_fro (void)
{
  QnModel model;
  init_fibre (&model, QN_LAW_ELASTIC_PLASTIC, 0);
  add_force (&model, "live", 0, YIELD);
  for (int i = 0; i < 8; i++)
    add_controlled_stage (&model, QN_PROCEDURE_DISPLACEMENT, 1,
                          (i % 2 == 0 ? 3 : -3) * YIELD / STIFFNESS);
  g_auto (TestRun) run;
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  for (int stage = 1; stage <= 8; stage++)
    g_assert_cmpfloat_with_epsilon (run.result.steps[end_of (&run, stage)].multiplier,
                                    stage % 2 == 1 ? 1 : -1, 1e-6);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

/* Over a cycle that closes the loads do the work that yielding takes: four times the yield force times the way
 * beyond yield. */
static void
test_work_of_a_cycle (void)
{
  const double yield = YIELD / STIFFNESS, plastic = 4 * YIELD * 2 * yield;
  g_auto (TestRun) run;
  QnModel model;
  double work = 0;
  init_fibre (&model, QN_LAW_ELASTIC_PLASTIC, 0);
  add_force (&model, "live", 0, YIELD);
  for (int i = 0; i < 4; i++) {
    add_controlled_stage (&model, QN_PROCEDURE_DISPLACEMENT, 1,
                          (i % 2 == 0 ? 3 : -3) * yield);
    model.stages[i].increments = 2000;
  }
  solve (&run, &model);
  for (int stage = 3; stage <= 4; stage++) {
    QnStageFigures figures;
    g_assert_true (
      qn_result_stage_figures (&run.model, &run.result, stage, stage, &figures));
    g_assert_cmpuint (figures.last, ==, end_of (&run, stage));
    g_assert_cmpfloat_with_epsilon (figures.multiplier, stage == 3 ? 1 : -1, 1e-6);
    g_assert_cmpfloat_with_epsilon (figures.lowest, -1, 1e-6);
    g_assert_cmpfloat_with_epsilon (figures.highest, 1, 1e-6);
    work += figures.work;
  }
  g_assert_cmpfloat_with_epsilon (work, plastic, 0.01 * plastic);
  QnStageFigures none;
  run.result.step_count = end_of (&run, 3) + 1;
  g_assert_false (qn_result_stage_figures (&run.model, &run.result, 4, 4, &none));
}

/* Two blocks side by side, pushed by the one that leads, then pulled by the one that follows: the other then
 * overturns on its own, at half its width over its height, however long the steps were before. */
static void
test_other_block_falls (void)
{
  g_auto (TestRun) run;
  QnModel model;
  test_model_init (&model);
  model.laws[0].kn = model.laws[0].ks = 1e9;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  test_model_add_base (&model, -1, -0.3, 3, 0.3);
  test_model_add_rectangle (&model, "left", 0, 0, 0.5, 1);
  test_model_add_rectangle (&model, "right", 0.5, 0, 0.5, 1);
  test_model_add_weight_loads (&model, 1);
  add_push (&model, 2, 0.005);
  add_push (&model, 2, -0.005);
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (run.result.stage, ==, 2);
  g_assert_cmpfloat_with_epsilon (run.result.collapse_multiplier, -0.5, 5e-4);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
}

/* Jumps on the way down of a multiplier are told as on its way up. */
static void
test_arch_to_and_fro (void)
{
  g_auto (TestRun) run;
  QnModel model;
  test_model_init (&model);
  model.laws[0].kn = model.laws[0].ks = 1e9;
  model.laws[0].friction = 0.5;
  model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  for (int i = 0; i < 15; i++) {
    const double radii[] = { 2, 2, 2.5, 2.5 };
    QnVec2 vertices[4];
    for (int k = 0; k < 4; k++) {
      double angle = G_PI * (i + (k == 1 || k == 2)) / 15;
      vertices[k] = qn_vec2 (-radii[k] * cos (angle), radii[k] * sin (angle));
    }
    g_autofree char *name = g_strdup_printf ("v%d", i);
    QnBlock *block = qn_model_add_block (&model, name, vertices, 4);
    block->unit_weight = 1e4;
    block->thickness = 1;
  }
  test_model_add_base (&model, -2.5, -0.3, 5, 0.3);
  test_model_add_weight_loads (&model, 1);
  for (int i = 0; i < 4; i++)
    add_push (&model, 5, i % 2 == 0 ? 0.003 : -0.003);
  solve (&run, &model);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpint (test_run_count_faults (&run), ==, 0);
  const QnPathEvent *first = run.result.events,
                    *last = first + run.result.event_count - 1;
  g_assert_cmpuint (run.result.event_count, >, 3);
  g_assert_cmpint (first->stage, ==, 1);
  g_assert_cmpint (last->stage, ==, 4);
}

static void
test_wrong_sign (void)
{
  QnDiag diag = { 0 };
  g_auto (TestRun) run = { 0 };
  init_fibre (&run.model, QN_LAW_ELASTIC_PLASTIC, 0);
  add_force (&run.model, "live", 0, YIELD);
  QnAnalysisSettings *analysis = &run.model.analysis;
  analysis->procedure = QN_PROCEDURE_DISPLACEMENT;
  analysis->control.block = 1;
  analysis->control.dof = QN_DOF_UY;
  analysis->control.target = -1e-3;
  g_assert_cmpint (qn_model_prepare (&run.model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&run.model, &run.contacts, &diag), ==, QN_OK);
  g_assert_cmpint (
    qn_analysis_run (&run.model, &run.contacts, NULL, NULL, &run.result, &diag), ==,
    QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_CONTROL_WRONG_SIGN);
  g_assert_cmpstr (diag.field, ==, "control.target");
}

QN_TESTS
{
  g_test_add_data_func ("/core/path-stages/cycle-of-loads",
                        GINT_TO_POINTER (QN_PROCEDURE_LOAD), test_cycle_of_loads);
  g_test_add_data_func ("/core/path-stages/cycle-of-work",
                        GINT_TO_POINTER (QN_PROCEDURE_WORK), test_cycle_of_loads);
  g_test_add_data_func ("/core/path-stages/cycle-of-arcs",
                        GINT_TO_POINTER (QN_PROCEDURE_ARC_LENGTH), test_cycle_of_loads);
  g_test_add_data_func ("/core/path-stages/cycle-of-displacements",
                        GINT_TO_POINTER (QN_PROCEDURE_DISPLACEMENT),
                        test_cycle_of_displacements);
  g_test_add_data_func ("/core/path-stages/work-to-displacements",
                        GINT_TO_POINTER (QN_PROCEDURE_WORK), test_cycle_of_displacements);
  g_test_add_data_func ("/core/path-stages/arcs-to-displacements",
                        GINT_TO_POINTER (QN_PROCEDURE_ARC_LENGTH),
                        test_cycle_of_displacements);
  g_test_add_func ("/core/path-stages/held-set", test_held_set);
  g_test_add_func ("/core/path-stages/stops-at-collapse", test_stops_at_collapse);
  g_test_add_func ("/core/path-stages/settlement", test_settlement);
  g_test_add_func ("/core/path-stages/settlement-of-nothing", test_settlement_of_nothing);
  g_test_add_func ("/core/path-stages/settlement-stage", test_settlement_stage);
  g_test_add_func ("/core/path-stages/energy", test_energy);
  g_test_add_func ("/core/path-stages/bricks-to-and-fro", test_bricks_to_and_fro);
  g_test_add_func ("/core/path-stages/stack-to-and-fro", test_stack_to_and_fro);
  g_test_add_func ("/core/path-stages/fibre-to-and-fro", test_fibre_to_and_fro);
  g_test_add_func ("/core/path-stages/softened-bond-unloads", test_softened_bond_unloads);
  g_test_add_func ("/core/path-stages/softened-wall-unloads", test_softened_wall_unloads);
  g_test_add_func ("/core/path-stages/block-comes-down", test_block_comes_down);
  g_test_add_func ("/core/path-stages/work-of-a-cycle", test_work_of_a_cycle);
  g_test_add_func ("/core/path-stages/other-block-falls", test_other_block_falls);
  g_test_add_func ("/core/path-stages/arch-to-and-fro", test_arch_to_and_fro);
  g_test_add_func ("/core/path-stages/wrong-sign", test_wrong_sign);
}
