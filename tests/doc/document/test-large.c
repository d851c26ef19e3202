/* Editing a large drawing: one block of ten thousand moves within the patience of a hand. */
#include "doc/large-drawing.h"

#include "doc/edit/edit-masonry.h"

#include <string.h>

/* s of processor time */
#define MOST_PER_EDIT (0.1 * LARGE_DRAWING_SLOWER)

static gboolean
move_all (QnProject *draft, gpointer data, GError **error)
{
  (void) data;
  g_autofree QnId *ids = g_new (QnId, draft->model.block_count);
  for (gsize i = 0; i < draft->model.block_count; i++)
    ids[i] = (QnId) i;
  return qn_edit_transform (draft, (QnBlockSet){ ids, (guint) draft->model.block_count },
                            qn_transform_translation (1.0 / 3, 0), error);
}

/* The text, read as a whole, is the model that is at hand. */
static void
check_state (QnDocument *document)
{
  const char *text = qn_document_get_text (document);
  const QnModel *model = qn_document_get_model (document);
  g_autoptr (GError) error = NULL;
  QnProject whole;
  qn_project_parse (text, strlen (text), "whole", NULL, &whole, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (whole.model.block_count, ==, model->block_count);
  for (gsize i = 0; i < model->block_count; i++) {
    g_assert_cmpstr (whole.model.blocks[i].name, ==, model->blocks[i].name);
    g_assert_cmpfloat (whole.model.blocks[i].centroid.x, ==, model->blocks[i].centroid.x);
    g_assert_cmpfloat (whole.model.blocks[i].centroid.y, ==, model->blocks[i].centroid.y);
  }
  qn_project_clear (&whole);
}

static void
test_move (void)
{
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  large_drawing_load (document);
  /* Coordinates of many digits, as sines and thirds make them. */
  qn_document_edit_project (document, "Move", NULL, move_all, NULL, &error);
  g_assert_no_error (error);
  double least = G_MAXDOUBLE;
  for (int i = 0; i < 6; i++) {
    double by = i % 2 == 0 ? 0.01 : -0.01, start = large_drawing_seconds ();
    large_drawing_move (document, by);
    least = MIN (least, large_drawing_seconds () - start);
  }
  g_test_message ("%.4f s per edit", least);
  g_assert_cmpfloat (least, <, MOST_PER_EDIT);
  check_state (document);
  double start = large_drawing_seconds ();
  g_assert_true (qn_document_undo (document));
  g_test_message ("%.4f s to undo it", large_drawing_seconds () - start);
  g_assert_cmpfloat (large_drawing_seconds () - start, <, MOST_PER_EDIT);
  check_state (document);
  while (qn_document_undo (document))
    ;
  check_state (document);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/large/move", test_move);
  return g_test_run ();
}
