#include "doc/document/document.h"
#include "doc/edit/edit-masonry.h"
#include "doc/edit/edit-tie.h"
#include "doc/masonry/masonry-shape.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <malloc.h>
#include <string.h>

typedef struct Change {
  QnId object;
  QnMasonryEditFunc func;
  QnBlockSet set;
  QnTransform transform;
  int copies;
  gsize opening;
} Change;

static QnMasonry
make_wall (void)
{
  QnMasonry wall;
  qn_masonry_init (&wall, QN_MASONRY_WALL, NULL);
  wall.unit_weight = 1e4;
  wall.foundation = 0.2;
  wall.wall.height = 2.0;
  wall.wall.leaves[0].length = 3.2;
  wall.wall.leaves[0].unit = qn_vec2 (0.4, 0.2);
  wall.wall.leaves[0].bond = QN_BOND_RUNNING;
  return wall;
}

static gboolean
add_wall (QnProject *draft, gpointer data, GError **error)
{
  (void) data;
  QnMasonry wall = make_wall ();
  return qn_edit_add_masonry (draft, &wall, error);
}

static gboolean
change (QnProject *draft, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_change_masonry (draft, c->object, c->func, NULL, error);
}

static gboolean
transform (QnProject *draft, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_transform (draft, c->set, c->transform, error);
}

static gboolean
copy (QnProject *draft, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_copy (draft, c->set, c->transform, c->copies, error);
}

static gboolean
remove_opening (QnProject *draft, gpointer data, GError **error)
{
  const Change *c = data;
  return qn_edit_remove_opening (draft, c->object, c->opening, error);
}

static gboolean
cut_window (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  QnOpening *opening = qn_masonry_add_opening (masonry);
  g_assert_true (qn_masonry_set_opening_box (masonry, opening, qn_vec2 (1.19, 0.61),
                                             qn_vec2 (2.0, 1.4), TRUE));
  qn_opening_set_head (opening, QN_HEAD_FLAT, QN_SPAN_LINTEL, 0.2);
  return TRUE;
}

static gboolean
make_flat_arch (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  QnOpening *opening = &masonry->wall.openings[0];
  opening->depth = 0.0;
  qn_opening_set_head (opening, QN_HEAD_FLAT, QN_SPAN_FLAT_ARCH, 0.2);
  return TRUE;
}

static gboolean
make_english (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  qn_masonry_set_bond (masonry, QN_BOND_ENGLISH, 0.5);
  return TRUE;
}

static gboolean
make_impossible (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  masonry->wall.height = -1.0;
  return TRUE;
}

static void
apply (QnDocument *document, const char *name, QnEditFunc func, Change *c)
{
  g_autoptr (GError) error = NULL;
  qn_document_edit (document, name, NULL, func, c, &error);
  g_assert_no_error (error);
}

static QnDocument *
document_with_window (void)
{
  QnDocument *document = qn_document_new ();
  Change cut = { .object = 0, .func = cut_window };
  apply (document, "Add Wall", add_wall, NULL);
  apply (document, "Cut Opening", change, &cut);
  return document;
}

static double
free_area (const QnModel *model)
{
  double area = 0.0;
  for (gsize i = 0; i < model->block_count; i++)
    area += model->blocks[i].support[0] ? 0.0 : model->blocks[i].area;
  return area;
}

static QnId
block_called (QnDocument *document, const char *name)
{
  QnId id = qn_model_find_block (&document->project.model, name);
  g_assert_cmpint (id, >=, 0);
  return id;
}

/* Wall, window, flat arch, bond: laid, and every state there again after undo and redo. */
static void
test_parameters (void)
{
  g_autoptr (QnDocument) document = document_with_window ();
  const QnModel *model = &document->project.model;
  g_assert_cmpfloat_with_epsilon (free_area (model), 3.2 * 2.0 - 0.8 * 0.8, 1e-9);
  g_assert_cmpuint (document->contacts.findings.count, ==, 0);
  block_called (document, "w1.o1.lintel");

  Change arch = { .object = 0, .func = make_flat_arch };
  Change bond = { .object = 0, .func = make_english };
  apply (document, "Flat Arch", change, &arch);
  block_called (document, "w1.o1.v1");
  apply (document, "Bond", change, &bond);
  g_assert_cmpfloat_with_epsilon (free_area (&document->project.model),
                                  3.2 * 2.0 - 0.8 * 0.8, 1e-9);

  g_autoptr (GPtrArray) texts = g_ptr_array_new_with_free_func (g_free);
  guint steps = document->history->steps->len;
  g_assert_cmpuint (steps, ==, 4);
  for (guint i = 0; i < steps; i++) {
    g_ptr_array_add (texts, g_strdup (document->text->text));
    g_assert_true (qn_document_undo (document));
  }
  g_assert_cmpuint (document->project.model.block_count, ==, 0);
  for (guint i = steps; i > 0; i--) {
    g_assert_true (qn_document_redo (document));
    g_assert_cmpstr (document->text->text, ==, g_ptr_array_index (texts, i - 1));
  }
}

