/* Kinematic hardening: kn = 100, yield 10, r = 0.2, so that first yield is at 0.1 and the
 * elastic range is 0.2 wide. */
#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>

static Probe
fibre (double hardening)
{
  return probe_of_law (&(QnLaw){ .name = "fibre",
                                 .kind = QN_LAW_BILINEAR,
                                 .kn = 100,
                                 .ks = 40,
                                 .yield = 10,
                                 .hardening = hardening });
}

/* Load, unload past yield on the other side (Bauschinger: 20 below), reload. */
static void
test_cycle (void)
{
  static const double rows[][2] = {
    { 0.05, 5 },   { 0.1, 10 },  { 0.3, 14 }, { 0.2, 4 },  { 0.1, -6 }, { 0, -8 },
    { -0.3, -14 }, { -0.2, -4 }, { 0, 8 },    { 0.1, 10 }, { 0.5, 18 },
  };
  Probe p = fibre (0.2);
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

/* After any history the closed cycle between two fixed elongations repeats itself. */
static void
test_closed_cycle (void)
{
  Probe p = fibre (0.2);
  probe_go (&p, 0.7, 0);
  probe_go (&p, -0.4, 0);
  double top = probe_go (&p, 0.3, 0).force[0];
  double bottom = probe_go (&p, -0.4, 0).force[0];
  for (int i = 0; i < 1000; i++) {
    QnSpringResponse r = probe_go (&p, 0.3, 0);
    probe_assert_force (&r, top, 0);
    r = probe_go (&p, -0.4, 0);
    probe_assert_force (&r, bottom, 0);
  }
}

/* One step or many: the same, because loading on one side has no path. */
static void
test_steps (void)
{
  Probe one = fibre (0.2), many = fibre (0.2);
  QnSpringResponse whole = probe_go (&one, -0.9, 0), part = { 0 };
  for (int i = 1; i <= 90; i++)
    part = probe_go (&many, -0.01 * i, 0);
  probe_assert_force (&part, whole.force[0], 0);
  g_assert_cmpfloat_with_epsilon (many.memory.opening, one.memory.opening, 1e-14);
}

/* Shear is elastic, whatever the normal direction does. */
static void
test_shear (void)
{
  Probe p = fibre (0.2);
  QnSpringResponse r = probe_go (&p, 0.3, -0.5);
  probe_assert_force (&r, 14, -20);
  probe_assert_tangent (&p, 0.4, -0.6);
  r = probe_go (&p, 0.2, 0.1);
  probe_assert_force (&r, 4, 4);
}

static void
test_states (void)
{
  Probe p = fibre (0.2);
  g_assert_cmpint (probe_look (&p, 0.09, 0).state, ==, QN_PAIR_STICK);
  g_assert_cmpint (probe_look (&p, 0.11, 0).state, ==, QN_PAIR_YIELD);
  g_assert_cmpint (probe_look (&p, -0.11, 0).state, ==, QN_PAIR_YIELD);
}

QN_TESTS
{
  g_test_add_func ("/law-bilinear/cycle", test_cycle);
  g_test_add_func ("/law-bilinear/closed-cycle", test_closed_cycle);
  g_test_add_func ("/law-bilinear/steps", test_steps);
  g_test_add_func ("/law-bilinear/shear", test_shear);
  g_test_add_func ("/law-bilinear/states", test_states);
}
