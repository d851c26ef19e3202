#include "project-text.h"

#include "io/text/io-error.h"

#include <string.h>

/* clang-format off */
const char test_project_text[] =
  "{\n"
  "  \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [\n"
  "    { \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.65 } ],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"base\", \"vertices\": [[0, -1], [2, -1], [2, 0], [0, 0]], \"thickness\": 1, \"unit_weight\": 10000, \"support\": [true, true, true] },\n"
  "    { \"name\": \"top\", \"vertices\": [[0.5, 0], [1.5, 0], [1.5, 1], [0.5, 1]], \"thickness\": 1, \"unit_weight\": 10000 } ],\n"
  "  \"contact\": { \"law\": \"joint\" },\n"
  "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ], \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] }\n"
  "}\n";
/* clang-format on */

char *
test_replace (const char *text, const char *what, const char *by)
{
  const char *at = strstr (text, what);
  g_assert_nonnull (at);
  GString *replaced = g_string_new_len (text, at - text);
  g_string_append (replaced, by);
  g_string_append (replaced, at + strlen (what));
  return g_string_free (replaced, FALSE);
}

void
test_parse (const char *text, QnProject *project)
{
  GError *error = NULL;
  gboolean parsed =
    qn_project_parse (text, strlen (text), "wall.quoin", NULL, project, &error);
  g_assert_no_error (error);
  g_assert_true (parsed);
}

char *
test_parse_error (const char *text, const char *const *overrides)
{
  QnProject project;
  g_autoptr (GError) error = NULL;
  g_assert_false (
    qn_project_parse (text, strlen (text), "wall.quoin", overrides, &project, &error));
  g_assert_nonnull (error);
  g_assert_true (error->domain == QN_IO_ERROR);
  g_assert_true (error->code == QN_IO_ERROR_INVALID
                 || (overrides != NULL && error->code == QN_IO_ERROR_OVERRIDE));
  g_assert_null (strchr (error->message, '\n'));
  g_assert_true (g_str_has_prefix (error->message, "wall.quoin:"));
  char *message = g_strdup (error->message + strlen ("wall.quoin:"));
  return message;
}
