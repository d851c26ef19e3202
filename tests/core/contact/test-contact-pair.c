/* Two springs in series: forces against the series formula, tangents against differences, and
 * how fast the internal iteration is. */
#include "core/contact/pair-series.h"

#include "core/base/tolerance.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const QnLaw stone = { .name = "stone", .kind = QN_LAW_ELASTIC, .kn = 6, .ks = 3 };
static const QnLaw lead = { .name = "lead", .kind = QN_LAW_ELASTIC, .kn = 3, .ks = 1.5 };
static const QnLaw rough = {
  .name = "rough", .kind = QN_LAW_COULOMB, .kn = 6, .ks = 3, .friction = 0.6
};
static const QnLaw smooth = {
  .name = "smooth", .kind = QN_LAW_COULOMB, .kn = 3, .ks = 1, .friction = 0.3
};
static const QnLaw lifting = { .name = "lifting",
                               .kind = QN_LAW_COULOMB,
                               .kn = 3,
                               .ks = 1,
                               .friction = 0.3,
                               .dilatancy = 0.3 };
static const QnLaw rising = { .name = "rising",
                              .kind = QN_LAW_COULOMB,
                              .kn = 6,
                              .ks = 3,
                              .friction = 0.6,
                              .dilatancy = 0.6,
                              .cohesion = 0.5,
                              .tension = 0.2 };
static const QnLaw fibre = {
  .name = "fibre", .kind = QN_LAW_BILINEAR, .kn = 4, .ks = 2, .yield = 1, .hardening = 0.2
};
static const QnLaw concrete = { .name = "concrete",
                                .kind = QN_LAW_CONCRETE,
                                .kn = 6,
                                .ks = 3,
                                .strength = 2,
                                .tension = 0.2,
                                .fracture_energy = 0.1 };

static QnPairSprings
pair_of (const QnLaw *a, const QnLaw *b)
{
  return qn_pair_springs (qn_spring_from_law (a, 1, 1), qn_spring_from_law (b, 1, 1));
}

static QnPairResponse
look (const QnPairSprings *springs, const QnPairMemory *memory, double normal,
      double tangential)
{
  QnPairResponse response;
  g_assert_true (qn_pair_evaluate (springs, memory,
                                   (const double[]){ normal, tangential }, &response));
  return response;
}

static void
assert_force (const QnPairResponse *response, double normal, double tangential)
{
  g_assert_cmpfloat_with_epsilon (response->force[0], normal, 1e-11);
  g_assert_cmpfloat_with_epsilon (response->force[1], tangential, 1e-11);
}

/* Two equal springs are one of half the stiffness; each takes half of the elongation. */
static void
test_equal (void)
{
  QnPairSprings springs = pair_of (&rough, &rough);
  QnPairMemory rest = { 0 };
  QnPairResponse r = look (&springs, &rest, -2, 1);
  g_assert_true (springs.equal);
  assert_force (&r, -6, 1.5);
  g_assert_cmpfloat (r.memory.qa[0], ==, -1);
  g_assert_cmpfloat (r.memory.qb[0], ==, -1);
  g_assert_cmpfloat (r.memory.qa[1], ==, 0.5);
  r = look (&springs, &rest, -2, 5);
  assert_force (&r, -6, 3.6);
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
}

/* Soft on stiff: k = ka kb / (ka + kb), and the hinge where the stiffnesses put it. */
static void
test_series_formula (void)
{
  QnPairSprings springs = pair_of (&stone, &lead);
  QnPairMemory rest = { 0 };
  QnPairResponse r = look (&springs, &rest, -3, 6);
  assert_force (&r, -3 * 2, 6 * 1);
  g_assert_cmpfloat_with_epsilon (r.memory.qa[0], -1, 1e-12);
  g_assert_cmpfloat_with_epsilon (r.memory.qb[0], -2, 1e-12);
  g_assert_cmpfloat_with_epsilon (r.tangent[0][0], 2, 1e-11);
  g_assert_cmpfloat_with_epsilon (r.tangent[1][1], 1, 1e-11);

  double k[2];
  qn_pair_elastic_stiffness (&springs, k);
  g_assert_cmpfloat_with_epsilon (k[0], 2, 1e-12);
  g_assert_cmpfloat_with_epsilon (k[1], 1, 1e-12);
}

