#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "doc/view/sheet.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n.h>
#include <stdio.h>
#include <string.h>

enum { TIE_STRAIN = 7, PART_PERIOD, SETTINGS = 14 };

typedef struct CapacityOptions {
  QnPictureOptions picture;
  char *given[SETTINGS]; /* values of the first options, which are settings */
  char *json, *csv, *result;
  gboolean mechanism;
  QnInputOptions input;
  gboolean quiet;
} CapacityOptions;

typedef struct Answer {
  const QnInput *input;
  QnResultFile file; /* of --result */
  QnRecord points;   /* of a spectrum from a file */
  QnCapacityAnswer answer;
  char *reason; /* why the path ended before multiplier 0, or NULL */
} Answer;

/* What the project keeps, and what options say instead. */
static QnExit
take_settings (const QnSubcommand *self, const CapacityOptions *options,
               const GOptionEntry *entries, QnCapacitySettings *s, Answer *answer)
{
  g_autoptr (GError) error = NULL;
  const QnProject *project = &answer->input->project;
  gboolean done = TRUE;
  if (!qn_capacity_settings_read (project, s, &error))
    return qn_cli_fail (error);
  s->mechanism |= options->mechanism;
  for (int i = 0; done && i < SETTINGS; i++)
    done =
      options->given[i] == NULL
      || qn_capacity_settings_set (s, entries[i].long_name, options->given[i], &error);
  if (done && !s->mechanism
      && (options->given[TIE_STRAIN] != NULL || options->given[PART_PERIOD] != NULL))
    return qn_cli_usage_error (
      self->name, _ ("--tie-strain and --part-period belong to --mechanism"));
  done = done
         && qn_capacity_settings_apply (s, project, options->input.allow_outside,
                                        &answer->answer, &answer->points, &error);
  if (done)
    return QN_EXIT_DONE;
  if (g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE))
    return qn_cli_usage_error (self->name, "--%s", error->message);
  return qn_cli_fail (g_steal_pointer (&error));
}

/* --- The path ---------------------------------------------------------------------------- */

static QnExit
find (QnInput *input, const CapacityOptions *options, Answer *answer)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  QnModel *model = &input->project.model;
  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, options->quiet);
  QnCapacityEnd end = qn_capacity_answer_find (&answer->answer, model, &input->contacts,
                                               qn_terminal_progress_update, &progress,
                                               &answer->reason, &diag);
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
  const QnModel *model = &answer->input->project.model;
  const int states = qn_capacity_answer_count_states (&answer->answer);
  g_autofree char *facts = qn_capacity_answer_dup_facts (
    &answer->answer, model->blocks[answer->answer.capacity.block].name, answer->reason,
    QN_UNITS_SI);
  qn_print ("%s\n", model->title != NULL ? model->title : answer->input->project.name);
  fputs (facts, stdout);
  fputc ('\n', stdout);
  if (states == 0)
    return;
  g_autoptr (GPtrArray) cells =
    qn_capacity_answer_make_table (&answer->answer, QN_UNITS_SI);
  for (guint i = 0; i < cells->len; i++) {
    const char *cell = cells->pdata[i];
    if (i % QN_CAPACITY_COLUMNS == QN_CAPACITY_COLUMNS - 1)
      qn_print ("%s\n", cell);
    else
      qn_print ("%s%*s", cell, (int) MAX (14 - g_utf8_strlen (cell, -1), 1), "");
  }
  qn_print (_ ("ratio: capacity over demand; the check is met from 1 on\n"));
  for (int i = 0; i < states && !answer->answer.capacity.kinematic; i++) {
    g_autofree char *rests =
      qn_capacity_dup_basis (&answer->answer.states[i], (QnCapacityCheck) i);
    qn_print ("%s\n", rests);
  }
}

static QnExit
write_json (const Answer *answer, const char *path)
{
  GError *error = NULL;
  gsize length;
  g_autofree char *text =
    qn_capacity_answer_dup_json (&answer->answer, &answer->input->project, &length);
  qn_file_write (path, text, length, &error);
  return qn_cli_end (error);
}

