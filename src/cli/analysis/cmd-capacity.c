#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "doc/view/capacity-answer.h"
#include "doc/view/capacity-settings.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n.h>

enum { TIE_STRAIN = 7, PART_PERIOD, SETTINGS = 14 };

static char
  *capacity_given[SETTINGS]; /* values of the first options, which are settings */
static char *capacity_json, *capacity_csv, *capacity_result;
static gboolean capacity_mechanism;

static const GOptionEntry capacity_entries[] = {
  { "spectrum", 0, 0, G_OPTION_ARG_FILENAME, &capacity_given[0],
    N_ ("Elastic spectrum of EN 1998-1, or a table of period and acceleration; without "
        "one the curve alone"),
    N_ ("type1|type2|FILE.csv") },
  { "ag", 0, 0, G_OPTION_ARG_STRING, &capacity_given[1],
    N_ ("Ground acceleration of type1 and type2, m/s2 or g"), N_ ("2.45|0.25g") },
  { "soil", 0, 0, G_OPTION_ARG_STRING, &capacity_given[2],
    N_ ("Ground type of type1 and type2"), N_ ("A|B|C|D|E") },
  { "damping", 0, 0, G_OPTION_ARG_STRING, &capacity_given[3],
    N_ ("Damping ratio of the spectrum (0.05)"), N_ ("RATIO") },
  { "unit", 0, 0, G_OPTION_ARG_STRING, &capacity_given[4],
    N_ ("Unit of accelerations where the table does not state it"), N_ ("g|m/s2|cm/s2") },
  { "confidence", 0, 0, G_OPTION_ARG_STRING, &capacity_given[5],
    N_ ("Confidence factor FC of NTC 2018 (1)"), N_ ("FC") },
  { "control", 0, 0, G_OPTION_ARG_STRING, &capacity_given[6],
    N_ ("Block whose horizontal displacement is controlled; by default that of the "
        "project, or the one that limit analysis moves furthest"),
    N_ ("BLOCK") },
  { "tie-strain", 0, 0, G_OPTION_ARG_STRING, &capacity_given[TIE_STRAIN],
    N_ ("Strain at which ties break: they are in the kinematic curve until then"),
    N_ ("RATIO") },
  { "part-period", 0, 0, G_OPTION_ARG_STRING, &capacity_given[PART_PERIOD],
    N_ ("Period T0 of a part that vibrates freely, for the linear check (0)"), N_ ("S") },
  { "height", 0, 0, G_OPTION_ARG_STRING, &capacity_given[9],
    N_ ("Height z of the part above the foundation: the spectrum is that of the floor"),
    N_ ("M") },
  { "building-height", 0, 0, G_OPTION_ARG_STRING, &capacity_given[10],
    N_ ("Height H of the building"), N_ ("M") },
  { "storeys", 0, 0, G_OPTION_ARG_STRING, &capacity_given[11],
    N_ ("Storeys n of the building"), N_ ("N") },
  { "building-period", 0, 0, G_OPTION_ARG_STRING, &capacity_given[12],
    N_ ("Period T1 of the building"), N_ ("S") },
  { "building-damping", 0, 0, G_OPTION_ARG_STRING, &capacity_given[13],
    N_ ("Damping ratio of the building (0.05)"), N_ ("RATIO") },
  { "mechanism", 0, 0, G_OPTION_ARG_NONE, &capacity_mechanism,
    N_ ("Kinematic curve of the mechanism, instead of the path: of limit analysis, or "
        "of --result"),
    NULL },
  { "result", 'r', 0, G_OPTION_ARG_FILENAME, &capacity_result,
    N_ ("Result whose mechanism is checked; with --mechanism"), N_ ("RESULT.json") },
  { "json", 0, 0, G_OPTION_ARG_FILENAME, &capacity_json,
    N_ ("Write curve and checks here; - is standard output"), N_ ("OUT.json") },
  { "csv", 0, 0, G_OPTION_ARG_FILENAME, &capacity_csv,
    N_ ("Write the curve here; - is standard output"), N_ ("OUT.csv") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf")),
  QN_INPUT_ENTRIES,
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

typedef struct Answer {
  QnInput *input;
  QnRecord points; /* of a spectrum from a file */
  QnCapacityAnswer answer;
} Answer;

/* What the project keeps, and what options say instead. */
static void
take_settings (Answer *answer)
{
  const QnProject *project = &answer->input->project;
  QnCapacitySettings *s = qn_cli_keep (g_new0 (QnCapacitySettings, 1));
  gboolean done = TRUE;
  qn_cli_must (qn_capacity_settings_read (project, s, QN_TROUBLE));
  s->mechanism |= capacity_mechanism;
  for (int i = 0; done && i < SETTINGS; i++)
    done = capacity_given[i] == NULL
           || qn_capacity_settings_set (s, capacity_entries[i].long_name,
                                        capacity_given[i], QN_TROUBLE);
  if (done && !s->mechanism
      && (capacity_given[TIE_STRAIN] != NULL || capacity_given[PART_PERIOD] != NULL))
    qn_cli_usage_error (_ ("--tie-strain and --part-period belong to --mechanism"));
  done = done
         && qn_capacity_settings_apply (s, project, qn_allow_outside, &answer->answer,
                                        &answer->points, QN_TROUBLE);
  if (g_error_matches (qn_cli_trouble, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE))
    qn_cli_usage_error ("--%s", qn_cli_trouble->message);
  qn_cli_must (done);
}

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
run_capacity (char **arguments)
{
  qn_picture_if_any ();
  if (capacity_result != NULL && !capacity_mechanism)
    qn_cli_usage_error (_ ("--result belongs to --mechanism"));
  if (capacity_mechanism) /* as if the project said so: its numbers of mechanisms count */
    qn_input_override ("capacity.mechanism=true", FALSE);
  Answer *answer = qn_cli_keep (g_new0 (Answer, 1));
  answer->input = qn_input_load_with_result (arguments[0], capacity_result);
  if (capacity_result != NULL)
    answer->answer.collapse = &answer->input->file.result;
  take_settings (answer);
  QnInput *input = answer->input;
  QnDiag diag = { 0 };
  qn_input_require_sound (input);
  qn_terminal_progress_begin ();
  QnStatus status =
    qn_capacity_answer_find (&answer->answer, &input->project.model, &input->contacts,
                             qn_terminal_progress_update, NULL, &diag);
  qn_terminal_progress_done ();
  if (status == QN_ERROR_CANCELLED)
    qn_cli_cancelled (input->project.name);
  if (status != QN_OK)
    qn_input_refuse (&input->project, &diag);
  if (answer->answer.capacity.count == 0)
    qn_cli_fail (QN_EXIT_NO_ANSWER, "%s: %s", input->project.name, answer->answer.reason);
  qn_capacity_answer_check (&answer->answer);
  const QnCapacityAnswer *capacity = &answer->answer;
  const QnProject *project = &input->project;
  if (capacity_json != NULL) {
    gsize length;
    g_autofree char *text = qn_capacity_answer_dup_json (capacity, project, &length);
    qn_cli_must (qn_file_write (capacity_json, text, length, QN_TROUBLE));
  }
  qn_cli_must (capacity_csv == NULL
               || qn_capacity_answer_write_csv (capacity, capacity_csv, QN_TROUBLE));
  if (qn_picture.path != NULL) {
    g_autoptr (QnPlot) plot = qn_capacity_answer_plot (capacity);
    qn_picture_plot (plot, project->model.title, project);
  }
  if (qn_subcommand_prints ())
    print (answer);
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
  .options = capacity_entries,
  .run = run_capacity,
};
