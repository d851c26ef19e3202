/* Files opened to be compared: projects that are solved, results, folders, and what cannot be read. */
#include "doc/document/batch.h"

#include "doc/document/document.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

/* A block that slides at a multiplier of 0.5, and the same with another friction. */
static char *
project_text (const char *title, double friction)
{
  return g_strdup_printf (
    "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"%s\","
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": %g } ],"
    "  \"blocks\": [ { \"name\": \"below\", \"vertices\": [[0,0],[1,0],[1,0.5],[0,0.5]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true, true, true] },"
    "    { \"name\": \"above\", \"vertices\": [[0,0.5],[1,0.5],[1,0.7],[0,0.7]],"
    "    \"thickness\": 1, \"unit_weight\": 1e4 } ],"
    "  \"contact\": { \"law\": \"dry\" },"
    "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],"
    "    \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] } }",
    title, friction);
}

static void
write_project (const char *folder, const char *name, double friction)
{
  g_autofree char *path = g_build_filename (folder, name, NULL);
  g_autofree char *text = project_text (name, friction);
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
}

static gboolean
is_busy (QnBatch *batch)
{
  const GPtrArray *documents = batch->documents;
  for (guint i = 0; i < documents->len; i++)
    if (((QnDocument *) documents->pdata[i])->job != NULL)
      return TRUE;
  return FALSE;
}

static void
wait_for (QnBatch *batch)
{
  while (is_busy (batch))
    g_main_context_iteration (NULL, TRUE);
}

static void
count (QnBatch *batch, gpointer data)
{
  (void) batch;
  (*(guint *) data)++;
}

static void
test_folder (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  write_project (folder, "b.quoin", 0.4);
  write_project (folder, "a.quoin", 0.5);
  g_autofree char *first = g_build_filename (folder, "a.quoin", NULL);
  g_autofree char *second = g_build_filename (folder, "b.quoin", NULL);
  g_autofree char *broken = g_build_filename (folder, "c.quoin", NULL);
  g_autofree char *result = g_build_filename (folder, "a.json", NULL);
  g_assert_true (g_file_set_contents (broken, "{ \"format\": ", -1, NULL));

  g_autoptr (QnBatch) batch = g_object_new (QN_TYPE_BATCH, NULL);
  guint changes = 0;
  g_signal_connect (batch, "changed", G_CALLBACK (count), &changes);
  g_assert_cmpuint (qn_batch_add (batch, folder), ==, 2);
  wait_for (batch);
  const GPtrArray *documents = batch->documents;
  g_assert_cmpuint (documents->len, ==, 2);
  g_assert_cmpuint (changes, >=, 3);
  g_assert_cmpuint (batch->messages->len, ==, 1);
  g_assert_nonnull (strstr (batch->messages->pdata[0], "c.quoin"));
  const double multipliers[] = { 0.5, 0.4 };
  for (guint i = 0; i < documents->len; i++) {
    const QnRun *run = ((QnDocument *) documents->pdata[i])->run;
    g_assert_nonnull (run);
    g_assert_cmpfloat_with_epsilon (run->result.collapse_multiplier, multipliers[i],
                                    1e-4);
  }
  QnDocument *solved = documents->pdata[0];
  g_assert_true (qn_document_write_result (solved, solved->run, result, NULL));

  /* A result comes with its project and is not solved again; neither comes twice. */
  g_autoptr (QnBatch) again = g_object_new (QN_TYPE_BATCH, NULL);
  g_assert_cmpuint (qn_batch_add (again, result), ==, 1);
  g_assert_false (is_busy (again));
  g_assert_cmpuint (qn_batch_add (again, first), ==, 1);
  g_assert_cmpuint (again->documents->len, ==, 1);
  const QnDocument *come = again->documents->pdata[0];
  g_assert_cmpuint (come->runs->len, ==, 1);
  g_assert_cmpuint (qn_batch_add (again, "/no/such/wall.quoin"), ==, 0);
  g_assert_cmpuint (again->messages->len, ==, 1);
  const char *const files[] = { first, second, broken, result };
  for (gsize i = 0; i < G_N_ELEMENTS (files); i++)
    g_unlink (files[i]);
  g_assert_cmpuint (qn_batch_add (again, folder), ==, 0);
  g_assert_cmpuint (again->messages->len, ==, 2);
  g_rmdir (folder);
}

QN_TESTS
{
  g_test_add_func ("/doc/batch/folder", test_folder);
}
