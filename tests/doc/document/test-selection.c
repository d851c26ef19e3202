#include "doc/document/document.h"
#include "support/auto-clear.h"
#include "support/room.h"

static void
on_changed (gpointer counter)
{
  (*(int *) counter)++;
}

static void
test_sets (void)
{
  g_autoptr (QnSelection) selection = g_object_new (QN_TYPE_SELECTION, NULL);
  int changes = 0;
  g_signal_connect_swapped (selection, "changed", G_CALLBACK (on_changed), &changes);
  const QnId ids[] = { 5, 2, 2, 9 };
  qn_selection_set (selection, QN_PICK_BLOCK, ids, 4);
  guint count = 0;
  const QnId *sorted = qn_selection_get (selection, QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, 3);
  g_assert_cmpint (sorted[0], ==, 2);
  g_assert_cmpint (sorted[2], ==, 9);
  g_assert_cmpint (changes, ==, 1);
  qn_selection_set (selection, QN_PICK_BLOCK, ids, 4);
  g_assert_cmpint (changes, ==, 1); /* nothing new */
  qn_selection_toggle (selection, QN_PICK_BLOCK, 5);
  g_assert_false (qn_selection_has (selection, QN_PICK_BLOCK, 5));
  qn_selection_toggle (selection, QN_PICK_BLOCK, 7);
  g_assert_true (qn_selection_has (selection, QN_PICK_BLOCK, 7));
  qn_selection_set_one (selection, QN_PICK_FACE, 3);
  g_assert_false (qn_selection_has (selection, QN_PICK_BLOCK, 7));
  g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==, 3);
  qn_selection_clear (selection);
  g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_FACE), ==, QN_NONE);
}

static void
test_like (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "ferris-tin-loi", "wall1.quoin", NULL);
  g_autoptr (QnDocument) document = qn_document_new ();
  g_assert_true (qn_document_load (document, path, NULL));
  const QnModel *model = &document->project.model;
  QnSelection *selection = document->selection;
  QnId block = qn_model_find_block (model, "w.2.1");
  guint count = 0;
  qn_selection_select_blocks_like (selection, model, block, QN_LIKE_COURSE);
  qn_selection_get (selection, QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, 5);
  qn_selection_select_blocks_like (selection, model, block, QN_LIKE_WALL);
  qn_selection_get (selection, QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, model->block_count - 1);
  qn_selection_select_all (selection, model);
  qn_selection_get (selection, QN_PICK_BLOCK, &count);
  g_assert_cmpuint (count, ==, model->block_count);
}

/* A selected load stays selected where it goes on: the one of an edge, when another before it is removed, and
 * when the model changes elsewhere; a load that is removed is not replaced by its neighbour on another edge. */
static void
test_follow_load (void)
{
  g_auto (QnModel) before = { 0 }, after = { 0 };
  g_auto (QnContacts) contacts = { 0 };
  static const QnVec2 corners[] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  qn_model_init (&before);
  g_assert_nonnull (qn_model_add_block (&before, "stone", corners, 4));
  for (QnId edge = 0; edge < 3; edge++) {
    QnLoad *load = qn_model_add_live_load (&before);
    load->kind = QN_LOAD_EDGE;
    load->block = 0;
    load->edge = edge;
    load->edge_count = 1;
  }
  g_assert_cmpint (qn_model_copy (&before, &after, NULL), ==, QN_OK);
  after.live_loads[0] = after.live_loads[1];
  after.live_loads[1] = after.live_loads[2];
  after.live_load_count = 2;
  static const QnId now[] = { QN_NONE, 0, 1 };
  for (QnId old = 0; old < 3; old++) {
    g_autoptr (QnSelection) selection = g_object_new (QN_TYPE_SELECTION, NULL);
    qn_selection_set_one (selection, QN_PICK_LIVE_LOAD, old);
    qn_selection_follow (selection, &before, &contacts, &after, &contacts);
    g_assert_cmpint (qn_selection_get_one (selection, QN_PICK_LIVE_LOAD), ==, now[old]);
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/selection/follow-load", test_follow_load);
  g_test_add_func ("/doc/selection/sets", test_sets);
  g_test_add_func ("/doc/selection/like", test_like);
}
