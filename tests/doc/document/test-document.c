#include "doc/edit/edit.h"
#include "io/project/project.h"

#include "doc/fixture.h"
#include "doc/long-analysis.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <malloc.h>
#include <math.h>
#include <string.h>

static gboolean
set_friction (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  model->laws[0].friction = *(const double *) data;
  return TRUE;
}

static gboolean
set_steps (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->analysis.increments += 7;
  return TRUE;
}

static gboolean
set_title (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  free (model->title);
  model->title = strdup (data);
  return TRUE;
}

static gboolean
break_polygon (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->vertices[model->blocks[0].first_vertex].x += 100.0;
  model->vertices[model->blocks[0].first_vertex + 1] = qn_vec2 (0.0, 0.0);
  model->vertices[model->blocks[0].first_vertex + 2] = qn_vec2 (0.0, 0.0);
  return TRUE;
}

static gboolean
change (QnDocument *document, double friction, const char *key)
{
  return edit_model (document, "Set Friction", key, set_friction, &friction, NULL);
}

static void
test_empty (void)
{
  g_autoptr (QnDocument) document = qn_document_new ();
  g_assert_false (qn_document_is_modified (document));
  g_assert_cmpuint (document->project.model.block_count, ==, 0);
  g_assert_cmpuint (document->project.model.law_count, ==, 1);
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_document_analyse (document, &error));
  g_assert_nonnull (error);

  /* An empty drawing can be changed, undone, saved and opened. */
  g_assert_true (change (document, 0.7, NULL));
  g_assert_cmpfloat (document->project.model.laws[0].friction, ==, 0.7);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpfloat (document->project.model.laws[0].friction, ==, 0.65);
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "empty.quoin", NULL);
  g_assert_true (qn_document_save (document, path, NULL));
  g_autoptr (QnDocument) again = qn_document_new ();
  g_assert_true (qn_document_load (again, path, NULL));
  g_assert_cmpuint (again->project.model.block_count, ==, 0);
  g_unlink (path);
  g_rmdir (folder);
}

static void
test_save_and_load (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "copy.quoin", NULL);
  g_assert_false (qn_document_is_modified (document));
  g_assert_true (change (document, 0.5, NULL));
  g_assert_true (qn_document_is_modified (document));
  g_assert_true (qn_document_save (document, path, NULL));
  g_assert_false (qn_document_is_modified (document));
  g_assert_cmpstr (document->path, ==, path);
  g_assert_true (qn_document_undo (document));
  g_assert_true (qn_document_is_modified (document));

  g_autoptr (QnDocument) again = qn_document_new ();
  g_assert_true (qn_document_load (again, path, NULL));
  g_assert_cmpfloat (again->project.model.laws[0].friction, ==, 0.5);
  g_assert_cmpuint (again->project.model.block_count, ==,
                    document->project.model.block_count);

  /* Written by another document since: told until it is written here. */
  g_assert_false (qn_document_is_changed_elsewhere (document));
  g_assert_false (qn_document_is_changed_elsewhere (again));
  g_assert_true (change (again, 0.7, NULL));
  g_assert_true (qn_document_save (again, path, NULL));
  g_assert_true (qn_document_is_changed_elsewhere (document));
  g_assert_false (qn_document_is_changed_elsewhere (again));

  /* What cannot be written or read is an error and changes nothing. */
  g_autoptr (GError) error = NULL;
  g_assert_false (qn_document_save (document, "/no/such/folder/x.quoin", &error));
  g_assert_nonnull (error);
  g_assert_cmpstr (document->path, ==, path);
  g_clear_error (&error);
  g_assert_false (qn_document_load (document, folder, &error));
  g_assert_nonnull (error);
  g_assert_cmpuint (document->project.model.block_count, >, 0);
  g_unlink (path);
  g_rmdir (folder);
}

static void
test_refused_edit (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  g_autofree char *text = g_strdup (document->text->text);
  g_autoptr (GError) error = NULL;
  g_assert_false (edit_model (document, "Break", NULL, break_polygon, NULL, &error));
  g_assert_nonnull (strstr (error->message, "blocks[0]"));
  g_assert_cmpstr (document->text->text, ==, text);
  g_assert_false (qn_document_is_modified (document));

  /* An edit that changes nothing makes no step. */
  g_assert_true (change (document, document->project.model.laws[0].friction, NULL));
  g_assert_false (document->history->position > 0);
}

static gboolean
delete_all (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  g_autofree QnId *ids = g_new (QnId, model->block_count);
  for (gsize i = 0; i < model->block_count; i++)
    ids[i] = (QnId) i;
  return qn_edit_delete_blocks (model, (QnBlockSet){ ids, (guint) model->block_count },
                                error);
}

/* A drawing from which everything was deleted is one like any other; the words that a file writes
 * for blocks may stand in a title. */
