#include "doc/edit/edit.h"

#include "doc/fixture.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <math.h>

typedef struct Edit {
  QnBlockSet set;
  QnTransform transform;
  int copies;
  bool support[QN_DOF_COUNT];
} Edit;

static gboolean
transform (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  return qn_edit_transform_blocks (model, edit->set, edit->transform, error);
}

static gboolean
copy (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  return qn_edit_copy_blocks (model, edit->set, edit->transform, edit->copies, error);
}

static gboolean
delete_blocks (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_delete_blocks (model, ((const Edit *) data)->set, error);
}

static gboolean
support (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  return qn_edit_set_support (model, edit->set, QN_DOF_UX, QN_DOF_COUNT, edit->support,
                              error);
}

static void
assert_place (QnVec2 a, double x, double y)
{
  g_assert_cmpfloat_with_epsilon (a.x, x, 1e-12);
  g_assert_cmpfloat_with_epsilon (a.y, y, 1e-12);
}

static void
test_transforms (void)
{
  QnVec2 p = { 2.0, 1.0 };
  assert_place (qn_transform_apply (qn_transform_translation (1.0, -1.0), p), 3.0, 0.0);
  assert_place (
    qn_transform_apply (qn_transform_rotation (qn_vec2 (1.0, 1.0), G_PI_2), p), 1.0, 2.0);
  assert_place (
    qn_transform_apply (qn_transform_mirror (qn_vec2 (0.0, 5.0), qn_vec2 (0.0, 6.0)), p),
    -2.0, 1.0);
  assert_place (
    qn_transform_apply (qn_transform_mirror (qn_vec2 (0.0, 0.0), qn_vec2 (1.0, 1.0)), p),
    1.0, 2.0);
  QnTransform both =
    qn_transform_compose (qn_transform_translation (1.0, 0.0),
                          qn_transform_rotation (qn_vec2 (0.0, 0.0), G_PI));
  assert_place (qn_transform_apply (both, p), -3.0, -1.0);
}

/* A whole wall that is shifted stays a wall; one that is turned becomes free blocks, whose
 * joints are found all the same. */
static void
test_walls_stay_or_detach (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  qn_selection_select_all (document->selection, &document->project.model);
  guint count = 0;
  const QnId *ids = qn_selection_get (document->selection, QN_PICK_BLOCK, &count);
  g_autofree QnId *all = g_memdup2 (ids, count * sizeof *ids);
  gsize faces = document->contacts.face_count;

  edit (
    document, transform,
    &(Edit){ .set = { all, count }, .transform = qn_transform_translation (1.0, 2.0) });
  g_assert_cmpuint (document->project.model.wall_count, ==, 1);
  assert_place (document->project.model.walls[0].origin, 1.0, 2.0);

  edit (document, transform,
        &(Edit){ .set = { all, count },
                 .transform = qn_transform_rotation (qn_vec2 (0.0, 0.0), 0.3) });
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->wall_count, ==, 0);
  g_assert_cmpuint (model->block_count, ==, count);
  g_assert_cmpuint (document->contacts.face_count, ==, faces);
  g_assert_cmpint (qn_model_find_block (model, "w.3.2"), !=, QN_NONE);
}

static void
test_delete (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  const QnModel *model = &document->project.model;
  gsize count = model->block_count;
  QnId block = qn_model_find_block (model, "w.11.2");
  edit (document, delete_blocks, &(Edit){ .set = { &block, 1 } });
  model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, count - 1);
  g_assert_cmpuint (model->wall_count, ==, 1);
  /* The courses, from the bottom: 1 to 10, then the one that the block was in. */
  const QnWall *wall = &model->walls[0];
  double gap = 0.0;
  for (int32_t entry = wall->course_ends[9]; entry < wall->course_ends[10]; entry++)
    gap += MIN (wall->lengths[entry], 0.0);
  g_assert_cmpfloat (gap, <, 0.0);

  qn_document_undo (document);
  g_assert_cmpuint (document->project.model.block_count, ==, count);
}

static void
test_array (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  gsize count = document->project.model.block_count;
  QnId block = 1;
  QnVec2 from = document->project.model.blocks[block].centroid;
  edit (document, copy,
        &(Edit){ .set = { &block, 1 },
                 .transform = qn_transform_translation (0.0, 3.0),
                 .copies = 4 });
  const QnModel *model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, count + 4);
  assert_place (model->blocks[count + 3].centroid, from.x, from.y + 12.0);
}

/* A copied voussoir belongs to the ring of the one it is copied from, with its law between rings. */
static gboolean
lay_in_ring (QnModel *model, gpointer data, GError **error)
{
  const Edit *edit = data;
  model->blocks[*edit->set.ids].ring = 2;
  model->blocks[*edit->set.ids].ring_law = 0;
  model->blocks[*edit->set.ids].rigid = true;
  return qn_edit_copy_blocks (model, edit->set, edit->transform, edit->copies, error);
}

static void
test_copies_of_a_ring (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  gsize count = document->project.model.block_count;
  QnId block = 1;
  edit (document, lay_in_ring,
        &(Edit){ .set = { &block, 1 },
                 .transform = qn_transform_translation (0.0, 3.0),
                 .copies = 1 });
  const QnBlock *copied = &document->project.model.blocks[count];
  g_assert_cmpint (copied->ring, ==, 2);
  g_assert_cmpint (copied->ring_law, ==, 0);
  g_assert_true (copied->rigid);
}

static void
test_support (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall1.quoin");
  QnId block = qn_model_find_block (&document->project.model, "w.2.1");
  edit (document, support,
        &(Edit){ .set = { &block, 1 }, .support = { true, false, true } });
  const QnModel *model = &document->project.model;
  const QnBlock *changed = &model->blocks[qn_model_find_block (model, "w.2.1")];
  g_assert_true (changed->support[QN_DOF_UX]);
  g_assert_false (changed->support[QN_DOF_UY]);
  g_assert_true (changed->support[QN_DOF_RZ]);
}

static void
test_nothing_selected (void)
{
  g_autoptr (QnDocument) document = open_example ("01-sliding-block.quoin");
  Edit edit = { .set = { NULL, 0 } };
  ModelEdit funcs[] = { transform, copy, delete_blocks, support };
  for (gsize i = 0; i < G_N_ELEMENTS (funcs); i++) {
    g_autoptr (GError) error = NULL;
    g_assert_false (edit_model (document, "edit", NULL, funcs[i], &edit, &error));
    g_assert_error (error, QN_EDIT_ERROR, 0);
  }
  g_assert_false (document->history->position > 0);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-block/transforms", test_transforms);
  g_test_add_func ("/doc/edit-block/walls-stay-or-detach", test_walls_stay_or_detach);
  g_test_add_func ("/doc/edit-block/delete", test_delete);
  g_test_add_func ("/doc/edit-block/array", test_array);
  g_test_add_func ("/doc/edit-block/copies-of-a-ring", test_copies_of_a_ring);
  g_test_add_func ("/doc/edit-block/support", test_support);
  g_test_add_func ("/doc/edit-block/nothing-selected", test_nothing_selected);
}
