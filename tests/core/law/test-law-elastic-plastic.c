#include "support/room.h"
#include "support/spring-probe.h"

#include <glib.h>

static void
test_cycle (void)
{
  static const double rows[][2] = {
    { 0.05, 5 }, { 0.4, 10 }, { 0.35, 5 },  { 0.25, -5 },  { -0.2, -10 },
    { -0.1, 0 }, { 0, 10 },   { 0.02, 10 }, { -0.13, -5 },
  };
  Probe p = probe_of_law (&(QnLaw){ .name = "fibre",
                                    .kind = QN_LAW_ELASTIC_PLASTIC,
                                    .kn = 100,
                                    .ks = 40,
                                    .yield = 10,
                                    .hardening = 0.5 /* is another law's */ });
  probe_assert_history (&p, rows, G_N_ELEMENTS (rows));
}

QN_TESTS
{
  g_test_add_func ("/law-elastic-plastic/cycle", test_cycle);
}
