#include "bench/report-tables.h"

#include <glib/gstdio.h>

static const char csv[] = "kind,blocks,time s,\"part, of\"\n"
                          "wall,199,0.5,1\n"
                          "façade,182,nan,2\n"
                          "wall,799,1.5,3\n";

/* What becomes of a text; NULL where it is refused. */
static char *
write_anew (const char *text)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-tables-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "sizes.csv", NULL);
  g_autoptr (GError) error = NULL;
  g_assert_true (g_file_set_contents (path, csv, -1, NULL));
  char *written = report_tables_dup (text, folder, &error);
  g_assert_true ((written == NULL) == (error != NULL));
  g_remove (path);
  g_remove (folder);
  return written;
}

static void
test_columns (void)
{
  g_autofree char *written =
    write_anew ("before\n<!-- table sizes: kind | time s = s | part, of -->\n"
                "| old |\n<!-- end -->\nafter\n");
  g_assert_cmpstr (written, ==,
                   "before\n<!-- table sizes: kind | time s = s | part, of -->\n"
                   "| kind | s | part, of |\n| --- | --- | --- |\n"
                   "| wall | 0.5 | 1 |\n| façade | – | 2 |\n| wall | 1.5 | 3 |\n"
                   "<!-- end -->\nafter\n");
}

static void
test_conditions (void)
{
  g_autofree char *written = write_anew (
    "<!-- table sizes where kind is wall, time s is 1.5: blocks -->\n<!-- end -->\n"
    "<!-- table sizes where kind is façade: blocks -->\n<!-- end -->\n");
  g_assert_cmpstr (written, ==,
                   "<!-- table sizes where kind is wall, time s is 1.5: blocks -->\n"
                   "| blocks |\n| --- |\n| 799 |\n<!-- end -->\n"
                   "<!-- table sizes where kind is façade: blocks -->\n"
                   "| blocks |\n| --- |\n| 182 |\n<!-- end -->\n");
}

/* Written twice is written once. */
static void
test_again (void)
{
  g_autofree char *once = write_anew ("<!-- table sizes: kind -->\n<!-- end -->\n");
  g_autofree char *twice = write_anew (once);
  g_assert_cmpstr (once, ==, twice);
}

static void
test_refused (void)
{
  g_assert_null (write_anew ("<!-- table sizes: kind -->\n"));
  g_assert_null (write_anew ("<!-- table sizes -->\n<!-- end -->\n"));
  g_assert_null (write_anew ("<!-- table sizes: colour -->\n<!-- end -->\n"));
  g_assert_null (write_anew ("<!-- table others: kind -->\n<!-- end -->\n"));
  g_assert_null (
    write_anew ("<!-- table sizes where colour is red: kind -->\n<!-- end -->\n"));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/bench/report-tables/columns", test_columns);
  g_test_add_func ("/bench/report-tables/conditions", test_conditions);
  g_test_add_func ("/bench/report-tables/again", test_again);
  g_test_add_func ("/bench/report-tables/refused", test_refused);
  return g_test_run ();
}
