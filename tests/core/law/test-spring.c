#include "core/law/spring.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Bases: contact as given, surface times area, material times area over length. */
static void
test_bases (void)
{
  QnLaw law = { .name = "joint",
                .kind = QN_LAW_COULOMB,
                .kn = 100,
                .ks = 60,
                .friction = 0.5,
                .cohesion = 8,
                .tension = 3,
                .dilatancy = 0.1 };
  const double area = 0.2, length = 0.05;
  QnSpring contact = qn_spring_from_law (&law, area, length);
  law.basis = QN_BASIS_SURFACE;
  QnSpring surface = qn_spring_from_law (&law, area, length);
  law.basis = QN_BASIS_MATERIAL;
  QnSpring material = qn_spring_from_law (&law, area, length);

  g_assert_cmpfloat (contact.kn, ==, 100);
  g_assert_cmpfloat (contact.ks, ==, 60);
  g_assert_cmpfloat (contact.cap, ==, 3);
  g_assert_cmpfloat (surface.kn, ==, 20);
  g_assert_cmpfloat (surface.ks, ==, 12);
  g_assert_cmpfloat (surface.cohesion, ==, 8 * area);
  g_assert_cmpfloat_with_epsilon (material.kn, 400, 1e-12);
  g_assert_cmpfloat_with_epsilon (material.ks, 240, 1e-12);
  g_assert_cmpfloat (material.cap, ==, surface.cap);
  g_assert_cmpfloat (material.friction, ==, 0.5);

  law.shear_factor = 5. / 6;
  QnSpring corrected = qn_spring_from_law (&law, area, length);
  g_assert_cmpfloat_with_epsilon (corrected.ks, 200, 1e-12);
  g_assert_cmpfloat (corrected.kn, ==, material.kn);
}

/* Strains become elongations over the length, energies do not. */
static void
test_lengths (void)
{
  QnLaw law = { .name = "c",
                .kind = QN_LAW_CONCRETE,
                .basis = QN_BASIS_MATERIAL,
                .kn = 30e9,
                .ks = 12e9,
                .strength = 30e6,
                .tension = 3e6,
                .fracture_energy = 90,
                .ultimate_strain = 0.0035,
                .crushing_energy = 2e4 };
  QnSpring one = qn_spring_from_law (&law, 0.01, 0.1);
  QnSpring two = qn_spring_from_law (&law, 0.01, 0.2);
  g_assert_cmpfloat_with_epsilon (one.ultimate, 0.00035, 1e-16);
  g_assert_cmpfloat_with_epsilon (two.ultimate, 0.0007, 1e-16);
  g_assert_cmpfloat_with_epsilon (one.fracture, 6e-5, 1e-16);
  g_assert_cmpfloat (two.fracture, ==, one.fracture);
  g_assert_cmpfloat (two.crushing, ==, one.crushing);
  g_assert_cmpfloat_with_epsilon (one.strength, 3e5, 1e-9);
}

/* Similar: equal but for the length. */
static void
test_similar (void)
{
  QnLaw law = { .name = "s",
                .kind = QN_LAW_STEEL,
                .basis = QN_BASIS_MATERIAL,
                .kn = 2e11,
                .ks = 8e10,
                .yield = 5e8,
                .strength = 5.5e8,
                .ultimate_strain = 0.05,
                .fracture_energy = 1e6 };
  QnSpring a = qn_spring_from_law (&law, 3e-4, 0.1);
  QnSpring b = qn_spring_from_law (&law, 3e-4, 0.37);
  g_assert_true (qn_spring_similar (&a, &a));
  g_assert_true (qn_spring_similar (&a, &b));
  QnSpring joined = qn_spring_join (&a, &b),
           whole = qn_spring_from_law (&law, 3e-4, 0.47);
  g_assert_cmpfloat_with_epsilon (joined.kn / whole.kn, 1, 1e-14);
  g_assert_cmpfloat_with_epsilon (joined.ks / whole.ks, 1, 1e-14);
  g_assert_cmpfloat_with_epsilon (joined.ultimate / whole.ultimate, 1, 1e-14);
  g_assert_cmpfloat (joined.fracture, ==, whole.fracture);

  b = qn_spring_from_law (&law, 4e-4, 0.1);
  g_assert_false (qn_spring_similar (&a, &b));
  law.yield = 4.9e8;
  b = qn_spring_from_law (&law, 3e-4, 0.1);
  g_assert_false (qn_spring_similar (&a, &b));
  law.kind = QN_LAW_ELASTIC;
  b = qn_spring_from_law (&law, 3e-4, 0.1);
  g_assert_false (qn_spring_similar (&a, &b));
}