/* One stone of two lengths: a column of their joint length, whatever the law. */
static void
test_lengths (void)
{
  const QnLaw *laws[] = { &stone, &rough, &fibre, &concrete };
  for (size_t i = 0; i < G_N_ELEMENTS (laws); i++) {
    QnLaw law = *laws[i];
    law.basis = QN_BASIS_MATERIAL;
    QnSpring a = qn_spring_from_law (&law, 0.7, 0.3),
             b = qn_spring_from_law (&law, 0.7, 0.1);
    QnPairSprings joined = qn_pair_springs (a, b);
    QnPairSprings iterated = { .a = a, .b = b };
    QnPairMemory m = { 0 }, n = { 0 };
    g_assert_true (joined.equal);
    g_assert_cmpfloat_with_epsilon (joined.a.kn, 0.7 * law.kn / 0.4, 1e-12);
    for (int k = 1; k <= 10; k++) {
      double q = -0.02 * k, s = 0.011 * k;
      QnPairResponse r = look (&joined, &m, q, s), t = look (&iterated, &n, q, s);
      assert_force (&t, r.force[0], r.force[1]);
      m = r.memory;
      n = t.memory;
      g_assert_cmpfloat_with_epsilon (r.memory.qa[0], 0.75 * q, 1e-12);
    }
  }
}

/* Slides where friction is smaller; the other side stays elastic. */
static void
test_unequal_friction (void)
{
  QnPairSprings springs = pair_of (&rough, &smooth);
  QnPairMemory rest = { 0 };
  QnPairResponse r = look (&springs, &rest, -3, 10);
  assert_force (&r, -6, 1.8);
  g_assert_cmpfloat_with_epsilon (r.memory.qa[1], 1.8 / 3, 1e-11);
  g_assert_cmpfloat (r.memory.a.slip, ==, 0);
  g_assert_cmpfloat_with_epsilon (r.memory.b.slip, 10 - 0.6 - 1.8, 1e-11);
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);

  r = look (&springs, &rest, 0.5, 0);
  assert_force (&r, 0, 0);
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
}

/* One side elastic, the other with friction, through a history: the same as a spring of the
 * joint stiffness that slides at mu n, because slip is all on one side. */
static void
test_one_elastic (void)
{
  static const double steps[][2] = {
    { -1, 0.2 }, { -1, 4 }, { -2, 4 }, { -2, 3 }, { -2, -5 }, { 0.5, -5 }, { -1, -4.5 },
  };
  QnLaw joint = smooth;
  joint.kn = 1 / (1 / 6.0 + 1 / 3.0);
  joint.ks = 1 / (1 / 3.0 + 1 / 1.0);
  QnPairSprings springs = pair_of (&stone, &smooth);
  QnSpring whole = qn_spring_from_law (&joint, 1, 1);
  QnPairMemory memory = { 0 };
  QnSpringMemory whole_memory = { 0 };
  for (size_t i = 0; i < G_N_ELEMENTS (steps); i++) {
    QnSpringResponse expected;
    QnPairResponse r = look (&springs, &memory, steps[i][0], steps[i][1]);
    qn_spring_evaluate (&whole, &whole_memory, steps[i], &expected);
    assert_force (&r, expected.force[0], expected.force[1]);
    memory = r.memory;
    whole_memory = expected.memory;
  }
}

/* The kinds of pair that the remaining tests go through. */
static const struct {
  const QnLaw *a, *b;
  bool symmetric;
} kinds[] = {
  { &stone, &lead, true },        { &rough, &smooth, false },
  { &rising, &lifting, true },    { &stone, &lifting, true },
  { &stone, &fibre, true },       { &fibre, &smooth, false },
  { &concrete, &stone, true },    { &concrete, &rough, false },
  { &concrete, &concrete, true }, { &rough, &rough, false },
};

/* Whether a corner of the response lies between two elongations that are hardly apart. */
static gboolean
is_apart (const QnPairResponse *one, const QnPairResponse *other)
{
  gboolean apart = one->state != other->state;
  for (int i = 0; i < 4; i++)
    apart |= fabs (one->tangent[i / 2][i % 2] - other->tangent[i / 2][i % 2]) > 1e-3;
  return apart;
}

