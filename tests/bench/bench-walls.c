/* Run time against error on the six walls of Ferris & Tin-Loi: increments, tolerances, procedures,
 * with and without going on beyond the first limit point by relaxation.
 *
 * With dilatancy = friction the answer is known exactly (linear program); without dilatancy the
 * reference is the published limit analysis, of three digits. */
#include "bench/bench.h"
#include "bench/chart.h"
#include "core/path/analysis.h"
#include "support/models.h"

#include <math.h>

#define FRICTION 0.65

/* A run that takes longer is stopped and counts as cancelled. */
#define MOST_SECONDS 20

/* Errors below are drawn there, %. */
#define LEAST_DRAWN 1e-6

static Chart by_tolerance = { .name = "walls",
                              .title = "Six walls, dilatancy = friction: error against "
                                       "processor time for tolerances 1e-2 to 1e-6",
                              .x_label = "Time",
                              .x_unit = "s",
                              .y_label = "Error (%)" };
static Chart by_increments = { .name = "walls-increments",
                               .title = "Six walls, dilatancy = friction: error against "
                                        "processor time for 3 to 1000 increments",
                               .x_label = "Time",
                               .x_unit = "s",
                               .y_label = "Error (%)" };
static Chart by_procedure = { .name = "walls-procedures",
                              .title = "Six walls, dilatancy 0: processor time of every "
                                       "procedure, 100 increments",
                              .x_label = "Wall",
                              .x_unit = "",
                              .y_label = "Time (s)",
                              .x_linear = TRUE };
static Chart cost = { .name = "walls-cost",
                      .title = "Six walls, dilatancy 0: processor time against "
                               "increments, tolerance 1e-4",
                      .x_label = "Increments",
                      .x_unit = "",
                      .y_label = "Time (s)" };

/* What a run is asked for. */
typedef struct Setting {
  QnProcedure procedure;
  int increments;
  double tolerance;
  QnSnapThrough snap;
} Setting;

static const char *const procedures[] = { "load", "displacement", "work", "arc-length",
                                          "limit" };

/* The largest multiplier with an equilibrium: that of collapse, or the highest step. */
static double
highest_multiplier (const QnResult *result)
{
  double highest = result->has_collapse_multiplier ? result->collapse_multiplier : 0;
  for (size_t i = 0; i < result->step_count; i++)
    highest = fmax (highest, result->steps[i].multiplier);
  return highest;
}

static void
draw (int number, double dilatancy, const Setting *setting, double seconds, double error)
{
  g_autofree char *wall = g_strdup_printf ("wall %d", number);
  gboolean load = setting->procedure == QN_PROCEDURE_LOAD, associative = dilatancy > 0;
  gboolean relaxed = setting->snap == QN_SNAP_THROUGH_JUMP;

  error = fmax (error, LEAST_DRAWN);
  if (associative && load && relaxed && setting->increments == 30)
    chart_add (&by_tolerance, wall, seconds, error);
  if (associative && load && relaxed && setting->tolerance == 1e-4)
    chart_add (&by_increments, wall, seconds, error);
  if (!associative && setting->tolerance == 1e-4
      && (setting->increments == 100 || setting->procedure == QN_PROCEDURE_LIMIT))
    chart_add (&by_procedure,
               relaxed ? procedures[setting->procedure] : "load, no relaxation", number,
               seconds);
  if (!associative && load && relaxed && setting->tolerance == 1e-4)
    chart_add (&cost, wall, setting->increments, seconds);
}

