/* What a multiplier means in words of the load. */
#include "doc/view/load-text.h"

#include "support/room.h"

static void
test_amount (void)
{
  static const struct {
    QnLoad loads[2];
    gsize count;
    const char *text;
  } cases[] = {
    { { { .kind = QN_LOAD_WEIGHT, .vector = { 1, 0 } } }, 1, "0.234 g" },
    { { { .kind = QN_LOAD_WEIGHT, .vector = { 0, 1 } } }, 1, NULL },
    { { { .kind = QN_LOAD_FORCE, .vector = { 0, -1000 } },
        { .kind = QN_LOAD_FORCE, .vector = { 0, -3000 } } },
      2,
      "0.936\u00a0kN" },
    { { { .kind = QN_LOAD_FORCE, .vector = { 0, -1000 } },
        { .kind = QN_LOAD_FORCE, .vector = { 1000, 0 } } },
      2,
      NULL },
    { { { .kind = QN_LOAD_WEIGHT, .vector = { 1, 0 } },
        { .kind = QN_LOAD_FORCE, .vector = { 1000, 0 } } },
      2,
      NULL },
    { { { .kind = QN_LOAD_FORCE, .vector = { 1000, 0 } },
        { .kind = QN_LOAD_FORCE, .set = 1, .vector = { 0, 1000 } } },
      2,
      "0.234\u00a0kN" },
    { { { .kind = QN_LOAD_VEHICLE, .convoy = 2 } }, 1, "93.6\u00a0kN" },
    { { { .kind = QN_LOAD_SETTLEMENT } }, 1, NULL },
  };
  QnVehicle truck = { .axles = { { .load = 5e4 }, { .load = 15e4 } }, .axle_count = 2 };
  const QnUnits units = { .force = QN_FORCE_KN };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const QnModel model = { .live_loads = (QnLoad *) cases[i].loads,
                            .live_load_count = cases[i].count,
                            .vehicles = &truck,
                            .vehicle_count = 1 };
    g_autofree char *text = qn_live_loads_dup_amount (&model, 0.234, units);
    g_assert_cmpstr (text, ==, cases[i].text);
  }
}

QN_TESTS
{
  g_test_add_func ("/load-text/amount", test_amount);
}
