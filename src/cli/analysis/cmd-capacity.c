#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/path/analysis.h"
#include "io/exchange/record.h"
#include "io/text/file-writer.h"
#include "render/figure/capacity-plot.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* What "g" is in --ag, m/s2. */
#define STANDARD_GRAVITY 9.80665

/* First step of the control over its target, where both are chosen here: the path rises while joints
 * still deform little. */
#define INCREMENTS 2000

/* Share of mass below which a word is due. */
#define SMALL_SHARE 0.5

/* The checks of both codes, in the order of the tables. */
enum { SLV, SLC, SD, NC, STATE_COUNT };

typedef struct Options {
  QnPictureOptions picture;
  char *json, *csv, *spectrum, *ag, *soil, *unit, *control;
  char **overrides;
  double damping, confidence;
  gboolean quiet;
} Options;

typedef struct Answer {
  const QnInput *input;
  QnCapacity capacity;
  QnRecord points; /* of a spectrum from a file */
  QnSpectrum spectrum;
  gboolean has_spectrum;
  double confidence;
  QnEnDemand en;
  QnCapacityState states[STATE_COUNT];
} Answer;

static const char *const state_names[STATE_COUNT] = { "SLV", "SLC", "SD", "NC" };

static const char *
code_name (int state)
{
  return state < SD ? "NTC 2018, Circolare 7/2019 C8.7.1.2" : "EN 1998-3";
}

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
  return isfinite (value) && value > 0 ? value : 0;
}

