#include "study/cluster/slurm.h"

#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "study/cases/store.h"

#include <glib/gi18n-lib.h>
#include <string.h>
#include <unistd.h>

void
qn_submission_clear (QnSubmission *submission)
{
  g_free (submission->script);
  g_free (submission->job);
  *submission = (QnSubmission){ 0 };
}

char *
qn_slurm_dup_range (const guint8 *marks, guint count)
{
  GString *range = g_string_new (NULL);
  for (guint i = 0; i < count; i++) {
    guint last = i;
    if (!marks[i])
      continue;
    while (last + 1 < count && marks[last + 1])
      last++;
    g_string_append_printf (range, "%s%u", range->len > 0 ? "," : "", i + 1);
    if (last > i)
      g_string_append_printf (range, "-%u", last + 1);
    i = last;
  }
  return g_string_free (range, FALSE);
}

/* What a program of Slurm says; NULL with an error where it cannot be started. Where it fails,
 * *refusal is what it said of that. */
static char *
ask_scheduler (const char *const *command, char **refusal, GError **error)
{
  GError *local = NULL;
  char *answer = NULL;
  g_autofree char *complaint = NULL;
  int status = 0;
  if (!g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL,
                     &answer, &complaint, &status, &local)) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_FILE, "%s: %s", command[0],
                 local->message);
    g_error_free (local);
    return NULL;
  }
  *refusal = g_spawn_check_wait_status (status, NULL)
               ? NULL
               : g_strdup (g_strdelimit (g_strchomp (complaint), "\n", ' '));
  return answer;
}

/* Marks the slices whose tasks wait or run. Slurm removes arrays that have ended and then reports
 * an error for them: none of their tasks runs. */
static gboolean
mark_active (const char *jobs, guint8 *active, guint slices, GError **error)
{
  g_auto (GStrv) numbers = g_strsplit (jobs, " ", -1);
  for (gsize i = 0; numbers[i] != NULL && *numbers[i] != '\0'; i++) {
    const char *command[] = { "squeue", "--noheader", "--array", "--format=%K",
                              "--jobs", numbers[i],   NULL };
    g_autofree char *refusal = NULL;
    g_autofree char *answer = ask_scheduler (command, &refusal, error);
    if (answer == NULL)
      return FALSE;
    if (refusal != NULL && strstr (refusal, "Invalid job id") == NULL)
      return qn_io_fail (error, QN_IO_ERROR_FILE, "squeue: %s", refusal);
    g_auto (GStrv) lines = g_strsplit (refusal == NULL ? answer : "", "\n", -1);
    for (gsize k = 0; lines[k] != NULL; k++) {
      guint64 task = g_ascii_strtoull (lines[k], NULL, 10);
      if (task >= 1 && task <= slices)
        active[task - 1] = 1;
    }
  }
  return TRUE;
}

static guint
count_marks (const guint8 *marks, guint count)
{
  guint sum = 0;
  for (guint i = 0; i < count; i++)
    sum += marks[i];
  return sum;
}

/* Paths stand in double quotes in lines for Slurm, which knows % as its own, and in single quotes in
 * those for the shell. */
static char *
dup_script (const char *folder, const QnSlurmSettings *settings, const guint8 *marks,
            guint slices)
{
  g_autofree char *range = qn_slurm_dup_range (marks, slices);
  g_autofree char *program = g_shell_quote (settings->program);
  g_autofree char *quoted = g_shell_quote (folder);
  g_auto (GStrv) parts = g_strsplit (folder, "%", -1);
  g_autofree char *log = g_strjoinv ("%%", parts);
  GString *script = g_string_new ("#!/bin/sh\n");
  g_string_append_printf (script,
                          "#SBATCH --job-name=quoin-study\n"
                          "#SBATCH --array=%s\n"
                          "#SBATCH --output=\"%s/slurm-%%A-%%a.log\"\n",
                          range, log);
  if (settings->partition != NULL)
    g_string_append_printf (script, "#SBATCH --partition=%s\n", settings->partition);
  g_string_append_printf (script,
                          "exec %s study run %s --shard \"$SLURM_ARRAY_TASK_ID/%u\" "
                          "--jobs \"${SLURM_CPUS_PER_TASK:-1}\" --quiet\n",
                          program, quoted, slices);
  return g_string_free (script, FALSE);
}