/* A curve keeps its descent when two springs are joined: it descends in one place. */
static void
test_join_curve (void)
{
  QnLaw law = { .name = "curve",
                .kind = QN_LAW_CURVE,
                .basis = QN_BASIS_SURFACE,
                .kn = 100,
                .ks = 50,
                .point_count = 2,
                .points = { { 0.1, 10 }, { 0.5, 0 } } };
  QnSpring one = qn_spring_from_law (&law, 1, 1);
  QnSpring joined = qn_spring_join (&one, &one);
  QnSpringMemory rest = { 0 };
  QnSpringResponse r;
  qn_spring_evaluate (&joined, &rest, (const double[]){ 0.2, 0 }, &r);
  g_assert_cmpfloat_with_epsilon (r.force[0], 10, 1e-12);
  qn_spring_evaluate (&joined, &rest, (const double[]){ 0.35, 0 }, &r);
  g_assert_cmpfloat_with_epsilon (r.force[0], 5, 1e-12);
  qn_spring_evaluate (&joined, &rest, (const double[]){ 0.5, 0 }, &r);
  g_assert_cmpfloat_with_epsilon (r.force[0], 0, 1e-12);
}

/* Whether some strength that limits this (shear, or the sign of the normal force) is reached. */
static bool
reaches (const QnStrengthRow *rows, int count, const double force[2], double shear,
         double normal)
{
  for (const QnStrengthRow *row = rows; row < rows + count; row++)
    if (row->shear == shear && (shear > 0 || row->normal == normal)
        && row->shear * fabs (force[1]) + row->normal * force[0] > row->limit - 1e-9)
      return true;
  return false;
}

/* What a perfectly plastic law answers, its bond whole or broken, is within the strengths that it gives, and what of the
 * elongation is not elastic flows at strengths that are reached, by their flow. */
static void
check_flow (const QnSpring *spring, const QnSpringMemory *before, const double q[2],
            const QnSpringResponse *r)
{
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  QnSpring now = qn_spring_now (spring, &r->memory);
  int count = qn_spring_strength (&now, rows);
  double slip = q[1] - r->force[1] / spring->ks - before->slip;
  double opening = q[0] - r->force[0] / spring->kn - before->opening;

  for (const QnStrengthRow *row = rows; row < rows + count; row++) {
    double used = row->shear * fabs (r->force[1]) + row->normal * r->force[0];
    g_assert_cmpfloat (used, <=, row->limit + 1e-9);
  }
  opening -= qn_spring_dilation (spring, before->slip + slip)
             - qn_spring_dilation (spring, before->slip);
  if (fabs (slip) > 1e-9) {
    g_assert_true (reaches (rows, count, r->force, 1, 0));
    g_assert_cmpfloat (slip * r->force[1], >=, -1e-9);
  }
  if (fabs (opening) > 1e-9)
    g_assert_true (reaches (rows, count, r->force, 0, opening > 0 ? 1 : -1));
}

static void
test_strength (void)
{
  g_autoptr (GRand) random = g_rand_new_with_seed (5);
  int plastic = 0;

  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++) {
    if (!qn_law_is_plastic ((QnLawKind) kind))
      continue;
    plastic++;
    g_assert_true (qn_law_has_strength ((QnLawKind) kind));
    for (int trial = 0; trial < 200; trial++) {
      QnLaw law = { .name = "joint", .kind = (QnLawKind) kind, .kn = 2, .ks = 1 };
      law.friction = g_rand_double_range (random, 0, 1);
      law.dilatancy = law.friction * g_rand_double_range (random, 0, 1);
      law.dilation_end = trial % 5 ? 0 : g_rand_double_range (random, 0.1, 3);
      law.cohesion = trial % 2 ? g_rand_double_range (random, 0, 1) : 0;
      law.compression = g_rand_double_range (random, 0.2, 3);
      law.tension = trial % 3 ? g_rand_double_range (random, 0, 1) : 0;
      QnSpring spring = qn_spring_from_law (&law, 1, 1);
      QnSpringMemory memory = { 0 };
      for (int step = 0; step < 50; step++) {
        double q[2] = { g_rand_double_range (random, -3, 1),
                        g_rand_double_range (random, -4, 4) };
        QnSpringResponse response;
        qn_spring_evaluate (&spring, &memory, q, &response);
        check_flow (&spring, &memory, q, &response);
        memory = response.memory;
      }
    }
  }
  g_assert_cmpint (plastic, >, 0);
}

/* Rigid joints without tension slide as they like: only the row of opening is left, and none behind it. */
static void
test_rigid_strength (void)
{
  QnLaw law = { .name = "j", .kind = QN_LAW_NO_TENSION, .kn = 100, .ks = 60 };
  QnSpring spring = qn_spring_from_law (&law, 1, 1);
  QnStrengthRow rows[QN_STRENGTH_ROWS + 1] = { { 0 } };
  g_assert_cmpint (qn_spring_rigid_strength (&spring, rows), ==, 1);
  g_assert_cmpfloat (rows[0].shear, ==, 0);
  g_assert_cmpfloat (fabs (rows[0].normal), ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/spring/rigid-strength", test_rigid_strength);
  g_test_add_func ("/spring/bases", test_bases);
  g_test_add_func ("/spring/lengths", test_lengths);
  g_test_add_func ("/spring/similar", test_similar);
  g_test_add_func ("/spring/join-curve", test_join_curve);
  g_test_add_func ("/spring/strength", test_strength);
}
