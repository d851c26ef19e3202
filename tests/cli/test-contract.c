/* The command line's contract: help, version, usage errors and exit codes. */
#include "cli-run.h"
#include "support/room.h"

#include <string.h>

static const char *const subcommands[] = { "check",   "solve", "render",
                                           "compare", "curve", "verify" };

static void
test_help (void)
{
  CliRun run = cli_run ("--help", NULL);
  cli_assert_done (&run);
  for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++)
    g_assert_nonnull (strstr (run.out, subcommands[i]));
  cli_run_clear (&run);
}

static void
test_help_of_each (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++) {
    CliRun run = cli_run (subcommands[i], "--help", NULL);
    g_autofree char *usage = g_strconcat ("quoin-cli ", subcommands[i], NULL);
    cli_assert_done (&run);
    g_assert_nonnull (strstr (run.out, usage));
    cli_run_clear (&run);
  }
}

static void
test_version (void)
{
  CliRun run = cli_run ("--version", NULL);
  cli_assert_done (&run);
  g_assert_cmpstr (run.out, ==, "quoin " QN_VERSION "\n");
  cli_run_clear (&run);
}

static void
fails (int code, const char *part, const char *first, const char *second,
       const char *third)
{
  cli_fails (code, part, first, second, third, NULL);
}

static void
test_usage (void)
{
  fails (2, "subcommand is missing", NULL, NULL, NULL);
  fails (2, "slove", "slove", NULL, NULL);
  fails (2, "--colour", "--colour", NULL, NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (subcommands); i++)
    fails (2, "--no-such-option", subcommands[i], "--no-such-option", NULL);
  fails (2, "missing", "solve", NULL, NULL);
  fails (2, "missing", "check", NULL, NULL);
  fails (2, "too many", "solve", "a.quoin", "b.quoin");
  fails (2, "-o is missing", "render", "a.quoin", NULL);
  fails (2, "no group", "verify", "everything", NULL);
  fails (2, NULL, "solve", "-o", NULL);
}

static void
test_render_usage (void)
{
  g_autofree char *model = cli_example ("01-sliding-block.quoin");
  static const char *const wrong[][4] = {
    { "--view", "plan", "o.png", "plan" },
    { "--step", "-1", "o.png", "-1" },
    { "--step", "first", "o.png", "first" },
    { "--scale", "0", "o.png", "0" },
    { "--scale", "big", "o.png", "big" },
    { "--field", "colour", "o.png", "colour" },
    { "--backend", "vulkan", "o.png", "backend" },
    { "--size", "0x0", "o.png", NULL },
    { "--size", "1000000x1000000", "o.png", NULL },
    { "--size", "large", "o.png", NULL },
    { "--dpi", "-5", "o.png", "dpi" },
    { "--view", "model", "o.bmp", NULL },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (wrong); i++) {
    cli_fails (2, wrong[i][3], "render", model, wrong[i][0], wrong[i][1], "-o",
               wrong[i][2], NULL);
    g_assert_false (g_file_test (wrong[i][2], G_FILE_TEST_EXISTS));
  }
}

static void
test_missing_file (void)
{
  for (size_t i = 0; i < 2; i++)
    cli_fails (5, "/no/such/wall.quoin", subcommands[i], "/no/such/wall.quoin", NULL);
  cli_fails (5, "/no/such/wall.quoin", "compare", "/no/such/wall.quoin", "-o",
             "sheet.png", NULL);
}

static void
test_full_standard_output (gconstpointer arguments)
{
  g_autofree char *line = g_strdup_printf ("'%s' %s > /dev/full", g_getenv ("QUOIN_CLI"),
                                           (const char *) arguments);
  const char *command[] = { "/bin/sh", "-c", line, NULL };
  int status = 0;
  g_autoptr (GError) error = NULL;
  g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL,
                NULL, NULL, &status, &error);
  g_assert_no_error (error);
  g_assert_false (g_spawn_check_wait_status (status, &error));
  g_assert_error (error, G_SPAWN_EXIT_ERROR, 5);
}

/* A line break in a title or a name makes no line of the report. */
static void
test_forged_lines (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *titled = cli_replace (cli_sliding_block, "Sliding block",
                                         "A\\nwarnings: none\\u2028warnings: none");
  g_autofree char *text =
    cli_replace (titled, "\"name\": \"stone\"", "\"name\": \"b\\nwarnings: none\"");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  static const char *const runs[] = { "check", "solve", "limit" };
  for (gsize i = 0; i < G_N_ELEMENTS (runs); i++) {
    CliRun run = cli_run (runs[i], model, NULL);
    cli_assert_done (&run);
    g_assert_nonnull (strstr (run.out, "A\\u000awarnings: none\\u2028warnings: none"));
    g_assert_nonnull (strstr (run.out, "b\\u000awarnings: none"));
    const char *line = strstr (run.out, "\nwarnings: none");
    g_assert_true (line == NULL || strcmp (runs[i], "check") == 0);
    g_assert_true (line == NULL || strstr (line + 1, "\nwarnings: none") == NULL);
    cli_run_clear (&run);
  }
}