static void
test_deleted (void)
{
  static const char *const names[] = { "01-sliding-block.quoin",
                                       "ferris-tin-loi/wall3.quoin", "12-facade.quoin" };
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "empty.quoin", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    g_autoptr (QnDocument) document = open_example (names[i]);
    edit (document, set_title, "\"vertices\" and \"courses\"");
    g_assert_cmpuint (edit (document, delete_all, NULL)->block_count, ==, 0);
    g_autoptr (GError) error = NULL;
    g_assert_true (qn_document_save (document, path, &error));
    g_assert_true (qn_document_load (document, path, &error));
    check_state (document);
    g_assert_cmpuint (document->project.model.block_count, ==, 0);
  }
  g_unlink (path);
  g_rmdir (folder);
}

static gsize
resident_bytes (void)
{
  g_autofree char *content = NULL;
  g_assert_true (g_file_get_contents ("/proc/self/statm", &content, NULL, NULL));
  char *end = NULL;
  g_ascii_strtoull (content, &end, 10);
  return (gsize) g_ascii_strtoull (end, NULL, 10) * 4096;
}

/* A thousand times to and fro: the same text each time, and no more memory. */
static void
test_thousand_undos (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall1.quoin");
  g_autofree char *first = g_strdup (document->text->text);
  for (int i = 1; i <= 10; i++)
    g_assert_true (change (document, 0.65 + 0.01 * i, NULL));
  g_autofree char *last = g_strdup (document->text->text);
  gsize warm = 0;
  for (int round = 0; round < 100; round++) {
    for (int i = 0; i < 10; i++)
      g_assert_true (qn_document_undo (document));
    g_assert_cmpstr (document->text->text, ==, first);
    for (int i = 0; i < 10; i++)
      g_assert_true (qn_document_redo (document));
    g_assert_cmpstr (document->text->text, ==, last);
    if (round == 20)
      warm = resident_bytes ();
  }
  g_test_message ("%.1f MB after 400, %.1f MB after 2,000 steps", 1e-6 * (double) warm,
                  1e-6 * (double) resident_bytes ());
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  g_assert_cmpuint (resident_bytes (), <, warm + 4 * 1024 * 1024);
#endif
  qn_document_go_to (document, 3);
  g_assert_cmpfloat_with_epsilon (document->project.model.laws[0].friction, 0.68, 1e-12);
}

static void
on_signal (gpointer counter)
{
  (*(int *) counter)++;
}

static void
test_gestures_and_signals (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  int changes = 0;
  g_signal_connect_swapped (document, "changed", G_CALLBACK (on_signal), &changes);
  change (document, 0.5, "drag");
  change (document, 0.4, "drag");
  change (document, 0.3, "drag");
  g_assert_cmpint (changes, ==, 3);
  g_assert_cmpuint (document->history->steps->len, ==, 1);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpint (changes, ==, 4);
  g_assert_false (qn_document_is_modified (document));
}

/* Arrow keys that move one block and then another are two steps. */
static void
test_selection_ends_gesture (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  QnSelection *selection = document->selection;
  QnEditHistory *history = document->history;
  const QnId first = 0;
  qn_selection_set (selection, QN_PICK_BLOCK, &first, 1);
  change (document, 0.5, "nudge");
  qn_selection_set (selection, QN_PICK_BLOCK, &first, 1); /* the same */
  change (document, 0.4, "nudge");
  g_assert_cmpuint (history->steps->len, ==, 1);
  qn_selection_clear (selection);
  change (document, 0.3, "nudge");
  change (document, 0.2, "nudge");
  g_assert_cmpuint (history->steps->len, ==, 2);
}

static void
test_extras (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  g_assert_true (qn_document_edit_extra (document, "Store Figure", NULL, "figures",
                                         "[{\"a\":1}]", NULL));
  g_autofree char *value =
    qn_project_dup_extra (qn_document_get_project (document), "figures");
  g_assert_nonnull (value);
  g_assert_nonnull (strstr (value, "\"a\""));
  g_assert_true (qn_document_undo (document));
  g_assert_null (qn_project_dup_extra (qn_document_get_project (document), "figures"));
}

/* ---- analyses ---- */

static void
test_analysis (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  g_autoptr (GError) error = NULL;
  qn_document_analyse (document, &error);
  g_assert_no_error (error);
  /* Editing goes on meanwhile. */
  change (document, 0.6, NULL);
  wait_for_job (document);
  QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_cmpfloat (run->model.laws[0].friction, ==, 0.65);
  g_assert_cmpfloat (fabs (run->result.collapse_multiplier - 0.356), <, 0.01 * 0.356);
  g_assert_true (qn_document_is_stale (document, run));
  qn_document_undo (document);
  g_assert_false (qn_document_is_stale (document, run));

  /* A title does not make a result outdated. */
  edit_model (document, "Rename", NULL, set_title, (char *) "Another", NULL);
  g_assert_false (qn_document_is_stale (document, run));

  /* Settings of the analysis are told apart from changes of the model, also when both change. */
  g_assert_cmpint (qn_document_get_run_age (document, run), ==, QN_RUN_CURRENT);
  g_assert_cmpstr (qn_run_age_text (QN_RUN_CURRENT), ==, "");
  edit_model (document, "Steps", NULL, set_steps, NULL, NULL);
  g_assert_cmpint (qn_document_get_run_age (document, run), ==, QN_RUN_OTHER_SETTINGS);
  g_assert_true (qn_document_is_stale (document, run));
  change (document, 0.6, NULL);
  g_assert_cmpint (qn_document_get_run_age (document, run), ==, QN_RUN_OTHER_MODEL);
  qn_document_undo (document);
  g_assert_cmpint (qn_document_get_run_age (document, run), ==, QN_RUN_OTHER_SETTINGS);
  qn_document_undo (document);
  g_assert_cmpint (qn_document_get_run_age (document, run), ==, QN_RUN_CURRENT);
  qn_document_remove_run (document, run);
  g_assert_null (document->run);
  g_assert_cmpuint (document->runs->len, ==, 0);
}