static void
assert_tangent (const QnPairSprings *springs, const QnPairMemory *memory, double normal,
                double tangential)
{
  const double step = 1e-6, scale = 6;
  QnPairResponse at = look (springs, memory, normal, tangential);
  for (int j = 0; j < 2; j++) {
    double dn = j == 0 ? step : 0, dt = j == 1 ? step : 0;
    QnPairResponse up = look (springs, memory, normal + dn, tangential + dt);
    QnPairResponse down = look (springs, memory, normal - dn, tangential - dt);
    if (is_apart (&up, &at) || is_apart (&down, &at))
      continue; /* at a corner */
    for (int i = 0; i < 2; i++)
      g_assert_cmpfloat_with_epsilon (
        at.tangent[i][j], (up.force[i] - down.force[i]) / (2 * step), 1e-6 * scale);
  }
}

static void
test_tangents (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    QnPairSprings springs = pair_of (kinds[i].a, kinds[i].b);
    QnPairMemory memory = { 0 };
    for (int k = 0; k < 60; k++) {
      double normal = 1.3 * cos (0.7 * k) - 0.6, tangential = 2.1 * sin (1.1 * k);
      assert_tangent (&springs, &memory, normal, tangential);
      QnPairResponse r = look (&springs, &memory, normal, tangential);
      if (kinds[i].symmetric)
        g_assert_cmpfloat_with_epsilon (r.tangent[0][1], r.tangent[1][0], 1e-10);
      if (k % 3 == 0)
        memory = r.memory;
    }
  }
}

/* Both springs carry the pair's force, and their elongations add up. */
static void
test_compatible (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    QnPairSprings springs = pair_of (kinds[i].a, kinds[i].b);
    QnPairMemory memory = { 0 };
    if (springs.equal)
      continue;
    for (int k = 0; k < 40; k++) {
      double q[2] = { cos (0.9 * k) - 0.5, 2 * sin (k) };
      QnSpringResponse a, b;
      QnPairResponse r = look (&springs, &memory, q[0], q[1]);
      qn_spring_evaluate (&springs.a, &memory.a, r.memory.qa, &a);
      qn_spring_evaluate (&springs.b, &memory.b, r.memory.qb, &b);
      for (int c = 0; c < 2; c++) {
        g_assert_cmpfloat_with_epsilon (r.memory.qa[c] + r.memory.qb[c], q[c], 1e-15);
        g_assert_cmpfloat_with_epsilon (a.force[c], r.force[c], 1e-10);
        g_assert_cmpfloat_with_epsilon (b.force[c], r.force[c], 1e-10);
      }
      memory = r.memory;
    }
  }
}

/* Between an elastic spring and a parabola the gap falls quadratically: each size is at most a
 * constant times the square of the one before, with the constant of the parabola's curvature. */
static void
test_quadratic_convergence (void)
{
  QnPairSprings springs = pair_of (&stone, &concrete);
  QnPairMemory rest = { 0 };
  for (double q = -0.3; q > -0.95; q -= 0.1) {
    QnPairSeries series;
    qn_pair_series_start (&series, &springs, &rest, (const double[]){ q, 0.4 });
    int iterations = 0, squared = 0;
    while (series.size > QN_TOLERANCE_SERIES) {
      double before = series.size;
      qn_pair_series_step (&series);
      g_assert_cmpint (++iterations, <=, 6);
      g_test_message ("q %g, iteration %d: gap %g", q, iterations, series.size);
      g_assert_cmpfloat (series.size, <=, fmax (before * before, 2e-16));
      squared += series.size < 1e-3 * before;
    }
    g_assert_cmpint (squared, >=, 2);
  }
}

/* Straight branches: solved exactly as soon as the branches are right, which takes a few
 * iterations; where Newton goes to and fro between them, the sweeps find the way. */
static void
test_straight_branches (void)
{
  const QnLaw *laws[][2] = { { &rough, &smooth },
                             { &fibre, &smooth },
                             { &rough, &lifting } };
  enum { STEPS = 500, FEW = 6 };
  for (size_t i = 0; i < G_N_ELEMENTS (laws); i++) {
    QnPairSprings springs = pair_of (laws[i][0], laws[i][1]);
    QnPairMemory memory = { 0 };
    int quick = 0;
    for (int k = 0; k < STEPS; k++) {
      QnPairSeries series;
      double q[2] = { 0.7 * cos (0.037 * k) - 0.4, 3 * sin (0.061 * k) };
      qn_pair_series_start (&series, &springs, &memory, q);
      for (int step = 0; step < FEW && series.size > QN_TOLERANCE_SERIES; step++)
        qn_pair_series_step (&series);
      quick += series.size <= QN_TOLERANCE_SERIES;
      memory = look (&springs, &memory, q[0], q[1]).memory;
    }
    g_test_message ("pair %zu: %d of %d by Newton alone", i, quick, STEPS);
    g_assert_cmpint (quick, >=, STEPS * 95 / 100);
  }
}