static void
run (FILE *csv, int number, double dilatancy, const Setting *setting)
{
  const TestWall *wall = &test_walls[number - 1];
  double reference = dilatancy > 0 ? wall->associative : wall->non_associative;
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;

  test_model_init_wall (&model, number, dilatancy);
  model.analysis.procedure = setting->procedure;
  model.analysis.increments = setting->increments;
  model.analysis.multiplier_tolerance = setting->tolerance;
  model.analysis.snap = setting->snap;
  model.analysis.flow = dilatancy > 0 ? QN_FLOW_ASSOCIATIVE : QN_FLOW_NON_ASSOCIATIVE;
  if (setting->procedure
      == QN_PROCEDURE_DISPLACEMENT) { /* of the last block of the top */
    model.analysis.control.block = (QnId) wall->blocks - 1;
    model.analysis.control.dof = QN_DOF_UX;
    model.analysis.control.target = 0.5;
  }
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  double start = bench_cpu_seconds (), end = start + MOST_SECONDS;
  g_assert_cmpint (
    qn_analysis_run (&model, &contacts, bench_within_time, &end, &result, NULL), ==,
    QN_OK);
  double seconds = bench_cpu_seconds () - start;
  double value = highest_multiplier (&result), error = 100 * (value / reference - 1);
  bench_csv_row (csv, "%d,%g,%s,%d,%g,%s,%s,%.6f,%.6f,%+.4f,%.4f,%.3f,%d,%d", number,
                 dilatancy, procedures[setting->procedure], setting->increments,
                 setting->tolerance, setting->snap == QN_SNAP_THROUGH_STOP ? "off" : "on",
                 qn_outcome_names[result.outcome], value, reference, error, seconds,
                 seconds / bench_kernel_seconds (), result.statistics.iterations,
                 result.statistics.factorizations);
  draw (number, dilatancy, setting, seconds, fabs (error));
}

/* Every increment, tolerance and procedure, with relaxation and without. */
static void
run_wall (FILE *csv, int number, double dilatancy)
{
  static const int increments[] = { 3, 10, 30, 100, 300, 1000 };
  static const double tolerances[] = { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 };
  static const QnProcedure controlled[] = { QN_PROCEDURE_DISPLACEMENT, QN_PROCEDURE_WORK,
                                            QN_PROCEDURE_ARC_LENGTH };
  Setting setting;

  for (int snap = 0; snap < QN_SNAP_THROUGH_COUNT; snap++) {
    setting = (Setting){ QN_PROCEDURE_LOAD, 30, 1e-4, (QnSnapThrough) snap };
    for (size_t i = 0; i < G_N_ELEMENTS (increments); i++) {
      setting.increments = increments[i];
      run (csv, number, dilatancy, &setting);
    }
    setting.increments = 30;
    for (size_t i = 0; i < G_N_ELEMENTS (tolerances); i++) {
      setting.tolerance = tolerances[i];
      if (setting.tolerance != 1e-4) /* with the increments already */
        run (csv, number, dilatancy, &setting);
    }
  }
  for (size_t i = 0; i < G_N_ELEMENTS (controlled); i++)
    for (size_t k = 1; k < G_N_ELEMENTS (increments); k += 2) {
      setting = (Setting){ controlled[i], increments[k], 1e-4, QN_SNAP_THROUGH_JUMP };
      run (csv, number, dilatancy, &setting);
    }
  setting = (Setting){ QN_PROCEDURE_LIMIT, 1, 1e-4, QN_SNAP_THROUGH_JUMP };
  run (csv, number, dilatancy, &setting);
}

int
main (int argc, char **argv)
{
  bench_no_arguments (argc, argv,
                      "Run time against error on the six walls of Ferris & Tin-Loi.");
  FILE *csv = bench_csv_open (
    "walls", "wall,dilatancy,procedure,increments,tolerance,relaxation,outcome,"
             "multiplier,reference,error %,time s,time/kernel,iterations,factorisations");
  for (int number = 1; number <= TEST_WALL_COUNT; number++)
    for (int associative = 0; associative < 2; associative++)
      run_wall (csv, number, associative * FRICTION);
  fclose (csv);
  chart_write (&by_tolerance);
  chart_write (&by_increments);
  chart_write (&by_procedure);
  chart_write (&cost);
  return 0;
}
