#include "support/instructions.h"

#include <glib/gstdio.h>
#include <sys/wait.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED TRUE
#else
#define SANITIZED FALSE
#endif

static double
total_of (const char *counted)
{
  g_autoptr (GRegex) regex = g_regex_new ("(?m)^(?:totals|summary): *(\\d+)", 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  g_assert_true (g_regex_match (regex, counted, 0, &match));
  g_autofree char *digits = g_match_info_fetch (match, 1);
  return g_ascii_strtod (digits, NULL);
}

/* Adds up what every process has left in the folder, and removes it. */
static double
take_totals (const char *folder)
{
  g_autoptr (GDir) files = g_dir_open (folder, 0, NULL);
  const char *name;
  double total = 0;
  while ((name = g_dir_read_name (files)) != NULL) {
    g_autofree char *path = g_build_filename (folder, name, NULL);
    g_autofree char *counted = NULL;
    g_autoptr (GError) error = NULL;
    g_file_get_contents (path, &counted, NULL, &error);
    g_assert_no_error (error);
    total += total_of (counted);
    g_remove (path);
  }
  g_rmdir (folder);
  return total;
}

typedef enum { ALONE, WITH_CHILDREN } Processes;

/* `function` NULL: all that is executed, loading the program too. Cachegrind counts this in six tenths
 * of callgrind's time. */
static double
count (const char *const *arguments, const char *function, Processes processes,
       char **output, int *status)
{
  g_autofree char *valgrind = g_find_program_in_path ("valgrind");
  if (SANITIZED || valgrind == NULL)
    return 0;

  g_autofree char *folder = g_dir_make_tmp ("quoin-work-XXXXXX", NULL);
  const char *tool = function != NULL ? "callgrind" : "cachegrind";
  g_autofree char *named = g_strconcat ("--tool=", tool, NULL);
  g_autofree char *out_file = g_strconcat ("--", tool, "-out-file=", folder, "/%p", NULL);
  g_autofree char *what = function != NULL
                            ? g_strconcat ("--toggle-collect=", function, NULL)
                            : g_strdup ("--cache-sim=no");
  g_autoptr (GPtrArray) command = g_ptr_array_new ();
  const char *children =
    processes == WITH_CHILDREN ? "--trace-children=yes" : "--trace-children=no";
  const char *head[] = { valgrind, "--quiet", named, children, what, out_file };
  for (gsize i = 0; i < G_N_ELEMENTS (head); i++)
    g_ptr_array_add (command, (gpointer) head[i]);
  for (; *arguments != NULL; arguments++)
    g_ptr_array_add (command, (gpointer) *arguments);
  g_ptr_array_add (command, NULL);

  g_autoptr (GError) error = NULL;
  /* Filling memory with a pattern is no work of the function's. */
  g_auto (GStrv) environment = g_environ_unsetenv (g_get_environ (), "MALLOC_PERTURB_");
  g_spawn_sync (NULL, (char **) command->pdata, environment, G_SPAWN_STDERR_TO_DEV_NULL,
                NULL, NULL, output, NULL, status, &error);
  g_assert_no_error (error);
  return take_totals (folder);
}

double
count_instructions (const char *const *arguments, const char *function, char **output)
{
  g_autofree char *said = NULL;
  int status = 0;
  double instructions = count (arguments, function, ALONE, &said, &status);
  g_assert_true (g_spawn_check_wait_status (status, NULL));
  if (output != NULL)
    *output = g_steal_pointer (&said);
  return instructions;
}

double
count_program (const char *const *arguments, int *code)
{
  static double start; /* of a program that does nothing else */
  const char *const alone[] = { arguments[0], "--version", NULL };
  if (start == 0)
    start = count_processes (alone);
  g_autofree char *said = NULL;
  int status = 0;
  double instructions = count (arguments, NULL, ALONE, &said, &status);
  g_assert_true (WIFEXITED (status));
  *code = WEXITSTATUS (status);
  return instructions - start;
}

double
count_processes (const char *const *arguments)
{
  g_autofree char *said = NULL;
  int status = 0;
  double instructions = count (arguments, NULL, WITH_CHILDREN, &said, &status);
  g_assert_true (g_spawn_check_wait_status (status, NULL));
  return instructions;
}
