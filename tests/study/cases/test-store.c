/* The database: rows come back as they went in, and belong to one study. */
#include "study/cases/store.h"

#include "io/text/io-error.h"
#include "study/fixture.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

#define PLAN "{ \"kind\": \"monte-carlo\", \"count\": 10 }"

typedef struct Bench {
  QnStudy study;
  char *folder, *path, *other_path;
  GError *error;
} Bench;

static void
set_up (Bench *bench, gconstpointer data)
{
  (void) data;
  fixture_study (&bench->study, PLAN, "");
  bench->folder = test_scratch_new ();
  bench->path = g_build_filename (bench->folder, "a.db", NULL);
  bench->other_path = g_build_filename (bench->folder, "b.db", NULL);
}

static void
tear_down (Bench *bench, gconstpointer data)
{
  (void) data;
  qn_study_clear (&bench->study);
  test_scratch_free (bench->folder);
  g_free (bench->path);
  g_free (bench->other_path);
}

static QnStore *
open_store (Bench *bench, const char *path)
{
  QnStore *store = qn_store_open (path, &bench->study, TRUE, &bench->error);
  g_assert_no_error (bench->error);
  return store;
}

/* A row whose numbers tell its case. */
static void
add (Bench *bench, QnStore *store, gsize index, gboolean failed)
{
  const double values[] = { 0.1 + (double) index, 1.0 / 3 };
  g_auto (QnCaseResult) result;
  qn_case_result_fail (&result, failed ? "it broke" : NULL);
  result.failed = failed;
  if (!failed) {
    result.outcome = g_strdup ("collapse");
    result.mechanism = g_strdup ("sliding");
    result.numbers[QN_STUDY_COLLAPSE_MULTIPLIER] = 0.1 * (double) index;
  }
  result.seconds = 0.25;
  qn_store_add (store, index, values, &result, &bench->error);
  g_assert_no_error (bench->error);
}

static void
commit (Bench *bench, QnStore *store)
{
  qn_store_commit (store, &bench->error);
  g_assert_no_error (bench->error);
}

static gboolean
check_row (gsize index, const double *values, const QnCaseResult *result, gpointer data)
{
  guint *rows = data;
  (*rows)++;
  g_assert_true (values[0] == 0.1 + (double) index && values[1] == 1.0 / 3);
  g_assert_cmpfloat (result->seconds, ==, 0.25);
  if (result->failed) {
    g_assert_cmpstr (result->reason, ==, "it broke");
    g_assert_null (result->outcome);
    g_assert_true (isnan (result->numbers[QN_STUDY_COLLAPSE_MULTIPLIER]));
  } else {
    g_assert_cmpstr (result->mechanism, ==, "sliding");
    g_assert_cmpfloat (result->numbers[QN_STUDY_COLLAPSE_MULTIPLIER], ==,
                       0.1 * (double) index);
  }
  return TRUE;
}

static void
test_rows (Bench *bench, gconstpointer data)
{
  (void) data;
  guint8 marks[10] = { 0 };
  guint rows = 0;
  gsize count, failed;
  QnStore *store = open_store (bench, bench->path);
  add (bench, store, 7, FALSE);
  add (bench, store, 2, TRUE);
  commit (bench, store);
  add (bench, store, 3, FALSE); /* never committed */
  qn_store_close (store);

  store = open_store (bench, bench->path);
  g_assert_true (qn_store_read (store, check_row, &rows, &bench->error));
  g_assert_cmpuint (rows, ==, 2);
  g_assert_true (qn_store_mark_present (store, marks, 10, &bench->error));
  g_assert_true (marks[7] && marks[2] && !marks[3]);
  g_assert_true (qn_store_count (store, &count, &failed, &bench->error));
  g_assert_cmpuint (count, ==, 2);
  g_assert_cmpuint (failed, ==, 1);
  g_assert_true (qn_store_forget_failed (store, &bench->error));
  g_assert_true (qn_store_count (store, &count, &failed, &bench->error));
  g_assert_cmpuint (count, ==, 1);
  qn_store_close (store);
}

/* Missing rows come over, done ones replace failed ones and not the reverse; again changes nothing. */
static void
test_merge (Bench *bench, gconstpointer data)
{
  (void) data;
  gsize added, count, failed;
  QnStore *store = open_store (bench, bench->path);
  QnStore *other = open_store (bench, bench->other_path);
  add (bench, store, 0, FALSE);
  add (bench, store, 1, TRUE);
  commit (bench, store);
  add (bench, other, 0, TRUE);
  add (bench, other, 1, FALSE);
  add (bench, other, 2, TRUE);
  commit (bench, other);
  g_assert_true (qn_store_merge (store, bench->other_path, &added, &bench->error));
  g_assert_cmpuint (added, ==, 2);
  g_assert_true (qn_store_count (store, &count, &failed, &bench->error));
  g_assert_cmpuint (count, ==, 3);
  g_assert_cmpuint (failed, ==, 1);
  g_assert_true (qn_store_merge (store, bench->other_path, &added, &bench->error));
  g_assert_cmpuint (added, ==, 0);
  qn_store_close (other);
  qn_store_close (store);
}

static void
expect_refused (Bench *bench, const char *path, const char *part)
{
  g_assert_null (qn_store_open (path, &bench->study, TRUE, &bench->error));
  g_assert_error (bench->error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  g_assert_nonnull (strstr (bench->error->message, part));
  g_assert_true (g_str_has_prefix (bench->error->message, path));
  g_clear_error (&bench->error);
}

static void
test_others (Bench *bench, gconstpointer data)
{
  (void) data;
  qn_store_close (open_store (bench, bench->path));
  qn_study_clear (&bench->study);
  fixture_study (&bench->study, "{ \"kind\": \"monte-carlo\", \"count\": 11 }", "");
  expect_refused (bench, bench->path, "another study");

  g_assert_true (
    g_file_set_contents (bench->other_path, "this is no database, is it?", -1, NULL));
  expect_refused (bench, bench->other_path, "not a database");
  g_assert_null (qn_store_open ("/nowhere/a.db", &bench->study, TRUE, &bench->error));
  g_assert_error (bench->error, QN_IO_ERROR, QN_IO_ERROR_FILE);
  g_clear_error (&bench->error);
}

QN_TESTS
{
#define ADD(name, function)                                                              \
  g_test_add ("/study/store/" name, Bench, NULL, set_up, function, tear_down)
  ADD ("rows", test_rows);
  ADD ("merge", test_merge);
  ADD ("others", test_others);
}
