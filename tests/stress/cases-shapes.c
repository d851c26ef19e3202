/* Structures of extreme size, place, slenderness, and with slivers among their blocks. */
#include "stress/cases.h"

#include "support/models.h"
#include "support/walls.h"

#include <math.h>

static void
build_size (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  test_model_scale (model, c->value);
}

/* The same wall in another unit of length: millimetres and newtons instead of metres. */
static void
build_unit (const StressCase *c, QnModel *model)
{
  double unit = c->value; /* of the file's lengths per metre */

  test_model_init_wall (model, c->number, 0);
  test_model_scale (model, unit);
  model->laws[0].kn /= unit;
  model->laws[0].ks /= unit;
  for (size_t i = 0; i < model->block_count; i++) {
    model->blocks[i].thickness *= unit;
    model->blocks[i].unit_weight /= pow (unit, 3);
  }
}

static void
build_shifted (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  test_model_translate (model, c->value, -0.7 * c->value);
}

static void
build_heavy (const StressCase *c, QnModel *model)
{
  test_model_init_wall (model, c->number, 0);
  model->walls[0].unit_weight = c->value;
}

/* Running bond of 5 x 6 blocks, `value` times as long as high. */
static void
build_aspect (const StressCase *c, QnModel *model)
{
  QnVec2 unit = qn_vec2 (0.3 * sqrt (c->value), 0.3 / sqrt (c->value));
  test_bond_init (model, unit, 5, 6, 0, 0);
}

/* Friction that makes blocks turn about the slivers rather than slide. With number = 1 a contact tolerance that tells both sides of the sliver apart, with 0 the usual
 * one, which is about the size of the thinnest. */
static void
make_rough (const StressCase *c, QnModel *model, double part)
{
  model->laws[0].friction = 1.5;
  if (c->number == 1)
    model->contact.tolerance = fmin (model->contact.tolerance, 1e-3 * part);
}

/* Running bond of five courses, the third of which is thin: `value` of a block's height. */
static void
build_thin_course (const StressCase *c, QnModel *model)
{
  double unit = 0.4, height = 0.2, y = 0;

  test_model_init (model);
  test_model_add_base (model, 0, -height, 4 * unit, height);
  for (int course = 0; course < 5; course++) {
    double h = course == 2 ? c->value * height : height;
    bool shifted = course % 2 != 0;
    for (int i = 0; i < (shifted ? 5 : 4); i++) {
      g_autofree char *name = g_strdup_printf ("b%d.%d", course, i);
      double left = shifted ? MAX (0, (i - 0.5) * unit) : i * unit;
      double right = shifted ? MIN (4 * unit, (i + 0.5) * unit) : (i + 1) * unit;
      test_model_add_rectangle (model, name, left, y, right - left, h);
    }
    y += h;
  }
  test_model_add_weight_loads (model, 1);
  make_rough (c, model, c->value);
}

/* Chips of `value` of a block's area in the bed joint under its corners: the block rests on
 * them. */
static void
build_chips (const StressCase *c, QnModel *model)
{
  double unit = 0.4, height = 0.2, chip = sqrt (c->value * unit * height);

  test_model_init (model);
  test_model_add_base (model, 0, -height, 2 * unit, height);
  test_model_add_rectangle (model, "b1", 0, 0, unit, height);
  test_model_add_rectangle (model, "b2", unit, 0, unit, height);
  test_model_add_rectangle (model, "chip1", unit / 2, height, chip, chip);
  test_model_add_rectangle (model, "chip2", 1.5 * unit - chip, height, chip, chip);
  test_model_add_rectangle (model, "b3", unit / 2, height + chip, unit, height);
  test_model_add_weight_loads (model, 1);
  make_rough (c, model, chip / height);
}

/* One block over another, on a strip of `value` of its length: faces of very different size. */
static void
build_narrow_bearing (const StressCase *c, QnModel *model)
{
  double unit = 0.4, height = 0.2, strip = c->value * unit;

  test_model_init (model);
  test_model_add_base (model, 0, -height, 3 * unit, height);
  test_model_add_rectangle (model, "b1", 0, 0, unit, height);
  test_model_add_rectangle (model, "b2", unit, 0, unit, height);
  test_model_add_rectangle (model, "b3", strip, height, unit, height);
  test_model_add_rectangle (model, "b4", unit + strip, height, unit, height);
  test_model_add_weight_loads (model, 1);
  make_rough (c, model, c->value);
}

