#include "io/project/project.h"

#include "io/project-text.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

static void
expect_extra (const QnProject *project, const char *member, const char *expected)
{
  g_autofree char *json = qn_project_dup_extra (project, member);
  g_assert_cmpstr (json, ==, expected);
}

static void
change (QnProject *project, const char *member, const char *json)
{
  GError *error = NULL;
  g_assert_true (qn_project_set_extra (project, member, json, &error));
  g_assert_no_error (error);
}

static void
test_members (void)
{
  g_auto (QnProject) project;
  test_parse (test_project_text, &project);
  expect_extra (&project, "view", NULL);
  change (&project, "view", "{\"zoom\":0.5}");
  change (&project, "figures", "[1, \"ü\"]");
  expect_extra (&project, "view", "{ \"zoom\": 0.5 }");
  change (&project, "view", "2");
  expect_extra (&project, "view", "2");
  change (&project, "view", NULL);
  expect_extra (&project, "view", NULL);
  expect_extra (&project, "figures", "[1, \"ü\"]");

  /* What was put there is in the file. */
  g_autofree char *text = qn_project_to_text (&project, NULL);
  g_assert_nonnull (strstr (text, "\"figures\": [1, \"ü\"]"));
}

static void
test_not_json (void)
{
  g_auto (QnProject) project;
  g_autoptr (GError) error = NULL;
  test_parse (test_project_text, &project);
  g_assert_false (qn_project_set_extra (&project, "view", "{", &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_cmpstr (error->message, ==, "view:1:2: text ends inside an object");
}

QN_TESTS
{
  g_test_add_func ("/project-extras/members", test_members);
  g_test_add_func ("/project-extras/not-json", test_not_json);
}
