#include "library/library-private.h"

#include <gio/gio.h>
#include <glib/gstdio.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/* The kind of error that an exit code stands for. */
static QuoinErrorKind
kind_of_exit (int code)
{
  return code == 2   ? QUOIN_ERROR_USAGE
         : code == 3 ? QUOIN_ERROR_INVALID
         : code == 5 ? QUOIN_ERROR_FILE
                     : QUOIN_ERROR_NO_ANSWER;
}

/* The last line that is no warning, without the name of the program. */
static char *
dup_message (const char *said)
{
  const char *name = "quoin-cli: ";
  g_auto (GStrv) lines = g_strsplit (said, "\n", -1);
  for (guint i = g_strv_length (lines); i > 0; i--)
    if (g_str_has_prefix (lines[i - 1], name)
        && !g_str_has_prefix (lines[i - 1] + strlen (name), "warning: "))
      return g_strdup (lines[i - 1] + strlen (name));
  return g_strdup (*said != '\0' ? g_strstrip ((char *) said) : "quoin-cli failed");
}

/* Calls back for a line of progress (quoin-cli, cases of a study); ends the program where that says so.
 * It may be done by then. False for any other line. */
static bool
take_progress (const char *line, GSubprocess *program, QuoinCaller *caller)
{
  gsize present, wanted, failed;
  if (sscanf (line, "progress %zu %zu %zu", &present, &wanted, &failed) != 3)
    return false;
  caller->steps = (int32_t) present;
  caller->reached = (double) present;
  if (!quoin_library_tell (caller,
                           wanted > 0 ? fmin ((double) present / (double) wanted, 1) : 0,
                           (int32_t) failed)) {
    g_subprocess_send_signal (program, SIGINT); /* a second one would end it at once */
    caller->func = NULL;
  }
  return true;
}

/* What it prints goes to a file that has no name any more; what it says is read as it comes. */
static GSubprocess *
start (const char *const *arguments, int output, GError **cause)
{
  const char *name = g_getenv ("QUOIN_CLI");
  g_autoptr (GPtrArray) all = g_ptr_array_new ();
  g_autoptr (GSubprocessLauncher) launcher =
    g_subprocess_launcher_new (G_SUBPROCESS_FLAGS_STDERR_PIPE);
  g_ptr_array_add (all, (gpointer) (name != NULL ? name : "quoin-cli"));
  for (; *arguments != NULL; arguments++)
    g_ptr_array_add (all, (gpointer) *arguments);
  g_ptr_array_add (all, NULL);
  /* Messages are those of the library: in English. */
  g_subprocess_launcher_setenv (launcher, "LC_ALL", "C.UTF-8", TRUE);
  g_subprocess_launcher_setenv (launcher, "QUOIN_PROGRESS", "1", TRUE);
  g_subprocess_launcher_take_stdout_fd (launcher, output);
  return g_subprocess_launcher_spawnv (launcher, (const char *const *) all->pdata, cause);
}

bool
quoin_command_watched (const char *const *arguments, char **output,
                       QuoinProgressFunc progress, void *data, QuoinError **error)
{
  if (output != NULL)
    *output = NULL;
  if (!quoin_library_given (arguments, "arguments", error))
    return false;
  QuoinCaller caller = { .func = progress, .data = data, .what = "cases" };
  GError *cause = NULL;
  g_autofree char *path = NULL, *printed = NULL;
  int file = g_file_open_tmp ("quoin-XXXXXX", &path, &cause);
  g_autoptr (GSubprocess) program = file >= 0 ? start (arguments, file, &cause) : NULL;
  if (program == NULL) {
    g_unlink (path != NULL ? path : "");
    return quoin_library_take_error (error, NULL, cause);
  }
  g_autoptr (GString) said = g_string_new (NULL);
  g_autoptr (GDataInputStream) lines =
    g_data_input_stream_new (g_subprocess_get_stderr_pipe (program));
  char *line;
  while ((line = g_data_input_stream_read_line (lines, NULL, NULL, NULL)) != NULL) {
    if (!take_progress (line, program, &caller))
      g_string_append_printf (said, "%s\n", line);
    g_free (line);
  }
  bool done = g_subprocess_wait_check (program, NULL, &cause)
              && g_file_get_contents (path, &printed, NULL, &cause);
  g_unlink (path);
  if (!done && cause->domain != G_SPAWN_EXIT_ERROR && cause->domain != G_SPAWN_ERROR)
    return quoin_library_take_error (error, NULL, cause);
  if (!done || caller.func != progress) {
    g_autofree char *message = done ? g_strdup ("cancelled") : dup_message (said->str);
    int code = !done && cause->domain == G_SPAWN_EXIT_ERROR ? cause->code : 1;
    g_clear_error (&cause);
    return quoin_library_set_error (error, kind_of_exit (code), "%s", message);
  }
  quoin_library_tell (&caller, 1, 0);
  if (output != NULL)
    *output = g_steal_pointer (&printed);
  return true;
}

bool
quoin_command (const char *const *arguments, char **output, QuoinError **error)
{
  return quoin_command_watched (arguments, output, NULL, NULL, error);
}