/* A bond breaks where the other spring lets it be strained so far: a dry one opens before, the weaker of
 * two bonds relieves the other. */
static void
test_one_bond (void)
{
  QnLaw bonded = rough, weak = smooth;
  bonded.cohesion = 0.5;
  bonded.tension = 0.2;
  weak.cohesion = weak.tension = 0.05;
  QnPairSprings one = pair_of (&rough, &bonded), other = pair_of (&bonded, &rough),
                both = pair_of (&bonded, &weak);
  one.b.kn = other.a.kn = 3;
  QnPairMemory rest = { 0 };
  g_assert_false (one.equal || other.equal || both.equal);
  QnPairResponse r = look (&one, &rest, 0.9, -0.4);
  g_assert_cmpfloat_with_epsilon (r.force[0], 0, 1e-12);
  g_assert_cmpfloat (qn_pair_damage (&one, &r.memory), ==, 0);
  r = look (&other, &rest, 0.9, -0.4);
  g_assert_cmpfloat (qn_pair_damage (&other, &r.memory), ==, 0);
  r = look (&both, &rest, 0.9, 0.4);
  g_assert_cmpfloat (r.memory.a.extreme, ==, 0);
  g_assert_cmpfloat (r.memory.b.extreme, ==, 1);

  /* Pressed, it slides at the friction of the broken one, and no force of the whole one is a slip. */
  r = look (&both, &rest, -0.5, 2);
  g_assert_cmpfloat (r.memory.a.extreme, ==, 0);
  g_assert_cmpfloat_with_epsilon (r.force[1], -smooth.friction * r.force[0], 1e-9);
  g_assert_cmpint (qn_pair_state_of_force (&both, &r.memory, QN_PAIR_SLIP, r.force, 1e-6),
                   ==, QN_PAIR_SLIP);
  QnPairMemory swapped = { .a = r.memory.b, .b = r.memory.a };
  QnPairSprings mirrored = { .a = both.b, .b = both.a };
  g_assert_cmpint (
    qn_pair_state_of_force (&mirrored, &swapped, QN_PAIR_SLIP, r.force, 1e-6), ==,
    QN_PAIR_SLIP);
}

/* A crack between two halves of one stone opens once: Gf, not twice Gf. Between unequal ones
 * the weaker cracks and the stronger unloads. */
static void
test_one_crack (void)
{
  QnLaw strong = concrete;
  strong.tension = 0.3;
  const QnPairSprings pairs[] = { pair_of (&concrete, &concrete),
                                  pair_of (&concrete, &strong) };
  for (size_t i = 0; i < G_N_ELEMENTS (pairs); i++) {
    enum { STEPS = 4000 };
    QnPairMemory memory = { 0 };
    double far = 2 * concrete.fracture_energy / concrete.tension, work = 0, before = 0;
    g_assert_false (qn_pair_springs_snap_back (&pairs[i]));
    for (int k = 1; k <= STEPS; k++) {
      QnPairResponse r = look (&pairs[i], &memory, 1.000001 * far * k / STEPS, 0);
      work += 0.5 * (before + r.force[0]) * far / STEPS;
      before = r.force[0];
      memory = r.memory;
    }
    g_assert_cmpfloat_with_epsilon (before, 0, 1e-9);
    g_assert_cmpfloat_with_epsilon (work, concrete.fracture_energy, 1e-4);
  }
}

/* Of two bonds the weaker one breaks, however far one step leads and whichever way: the other is whole
 * after it, and so is concrete beside a joint. */
