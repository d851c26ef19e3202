/* What compares numbers so that NaN passes, prints them or names as they are, and a double that becomes an
 * integer without a bound.
 *
 * A double becomes an integer in core/base/integer.h alone, where every value has a result. What
 * text can show is looked for here: casts of functions that give doubles, and functions of libm
 * that give integers. Casts of variables are found by clang's float-cast-overflow as they run, and
 * conversions without a cast by -Wfloat-conversion. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

#define INTEGERS                                                                         \
  "(?:g?u?int(?:8|16|32|64)?(?:_t)?|g?size_t|gs?size|g?u?long|unsigned(?: char| int)?|"  \
  "guint8|QnId|GLint|GLsizei|png_uint_32|GstClockTime)"
#define DOUBLES                                                                          \
  "(?:round|floor|ceil|trunc|nearbyint|rint|fmin|fmax|fabs|sqrt|pow|exp|log|log10|"      \
  "log2|hypot|strtod|g_ascii_strtod|atof|[a-z_]+_entry_get_value)"

static const char pattern[] = "\\b(?:ll|l)r(?:ound|int)f? ?\\(|\\(" INTEGERS
                              "\\) ?-?(?:" DOUBLES " ?\\(|[a-z_]+->valuedouble)";

/* fmax() drops NaN, and an iteration that goes on while something is larger than its tolerance ends with
 * NaN as if it had converged. */
static const char drops_nan[] = "\\b(?:worst|error|excess|residual|relative) = fmax \\(";
static const char ends_with_nan[] =
  "\\b(?:for|while) \\(.*[^-=]> [^=;]*(?:tolerance|TOLERANCE)";

static void
check_text (const char *path, char **lines, GString *complaints)
{
  static const char *const patterns[][2] = {
    { pattern, "use qn_to_integer()" },
    { drops_nan, "use qn_worse()" },
    { "^(?! \\*).*(?<![a-z_])printf \\(",
      "use qn_print(): a name may hold a line break" },
    { ends_with_nan, "go on while not (… <= …): else NaN has converged" },
  };
  for (gsize k = 0; k < G_N_ELEMENTS (patterns); k++) {
    g_autoptr (GRegex) regex = g_regex_new (patterns[k][0], G_REGEX_OPTIMIZE, 0, NULL);
    for (guint i = 0; lines[i] != NULL; i++)
      if (g_regex_match (regex, lines[i], 0, NULL))
        complain (complaints, "%s:%u: %s", path, i + 1, patterns[k][1]);
  }
}

static void
test_sources (void)
{
  static const char *const suffixes[] = { ".c", ".h", NULL };
  GString *complaints = g_string_new (NULL);
  g_autoptr (GPtrArray) files = source_tree_files ("src", suffixes);
  g_assert_cmpuint (files->len, >, 100);
  for (guint i = 0; i < files->len; i++) {
    g_auto (GStrv) lines = source_tree_lines (files->pdata[i]);
    check_text (files->pdata[i], lines, complaints);
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  static const char *const wrong[] = {
    "  int n = (int) ceil (x);",
    "  n = (uint8_t) fmax (0, x);",
    "  n = lround (x);",
    "  return (guint) position->valuedouble;",
    "  s = (int32_t) -floor (x);",
    "  worst = fmax (worst, fabs (x));",
    "  while (x > tolerance)",
    "  printf (\"%s\", name);",
    "  for (int i = 0; s->left > s->tolerance; i++) {",
  };
  for (guint i = 0; i < G_N_ELEMENTS (wrong); i++) {
    char *lines[] = { (char *) wrong[i], NULL };
    GString *complaints = g_string_new (NULL);
    check_text ("wrong.c", lines, complaints);
    assert_complaint (complaints, "wrong.c:1");
  }
  char *right[] = { (char *) "  n = (int) qn_to_integer (round (x), 0, 9);",
                    (char *) "  double y = round ((double) n);",
                    (char *) "  while (!(x <= tolerance))", NULL };
  GString *complaints = g_string_new (NULL);
  check_text ("right.c", right, complaints);
  assert_no_complaints (complaints);
}

QN_TESTS
{
  g_test_add_func ("/checks/conversions/sources", test_sources);
  g_test_add_func ("/checks/conversions/can-fail", test_check_can_fail);
}
