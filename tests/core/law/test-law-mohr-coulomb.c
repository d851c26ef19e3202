/* Friction with crushing: kn = 2, ks = 1, mu = 0.5, fc = 8, so that numbers can be checked in the
 * head. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

static const QnLaw joint = { .name = "joint",
                             .kind = QN_LAW_MOHR_COULOMB,
                             .kn = 2,
                             .ks = 1,
                             .friction = 0.5,
                             .compression = 8 };

static Probe
with_dilatancy (double dilatancy)
{
  QnLaw law = joint;
  law.dilatancy = dilatancy;
  return probe_of_law (&law);
}

/* Below the limit of compression the law is Coulomb's to the bit. */
static void
test_below (void)
{
  QnLaw coulomb = joint;
  coulomb.kind = QN_LAW_COULOMB;
  g_autoptr (GRand) random = g_rand_new_with_seed (3);
  Probe crushing = probe_of_law (&joint), other = probe_of_law (&coulomb);

  for (int i = 0; i < 200; i++) {
    double n = g_rand_double_range (random, -4, 1);
    double t = g_rand_double_range (random, -6, 6);
    QnSpringResponse a = probe_go (&crushing, n, t), b = probe_go (&other, n, t);
    g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  }
}

/* Crushed by 2, the joint unloads with kn, opens at -2 and is crushed again from there. */
static void
test_crush_and_return (void)
{
  Probe p = with_dilatancy (0);
  probe_assert_tangent (&p, -6, 0.5);
  QnSpringResponse r = probe_go (&p, -6, 0.5);
  g_assert_cmpint (r.state, ==, QN_PAIR_YIELD);
  probe_assert_force (&r, -8, 0.5);
  g_assert_cmpfloat (r.memory.opening, ==, -2);

  r = probe_go (&p, -4, 0.5);
  g_assert_cmpint (r.state, ==, QN_PAIR_STICK);
  probe_assert_force (&r, -4, 0.5);
  r = probe_go (&p, -1.5, 0);
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
  probe_assert_force (&r, 0, 0);
  r = probe_go (&p, -6, 0);
  probe_assert_force (&r, -8, 0);
  g_assert_cmpfloat (r.memory.opening, ==, -2);
}

/* At the corner both strengths are used up, mu fc = 4, and nothing is stiff. */
static void
test_corner (void)
{
  static const double psis[] = { 0, 0.25, 0.5 };
  for (size_t i = 0; i < G_N_ELEMENTS (psis); i++) {
    Probe p = with_dilatancy (psis[i]);
    probe_assert_tangent (&p, -6, -7);
    QnSpringResponse r = probe_go (&p, -6, -7);
    g_assert_cmpint (r.state, ==, QN_PAIR_YIELD);
    probe_assert_force (&r, -8, -4);
    g_assert_cmpfloat (r.memory.slip, ==, -3);
    g_assert_cmpfloat (r.memory.opening, ==, -2);
  }
}

/* Dilatancy presses a joint that cannot open into crushing: n* = -7, psi g = 0.5 (9 - 4) = 2.5, and
 * 2.5 - (8 - 7) / 2 = 2 is crushed away. */
static void
test_dilatancy_crushes (void)
{
  Probe p = with_dilatancy (0.5);
  probe_assert_tangent (&p, -3.5, 9);
  QnSpringResponse r = probe_go (&p, -3.5, 9);
  g_assert_cmpint (r.state, ==, QN_PAIR_YIELD);
  probe_assert_force (&r, -8, 4);
  g_assert_cmpfloat (r.memory.slip, ==, 5);
  g_assert_cmpfloat_with_epsilon (r.memory.opening, 2.5 - 2, 1e-12);
}

/* A bond is crushed with its joint, and stays whole as long as the shear force is below c + mu fc. */
static void
test_bond (void)
{
  QnLaw law = joint;
  law.cohesion = 1;
  law.tension = 1;
  Probe p = probe_of_law (&law);
  probe_assert_tangent (&p, -6, 4.9);
  QnSpringResponse r = probe_go (&p, -6, 4.9);
  g_assert_cmpint (r.state, ==, QN_PAIR_YIELD);
  probe_assert_force (&r, -8, 4.9);
  g_assert_cmpfloat (r.memory.opening, ==, -2);
  r = probe_look (&p, -1.6, 0.5); /* 0.4 of opening since -2 */
  probe_assert_force (&r, 0.8, 0.5);
  r = probe_go (&p, -6, 5.1);
  probe_assert_force (&r, -8, 4);
  r = probe_look (&p, -1.6, 0.5);
  probe_assert_force (&r, 0, 0);
}

/* kn = 2, fc = 8 down to nothing between the shortenings 5 and 5 - 8/2 + 2 x 20/8 = 6. */
static QnLaw
that_ends (void)
{
  QnLaw law = joint;
  law.ultimate_strain = 5;
  law.crushing_energy = 20;
  return law;
}

