/* Structures that hardly stand, do not stand, stand only just, or are none. */
#include "stress/cases.h"

#include "support/models.h"
#include "support/walls.h"

#include <math.h>

/* Parts by which a start misses the verge between standing and falling. */
static const double misses[] = { -0.1, -1e-3, -1e-6, -1e-9, 0, 1e-9, 1e-6, 1e-3, 0.1 };

/* Nearer than this to the verge, standing and falling are both right. */
#define VERGE 1e-5

/* --- At the verge ----------------------------------------------------------------------- */

#define SLOPE 0.4

/* A block on a slope whose friction exceeds what it needs by the part `value`. */
static void
build_slope (const StressCase *c, QnModel *model)
{
  test_model_init_block_on_plane (model, 2, 0.5);
  test_model_rotate (model, -SLOPE);
  test_model_add_weight_loads (model, 1);
  model->laws[0].friction = (1 + c->value) * tan (SLOPE);
}

/* A block whose weight acts `value` of its width inside the edge that it stands on. */
static void
build_overhang (const StressCase *c, QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -2, -1, 2, 1);
  test_model_add_rectangle (model, "b", -0.5 - c->value, 0, 1, 1);
  test_model_add_weight_loads (model, 1);
}

/* One of the six walls under a dead load that is 1 - `value` times what it carries. */
static void
build_loaded (const StressCase *c, QnModel *model)
{
  double most = test_walls[c->number - 1].associative;

  test_model_init_wall (model, c->number, 0);
  model->dead_loads[0].vector.x = (1 - c->value) * most;
}

/* A semicircular arch of 27 straight voussoirs, `value` thicker than the thinnest that stands. */
static void
build_arch_at_rest (const StressCase *c, QnModel *model)
{
  test_arch_init (model, 0.106721 * (1 + c->value), 27, 1);
  model->laws[0].friction = 2;
}

/* A block that hangs from its support by tension which exceeds its weight by the part `value`. */
static void
build_hanging (const StressCase *c, QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1, 0, 2, 1);
  test_model_add_rectangle (model, "b", -0.5, -1, 1, 1);
  test_model_add_weight_loads (model, 1);
  model->laws[0].cohesion = 1e5;
  model->laws[0].tension = (1 + c->value) * 10000 / 2;
}

static void
add_verges (GArray *cases)
{
  static const struct {
    const char *name;
    StressBuild build;
  } kinds[] = { { "slope", build_slope },
                { "overhang", build_overhang },
                { "arch", build_arch_at_rest },
                { "hanging", build_hanging } };

  for (size_t kind = 0; kind < G_N_ELEMENTS (kinds); kind++)
    for (size_t i = 0; i < G_N_ELEMENTS (misses); i++) {
      StressCase *c = stress_cases_add (
        cases, "dead load at the verge, part that is left", kinds[kind].build, 0,
        misses[i], "%s%+g", kinds[kind].name, misses[i]);
      c->brief = true;
      if (fabs (misses[i]) < VERGE)
        c->expectation = STRESS_EXPECT_VERGE;
      if (kinds[kind].build == build_slope && misses[i] > VERGE)
        c->exact[0] = c->exact[1] = tan (atan ((1 + misses[i]) * tan (SLOPE)) - SLOPE);
      if (kinds[kind].build == build_overhang && misses[i] > VERGE)
        c->exact[0] = c->exact[1] = 2 * misses[i];
    }
  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++)
    for (size_t i = 0; i < G_N_ELEMENTS (misses); i++) {
      StressCase *c = stress_cases_add (
        cases, "dead load at the verge, part that is left", build_loaded, wall, misses[i],
        "loaded%+g-wall%d", misses[i], wall);
      c->brief = wall == 1 || wall == 3;
      if (fabs (misses[i]) < VERGE)
        c->expectation = STRESS_EXPECT_VERGE;
    }
}

/* --- Mechanisms and singular tangents --------------------------------------------------- */

/* A stack on single pairs: every joint turns freely, and the weight stands exactly on it. */
static void
build_pendulum (const StressCase *c, QnModel *model)
{
  test_model_init_stack (model, c->number, 1, 1);
  test_model_add_weight_loads (model, 1);
  model->contact.pairs.placement = QN_PLACEMENT_UNIFORM;
  model->contact.pairs.count = 1;
}

/* The same that no live load turns: the structure is free to, but nothing asks it. */
static void
build_idle_pendulum (const StressCase *c, QnModel *model)
{
  build_pendulum (c, model);
  model->live_loads[0].vector = qn_vec2 (0, -1);
}

/* Blocks without weight on top of blocks with weight: joints without forces. */
static void
build_weightless (const StressCase *c, QnModel *model)
{
  test_model_init_stack (model, c->number, 1, 1);
  test_model_add_weight_loads (model, 1);
  for (size_t i = 3; i < model->block_count; i++)
    model->blocks[i].unit_weight = 0;
}

/* A frictionless wall under its weight: every course is free to slide. */
static void
build_idle_slide (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].friction = 0;
  model->live_loads[0].vector = qn_vec2 (0, -1);
}

/* A block without weight beside a wall, held by nothing; or one with weight. */
static void
build_leaning_on_air (const StressCase *c, QnModel *model)
{
  test_model_init_stack (model, 2, 1, 1);
  QnBlock *block = test_model_add_rectangle (model, "aside", 1, 0.5, 1, 1);
  block->unit_weight = c->value;
  test_model_add_weight_loads (model, 1);
}

