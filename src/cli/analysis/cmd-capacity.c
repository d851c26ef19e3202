#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "core/base/numbers.h"
#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "io/exchange/record.h"
#include "io/text/file-inside.h"
#include "io/text/file-writer.h"
#include "io/text/number-text.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* What "g" is in --ag, m/s2. */
#define STANDARD_GRAVITY 9.80665

/* A number that no option is meant to be. */
#define NOT_GIVEN -1e300

/* Share of mass below which a word is due. */
#define SMALL_SHARE 0.5

typedef struct CapacityOptions {
  QnPictureOptions picture;
  char *json, *csv, *spectrum, *ag, *soil, *unit, *control;
  QnInputOptions input;
  double damping, confidence;
  gboolean quiet;
} CapacityOptions;

typedef struct Answer {
  const QnInput *input;
  QnRecord points; /* of a spectrum from a file */
  QnCapacityAnswer answer;
  char *reason; /* why the path ended before multiplier 0, or NULL */
} Answer;

/* --- What is asked ----------------------------------------------------------------------- */

/* "2.45" in m/s2, or "0.25g". 0 where it is neither. */
static double
parse_acceleration (const char *text)
{
  char *end;
  double value = g_ascii_strtod (text, &end);
  if (end != text && strcmp (end, "g") == 0)
    value *= STANDARD_GRAVITY;
  else if (end == text || *end != '\0')
    return 0;
  return qn_number_problem (value, QN_RANGE_POSITIVE, QN_LARGEST_NUMBER)
             == QN_PROBLEM_NONE
           ? value
           : 0;
}

static gboolean
is_of_code (const char *spectrum)
{
  return strcmp (spectrum, "type1") == 0 || strcmp (spectrum, "type2") == 0;
}

static void
take_text (char **option, const char *kept)
{
  if (*option == NULL)
    *option = g_strdup (kept);
}

/* Options that are not given are those of the project. A file that the project names lies beside
 * it. */
static gboolean
take_kept (CapacityOptions *options, const QnProject *project, GError **error)
{
  QnCapacitySettings kept;
  gboolean named = options->spectrum == NULL, found = TRUE;
  if (!qn_capacity_settings_read (project, &kept, error))
    return FALSE;
  take_text (&options->control, kept.control);
  if (named && kept.spectrum != NULL && !is_of_code (kept.spectrum)) {
    g_autofree char *folder = g_path_get_dirname (project->path);
    options->spectrum =
      qn_file_inside (folder, kept.spectrum, options->input.allow_outside, error);
    found = options->spectrum != NULL;
  } else
    take_text (&options->spectrum, kept.spectrum);
  if (options->spectrum != NULL && is_of_code (options->spectrum)) {
    char number[QN_NUMBER_TEXT_SIZE];
    qn_number_text (kept.ag, number);
    take_text (&options->ag, kept.ag > 0 ? number : NULL);
    take_text (&options->soil, kept.soil);
  } else if (named)
    take_text (&options->unit, kept.unit);
  if (options->damping == NOT_GIVEN)
    options->damping = kept.damping > 0 ? kept.damping : 0.05;
  if (options->confidence == NOT_GIVEN)
    options->confidence = kept.confidence > 0 ? kept.confidence : 1;
  qn_capacity_settings_clear (&kept);
  return found;
}

static QnExit
parse_spectrum (const QnSubcommand *self, const CapacityOptions *options, Answer *answer)
{
  GError *error = NULL;
  if (!(options->confidence >= 1) || !isfinite (options->confidence))
    return qn_cli_usage_error (self->name, _ ("--confidence is a factor of 1 or more"));
  if (!(options->damping > 0 && options->damping < 1))
    return qn_cli_usage_error (self->name, _ ("--damping is a ratio between 0 and 1"));
  answer->answer.confidence = options->confidence;
  answer->answer.has_spectrum = options->spectrum != NULL;
  if (!answer->answer.has_spectrum) {
    if (options->ag == NULL && options->soil == NULL && options->unit == NULL)
      return QN_EXIT_DONE;
    return qn_cli_usage_error (self->name, _ ("--spectrum is missing"));
  }
  if (is_of_code (options->spectrum)) {
    QnSpectrum *s = &answer->answer.spectrum;
    s->kind =
      strcmp (options->spectrum, "type1") == 0 ? QN_SPECTRUM_EN_1 : QN_SPECTRUM_EN_2;
    s->damping = options->damping;
    if (options->ag == NULL || options->soil == NULL)
      return qn_cli_usage_error (self->name,
                                 _ ("a spectrum of EN 1998-1 needs --ag and --soil"));
    s->ground_acceleration = parse_acceleration (options->ag);
    if (s->ground_acceleration == 0)
      return qn_cli_usage_error (
        self->name, _ ("--ag is a positive acceleration in m/s2, or in g as 0.25g"));
    if (strlen (options->soil) != 1 || *options->soil < 'A' || *options->soil > 'E')
      return qn_cli_usage_error (self->name, _ ("--soil is A, B, C, D or E"));
    s->soil = (QnSoil) (*options->soil - 'A');
    return QN_EXIT_DONE;
  }
  if (options->ag != NULL || options->soil != NULL)
    return qn_cli_usage_error (
      self->name, _ ("--ag and --soil belong to the spectra type1 and type2"));
  if (!qn_record_read (options->spectrum, options->unit, 0, &answer->points, &error))
    return qn_cli_fail (error);
  answer->answer.spectrum = (QnSpectrum){ .kind = QN_SPECTRUM_POINTS,
                                          .damping = options->damping,
                                          .points = answer->points.points,
                                          .point_count = answer->points.count };
  for (gsize i = 0; i < answer->points.count; i++)
    if (!(answer->points.points[i].y > 0)) {
      qn_cli_error (_ ("%s: accelerations of a spectrum must be positive"),
                    options->spectrum);
      return QN_EXIT_INVALID;
    }
  return QN_EXIT_DONE;
}

