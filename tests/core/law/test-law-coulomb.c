/* Friction: kn = 2, ks = 1, mu = 0.5, so that every number can be checked in the head. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

static Probe
joint (double cohesion, double tension, double dilatancy)
{
  return probe_of_law (&(QnLaw){ .name = "joint",
                                 .kind = QN_LAW_COULOMB,
                                 .basis = QN_BASIS_CONTACT,
                                 .kn = 2,
                                 .ks = 1,
                                 .friction = 0.5,
                                 .cohesion = cohesion,
                                 .tension = tension,
                                 .dilatancy = dilatancy });
}

static void
test_stick (void)
{
  Probe p = joint (0, 0, 0);
  QnSpringResponse r = probe_go (&p, -3, 2);
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, -6, 2);
  probe_assert_tangent (&p, -3, 2);
  g_assert_cmpfloat (r.memory.slip, ==, 0);
}

/* Slides at mu |n| without dilatancy, remembers by how much, and sticks on the way back. */
static void
test_slip_and_return (void)
{
  Probe p = joint (0, 0, 0);
  probe_assert_tangent (&p, -3, 5);
  QnSpringResponse r = probe_go (&p, -3, 5);
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
  probe_assert_force (&r, -6, 3);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, 2, 1e-12);
  g_assert_cmpfloat (r.memory.opening, ==, 0);

  r = probe_go (&p, -3, 1); /* 1 - 2 = -1: sticks */
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, -6, -1);
  probe_assert_tangent (&p, -3, 1);
  r = probe_go (&p, -3, -4); /* -4 - 2 = -6: slides back by 3 */
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
  probe_assert_force (&r, -6, -3);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, -1, 1e-12);
}

/* Slip depends on where a step ends, not on how often it was looked at. */
static void
test_looking_does_not_commit (void)
{
  Probe p = joint (0, 0, 0.2);
  QnSpringResponse first = probe_look (&p, -1, 8);
  probe_look (&p, -1, -8);
  QnSpringResponse again = probe_look (&p, -1, 8);
  g_assert_cmpmem (first.force, sizeof first.force, again.force, sizeof again.force);
  g_assert_cmpmem (first.tangent, sizeof first.tangent, again.tangent,
                   sizeof again.tangent);
  g_assert_cmpfloat (first.memory.slip, ==, again.memory.slip);
  g_assert_cmpfloat (first.memory.opening, ==, again.memory.opening);
  g_assert_cmpint (first.state, ==, again.state);
}

/* Dilatancy lifts: g = (|t*| + mu n*) / (ks + mu psi kn), n = n* - kn psi g. */
static void
test_dilatancy (void)
{
  static const double psis[] = { 0.1, 0.25, 0.5 };
  for (size_t i = 0; i < G_N_ELEMENTS (psis); i++) {
    double psi = psis[i];
    Probe p = joint (0, 0, psi);
    double g = (5 - 0.5 * 6) / (1 + 0.5 * psi * 2), n = -6 - 2 * psi * g;
    QnSpringResponse r = probe_look (&p, -3, -5);
    g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
    probe_assert_force (&r, n, 0.5 * n);
    probe_assert_tangent (&p, -3, -5);
    g_assert_cmpfloat_with_epsilon (r.memory.opening, psi * g, 1e-12);
    g_assert_cmpfloat_with_epsilon (r.memory.slip, -g, 1e-12);
  }
}

/* A block of -4 that slides to and fro rises and comes down with it, and no further than dilation goes; its
 * friction does not change. `work` is what the shear force has done. */
static void
test_dilation_and_return (void)
{
  static const double ways[][2] = {
    { 2, 0.25 * 2 },  { 5, 0.25 * 3 },  { 1, 0.25 },
    { -2, 0.25 * 2 }, { -6, 0.25 * 3 }, { 0, 0 },
  };
  Probe p = probe_of_law (&(QnLaw){ .name = "joint",
                                    .kind = QN_LAW_COULOMB,
                                    .kn = 2,
                                    .ks = 1,
                                    .friction = 0.5,
                                    .dilatancy = 0.25,
                                    .dilation_end = 3 });
  for (size_t i = 0; i < G_N_ELEMENTS (ways); i++) {
    double slip = ways[i][0], sense = slip > p.memory.slip ? 1 : -1;
    double normal = -2 + ways[i][1], shear = slip + sense * 2;
    probe_assert_tangent (&p, normal, shear + 1e-3);
    QnSpringResponse r = probe_go (&p, normal, shear);
    probe_assert_force (&r, -4, sense * 2);
    g_assert_cmpfloat_with_epsilon (r.memory.slip, slip, 1e-12);
    g_assert_cmpfloat_with_epsilon (r.memory.opening, ways[i][1], 1e-12);
  }
}

