#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "core/base/integer.h"

#include "cli/base/message.h"
#include "cli/base/progress.h"
#include "cli/study/cmd-study.h"
#include "study/cases/gather.h"
#include "study/cases/run.h"
#include "study/cases/worker.h"
#include "study/cluster/slurm.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct RunOptions {
  char *folder, *shard;
  int jobs;
  gboolean keep, retry, prepare, quiet;
} RunOptions;

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
                  gboolean quiet, gsize part, gsize parts, QnStudyProgress *progress)
{
  Display display = { .shown = !quiet && isatty (STDERR_FILENO),
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

/* "3/10": the third of ten slices. */
static gboolean
parse_shard (const char *text, QnShard *shard)
{
  guint index, count;
  char rest;
  *shard = (QnShard){ 0, 1 };
  if (text == NULL)
    return TRUE;
  if (sscanf (text, "%u/%u%c", &index, &count, &rest) != 2 || index < 1 || index > count
      || count > QN_STUDY_MAX_CASES)
    return FALSE;
  *shard = (QnShard){ index - 1, count };
  return TRUE;
}

static void
compute (const QnStudy *study, const RunOptions *options, QnStudyRunSettings settings)
{
  QnStudyProgress progress;
  gboolean done =
    qn_study_compute (study, options->folder, settings, options->quiet, 0, 1, &progress);
  if (!options->quiet) {
    qn_print (_ ("%s: %zu of %zu cases"), options->folder, progress.present,
              progress.wanted);
    if (progress.failed > 0)
      qn_print (_ (", %zu of those computed now failed"), progress.failed);
    qn_print (_ ("; %.1f s\n"), progress.seconds);
  }
  if (!done)
    qn_study_cancelled (options->folder);
}

static void
run_study (RunOptions *options, char *path)
{
  QnStudy *study = qn_cli_keep (g_new0 (QnStudy, 1));
  QnStudyRunSettings settings = { .jobs = (guint) MAX (options->jobs, 0),
                                  .keep = options->keep,
                                  .retry = options->retry };
  /* The folder of a study stands for the study as well. */
  gboolean again = options->folder == NULL && g_file_test (path, G_FILE_TEST_IS_DIR);
  if (again)
    path = qn_cli_keep (qn_folder_dup_named (path));
  if (options->folder == NULL && !again)
    qn_cli_usage_error (_ ("-o is missing"));
  if (options->jobs < 0 || options->jobs > 1024)
    qn_cli_usage_error (_ ("--jobs is a number from 1 to 1024"));
  if (!parse_shard (options->shard, &settings.shard))
    qn_cli_usage_error (_ ("--shard is k/n, the k-th of n slices, as in 3/10"));
  qn_cli_must (again ? qn_folder_read_study (path, study, QN_TROUBLE)
                     : qn_study_read (path, NULL, study, QN_TROUBLE));
  if (again)
    options->folder = path;
  for (guint i = 0; i < study->warnings->len; i++)
    qn_cli_warning ("%s", (char *) g_ptr_array_index (study->warnings, i));
  for (guint i = 0; i < study->project.warnings->len; i++)
    qn_cli_warning ("%s", (char *) g_ptr_array_index (study->project.warnings, i));
  if (!options->prepare) {
    compute (study, options, settings);
    return;
  }
  qn_cli_must (qn_folder_prepare (options->folder, study, QN_TROUBLE));
  if (!options->quiet)
    qn_print (_ ("%s: %zu cases to compute\n"), options->folder,
              qn_study_case_count (study));
}

static void
run_run (const QnSubcommand *self, int argc, char **argv)
{
  RunOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.folder,
      N_ ("Folder of the results; made where there is none"), N_ ("FOLDER") },
    { "jobs", 'j', 0, G_OPTION_ARG_INT, &options.jobs,
      N_ ("Processes at once; all cores by default"), N_ ("N") },
    { "shard", 0, 0, G_OPTION_ARG_STRING, &options.shard,
      N_ ("Compute the k-th of n slices only, into a separate database"), N_ ("K/N") },
    { "keep", 0, 0, G_OPTION_ARG_NONE, &options.keep,
      N_ ("Keep the full result of every case that is computed"), NULL },
    { "retry", 0, 0, G_OPTION_ARG_NONE, &options.retry,
      N_ ("Compute cases that failed once more"), NULL },
    { "prepare", 0, 0, G_OPTION_ARG_NONE, &options.prepare,
      N_ ("Make the folder and compute nothing yet"), NULL },
    { "quiet", 'q', 0, G_OPTION_ARG_NONE, &options.quiet,
      N_ ("Print errors and warnings only"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    run_study (&options, argv[1]);
}

static void
run_submit (const QnSubcommand *self, int argc, char **argv)
{
  gboolean slurm = FALSE, dry_run = FALSE;
  int size = 0;
  char *partition = NULL;
  const GOptionEntry entries[] = {
    { "slurm", 0, 0, G_OPTION_ARG_NONE, &slurm, N_ ("Submit to Slurm"), NULL },
    { "array-size", 0, 0, G_OPTION_ARG_INT, &size,
      N_ ("Tasks of the array; as before, or 100"), N_ ("N") },
    { "partition", 0, 0, G_OPTION_ARG_STRING, &partition, N_ ("Partition of the cluster"),
      N_ ("NAME") },
    { "dry-run", 0, 0, G_OPTION_ARG_NONE, &dry_run,
      N_ ("Print the script and submit nothing"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  if (!slurm)
    qn_cli_usage_error (_ ("--slurm is missing"));
  if (size < 0 || size > QN_STUDY_MAX_CASES)
    qn_cli_usage_error (_ ("--array-size must be positive"));
  g_autofree char *program = g_file_read_link ("/proc/self/exe", NULL);
  const QnSlurmSettings settings = { .program = program != NULL ? program : "quoin-cli",
                                     .array_size = (guint) size,
                                     .partition = partition,
                                     .dry_run = dry_run };
  const char *folder = qn_cli_keep (qn_folder_dup_named (argv[1]));
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
  .run = run_submit,
};

/* Started by `run` alone: not in the help. */
static void
run_worker (const QnSubcommand *self, int argc, char **argv)
{
  gboolean keep = FALSE;
  const GOptionEntry entries[] = {
    { "keep", 0, 0, G_OPTION_ARG_NONE, &keep,
      N_ ("Keep the full result of every case that is computed"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_auto (QnStudy) study = { 0 };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  qn_cli_must (qn_folder_read_study (argv[1], &study, QN_TROUBLE));
  qn_worker_serve (&study, argv[1], keep, stdin, stdout);
}

static const QnSubcommand worker = {
  .name = "study worker",
  .arguments = "FOLDER",
  .summary = N_ ("Compute the cases that standard input names"),
  .run = run_worker,
};

static const QnSubcommand run_action = {
  .name = "study run",
  .arguments = "STUDY|FOLDER",
  .summary = N_ ("Compute the cases of a study that have no result yet"),
  .help = N_ ("Every case is a row of FOLDER/study.db, written as it is computed: after "
              "Ctrl+C or a crash the same command continues. A case that "
              "fails is a row that says why."),
  .run = run_run,
};

static void
run_gather (const QnSubcommand *self, int argc, char **argv)
{
  const GOptionEntry entries[] = { G_OPTION_ENTRY_NULL };
  g_auto (QnStudy) study = { 0 };
  QnGathered gathered;
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  const char *folder = qn_cli_keep (qn_folder_dup_named (argv[1]));
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

static const QnSubcommand *const actions[] = { &run_action,
                                               &submit_action,
                                               &gather_action,
                                               &qn_study_action_table,
                                               &qn_study_action_summary,
                                               &qn_study_action_plot };

static void
print_help (void)
{
  qn_print (_ ("Usage: quoin-cli study ACTION [OPTION…] ARGUMENT…\n\n"
               "Many cases of one project, and what is uncertain in it.\n\nActions:\n"));
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
    qn_print ("  %-16s%s\n", actions[i]->name, _ (actions[i]->summary));
  qn_print (_ ("\n\"quoin-cli study ACTION --help\" explains one of them.\n"));
}

static void
run_subcommand (const QnSubcommand *self, int argc, char **argv)
{
  const char *name = argc > 1 ? argv[1] : NULL;
  const QnSubcommand *action = g_strcmp0 (name, "worker") == 0 ? &worker : NULL;
  qn_cli_set_subcommand (self->name);
  if (name == NULL)
    qn_cli_usage_error (_ ("an action is missing"));
  if (strcmp (name, "--help") == 0 || strcmp (name, "-h") == 0) {
    print_help ();
    return;
  }
  if (strcmp (name, QN_DESCRIBE) == 0) {
    const GOptionEntry none[] = { G_OPTION_ENTRY_NULL };
    qn_subcommand_parse (self, none, 0, 0, &argc, &argv);
    for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
      actions[i]->run (actions[i], argc, argv);
    return;
  }
  for (gsize i = 0; i < G_N_ELEMENTS (actions); i++)
    if (strcmp (name, actions[i]->name + strlen ("study ")) == 0)
      action = actions[i];
  if (action == NULL)
    qn_cli_usage_error (_ ("unknown action %s"), name);
  action->run (action, argc - 1, argv + 1);
}

const QnSubcommand qn_cmd_study = {
  .name = "study",
  .arguments = "ACTION",
  .summary = N_ ("Study uncertain parameters: compute many cases, and their statistics"),
  .run = run_subcommand,
};
