#include "bench/compare.h"

#include "support/scratch.h"

#include <glib/gstdio.h>

#define HEADINGS                                                                         \
  "wall,dilatancy,procedure,increments,tolerance,relaxation,outcome,multiplier,"         \
  "error %,time s,time/kernel,factorisations\n"
#define ROW "1,0,load,30,0.0001,on,collapse,0.640000,-0.2000,0.01,1.00,100\n"

/* Two folders, each with one table. */
typedef struct Fixture {
  char *folder, *before, *after, *said;
  CompareVerdict verdict;
} Fixture;

static void
write_table (const char *folder, const char *name, const char *text)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_assert_cmpint (g_mkdir_with_parents (folder, 0777), ==, 0);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static void
set_up (Fixture *f)
{
  *f = (Fixture){ .folder = test_scratch_new () };
  f->before = g_build_filename (f->folder, "before", NULL);
  f->after = g_build_filename (f->folder, "after", NULL);
}

static void
tear_down (Fixture *f)
{
  test_scratch_free (f->folder);
  g_free (f->before);
  g_free (f->after);
  g_free (f->said);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Fixture, tear_down)

static gboolean
compare (Fixture *f, gboolean partial, GError **error)
{
  CompareMargins margins = compare_margins_default ();
  g_autofree char *path = g_build_filename (f->folder, "said", NULL);
  FILE *out = g_fopen (path, "w");
  g_assert_nonnull (out);
  gboolean ok =
    compare_folders (f->before, f->after, &margins, partial, out, &f->verdict, error);
  fclose (out);
  g_free (f->said);
  g_assert_true (g_file_get_contents (path, &f->said, NULL, NULL));
  return ok;
}

/* Compares a table before and after. */
static void
compare_tables (Fixture *f, const char *name, const char *before, const char *after)
{
  set_up (f);
  write_table (f->before, name, before);
  write_table (f->after, name, after);
  g_assert_true (compare (f, FALSE, NULL));
}

/* Rows of walls.csv before and after. */
static void
check_rows (const char *before, const char *after, int worse, int better)
{
  g_auto (Fixture) f;
  g_autofree char *old = g_strconcat (HEADINGS, before, NULL);
  g_autofree char *new = g_strconcat (HEADINGS, after, NULL);
  compare_tables (&f, "walls.csv", old, new);
  if (f.verdict.worse != worse || f.verdict.better != better)
    g_error ("%s -> %s: %s", before, after, f.said);
}

/* What becomes of a row when `what` in it is replaced by `by`. */
static void
check_change_of (const char *before, const char *what, const char *by, int worse,
                 int better)
{
  g_autoptr (GString) after = g_string_new (before);
  g_assert_cmpuint (g_string_replace (after, what, by, 1), ==, 1);
  check_rows (before, after->str, worse, better);
}

static void
check_change (const char *what, const char *by, int worse, int better)
{
  check_change_of (ROW, what, by, worse, better);
}

static void
test_equal (void)
{
  check_change ("collapse", "collapse", 0, 0);
  check_change ("0.01,", "99,", 0, 0); /* plain seconds */
}

static void
test_counts (void)
{
  check_change (",100\n", ",101\n", 1, 0);
  check_change (",100\n", ",99\n", 0, 1);
}

static void
test_multipliers (void)
{
  static const char row[] =
    "1,0,load,30,0.0001,on,collapse,0.640000,+nan,0.01,1.00,100\n";
  check_change_of (row, "0.640000", "0.639000", 1, 0);
  check_change_of (row, "0.640000", "0.639500", 0, 0);
  check_change_of (row, "0.640000", "0.641000", 0, 1);
  check_change ("0.640000", "0.639000", 0, 0); /* the error rules */
  check_change ("-0.2000", "+0.3100", 1, 0);
  check_change ("-0.2000", "+0.2500", 0, 0);
  check_change ("-0.2000", "-0.0500", 0, 1);
}

/* A run with a tolerance of 1e-2 may be off by twice that. */
static void
test_tolerance (void)
{
  check_rows ("1,0,load,30,0.01,on,collapse,0.64,-0.2,0.01,1,100\n",
              "1,0,load,30,0.01,on,collapse,0.63,-1.7,0.01,1,100\n", 0, 0);
}

static void
test_times (void)
{
  check_change ("1.00,", "1.50,", 0, 0);
  check_change ("1.00,", "1.70,", 1, 0);
  check_change ("1.00,", "0.50,", 0, 1);
}

/* Too short to be measured, on either side; what is longer than that counts from there. */
static void
test_short_times (void)
{
  check_rows ("1,0,load,30,0.0001,on,collapse,0.64,0,0.01,0.01,100\n"
              "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,0.01,100\n",
              "1,0,load,30,0.0001,on,collapse,0.64,0,0.01,0.29,100\n"
              "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,0.31,100\n",
              0, 0);
}

/* No time is much longer, but all of them are. */
static void
test_mean_time (void)
{
  check_rows ("1,0,load,30,0.0001,on,collapse,0.64,0,0.01,1,100\n"
              "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,1,100\n",
              "1,0,load,30,0.0001,on,collapse,0.64,0,0.01,1.4,100\n"
              "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,1.4,100\n",
              1, 0);
}

static void
test_outcomes (void)
{
  /* An answer lost is one fault, not three: its counts say nothing. */
  check_change ("collapse,0.64", "cancelled,0.30", 1, 0);
  check_change ("collapse", "target-reached", 1, 0);
}

