/* Whether a result belongs to a project. */
#include "io/result/result-file.h"

#include "io/result-fixture.h"
#include "io/text/io-error.h"
#include "support/room.h"

#include <string.h>

static void
read_back (const ResultFixture *fixture, QnResultFile *file)
{
  g_autofree char *text = result_fixture_dup_text (fixture);
  GError *error = NULL;
  g_assert_true (qn_result_file_parse (text, strlen (text), "r.json", file, &error));
  g_assert_no_error (error);
}

static void
test_match (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_auto (QnResultFile) file;
  GError *error = NULL;
  gboolean same_bytes = FALSE;
  read_back (fixture, &file);
  g_assert_true (qn_result_file_match (&file, "r.json", &fixture->project,
                                       &fixture->contacts, &same_bytes, &error));
  g_assert_true (same_bytes);

  /* A changed file with the same blocks is for the caller to judge. */
  fixture->project.sha256[0] = 'x';
  g_assert_true (
    qn_result_file_match (&file, "r.json", &fixture->project, NULL, &same_bytes, &error));
  g_assert_false (same_bytes);
}

static void
expect_mismatch (const QnResultFile *file, const QnProject *project,
                 const QnContacts *contacts, const char *reason)
{
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_result_file_match (file, "r.json", project, contacts, NULL, &error));
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_true (
    g_str_has_prefix (error->message, "r.json: the result is of another model"));
  g_assert_nonnull (strstr (error->message, reason));
}

static void
test_mismatch (ResultFixture *fixture, gconstpointer data)
{
  (void) data;
  g_auto (QnResultFile) file;
  read_back (fixture, &file);
  file.contacts[1].face = 1;
  expect_mismatch (&file, &fixture->project, &fixture->contacts, "other contacts");
  /* A corner that no block has. */
  g_assert_true (qn_result_add_found (
    &file.result, (QnFound){ .contact = { .block = 0, .other = 1, .corner = 17 } }));
  expect_mismatch (&file, &fixture->project, NULL, "found other contacts");
  file.result.found_count = 0;
  file.block_names[1][0] = 'x';
  expect_mismatch (&file, &fixture->project, NULL, "other names");
  file.result.block_count = 1;
  expect_mismatch (&file, &fixture->project, NULL, "other blocks");
  file.result.block_count = 2;
}

QN_TESTS
{
  RESULT_FIXTURE_ADD ("/result-file/match", test_match);
  RESULT_FIXTURE_ADD ("/result-file/mismatch", test_mismatch);
}
