/* How the path is followed, and from which side the wall is loaded. */
#include "stress/cases.h"

#include "support/models.h"
#include "support/walls.h"

#include <math.h>

static void
build_increments (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->analysis.increments = (int32_t) c->value;
}

static void
build_tolerance (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->analysis.multiplier_tolerance = c->value;
}

static void
build_residual (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->analysis.residual_tolerance = c->value;
}

static void
build_small_load (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->live_loads[0].vector.x = c->value;
}

static void
build_turned (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  test_model_rotate (model, c->value);
}

static void
build_renumbered (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  test_model_renumber (model, (unsigned) c->value);
}

static void
build_wall (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
}

static void
build_arch (const StressCase *c, QnModel *model)
{
  test_arch_init (model, c->value, c->number, 1);
}

static void
add_symmetric (GArray *cases)
{
  for (int wall = 1; wall <= TEST_WALL_COUNT; wall++) {
    StressCase *c = stress_cases_add (cases, "symmetric, loaded from both sides",
                                      build_wall, wall, 0, "symmetric-wall%d", wall);
    c->symmetric = true;
    c->brief = wall < TEST_WALL_COUNT;
  }
  for (int count = 10; count <= 40; count += 10) {
    StressCase *c =
      stress_cases_add (cases, "symmetric, loaded from both sides", build_arch, count,
                        0.15, "symmetric-arch-of-%d", count);
    c->symmetric = c->brief = true;
  }
}

void
stress_cases_add_steps (GArray *cases)
{
  static const double increments[] = { 1, 2, 3, 5, 10, 30, 100, 300, 1000, 3000, 10000 };

  for (size_t i = 0; i < G_N_ELEMENTS (increments); i++)
    stress_cases_add_on_walls (cases, "increments", build_increments, increments[i],
                               "increments");
  for (int power = -2; power >= -8; power -= 2)
    stress_cases_add_on_walls (cases, "multiplier tolerance", build_tolerance,
                               pow (10, power), "tolerance");
  for (int power = -6; power >= -12; power -= 2)
    stress_cases_add_on_walls (cases, "residual tolerance", build_residual,
                               pow (10, power), "residual");
  for (int power = -6; power <= 6; power += 3)
    stress_cases_add_on_walls (cases, "live load, times the weight", build_small_load,
                               pow (10, power), "live");
  for (int degrees = 15; degrees < 360; degrees += 75)
    stress_cases_add_on_walls (cases, "turned with its loads, rad", build_turned,
                               degrees * G_PI / 180, "turned");
  for (int seed = 1; seed <= 3; seed++)
    stress_cases_add_on_walls (cases, "blocks in random order", build_renumbered, seed,
                               "order");
  add_symmetric (cases);
}
