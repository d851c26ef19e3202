/* What analyses in time find beside published values: the least impulse that overturns the multi-drum
 * column, the least pulse that overturns a block, the peaks of the arch of Lemos, the acceleration that
 * overturns the six walls where it grows slowly; with contacts that stay where they are drawn and with
 * contacts that follow the blocks. */
#include "bench/bench.h"
#include "support/earthquakes.h"
#include "support/models.h"
#include "support/walls.h"

#include <math.h>

/* Amplitudes that are tried between the ends of a range, and halvings of the interval then. */
#define SCAN       24
#define BISECTIONS 5

typedef void (*InitFunc) (QnModel *model, double amplitude, double duration);

/* Least of the amplitudes tried that overturns, between those of the bisections. */
static double
least_amplitude (InitFunc init, double duration, double low, double high, gboolean follow,
                 double *energy_error)
{
  double step = (high - low) / SCAN;
  QnModel model;
  for (int i = 0; i <= SCAN; i++) {
    init (&model, low + step * i, duration);
    if (!test_earthquake_overturns (&model, follow, energy_error))
      continue;
    if (i == 0)
      return low;
    double stands = low + step * (i - 1), falls = low + step * i;
    for (int k = 0; k < BISECTIONS; k++) {
      double middle = 0.5 * (stands + falls);
      init (&model, middle, duration);
      if (test_earthquake_overturns (&model, follow, energy_error))
        falls = middle;
      else
        stands = middle;
    }
    return falls;
  }
  return NAN;
}

static gboolean
within (double found, double least, double greatest)
{
  return found >= least && found <= greatest;
}

static gboolean
measure_column (FILE *csv, const char *contacts, gboolean follow)
{
  gboolean met = TRUE;
  for (gsize i = 0; i < TEST_COLUMNS; i++) {
    const TestColumn *known = &test_columns[i];
    double low = 0.95 * known->least, high = 1.05 * known->greatest, error = 0;
    double found = least_amplitude (test_earthquake_init_column, known->duration, low,
                                    high, follow, &error);
    gboolean fits = within (found, low, high) && found > low && error < 1e-3;
    met = met && fits;
    bench_csv_row (csv, "column t_p %g s (g),%s,%g to %g,%.4g,%.1e,%s", known->duration,
                   contacts, known->least, known->greatest, found, error,
                   fits ? "yes" : "no");
  }
  return met;
}

static gboolean
measure_block (FILE *csv, const char *contacts, gboolean follow)
{
  const double p = test_earthquake_block_frequency ();
  gboolean met = TRUE;
  for (int i = 0; i < 25; i++) {
    int impacts, halves = i < 20 ? 1 : 2;
    double ratio = i < 20 ? 1 + 0.5 * i : i - 18;
    double pulse = halves * G_PI / (p * ratio), error = 0;
    double exact = test_earthquake_exact_boundary (halves, pulse, &impacts);
    double found = least_amplitude (halves == 1 ? test_earthquake_init_block
                                                : test_earthquake_init_block_sine,
                                    pulse, 0.95 * exact, 1.05 * exact, follow, &error);
    gboolean fits = fabs (found / exact - 1) < 0.05 && error < 1e-3;
    met = met && fits;
    bench_csv_row (csv, "block %s omega/p %g (g),%s,%.4f,%.4f,%.1e,%s",
                   halves == 1 ? "half-sine" : "sine", ratio, contacts, exact / TEST_G,
                   found / TEST_G, error, fits ? "yes" : "no");
  }
  return met;
}

static gboolean
measure_arch (FILE *csv, const char *contacts, gboolean follow)
{
  const struct {
    const char *name;
    double known;
  } values[] = { { "arch first peak (mm)", 1e3 * TEST_ARCH_FIRST },
                 { "arch first peak (s)", TEST_ARCH_FIRST_TIME },
                 { "arch second peak (mm)", 1e3 * TEST_ARCH_SECOND },
                 { "arch second peak (s)", TEST_ARCH_SECOND_TIME } };
  gboolean met = TRUE;
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  double peaks[2], times[2];
  test_earthquake_init_arch (&model);
  test_earthquake_solve (&model, follow, &result);
  test_earthquake_arch_peaks (&model, &result.history, peaks, times);
  for (gsize i = 0; i < G_N_ELEMENTS (values); i++) {
    double found = i % 2 == 0 ? 1e3 * peaks[i / 2] : times[i / 2];
    double error = result.history.energy_error;
    gboolean fits = fabs (found / values[i].known - 1) < 0.1 && error < 1e-3;
    met = met && fits;
    bench_csv_row (csv, "%s,%s,%g,%.4g,%.1e,%s", values[i].name, contacts,
                   values[i].known, found, error, fits ? "yes" : "no");
  }
  return met;
}

/* --- Walls under an acceleration that grows so slowly that inertia does not matter --------------- */

/* To so much of the static multiplier in so many seconds; from there on slowly, so that what damping by
 * mass holds back is a small part of it. */
static const struct {
  double time, part;
} ramp[] = { { 0, 0 }, { 10, 0.9 }, { 40, 1.05 } };

#define RAMP_STIFFNESS 1e9 /* N/m */