/* With dilatancy = friction the law is associative: dilation adds up to and fro. */
static void
test_dilation_adds_up (void)
{
  static const double ways[][2] = { { 2, 1 }, { 0, 2 }, { -1, 2.5 }, { 3, 4.5 } };
  Probe p = joint (0, 0, 0.5);
  for (size_t i = 0; i < G_N_ELEMENTS (ways); i++) {
    double slip = ways[i][0], sense = slip > p.memory.slip ? 1 : -1;
    double normal = -2 + ways[i][1], shear = slip + sense * 2;
    QnSpringResponse r = probe_go (&p, normal, shear);
    probe_assert_force (&r, -4, sense * 2);
    g_assert_cmpfloat_with_epsilon (r.memory.slip, slip, 1e-12);
    g_assert_cmpfloat_with_epsilon (r.memory.opening, ways[i][1], 1e-12);
    g_assert_cmpfloat_with_epsilon (r.tangent[0][1], r.tangent[1][0], 1e-12);
  }
}

/* Wherever it is taken, a joint that is closed has risen by what its slip tells, and the tangents are those of
 * differences. */
static void
test_dilation_anywhere (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  Probe p = probe_of_law (&(QnLaw){ .name = "joint",
                                    .kind = QN_LAW_COULOMB,
                                    .kn = 2,
                                    .ks = 1,
                                    .friction = 0.6,
                                    .dilatancy = 0.3,
                                    .dilation_end = 1.5 });
  for (int i = 0; i < 3000; i++) {
    double n = g_rand_double_range (random, -3, 0.6),
           t = g_rand_double_range (random, -4, 4);
    QnSpringResponse r = probe_look (&p, n, t);
    bool corner = false;
    for (int k = 0; k < 4; k++) {
      double change = k % 2 == 0 ? 1e-3 : -1e-3;
      QnSpringResponse near =
        probe_look (&p, n + (k < 2 ? change : 0), t + (k < 2 ? 0 : change));
      corner |= near.state != r.state || near.force[1] * r.force[1] < 0
                || near.memory.slip * r.memory.slip <= 0
                || (fabs (near.memory.slip) > 1.5) != (fabs (r.memory.slip) > 1.5);
    }
    if (!corner)
      probe_assert_tangent (&p, n, t);
    probe_go (&p, n, t);
    g_assert_cmpfloat_with_epsilon (p.memory.opening,
                                    0.3 * MIN (fabs (p.memory.slip), 1.5), 1e-12);
    g_assert_cmpfloat (fabs (r.force[1]), <=, -0.6 * r.force[0] + 1e-12);
  }
}

/* The tangent is symmetric where dilatancy = friction, and only there. */
static void
test_symmetry (void)
{
  static const double elongations[][2] = {
    { -3, 2 }, { -3, 5 }, { -3, -5 }, { -0.5, 9 }, { 0.7, 3 }
  };
  for (size_t i = 0; i < G_N_ELEMENTS (elongations); i++) {
    const double *q = elongations[i];
    Probe associative = joint (0, 0, 0.5), friction = joint (0, 0, 0);
    QnSpringResponse a = probe_look (&associative, q[0], q[1]);
    g_assert_cmpfloat_with_epsilon (a.tangent[0][1], a.tangent[1][0], 1e-14);
    QnSpringResponse f = probe_look (&friction, q[0], q[1]);
    if (f.state == QN_PAIR_SLIP)
      g_assert_cmpfloat (fabs (f.tangent[0][1] - f.tangent[1][0]), >, 0.1);
  }
}

/* A dry joint that opens carries nothing and forgets its slip; it closes where it opened. */
static void
test_open_dry (void)
{
  Probe p = joint (0, 0, 0);
  probe_go (&p, -3, 5);
  probe_assert_tangent (&p, 1, 7);
  QnSpringResponse r = probe_go (&p, 1, 7);
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
  probe_assert_force (&r, 0, 0);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, 7, 1e-12);
  r = probe_go (&p, -2, 8);
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, -4, 1);
}

