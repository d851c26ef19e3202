/* Small walls shaken with every kind of joint: which motions are followed to their end, and what is lost
 * of their energy. */
#include "bench/bench.h"

#include "core/path/analysis.h"
#include "support/auto-clear.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>
#include <stdio.h>

#define FIRST 2001
#define COUNT 40

/* Blocks of a wall. */
#define LEAST 20
#define MOST  60

/* Error of the energy balance that is too large, over the input. */
#define ENERGY_ERROR 1e-3

#define NORMAL_STIFFNESS 2e10 /* Pa/m */

static const struct {
  const char *name;
  QnLawKind kind;
  double friction, cohesion, tension, dilatancy, compression;
} joints[] = {
  { "lime mortar: c 0.1 MPa, no tension", QN_LAW_COULOMB, 0.4, 1e5, 0, 0, 0 },
  { "c 20 kPa, no tension", QN_LAW_COULOMB, 0.55, 2e4, 0, 0, 0 },
  { "c 5 kPa, ft 2 kPa", QN_LAW_COULOMB, 0.6, 5e3, 2e3, 0, 0 },
  { "dry, dilatancy 0.2", QN_LAW_COULOMB, 0.65, 0, 0, 0.2, 0 },
  { "dry", QN_LAW_COULOMB, 0.65, 0, 0, 0, 0 },
  { "c 5 kPa, fc 0.2 MPa", QN_LAW_MOHR_COULOMB, 0.6, 5e3, 0, 0, 2e5 },
};

static const struct {
  const char *name;
  QnGeometry geometry;
  double rho, joint_damping, mass_damping;
  QnDampingStiffness of;
  QnPulse pulse; /* m/s2, s */
} settings[] = {
  { "sine 5 m/s2 0.4 s, rho 0.8, damping 5e-4 s",
    QN_GEOMETRY_NONLINEAR,
    0.8,
    5e-4,
    0,
    QN_DAMPING_CURRENT,
    { QN_PULSE_SINE, 5, 0.4, 0 } },
  { "half sine 9 m/s2 0.2 s, rho 1",
    QN_GEOMETRY_NONLINEAR,
    1,
    0,
    0,
    QN_DAMPING_CURRENT,
    { QN_PULSE_HALF_SINE, 9, 0.2, 0 } },
  { "ricker 6 m/s2 0.3 s, rho 0.5, initial damping",
    QN_GEOMETRY_NONLINEAR,
    0.5,
    2e-4,
    0,
    QN_DAMPING_INITIAL,
    { QN_PULSE_RICKER, 6, 0.3, 0 } },
  { "linear, sine 4 m/s2 0.3 s, rho 0.8",
    QN_GEOMETRY_LINEAR,
    0.8,
    1e-4,
    0,
    QN_DAMPING_CURRENT,
    { QN_PULSE_SINE, 4, 0.3, 0 } },
  { "linear, rectangle 8 m/s2 0.25 s, rho 0, damping by mass",
    QN_GEOMETRY_LINEAR,
    0,
    0,
    1,
    QN_DAMPING_CURRENT,
    { QN_PULSE_RECTANGLE, 8, 0.25, 0.05 } },
};

typedef struct Options {
  int first, count;
  double duration;
} Options;

/* What became of the walls with one kind of joint under one motion. */
typedef struct Tally {
  int runs, ended, overturned, failed;
  double energy_error; /* largest of those that ended */
  int64_t factorizations;
} Tally;

static gboolean
parse (int *argc, char ***argv, Options *options, GError **error)
{
  const GOptionEntry entries[] = {
    { "first", 0, 0, G_OPTION_ARG_INT, &options->first, "First seed (2001)", "SEED" },
    { "count", 0, 0, G_OPTION_ARG_INT, &options->count, "How many walls (40)", "N" },
    { "duration", 0, 0, G_OPTION_ARG_DOUBLE, &options->duration, "Of a motion (0.8)",
      "S" },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, argc, argv, error))
    return FALSE;
  if (*argc == 1 && options->first >= 1 && options->count >= 1 && options->duration > 0)
    return TRUE;
  g_set_error (error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
               "seeds and counts from 1, a duration above 0, nothing else");
  return FALSE;
}

static void
set_up (QnModel *model, gsize joint, gsize setting, double duration)
{
  QnDynamicSettings *dynamic = &model->analysis.dynamic;

  for (size_t i = 0; i < model->law_count; i++) {
    QnLaw *law = &model->laws[i];
    law->kind = joints[joint].kind;
    law->basis = QN_BASIS_SURFACE;
    law->kn = NORMAL_STIFFNESS;
    law->ks = 0.5 * NORMAL_STIFFNESS;
    law->friction = joints[joint].friction;
    law->cohesion = joints[joint].cohesion;
    law->tension = joints[joint].tension;
    law->dilatancy = joints[joint].dilatancy;
    law->compression = joints[joint].compression;
  }
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.geometry = settings[setting].geometry;
  dynamic->duration = duration;
  dynamic->time_step = 0.005;
  dynamic->rho = settings[setting].rho;
  dynamic->joint_damping = settings[setting].joint_damping;
  dynamic->mass_damping = settings[setting].mass_damping;
  dynamic->of = settings[setting].of;
  dynamic->output_interval = 0.1;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0.3);
  motion->pulse = settings[setting].pulse;
}

static void
shake (const Options *options, int seed, gsize joint, gsize setting, Tally *tally)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  test_wall_draw_sized (&model, (guint32) seed, LEAST, MOST);
  set_up (&model, joint, setting, options->duration);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                   QN_OK);
  tally->runs++;
  tally->factorizations += result.statistics.factorizations;
  gboolean ended = result.outcome == QN_OUTCOME_COLLAPSE
                   || result.outcome == QN_OUTCOME_REST
                   || result.outcome == QN_OUTCOME_TARGET_REACHED;
  if (!ended) {
    tally->failed++;
    printf ("# seed %d (%s), %s, %s: outcome %d, stop %d, at %.5f s\n", seed,
            test_wall_family ((guint32) seed), joints[joint].name, settings[setting].name,
            result.outcome, result.stop, result.history.end);
    return;
  }
  tally->ended++;
  tally->overturned += result.outcome == QN_OUTCOME_COLLAPSE;
  tally->energy_error = MAX (tally->energy_error, result.history.energy_error);
}

int
main (int argc, char **argv)
{
  Options options = { .first = FIRST, .count = COUNT, .duration = 0.8 };
  g_autoptr (GError) error = NULL;
  gboolean met = TRUE;
  if (!parse (&argc, &argv, &options, &error)) {
    fprintf (stderr, "bench-motions: %s\n", error->message);
    return 2;
  }
  FILE *csv =
    bench_csv_open ("motions", "joints,motion,walls,followed to the end,overturned,"
                               "largest energy error,factorisations,met");
  for (gsize joint = 0; joint < G_N_ELEMENTS (joints); joint++)
    for (gsize setting = 0; setting < G_N_ELEMENTS (settings); setting++) {
      Tally tally = { 0 };
      for (int i = 0; i < options.count; i++)
        shake (&options, options.first + i, joint, setting, &tally);
      gboolean fits = tally.failed == 0 && tally.energy_error < ENERGY_ERROR;
      met = met && fits;
      bench_csv_row (csv, "\"%s\",\"%s\",%d,%d,%d,%.1e,%" G_GINT64_FORMAT ",%s",
                     joints[joint].name, settings[setting].name, tally.runs, tally.ended,
                     tally.overturned, tally.energy_error, tally.factorizations,
                     fits ? "yes" : "no");
    }
  fclose (csv);
  return met ? 0 : 1;
}
