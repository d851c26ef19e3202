#include "cli/study/cmd-study.h"

#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "core/base/integer.h"
#include "core/base/word.h"
#include "study/cases/folder.h"
#include "study/cases/run.h"
#include "study/cases/store.h"
#include "study/cluster/slurm.h"
#include "study/report/figures.h"
#include "study/report/table.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static char *study_folder, *study_shard;
static int study_jobs;
static gboolean study_keep, study_retry, study_prepare;

/* How far a study has come, on a terminal, or in lines for a program that sets QUOIN_PROGRESS. */
typedef struct Display {
  gboolean shown, lines;
  gsize part, parts; /* this study is one of so many of as many cases */
  gint64 last_time;  /* us */
} Display;

static gboolean
update_display (const QnStudyProgress *progress, gpointer data)
{
  enum { INTERVAL = 200000 };
  Display *display = data;
  gint64 now = g_get_monotonic_time ();
  if (display->lines)
    fprintf (stderr, "progress %zu %zu %zu\n",
             display->part * progress->wanted + progress->present,
             display->parts * progress->wanted, progress->failed);
  if (display->shown && now - display->last_time >= INTERVAL) {
    display->last_time = now;
    fprintf (stderr, "\r\033[K");
    fprintf (stderr, _ ("%zu of %zu cases, %zu failed"), progress->present,
             progress->wanted, progress->failed);
    if (!isnan (progress->to_go)) {
      guint seconds = (guint) qn_to_integer (progress->to_go, 0, G_MAXINT32);
      fprintf (stderr, _ (", %u:%02u:%02u left"), seconds / 3600, seconds / 60 % 60,
               seconds % 60);
    }
    fflush (stderr);
  }
  return !qn_interrupt_seen ();
}

/* Path of this program, to be started again as a worker. By its name where it is there, so that tools that
 * follow programs (valgrind) follow it; else by the file that is open. */
static char *
dup_program (void)
{
  g_autofree char *path = g_file_read_link ("/proc/self/exe", NULL);
  if (path != NULL && g_file_test (path, G_FILE_TEST_IS_EXECUTABLE))
    return g_steal_pointer (&path);
  return g_strdup ("/proc/self/exe");
}

gboolean
qn_study_compute (const QnStudy *study, const char *folder, QnStudyRunSettings settings,
                  gsize part, gsize parts, QnStudyProgress *progress)
{
  Display display = { .shown = qn_progress_is_shown (),
                      .lines = g_getenv ("QUOIN_PROGRESS") != NULL,
                      .part = part,
                      .parts = parts };
  gboolean cancelled;
  g_autofree char *program = dup_program ();
  settings.program = program;
  settings.progress = update_display;
  settings.data = &display;
  if (settings.jobs == 0)
    settings.jobs = g_get_num_processors ();
  qn_interrupt_install ();
  gboolean ok = qn_study_run (study, folder, &settings, progress, &cancelled, QN_TROUBLE);
  if (display.last_time > 0)
    fprintf (stderr, "\r\033[K");
  qn_cli_must (ok);
  return !cancelled;
}

void
qn_study_cancelled (const char *name)
{
  qn_cli_fail (QN_EXIT_CANCELLED, _ ("%s: cancelled; the same command continues"), name);
}

static void
run_cases (char **arguments)
{
  char *path = arguments[0];
  QnStudy *study = qn_cli_keep (g_new0 (QnStudy, 1));
  QnStudyRunSettings settings = { .jobs = (guint) MAX (study_jobs, 0),
                                  .keep = study_keep,
                                  .retry = study_retry };
  /* The folder of a study stands for the study as well. */
  gboolean again = study_folder == NULL && g_file_test (path, G_FILE_TEST_IS_DIR);
  if (again)
    path = qn_cli_keep (qn_folder_dup_named (path));
  if (study_folder == NULL && !again)
    qn_cli_usage_error (_ ("-o is missing"));
  if (study_jobs < 0 || study_jobs > 1024)
    qn_cli_usage_error (_ ("--jobs is a number from 1 to 1024"));
  guint index = 1, count = 1; /* "3/10": the third of ten slices */
  char rest;
  if (study_shard != NULL
      && (sscanf (study_shard, "%u/%u%c", &index, &count, &rest) != 2 || index < 1
          || index > count || count > QN_STUDY_MAX_CASES))
    qn_cli_usage_error (_ ("--shard is k/n, the k-th of n slices, as in 3/10"));
  settings.shard = (QnShard){ index - 1, count };
  qn_cli_must (again ? qn_folder_read_study (path, study, QN_TROUBLE)
                     : qn_study_read (path, NULL, study, QN_TROUBLE));
  if (again)
    study_folder = path;
  for (guint i = 0; i < study->warnings->len; i++)
    qn_cli_warning ("%s", (char *) g_ptr_array_index (study->warnings, i));
  for (guint i = 0; i < study->project.warnings->len; i++)
    qn_cli_warning ("%s", (char *) g_ptr_array_index (study->project.warnings, i));
  if (!study_prepare) {
    QnStudyProgress progress;
    gboolean done = qn_study_compute (study, study_folder, settings, 0, 1, &progress);
    if (!qn_cli_quiet) {
      qn_print (_ ("%s: %zu of %zu cases"), study_folder, progress.present,
                progress.wanted);
      if (progress.failed > 0)
        qn_print (_ (", %zu of those computed now failed"), progress.failed);
      qn_print (_ ("; %.1f s\n"), progress.seconds);
    }
    if (!done)
      qn_study_cancelled (study_folder);
    return;
  }
  qn_cli_must (qn_folder_prepare (study_folder, study, QN_TROUBLE));
  if (!qn_cli_quiet)
    qn_print (_ ("%s: %zu cases to compute\n"), study_folder,
              qn_study_case_count (study));
}

