/* The stress tests: what is likely to break a solver, and what came of it.
 *
 *   stress [--long] [--seed N] [--count N] [--only PATTERN]… [--write FOLDER]
 *          [--markdown FILE] [--seconds N] [--jobs N] [--list]
 *
 * Without options: the quick set and its share of random walls. --long takes every case and a
 * thousand walls. --only repeats single cases, "random-137" or "kn=*"; with --write they, and
 * otherwise those that fail, are written out as project files to be solved by hand. */
#include "stress/cases.h"
#include "stress/process.h"
#include "stress/report.h"
#include "stress/run.h"

#include <locale.h>
#include <stdio.h>
#include <string.h>

#define QUICK_WALLS 60
#define LONG_WALLS  1000

/* Everything in the file of --markdown after this line is written anew. */
#define MARK "<!-- written by tests/stress -->\n"

static gboolean all_cases, list_only;
static int seed = 1, count = -1, seconds = 300, jobs = 1;
static char **only, *folder, *markdown;

static const GOptionEntry entries[] = {
  { "long", 0, 0, G_OPTION_ARG_NONE, &all_cases, "Every case, and 1000 walls", NULL },
  { "seed", 0, 0, G_OPTION_ARG_INT, &seed, "Seed of the first random wall", "N" },
  { "count", 0, 0, G_OPTION_ARG_INT, &count, "Random walls", "N" },
  { "only", 0, 0, G_OPTION_ARG_STRING_ARRAY, &only, "Cases of this name (* and ?)",
    "PATTERN" },
  { "write", 0, 0, G_OPTION_ARG_FILENAME, &folder, "Write projects of faulty cases here",
    "FOLDER" },
  { "markdown", 0, 0, G_OPTION_ARG_FILENAME, &markdown, "Write the tables to this file",
    "FILE" },
  { "seconds", 0, 0, G_OPTION_ARG_INT, &seconds, "Processor time of a case", "N" },
  { "jobs", 0, 0, G_OPTION_ARG_INT, &jobs, "Cases at a time", "N" },
  { "list", 0, 0, G_OPTION_ARG_NONE, &list_only, "Name the cases, run none", NULL },
  G_OPTION_ENTRY_NULL,
};

/* A random wall that is asked for by its seed need not be among those of --count. */
static void
add_named_walls (GArray *cases)
{
  for (char **name = only; name != NULL && *name != NULL; name++)
    if (g_str_has_prefix (*name, "random-") && strpbrk (*name, "*?") == NULL)
      stress_cases_add_random (cases, (guint32) g_ascii_strtoull (*name + 7, NULL, 10),
                               1);
}

static bool
is_wanted (const StressCase *c)
{
  bool random = c->build == stress_case_build_random;

  for (char **pattern = only; pattern != NULL && *pattern != NULL; pattern++)
    if (g_pattern_match_simple (*pattern, c->name))
      return true;
  return only == NULL && (random || all_cases || c->brief);
}

static GArray *
choose_cases (void)
{
  g_autoptr (GArray) cases = stress_cases_new ();
  GArray *chosen = g_array_new (FALSE, FALSE, sizeof (StressCase));
  int walls = count >= 0 ? count : all_cases ? LONG_WALLS : QUICK_WALLS;

  if (only == NULL || count >= 0)
    stress_cases_add_random (cases, (guint32) seed, (guint) walls);
  else
    add_named_walls (cases);
  for (guint i = 0; i < cases->len; i++) {
    const StressCase *c = &g_array_index (cases, StressCase, i);
    if (is_wanted (c))
      g_array_append_val (chosen, *c);
  }
  return chosen;
}

static void
write_projects (const StressCase *c)
{
  static const char *const flows[] = { "associative", "sliding" };

  for (int flow = 0; flow < STRESS_FLOW_COUNT; flow++) {
    g_autoptr (GError) error = NULL;
    g_autofree char *name = g_strdup_printf ("%s-%s.quoin", c->name, flows[flow]);
    g_strdelimit (name, "/", '-');
    g_autofree char *path = g_build_filename (folder, name, NULL);
    if (!stress_write_project (c, (StressFlow) flow, path, &error))
      g_error ("%s", error->message);
  }
}

/* What stands in the file before the tables, up to and with the mark that they begin after. */
static char *
dup_introduction (void)
{
  char *text = NULL;

  if (!g_file_get_contents (markdown, &text, NULL, NULL))
    return g_strdup (MARK);
  char *mark = strstr (text, MARK);
  if (mark == NULL) {
    g_free (text);
    return g_strdup (MARK);
  }
  mark[strlen (MARK)] = '\0';
  return text;
}

static void
write_markdown (const GArray *rows)
{
  g_autoptr (GString) text = g_string_new (NULL);
  g_autoptr (GError) error = NULL;
  g_autofree char *introduction = dup_introduction ();

  g_string_append_printf (text, "%s\n", introduction);
  stress_report_markdown (text, rows, all_cases ? "stress --long" : "stress");
  if (!g_file_set_contents (markdown, text->str, (gssize) text->len, &error))
    g_error ("%s", error->message);
}

/* Runs every case, `jobs` at a time; returns how many failed. */
static int
run_all (const GArray *cases)
{
  g_autoptr (GArray) rows = g_array_new (FALSE, FALSE, sizeof (StressEntry));
  g_autofree StressProcess *processes = g_new (StressProcess, cases->len + 1);
  guint started = 0;
  int failed = 0;

  for (guint i = 0; i < cases->len; i++) {
    StressEntry entry = { .c = &g_array_index (cases, StressCase, i) };
    for (; started < cases->len && started < i + (guint) MAX (1, jobs); started++)
      processes[started] =
        stress_process_start (&g_array_index (cases, StressCase, started), seconds);
    stress_process_finish (&processes[i], &entry.row);
    failed += stress_report_tap (&entry, i + 1);
    if (folder != NULL && (only != NULL || stress_row_faults (&entry.row) != 0))
      write_projects (entry.c);
    g_array_append_val (rows, entry);
  }
  printf ("1..%u\n", cases->len);
  if (markdown != NULL)
    write_markdown (rows);
  return failed;
}

int
main (int argc, char **argv)
{
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_autoptr (GError) error = NULL;

  setlocale (LC_ALL, "C.UTF-8");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    fprintf (stderr, "stress: %s\n", error->message);
    return 2;
  }
  if (folder != NULL && g_mkdir_with_parents (folder, 0777) != 0) {
    fprintf (stderr, "stress: %s: cannot be made\n", folder);
    return 2;
  }
  g_autoptr (GArray) cases = choose_cases ();
  for (guint i = 0; i < cases->len && list_only; i++)
    printf ("%s\n", g_array_index (cases, StressCase, i).name);
  return !list_only && run_all (cases) > 0 ? 1 : 0;
}
