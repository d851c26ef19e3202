/* How the work of reading a project grows with what a file says besides the model, and that of reading a
 * drawing with its style sheet, in instructions.
 *
 *   test-io-project-work --read KIND COUNT
 *
 * reads a file once: what runs under callgrind. */
#include "io/exchange/drawing.h"
#include "io/project/project.h"

#include "support/instructions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Twice as much to read takes twice the work; sorting and hashing would add little. */
#define MOST_GROWTH 1.1

#define FEW  250
#define MANY 4000

/* "k1": 1, "k2": 2, … */
static char *
make_members (int count)
{
  GString *json = g_string_new (NULL);
  for (int i = 0; i < count; i++)
    g_string_append_printf (json, ", \"k%d\": %d", i, i);
  return g_string_free (json, FALSE);
}

/* Loads, each with a key that no layer knows. */
static char *
make_loads (int count)
{
  GString *json = g_string_new (NULL);
  for (int i = 0; i < count; i++)
    g_string_append_printf (json,
                            "%s{ \"kind\": \"force\", \"block\": \"a\","
                            " \"value\": [1, 0], \"origin\": %d }",
                            i > 0 ? ", " : "", i);
  return g_string_free (json, FALSE);
}

/* Rectangles, each with two classes of its own and rules for them, and with what all rules are for. */
static int
read_styles (int count)
{
  g_autoptr (GString) text = g_string_new ("<svg><style>");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, "/* %d */ rect.c%d, .d%d, rect { fill: #%06d }\n", i, i,
                            i, i);
  g_string_append (text, "</style>");
  for (int i = 0; i < count; i++)
    g_string_append_printf (text, "<rect class=\"c%d d%d\" width=\"1\"/>\n", i, i);
  g_string_append (text, "</svg>");
  g_autoptr (GError) error = NULL;
  g_auto (QnDrawing) drawing;
  qn_drawing_read (qn_svg_import, text->str, text->len, "many", &drawing, &error);
  g_assert_no_error (error);
  g_assert_cmpint (drawing.paths->len, ==, count);
  return 0;
}

static int
read_once (const char *kind, int count)
{
  if (g_str_equal (kind, "styles"))
    return read_styles (count / 10);
  g_autofree char *members = make_members (count), *loads = make_loads (count);
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [ { \"name\": \"dry\","
    " \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.6%s } ],"
    " \"contact\": { \"law\": \"dry\" }, \"blocks\": [ { \"name\": \"a\","
    " \"vertices\": [[0,0],[1,0],[1,1],[0,1]], \"thickness\": 1, \"unit_weight\": 1e4%s"
    " } ], \"loads\": { \"live\": [%s] }%s }",
    g_str_equal (kind, "law") ? members : "", g_str_equal (kind, "block") ? members : "",
    g_str_equal (kind, "loads") ? loads : "",
    g_str_equal (kind, "document") ? members : "");
  g_autoptr (GError) error = NULL;
  g_auto (QnProject) project;
  qn_project_parse (text, strlen (text), "many", NULL, &project, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (project.warnings->len, >, 100);
  return 0;
}

static const char *self;

static void
test_growth (gconstpointer kind)
{
  double work[2];
  for (int i = 0; i < 2; i++) {
    const char *const arguments[] = { self, "--read", kind,
                                      i == 0 ? G_STRINGIFY (FEW) : G_STRINGIFY (MANY),
                                      NULL };
    work[i] = count_instructions (
      arguments, g_str_equal (kind, "styles") ? "qn_svg_import" : "qn_project_parse",
      NULL);
  }
  if (work[0] == 0) {
    g_test_skip ("instructions cannot be counted here");
    return;
  }
  double growth = log (work[1] / work[0]) / log ((double) MANY / FEW);
  g_test_message ("%s: %.0f instructions each, exponent %.3f", (const char *) kind,
                  work[1] / MANY, growth);
  g_assert_cmpfloat (work[0], >, 100 * FEW); /* something was counted */
  g_assert_cmpfloat (growth, <=, MOST_GROWTH);
}

int
main (int argc, char **argv)
{
  static const char *const kinds[] = { "document", "law", "block", "loads", "styles" };
  if (argc == 4 && g_str_equal (argv[1], "--read"))
    return read_once (argv[2], atoi (argv[3]));
  self = argv[0];
  g_test_init (&argc, &argv, NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = g_strconcat ("/project-work/", kinds[i], NULL);
    g_test_add_data_func (path, kinds[i], test_growth);
  }
  return g_test_run ();
}