static gboolean
hand_over (QnStore *store, const char *folder, const char *jobs, guint slices,
           QnSubmission *submission, GError **error)
{
  g_autofree char *path = g_build_filename (folder, "slurm.sh", NULL), *refusal = NULL;
  const char *command[] = { "sbatch", "--parsable", path, NULL };
  if (!qn_file_write (path, submission->script, strlen (submission->script), error))
    return FALSE;
  char *answer = ask_scheduler (command, &refusal, error);
  if (answer == NULL)
    return FALSE;
  if (refusal != NULL) {
    g_free (answer);
    return qn_io_fail (error, QN_IO_ERROR_FILE, "sbatch: %s", refusal);
  }
  submission->job = g_strchomp (answer);
  submission->job[strcspn (submission->job, ";")] =
    '\0'; /* the cluster's name behind it */
  g_autofree char *all =
    g_strdup_printf ("%s%s%s", jobs, *jobs != '\0' ? " " : "", submission->job);
  g_autofree char *number = g_strdup_printf ("%u", slices);
  return qn_store_set_note (store, "slurm-slices", number, error)
         && qn_store_set_note (store, "slurm-jobs", all, error);
}

static gboolean
submit (QnStore *store, gsize count, const char *folder, const QnSlurmSettings *settings,
        QnSubmission *submission, GError **error)
{
  g_autofree char *before = NULL, *jobs = NULL;
  if (!qn_store_get_note (store, "slurm-slices", &before, error)
      || !qn_store_get_note (store, "slurm-jobs", &jobs, error))
    return FALSE;
  guint former = before != NULL ? (guint) g_ascii_strtoull (before, NULL, 10) : 0;
  guint asked = settings->array_size > 0 ? settings->array_size
                : former > 0             ? former
                                         : QN_SLURM_ARRAY_SIZE;
  guint slices = (guint) MIN ((gsize) asked, count);
  g_autofree guint8 *active = g_new0 (guint8, MAX (slices, former));
  g_autofree guint8 *wanted = g_new0 (guint8, slices);
  const char *known = jobs != NULL ? jobs : "";
  if (!mark_active (known, active, former, error))
    return FALSE;
  submission->active = count_marks (active, former);
  if (former != slices && submission->active > 0)
    return qn_io_fail (error, QN_IO_ERROR_INVALID, "%s: %s", folder,
                       _ ("tasks of another array size still wait or run"));
  g_autofree guint8 *present = g_new0 (guint8, count);
  if (!qn_store_mark_present (store, present, count, error))
    return FALSE;
  for (gsize i = 0; i < count; i++) {
    submission->missing += !present[i];
    if (!present[i] && !active[i % slices])
      wanted[i % slices] = 1;
  }
  submission->tasks = count_marks (wanted, slices);
  if (submission->tasks == 0)
    return TRUE;
  submission->script = dup_script (folder, settings, wanted, slices);
  return settings->dry_run || hand_over (store, folder, known, slices, submission, error);
}

gboolean
qn_study_submit (const QnStudy *study, const char *folder,
                 const QnSlurmSettings *settings, QnSubmission *submission,
                 GError **error)
{
  QnGathered gathered;
  g_autofree char *full = g_canonicalize_filename (folder, NULL);
  g_autofree char *database = qn_folder_dup_database (folder, (QnShard){ 0, 1 });
  *submission = (QnSubmission){ 0 };
  if (!qn_study_gather (study, folder, &gathered, error))
    return FALSE;
  int lock = qn_folder_lock (database, error);
  if (lock < 0)
    return FALSE;
  QnStore *store = qn_store_open (database, study, FALSE, error);
  gboolean ok =
    store != NULL
    && submit (store, qn_study_case_count (study), full, settings, submission, error);
  qn_store_close (store);
  close (lock);
  if (!ok)
    qn_submission_clear (submission);
  return ok;
}