static void
test_crushing_ends (void)
{
  QnLaw law = that_ends ();
  Probe p = probe_of_law (&law);
  static const double history[][2] = {
    { -3, -6 },    { -4.5, -8 }, { -2, -3 },     { -5, -8 },
    { -5.5, -4 },  { -4.5, -2 }, { -3.6, -0.2 }, { -5.25, -3.5 },
    { -5.75, -2 }, { -7, 0 },    { -5, 0 },      { -7, 0 },
  };
  probe_assert_history (&p, history, G_N_ELEMENTS (history));
}

/* Friction and bond go with it: at -5.5 half of fc is left, 4. */
static void
test_crushing_takes_shear (void)
{
  QnLaw law = that_ends ();
  Probe p = probe_of_law (&law);
  probe_assert_tangent (&p, -5.5, 9);
  probe_assert_tangent (&p, -5.5, 1);
  QnSpringResponse r = probe_look (&p, -5.5, 9);
  probe_assert_force (&r, -4, 2);

  law.cohesion = 4;
  law.tension = 1;
  law.fracture_energy_tension = 20;
  p = probe_of_law (&law);
  probe_assert_tangent (&p, -5.5, 1);
  probe_assert_tangent (&p, -5.5, 3);
  probe_assert_tangent (&p, -5.5, 7);
  r = probe_go (&p, -5.5, 0);
  probe_assert_force (&r, -4, 0);
  g_assert_cmpfloat_with_epsilon (r.memory.extreme, 0.5, 1e-12);
}

/* What crushing takes from 5 on, its energy, however it goes there. */
static void
test_crushing_energy (void)
{
  QnLaw law = that_ends ();
  Probe p = probe_of_law (&law);
  double work = 0, before = -8, last = -5;
  probe_go (&p, last, 0);
  for (int i = 1; i <= 4000; i++) {
    double q = -5 - i / 4000.0 * 1.5 + 0.3 * sin (i * 0.01);
    QnSpringResponse r = probe_go (&p, q, 0);
    work += 0.5 * (before + r.force[0]) * (q - last);
    before = r.force[0];
    last = q;
  }
  g_assert_cmpfloat (last, <, -6);
  /* Less what was stored elastically at -5: 8 x 8 / (2 kn). */
  g_assert_cmpfloat_with_epsilon (work, 20 - 16, 2e-3);
}

static void
test_crushing_refused (void)
{
  static const struct {
    double strain, energy, dilatancy;
    QnProblem problem;
  } cases[] = {
    { 3.9, 20, 0, QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL },
    { 5, 0, 0, QN_PROBLEM_FRACTURE_ENERGY_MISSING },
    { 0, 20, 0, QN_PROBLEM_NOT_POSITIVE },
    { 5, 20, 0.1, QN_PROBLEM_CRUSHING_DILATES },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    QnLaw law = joint;
    QnDiag diag;
    law.ultimate_strain = cases[i].strain;
    law.crushing_energy = cases[i].energy;
    law.dilatancy = cases[i].dilatancy;
    g_assert_cmpint (qn_law_check (&law, 0, &diag), ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, cases[i].problem);
  }
}

/* No jump between the mappings: responses on either side of a boundary agree. */
static void
test_continuous (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (7);

  for (int i = 0; i < 2000; i++) {
    Probe p = with_dilatancy (i % 3 * 0.25);
    double n = g_rand_double_range (random, -8, 1);
    double t = g_rand_double_range (random, -12, 12);
    QnSpringResponse a = probe_look (&p, n, t);
    for (int k = 0; k < 2; k++) {
      QnSpringResponse b =
        probe_look (&p, n + (k == 0 ? 1e-7 : 0), t + (k == 1 ? 1e-7 : 0));
      for (int j = 0; j < 2; j++)
        g_assert_cmpfloat (fabs (a.force[j] - b.force[j]), <=, 4e-7);
    }
  }
}

QN_TESTS
{
  g_test_add_func ("/law-mohr-coulomb/below", test_below);
  g_test_add_func ("/law-mohr-coulomb/crush-and-return", test_crush_and_return);
  g_test_add_func ("/law-mohr-coulomb/corner", test_corner);
  g_test_add_func ("/law-mohr-coulomb/dilatancy-crushes", test_dilatancy_crushes);
  g_test_add_func ("/law-mohr-coulomb/bond", test_bond);
  g_test_add_func ("/law-mohr-coulomb/crushing-ends", test_crushing_ends);
  g_test_add_func ("/law-mohr-coulomb/crushing-takes-shear", test_crushing_takes_shear);
  g_test_add_func ("/law-mohr-coulomb/crushing-energy", test_crushing_energy);
  g_test_add_func ("/law-mohr-coulomb/crushing-refused", test_crushing_refused);
  g_test_add_func ("/law-mohr-coulomb/continuous", test_continuous);
}