static void
test_weaker_bond (void)
{
  QnLaw mortar = rising, strong = rough, own = concrete;
  mortar.dilatancy = 0;
  mortar.fracture_energy_tension = strong.fracture_energy_tension = 0.3;
  strong.friction = 0.8;
  strong.cohesion = 2;
  strong.tension = 0.5;
  own.tension = 0.4;
  own.fracture_energy = 0.3;
  const QnPairSprings pairs[] = { pair_of (&mortar, &strong), pair_of (&strong, &mortar),
                                  pair_of (&mortar, &own) };
  for (size_t i = 0; i < G_N_ELEMENTS (pairs); i++)
    for (double size = 0.1; size < 10; size *= 2)
      for (double way = -1; way <= 1; way += 0.25) {
        const QnPairMemory rest = { 0 };
        QnPairResponse r = look (&pairs[i], &rest, size * (1 - fabs (way)), size * way);
        const QnSpring *stronger = i == 1 ? &pairs[i].a : &pairs[i].b;
        const QnSpringMemory *kept = i == 1 ? &r.memory.a : &r.memory.b;
        g_assert_cmpfloat (qn_spring_damage (stronger, kept), ==, 0);
        g_assert_true (size < 1 || qn_pair_damage (&pairs[i], &r.memory) > 0.5);
      }
  /* Neither is the weaker one where each has the lower strength in one direction. */
  strong.cohesion = 0.4;
  QnPairSprings crossed = pair_of (&mortar, &strong);
  g_assert_false (crossed.a.outlasts || crossed.b.outlasts);
}

/* Too little fracture energy for the length: by itself, or with what the other side gives back. */
static void
test_snap_back (void)
{
  QnLaw brittle = concrete, soft = lead;
  brittle.fracture_energy =
    0.2 * 0.2 / 3; /* crack carries nothing at twice ft (1/k + 1/k) */
  QnPairSprings springs = pair_of (&brittle, &brittle);
  g_assert_false (qn_pair_springs_snap_back (&springs));
  soft.kn = 0.5;
  springs = pair_of (&brittle, &soft);
  g_assert_true (qn_pair_springs_snap_back (&springs));
  springs = pair_of (&soft, &brittle);
  g_assert_true (qn_pair_springs_snap_back (&springs));
  brittle.fracture_energy /= 5;
  springs = pair_of (&brittle, &brittle);
  g_assert_true (qn_pair_springs_snap_back (&springs));
}

/* The state of two springs is that of the one which is worse off: open, slipping, yielding, elastic. */
static void
test_states (void)
{
  static const struct {
    const QnLaw *a, *b;
    double q[2];
    QnPairState state;
  } of[] = {
    { &concrete, &stone, { -1e-3, 0 }, QN_PAIR_STICK },
    { &concrete, &stone, { -50, 0 }, QN_PAIR_YIELD },
    { &stone, &concrete, { -50, 0 }, QN_PAIR_YIELD },
    { &concrete, &smooth, { -50, 50 }, QN_PAIR_SLIP },
    { &smooth, &concrete, { -50, -50 }, QN_PAIR_SLIP },
    { &concrete, &smooth, { 5, 0 }, QN_PAIR_OPEN },
    { &rough, &smooth, { 5, 5 }, QN_PAIR_OPEN },
  };
  QnPairMemory rest = { 0 };
  for (size_t i = 0; i < G_N_ELEMENTS (of); i++) {
    QnPairSprings springs = pair_of (of[i].a, of[i].b);
    g_assert_cmpint (look (&springs, &rest, of[i].q[0], of[i].q[1]).state, ==,
                     of[i].state);
  }
}

QN_TESTS
{
  g_test_add_func ("/contact-pair/states", test_states);
  g_test_add_func ("/contact-pair/equal", test_equal);
  g_test_add_func ("/contact-pair/weaker-bond", test_weaker_bond);
  g_test_add_func ("/contact-pair/series-formula", test_series_formula);
  g_test_add_func ("/contact-pair/lengths", test_lengths);
  g_test_add_func ("/contact-pair/unequal-friction", test_unequal_friction);
  g_test_add_func ("/contact-pair/one-elastic", test_one_elastic);
  g_test_add_func ("/contact-pair/tangents", test_tangents);
  g_test_add_func ("/contact-pair/compatible", test_compatible);
  g_test_add_func ("/contact-pair/quadratic-convergence", test_quadratic_convergence);
  g_test_add_func ("/contact-pair/straight-branches", test_straight_branches);
  g_test_add_func ("/contact-pair/one-bond", test_one_bond);
  g_test_add_func ("/contact-pair/one-crack", test_one_crack);
  g_test_add_func ("/contact-pair/snap-back", test_snap_back);
}
