/* What a study costs beside single runs.
 *
 *   bench-study [--cases N] [--solve N] [--counted N] [--check]
 *
 * study.csv: cases of wall 3 by `limit` (examples/studies/wall3-friction) and by `solve`: processor
 *            time and duration of all, by number of processes, beside so many single runs of quoin-cli;
 *            ended with kill -9 when the first rows are kept and taken up again
 * study-bars.csv: how many times a single run a case costs less, in instructions (of all processes,
 *            with callgrind) and in processor time, and the speed-up by two processes
 *
 * With --check the bar in instructions is the one that fails: times are those of a shared machine. It is
 * lower than that in time, since the start of a process takes more time than instructions: pages are
 * faulted in. */
#include "bench/bench.h"
#include "support/instructions.h"

#include <locale.h>
#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* So many single runs are measured. */
#define SINGLE 20

#define BAR          5.0
#define INSTRUCTIONS 3.0
#define SPEED_UP     1.6

typedef struct Cost {
  double seconds, elapsed;
} Cost;

static char *folder;

static char *
example (const char *name)
{
  return g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
}

static double
children_seconds (void)
{
  struct rusage usage;
  getrusage (RUSAGE_CHILDREN, &usage);
  return (double) (usage.ru_utime.tv_sec + usage.ru_stime.tv_sec)
         + 1e-6 * (double) (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static GPid
start (const char *const *arguments, char **output)
{
  g_autoptr (GError) error = NULL;
  GPid child = 0;
  if (output != NULL)
    g_spawn_sync (NULL, (char **) arguments, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL,
                  output, NULL, NULL, &error);
  else
    g_spawn_async (NULL, (char **) arguments, NULL,
                   G_SPAWN_DO_NOT_REAP_CHILD | G_SPAWN_STDOUT_TO_DEV_NULL
                     | G_SPAWN_STDERR_TO_DEV_NULL,
                   NULL, NULL, &child, &error);
  g_assert_no_error (error);
  return child;
}

static Cost
run (const char *const *arguments)
{
  double before = children_seconds ();
  gint64 begun = g_get_monotonic_time ();
  int status;
  GPid child = start (arguments, NULL);
  g_assert_cmpint (waitpid (child, &status, 0), ==, child);
  g_assert_cmpint (status, ==, 0);
  return (Cost){ children_seconds () - before,
                 1e-6 * (double) (g_get_monotonic_time () - begun) };
}

static void
remove_folder (const char *path)
{
  g_autofree char *rm = g_find_program_in_path ("rm");
  const char *const command[] = { rm, "-rf", path, NULL };
  run (command);
}

/* The example's study with another run and so many cases, beside its project. */
static char *
write_study (const char *kind, int cases)
{
  g_autofree char *path = example ("studies/wall3-friction.quoin-study");
  g_autofree char *project = example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *name = g_strdup_printf ("%s-%d.quoin-study", kind, cases);
  g_autofree char *text = NULL;
  g_autoptr (GError) error = NULL;
  g_file_get_contents (path, &text, NULL, &error);
  g_assert_no_error (error);
  g_autofree char *count = g_strdup_printf ("\"count\": %d,", cases);
  g_autofree char *run = g_strdup_printf ("\"run\": \"%s\"", kind);
  g_autoptr (GString) study = g_string_new (text);
  g_assert_cmpint (g_string_replace (study, "../ferris-tin-loi/wall3.quoin", project, 1),
                   ==, 1);
  g_assert_cmpint (g_string_replace (study, "\"count\": 1000,", count, 1), ==, 1);
  g_assert_cmpint (g_string_replace (study, "\"run\": \"solve\"", run, 1), ==, 1);
  char *written = g_build_filename (folder, name, NULL);
  g_file_set_contents (written, study->str, -1, &error);
  g_assert_no_error (error);
  return written;
}

/* The command that runs it; the strings are the caller's. */
static void
command_of (const char *command[9], const char *study, const char *into, const char *jobs)
{
  const char *words[] = {
    g_getenv ("QUOIN_CLI"), "study", "run", study, "-o", into, "--jobs", jobs, NULL
  };
  memcpy (command, words, sizeof words);
}

static char *
dup_table (const char *results)
{
  char *table = NULL;
  const char *const command[] = { g_getenv ("QUOIN_CLI"), "study", "table", results,
                                  NULL };
  start (command, &table);
  return table;
}

/* Its rows without what a case took, in order of the cases. */
static char *
dup_values (const char *results)
{
  g_autofree char *table = dup_table (results);
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_auto (GStrv) names = g_strsplit (lines[0], ",", -1);
  g_autoptr (GString) values = g_string_new (NULL);
  for (char **line = lines; *line != NULL; line++) {
    g_auto (GStrv) fields = g_strsplit (*line, ",", -1);
    for (guint i = 0; fields[i] != NULL && names[i] != NULL; i++)
      if (!g_str_has_prefix (names[i], "seconds"))
        g_string_append_printf (values, "%s,", fields[i]);
    g_string_append_c (values, '\n');
  }
  return g_string_free (g_steal_pointer (&values), FALSE);
}

static guint
count_rows (const char *results)
{
  g_autofree char *table = dup_table (results);
  guint rows = 0;
  for (const char *at = table; at != NULL && (at = strstr (at, ",done,")) != NULL; at++)
    rows++;
  return rows;
}

/* Ends the run with kill -9 when the first rows are there, and takes it up again. */
static gboolean
is_same_after_kill (const char *study, const char *whole, int cases)
{
  const char *command[9];
  g_autofree char *into = g_build_filename (folder, "killed", NULL);
  command_of (command, study, into, "2");
  GPid child = start (command, NULL);
  while (count_rows (into) == 0)
    g_usleep (20000);
  kill (child, SIGKILL);
  waitpid (child, NULL, 0);
  guint kept = count_rows (into);
  run (command);
  g_autofree char *expected = dup_values (whole);
  g_autofree char *found = dup_values (into);
  printf ("# killed after %u of %d rows\n", kept, cases);
  return strcmp (expected, found) == 0;
}

static Cost
cost_of_single (const char *kind)
{
  g_autofree char *project = example ("ferris-tin-loi/wall3.quoin");
  const char *const command[] = { g_getenv ("QUOIN_CLI"), kind, project, NULL };
  Cost sum = { 0, 0 };
  for (int i = 0; i < SINGLE; i++) {
    Cost cost = run (command);
    sum.seconds += cost.seconds / SINGLE;
    sum.elapsed += cost.elapsed / SINGLE;
  }
  return sum;
}

/* One process and two; times in seconds. *same: of a run that was killed. */
static gboolean
measure (FILE *csv, FILE *bars, const char *kind, int cases)
{
  const char *command[9];
  Cost single = cost_of_single (kind), costs[2];
  g_autofree char *study = write_study (kind, cases);
  g_autofree char *alone = g_strdup_printf ("%s/%s-1", folder, kind);
  g_autofree char *together = g_strdup_printf ("%s/%s-2", folder, kind);
  const char *const into[] = { alone, together };
  for (int jobs = 1; jobs <= 2; jobs++) {
    g_autofree char *count = g_strdup_printf ("%d", jobs);
    command_of (command, study, into[jobs - 1], count);
    costs[jobs - 1] = run (command);
    bench_csv_row (csv, "%s,%d,%d,%.2f,%.2f,%.4f", kind, cases, jobs,
                   costs[jobs - 1].seconds, costs[jobs - 1].elapsed, single.seconds);
  }
  g_autofree char *one = dup_values (into[0]);
  g_autofree char *two = dup_values (into[1]);
  gboolean same = strcmp (one, two) == 0 && is_same_after_kill (study, into[0], cases);
  bench_bar (bars, "same table by two processes and after kill -9", kind, same,
             BENCH_AT_LEAST, 1);
  if (g_str_equal (kind, "limit"))
    bench_bar (bars, "single run / case (processor time)", kind,
               single.seconds * cases / costs[0].seconds, BENCH_AT_LEAST, BAR);
  bench_bar (bars, "speed-up by 2 processes", kind, costs[0].elapsed / costs[1].elapsed,
             BENCH_AT_LEAST, SPEED_UP);
  g_autofree char *killed = g_build_filename (folder, "killed", NULL);
  remove_folder (killed);
  return same;
}

/* Instructions of a case: what so many of them more cost. */
static double
count_cases (int cases)
{
  const char *command[9];
  g_autofree char *study = write_study ("limit", cases);
  g_autofree char *into = g_strdup_printf ("%s/counted-%d", folder, cases);
  command_of (command, study, into, "1");
  return count_processes (command);
}

static gboolean
compare_instructions (FILE *bars, int counted)
{
  g_autofree char *project = example ("ferris-tin-loi/wall3.quoin");
  const char *const command[] = { g_getenv ("QUOIN_CLI"), "limit", project, NULL };
  double single = count_processes (command);
  if (single == 0)
    return TRUE; /* cannot be counted here */
  double one = (count_cases (2 * counted) - count_cases (counted)) / counted;
  printf ("# %.1f million instructions a run, %.1f a case\n", 1e-6 * single, 1e-6 * one);
  return bench_bar (bars, "single run / case (instructions)", "limit", single / one,
                    BENCH_AT_LEAST, INSTRUCTIONS);
}

int
main (int argc, char **argv)
{
  int cases = 1000, solve = 1000, counted = 40;
  gboolean check = FALSE;
  const GOptionEntry entries[] = {
    { "cases", 0, 0, G_OPTION_ARG_INT, &cases, "Cases by limit (1000)", "N" },
    { "solve", 0, 0, G_OPTION_ARG_INT, &solve, "Cases by solve (1000)", "N" },
    { "counted", 0, 0, G_OPTION_ARG_INT, &counted, "Cases to count (40)", "N" },
    { "check", 0, 0, G_OPTION_ARG_NONE, &check, "Fail below the bars", NULL },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_autoptr (GError) error = NULL;
  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error) || argc > 1) {
    fprintf (stderr, "bench-study: %s\n", error != NULL ? error->message : argv[1]);
    return 2;
  }
  folder = g_dir_make_tmp ("quoin-study-XXXXXX", NULL);
  FILE *csv = bench_csv_open (
    "study", "run,cases,processes,processor_seconds,elapsed_seconds,single_seconds");
  FILE *bars = bench_bars_open ("study");
  gboolean met = compare_instructions (bars, counted);
  met &= measure (csv, bars, "limit", cases);
  met &= measure (csv, bars, "solve", solve);
  fclose (csv);
  fclose (bars);
  remove_folder (folder);
  g_free (folder);
  return check && !met;
}
