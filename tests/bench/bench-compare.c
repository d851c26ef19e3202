/* Says what got worse between two runs of the benchmarks, and fails if anything did.
 *
 *   bench-compare [--noise N] [--mean-noise N] [--multiplier M] [--partial] BASELINE FRESH
 *
 * Two folders of tables as the other programs write them; compare.h says what is compared and how.
 * Exit codes: 0 nothing got worse, 1 something did, 2 wrong usage, 5 cannot be read. */
#include "bench/compare.h"

#include <locale.h>

int
main (int argc, char **argv)
{
  CompareMargins margins = compare_margins_default ();
  gboolean partial = FALSE;
  const GOptionEntry entries[] = {
    { "noise", 0, 0, G_OPTION_ARG_DOUBLE, &margins.time,
      "How many times as long one thing may take (1.6)", "N" },
    { "mean-noise", 0, 0, G_OPTION_ARG_DOUBLE, &margins.mean_time,
      "The same for all of a table together (1.25)", "N" },
    { "multiplier", 0, 0, G_OPTION_ARG_DOUBLE, &margins.multiplier,
      "Relative margin of multipliers (1e-3)", "M" },
    { "partial", 0, 0, G_OPTION_ARG_NONE, &partial, "Do not miss what was not run",
      NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BASELINE FRESH");
  g_autoptr (GError) error = NULL;
  CompareVerdict verdict;

  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error) || argc != 3) {
    fprintf (stderr, "bench-compare: %s\n",
             error != NULL ? error->message : "two folders are needed");
    return 2;
  }
  if (!compare_folders (argv[1], argv[2], &margins, partial, stdout, &verdict, &error)) {
    fprintf (stderr, "bench-compare: %s\n", error->message);
    return 5;
  }
  printf ("%d figures compared, %d worse, %d better, %d missing, %d new\n",
          verdict.compared, verdict.worse, verdict.better, verdict.missing,
          verdict.added);
  return verdict.worse + verdict.missing > 0 ? 1 : 0;
}
