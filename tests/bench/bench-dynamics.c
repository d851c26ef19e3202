/* Cost of analyses in time: wall 6 and a wall of 800 blocks under ten seconds of a record, and the
 * multi-drum column under an impulse, with adaptive steps, with contacts that follow the blocks, and beside
 * them with constant small steps. */
#include "bench/bench.h"
#include "core/path/analysis.h"
#include "support/earthquakes.h"
#include "support/models.h"
#include "support/walls.h"

#include <math.h>

/* The record: samples at 200 Hz for ten seconds. */
#define RATE     200
#define DURATION 10.0

/* Processor time that is allowed, s. */
#define WALL_6_SECONDS     30.0
#define LARGE_WALL_SECONDS 300.0

/* Ground that shakes at several frequencies, growing and dying away; its peak, m/s2. It is made here
 * and stands for no earthquake. */
static void
add_record (QnModel *model, double peak)
{
  static const double frequencies[] = { 0.7, 1.3, 2.1, 3.4, 5.2, 7.9 }; /* Hz */
  double largest = 0;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_POINTS;
  motion->direction = qn_vec2 (1, 0);
  for (int pass = 0; pass < 2; pass++)
    for (int i = 0; i <= RATE * (int) DURATION; i++) {
      double t = i / (double) RATE, a = 0;
      for (gsize k = 0; k < G_N_ELEMENTS (frequencies); k++)
        a += sin (2 * G_PI * frequencies[k] * t + 1.7 * (double) (k * k));
      a *= sin (G_PI * t / DURATION);
      if (pass == 0)
        largest = fmax (largest, fabs (a));
      else if (!qn_ground_motion_add_point (motion, t, peak * a / largest))
        g_error ("no memory");
    }
}

static void
set_up (QnModel *model, double duration, double rho, double damping)
{
  QnDynamicSettings *dynamic = &model->analysis.dynamic;
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model->analysis.max_factorizations = INT32_MAX;
  dynamic->duration = duration;
  dynamic->rho = rho;
  dynamic->joint_damping = damping;
  dynamic->output_interval = duration / 20;
}

static void
init_wall_6 (QnModel *model)
{
  test_model_init_wall (model, 6, 0);
  set_up (model, DURATION, 0.8, 5e-4);
  add_record (model, 1.5);
}

static void
init_large_wall (QnModel *model)
{
  test_bond_init (model, TEST_UNIT, 28, 28, 0, 0);
  set_up (model, DURATION, 0.8, 5e-4);
  add_record (model, 4);
}

static void
init_column (QnModel *model)
{
  test_earthquake_init_column (model, 0.4, 0.3);
  model->analysis.max_factorizations = INT32_MAX;
  model->analysis.dynamic.duration = 8;
  model->analysis.dynamic.output_interval = 8.0 / 20;
}

typedef struct Structure {
  const char *name;
  void (*init) (QnModel *model);
  double constant[2]; /* steps, s; 0: none */
  double seconds;     /* allowed for adaptive steps; 0: nothing is demanded */
} Structure;

static const Structure structures[] = {
  { "column", init_column, { 1e-3, 2.5e-4 }, 0 },
  { "wall 6", init_wall_6, { 1e-3, 5e-4 }, WALL_6_SECONDS },
  { "wall 800", init_large_wall, { 0, 0 }, LARGE_WALL_SECONDS },
};

/* One analysis; processor time, s. */
static double
run (FILE *csv, const Structure *structure, const char *name, double step,
     gboolean adaptive, gboolean follow)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnDiag diag = { 0 };
  structure->init (&model);
  model.analysis.dynamic.time_step = step;
  model.analysis.dynamic.adaptive = adaptive;
  model.analysis.dynamic.follow = follow;
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, &diag), ==, QN_OK);
  double begun = bench_cpu_seconds ();
  QnStatus status = qn_analysis_run (&model, &contacts, NULL, NULL, &result, &diag);
  double seconds = bench_cpu_seconds () - begun;
  if (status != QN_OK)
    g_error ("%s", qn_problem_text (diag.problem));
  const QnHistory *h = &result.history;
  const QnStatistics *spent = &result.statistics;
  double peak = 0;
  for (size_t b = 0; b < model.block_count; b++)
    peak = fmax (peak, h->peaks[b]);
  bench_csv_row (
    csv, "%s,%zu,%s,%g,%d,%d,%d,%d,%.2f,%.4f,%.4f,%.1e,%.4f", name, model.block_count,
    adaptive ? "adaptive" : "constant", 1e3 * step, h->steps, h->rejected,
    spent->iterations, spent->factorizations, seconds, 1e3 * seconds / h->steps,
    1e3 * spent->factor_seconds / MAX (spent->factorizations, 1), h->energy_error, peak);
  return seconds;
}

int
main (int argc, char **argv)
{
  bench_no_arguments (
    argc, argv, "What analyses in time cost, with adaptive and with constant steps.");
  FILE *csv = bench_csv_open (
    "dynamics", "structure,blocks,steps,longest ms,taken,rejected,iterations,"
                "factorisations,time s,time/step ms,factor and solve/factorisation ms,"
                "energy error,largest displacement m");
  FILE *bars = bench_bars_open ("dynamics");
  gboolean met = TRUE;
  for (gsize i = 0; i < G_N_ELEMENTS (structures); i++) {
    const Structure *s = &structures[i];
    for (int follow = 0; follow < 2; follow++) {
      g_autofree char *name = g_strconcat (s->name, follow ? " follow" : "", NULL);
      double seconds = run (csv, s, name, 5e-3, TRUE, follow);
      if (s->seconds > 0)
        met &= bench_bar (bars, "processor time of 10 s of record, s", name, seconds,
                          BENCH_AT_MOST, s->seconds);
    }
    for (gsize k = 0; k < G_N_ELEMENTS (s->constant) && s->constant[k] > 0; k++)
      run (csv, s, s->name, s->constant[k], FALSE, FALSE);
  }
  fclose (bars);
  fclose (csv);
  return met ? 0 : 1;
}