/* A bond is elastic until it breaks, and nothing is left of it afterwards. */
static void
test_bond_in_tension (void)
{
  Probe p = joint (2, 1, 0); /* apex at 4, strength at the cut-off 1.5 */
  QnSpringResponse r = probe_go (&p, 0.4, 1);
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, 0.8, 1);
  probe_assert_tangent (&p, 0.4, 1);
  r = probe_go (&p, 0.6, 1);
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
  probe_assert_force (&r, 0, 0);
  g_assert_cmpfloat (r.memory.extreme, ==, 1);
  r = probe_go (&p, 0.2, 1); /* still apart */
  probe_assert_force (&r, 0, 0);
  r = probe_go (&p, -3, 5); /* 5 - 1 > 0.5 * 6: friction alone */
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
  probe_assert_force (&r, -6, 3);
}

/* In shear at c - mu n, down to mu n at once; tension is gone with it. */
static void
test_bond_in_shear (void)
{
  Probe p = joint (2, 1, 0);
  QnSpringResponse r = probe_go (&p, -3, -4.999);
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, -6, -4.999);
  r = probe_go (&p, -3, -5.001);
  g_assert_cmpint (r.state, ==, QN_PAIR_SLIP);
  probe_assert_force (&r, -6, -3);
  r = probe_go (&p, 0.1, -2);
  probe_assert_force (&r, 0, 0);
}

/* Without a cut-off of its own the apex of the cone, c / mu, bounds tension; a bond of cohesion alone
 * has none, but is not broken by rounding. */
static void
test_apex (void)
{
  Probe p = joint (2, 100, 0);
  QnSpringResponse r = probe_look (&p, 1.5, 0.4);
  probe_assert_force (&r, 3, 0.4);
  r = probe_look (&p, 1.5, 0.6);
  probe_assert_force (&r, 0, 0);
  r = probe_look (&p, 2.01, 0);
  probe_assert_force (&r, 0, 0);

  p = joint (2, 0, 0);
  r = probe_look (&p, 1e-7, 1.5);
  probe_assert_force (&r, 2e-7, 1.5);
  r = probe_look (&p, 2e-6, 1.5);
  probe_assert_force (&r, 0, 0);
}

/* A bond with fracture energies: c 2, ft 1, G1 3, G2 8, mu 0.5. */
static Probe
tough (double dilatancy, double residual)
{
  return probe_of_law (&(QnLaw){ .name = "joint",
                                 .kind = QN_LAW_COULOMB,
                                 .kn = 2,
                                 .ks = 1,
                                 .friction = 0.5,
                                 .residual_friction = residual,
                                 .cohesion = 2,
                                 .tension = 1,
                                 .fracture_energy_tension = 3,
                                 .fracture_energy_shear = 8,
                                 .dilatancy = dilatancy });
}

/* Work of a spring along a straight line of many steps, friction aside. */
static double
work_along (Probe *p, const double from[2], const double to[2], double friction)
{
  enum { STEPS = 20000 };
  double work = 0;
  QnSpringResponse before = probe_go (p, from[0], from[1]);
  for (int k = 1; k <= STEPS; k++) {
    double share = (double) k / STEPS;
    QnSpringResponse r = probe_go (p, from[0] + share * (to[0] - from[0]),
                                   from[1] + share * (to[1] - from[1]));
    for (int i = 0; i < 2; i++)
      work += 0.5 * (r.force[i] + before.force[i]) * (to[i] - from[i]) / STEPS;
    work -= friction * fabs (to[1] - from[1]) / STEPS;
    before = r;
  }
  return work;
}

/* The energy taken is the fracture energy, in either mode, in both together in proportion, and beside the work
 * of friction. */