/* Blocks between two fixed cheeks with nothing below: they wedge with dilatancy, and fall
 * without. */
static void
build_wedged (const StressCase *c, QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1, 0, 1, 1)->name[0] = 'l';
  for (int i = 0; i < c->number; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i + 1);
    test_model_add_rectangle (model, name, i, 0, 1, 1);
  }
  test_model_add_base (model, c->number, 0, 1, 1);
  test_model_add_weight_loads (model, 1);
}

/* Live load that pulls everything up: at 1 nothing weighs anything any more. */
static void
build_uplift (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->live_loads[0].vector = qn_vec2 (0, 1);
}

/* Live load that can only press: no multiplier is too large. */
static void
build_pressed (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->live_loads[0].vector = qn_vec2 (0, -1);
}

/* A foot between two cheeks that cannot be pushed over. */
static void
build_confined (const StressCase *c, QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1, -1, c->number + 2, 1);
  for (int i = 0; i < c->number; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i + 1);
    test_model_add_rectangle (model, name, i, 0, 1, 0.5);
  }
  test_model_add_base (model, c->number, 0, 1, 1)->name[0] = 'r';
  test_model_add_weight_loads (model, 1);
}

static void
add_mechanisms (GArray *cases)
{
  const char *subject = "mechanisms and singular tangents";
  static const int counts[] = { 1, 3, 30 };

  for (size_t i = 0; i < G_N_ELEMENTS (counts); i++) {
    int n = counts[i];
    StressCase *c =
      stress_cases_add (cases, subject, build_pendulum, n, 0, "pendulum-of-%d", n);
    c->expectation = STRESS_EXPECT_VERGE;
    c->brief = true;
    stress_cases_add (cases, subject, build_idle_pendulum, n, 0, "idle-pendulum-of-%d", n)
      ->brief = true;
    c = stress_cases_add (cases, subject, build_weightless, 2 + n, 0, "%d-weightless", n);
    c->exact[0] = c->exact[1] = 0.5;
    c->brief = true;
    stress_cases_add (cases, subject, build_wedged, n, 0, "wedged-%d", n)->brief = true;
    stress_cases_add (cases, subject, build_confined, n, 0, "confined-%d", n)->brief =
      true;
  }
  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++) {
    bool brief = wall == 1 || wall == 4;
    stress_cases_add (cases, subject, build_idle_slide, wall, 0, "idle-slide-wall%d",
                      wall)
      ->brief = brief;
    StressCase *c =
      stress_cases_add (cases, subject, build_uplift, wall, 0, "uplift-wall%d", wall);
    c->exact[0] = c->exact[1] = 1;
    c->brief = brief;
    stress_cases_add (cases, subject, build_pressed, wall, 0, "pressed-wall%d", wall)
      ->brief = brief;
  }
  stress_cases_add (cases, subject, build_leaning_on_air, 0, 10000, "beside-a-wall")
    ->brief = true;
  stress_cases_add (cases, subject, build_leaning_on_air, 0, 0,
                    "weightless-beside-a-wall")
    ->brief = true;
}

/* --- No structure ----------------------------------------------------------------------- */

static void
build_floating (const StressCase *c, QnModel *model)
{
  (void) c;
  test_model_init_stack (model, 2, 1, 1);
  test_model_add_rectangle (model, "cloud", 5, 5, 1, 1);
  test_model_add_weight_loads (model, 1);
}

static void
build_unsupported (const StressCase *c, QnModel *model)
{
  (void) c;
  test_model_init_stack (model, 2, 1, 1);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    model->blocks[0].support[dof] = false;
  test_model_add_weight_loads (model, 1);
}

static void
build_overlapping (const StressCase *c, QnModel *model)
{
  test_model_init_stack (model, 2, 1, 1);
  test_model_add_rectangle (model, "twin", c->value, 0, 1, 1);
  test_model_add_weight_loads (model, 1);
}

static void
build_empty (const StressCase *c, QnModel *model)
{
  (void) c;
  test_model_init (model);
}

static void
build_flat_block (const StressCase *c, QnModel *model)
{
  (void) c;
  test_model_init_stack (model, 2, 1, 1);
  test_model_add_rectangle (model, "line", 0, 2, 1, 0);
  test_model_add_weight_loads (model, 1);
}

static void
add_refused (GArray *cases, StressBuild build, double value, QnProblem problem,
             const char *name)
{
  StressCase *c = stress_cases_add (cases, "no structure", build, 0, value, "%s", name);

  c->expectation = STRESS_EXPECT_REFUSED;
  c->problem = problem;
  c->brief = true;
}

void
stress_cases_add_starts (GArray *cases)
{
  add_verges (cases);
  add_mechanisms (cases);
  add_refused (cases, build_floating, 0, QN_PROBLEM_BLOCK_FLOATING, "floating-block");
  add_refused (cases, build_unsupported, 0, QN_PROBLEM_NO_SUPPORT, "no-support");
  add_refused (cases, build_overlapping, 0, QN_PROBLEM_BLOCKS_OVERLAP,
               "same-place-twice");
  add_refused (cases, build_overlapping, 0.999, QN_PROBLEM_BLOCKS_OVERLAP, "overlap");
  add_refused (cases, build_empty, 0, QN_PROBLEM_NO_BLOCKS, "no-blocks");
  add_refused (cases, build_flat_block, 0, QN_PROBLEM_DUPLICATE_VERTEX,
               "block-without-area");
}
