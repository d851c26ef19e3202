/* What stiffness and offset of the joints do to multiplier and run time of the six walls in
 * linear geometry: the multiplier should not depend on the first, and it follows the second. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "core/path/analysis.h"
#include "support/models.h"

#include <math.h>

static Chart by_offset = { .name = "joints-offset",
                           .title =
                             "Six walls, dilatancy 0: multiplier against the offset "
                             "of the pairs from the corners",
                           .x_label = "Offset",
                           .x_unit = "mm",
                           .y_label = "Load multiplier",
                           .x_linear = TRUE,
                           .y_linear = TRUE };
static Chart by_ratio = { .name = "joints-ratio",
                          .title = "Six walls: processor time against ks/kn",
                          .x_label = "ks/kn",
                          .x_unit = "",
                          .y_label = "Time (s)" };
static Chart by_stiffness = { .name = "joints",
                              .title =
                                "Six walls: processor time against the stiffness of "
                                "the joints (kn = ks)",
                              .x_label = "Stiffness",
                              .x_unit = "N/m",
                              .y_label = "Time (s)" };

/* Of the joints where only something else changes, N/m. */
#define OWN_STIFFNESS 1e7

/* Multipliers with corners rounded by 20 mm, without dilatancy: LMGC90. */
static const double rounded[TEST_WALL_COUNT] = {
  0.578, 0.512, 0.321, 0.242, 0.175, 0.219
};

static void
run (FILE *csv, int number, double kn, double ratio, double offset, double reference)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;

  test_model_init_wall (&model, number, 0);
  model.laws[0].kn = kn;
  model.laws[0].ks = kn * ratio;
  model.contact.pairs.offset = offset;
  model.analysis.increments = 100;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  double start = bench_cpu_seconds ();
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  double seconds = bench_cpu_seconds () - start;
  bench_csv_row (csv, "%d,%g,%g,%g,%s,%.6f,%.3f,%+.3f,%.4f,%.3f,%d", number, kn, ratio,
                 1e3 * offset, qn_outcome_names[result.outcome],
                 result.collapse_multiplier, reference,
                 100 * (result.collapse_multiplier / reference - 1), seconds,
                 seconds / bench_kernel_seconds (), result.statistics.factorizations);
  g_autofree char *label = g_strdup_printf ("wall %d", number);
  if (ratio == 1 && offset == 0)
    chart_add (&by_stiffness, label, kn, seconds);
  if (kn == OWN_STIFFNESS && offset == 0)
    chart_add (&by_ratio, label, ratio, seconds);
  if (kn == OWN_STIFFNESS && ratio == 1)
    chart_add (&by_offset, label, 1e3 * offset, result.collapse_multiplier);
}

int
main (int argc, char **argv)
{
  static const double offsets[] = { 0.005, 0.01, 0.02, 0.04 }; /* m */
  bench_no_arguments (argc, argv,
                      "What stiffness and offset of the joints do to multiplier and run "
                      "time of the six walls.");
  FILE *csv =
    bench_csv_open ("joints", "wall,kn N/m,ks/kn,offset mm,outcome,multiplier,reference,"
                              "error %,time s,time/kernel,factorisations");
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    double published = test_walls[number - 1].non_associative;
    for (double kn = 1e4; kn < 2e12; kn *= 100)
      run (csv, number, kn, 1, 0, published);
    for (double ratio = 0.01; ratio < 200; ratio *= 10)
      run (csv, number, OWN_STIFFNESS, ratio, 0, published);
    for (size_t i = 0; i < G_N_ELEMENTS (offsets); i++)
      run (csv, number, OWN_STIFFNESS, 1, offsets[i],
           offsets[i] == 0.02 ? rounded[number - 1] : NAN);
  }
  fclose (csv);
  chart_write (&by_stiffness);
  chart_write (&by_ratio);
  chart_write (&by_offset);
  return 0;
}
