/* The command line's contract: help, version, usage errors and exit codes. */
#include "cli-run.h"

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
  CliRun run = cli_run (first, second, third, NULL);
  cli_assert_failed (&run, code, part);
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
    { "--view", "mechanism", "o.png", "--result" },
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
    CliRun run =
      cli_run ("render", model, wrong[i][0], wrong[i][1], "-o", wrong[i][2], NULL);
    cli_assert_failed (&run, 2, wrong[i][3]);
    g_assert_false (g_file_test (wrong[i][2], G_FILE_TEST_EXISTS));
  }
}

static void
test_missing_file (void)
{
  for (size_t i = 0; i < 2; i++) {
    CliRun run = cli_run (subcommands[i], "/no/such/wall.quoin", NULL);
    cli_assert_failed (&run, 5, "/no/such/wall.quoin");
  }
  CliRun run = cli_run ("compare", "/no/such/wall.quoin", "-o", "sheet.png", NULL);
  cli_assert_failed (&run, 5, "/no/such/wall.quoin");
}

static void
test_full_standard_output (void)
{
  g_autofree char *line =
    g_strdup_printf ("'%s' --help > /dev/full", g_getenv ("QUOIN_CLI"));
  const char *command[] = { "/bin/sh", "-c", line, NULL };
  int status = 0;
  g_autoptr (GError) error = NULL;
  g_spawn_sync (NULL, (char **) command, NULL, G_SPAWN_STDERR_TO_DEV_NULL, NULL, NULL,
                NULL, NULL, &status, &error);
  g_assert_no_error (error);
  g_assert_false (g_spawn_check_wait_status (status, &error));
  g_assert_error (error, G_SPAWN_EXIT_ERROR, 5);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/cli/contract/help", test_help);
  g_test_add_func ("/cli/contract/help-of-each", test_help_of_each);
  g_test_add_func ("/cli/contract/version", test_version);
  g_test_add_func ("/cli/contract/usage", test_usage);
  g_test_add_func ("/cli/contract/render-usage", test_render_usage);
  g_test_add_func ("/cli/contract/missing-file", test_missing_file);
  g_test_add_func ("/cli/contract/full-standard-output", test_full_standard_output);
  return g_test_run ();
}