static const GOptionEntry run_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &study_folder,
    N_ ("Folder of the results; made where there is none"), N_ ("FOLDER") },
  { "jobs", 'j', 0, G_OPTION_ARG_INT, &study_jobs,
    N_ ("Processes at once; all cores by default"), N_ ("N") },
  { "shard", 0, 0, G_OPTION_ARG_STRING, &study_shard,
    N_ ("Compute the k-th of n slices only, into a separate database"), N_ ("K/N") },
  { "keep", 0, 0, G_OPTION_ARG_NONE, &study_keep,
    N_ ("Keep the full result of every case that is computed"), NULL },
  { "retry", 0, 0, G_OPTION_ARG_NONE, &study_retry,
    N_ ("Compute cases that failed once more"), NULL },
  { "prepare", 0, 0, G_OPTION_ARG_NONE, &study_prepare,
    N_ ("Make the folder and compute nothing yet"), NULL },
  QN_QUIET_ENTRY,
  G_OPTION_ENTRY_NULL,
};

static const QnSubcommand run_action = {
  .name = "study run",
  .arguments = "STUDY|FOLDER",
  .summary = N_ ("Compute the cases of a study that have no result yet"),
  .help = N_ ("Every case is a row of FOLDER/study.db, written as it is computed: after "
              "Ctrl+C or a crash the same command continues. A case that "
              "fails is a row that says why."),
  .options = run_entries,
  .run = run_cases,
};

/* --- On a cluster --- */

static gboolean submit_slurm, submit_dry_run;
static int submit_size;
static char *submit_partition;

static const GOptionEntry submit_entries[] = {
  { "slurm", 0, 0, G_OPTION_ARG_NONE, &submit_slurm, N_ ("Submit to Slurm"), NULL },
  { "array-size", 0, 0, G_OPTION_ARG_INT, &submit_size,
    N_ ("Tasks of the array; as before, or 100"), N_ ("N") },
  { "partition", 0, 0, G_OPTION_ARG_STRING, &submit_partition,
    N_ ("Partition of the cluster"), N_ ("NAME") },
  { "dry-run", 0, 0, G_OPTION_ARG_NONE, &submit_dry_run,
    N_ ("Print the script and submit nothing"), NULL },
  G_OPTION_ENTRY_NULL,
};

static void
run_submit (char **arguments)
{
  if (!submit_slurm)
    qn_cli_usage_error (_ ("--slurm is missing"));
  if (submit_size < 0 || submit_size > QN_STUDY_MAX_CASES)
    qn_cli_usage_error (_ ("--array-size must be positive"));
  g_autofree char *program = g_file_read_link ("/proc/self/exe", NULL);
  const QnSlurmSettings settings = { .program = program != NULL ? program : "quoin-cli",
                                     .array_size = (guint) submit_size,
                                     .partition = submit_partition,
                                     .dry_run = submit_dry_run };
  const char *folder = qn_cli_keep (qn_folder_dup_named (arguments[0]));
  g_auto (QnStudy) study = { 0 };
  QnSubmission submission;
  qn_cli_must (qn_folder_read_study (folder, &study, QN_TROUBLE)
               && qn_study_submit (&study, folder, &settings, &submission, QN_TROUBLE));
  if (submission.script == NULL)
    qn_print (_ ("%s: nothing to submit: %zu cases missing, %u tasks wait or run\n"),
              folder, submission.missing, submission.active);
  else if (submission.job == NULL)
    qn_print_text (submission.script);
  else
    qn_print (_ ("%s: %zu cases missing, %u tasks submitted as array %s\n"), folder,
              submission.missing, submission.tasks, submission.job);
  qn_submission_clear (&submission);
}