static void
test_cancel (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall6.quoin");
  long_analysis_ask (document);
  qn_document_analyse (document, NULL);
  while (qn_job_get_progress (document->job).steps < 2)
    g_main_context_iteration (NULL, TRUE);
  qn_document_cancel (document);
  wait_for_job (document);
  const QnRun *run = document->run;
  g_assert_nonnull (run);
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_CANCELLED);
  g_assert_cmpuint (run->result.step_count, >=, 2);
}

/* The later analysis wins, whichever ends first. */
static void
test_restart (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  qn_document_analyse (document, NULL);
  change (document, 0.5, NULL);
  qn_document_analyse (document, NULL);
  wait_for_job (document);
  for (int i = 0; i < 20; i++) {
    g_usleep (5000);
    g_main_context_iteration (NULL, FALSE);
  }
  g_assert_cmpuint (document->runs->len, ==, 1);
  g_assert_cmpfloat (document->run->model.laws[0].friction, ==, 0.5);
}

/* A document may be closed while its analysis runs. */
static void
test_drop_while_running (void)
{
  QnDocument *document = open_example ("ferris-tin-loi/wall6.quoin");
  g_object_add_weak_pointer (G_OBJECT (document), (gpointer *) &document);
  qn_document_analyse (document, NULL);
  qn_document_cancel (document);
  QnDocument *borrowed = document;
  g_object_unref (borrowed);
  while (document != NULL)
    g_main_context_iteration (NULL, TRUE);
}

static gboolean
lift_block (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  QnId top = (QnId) model->block_count - 1;
  return qn_edit_transform_blocks (model, (QnBlockSet){ &top, 1 },
                                   qn_transform_translation (0.0, 1.0), error);
}

static void
test_explained_failure (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  edit_model (document, "Lift", NULL, lift_block, NULL, NULL);
  qn_document_analyse (document, NULL);
  wait_for_job (document);
  g_assert_null (document->run);
  const GError *error = document->job_error;
  g_assert_error (error, QN_EDIT_ERROR, 0);
  const QnDiag *diag = &document->job_diag;
  g_assert_cmpint (diag->entity, ==, QN_ENTITY_BLOCK);
  g_assert_nonnull (
    strstr (error->message, document->project.model.blocks[diag->index].name));
}

static gsize
bytes_in_use (void)
{
  return mallinfo2 ().uordblks;
}

/* A thousand times back and forth over ten edits of a wall: memory stays what it was. */
static void
test_memory (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  for (int i = 0; i < 10; i++)
    g_assert_true (change (document, 0.3 + 0.01 * i, NULL));
  gsize after_warm_up = 0;
  for (int i = 0; i < 50 + 500; i++) {
    if (i == 50)
      after_warm_up = bytes_in_use ();
    g_assert_true (qn_document_undo (document));
    g_assert_true (qn_document_redo (document));
  }
  gsize end = bytes_in_use ();
  g_test_message ("%zu bytes in use before, %zu after", after_warm_up, end);
  g_assert_cmpuint (end, <=, after_warm_up + 65536);
}

QN_TESTS
{
  g_test_add_func ("/doc/document/empty", test_empty);
  g_test_add_func ("/doc/document/save-and-load", test_save_and_load);
  g_test_add_func ("/doc/document/refused-edit", test_refused_edit);
  g_test_add_func ("/doc/document/deleted", test_deleted);
  g_test_add_func ("/doc/document/thousand-undos", test_thousand_undos);
  g_test_add_func ("/doc/document/gestures-and-signals", test_gestures_and_signals);
  g_test_add_func ("/doc/document/selection-ends-gesture", test_selection_ends_gesture);
  g_test_add_func ("/doc/document/extras", test_extras);
  g_test_add_func ("/doc/document/analysis", test_analysis);
  g_test_add_func ("/doc/document/cancel", test_cancel);
  g_test_add_func ("/doc/document/restart", test_restart);
  g_test_add_func ("/doc/document/drop-while-running", test_drop_while_running);
  g_test_add_func ("/doc/document/explained-failure", test_explained_failure);
  g_test_add_func ("/doc/document/memory", test_memory);
}
