#include "library/library-private.h"

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

bool
quoin_command (const char *const *arguments, char **output, QuoinError **error)
{
  if (output != NULL)
    *output = NULL;
  if (!quoin_library_given (arguments, "arguments", error))
    return false;
  const char *program = g_getenv ("QUOIN_CLI");
  g_autoptr (GPtrArray) all = g_ptr_array_new ();
  GError *cause = NULL;
  g_autofree char *printed = NULL, *said = NULL;
  g_ptr_array_add (all, (gpointer) (program != NULL ? program : "quoin-cli"));
  for (; *arguments != NULL; arguments++)
    g_ptr_array_add (all, (gpointer) *arguments);
  g_ptr_array_add (all, NULL);
  /* Messages are those of the library: in English. */
  g_auto (GStrv) variables =
    g_environ_setenv (g_get_environ (), "LC_ALL", "C.UTF-8", TRUE);
  int status = 0;
  if (!g_spawn_sync (NULL, (char **) all->pdata, variables, G_SPAWN_SEARCH_PATH, NULL,
                     NULL, &printed, &said, &status, &cause)) {
    quoin_library_take_error (error, NULL, cause);
    return false;
  }
  if (!g_spawn_check_wait_status (status, &cause)) {
    g_autofree char *message = dup_message (said);
    int code = cause->domain == G_SPAWN_EXIT_ERROR ? cause->code : 1;
    quoin_library_set_error (error, kind_of_exit (code), "%s", message);
    g_error_free (cause);
    return false;
  }
  if (output != NULL)
    *output = g_steal_pointer (&printed);
  return true;
}
