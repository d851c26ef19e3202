#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>

/* Linear in both directions and without memory. */
static void
test_linear (void)
{
  static const double elongations[][2] = { { -3, 2 }, { 4, -5 }, { 0, 1 }, { -1, 0 } };
  Probe p = probe_of_law (
    &(QnLaw){ .name = "stone", .kind = QN_LAW_ELASTIC, .kn = 2, .ks = 0.5 });
  for (size_t i = 0; i < G_N_ELEMENTS (elongations); i++) {
    const double *q = elongations[i];
    probe_assert_tangent (&p, q[0], q[1]);
    QnSpringResponse r = probe_go (&p, q[0], q[1]);
    probe_assert_force (&r, 2 * q[0], 0.5 * q[1]);
  }
}

QN_TESTS
{
  g_test_add_func ("/law-elastic/linear", test_linear);
}