/* --- The path ---------------------------------------------------------------------------- */

static QnExit
find (QnInput *input, const CapacityOptions *options, Answer *answer)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  QnModel *model = &input->project.model;
  QnId control = QN_NONE;
  if (options->control != NULL) {
    control = qn_model_find_block (model, options->control);
    if (control == QN_NONE) {
      qn_cli_error (_ ("%s: --control: no block has the name %s"), input->project.name,
                    options->control);
      return QN_EXIT_INVALID;
    }
  }
  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, options->quiet);
  QnCapacityEnd end = qn_capacity_answer_find (&answer->answer, model, &input->contacts,
                                               control, qn_terminal_progress_update,
                                               &progress, &answer->reason, &diag);
  qn_terminal_progress_done (&progress);
  switch (end) {
  case QN_CAPACITY_FOUND:
    return QN_EXIT_DONE;
  case QN_CAPACITY_CANCELLED:
    return qn_cli_cancelled (input->project.name);
  case QN_CAPACITY_REFUSED:
    return qn_input_refuse (&input->project, &diag);
  case QN_CAPACITY_STAGES:
  case QN_CAPACITY_NO_ANSWER:
    break;
  }
  qn_cli_error ("%s: %s", input->project.name, answer->reason);
  return end == QN_CAPACITY_STAGES ? QN_EXIT_INVALID : QN_EXIT_NO_ANSWER;
}

/* --- Output ---------------------------------------------------------------------- */

static void
print (const Answer *answer)
{
  const QnCapacity *c = &answer->answer.capacity;
  const QnModel *model = &answer->input->project.model;
  const QnCapacityPoint *peak = &c->points[c->peak];
  qn_print (_ ("%s: controlled by ux of block %s\n"),
            model->title != NULL ? model->title : answer->input->project.name,
            model->blocks[c->block].name);
  qn_print (
    _ ("%zu of %zu blocks take part, %.6g kg; participating mass M* %.6g kg, e* %.4f\n"),
    c->participating, model->block_count, c->moving_mass, c->mass, c->share);
  if (c->left_out > 0)
    qn_print (_ ("%.1f %% of the mass that is not fixed does not take part\n"),
              100 * c->left_out / (c->left_out + c->moving_mass));
  qn_print (_ ("peak: multiplier %.5f at %.4g m; d* %.4g m, a* %.4g m/s2\n"),
            peak->multiplier, peak->control, peak->displacement, peak->acceleration);
  if (c->reaches_zero)
    qn_print (_ ("multiplier back at zero: d0* %.4g m\n"), c->end);
  else
    qn_print (_ ("the path ends at d* %.4g m, multiplier %.5f, before zero: its end is "
                 "taken as d0*. %s\n"),
              c->end, c->points[c->count - 1].multiplier, answer->reason);
  if (c->share < SMALL_SHARE)
    qn_print (
      _ ("e* is small: the blocks move very differently, and a* of the codes is %.1f "
         "times what virtual work gives, multiplier times g\n"),
      1 / c->share);
  if (!answer->answer.has_spectrum)
    return;
  qn_print ("%-36s %5s %12s %12s %10s %12s %10s\n", _ ("code"), _ ("state"),
            _ ("capacity [m]"), _ ("a* [m/s2]"), _ ("T [s]"), _ ("demand [m]"),
            _ ("ratio"));
  for (int i = 0; i < QN_CAPACITY_STATE_COUNT; i++) {
    const QnCapacityState *s = &answer->answer.states[i];
    g_autofree char *verdict = qn_capacity_dup_verdict (s);
    qn_print ("%-36s %5s %12.5g %12.5g %10.4g %12.5g  %s\n",
              qn_capacity_check_code ((QnCapacityCheck) i),
              qn_capacity_check_name ((QnCapacityCheck) i), s->capacity, s->acceleration,
              s->period, s->demand, verdict);
  }
  qn_print (_ ("ratio: capacity over demand; the check is met from 1 on\n"));
  for (int i = 0; i < QN_CAPACITY_STATE_COUNT; i++) {
    g_autofree char *rests =
      qn_capacity_dup_basis (&answer->answer.states[i], (QnCapacityCheck) i);
    qn_print ("%s\n", rests);
  }
}