static const QnSubcommand submit_action = {
  .name = "study submit",
  .arguments = "FOLDER",
  .summary = N_ ("Compute the cases that are missing on a cluster"),
  .help = N_ ("All nodes must see the folder. Run again, the command submits only tasks "
              "that failed or were lost."),
  .options = submit_entries,
  .run = run_submit,
};

/* Started by `run` alone: not in the help. */
static const GOptionEntry worker_entries[] = {
  { "keep", 0, 0, G_OPTION_ARG_NONE, &study_keep,
    N_ ("Keep the full result of every case that is computed"), NULL },
  G_OPTION_ENTRY_NULL,
};

static void
run_worker (char **arguments)
{
  g_auto (QnStudy) study = { 0 };
  qn_cli_must (qn_folder_read_study (arguments[0], &study, QN_TROUBLE));
  qn_worker_serve (&study, arguments[0], study_keep, stdin, stdout);
}

static const QnSubcommand worker = {
  .name = "study worker",
  .arguments = "FOLDER",
  .summary = N_ ("Compute the cases that standard input names"),
  .options = worker_entries,
  .run = run_worker,
};

static void
run_gather (char **arguments)
{
  g_auto (QnStudy) study = { 0 };
  QnGathered gathered;
  const char *folder = qn_cli_keep (qn_folder_dup_named (arguments[0]));
  qn_cli_must (qn_folder_read_study (folder, &study, QN_TROUBLE)
               && qn_study_gather (&study, folder, &gathered, QN_TROUBLE));
  qn_print (_ ("%s: %zu rows added; %zu of %zu cases, %zu failed\n"), folder,
            gathered.added, gathered.present, gathered.count, gathered.failed);
}

static const QnSubcommand gather_action = {
  .name = "study gather",
  .arguments = "FOLDER",
  .summary = N_ ("Join the results of slices that were computed apart"),
  .help = N_ ("May be repeated, and run while slices are computed."),
  .run = run_gather,
};

/* --- What came of it --- */

/* The rows of the study of a folder, for the rest of the program. */
static QnTable *
load_table (const char *name)
{
  const char *folder = qn_cli_keep (qn_folder_dup_named (name));
  QnStudy *study = qn_cli_keep (g_new0 (QnStudy, 1));
  QnTable *table = qn_cli_keep (g_new0 (QnTable, 1));
  qn_cli_must (qn_folder_read_study (folder, study, QN_TROUBLE)
               && qn_table_read (table, study, folder, QN_TROUBLE));
  return table;
}

static char *table_path = (char *) "-";

static const GOptionEntry table_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &table_path,
    N_ ("Write the table here; standard output by default"), N_ ("TABLE.csv") },
  G_OPTION_ENTRY_NULL,
};

static void
run_table (char **arguments)
{
  qn_cli_must (qn_table_write (load_table (arguments[0]), table_path, QN_TROUBLE));
}

static const QnSubcommand table_action = {
  .name = "study table",
  .arguments = "FOLDER",
  .summary = N_ ("Write the cases of a study as a table (CSV)"),
  .options = table_entries,
  .run = run_table,
};

static void
run_summary (char **arguments)
{
  g_autofree char *text = qn_summary_dup_text (load_table (arguments[0]));
  qn_print_text (text);
}

static const QnSubcommand summary_action = {
  .name = "study summary",
  .arguments = "FOLDER",
  .summary =
    N_ ("Print mean, deviation, quantiles, fragility, sensitivities, mechanisms"),
  .run = run_summary,
};

static char *plot_kind, *plot_of;
static char **plot_by;

