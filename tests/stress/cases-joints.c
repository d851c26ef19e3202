/* Joints of extreme stiffness, friction and strength, on the six walls. */
#include "stress/cases.h"

#include "support/models.h"

#include <math.h>

/* Weight of a full block of the six walls, N. */
#define BLOCK_WEIGHT (0.4 * 0.175 * 10000)

static void
build_stiffness (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].kn = model->laws[0].ks = c->value;
}

static void
build_ratio (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].ks = c->value * model->laws[0].kn;
}

static void
build_friction (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].friction = c->value;
}

static void
build_cohesion (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].cohesion = c->value * BLOCK_WEIGHT;
}

static void
build_tension (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].cohesion = model->laws[0].tension = c->value * BLOCK_WEIGHT;
}

/* Tension up to the cone's apex. */
static void
build_apex (const StressCase *c, QnModel *model)
{
  build_cohesion (c, model);
  model->laws[0].tension = 1e12;
}

/* Tension without cohesion: the apex is at zero, and the cut-off beyond it. */
static void
build_cut_off_beyond_apex (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->laws[0].tension = c->value * BLOCK_WEIGHT;
}

/* Two laws that differ by a factor, on every other block. */
static void
build_stiffness_contrast (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  test_model_soften_every_other_block (model, c->value);
}

void
stress_cases_add_joints (GArray *cases)
{
  static const double friction[] = { 0,   1e-6, 0.01, 0.05, 0.1, 0.2, 0.4,
                                     0.8, 1,    1.5,  2,    3,   4,   5 };
  static const double strength[] = { 1e-6, 1e-3, 0.1, 1, 10, 1e3 };

  for (int power = 3; power <= 15; power++)
    stress_cases_add_on_walls (cases, "kn = ks, N/m", build_stiffness, pow (10, power),
                               "kn");
  for (int power = -4; power <= 4; power++)
    stress_cases_add_on_walls (cases, "ks / kn", build_ratio, pow (10, power), "ks/kn");
  for (int power = 1; power <= 4; power++)
    stress_cases_add_on_walls (cases, "stiffness of every other block's joints, part",
                               build_stiffness_contrast, pow (100, power), "contrast");
  for (size_t i = 0; i < G_N_ELEMENTS (friction); i++)
    stress_cases_add_on_walls (cases, "friction", build_friction, friction[i],
                               "friction");
  for (size_t i = 0; i < G_N_ELEMENTS (strength); i++)
    stress_cases_add_on_walls (cases, "cohesion, weights of a block", build_cohesion,
                               strength[i], "cohesion");
  for (size_t i = 0; i < G_N_ELEMENTS (strength); i++)
    stress_cases_add_on_walls (cases, "cohesion = tension, weights of a block",
                               build_tension, strength[i], "tension");
  for (size_t i = 0; i < G_N_ELEMENTS (strength); i++)
    stress_cases_add_on_walls (cases, "cohesion, tension to the apex, weights of a block",
                               build_apex, strength[i], "apex");
  stress_cases_add_on_walls (cases, "tension without cohesion, weights of a block",
                             build_cut_off_beyond_apex, 1, "cut-off");
}