static QnExit
parse_code_spectrum (const QnSubcommand *self, const Options *options, Answer *answer)
{
  QnSpectrum *s = &answer->spectrum;
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

static QnExit
parse_spectrum (const QnSubcommand *self, const Options *options, Answer *answer)
{
  GError *error = NULL;
  if (!(options->confidence >= 1) || !isfinite (options->confidence))
    return qn_cli_usage_error (self->name, _ ("--confidence is a factor of 1 or more"));
  if (!(options->damping > 0 && options->damping < 1))
    return qn_cli_usage_error (self->name, _ ("--damping is a ratio between 0 and 1"));
  answer->confidence = options->confidence;
  answer->has_spectrum = options->spectrum != NULL;
  if (!answer->has_spectrum) {
    if (options->ag == NULL && options->soil == NULL && options->unit == NULL)
      return QN_EXIT_DONE;
    return qn_cli_usage_error (self->name, _ ("--spectrum is missing"));
  }
  if (strcmp (options->spectrum, "type1") == 0
      || strcmp (options->spectrum, "type2") == 0)
    return parse_code_spectrum (self, options, answer);
  if (options->ag != NULL || options->soil != NULL)
    return qn_cli_usage_error (
      self->name, _ ("--ag and --soil belong to the spectra type1 and type2"));
  if (!qn_record_read (options->spectrum, options->unit, 0, &answer->points, &error))
    return qn_cli_fail (error);
  answer->spectrum = (QnSpectrum){ .kind = QN_SPECTRUM_POINTS,
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

/* Runs an analysis; QN_EXIT_DONE where it gave a result to go on with. */
static QnExit
analyse (const QnInput *input, gboolean quiet, QnResult *result)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  GError *error = NULL;
  qn_terminal_progress_init (&progress, quiet);
  QnStatus status =
    qn_analysis_run (&input->project.model, &input->contacts, qn_terminal_progress_update,
                     &progress, result, &diag);
  qn_terminal_progress_done (&progress);
  if (status == QN_ERROR_CANCELLED
      || (status == QN_OK && result->outcome == QN_OUTCOME_CANCELLED)) {
    qn_cli_error (_ ("%s: cancelled"), input->project.name);
    return QN_EXIT_CANCELLED;
  }
  if (status == QN_OK)
    return QN_EXIT_DONE;
  qn_project_set_error (&input->project, &diag, &error);
  return qn_cli_fail (error);
}

/* Height from the lowest to the highest vertex, m. */
static double
height_of (const QnModel *model)
{
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < model->vertex_count; i++) {
    low = MIN (low, model->vertices[i].y);
    high = MAX (high, model->vertices[i].y);
  }
  return high - low;
}

/* Controls the block that moves furthest along the load in the mechanism of limit analysis. */
static QnExit
choose_control (QnInput *input, gboolean quiet)
{
  QnModel *model = &input->project.model;
  QnResult result;
  model->analysis.procedure = QN_PROCEDURE_LIMIT;
  QnExit code = analyse (input, quiet, &result);
  if (code != QN_EXIT_DONE)
    return code;
  double farthest = 0;
  for (gsize b = 0; result.mechanism != NULL && b < model->block_count; b++) {
    double ux = result.mechanism[QN_DOF_COUNT * b + QN_DOF_UX];
    if (fabs (ux) <= fabs (farthest))
      continue;
    farthest = ux;
    model->analysis.control_block = (QnId) b;
  }
  qn_result_clear (&result);
  if (farthest != 0) {
    model->analysis.control_target = copysign (height_of (model), farthest);
    return QN_EXIT_DONE;
  }
  qn_cli_error (_ ("%s: limit analysis found no mechanism: name a block by --control"),
                input->project.name);
  return QN_EXIT_NO_ANSWER;
}

/* The block of --control, moved along the live load by the height of the structure. */
static QnExit
set_control (QnInput *input, const char *name)
{
  QnModel *model = &input->project.model;
  QnId block = qn_model_find_block (model, name);
  double direction = 0;
  if (block == QN_NONE) {
    qn_cli_error (_ ("%s: --control: no block has the name %s"), input->project.name,
                  name);
    return QN_EXIT_INVALID;
  }
  for (gsize i = 0; i < model->live_load_count; i++)
    direction += model->live_loads[i].vector.x;
  model->analysis.control_block = block;
  model->analysis.control_target = copysign (height_of (model), direction);
  return QN_EXIT_DONE;
}

/* The path in large displacements until the multiplier is zero again. */
static QnExit
follow (QnInput *input, const Options *options, QnResult *result)
{
  QnAnalysisSettings *analysis = &input->project.model.analysis;
  QnExit code = QN_EXIT_DONE;
  if (input->project.model.stage_count > 0) {
    qn_cli_error (_ ("%s: a capacity curve has one live load: no stages"),
                  input->project.name);
    return QN_EXIT_INVALID;
  }
  if (options->control != NULL)
    code = set_control (input, options->control);
  else if (analysis->procedure != QN_PROCEDURE_DISPLACEMENT
           || analysis->control_block == QN_NONE || analysis->control_dof != QN_DOF_UX)
    code = choose_control (input, options->quiet);
  if (code != QN_EXIT_DONE)
    return code;
  if (options->control != NULL || analysis->procedure != QN_PROCEDURE_DISPLACEMENT)
    analysis->increments = MAX (analysis->increments, INCREMENTS);
  analysis->control_node = QN_NONE;
  analysis->control_dof = QN_DOF_UX;
  analysis->procedure = QN_PROCEDURE_DISPLACEMENT;
  analysis->geometry = QN_GEOMETRY_NONLINEAR;
  analysis->max_multiplier = INFINITY;
  code = analyse (input, options->quiet, result);
  if (code == QN_EXIT_DONE && result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    qn_cli_error (_ ("%s: no equilibrium under the dead load"), input->project.name);
    qn_result_clear (result);
    return QN_EXIT_NO_ANSWER;
  }
  return code;
}

static void
check (Answer *answer)
{
  const QnCapacity *c = &answer->capacity;
  for (int i = 0; i < QN_NTC_STATE_COUNT; i++)
    answer->states[SLV + i] =
      qn_capacity_check_ntc (c, &answer->spectrum, answer->confidence, (QnNtcState) i);
  answer->en = qn_capacity_en_demand (c, &answer->spectrum);
  for (int i = 0; i < QN_EN_STATE_COUNT; i++)
    answer->states[SD + i] = qn_capacity_check_en (c, &answer->en, (QnEnState) i);
}

/* --- What comes out ---------------------------------------------------------------------- */

static void
print (const Answer *answer)
{
  const QnCapacity *c = &answer->capacity;
  const QnModel *model = &answer->input->project.model;
  const QnCapacityPoint *peak = &c->points[c->peak];
  printf (_ ("%s: controlled by ux of block %s\n"),
          model->title != NULL ? model->title : answer->input->project.name,
          model->blocks[c->block].name);
  printf (
    _ ("%zu of %zu blocks take part, %.6g kg; participating mass M* %.6g kg, e* %.4f\n"),
    c->participating, model->block_count, c->moving_mass, c->mass, c->share);
  printf (_ ("peak: multiplier %.5f at %.4g m; d* %.4g m, a* %.4g m/s2\n"),
          peak->multiplier, peak->control, peak->displacement, peak->acceleration);
  if (c->reaches_zero)
    printf (_ ("multiplier back at zero: d0* %.4g m\n"), c->end);
  else
    printf (_ ("the path ends at d* %.4g m, multiplier %.5f, before zero: its end stands "
               "for d0*\n"),
            c->end, c->points[c->count - 1].multiplier);
  if (c->share < SMALL_SHARE)
    printf (
      _ ("e* is small: the blocks move very differently, and a* of the codes is %.1f "
         "times what virtual work gives, multiplier times g\n"),
      1 / c->share);
  if (!answer->has_spectrum)
    return;
  printf ("%-36s %5s %12s %12s %10s %12s %10s\n", _ ("code"), _ ("state"),
          _ ("capacity [m]"), _ ("a* [m/s2]"), _ ("T [s]"), _ ("demand [m]"),
          _ ("ratio"));
  for (int i = 0; i < STATE_COUNT; i++) {
    const QnCapacityState *s = &answer->states[i];
    printf ("%-36s %5s %12.5g %12.5g %10.4g %12.5g %10.3f\n", code_name (i),
            state_names[i], s->capacity, s->acceleration, s->period, s->demand, s->ratio);
  }
  printf (_ ("ratio: capacity over demand; the check is met from 1 on\n"));
}

typedef struct Member {
  const char *key;
  double value;
} Member;

static void
put_members (QnFileWriter *out, const char *before, const Member *members, gsize count,
             const char *between)
{
  for (gsize i = 0; i < count; i++) {
    qn_file_writer_printf (out, "%s\"%s\"", i > 0 ? between : before, members[i].key);
    qn_file_writer_puts_number (out, ": ", members[i].value);
  }
}

static QnExit
write_json (const Answer *answer, const char *path)
{
  const QnCapacity *c = &answer->capacity;
  GError *error = NULL;
  QnFileWriter *out = qn_file_writer_open (path, &error);
  if (out == NULL)
    return qn_cli_fail (error);
  const Member facts[] = {
    { "participating_blocks", (double) c->participating },
    { "moving_mass", c->moving_mass },
    { "participating_mass", c->mass },
    { "mass_share", c->share },
    { "displacement_ratio", c->ratio },
    { "peak_multiplier", c->points[c->peak].multiplier },
    { "end_displacement", c->end },
  };
  const Member demand[] = {
    { "yield_acceleration", answer->en.yield_acceleration },
    { "mechanism_displacement", answer->en.mechanism },
    { "energy", answer->en.energy },
    { "yield_displacement", answer->en.yield },
    { "period", answer->en.period },
    { "elastic_demand", answer->en.elastic },
    { "q", answer->en.q },
    { "target", answer->en.target },
  };
  qn_file_writer_puts (out, "{\n  \"format\": \"quoin-capacity\", \"version\": 1,\n"
                            "  \"generator\": \"quoin " QN_VERSION "\",\n  \"model\": ");
  qn_file_writer_json_string (out, answer->input->project.name);
  qn_file_writer_puts (out, ",\n  \"control_block\": ");
  qn_file_writer_json_string (out, answer->input->project.model.blocks[c->block].name);
  put_members (out, ",\n  ", facts, G_N_ELEMENTS (facts), ",\n  ");
  qn_file_writer_printf (out, ",\n  \"reaches_zero\": %s",
                         c->reaches_zero ? "true" : "false");
  if (answer->has_spectrum) {
    qn_file_writer_puts_number (out, ",\n  \"confidence\": ", answer->confidence);
    qn_file_writer_puts (out, ",\n  \"en_demand\": ");
    put_members (out, "{ ", demand, G_N_ELEMENTS (demand), ", ");
    qn_file_writer_puts (out, " },\n  \"checks\": [");
    for (int i = 0; i < STATE_COUNT; i++) {
      const QnCapacityState *s = &answer->states[i];
      const Member members[] = { { "capacity", s->capacity },
                                 { "acceleration", s->acceleration },
                                 { "period", s->period },
                                 { "demand", s->demand },
                                 { "ratio", s->ratio } };
      qn_file_writer_printf (out, "%s\n    { \"code\": \"%s\", \"state\": \"%s\"",
                             i > 0 ? "," : "", i < SD ? "NTC 2018" : "EN 1998-3",
                             state_names[i]);
      put_members (out, ", ", members, G_N_ELEMENTS (members), ", ");
      qn_file_writer_puts (out, " }");
    }
    qn_file_writer_puts (out, "\n  ]");
  }
  qn_file_writer_puts (out, ",\n  \"curve\": [");
  for (size_t i = 0; i < c->count; i++) {
    const QnCapacityPoint *p = &c->points[i];
    const Member members[] = { { "multiplier", p->multiplier },
                               { "control", p->control },
                               { "displacement", p->displacement },
                               { "acceleration", p->acceleration } };
    qn_file_writer_puts (out, i > 0 ? "," : "");
    put_members (out, "\n    { ", members, G_N_ELEMENTS (members), ", ");
    qn_file_writer_puts (out, " }");
  }
  qn_file_writer_puts (out, "\n  ]\n}\n");
  return qn_file_writer_commit (out, &error) ? QN_EXIT_DONE : qn_cli_fail (error);
}

static QnExit
write_csv (const Answer *answer, const char *path)
{
  const QnCapacity *c = &answer->capacity;
  GError *error = NULL;
  QnFileWriter *out = qn_file_writer_open (path, &error);
  if (out == NULL)
    return qn_cli_fail (error);
  qn_file_writer_puts (out, "load multiplier,control displacement [m],spectral "
                            "displacement [m],spectral acceleration [m/s2]\n");
  for (size_t i = 0; i < c->count; i++) {
    const QnCapacityPoint *p = &c->points[i];
    const double row[] = { p->multiplier, p->control, p->displacement, p->acceleration };
    qn_file_writer_numbers (out, row, G_N_ELEMENTS (row), ",");
    qn_file_writer_puts (out, "\n");
  }
  return qn_file_writer_commit (out, &error) ? QN_EXIT_DONE : qn_cli_fail (error);
}

static QnExit
draw (const Answer *answer, const Options *options, const QnOutput *output)
{
  QnMetadata metadata;
  GError *error = NULL;
  QnCapacityMark marks[STATE_COUNT];
  char *labels[2 * STATE_COUNT] = { NULL };
  gsize count = answer->has_spectrum ? STATE_COUNT : 0;
  for (gsize i = 0; i < count; i++) {
    labels[2 * i] = g_strdup_printf (_ ("%s: capacity"), state_names[i]);
    labels[2 * i + 1] = g_strdup_printf (_ ("%s: demand"), state_names[i]);
    marks[i] = (QnCapacityMark){ labels[2 * i], labels[2 * i + 1], answer->states[i] };
  }
  QnCapacityPlot plot = { .title = answer->input->project.model.title,
                          .x_label = _ ("Spectral displacement [m]"),
                          .y_label = _ ("Spectral acceleration [m/s²]"),
                          .curve_label = _ ("capacity curve"),
                          .spectrum_label = _ ("elastic spectrum"),
                          .capacity = &answer->capacity,
                          .spectrum = answer->has_spectrum ? &answer->spectrum : NULL,
                          .marks = marks,
                          .mark_count = count,
                          .monochrome = options->picture.monochrome };
  qn_picture_metadata (&answer->input->project, &metadata);
  gboolean ok =
    qn_capacity_plot_export (&plot, options->picture.path, output, &metadata, &error);
  for (gsize i = 0; i < G_N_ELEMENTS (labels); i++)
    g_free (labels[i]);
  return ok ? QN_EXIT_DONE : qn_cli_fail (error);
}

static QnExit
report (const Options *options, const QnOutput *output, const Answer *answer)
{
  QnExit code = QN_EXIT_DONE;
  gboolean to_stdout = g_strcmp0 (options->json, "-") == 0
                       || g_strcmp0 (options->csv, "-") == 0
                       || g_strcmp0 (options->picture.path, "-") == 0;
  if (options->json != NULL)
    code = write_json (answer, options->json);
  if (code == QN_EXIT_DONE && options->csv != NULL)
    code = write_csv (answer, options->csv);
  if (code == QN_EXIT_DONE && options->picture.path != NULL)
    code = draw (answer, options, output);
  if (code == QN_EXIT_DONE && !options->quiet && !to_stdout)
    print (answer);
  return code;
}

static QnExit
compute (QnInput *input, const Options *options, const QnOutput *output, Answer *answer)
{
  QnResult result = { 0 };
  QnDiag diag = { 0 };
  GError *error = NULL;
  qn_interrupt_install ();
  answer->input = input;
  QnExit code = follow (input, options, &result);
  if (code != QN_EXIT_DONE)
    return code;
  if (qn_capacity_init (&answer->capacity, &input->project.model, &result,
                        input->project.model.analysis.control_block, &diag)
      != QN_OK) {
    qn_project_set_error (&input->project, &diag, &error);
    code = qn_cli_fail (error);
  } else {
    if (answer->has_spectrum)
      check (answer);
    code = report (options, output, answer);
    qn_capacity_clear (&answer->capacity);
  }
  qn_result_clear (&result);
  return code;
}

static QnExit
run (const QnSubcommand *self, int argc, char **argv)
{
  Options options = { .damping = 0.05, .confidence = 1 };
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
      N_ ("Unit of accelerations where the table does not say it"), N_ ("g|m/s2|cm/s2") },
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
    QN_INPUT_SET_ENTRY (&options.overrides),
    QN_INPUT_QUIET_ENTRY (&options.quiet),
    G_OPTION_ENTRY_NULL,
  };
  QnInput input;
  QnOutput output;
  Answer answer = { 0 };
  QnExit code = QN_EXIT_USAGE;

  memset (&input, 0, sizeof input);
  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = parse_spectrum (self, &options, &answer);
  if (code == QN_EXIT_DONE && options.picture.path != NULL)
    code = qn_picture_output (self, &options.picture, &output);
  if (code == QN_EXIT_DONE)
    code = qn_input_load (&input, argv[1], options.overrides, options.quiet);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  if (code == QN_EXIT_DONE)
    code = compute (&input, &options, &output, &answer);

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
        "the curve of a single mass. docs/method/capacity.md has every formula, and says "
        "what the checks do not cover."),
  .run = run,
};