static const GOptionEntry plot_entries[] = {
  { "kind", 'k', 0, G_OPTION_ARG_STRING, &plot_kind, N_ ("What is drawn"),
    "scatter|histogram|cumulative|tornado|surface|envelope|mechanisms" },
  { "of", 0, 0, G_OPTION_ARG_STRING, &plot_of,
    N_ ("The output; the first one by default"), N_ ("NAME") },
  { "by", 0, 0, G_OPTION_ARG_STRING_ARRAY, &plot_by,
    N_ ("A parameter; the first by default; a surface has two"), N_ ("NAME") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf")),
  G_OPTION_ENTRY_NULL,
};

/* The first output that is a number, where none is named. */
static int
default_output (const QnTable *table)
{
  for (gsize i = table->parameters; i < table->width; i++)
    if (qn_study_output_is_number (qn_study_output (table->study, i - table->parameters)))
      return (int) i;
  return -1;
}

/* Columns by their names; the first ones that fit where none are named. */
static void
find_columns (const QnTable *table, QnStudyFigure *figure)
{
  guint given = plot_by != NULL ? g_strv_length (plot_by) : 0;
  gboolean one =
    figure->kind == QN_STUDY_FIGURE_SCATTER || figure->kind == QN_STUDY_FIGURE_ENVELOPE;
  guint wanted = figure->kind == QN_STUDY_FIGURE_SURFACE ? 2 : one;
  figure->column =
    plot_of != NULL ? qn_table_find (table, plot_of) : default_output (table);
  if (figure->kind == QN_STUDY_FIGURE_MECHANISMS)
    return;
  if (figure->column < (int) table->parameters
      || !qn_study_output_is_number (
        qn_study_output (table->study, (gsize) figure->column - table->parameters)))
    qn_cli_usage_error (_ ("--of names an output of the study that is a number"));
  if (given > wanted || table->parameters < wanted)
    qn_cli_usage_error (_ ("--by names the parameter of a scatter or an envelope, or the "
                           "two of a surface"));
  for (guint i = 0; i < wanted; i++) {
    figure->parameters[i] = i < given ? qn_table_find (table, plot_by[i]) : (int) i;
    if (figure->parameters[i] < 0 || figure->parameters[i] >= (int) table->parameters)
      qn_cli_usage_error (_ ("--by names a parameter of the study"));
  }
  if (wanted == 2 && figure->parameters[0] == figure->parameters[1])
    qn_cli_usage_error (_ ("a surface needs two different parameters"));
}

static void
run_plot (char **arguments)
{
  QnStudyFigure figure = { 0 };
  if (plot_kind == NULL)
    qn_cli_usage_error (_ ("--kind is missing"));
  if (!qn_find_word (plot_kind, qn_study_figure_names, QN_STUDY_FIGURE_COUNT,
                     &figure.kind))
    qn_cli_refuse_name (plot_kind, qn_study_figure_names, QN_STUDY_FIGURE_COUNT);
  qn_picture_output ();
  figure.monochrome = qn_picture.monochrome;
  const QnTable *table = load_table (arguments[0]);
  find_columns (table, &figure);
  qn_cli_must (qn_study_figure_export (&figure, table, qn_picture.path,
                                       &qn_picture.output, QN_TROUBLE));
}

static const QnSubcommand plot_action = {
  .name = "study plot",
  .arguments = "FOLDER",
  .summary = N_ ("Draw the cases of a study: PNG, SVG or PDF"),
  .help =
    N_ ("A tornado shows Sobol indices of a plan \"sobol\", ranges of a plan "
        "\"one-at-a-time\", else rank correlations. An envelope has the least value "
        "over a parameter, as of a moving load by its place. Mechanisms shows a "
        "typical case of every shape or kind."),
  .options = plot_entries,
  .run = run_plot,
};

static const QnSubcommand *const actions[] = {
  &run_action,   &submit_action,  &gather_action,
  &table_action, &summary_action, &plot_action,
  NULL
};

static void
run_study (char **arguments)
{
  const char *name = arguments[0];
  const QnSubcommand *action = g_strcmp0 (name, "worker") == 0 ? &worker : NULL;
  if (name == NULL)
    qn_cli_usage_error (_ ("an action is missing"));
  if (strcmp (name, "--help") == 0 || strcmp (name, "-h") == 0) {
    qn_print (
      _ ("Usage: quoin-cli study ACTION [OPTION…] ARGUMENT…\n\n"
         "Many cases of one project, and what is uncertain in it.\n\nActions:\n"));
    for (gsize i = 0; actions[i] != NULL; i++)
      qn_print ("  %-16s%s\n", actions[i]->name, _ (actions[i]->summary));
    qn_print (_ ("\n\"quoin-cli study ACTION --help\" explains one of them.\n"));
    return;
  }
  for (gsize i = 0; actions[i] != NULL; i++)
    if (strcmp (name, actions[i]->name + strlen ("study ")) == 0)
      action = actions[i];
  if (action == NULL)
    qn_cli_usage_error (_ ("unknown action %s"), name);
  qn_subcommand_run (action, (int) g_strv_length (arguments), arguments);
}

const QnSubcommand qn_cmd_study = {
  .name = "study",
  .arguments = "ACTION",
  .summary = N_ ("Study uncertain parameters: compute many cases, and their statistics"),
  .actions = actions,
  .run = run_study,
};