/* A stack overturns at its foot at width / height, unless it slides. */
static void
build_stack (const StressCase *c, QnModel *model)
{
  test_model_init_stack (model, c->number, 1, c->value);
  test_model_add_weight_loads (model, 1);
}

static void
build_bonded_tower (const StressCase *c, QnModel *model)
{
  test_bond_init (model, TEST_UNIT, 2, (int) (c->number / 2.5), 0, 0);
}

/* A row of blocks that push one another: all slide, or the last one overturns. */
static void
build_row (const StressCase *c, QnModel *model)
{
  test_model_init (model);
  test_model_add_base (model, -1, -1, c->number + 2, 1);
  for (int i = 0; i < c->number; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i + 1);
    test_model_add_rectangle (model, name, i, 0, 1, 0.5);
  }
  test_model_add_weight_loads (model, 1);
}

static void
expect (StressCase *c, double multiplier)
{
  c->exact[STRESS_ASSOCIATIVE] = c->exact[STRESS_SLIDING] = multiplier;
}

static void
add_towers (GArray *cases)
{
  static const int counts[] = { 10, 100, 500, 2000 };

  for (size_t i = 0; i < G_N_ELEMENTS (counts); i++) {
    int n = counts[i];
    bool brief = n <= 500;
    StressCase *c =
      stress_cases_add (cases, "towers and rows", build_stack, n, 0.5, "stack-of-%d", n);
    expect (c, fmin (0.65, 1 / (0.5 * n)));
    c->brief = brief;
    c = stress_cases_add (cases, "towers and rows", build_stack, n, 0.01,
                          "stack-of-%d-slabs", n);
    expect (c, fmin (0.65, 1 / (0.01 * n)));
    c->brief = n <= 100;
    stress_cases_add (cases, "towers and rows", build_bonded_tower, n, 0,
                      "bonded-tower-of-%d", n)
      ->brief = n <= 100;
    c = stress_cases_add (cases, "towers and rows", build_row, n, 0, "row-of-%d", n);
    expect (c, 0.65);
    c->brief = n <= 100;
  }
}

static void
add_slivers (GArray *cases)
{
  static const struct {
    const char *name;
    StressBuild build;
  } kinds[] = { { "thin-course", build_thin_course },
                { "chips", build_chips },
                { "narrow-bearing", build_narrow_bearing } };

  for (int number = 0; number < 2; number++)
    for (size_t kind = 0; kind < G_N_ELEMENTS (kinds); kind++)
      for (int power = -6; power <= -1; power++)
        stress_cases_add (cases,
                          number == 1 ? "slivers, part of a block, with a finer tolerance"
                                      : "slivers, part of a block",
                          kinds[kind].build, number, pow (10, power), "%s%s=%g",
                          number == 1 ? "fine-" : "", kinds[kind].name, pow (10, power))
          ->brief = true;
}

void
stress_cases_add_shapes (GArray *cases)
{
  static const double units[] = { 10, 100, 1000, 1e-3 };

  for (int power = -3; power <= 4; power++)
    if (power != 0)
      stress_cases_add_on_walls (cases, "size, times that of the wall", build_size,
                                 pow (10, power), "size");
  for (size_t i = 0; i < G_N_ELEMENTS (units); i++)
    stress_cases_add_on_walls (cases, "unit of length, per metre", build_unit, units[i],
                               "unit");
  for (int power = 2; power <= 8; power++)
    stress_cases_add_on_walls (cases, "distance from the origin, m", build_shifted,
                               pow (10, power), "distance");
  for (int power = -6; power <= 12; power += 3)
    stress_cases_add_on_walls (cases, "unit weight, N/m3", build_heavy, pow (10, power),
                               "weight");
  for (int power = -4; power <= 4; power++)
    stress_cases_add (cases, "blocks, length over height", build_aspect, 0,
                      pow (10, power), "aspect=1e%d", power)
      ->brief = true;
  add_slivers (cases);
  add_towers (cases);
}
