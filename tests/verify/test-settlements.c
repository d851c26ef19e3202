/* Settling supports, against closed forms and limit analysis. */
#include "core/limit/limit.h"
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

#define SPREAD 0.04 /* m */

static void
add_settlement (QnModel *model, QnId block, QnDof dof, double value)
{
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_SETTLEMENT;
  load->block = block;
  load->dof = dof;
  load->value = value;
}

/* Clamped elastic beam of length L, one end of which sinks by s, or turns by phi: reactions
 * 12 EI s/L^3, 6 EI s/L^2, and 4 EI phi/L, 2 EI phi/L, stiff in shear. */
static void
init_beam (TestRun *run, int faces)
{
  const double L = 4, d = 0.2, h = L / faces;
  qn_model_init (&run->model);
  QnLaw *law = qn_model_add_law (&run->model, "member");
  *law = (QnLaw){ .name = law->name,
                  .kind = QN_LAW_ELASTIC,
                  .basis = QN_BASIS_MATERIAL,
                  .kn = 30e9,
                  .ks = 1e13 };
  run->model.contact.law = 0;
  run->model.contact.pairs =
    (QnPairRule){ .placement = QN_PLACEMENT_UNIFORM, .count = 4 };
  for (int i = 0; i <= faces; i++) {
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block =
      test_model_add_rectangle (&run->model, name, (i - 0.5) * h, -d / 2, h, d);
    block->thickness = 0.2;
    block->unit_weight = 0;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = i == 0 || i == faces;
  }
}

static void
test_clamped_beam (void)
{
  enum { FACES = 40 };
  const double L = 4, EI = 30e9 * 0.2 * 0.2 * 0.2 * 0.2 / 12, s = 0.01, phi = 0.002;
  for (int turned = 0; turned < 2; turned++) {
    g_auto (TestRun) run;
    init_beam (&run, FACES);
    if (turned)
      add_settlement (&run.model, FACES, QN_DOF_RZ, phi);
    else
      add_settlement (&run.model, FACES, QN_DOF_UY, -s);
    test_run_solve (&run);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    size_t last = run.result.step_count - 1;
    g_assert_cmpfloat (run.result.steps[last].multiplier, ==, 1);
    const double *near = qn_result_step_reactions (&run.result, last), *far = near + 3;
    double force = turned ? 6 * EI * phi / (L * L) : -12 * EI * s / (L * L * L);
    double moment_far = turned ? 4 * EI * phi / L : 6 * EI * s / (L * L);
    double moment_near = turned ? 2 * EI * phi / L : 6 * EI * s / (L * L);
    /* What sinks is pulled down; it turns by phi > 0 and lifts: V = 6 EI phi/L^2 upwards on
     * the near end, downwards on the far one. */
    double sign = turned ? -1 : 1;
    g_assert_cmpfloat_with_epsilon (far[1] / (sign * force), 1, 2e-3);
    g_assert_cmpfloat_with_epsilon (near[1] / (-sign * force), 1, 2e-3);
    g_assert_cmpfloat_with_epsilon (fabs (far[2] / moment_far), 1, 2e-3);
    g_assert_cmpfloat_with_epsilon (fabs (near[2] / moment_near), 1, 2e-3);
  }
}

/* A rigid block on three fixed ones, the middle one of which sinks: when it has let go, the outer
 * ones carry half of the weight each. */