static QnExit
write_json (const Answer *answer, const char *path)
{
  const QnCapacity *c = &answer->answer.capacity;
  const QnEnDemand *en = &answer->answer.en;
  GError *error = NULL;
  QnFileWriter *out = qn_file_writer_open (path, &error);
  if (out == NULL)
    return qn_cli_fail (error);
  qn_file_writer_json (
    out,
    "{\n  \"format\": \"quoin-capacity\", \"version\": 1,\n  \"generator\": %s,\n"
    "  \"model\": %s,\n  \"control_block\": %s,\n  \"participating_blocks\": %zu,\n"
    "  \"moving_mass\": %f,\n  \"participating_mass\": %f,\n  \"mass_share\": %f,\n"
    "  \"mass_left_out\": %f,\n  \"displacement_ratio\": %f,\n"
    "  \"peak_multiplier\": %f,\n  \"end_displacement\": %f,\n  \"reaches_zero\": %i",
    "quoin " QN_VERSION, answer->input->project.name,
    answer->input->project.model.blocks[c->block].name, c->participating, c->moving_mass,
    c->mass, c->share, c->left_out, c->ratio, c->points[c->peak].multiplier, c->end,
    c->reaches_zero);
  if (answer->answer.has_spectrum) {
    qn_file_writer_json (
      out,
      ",\n  \"confidence\": %g,\n  \"en_demand\": { \"yield_acceleration\": %f, "
      "\"mechanism_displacement\": %f, \"energy\": %f, \"yield_displacement\": %f, "
      "\"period\": %f, \"elastic_demand\": %f, \"q\": %f, \"target\": %f },\n"
      "  \"checks\": [",
      answer->answer.confidence, en->yield_acceleration, en->mechanism, en->energy,
      en->yield, en->period, en->elastic, en->q, en->target);
    for (int i = 0; i < QN_CAPACITY_STATE_COUNT; i++) {
      const QnCapacityState *s = &answer->answer.states[i];
      qn_file_writer_json (
        out,
        ",\n    { \"code\": %s, \"state\": %s, \"capacity\": %f, \"acceleration\": %f, "
        "\"period\": %f, \"period_half_stiffness\": %f, \"demand\": %f, \"ratio\": "
        "%f, \"met\": ",
        i < QN_CAPACITY_SD ? "NTC 2018" : "EN 1998-3",
        qn_capacity_check_name ((QnCapacityCheck) i), s->capacity, s->acceleration,
        s->period, s->softer, s->demand, s->ratio);
      qn_file_writer_puts (out, s->refused      ? "null }"
                                : s->ratio >= 1 ? "true }"
                                                : "false }");
    }
    qn_file_writer_puts (out, "\n  ]");
  }
  qn_file_writer_puts (out, ",\n  \"curve\": [");
  for (size_t i = 0; i < c->count; i++) {
    const QnCapacityPoint *p = &c->points[i];
    qn_file_writer_json (out,
                         ",\n    { \"multiplier\": %f, \"control\": %f, "
                         "\"displacement\": %f, \"acceleration\": %f }",
                         p->multiplier, p->control, p->displacement, p->acceleration);
  }
  qn_file_writer_puts (out, "\n  ]\n}\n");
  qn_file_writer_commit (out, &error);
  return qn_cli_end (error);
}

static QnExit
draw_capacity (const Answer *answer, const CapacityOptions *options,
               const QnOutput *output)
{
  const QnProject *project = &answer->input->project;
  QnMetadata metadata;
  GError *error = NULL;
  qn_picture_metadata (project, &metadata);
  g_autoptr (QnPlot) plot = qn_capacity_answer_plot (&answer->answer);
  plot->title = project->model.title;
  plot->monochrome = options->picture.monochrome;
  qn_plot_export (plot, options->picture.path, output, &metadata, &error);
  return qn_cli_end (error);
}

