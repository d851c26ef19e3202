#include "study/cases/worker.h"

#include "core/base/clock.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"
#include "study/cases/folder.h"

#include <errno.h>
#include <glib/gi18n-lib.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/* Of a result: whether it failed, seconds; outcome, reason, kind and shape of the mechanism; numbers. */
#define RESULT "(bdmsmsmsms@ad)"

static void
print_result (FILE *output, const QnCaseResult *result)
{
  /* Names in a reason may have any bytes. */
  g_autofree char *reason =
    g_utf8_make_valid (result->reason != NULL ? result->reason : "", -1);
  g_strdelimit (reason, "\t\r\n", ' ');
  g_autoptr (GVariant) fields = g_variant_ref_sink (g_variant_new (
    RESULT, result->failed, result->seconds, result->outcome,
    *reason != '\0' ? reason : NULL, result->mechanism, result->shape,
    g_variant_new_fixed_array (G_VARIANT_TYPE_DOUBLE, result->numbers,
                               QN_STUDY_OUTPUT_COUNT, sizeof *result->numbers)));
  g_autofree char *line = g_variant_print (fields, FALSE);
  fprintf (output, "%s\n", line);
  fflush (output);
}

static gboolean
parse_result (const char *line, QnCaseResult *result)
{
  gsize count = 0;
  g_autoptr (GVariant) numbers = NULL;
  g_autoptr (GVariant) fields =
    g_variant_parse (G_VARIANT_TYPE ("(bdmsmsmsmsad)"), line, NULL, NULL, NULL);
  if (fields == NULL)
    return FALSE;
  g_variant_get (fields, RESULT, &result->failed, &result->seconds, &result->outcome,
                 &result->reason, &result->mechanism, &result->shape, &numbers);
  const double *values =
    g_variant_get_fixed_array (numbers, &count, sizeof *result->numbers);
  memcpy (result->numbers, values,
          MIN (count, QN_STUDY_OUTPUT_COUNT) * sizeof *result->numbers);
  return TRUE;
}

void
qn_worker_serve (const QnStudy *study, const char *folder, gboolean keep, FILE *input,
                 FILE *output)
{
  char *line = NULL;
  size_t size = 0;
  g_autofree double *values = g_new (double, study->parameters->len);

  fputs ("ready\n", output);
  fflush (output);
  while (getline (&line, &size, input) > 0) {
    QnCaseResult result;
    char *at = line;
    gsize number = (gsize) g_ascii_strtoull (at, &at, 10);
    for (guint i = 0; i < study->parameters->len; i++)
      values[i] = g_ascii_strtod (at, &at);
    g_autofree char *path = keep ? qn_folder_dup_result (folder, number) : NULL;
    qn_case_solve (study, values, path, NULL, &result);
    print_result (output, &result);
    qn_case_result_clear (&result);
  }
  free (line);
}

/* In the child, before it becomes the worker: only what is safe after a fork. */
static void
set_up_child (gpointer data)
{
  const pid_t *parent = data;
  prctl (PR_SET_PDEATHSIG, SIGKILL);
  signal (SIGINT, SIG_IGN);
  signal (SIGPIPE, SIG_DFL);
  if (getppid () != *parent)
    _exit (1);
}

gboolean
qn_worker_start (QnWorker *worker, const char *program, const char *folder, gboolean keep,
                 GError **error)
{
  const char *arguments[] = { program, "study", "worker", folder, keep ? "--keep" : NULL,
                              NULL };
  pid_t parent = getpid ();
  g_autoptr (GError) cause = NULL;
  /* As many workers as cores: libraries are not to start threads of their own beside them. */
  g_auto (GStrv) variables =
    g_environ_setenv (g_get_environ (), "OPENBLAS_NUM_THREADS", "1", TRUE);
  *worker = (QnWorker){ .input = -1, .output = -1 };
  if (!g_spawn_async_with_pipes (NULL, (char **) arguments, variables,
                                 G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_CLOEXEC_PIPES,
                                 set_up_child, &parent, &worker->pid, &worker->input,
                                 &worker->output, NULL, &cause))
    return qn_io_fail (error, QN_IO_ERROR_FILE, "%s: %s: %s", program,
                       _ ("cannot be started"), cause->message);
  worker->received = g_string_new (NULL);
  return TRUE;
}

void
qn_worker_give (QnWorker *worker, gsize index, const double *values, gsize width)
{
  g_autoptr (GString) line = g_string_new (NULL);
  char number[QN_NUMBER_TEXT_SIZE];
  g_string_printf (line, "%" G_GSIZE_FORMAT, index + 1);
  for (gsize i = 0; i < width; i++)
    g_string_append_printf (line, "\t%s", qn_number_text (values[i], number));
  g_string_append_c (line, '\n');
  worker->begun = qn_clock_seconds ();
  worker->index = index;
  worker->busy = TRUE;
  for (gsize sent = 0; sent < line->len;) {
    ssize_t count = write (worker->input, line->str + sent, line->len - sent);
    if (count < 0 && errno != EINTR)
      return;
    sent += count > 0 ? (gsize) count : 0;
  }
}

gboolean
qn_worker_receive (QnWorker *worker)
{
  char bytes[4096];
  ssize_t count = read (worker->output, bytes, sizeof bytes);
  if (count > 0)
    g_string_append_len (worker->received, bytes, count);
  return count > 0 || (count < 0 && errno == EINTR);
}

/* Takes the first line; NULL where none is complete. */
static char *
take_line (QnWorker *worker)
{
  const char *end = memchr (worker->received->str, '\n', worker->received->len);
  if (end == NULL)
    return NULL;
  gsize length = (gsize) (end - worker->received->str);
  char *line = g_strndup (worker->received->str, length);
  g_string_erase (worker->received, 0, (gssize) length + 1);
  return line;
}

gboolean
qn_worker_answer (QnWorker *worker, QnCaseResult *result)
{
  for (;;) {
    g_autofree char *line = take_line (worker);
    if (line == NULL)
      return FALSE;
    if (strcmp (line, "ready") == 0) {
      worker->ready = TRUE;
      worker->begun = qn_clock_seconds ();
    } else if (worker->busy && parse_result (line, result)) {
      worker->busy = FALSE;
      return TRUE;
    }
  }
}

char *
qn_worker_end (QnWorker *worker, gboolean kill_it)
{
  int status = 0;
  if (kill_it)
    kill (worker->pid, SIGKILL);
  close (worker->input);
  close (worker->output);
  while (waitpid (worker->pid, &status, 0) < 0 && errno == EINTR)
    ;
  g_string_free (worker->received, TRUE);
  *worker = (QnWorker){ .input = -1, .output = -1 };
  if (WIFSIGNALED (status))
    return g_strdup_printf (_ ("the process of the case was ended by signal %d (%s)"),
                            WTERMSIG (status), strsignal (WTERMSIG (status)));
  if (WIFEXITED (status) && WEXITSTATUS (status) != 0)
    return g_strdup_printf (_ ("the process of the case ended with status %d"),
                            WEXITSTATUS (status));
  return NULL;
}