/* What the clock stopped both times says nothing; an answer gained is better. */
static void
test_time_limits (void)
{
  check_rows ("1,0,load,30,0.0001,on,cancelled,0.64,0,0.01,1,100\n"
              "2,0,load,30,0.0001,on,cancelled,0.64,0,0.01,1,100\n",
              "1,0,load,30,0.0001,on,cancelled,0.32,-50,0.01,9,999\n"
              "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,1,100\n",
              0, 1);
}

/* Several outcomes in one table: each speaks for its own columns; limit analysis is exact. */
static void
test_prefixes (void)
{
  static const char headings[] =
    "kind,blocks,limit outcome,limit multiplier,path outcome,"
    "path multiplier,path factorisations\n";
  g_auto (Fixture) f;
  g_autofree char *before =
    g_strconcat (headings, "wall,199,collapse,0.5,cancelled,0.1,50\n", NULL);
  g_autofree char *after =
    g_strconcat (headings, "wall,199,collapse,0.500002,cancelled,0.05,70\n", NULL);
  compare_tables (&f, "scaling.csv", before, after);
  g_assert_cmpint (f.verdict.worse, ==, 1);
  g_assert_nonnull (strstr (f.said, "limit multiplier 0.5 -> 0.500002"));
}

static void
test_rows (void)
{
  g_auto (Fixture) f;
  compare_tables (&f, "walls.csv", HEADINGS ROW,
                  HEADINGS "2,0,load,30,0.0001,on,collapse,0.64,0,0.01,1,100\n");
  g_assert_cmpint (f.verdict.missing, ==, 1);
  g_assert_cmpint (f.verdict.added, ==, 1);
  g_assert_true (compare (&f, TRUE, NULL));
  g_assert_cmpint (f.verdict.missing, ==, 0);
}

/* Commas within quotes, and the bars that are met or missed. */
static void
test_bars (void)
{
  g_auto (Fixture) f;
  compare_tables (&f, "scaling-bars.csv",
                  "bar,case,value,met\n\"time, s\",wall,3,yes\nx,wall,1,no\n",
                  "bar,case,value,met\n\"time, s\",wall,9,no\nx,wall,1,yes\n");
  g_assert_cmpint (f.verdict.worse, ==, 1);
  g_assert_cmpint (f.verdict.better, ==, 1);
  g_assert_cmpint (f.verdict.missing, ==, 0);
}

static void
test_unreadable (void)
{
  g_auto (Fixture) f;
  g_autoptr (GError) error = NULL;
  set_up (&f);
  g_assert_false (compare (&f, FALSE, &error));
  g_assert_error (error, G_FILE_ERROR, G_FILE_ERROR_NOENT);
  g_clear_error (&error);
  write_table (f.before, "walls.csv", HEADINGS ROW);
  g_assert_false (compare (&f, FALSE, &error)); /* the other one is not there */
  g_clear_error (&error);
  write_table (f.after, "walls.csv", "");
  g_assert_false (compare (&f, FALSE, &error));
  g_assert_error (error, G_FILE_ERROR, G_FILE_ERROR_INVAL);
}

static int
run_program (const char *before, const char *after)
{
  const char *argv[] = { g_getenv ("QUOIN_BENCH_COMPARE"), before, after, NULL };
  int status;
  g_assert_true (g_spawn_sync (NULL, (char **) argv, NULL,
                               G_SPAWN_STDOUT_TO_DEV_NULL | G_SPAWN_STDERR_TO_DEV_NULL,
                               NULL, NULL, NULL, NULL, &status, NULL));
  g_assert_true (WIFEXITED (status));
  return WEXITSTATUS (status);
}

static void
test_exit_codes (void)
{
  g_auto (Fixture) f;
  set_up (&f);
  write_table (f.before, "walls.csv", HEADINGS ROW);
  write_table (f.after, "walls.csv",
               HEADINGS "1,0,load,30,0.0001,on,collapse,0.64,-0.2,0.01,1,101\n");
  g_assert_cmpint (run_program (f.before, f.before), ==, 0);
  g_assert_cmpint (run_program (f.before, f.after), ==, 1);
  g_assert_cmpint (run_program (f.before, NULL), ==, 2);
  g_assert_cmpint (run_program (f.before, f.folder), ==, 5);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/bench/compare/equal", test_equal);
  g_test_add_func ("/bench/compare/counts", test_counts);
  g_test_add_func ("/bench/compare/multipliers", test_multipliers);
  g_test_add_func ("/bench/compare/tolerance", test_tolerance);
  g_test_add_func ("/bench/compare/times", test_times);
  g_test_add_func ("/bench/compare/short-times", test_short_times);
  g_test_add_func ("/bench/compare/mean-time", test_mean_time);
  g_test_add_func ("/bench/compare/outcomes", test_outcomes);
  g_test_add_func ("/bench/compare/time-limits", test_time_limits);
  g_test_add_func ("/bench/compare/prefixes", test_prefixes);
  g_test_add_func ("/bench/compare/rows", test_rows);
  g_test_add_func ("/bench/compare/bars", test_bars);
  g_test_add_func ("/bench/compare/unreadable", test_unreadable);
  g_test_add_func ("/bench/compare/exit-codes", test_exit_codes);
  return g_test_run ();
}