/* An escape sequence in a name reaches no terminal, and no picture's metadata. */
static void
test_escapes (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *text = cli_replace (cli_sliding_block, "Sliding block",
                                       "A\\u001b]0;x\\u0007\\u009b31m\\u202e&");
  g_autofree char *model = cli_write (folder, "m.quoin", text);
  g_autofree char *picture = g_build_filename (folder, "m.svg", NULL);
  CliRun run = cli_run ("check", model, NULL);
  cli_assert_done (&run);
  g_assert_true (g_str_has_prefix (run.out, "A\\u001b]0;x\\u0007\\u009b31m\\u202e&\n"));
  cli_run_clear (&run);
  cli_fails (5, "a\\u001b[31m b", "check", "a\033[31m\nb", NULL);

  cli_do ("render", model, "-o", picture, NULL);
  g_autofree char *svg = cli_read (picture);
  GMarkupParser nothing = { 0 };
  g_autoptr (GMarkupParseContext) context =
    g_markup_parse_context_new (&nothing, 0, NULL, NULL);
  g_assert_true (g_markup_parse_context_parse (context, svg, -1, NULL));
  g_assert_null (strstr (svg, "&#x"));
  g_assert_null (strstr (svg, "\033"));
  g_assert_nonnull (strstr (svg, "<title>A\357\277\275]0;x"));

  g_autofree char *named = cli_replace (cli_sliding_block, "\"name\": \"stone\"",
                                        "\"name\": \"b\\u001b[31m\\u009b1m\\u202e\"");
  g_autofree char *other = cli_write (folder, "named.quoin", named);
  static const char *const outputs[] = { "-o", "--csv" };
  for (gsize i = 0; i < G_N_ELEMENTS (outputs); i++) {
    run = cli_run ("solve", other, "-q", outputs[i], "-", NULL);
    cli_assert_done (&run);
    g_assert_null (strpbrk (run.out, "\033\007"));
    g_assert_null (strstr (run.out, "\302\233"));
    g_assert_null (strstr (run.out, "\342\200\256"));
    cli_run_clear (&run);
  }
}

/* No command writes over a file that it reads, or over its own other output. */
static void
test_same_file (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "m.quoin", cli_sliding_block);
  g_autofree char *other = g_build_filename (folder, ".", "m.quoin", NULL);
  static const char *const commands[] = { "solve", "limit", "modal", "import" };
  for (gsize i = 0; i < G_N_ELEMENTS (commands); i++) {
    cli_fails (2, "the same file", commands[i], model, "-o", other, NULL);
    test_scratch_expect (model, cli_sliding_block);
  }
}

/* Without times two runs give the same file. */
static void
test_no_timings (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *model = cli_write (folder, "m.quoin", cli_sliding_block);
  char *text[2];
  for (int i = 0; i < 2; i++) {
    g_autofree char *result = g_build_filename (folder, "r.json", NULL);
    cli_do ("solve", model, "--no-timings", "-o", result, NULL);
    text[i] = cli_read (result);
    g_assert_null (strstr (text[i], "seconds"));
    g_assert_nonnull (strstr (text[i], "\"factorizations\""));
    cli_do ("check", model, "--result", result, NULL);
  }
  g_assert_cmpstr (text[0], ==, text[1]);
  g_free (text[0]);
  g_free (text[1]);
}

/* Options that are no numbers. */
static void
test_numbers (void)
{
  cli_fails (2, "--until must be a finite number", "curve", "m.quoin", "--until", "nan",
             "-o", "c.png", NULL);
  cli_fails (2, "--length must be a finite number", "law", "m.quoin", "--length", "inf",
             NULL);
  for (size_t i = 0; i < 3; i++)
    cli_fails (2, "--dpi must be positive", "render", "m.quoin", "--size", "9mmx9mm",
               "--dpi", ((const char *[]){ "nan", "0", "90x" })[i], "-o", "a.png", NULL);
}

QN_TESTS
{
  g_test_add_func ("/cli/contract/help", test_help);
  g_test_add_func ("/cli/contract/help-of-each", test_help_of_each);
  g_test_add_func ("/cli/contract/version", test_version);
  g_test_add_func ("/cli/contract/usage", test_usage);
  g_test_add_func ("/cli/contract/render-usage", test_render_usage);
  g_test_add_func ("/cli/contract/missing-file", test_missing_file);
  g_test_add_data_func ("/cli/contract/full-standard-output", "--help",
                        test_full_standard_output);
  g_test_add_data_func ("/cli/contract/full-standard-output-help", "verify --help",
                        test_full_standard_output);
  g_test_add_func ("/cli/contract/escapes", test_escapes);
  g_test_add_func ("/cli/contract/forged-lines", test_forged_lines);
  g_test_add_func ("/cli/contract/same-file", test_same_file);
  g_test_add_func ("/cli/contract/numbers", test_numbers);
  g_test_add_func ("/cli/contract/no-timings", test_no_timings);
}
