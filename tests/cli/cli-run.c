#include "cli-run.h"

#include <gio/gio.h>
#include <string.h>
#include <sys/wait.h>

const char cli_sliding_block[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"Sliding block\",\n"
  "  \"laws\": [ { \"name\": \"joint\", \"kind\": \"coulomb\", \"basis\": \"contact\",\n"
  "    \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.4, \"cohesion\": 0, \"tension\": 0,\n"
  "    \"dilatancy\": 0 } ],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"ground\", \"vertices\": [[-1, -0.5], [2, -0.5], [2, 0], [-1, 0]],\n"
  "      \"thickness\": 1, \"unit_weight\": 10000, \"support\": [true, true, true] },\n"
  "    { \"name\": \"stone\", \"vertices\": [[0, 0], [1, 0], [1, 0.5], [0, 0.5]],\n"
  "      \"thickness\": 1, \"unit_weight\": 10000 }\n"
  "  ],\n"
  "  \"contact\": { \"law\": \"joint\", \"tolerance\": 1e-6,\n"
  "    \"pairs\": { \"placement\": \"ends\", \"offset\": 0 } },\n"
  "  \"loads\": {\n"
  "    \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],\n"
  "    \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] },\n"
  "  \"analysis\": { \"procedure\": \"load\", \"geometry\": \"linear\", \"increments\": "
  "10 }\n"
  "}\n";

CliRun
cli_run_with (const char *const *arguments, const char *variable, const char *value)
{
  CliRun run = { 0 };
  g_autoptr (GError) error = NULL;
  g_autoptr (GStrvBuilder) builder = g_strv_builder_new ();
  g_auto (GStrv) environment = g_get_environ ();
  int status = 0;

  g_strv_builder_add (builder, g_getenv ("QUOIN_CLI"));
  g_strv_builder_addv (builder, (const char **) arguments);
  g_auto (GStrv) command = g_strv_builder_end (builder);
  environment = g_environ_unsetenv (environment, "DISPLAY");
  environment = g_environ_unsetenv (environment, "WAYLAND_DISPLAY");
  if (variable != NULL)
    environment = g_environ_setenv (environment, variable, value, TRUE);

  g_spawn_sync (NULL, command, environment, G_SPAWN_DEFAULT, NULL, NULL, &run.out,
                &run.err, &status, &error);
  g_assert_no_error (error);
  run.code = WIFEXITED (status) ? WEXITSTATUS (status) : 128 + WTERMSIG (status);
  return run;
}

CliRun
cli_run (const char *first, ...)
{
  g_autoptr (GPtrArray) arguments = g_ptr_array_new ();
  va_list rest;
  va_start (rest, first);
  for (const char *argument = first; argument != NULL; argument = va_arg (rest, char *))
    g_ptr_array_add (arguments, (char *) argument);
  va_end (rest);
  g_ptr_array_add (arguments, NULL);
  return cli_run_with ((const char *const *) arguments->pdata, NULL, NULL);
}

void
cli_run_clear (CliRun *run)
{
  g_clear_pointer (&run->out, g_free);
  g_clear_pointer (&run->err, g_free);
}

/* What follows the warnings, which come first and are printed with -q, too. */
static const char *
behind_warnings (const char *err)
{
  while (g_str_has_prefix (err, "quoin-cli: warning: ") && strchr (err, '\n') != NULL)
    err = strchr (err, '\n') + 1;
  return err;
}

void
cli_assert_failed (CliRun *run, int code, const char *part)
{
  const char *said = behind_warnings (run->err), *end = strchr (said, '\n');
  if (run->code != code || !g_str_has_prefix (said, "quoin-cli: ") || end == NULL
      || end[1] != '\0' || (part != NULL && strstr (said, part) == NULL))
    g_test_fail_printf ("code %d (expected %d), said '%s' (expected one line with '%s')",
                        run->code, code, run->err, part != NULL ? part : "");
  cli_run_clear (run);
}

void
cli_assert_done (const CliRun *run)
{
  g_assert_cmpstr (behind_warnings (run->err), ==, "");
  g_assert_cmpint (run->code, ==, 0);
}

void
cli_expect_done (CliRun run)
{
  cli_assert_done (&run);
  cli_run_clear (&run);
}

void
cli_expect_said (CliRun run, const char *part)
{
  cli_assert_done (&run);
  g_assert_nonnull (strstr (run.out, part));
  cli_run_clear (&run);
}

char *
cli_write (const char *folder, const char *name, const char *text)
{
  g_autoptr (GError) error = NULL;
  char *path = g_build_filename (folder, name, NULL);
  g_file_set_contents (path, text, -1, &error);
  g_assert_no_error (error);
  return path;
}

char *
cli_read (const char *path)
{
  g_autoptr (GError) error = NULL;
  char *text = NULL;
  g_file_get_contents (path, &text, NULL, &error);
  g_assert_no_error (error);
  return text;
}

char *
cli_example (const char *name)
{
  return g_build_filename (g_getenv ("QUOIN_EXAMPLES"), name, NULL);
}

char *
cli_replace (const char *text, const char *from, const char *to)
{
  const char *found = strstr (text, from);
  g_assert_nonnull (found);
  GString *result = g_string_new_len (text, found - text);
  g_string_append (result, to);
  g_string_append (result, found + strlen (from));
  return g_string_free (result, FALSE);
}