static void
test_fracture_energy (void)
{
  static const double origin[2] = { 0, 0 };
  for (int curve = 0; curve < 2; curve++) {
    double far = curve ? 4 : 1; /* an exponential goes on for longer */
    Probe p = tough (0, 0);
    p.spring.exponential = curve;
    const QnSpring spring = p.spring;
    double work = work_along (&p, origin, (double[2]){ 7 * far, 0 }, 0);
    g_assert_cmpfloat_with_epsilon (work, 3, 1e-4);
    g_assert_cmpfloat (p.memory.extreme, ==, 1);
    p = (Probe){ .spring = spring };
    work = work_along (&p, origin, (double[2]){ 0, -9 * far }, 0);
    g_assert_cmpfloat_with_epsilon (work, 8, 1e-4);
    g_assert_cmpfloat (p.memory.extreme, ==, 1);

    /* Pressed by n = -4 with friction 2: what the shear force does beyond it, but for the energy that
     * the friction stores, 2^2 / 2, and holds back while it grows. */
    p = (Probe){ .spring = spring };
    work = work_along (&p, (double[2]){ -2, 0 }, (double[2]){ -2, 12 * far }, 2);
    g_assert_cmpfloat_with_epsilon (work + 2, 8, 1e-4);

    /* Along q_t = 2 q_n elastic energies are as 1 to 2. */
    p = (Probe){ .spring = spring };
    work = work_along (&p, origin, (double[2]){ 5 * far, 10 * far }, 0);
    g_assert_cmpfloat (p.memory.extreme, ==, 1);
    g_assert_cmpfloat_with_epsilon (work * (1.0 / 3 / 3 + 2.0 / 3 / 8), 1, 1e-4);
  }
}

/* Straight back to the origin and up again on the same line; then on as if nothing had been. */
static void
test_unloading (void)
{
  Probe p = tough (0, 0);
  QnSpringResponse r = probe_go (&p, 3, 0);
  double there = r.force[0];
  g_assert_cmpfloat_with_epsilon (there, (6 - 3) / 5.5,
                                  1e-12); /* ft (w - q) / (w - ft/kn) */
  probe_assert_tangent (&p, 4, 0.3);
  probe_assert_tangent (&p, 1.5, 0.3);
  r = probe_go (&p, 1.5, 0);
  probe_assert_force (&r, there / 2, 0);
  r = probe_go (&p, -2, 0);
  probe_assert_force (&r, -4, 0);
  r = probe_go (&p, 3, 0);
  probe_assert_force (&r, there, 0);

  /* In shear the friction slides and stays where it is. */
  p = tough (0, 0.25);
  probe_go (&p, -2, 6);
  g_assert_cmpfloat_with_epsilon (p.memory.slip, 6 - 1, 1e-12);
  r = probe_look (&p, -2, 0);
  g_assert_cmpfloat (r.force[1], <, 0);
}

/* Tangents by finite differences anywhere but in corners, with and without dilatancy. */
static void
test_bond_tangents (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (5);
  for (int i = 0; i < 3000; i++) {
    Probe p = tough (i % 3 * 0.2, i % 2 * 0.4);
    p.spring.exponential = i % 4 < 2;
    probe_go (&p, g_rand_double_range (random, -3, 1.5),
              g_rand_double_range (random, -6, 6));
    double n = g_rand_double_range (random, -3, 2),
           t = g_rand_double_range (random, -8, 8);
    QnSpringResponse r = probe_look (&p, n, t);
    bool corner = false;
    for (int k = 0; k < 4; k++) {
      double away[2] = { n, t };
      away[k / 2] += k % 2 == 0 ? 1e-3 : -1e-3;
      QnSpringResponse near = probe_look (&p, away[0], away[1]);
      corner |= near.state != r.state || near.force[1] * r.force[1] < 0
                || (near.memory.extreme > 0) != (r.memory.extreme > 0)
                || (near.memory.extreme > p.memory.extreme)
                     != (r.memory.extreme > p.memory.extreme);
    }
    /* r itself has a corner where both strengths are reached. */
    if (!corner && fabs (2 * n / 1 - (fabs (t) + n) / 2) > 1e-2)
      probe_assert_tangent (&p, n, t);
  }
}

/* Too little energy for its stiffness: the bond breaks at once, as it does without any. */
static void
test_brittle (void)
{
  Probe p = probe_of_law (&(QnLaw){ .name = "joint",
                                    .kind = QN_LAW_COULOMB,
                                    .kn = 2,
                                    .ks = 1,
                                    .friction = 0.5,
                                    .cohesion = 2,
                                    .tension = 1,
                                    .fracture_energy_tension = 0.24 });
  QnSpringResponse r = probe_go (&p, 0.501, 0);
  probe_assert_force (&r, 0, 0);
  g_assert_cmpfloat (r.memory.extreme, ==, 1);
}

/* A bond of cohesion alone that is half gone loses the rest at once as the joint opens. Held, it does not yet, and
 * says that it is to: no force jumps while an equilibrium is sought. */