static void
test_middle_support (void)
{
  g_auto (TestRun) run;
  test_model_init (&run.model);
  for (int i = 0; i < 3; i++) {
    g_autofree char *name = g_strdup_printf ("pier%d", i);
    QnBlock *pier = test_model_add_rectangle (&run.model, name, 2 * i, -1, 0.5, 1);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      pier->support[dof] = true;
  }
  test_model_add_rectangle (&run.model, "lintel", 0, 0, 4.5, 0.5);
  QnLoad *dead = qn_model_add_dead_load (&run.model);
  dead->vector = qn_vec2 (0, -1);
  add_settlement (&run.model, 1, QN_DOF_UY, -0.01);
  test_run_solve (&run);
  double weight = run.model.blocks[3].weight, pier = run.model.blocks[1].weight;
  size_t last = run.result.step_count - 1;
  const double *first = qn_result_step_reactions (&run.result, 0);
  const double *r = qn_result_step_reactions (&run.result, last);
  g_assert_cmpfloat_with_epsilon (first[4], weight / 3 + pier, 1e-3 * weight);
  g_assert_cmpfloat_with_epsilon (r[4], pier, 1e-6 * weight);
  g_assert_cmpfloat_with_epsilon (r[1], weight / 2 + pier, 1e-6 * weight);
  g_assert_cmpfloat_with_epsilon (r[7], weight / 2 + pier, 1e-6 * weight);
}

#define RADIUS 5.0 /* m, of the middle line of arches */

/* A semicircular arch with a ring of this thickness, of so many voussoirs, between two abutments. */
static void
init_arch (TestRun *run, double ring, int count)
{
  test_model_init (&run->model);
  run->model.laws[0].kn = run->model.laws[0].ks = 1e9;
  for (int side = 0; side < 2; side++) {
    QnBlock *block = test_model_add_rectangle (&run->model, side == 0 ? "left" : "right",
                                               side == 0 ? -6.5 : 4.1, -1, 2.4, 1);
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = true;
  }
  for (int i = 0; i < count; i++) {
    QnVec2 v[4];
    for (int k = 0; k < 4; k++) {
      double angle = G_PI * (1 - (double) (i + k / 2) / count);
      double radius = RADIUS + (k == 1 || k == 2 ? 0.5 : -0.5) * ring;
      v[k] = qn_vec2 (radius * cos (angle), radius * sin (angle));
    }
    v[0].y = fabs (v[0].y) < 1e-12 ? 0 : v[0].y;
    g_autofree char *name = g_strdup_printf ("v%d", i + 1);
    QnBlock *block = qn_model_add_block (&run->model, name, v, 4);
    block->thickness = 1;
    block->unit_weight = 20000;
  }
  QnLoad *dead = qn_model_add_dead_load (&run->model);
  dead->vector = qn_vec2 (0, -1);
}

/* Arch on a spreading abutment: the thrust sinks to the least one with which it can stand. That is
 * a question of limit analysis, too: with the abutment free to move and pushed inwards by P, how
 * much of P can be taken away? */