static QnExit
report (const CapacityOptions *options, const QnOutput *output, const Answer *answer)
{
  QnExit code = QN_EXIT_DONE;
  GError *error = NULL;
  gboolean to_stdout = g_strcmp0 (options->json, "-") == 0
                       || g_strcmp0 (options->csv, "-") == 0
                       || g_strcmp0 (options->picture.path, "-") == 0;
  if (options->json != NULL)
    code = write_json (answer, options->json);
  if (code == QN_EXIT_DONE && options->csv != NULL) {
    qn_capacity_answer_write_csv (&answer->answer, options->csv, &error);
    code = qn_cli_end (error);
  }
  if (code == QN_EXIT_DONE && options->picture.path != NULL)
    code = draw_capacity (answer, options, output);
  if (code == QN_EXIT_DONE && !options->quiet && !to_stdout)
    print (answer);
  return code;
}

static QnExit
run_capacity (const QnSubcommand *self, int argc, char **argv)
{
  CapacityOptions options = { .damping = NOT_GIVEN, .confidence = NOT_GIVEN };
  GError *error = NULL;
  const GOptionEntry entries[] = {
    { "spectrum", 0, 0, G_OPTION_ARG_FILENAME, &options.spectrum,
      N_ ("Elastic spectrum of EN 1998-1, or a table of period and acceleration; without "
          "one the curve alone"),
      N_ ("type1|type2|FILE.csv") },
    { "ag", 0, 0, G_OPTION_ARG_STRING, &options.ag,
      N_ ("Ground acceleration of type1 and type2, m/s2 or g"), N_ ("2.45|0.25g") },
    { "soil", 0, 0, G_OPTION_ARG_STRING, &options.soil,
      N_ ("Ground type of type1 and type2"), N_ ("A|B|C|D|E") },
    { "damping", 0, 0, G_OPTION_ARG_DOUBLE, &options.damping,
      N_ ("Damping ratio of the spectrum (0.05)"), N_ ("RATIO") },
    { "unit", 0, 0, G_OPTION_ARG_STRING, &options.unit,
      N_ ("Unit of accelerations where the table does not state it"),
      N_ ("g|m/s2|cm/s2") },
    { "confidence", 0, 0, G_OPTION_ARG_DOUBLE, &options.confidence,
      N_ ("Confidence factor FC of NTC 2018 (1)"), N_ ("FC") },
    { "control", 0, 0, G_OPTION_ARG_STRING, &options.control,
      N_ ("Block whose horizontal displacement is controlled; by default that of the "
          "project, or the one that limit analysis moves furthest"),
      N_ ("BLOCK") },
    { "json", 0, 0, G_OPTION_ARG_FILENAME, &options.json,
      N_ ("Write curve and checks here; - is standard output"), N_ ("OUT.json") },
    { "csv", 0, 0, G_OPTION_ARG_FILENAME, &options.csv,
      N_ ("Write the curve here; - is standard output"), N_ ("OUT.csv") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    QN_INPUT_ENTRIES (options.input),
    QN_INPUT_QUIET_ENTRY (&options.quiet),
    G_OPTION_ENTRY_NULL,
  };
  QnInput input = { 0 };
  QnOutput output;
  Answer answer = { .input = &input };
  QnExit code = QN_EXIT_USAGE;

  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = options.picture.path != NULL
             ? qn_picture_output (self, &options.picture, &output)
             : QN_EXIT_DONE;
  if (code == QN_EXIT_DONE)
    code = qn_input_load (&input, argv[1], &options.input);
  if (code == QN_EXIT_DONE && !take_kept (&options, &input.project, &error))
    code = qn_cli_fail (error);
  if (code == QN_EXIT_DONE)
    code = parse_spectrum (self, &options, &answer);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  if (code == QN_EXIT_DONE)
    code = find (&input, &options, &answer);
  if (code == QN_EXIT_DONE) {
    qn_capacity_answer_check (&answer.answer);
    code = report (&options, &output, &answer);
  }

  qn_capacity_clear (&answer.answer.capacity);
  g_free (answer.reason);
  qn_record_clear (&answer.points);
  qn_input_clear (&input);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_capacity = {
  .name = "capacity",
  .arguments = "MODEL",
  .summary = N_ ("Capacity curve, and displacement checks of EN 1998-3 and NTC 2018"),
  .help =
    N_ ("The live load is weight times a horizontal direction. The path in large "
        "displacements is followed until its multiplier is zero again, and turned into "
        "the curve of a single mass. The page on capacity curves in the manual has every "
        "formula, and says what the checks do not cover."),
  .run = run_capacity,
};
