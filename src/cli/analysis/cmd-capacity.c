#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n.h>

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
  QnInput *input;
  QnRecord points; /* of a spectrum from a file */
  QnCapacityAnswer answer;
} Answer;

/* What the project keeps, and what options say instead. */
static void
take_settings (const CapacityOptions *options, const GOptionEntry *entries,
               Answer *answer)
{
  const QnProject *project = &answer->input->project;
  QnCapacitySettings *s = qn_cli_keep (g_new0 (QnCapacitySettings, 1));
  gboolean done = TRUE;
  qn_cli_must (qn_capacity_settings_read (project, s, QN_TROUBLE));
  s->mechanism |= options->mechanism;
  for (int i = 0; done && i < SETTINGS; i++)
    done = options->given[i] == NULL
           || qn_capacity_settings_set (s, entries[i].long_name, options->given[i],
                                        QN_TROUBLE);
  if (done && !s->mechanism
      && (options->given[TIE_STRAIN] != NULL || options->given[PART_PERIOD] != NULL))
    qn_cli_usage_error (_ ("--tie-strain and --part-period belong to --mechanism"));
  done = done
         && qn_capacity_settings_apply (s, project, options->input.allow_outside,
                                        &answer->answer, &answer->points, QN_TROUBLE);
  if (g_error_matches (qn_cli_trouble, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE))
    qn_cli_usage_error ("--%s", qn_cli_trouble->message);
  qn_cli_must (done);
}

/* --- The path ---------------------------------------------------------------------------- */

static void
find (const CapacityOptions *options, Answer *answer)
{
  QnTerminalProgress progress;
  QnDiag diag = { 0 };
  QnInput *input = answer->input;
  qn_terminal_progress_begin (&progress, options->quiet);
  QnStatus status =
    qn_capacity_answer_find (&answer->answer, &input->project.model, &input->contacts,
                             qn_terminal_progress_update, &progress, &diag);
  qn_terminal_progress_done (&progress);
  if (status == QN_ERROR_CANCELLED)
    qn_cli_cancelled (input->project.name);
  if (status != QN_OK)
    qn_input_refuse (&input->project, &diag);
  if (answer->answer.capacity.count == 0)
    qn_cli_fail (QN_EXIT_NO_ANSWER, "%s: %s", input->project.name, answer->answer.reason);
}

/* --- Output ---------------------------------------------------------------------- */

static void
print (const Answer *answer)
{
  const QnModel *model = &answer->input->project.model;
  const int states = qn_capacity_answer_count_states (&answer->answer);
  g_autofree char *facts = qn_capacity_answer_dup_facts (&answer->answer, QN_UNITS_SI);
  qn_print ("%s\n", model->title != NULL ? model->title : answer->input->project.name);
  qn_print_text (facts);
  qn_print ("\n");
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

static void
report (const CapacityOptions *options, const Answer *answer)
{
  const QnCapacityAnswer *capacity = &answer->answer;
  const QnProject *project = &answer->input->project;
  if (options->json != NULL) {
    gsize length;
    g_autofree char *text = qn_capacity_answer_dup_json (capacity, project, &length);
    qn_cli_must (qn_file_write (options->json, text, length, QN_TROUBLE));
  }
  qn_cli_must (options->csv == NULL
               || qn_capacity_answer_write_csv (capacity, options->csv, QN_TROUBLE));
  if (options->picture.path != NULL) {
    g_autoptr (QnPlot) plot = qn_capacity_answer_plot (capacity);
    qn_picture_plot (&options->picture, plot, project->model.title, project);
  }
  if (!options->quiet && g_strcmp0 (options->json, "-") != 0
      && g_strcmp0 (options->csv, "-") != 0
      && g_strcmp0 (options->picture.path, "-") != 0)
    print (answer);
}

static void
run_capacity (const QnSubcommand *self, int argc, char **argv)
{
  CapacityOptions options = { 0 };
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
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  qn_picture_if_any (&options.picture);
  if (options.result != NULL && !options.mechanism)
    qn_cli_usage_error (_ ("--result belongs to --mechanism"));
  if (options
        .mechanism) /* as if the project said it: its numbers of mechanisms count then */
    qn_input_override (&options.input, "capacity.mechanism=true", FALSE);
  Answer *answer = qn_cli_keep (g_new0 (Answer, 1));
  answer->input = options.result != NULL
                    ? qn_input_load_with_result (argv[1], options.result, &options.input)
                    : qn_input_load (argv[1], &options.input);
  if (options.result != NULL)
    answer->answer.collapse = &answer->input->file.result;
  take_settings (&options, entries, answer);
  qn_input_require_sound (answer->input);
  find (&options, answer);
  qn_capacity_answer_check (&answer->answer);
  report (&options, answer);
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