/* Seeds of generated walls, and their size in blocks. */
#define FIRST_SEED 301
#define LAST_SEED  312
#define LEAST      30
#define MOST       90

/* One of the six walls, or the wall of a seed. */
static void
init_wall (QnModel *model, int number)
{
  if (number <= TEST_WALL_COUNT) {
    test_model_init_wall (model, number, 0);
  } else {
    test_wall_draw_sized (model, (guint32) number, LEAST, MOST);
  }
  for (size_t law = 0; law < model->law_count; law++)
    model->laws[law].kn = model->laws[law].ks = RAMP_STIFFNESS;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
}

/* Collapse multiplier of the static path, the block that has moved furthest at its last step, and how far
 * since the dead load, m. NAN where the wall does not stand. */
static double
static_collapse (int number, QnId *block, double *moved)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  init_wall (&model, number);
  test_earthquake_solve (&model, FALSE, &result);
  *moved = 0;
  if (result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    return NAN;
  const double *first = qn_result_step_displacements (&result, 0),
               *last = qn_result_step_displacements (&result, result.step_count - 1);
  for (size_t b = 0; b < model.block_count; b++) {
    double way = hypot (last[3 * b] - first[3 * b], last[3 * b + 1] - first[3 * b + 1]);
    if (way > *moved) {
      *moved = way;
      *block = (QnId) b;
    }
  }
  double multiplier = result.collapse_multiplier;
  return multiplier;
}

/* The acceleration, over g, at which that block has moved as far in time. */
static double
ramp_acceleration (int number, double multiplier, QnId block, double moved,
                   gboolean follow, double *energy_error)
{
  g_auto (QnModel) model;
  g_auto (QnResult) result;
  double found = NAN;
  init_wall (&model, number);
  QnDynamicSettings *dynamic = &model.analysis.dynamic;
  model.analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model.analysis.max_factorizations = INT32_MAX;
  dynamic->duration = dynamic->output_interval = ramp[G_N_ELEMENTS (ramp) - 1].time;
  dynamic->time_step = 0.02;
  dynamic->rho = 0.5;
  dynamic->mass_damping = number < 6 ? 5 : 1;
  dynamic->joint_damping = number <= TEST_WALL_COUNT ? 0 : 2e-4;
  QnGroundMotion *motion = qn_model_add_ground_motion (&model);
  motion->kind = QN_SIGNAL_POINTS;
  motion->direction = qn_vec2 (-1, 0); /* inertia acts along +x, as the live load */
  for (gsize i = 0; i < G_N_ELEMENTS (ramp); i++)
    g_assert_true (qn_ground_motion_add_point (
      motion, ramp[i].time, ramp[i].part * multiplier * model.gravity));
  for (int dof = 0; dof < 2; dof++) {
    QnTrack *track = qn_model_add_track (&model);
    track->block = block;
    track->dof = (QnDof) dof;
  }
  test_earthquake_solve (&model, follow, &result);
  const QnHistory *h = &result.history;
  const double *first = h->rows + QN_HISTORY_TRACK;
  for (size_t i = 0; i < h->row_count && isnan (found); i++) {
    const double *now = first + i * h->width;
    if (hypot (now[0] - first[0], now[1] - first[1]) >= moved)
      found = -h->rows[i * h->width + QN_HISTORY_GROUND_X] / model.gravity;
  }
  *energy_error = h->energy_error;
  return found;
}

static gboolean
measure_wall (FILE *csv, int number, gboolean follow)
{
  g_autofree char *name =
    number <= TEST_WALL_COUNT
      ? g_strdup_printf ("wall %d", number)
      : g_strdup_printf ("seed %d, %s", number, test_wall_family ((guint32) number));
  QnId block;
  double moved, error, multiplier = static_collapse (number, &block, &moved);
  if (isnan (multiplier))
    return TRUE;
  double found = ramp_acceleration (number, multiplier, block, moved, follow, &error);
  /* A wall that is shaken may jump a little sooner than one that is pushed, or later. */
  double most = number <= TEST_WALL_COUNT ? 0.01 : 0.02;
  gboolean fits = fabs (found / multiplier - 1) < most && error < 1e-3;
  bench_csv_row (csv, "%s; slow ramp (g),%s,%.5f,%.5f,%.1e,%s", name,
                 follow ? "follow" : "fixed", multiplier, found, error,
                 fits ? "yes" : "no");
  return fits;
}

int
main (int argc, char **argv)
{
  bench_no_arguments (argc, argv, "Analyses in time beside published values.");
  FILE *csv =
    bench_csv_open ("earthquakes", "case,contacts,reference,found,energy error,met");
  gboolean met = TRUE;
  for (int follow = 0; follow < 2; follow++) {
    const char *contacts = follow ? "follow" : "fixed";
    met &= measure_arch (csv, contacts, follow);
    met &= measure_column (csv, contacts, follow);
    met &= measure_block (csv, contacts, follow);
  }
  for (int number = 1; number <= TEST_WALL_COUNT; number++)
    for (int follow = 0; follow < 2; follow++)
      met &= measure_wall (csv, number, follow);
  for (int seed = FIRST_SEED; seed <= LAST_SEED; seed++)
    met &= measure_wall (csv, seed, FALSE);
  fclose (csv);
  return met ? 0 : 1;
}
