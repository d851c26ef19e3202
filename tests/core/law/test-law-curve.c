/* A curve: kn = 100, to 10 at 0.1, 14 at 0.3, down to 4 at 0.5; in compression to -20 at -0.2
 * and -20 at -1. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

static QnLaw
curve (double fracture_energy)
{
  return (QnLaw){ .name = "curve",
                  .kind = QN_LAW_CURVE,
                  .kn = 100,
                  .ks = 40,
                  .fracture_energy = fracture_energy,
                  .point_count = 6,
                  .points = { { -1, -20 },
                              { -0.2, -20 },
                              { 0, 0 },
                              { 0.1, 10 },
                              { 0.3, 14 },
                              { 0.5, 4 } } };
}

/* Monotonic: through the points, then constant. */
static void
test_envelope (void)
{
  static const double tension[][2] = {
    { 0.05, 5 }, { 0.1, 10 }, { 0.2, 12 }, { 0.3, 14 }, { 0.4, 9 }, { 0.5, 4 }, { 2, 4 },
  };
  static const double compression[][2] = {
    { -0.15, -15 }, { -0.2, -20 }, { -0.7, -20 }, { -1, -20 }, { -3, -20 },
  };
  QnLaw law = curve (0);
  Probe p = probe_of_law (&law);
  probe_assert_history (&p, tension, G_N_ELEMENTS (tension));
  p = probe_of_law (&law);
  probe_assert_history (&p, compression, G_N_ELEMENTS (compression));
}

/* Unloading is elastic, each side goes on where it was left: after pt = 0.16 the compression
 * side is entered 0.16 later. */
static void
test_cycle (void)
{
  static const double rows[][2] = {
    { 0.3, 14 },    { 0.2, 4 },     { 0.16, 0 },  { 0.06, -10 },
    { -0.04, -20 }, { -0.34, -20 }, { -0.14, 0 }, { -0.04, 10 },
    { 0, 14 },      { 0.1, 9 },     { 0.01, 0 },
  };
  QnLaw law = curve (0);
  Probe p = probe_of_law (&law);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

static void
test_states (void)
{
  QnLaw law = curve (0);
  Probe p = probe_of_law (&law);
  static const double at[] = { 0.2, 0.4, 0.6, -0.5, -2 };
  g_assert_cmpint (probe_look (&p, 0.09, 0).state, ==, QN_PAIR_STICK);
  g_assert_cmpint (probe_look (&p, -0.19, 0).state, ==, QN_PAIR_STICK);
  for (size_t i = 0; i < G_N_ELEMENTS (at); i++)
    g_assert_cmpint (probe_look (&p, at[i], 0).state, ==, QN_PAIR_YIELD);
}

/* A side without points is elastic. */
static void
test_one_sided (void)
{
  QnLaw law = curve (0);
  law.point_count = 2;
  Probe p = probe_of_law (&law);
  QnSpringResponse r = probe_look (&p, 7, 0);
  probe_assert_force (&r, 700, 0);
  r = probe_look (&p, -7, 0);
  probe_assert_force (&r, -20, 0);
}

/* The descent dissipates the energy that is asked for, above the last force, and its corner
 * points follow: plastic elongations 0.16 and 0.46 become 0.16 and 0.16 + 0.3 f. */
static void
test_energy (void)
{
  const double own = 0.5 * 10 * 0.3, energy = 2.7, factor = energy / own;
  QnLaw law = curve (energy);
  Probe p = probe_of_law (&law);
  double end = 0.16 + 0.3 * factor + 0.04;
  QnSpringResponse r = probe_look (&p, end, 0);
  probe_assert_force (&r, 4, 0);
  r = probe_look (&p, 0.5 * (0.3 + end), 0);
  probe_assert_force (&r, 9, 0);
  probe_assert_tangent (&p, 0.5 * (0.3 + end), 0);
  r = probe_look (&p, 0.2, 0);
  probe_assert_force (&r, 12, 0);
}

/* Over strain, the stretched descent has the same length in metres for every length of block. */
static void
test_mesh_objective (void)
{
  QnLaw law = { .name = "timber",
                .kind = QN_LAW_CURVE,
                .basis = QN_BASIS_MATERIAL,
                .kn = 1e10,
                .ks = 1e9,
                .fracture_energy = 3000,
                .point_count = 2,
                .points = { { 0.001, 10e6 }, { 0.003, 0 } } };
  static const double lengths[] = { 0.05, 0.1, 0.2 };
  for (size_t i = 0; i < G_N_ELEMENTS (lengths); i++) {
    Probe p = { .spring = qn_spring_from_law (&law, 0.01, lengths[i]) };
    double crack = 2 * 3000 / 10e6; /* triangle */
    QnSpringResponse r = probe_look (&p, 0.5 * crack + 0.0005 * lengths[i], 0);
    g_assert_cmpfloat_with_epsilon (r.force[0], 5e6 * 0.01, 1e-6);
    r = probe_look (&p, crack * 1.000001, 0);
    g_assert_cmpfloat_with_epsilon (r.force[0], 0, 1e-6);
    g_assert_cmpfloat_with_epsilon (qn_spring_softening (&p.spring),
                                    1e5 / (crack - 0.001 * lengths[i]), 1);
  }
  Probe p = { .spring = qn_spring_from_law (&law, 0.01, 0.7) };
  g_assert_true (isinf (qn_spring_softening (&p.spring)));
}

QN_TESTS
{
  g_test_add_func ("/law-curve/envelope", test_envelope);
  g_test_add_func ("/law-curve/cycle", test_cycle);
  g_test_add_func ("/law-curve/states", test_states);
  g_test_add_func ("/law-curve/one-sided", test_one_sided);
  g_test_add_func ("/law-curve/energy", test_energy);
  g_test_add_func ("/law-curve/mesh-objective", test_mesh_objective);
}