static void
test_held (void)
{
  Probe p = probe_of_law (&(QnLaw){ .name = "joint",
                                    .kind = QN_LAW_COULOMB,
                                    .kn = 2,
                                    .ks = 1,
                                    .friction = 0.5,
                                    .cohesion = 2,
                                    .fracture_energy_shear = 8 });
  probe_go (&p, -0.001, 4);
  double damage = p.memory.extreme;
  g_assert_cmpfloat (damage, >, 0.2);
  g_assert_cmpfloat (damage, <, 0.9);
  QnSpringResponse r = probe_look (&p, 0.001, 4);
  probe_assert_force (&r, 0, 0);
  g_assert_cmpfloat (qn_spring_damage (&p.spring, &r.memory), ==, 1);

  p.memory.extreme = qn_bond_held (damage);
  g_assert_cmpfloat_with_epsilon (qn_spring_damage (&p.spring, &p.memory), damage, 1e-15);
  r = probe_look (&p, 0.001, 4);
  g_assert_cmpfloat (r.memory.extreme, ==, QN_BOND_BREAKS);
  probe_assert_force (&r, (1 - damage) * 0.002, (1 - damage) * 4);
  /* Softening is no jump: it goes on. */
  r = probe_look (&p, -0.001, 5);
  g_assert_cmpfloat (r.memory.extreme, >, damage);
  g_assert_cmpfloat (r.memory.extreme, <, 1);
}

/* Never whole again, wherever it is taken. */
static void
test_never_heals (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (11);
  Probe p = tough (0.2, 0);
  double damage = 0;
  for (int i = 0; i < 2000; i++) {
    double size = 3e-3 * i;
    QnSpringResponse r = probe_go (&p, g_rand_double_range (random, -2, size),
                                   g_rand_double_range (random, -3 * size, 3 * size));
    g_assert_cmpfloat (r.memory.extreme, >=, damage);
    damage = r.memory.extreme;
    if (damage == 1)
      g_assert_cmpfloat (r.force[0], <=, 0);
  }
  g_assert_cmpfloat (damage, ==, 1);
}

/* Forces are continuous across every border between states, with and without dilatancy: along
 * a ring of elongations no two neighbours differ by more than the stiffness allows. */
static void
test_continuous (void)
{
  enum { STEPS = 20000 };
  static const double psis[] = { 0, 0.2, 0.5 };
  for (size_t i = 0; i < G_N_ELEMENTS (psis) * 2; i++) {
    double psi = psis[i / 2];
    Probe p = i % 2 == 0 ? joint (0, 0, psi) : tough (psi, 0);
    QnSpringResponse before = probe_look (&p, 4, 0);
    for (int k = 1; k <= STEPS; k++) {
      double angle = 2 * G_PI * k / STEPS;
      QnSpringResponse r = probe_look (&p, 4 * cos (angle), 4 * sin (angle));
      for (int c = 0; c < 2; c++)
        g_assert_cmpfloat (fabs (r.force[c] - before.force[c]), <=, 3 * 8 * G_PI / STEPS);
      before = r;
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/law-coulomb/stick", test_stick);
  g_test_add_func ("/law-coulomb/slip-and-return", test_slip_and_return);
  g_test_add_func ("/law-coulomb/looking", test_looking_does_not_commit);
  g_test_add_func ("/law-coulomb/dilatancy", test_dilatancy);
  g_test_add_func ("/law-coulomb/dilation-and-return", test_dilation_and_return);
  g_test_add_func ("/law-coulomb/dilation-adds-up", test_dilation_adds_up);
  g_test_add_func ("/law-coulomb/dilation-anywhere", test_dilation_anywhere);
  g_test_add_func ("/law-coulomb/symmetry", test_symmetry);
  g_test_add_func ("/law-coulomb/open-dry", test_open_dry);
  g_test_add_func ("/law-coulomb/bond-in-tension", test_bond_in_tension);
  g_test_add_func ("/law-coulomb/bond-in-shear", test_bond_in_shear);
  g_test_add_func ("/law-coulomb/apex", test_apex);
  g_test_add_func ("/law-coulomb/fracture-energy", test_fracture_energy);
  g_test_add_func ("/law-coulomb/unloading", test_unloading);
  g_test_add_func ("/law-coulomb/bond-tangents", test_bond_tangents);
  g_test_add_func ("/law-coulomb/brittle", test_brittle);
  g_test_add_func ("/law-coulomb/held", test_held);
  g_test_add_func ("/law-coulomb/never-heals", test_never_heals);
  g_test_add_func ("/law-coulomb/continuous", test_continuous);
}
