#include "doc/document/history.h"

#include "doc/fixture.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

static QnEditHistory *
make_history (void)
{
  QnEditHistory *history = qn_history_new ();
  qn_history_record (history, "One", NULL, "a\nb\nc\n", "a\nB \"x\"\nc\n");
  qn_history_record (history, "Two", NULL, "a\nB \"x\"\nc\n", "a\nc\n");
  qn_history_record (history, "Three", NULL, "a\nc\n", "a\nc\nd\n");
  return history;
}

static void
test_round_trip (void)
{
  g_autofree char *text = g_strdup ("a\nc\nd\n");
  QnEditHistory *history = make_history ();
  g_autofree char *back = qn_history_go_to (history, text, 2);
  g_autofree char *json = qn_history_to_json (history, back);
  QnEditHistory *read = qn_history_from_json (json, back);
  g_assert_nonnull (read);
  g_assert_cmpuint (read->steps->len, ==, 3);
  g_assert_cmpuint (read->position, ==, 2);
  g_assert_cmpstr (qn_history_get_name (read, 1), ==, "Two");
  g_assert_true (read->clean == read->position);
  g_autofree char *forth = qn_history_go_to (read, back, 3);
  g_assert_cmpstr (forth, ==, text);
  g_autofree char *start = qn_history_go_to (read, forth, 0);
  g_assert_cmpstr (start, ==, "a\nb\nc\n");
  qn_history_free (history);
  qn_history_free (read);
}

/* Another text, steps that do not fit, and anything but a history are refused whole. */
static void
test_refused (void)
{
  QnEditHistory *history = make_history ();
  g_autofree char *json = qn_history_to_json (history, "a\nc\nd\n");
  qn_history_free (history);
  g_assert_null (qn_history_from_json (json, "a\nc\ne\n"));
  static const char *const changes[][2] = {
    { "\"position\": 3", "\"position\": 4" },
    { "\"position\": 3", "\"position\": -1" },
    { "\"d\\n\"", "\"e\\n\"" },
    { "[4, ", "[400, " },
    { "\"steps\": [", "\"step\": [" },
    { "\"hunks\": [[", "\"hunks\": [[[], " },
    { "\"name\": \"Two\"", "\"name\": null" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (changes); i++) {
    g_auto (GStrv) parts = g_strsplit (json, changes[i][0], 2);
    g_assert_nonnull (parts[1]);
    g_autofree char *broken = g_strjoin (changes[i][1], parts[0], parts[1], NULL);
    g_assert_null (qn_history_from_json (broken, "a\nc\nd\n"));
  }
  g_assert_null (qn_history_from_json ("", "a\nc\nd\n"));
  g_assert_null (qn_history_from_json ("[]", "a\nc\nd\n"));
}

static gboolean
set_friction (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  model->laws[0].friction = *(const double *) data;
  return TRUE;
}

/* In a file: kept on request, undone after loading, left out with a word where the file has been
 * edited by hand, and no part of the state. */
static void
test_document (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "kept.quoin", NULL);
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  g_autofree char *opened = g_strdup (document->text->text);
  for (double friction = 0.3; friction < 0.55; friction += 0.1)
    g_assert_true (
      edit_model (document, "Set Friction", NULL, set_friction, &friction, NULL));
  g_assert_false (document->keeps_history);
  qn_document_set_keeps_history (document, TRUE);
  g_autofree char *digest = g_strdup (document->text->text);
  g_assert_true (qn_document_save (document, path, NULL));

  g_autoptr (QnDocument) again = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load (again, path, &error);
  g_assert_no_error (error);
  g_assert_true (again->keeps_history);
  g_assert_cmpstr (again->text->text, ==, digest);
  g_assert_false (qn_document_is_modified (again));
  g_assert_cmpuint (qn_document_get_project (again)->warnings->len, ==, 0);
  qn_document_go_to (again, 0);
  g_assert_cmpstr (again->text->text, ==, opened);

  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  char *weight = strstr (text, "\"unit_weight\": ");
  g_assert_nonnull (weight);
  weight[strlen ("\"unit_weight\": ")] = '7';
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  qn_document_load (again, path, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (again->history->steps->len, ==, 0);
  g_assert_cmpuint (qn_document_get_project (again)->warnings->len, ==, 1);
  g_unlink (path);
  g_rmdir (folder);
}

QN_TESTS
{
  g_test_add_func ("/doc/history-file/round-trip", test_round_trip);
  g_test_add_func ("/doc/history-file/refused", test_refused);
  g_test_add_func ("/doc/history-file/document", test_document);
}
