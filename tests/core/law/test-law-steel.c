/* Steel: kn = 100, yield 10, strength 14 at 0.5, so that r = 0.1; breaking work 1.4. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

static Probe
bar (double fracture_energy)
{
  return probe_of_law (&(QnLaw){ .name = "bar",
                                 .kind = QN_LAW_STEEL,
                                 .kn = 100,
                                 .ks = 40,
                                 .yield = 10,
                                 .strength = 14,
                                 .ultimate_strain = 0.5,
                                 .fracture_energy = fracture_energy });
}

/* Without a fracture energy it goes on at its strength, either way. The elastic range stays 20 wide and
 * hardens again once what was plastic beyond the strength, 0.2 here, is taken back. */
static void
test_cycle (void)
{
  static const double rows[][2] = {
    { 0.1, 10 }, { 0.3, 12 }, { 0.2, 2 },    { 0.1, -8 },   { 0, -9 },
    { 0.12, 3 }, { 0.5, 14 }, { 0.7, 14 },   { 0.6, 4 },    { 0.4, -6 },
    { 0.3, -6 }, { 0.2, -7 }, { -0.5, -14 }, { -0.9, -14 },
  };
  Probe p = bar (0);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

/* Breaks from 0.5 to 0.5 - 0.14 + 0.2 = 0.56; in between it unloads with the stiffness that is
 * left, and once broken it carries nothing either way. */
static void
test_breaks (void)
{
  static const double rows[][2] = {
    { 0.3, 12 }, { 0.5, 14 }, { 0.53, 7 }, { 0.545, 3.5 },
    { 0.56, 0 }, { 0.7, 0 },  { -1, 0 },
  };
  Probe p = bar (1.4);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
  g_assert_cmpint (probe_look (&p, 0.2, 0).state, ==, QN_PAIR_OPEN);

  p = bar (1.4);
  QnSpringResponse r = probe_go (&p, 0.53, 0);
  double left = 7.0 / 14;
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
  r = probe_go (&p, 0.48, 0);
  probe_assert_force (&r, left * (14 - 5), 0);
  probe_assert_tangent (&p, 0.47, 0);
}

/* The plastic work from the strength on is the fracture energy, whatever the length of bar. */
static void
test_breaking_work (void)
{
  enum { STEPS = 4000 };
  const double length[] = { 0.05, 0.3, 1 };
  QnLaw law = { .name = "bar",
                .kind = QN_LAW_STEEL,
                .basis = QN_BASIS_MATERIAL,
                .kn = 2e11,
                .ks = 8e10,
                .yield = 5e8,
                .strength = 5.4e8,
                .ultimate_strain = 0.025,
                .fracture_energy = 2e6 };
  const double area = 3e-4;
  for (size_t k = 0; k < G_N_ELEMENTS (length); k++) {
    Probe p = { .spring = qn_spring_from_law (&law, area, length[k]) };
    double start = law.ultimate_strain * length[k];
    double far = start + 2 * law.fracture_energy / law.strength;
    QnSpringResponse before = probe_go (&p, start, 0), r;
    g_assert_cmpfloat_with_epsilon (before.force[0], area * law.strength, 1e-6);
    double work = 0.5 * before.force[0] * before.force[0] / p.spring.kn; /* given back */
    for (int i = 1; i <= STEPS; i++) {
      r = probe_go (&p, start + (far - start) * i / STEPS, 0);
      work += 0.5 * (r.force[0] + before.force[0]) * (far - start) / STEPS;
      before = r;
    }
    g_assert_cmpfloat (r.force[0], ==, 0);
    g_assert_cmpfloat_with_epsilon (work / (area * law.fracture_energy), 1, 1e-3);
  }
}

/* A long bar with little fracture energy would snap back, and says so. */
static void
test_softening (void)
{
  Probe p = bar (1.4);
  g_assert_cmpfloat_with_epsilon (qn_spring_softening (&p.spring), 14 / 0.06, 1e-9);
  p = bar (0.9);
  g_assert_true (isinf (qn_spring_softening (&p.spring)));
  p = bar (0);
  g_assert_cmpfloat (qn_spring_softening (&p.spring), ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/law-steel/cycle", test_cycle);
  g_test_add_func ("/law-steel/breaks", test_breaks);
  g_test_add_func ("/law-steel/breaking-work", test_breaking_work);
  g_test_add_func ("/law-steel/softening", test_softening);
}