/* What cannot be laid is refused and changes nothing. */
static void
test_refused (void)
{
  g_autoptr (QnDocument) document = document_with_window ();
  g_autofree char *before = g_strdup (document->text->text);
  g_autoptr (GError) error = NULL;
  Change bad = { .object = 0, .func = make_impossible };
  g_assert_false (qn_document_edit (document, "Bad", NULL, change, &bad, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
  g_clear_error (&error);
  Change none = { .object = 7, .func = make_english };
  g_assert_false (qn_document_edit (document, "Bad", NULL, change, &none, &error));
  g_assert_error (error, QN_EDIT_ERROR, 0);
  g_assert_cmpstr (document->text->text, ==, before);
}

static gboolean
load_block (QnModel *model, gpointer data, GError **error)
{
  QnId block = qn_model_find_block (model, data);
  return qn_edit_add_force (model, block, TRUE, qn_vec2 (1e3, 0.0),
                            model->blocks[block].centroid, error);
}

/* A force stays where it was when its block gets another name, and goes with a block that an
 * opening takes away. */
static void
test_loads_follow (void)
{
  g_autoptr (QnDocument) document = document_with_window ();
  g_autoptr (GError) error = NULL;
  edit_model (document, "Force", NULL, load_block, (gpointer) "w1.10.3", &error);
  g_assert_no_error (error);
  const QnModel *model = &document->project.model;
  gsize loads = model->live_load_count;
  QnVec2 at = model->live_loads[loads - 1].at;

  Change bond = { .object = 0, .func = make_english };
  apply (document, "Bond", change, &bond);
  model = &document->project.model;
  g_assert_cmpuint (model->live_load_count, ==, loads);
  g_assert_cmpfloat (model->live_loads[loads - 1].at.x, ==, at.x);

  qn_document_undo (document);
  edit_model (document, "Force", NULL, load_block, (gpointer) "w1.o1.lintel", &error);
  g_assert_no_error (error);
  Change closed = { .object = 0, .opening = 0 };
  apply (document, "Remove Opening", remove_opening, &closed);
  model = &document->project.model;
  g_assert_cmpfloat_with_epsilon (free_area (model), 3.2 * 2.0, 1e-9);
  g_assert_cmpuint (model->live_load_count, ==, loads + 1);
}

static gboolean
tie_to_ground (QnModel *model, gpointer data, GError **error)
{
  return qn_edit_draw_tie (model, *(const QnVec2 *) data, qn_vec2 (9, 3), error);
}

/* A wall that is moved or turned as a whole stays parametric, and so do its copies; part of it
 * does not. What is fixed to it goes along. */
static void
test_transform (void)
{
  g_autoptr (QnDocument) document = document_with_window ();
  const QnModel *model = &document->project.model;
  g_autofree QnId *all = g_new (QnId, model->block_count);
  for (gsize i = 0; i < model->block_count; i++)
    all[i] = (QnId) i;
  QnVec2 before = model->blocks[block_called (document, "w1.10.3")].centroid;
  g_assert_true (edit_model (document, "Tie", NULL, tie_to_ground, &before, NULL));
  Change turn = { .set = { all, (guint) model->block_count },
                  .transform = qn_transform_rotation (qn_vec2 (0.0, 0.0), 0.3) };
  apply (document, "Rotate", transform, &turn);
  model = &document->project.model;
  QnVec2 after = model->blocks[block_called (document, "w1.10.3")].centroid;
  QnVec2 expected = qn_transform_apply (turn.transform, before);
  g_assert_cmpfloat_with_epsilon (after.x, expected.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (after.y, expected.y, 1e-12);
  g_assert_cmpint (model->blocks[0].masonry, ==, 0);
  g_assert_cmpfloat_with_epsilon (model->ties[0].ends[0].at.x, expected.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (model->ties[0].ends[0].at.y, expected.y, 1e-12);

  gsize count = model->block_count;
  Change more = { .set = { all, (guint) count },
                  .transform = qn_transform_translation (5.0, 0.0),
                  .copies = 2 };
  apply (document, "Array", copy, &more);
  model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, 3 * count);
  g_assert_cmpint (model->blocks[block_called (document, "w3.1.1")].masonry, ==, 2);

  QnId one = block_called (document, "w1.10.3");
  Change part = { .set = { &one, 1 }, .transform = qn_transform_translation (0.0, 0.5) };
  apply (document, "Move", transform, &part);
  model = &document->project.model;
  g_assert_cmpuint (model->block_count, ==, 3 * count);
  g_assert_cmpint (model->blocks[block_called (document, "w1.1.1")].masonry, ==, QN_NONE);
  g_assert_cmpint (model->blocks[block_called (document, "w3.1.1")].masonry, ==, 1);

  /* A mirror takes it apart. */
  QnId in = block_called (document, "w2.1.1");
  g_autoptr (GArray) w2 = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    if (model->blocks[i].masonry == model->blocks[in].masonry)
      g_array_append_val (w2, i);
  }
  Change mirror = { .set = { (const QnId *) w2->data, w2->len },
                    .transform = qn_transform_mirror (qn_vec2 (0, 0), qn_vec2 (0, 1)) };
  apply (document, "Mirror", transform, &mirror);
  model = &document->project.model;
  g_assert_cmpint (model->blocks[block_called (document, "w2.1.1")].masonry, ==, QN_NONE);
  g_assert_cmpuint (model->block_count, ==, 3 * count);
}

/* A thousand times back and forth holds no more memory than a hundred times. */
static void
test_no_growth (void)
{
  g_autoptr (QnDocument) document = document_with_window ();
  gsize after_hundred = 0;
  for (int i = 0; i < 1000; i++) {
    g_assert_true (qn_document_undo (document));
    g_assert_true (qn_document_redo (document));
    if (i == 99)
      after_hundred = mallinfo2 ().uordblks;
  }
  g_assert_cmpuint (mallinfo2 ().uordblks, <=, after_hundred + 64 * 1024);
}

QN_TESTS
{
  g_test_add_func ("/doc/edit-masonry/parameters", test_parameters);
  g_test_add_func ("/doc/edit-masonry/refused", test_refused);
  g_test_add_func ("/doc/edit-masonry/loads-follow", test_loads_follow);
  g_test_add_func ("/doc/edit-masonry/transform", test_transform);
  g_test_add_func ("/doc/edit-masonry/no-growth", test_no_growth);
}
