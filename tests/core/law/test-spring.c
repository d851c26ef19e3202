#include "core/law/spring.h"

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

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/spring/bases", test_bases);
  g_test_add_func ("/spring/lengths", test_lengths);
  g_test_add_func ("/spring/similar", test_similar);
  g_test_add_func ("/spring/join-curve", test_join_curve);
  return g_test_run ();
}