static void
test_least_thrust (void)
{
  const double push = 55e3;
  TestRun run;
  init_arch (&run, 1, 21);
  add_settlement (&run.model, 1, QN_DOF_UX, SPREAD);
  run.model.analysis.increments = 20;
  test_run_solve (&run);
  g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
  size_t last = run.result.step_count - 1;
  double thrust = -qn_result_step_reactions (&run.result, last)[3];
  double before = -qn_result_step_reactions (&run.result, 0)[3];
  test_run_clear (&run);

  g_auto (QnLimitSolution) solution;
  init_arch (&run, 1, 21);
  run.model.laws[0].dilatancy = run.model.laws[0].friction;
  run.model.blocks[1].support[QN_DOF_UX] = false;
  for (int live = 0; live < 2; live++) {
    QnLoad *load =
      live ? qn_model_add_live_load (&run.model) : qn_model_add_dead_load (&run.model);
    load->kind = QN_LOAD_FORCE;
    load->block = 1;
    load->vector = qn_vec2 (live ? 1000 : -push, 0);
  }
  g_assert_cmpint (qn_model_prepare (&run.model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&run.model, &run.contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_associative (&run.model, &run.contacts, NULL, NULL, &solution, NULL), ==,
    QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  double least = push - 1000 * solution.upper_bound;
  g_test_message ("thrust %.3f N at rest, %.6f N spread; least %.6f N", before, thrust,
                  least);
  g_assert_cmpfloat (before, >, 1.1 * least);
  g_assert_cmpfloat_with_epsilon (thrust / least, 1, 1e-6);
  qn_contacts_clear (&run.contacts);
  qn_model_clear (&run.model);
}

/* Of a part of a ring between two angles from the crown: area, and its centroid. */
static double
part_of_ring (const double radius[2], double from, double to, QnVec2 *centroid)
{
  const double half = 0.5 * (to - from), middle = 0.5 * (from + to);
  const double area = (radius[1] * radius[1] - radius[0] * radius[0]) * half;
  const double r =
    2.0 / 3 * (pow (radius[1], 3) - pow (radius[0], 3)) * sin (half) / area;
  *centroid = qn_vec2 (r * sin (middle), r * cos (middle));
  return area;
}

/* What the thrust of the half arch lacks to pass through the extrados at the springing, when that has moved
 * out by x: between a hinge at the extrados of the crown and one at the intrados at the angle a the arch has
 * turned, the part below has gone with the abutment. *thrust: over the unit weight. */
static double
lack_at_springing (const double radius[2], double a, double x, double *thrust)
{
  const QnVec2 crown = qn_vec2 (0, radius[1]);
  const QnVec2 foot = qn_vec2 (radius[0] * sin (a), radius[0] * cos (a));
  const double length = qn_vec2_length (qn_vec2_sub (crown, foot));
  const double height = sqrt (length * length - (foot.x + x) * (foot.x + x));
  const double turned = acos (height / length) - atan2 (foot.x, crown.y - foot.y);
  QnVec2 upper, lower;
  double above = part_of_ring (radius, 0, a, &upper);
  double below = part_of_ring (radius, a, G_PI / 2, &lower);
  QnVec2 g = qn_vec2_sub (upper, crown);
  double lever =
    g.x * cos (turned) - g.y * sin (turned); /* of the part above, from the crown */
  *thrust = above * (foot.x + x - lever) / height;
  return above * (radius[1] + x - lever) + below * (radius[1] - lower.x)
         - *thrust * (foot.y + height);
}

/* An arch on spreading supports collapses when a fifth hinge opens at the springing, its first three being
 * at the crown and where the thrust is least (the theory of Ochsendorf 2002, whose program ArchSpread in the
 * appendix does this step by step). */
static void
test_spread (void)
{
  static const double rings[] = { 0.6, 1, 1.25 };
  enum { COUNT = 36 };
  for (gsize i = 0; i < G_N_ELEMENTS (rings); i++) {
    const double radius[2] = { RADIUS - 0.5 * rings[i], RADIUS + 0.5 * rings[i] };
    double hinge = 0, most = 0, thrust, low = 0, high = 0.25 * RADIUS;
    for (int k = 1; k < COUNT / 2; k++) {
      lack_at_springing (radius, G_PI * k / COUNT, 0, &thrust);
      hinge = thrust > most ? G_PI * k / COUNT : hinge;
      most = fmax (most, thrust);
    }
    for (int k = 0; k < 60; k++) {
      double x = 0.5 * (low + high);
      *(lack_at_springing (radius, hinge, x, &thrust) > 0 ? &low : &high) = x;
    }
    TestRun run;
    init_arch (&run, rings[i], COUNT);
    run.model.laws[0].kn = run.model.laws[0].ks = 1e10;
    run.model.laws[0].friction = 5; /* nothing slides: from 2.5 down the thick one does */
    run.model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
    run.model.analysis.increments = 100;
    add_settlement (&run.model, 1, QN_DOF_UX, 3 * low);
    test_run_solve (&run);
    double found = 1.5 * run.result.collapse_multiplier * low;
    g_test_message ("ring %g m, hinge at %.0f degrees: collapse at %.5f m of %.5f m",
                    rings[i], hinge * 180 / G_PI, 2 * found, 2 * low);
    g_assert_cmpint (run.result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat_with_epsilon (found / low, 1, 1e-3);
    test_run_clear (&run);
  }
}

QN_TESTS
{
  g_test_add_func ("/verify/settlements/clamped-beam", test_clamped_beam);
  g_test_add_func ("/verify/settlements/middle-support", test_middle_support);
  g_test_add_func ("/verify/settlements/least-thrust", test_least_thrust);
  g_test_add_func ("/verify/settlements/spread", test_spread);
}
