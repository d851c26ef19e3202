/* Beams in the drawing: they follow their blocks, go with them, and come back. */
#include "doc/edit/edit.h"

#include "doc/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>

static gboolean
move (QnModel *model, gpointer data, GError **error)
{
  QnId block = qn_model_find_block (model, data);
  return qn_edit_transform_blocks (model, (QnBlockSet){ &block, 1 },
                                   qn_transform_translation (0.25, 0), error);
}

static gboolean
move_all (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  const QnId all[] = { 0, 1 };
  return qn_edit_transform_blocks (model, (QnBlockSet){ all, 2 },
                                   qn_transform_translation (0, 10), error);
}

static gboolean delete (QnModel *model, gpointer data, GError **error)
{
  QnId block = qn_model_find_block (model, data);
  return qn_edit_delete_blocks (model, (QnBlockSet){ &block, 1 }, error);
}

static gboolean
rename_block (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_rename_block (model, qn_model_find_block (model, data), "stone", error);
}

/* A node on a block goes with it; one that stands free does when everything moves. */
static void
test_move (void)
{
  g_autoptr (QnDocument) document = open_example ("36-mast-on-block.quoin");
  const QnModel *model = edit (document, move, "footing");
  g_assert_cmpfloat (model->nodes[0].at.x, ==, 0.75);
  g_assert_cmpfloat (model->nodes[1].at.x, ==, 0.5);
  g_assert_cmpuint (model->element_count, ==, 4);
  model = edit (document, move_all, NULL);
  g_assert_cmpfloat (model->nodes[0].at.y, ==, 11);
  g_assert_cmpfloat (model->nodes[1].at.y, ==, 13);
  g_assert_cmpint (model->live_loads[0].kind, ==, QN_LOAD_NODE);
}

/* With its block go node, beam, the node at the other end, and the load there; undo brings all
 * of them back. */
static void
test_delete (void)
{
  g_autoptr (QnDocument) document = open_example ("36-mast-on-block.quoin");
  const QnModel *model = edit (document, delete, "footing");
  g_assert_cmpuint (model->node_count, ==, 0);
  g_assert_cmpuint (model->beam_count, ==, 0);
  g_assert_cmpuint (model->element_count, ==, 0);
  g_assert_cmpuint (model->section_count, ==, 1);
  g_assert_cmpuint (model->live_load_count, ==, 0);
  g_assert_true (qn_document_undo (document));
  model = &document->project.model;
  g_assert_cmpuint (model->node_count, ==, 5);
  g_assert_cmpuint (model->element_count, ==, 4);
  g_assert_cmpint (model->live_loads[0].node, ==, qn_model_find_node (model, "head"));
  g_assert_cmpint (model->nodes[0].block, ==, qn_model_find_block (model, "footing"));
}

/* Another block gone or renamed: beams are as they were, saved and read again too. */
static void
test_survive (void)
{
  g_autoptr (QnDocument) document = open_example ("36-mast-on-block.quoin");
  edit (document, rename_block, "footing");
  const QnModel *model = edit (document, delete, "ground");
  g_assert_cmpuint (model->block_count, ==, 1);
  g_assert_cmpint (model->nodes[0].block, ==, 0);
  g_assert_cmpuint (model->element_count, ==, 4);
  g_assert_true (qn_document_undo (document));

  g_autofree char *folder = g_dir_make_tmp ("quoin-beams-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "mast.quoin", NULL);
  g_autoptr (GError) error = NULL;
  qn_document_save (document, path, &error);
  g_assert_no_error (error);
  g_autoptr (QnDocument) again = qn_document_new ();
  qn_document_load (again, path, &error);
  g_assert_no_error (error);
  model = &again->project.model;
  g_assert_cmpuint (model->element_count, ==, 4);
  g_assert_cmpstr (model->blocks[model->nodes[0].block].name, ==, "stone");
  g_unlink (path);
  g_rmdir (folder);
}

QN_TESTS
{
  g_test_add_func ("/edit-beams/move", test_move);
  g_test_add_func ("/edit-beams/delete", test_delete);
  g_test_add_func ("/edit-beams/survive", test_survive);
}
