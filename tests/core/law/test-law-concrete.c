/* Concrete: kn = 100, fc = 10, so that the parabola ends at 0.2; ft = 1, Gf = 0.05: a crack
 * opens from 0.01 to 0.1. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>
#include <math.h>

static QnLaw
concrete (double tension, double ultimate)
{
  return (QnLaw){ .name = "concrete",
                  .kind = QN_LAW_CONCRETE,
                  .kn = 100,
                  .ks = 40,
                  .strength = 10,
                  .tension = tension,
                  .fracture_energy = 0.05,
                  .ultimate_strain = ultimate,
                  .crushing_energy = ultimate > 0 ? 1.5 : 0 };
}

/* Parabola, rectangle, elastic unloading, a gap without tension, reloading to the envelope. */
static void
test_compression (void)
{
  static const double rows[][2] = {
    { -0.05, -4.375 }, { -0.1, -7.5 }, { -0.08, -5.5 }, { -0.02, 0 }, { -0.1, -7.5 },
    { -0.2, -10 },     { -0.5, -10 },  { -0.45, -5 },   { -0.3, 0 },  { -0.6, -10 },
  };
  QnLaw law = concrete (0, 0);
  Probe p = probe_of_law (&law);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

/* Crushing from 0.3 to 0.3 - 0.1 + 0.3 = 0.5. */
static void
test_crushing (void)
{
  static const double rows[][2] = {
    { -0.2, -10 },   { -0.3, -10 }, { -0.4, -5 }, { -0.37, -2 },
    { -0.45, -2.5 }, { -0.5, 0 },   { -0.9, 0 },  { -0.2, 0 },
  };
  QnLaw law = concrete (0, 0.3);
  Probe p = probe_of_law (&law);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

/* Crack opens, closes to the origin, opens again the same way, and is open for good. */
static void
test_crack (void)
{
  static const double rows[][2] = {
    { 0.005, 0.5 }, { 0.01, 1 }, { 0.055, 0.5 }, { 0.022, 0.2 }, { -0.02, -1.9 },
    { 0.055, 0.5 }, { 0.1, 0 },  { 0.04, 0 },    { -0.1, -7.5 }, { 0.05, 0 },
  };
  QnLaw law = concrete (1, 0);
  Probe p = probe_of_law (&law);
  /* The parabola leaves a little plastic shortening: the crack is then measured from there. */
  for (size_t i = 0; i < 4; i++) {
    QnSpringResponse r = probe_go (&p, rows[i][0], 0);
    probe_assert_force (&r, rows[i][1], 0);
  }
  g_assert_cmpint (probe_look (&p, 0.02, 0).state, ==, QN_PAIR_OPEN);
  probe_assert_tangent (&p, 0.02, 0);
  probe_assert_tangent (&p, 0.06, 0);
  QnSpringResponse r = probe_go (&p, -0.02, 0);
  probe_assert_force (&r, -1.9, 0);
  const double plastic = 0.001; /* 0.02 - 1.9 / 100 */
  r = probe_go (&p, 0.055 - plastic, 0);
  probe_assert_force (&r, 0.5, 0);
  for (size_t i = 6; i < G_N_ELEMENTS (rows); i++) {
    r = probe_go (&p, rows[i][0], 0);
    probe_assert_force (&r, rows[i][1], 0);
  }
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
}

/* A crack takes Gf per area to open, whatever the length of the block behind it. */
static void
test_mesh_objective (void)
{
  enum { STEPS = 20000 };
  const double length[] = { 0.01, 0.1, 0.3 }, area = 0.02;
  QnLaw law = { .name = "c",
                .kind = QN_LAW_CONCRETE,
                .basis = QN_BASIS_MATERIAL,
                .kn = 30e9,
                .ks = 12.5e9,
                .strength = 30e6,
                .tension = 2e6,
                .fracture_energy = 80,
                .ultimate_strain = 0.0035,
                .crushing_energy = 20e3 };
  for (size_t k = 0; k < G_N_ELEMENTS (length); k++) {
    Probe p = { .spring = qn_spring_from_law (&law, area, length[k]) };
    double far = 2 * law.fracture_energy / law.tension, work = 0, before = 0;
    for (int i = 1; i <= STEPS; i++) {
      double force = probe_go (&p, far * i / STEPS, 0).force[0];
      work += 0.5 * (force + before) * far / STEPS;
      before = force;
    }
    g_assert_cmpfloat_with_epsilon (before, 0, 1e-6);
    g_assert_cmpfloat_with_epsilon (work / (area * law.fracture_energy), 1, 1e-3);

    /* Crushing: the work beyond the rectangle, with the elastic energy that is given back. */
    double start = law.ultimate_strain * length[k];
    before = probe_go (&p, -start, 0).force[0];
    work = 0.5 * before * before / p.spring.kn;
    far = start + 2 * law.crushing_energy / law.strength;
    for (int i = 1; i <= STEPS; i++) {
      double force = probe_go (&p, -start - (far - start) * i / STEPS, 0).force[0];
      work -= 0.5 * (force + before) * (far - start) / STEPS;
      before = force;
    }
    g_assert_cmpfloat_with_epsilon (work / (area * law.crushing_energy), 1, 1e-3);
  }
}

static void
test_softening (void)
{
  QnLaw law = concrete (1, 0);
  Probe p = probe_of_law (&law);
  g_assert_cmpfloat_with_epsilon (qn_spring_softening (&p.spring), 1 / 0.09, 1e-9);
  law.fracture_energy = 0.004; /* closes at 0.008, before it would begin */
  p = probe_of_law (&law);
  g_assert_true (isinf (qn_spring_softening (&p.spring)));
  law = concrete (0, 0.3);
  p = probe_of_law (&law);
  g_assert_cmpfloat_with_epsilon (qn_spring_softening (&p.spring), 50, 1e-9);
}

QN_TESTS
{
  g_test_add_func ("/law-concrete/compression", test_compression);
  g_test_add_func ("/law-concrete/crushing", test_crushing);
  g_test_add_func ("/law-concrete/crack", test_crack);
  g_test_add_func ("/law-concrete/mesh-objective", test_mesh_objective);
  g_test_add_func ("/law-concrete/softening", test_softening);
}
