/* quoin-cli law: tables, pictures, and what is refused. */
#include "cli-run.h"
#include "support/room.h"

#include <stdlib.h>
#include <string.h>

static const char *const kinds[] = { "elastic",  "no-tension",      "coulomb",
                                     "bilinear", "elastic-plastic", "concrete",
                                     "steel",    "curve",           "mohr-coulomb" };

/* Every kind has a picture and a table. */
static void
test_kinds (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *csv = g_build_filename (folder, "law.csv", NULL);
    g_autofree char *png = g_build_filename (folder, "law.png", NULL);
    cli_do ("law", kinds[i], "--plot", png, "--csv", csv, "--size", "400x300", NULL);
    g_autofree char *table = cli_read (csv);
    g_assert_true (g_str_has_prefix (table, "normal elongation ["));
    g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
    g_assert_cmpuint (g_strv_length (lines), >, 100);
    g_autofree char *picture = NULL;
    gsize length = 0;
    g_assert_true (g_file_get_contents (png, &picture, &length, NULL));
    g_assert_cmpuint (length, >, 1000);
    g_assert_true (memcmp (picture, "\x89PNG", 4) == 0);
  }
}

/* Column `column` of the last row of a table on standard output. */
static double
last_value (const char *table, int column)
{
  g_auto (GStrv) lines = g_strsplit (table, "\n", -1);
  g_auto (GStrv) fields = g_strsplit (lines[g_strv_length (lines) - 2], ",", -1);
  return g_ascii_strtod (fields[column], NULL);
}

/* Numbers: 10 at yield, a tenth of 100 beyond, unloading by 100. */
static void
test_numbers (void)
{
  g_auto (CliRun) run =
    cli_run ("law", "bilinear", "--set", "kn=100", "--set", "yield=10", "--set",
             "hardening=0.1", "--path", "0.3,0.25", NULL);
  cli_assert_done (&run);
  g_assert_cmpfloat_with_epsilon (last_value (run.out, 0), 0.25, 1e-12);
  g_assert_cmpfloat_with_epsilon (last_value (run.out, 2), 12 - 5, 1e-9);
  g_assert_cmpfloat_with_epsilon (last_value (run.out, 4), 100, 1e-9);
}

/* A law of a project. */
static void
test_of_project (void)
{
  g_autofree char *example = cli_example ("08-plastic-cantilever.quoin");
  CliRun run = cli_run ("law", "material", "--model", example, "--path", "0.01", NULL);
  cli_assert_done (&run);
  g_assert_cmpfloat_with_epsilon (last_value (run.out, 2), 20e6, 1e-3);
  cli_run_clear (&run);
  cli_fails (3, "no law is called", "law", "stone", "--model", example, NULL);
}

static void
test_refused (void)
{
  const struct {
    const char *name, *option, *value;
    int code;
    const char *message;
  } cases[] = {
    { "plastic", "--path", "1", 2, "no law is called" },
    { "steel", "--set", "friction=1", 2, "has no" },
    { "steel", "--set", "yield", 2, "KEY=VALUE" },
    { "steel", "--set", "yield=much", 2, "is not a number" },
    { "steel", "--set", "basis=volume", 2, "no basis is called" },
    { "steel", "--set", "yield=-1", 3, "yield: number must be positive" },
    { "steel", "--path", "1,x", 2, "--path" },
    { "steel", "--length", "0", 2, "--length" },
    { "concrete", "--length", "3", 3, "fracture energy is too small" },
    { "steel", "--plot", "law.xyz", 2, NULL },
    { "steel", "--csv", "/nowhere/law.csv", 5, NULL },
    { "steel", "--model", "/nowhere/wall.quoin", 5, NULL },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++)
    cli_fails (cases[i].code, cases[i].message, "law", cases[i].name, cases[i].option,
               cases[i].value, NULL);
}

/* --detail pairs adds hinge and springs to every contact, and nothing else does. */
static void
test_detail (void)
{
  g_autofree char *example = cli_example ("10-soft-on-stiff.quoin");
  CliRun run = cli_run ("solve", example, "-q", "-o", "-", "--detail", "pairs", NULL);
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, "\"hinge\": ["));
  g_assert_nonnull (strstr (run.out, "\"springs\": [{ \"elongation\": ["));
  cli_run_clear (&run);
  run = cli_run ("solve", example, "-q", "-o", "-", NULL);
  cli_assert_done (&run);
  g_assert_null (strstr (run.out, "\"hinge\""));
  cli_run_clear (&run);
  cli_fails (2, "--detail", "solve", example, "--detail", "all", NULL);
}

/* Limit analysis has no rows for the strengths of fibres, and says so. */
static void
test_no_limit (void)
{
  g_autofree char *example = cli_example ("08-plastic-cantilever.quoin");
  cli_fails (3, "laws[0].kind: limit analysis", "limit", example, NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/law/kinds", test_kinds);
  g_test_add_func ("/cli/law/numbers", test_numbers);
  g_test_add_func ("/cli/law/of-project", test_of_project);
  g_test_add_func ("/cli/law/refused", test_refused);
  g_test_add_func ("/cli/law/detail", test_detail);
  g_test_add_func ("/cli/law/no-limit", test_no_limit);
}
