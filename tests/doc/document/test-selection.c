#include "doc/document/document.h"
#include "support/room.h"

static void
on_changed (gpointer counter)
{
  (*(int *) counter)++;
}

static void
test_sets (void)
{
  g_autoptr (QnSelection) selection = qn_selection_new ();
  int changes = 0;
  g_signal_connect_swapped (selection, "changed", G_CALLBACK (on_changed), &changes);
  const QnId ids[] = { 5, 2, 2, 9 };
  qn_selection_set (selection, QN_PART_BLOCK, ids, 4);
  guint count = 0;
  const QnId *sorted = qn_selection_get (selection, QN_PART_BLOCK, &count);
  g_assert_cmpuint (count, ==, 3);
  g_assert_cmpint (sorted[0], ==, 2);
  g_assert_cmpint (sorted[2], ==, 9);
  g_assert_cmpint (changes, ==, 1);
  qn_selection_set (selection, QN_PART_BLOCK, ids, 4);
  g_assert_cmpint (changes, ==, 1); /* nothing new */
  qn_selection_toggle (selection, QN_PART_BLOCK, 5);
  g_assert_false (qn_selection_has (selection, QN_PART_BLOCK, 5));
  qn_selection_toggle (selection, QN_PART_BLOCK, 7);
  g_assert_true (qn_selection_has (selection, QN_PART_BLOCK, 7));
  qn_selection_set_face (selection, 3);
  g_assert_false (qn_selection_has (selection, QN_PART_BLOCK, 7));
  g_assert_cmpint (qn_selection_get_face (selection), ==, 3);
  qn_selection_clear (selection);
  g_assert_cmpint (qn_selection_get_face (selection), ==, QN_NONE);
}

static void
test_like (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "ferris-tin-loi", "wall1.quoin", NULL);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_assert_true (qn_document_load (document, path, NULL));
  const QnModel *model = qn_document_get_model (document);
  QnSelection *selection = qn_document_get_selection (document);
  QnId block = qn_model_find_block (model, "w.2.1");
  guint count = 0;
  qn_selection_select_course (selection, model, block);
  qn_selection_get (selection, QN_PART_BLOCK, &count);
  g_assert_cmpuint (count, ==, 5);
  qn_selection_select_wall (selection, model, block);
  qn_selection_get (selection, QN_PART_BLOCK, &count);
  g_assert_cmpuint (count, ==, model->block_count - 1);
  qn_selection_select_all (selection, model);
  qn_selection_get (selection, QN_PART_BLOCK, &count);
  g_assert_cmpuint (count, ==, model->block_count);
}

QN_TESTS
{
  g_test_add_func ("/doc/selection/sets", test_sets);
  g_test_add_func ("/doc/selection/like", test_like);
}
