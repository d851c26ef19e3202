/* Writes the tables of a text anew from those of the benchmark programs.
 *
 *   bench-tables [--check] FOLDER TEXT.md
 *
 * report-tables.h says how tables are marked. With --check nothing is written, and the program
 * fails where the text shows anything else than the folder's tables. Exit codes: 0 done, 1
 * something else is shown, 2 wrong usage, 5 cannot be read or written. */
#include "bench/report-tables.h"

#include <locale.h>
#include <stdio.h>

int
main (int argc, char **argv)
{
  gboolean check = FALSE;
  const GOptionEntry entries[] = {
    { "check", 0, 0, G_OPTION_ARG_NONE, &check, "Write nothing, fail where it differs",
      NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("FOLDER TEXT.md");
  g_autoptr (GError) error = NULL;
  g_autofree char *text = NULL, *written = NULL;

  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error) || argc != 3) {
    fprintf (stderr, "bench-tables: %s\n",
             error != NULL ? error->message : "a folder and a text are needed");
    return 2;
  }
  if (g_file_get_contents (argv[2], &text, NULL, &error))
    written = report_tables_dup (text, argv[1], &error);
  if (written != NULL && check && !g_str_equal (text, written)) {
    fprintf (stderr, "bench-tables: %s does not show the tables of %s\n", argv[2],
             argv[1]);
    return 1;
  }
  if (written == NULL
      || (!check && !g_file_set_contents (argv[2], written, -1, &error))) {
    fprintf (stderr, "bench-tables: %s\n", error->message);
    return 5;
  }
  return 0;
}