static QnExit
draw_capacity (const Answer *answer, const CapacityOptions *options,
               const QnOutput *output)
{
  const QnProject *project = &answer->input->project;
  QnMetadata metadata;
  GError *error = NULL;
  qn_project_get_metadata (project, &metadata);
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

/* --mechanism is as if the project said it: its numbers of mechanisms count then. */
static void
ask_for_mechanism (CapacityOptions *options)
{
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();
  char **given = options->input.overrides;
  if (given != NULL)
    g_strv_builder_addv (builder, (const char **) given);
  g_strv_builder_add (builder, "capacity.mechanism=true");
  options->input.overrides = g_strv_builder_end (builder);
  g_strfreev (given);
}

static QnExit
run_capacity (const QnSubcommand *self, int argc, char **argv)
{
  CapacityOptions options = { 0 };
  QnCapacitySettings settings = { 0 };
  const GOptionEntry entries[] = {
    { "spectrum", 0, 0, G_OPTION_ARG_FILENAME, &options.given[0],
      N_ ("Elastic spectrum of EN 1998-1, or a table of period and acceleration; without "
          "one the curve alone"),
      N_ ("type1|type2|FILE.csv") },
    { "ag", 0, 0, G_OPTION_ARG_STRING, &options.given[1],
      N_ ("Ground acceleration of type1 and type2, m/s2 or g"), N_ ("2.45|0.25g") },
    { "soil", 0, 0, G_OPTION_ARG_STRING, &options.given[2],
      N_ ("Ground type of type1 and type2"), N_ ("A|B|C|D|E") },
    { "damping", 0, 0, G_OPTION_ARG_STRING, &options.given[3],
      N_ ("Damping ratio of the spectrum (0.05)"), N_ ("RATIO") },
    { "unit", 0, 0, G_OPTION_ARG_STRING, &options.given[4],
      N_ ("Unit of accelerations where the table does not state it"),
      N_ ("g|m/s2|cm/s2") },
    { "confidence", 0, 0, G_OPTION_ARG_STRING, &options.given[5],
      N_ ("Confidence factor FC of NTC 2018 (1)"), N_ ("FC") },
    { "control", 0, 0, G_OPTION_ARG_STRING, &options.given[6],
      N_ ("Block whose horizontal displacement is controlled; by default that of the "
          "project, or the one that limit analysis moves furthest"),
      N_ ("BLOCK") },
    { "tie-strain", 0, 0, G_OPTION_ARG_STRING, &options.given[TIE_STRAIN],
      N_ ("Strain at which ties break: they are in the kinematic curve until then"),
      N_ ("RATIO") },
    { "part-period", 0, 0, G_OPTION_ARG_STRING, &options.given[PART_PERIOD],
      N_ ("Period T0 of a part that vibrates freely, for the linear check (0)"),
      N_ ("S") },
    { "height", 0, 0, G_OPTION_ARG_STRING, &options.given[9],
      N_ ("Height z of the part above the foundation: the spectrum is that of the floor"),
      N_ ("M") },
    { "building-height", 0, 0, G_OPTION_ARG_STRING, &options.given[10],
      N_ ("Height H of the building"), N_ ("M") },
    { "storeys", 0, 0, G_OPTION_ARG_STRING, &options.given[11],
      N_ ("Storeys n of the building"), N_ ("N") },
    { "building-period", 0, 0, G_OPTION_ARG_STRING, &options.given[12],
      N_ ("Period T1 of the building"), N_ ("S") },
    { "building-damping", 0, 0, G_OPTION_ARG_STRING, &options.given[13],
      N_ ("Damping ratio of the building (0.05)"), N_ ("RATIO") },
    { "mechanism", 0, 0, G_OPTION_ARG_NONE, &options.mechanism,
      N_ ("Kinematic curve of the mechanism, instead of the path: of limit analysis, or "
          "of --result"),
      NULL },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Result whose mechanism is checked; with --mechanism"), N_ ("RESULT.json") },
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
  if (code == QN_EXIT_DONE && options.result != NULL && !options.mechanism)
    code = qn_cli_usage_error (self->name, _ ("--result belongs to --mechanism"));
  if (code == QN_EXIT_DONE && options.mechanism)
    ask_for_mechanism (&options);
  if (code == QN_EXIT_DONE)
    code = options.result != NULL ? qn_input_load_with_result (
             &input, &answer.file, argv[1], options.result, &options.input)
                                  : qn_input_load (&input, argv[1], &options.input);
  if (code == QN_EXIT_DONE && options.result != NULL)
    answer.answer.collapse = &answer.file.result;
  if (code == QN_EXIT_DONE)
    code = take_settings (self, &options, entries, &settings, &answer);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  if (code == QN_EXIT_DONE)
    code = find (&input, &options, &answer);
  if (code == QN_EXIT_DONE) {
    qn_capacity_answer_check (&answer.answer);
    code = report (&options, &output, &answer);
  }

  qn_capacity_settings_clear (&settings);
  qn_capacity_clear (&answer.answer.capacity);
  g_free (answer.reason);
  qn_result_file_clear (&answer.file);
  qn_record_clear (&answer.points);
  qn_input_clear (&input);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_capacity = {
  .name = "capacity",
  .arguments = "MODEL",
  .summary = N_ ("Capacity curve, and checks of EN 1998-3 and NTC 2018"),
  .help = N_ (
    "The live load is weight times a horizontal direction. The path in large "
    "displacements is followed until its multiplier is zero again, and turned into "
    "the curve of a single mass; with --mechanism that of the parts of a mechanism, by "
    "virtual work. The page on capacity curves in the manual has every formula, and "
    "says what the checks do not cover."),
  .run = run_capacity,
};
