/* What makes a result outdated, and what does not. */
#include "io/project/project.h"
#include "support/room.h"

#include <string.h>

static char *
digest_of (const char *title, const char *source, double friction, double length,
           const char *extra)
{
  g_autofree char *text = g_strdup_printf (
    "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"%s\","
    "  \"laws\": [ { \"name\": \"dry\", \"source\": \"%s\", \"kind\": \"coulomb\", "
    "\"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": %g } ],"
    "  \"masonry\": [ { \"kind\": \"wall\", \"length\": %g, \"height\": 1,"
    "    \"unit\": [0.5, 0.25], \"thickness\": 1, \"unit_weight\": 1e4,"
    "    \"foundation\": 0.3 } ], \"contact\": { \"law\": \"dry\" }%s }",
    title, source, friction, length, extra);
  g_autoptr (GError) error = NULL;
  g_auto (QnProject) project;
  qn_project_parse (text, strlen (text), "wall", NULL, &project, &error);
  g_assert_no_error (error);
  char *digest = qn_model_digest (&project, NULL);
  QnProjectText *canonical = qn_project_write (&project, NULL, NULL);
  g_autofree char *quick = qn_model_digest (&project, canonical);
  qn_project_text_free (canonical);
  g_assert_cmpstr (quick, ==, digest);
  return digest;
}

static void
test_digest (void)
{
  g_autofree char *first = digest_of ("a", "s", 0.6, 3, "");
  g_autofree char *title = digest_of ("b", "s", 0.6, 3, "");
  g_autofree char *source = digest_of ("a", "t", 0.6, 3, "");
  g_autofree char *figures = digest_of ("a", "s", 0.6, 3, ", \"figures\": [ ]");
  g_autofree char *law = digest_of ("a", "s", 0.5, 3, "");
  g_autofree char *masonry = digest_of ("a", "s", 0.6, 4, "");
  g_assert_cmpstr (title, ==, first);
  g_assert_cmpstr (source, ==, first);
  g_assert_cmpstr (figures, ==, first);
  g_assert_cmpstr (law, !=, first);
  g_assert_cmpstr (masonry, !=, first);
}

QN_TESTS
{
  g_test_add_func ("/doc/digest/digest", test_digest);
}
