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
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
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
  g_assert_cmpint (r.phase, ==, QN_PHASE_SLIP_POSITIVE);
  probe_assert_force (&r, -6, 3);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, 2, 1e-12);
  g_assert_cmpfloat (r.memory.opening, ==, 0);

  r = probe_go (&p, -3, 1); /* 1 - 2 = -1: sticks */
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
  probe_assert_force (&r, -6, -1);
  probe_assert_tangent (&p, -3, 1);
  r = probe_go (&p, -3, -4); /* -4 - 2 = -6: slides back by 3 */
  g_assert_cmpint (r.phase, ==, QN_PHASE_SLIP_NEGATIVE);
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
  g_assert_cmpmem (&first, sizeof first, &again, sizeof again);
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
    g_assert_cmpint (r.phase, ==, QN_PHASE_SLIP_NEGATIVE);
    probe_assert_force (&r, n, 0.5 * n);
    probe_assert_tangent (&p, -3, -5);
    g_assert_cmpfloat_with_epsilon (r.memory.opening, psi * g, 1e-12);
    g_assert_cmpfloat_with_epsilon (r.memory.slip, -g, 1e-12);
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
    Probe associative = joint (0.25, 0.1, 0.5), friction = joint (0.25, 0.1, 0);
    QnSpringResponse a = probe_look (&associative, q[0], q[1]);
    g_assert_cmpfloat_with_epsilon (a.tangent[0][1], a.tangent[1][0], 1e-14);
    QnSpringResponse f = probe_look (&friction, q[0], q[1]);
    if (f.phase == QN_PHASE_SLIP_POSITIVE || f.phase == QN_PHASE_SLIP_NEGATIVE)
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
  g_assert_cmpint (r.phase, ==, QN_PHASE_OPEN);
  probe_assert_force (&r, 0, 0);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, 7, 1e-12);
  r = probe_go (&p, -2, 8);
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
  probe_assert_force (&r, -4, 1);
}

/* With cohesion and a cut-off below the apex: holds ft, and shear up to c - mu ft. */
static void
test_cut_off (void)
{
  Probe p = joint (2, 1, 0); /* apex at 4, strength at the cut-off 1.5 */
  QnSpringResponse r = probe_look (&p, 0.4, 0);
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
  probe_assert_force (&r, 0.8, 0);
  r = probe_look (&p, 3, 1.2);
  g_assert_cmpint (r.phase, ==, QN_PHASE_OPEN_STICK);
  probe_assert_force (&r, 1, 1.2);
  probe_assert_tangent (&p, 3, 1.2);
  r = probe_look (&p, 3, 2.5);
  g_assert_cmpint (r.phase, ==, QN_PHASE_OPEN_SLIP_POSITIVE);
  probe_assert_force (&r, 1, 1.5);
  probe_assert_tangent (&p, 3, 2.5);
  r = probe_go (&p, 3, -2.5);
  g_assert_cmpint (r.phase, ==, QN_PHASE_OPEN_SLIP_NEGATIVE);
  probe_assert_force (&r, 1, -1.5);
  g_assert_cmpfloat_with_epsilon (r.memory.slip, -1, 1e-12);

  r = probe_go (&p, 0, -2.5); /* 2.5 - 1 of slip = 1.5 < 2 */
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
  probe_assert_force (&r, 0, -1.5);
}

/* Without a cut-off of its own the apex of the cone, c / mu, bounds tension. */
static void
test_apex (void)
{
  Probe p = joint (2, 100, 0);
  QnSpringResponse r = probe_look (&p, 1.5, 0.4);
  g_assert_cmpint (r.phase, ==, QN_PHASE_STICK);
  probe_assert_force (&r, 3, 0.4);
  r = probe_look (&p, 1.5, 3);
  g_assert_cmpint (r.phase, ==, QN_PHASE_SLIP_POSITIVE);
  probe_assert_force (&r, 3, 0.5);
  r = probe_look (&p, 2.5, 3);
  g_assert_cmpint (r.phase, ==, QN_PHASE_OPEN);
  probe_assert_force (&r, 4, 0);
}

/* Forces are continuous across every border between phases, with and without dilatancy: along
 * a ring of elongations no two neighbours differ by more than the stiffness allows. */
static void
test_continuous (void)
{
  enum { STEPS = 20000 };
  static const double psis[] = { 0, 0.2, 0.5 };
  for (size_t i = 0; i < G_N_ELEMENTS (psis); i++) {
    Probe p = joint (0.5, 0.3, psis[i]);
    QnSpringResponse before = probe_look (&p, 2, 0);
    for (int k = 1; k <= STEPS; k++) {
      double angle = 2 * G_PI * k / STEPS;
      QnSpringResponse r = probe_look (&p, 2 * cos (angle), 2 * sin (angle));
      for (int c = 0; c < 2; c++)
        g_assert_cmpfloat (fabs (r.force[c] - before.force[c]), <=, 3 * 4 * G_PI / STEPS);
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
  g_test_add_func ("/law-coulomb/symmetry", test_symmetry);
  g_test_add_func ("/law-coulomb/open-dry", test_open_dry);
  g_test_add_func ("/law-coulomb/cut-off", test_cut_off);
  g_test_add_func ("/law-coulomb/apex", test_apex);
  g_test_add_func ("/law-coulomb/continuous", test_continuous);
}
