#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>

static Probe
joint (void)
{
  return probe_of_law (
    &(QnLaw){ .name = "joint", .kind = QN_LAW_NO_TENSION, .kn = 2, .ks = 1 });
}

static void
test_closed (void)
{
  Probe p = joint ();
  QnSpringResponse r = probe_look (&p, -3, 50);
  probe_assert_force (&r, -6, 50);
  probe_assert_tangent (&p, -3, 50);
}

/* The shear force goes to nothing with the last of the compression, not all at once. */
static void
test_lets_go (void)
{
  Probe p = joint ();
  QnSpringResponse r = probe_look (&p, -0.02, 50);
  probe_assert_force (&r, -0.04, QN_NO_TENSION_FRICTION * 0.04);
  probe_assert_tangent (&p, -0.02, 50);
  r = probe_look (&p, -1e-9, -50);
  probe_assert_force (&r, -2e-9, -QN_NO_TENSION_FRICTION * 2e-9);
}

/* Carries nothing while open, and is without shear where it closes again. */
static void
test_opens_and_closes (void)
{
  Probe p = joint ();
  probe_go (&p, -3, 5);
  QnSpringResponse r = probe_go (&p, 1, 7);
  g_assert_cmpint (r.state, ==, QN_PAIR_OPEN);
  probe_assert_force (&r, 0, 0);
  probe_assert_tangent (&p, 1, 7);
  r = probe_go (&p, -2, 7.5);
  probe_assert_force (&r, -4, 0.5);
}

QN_TESTS
{
  g_test_add_func ("/law-no-tension/closed", test_closed);
  g_test_add_func ("/law-no-tension/lets-go", test_lets_go);
  g_test_add_func ("/law-no-tension/opens-and-closes", test_opens_and_closes);
}
