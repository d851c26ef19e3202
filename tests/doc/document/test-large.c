/* Editing a large drawing: what moving one block of ten thousand costs, in instructions.
 *
 *   test-doc-large --move
 *
 * loads the drawing and moves a block: what runs under callgrind. */
#include "doc/large-drawing.h"

#include "doc/edit/edit-masonry.h"
#include "fixture.h"
#include "support/instructions.h"

/* Reading ten thousand blocks takes 500 million, writing them 400 million: an edit copies what did
 * not change. Of 200 million (gcc; clang 300) the contacts, which are detected anew, take 100. */
#define MOST_PER_MOVE 350e6

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

/* The drawing with coordinates of many digits, as sines and thirds make them. */
static QnDocument *
open_large (void)
{
  g_autoptr (GError) error = NULL;
  QnDocument *document = qn_document_new ();
  large_drawing_load (document);
  qn_document_edit (document, "Move", NULL, move_all, NULL, &error);
  g_assert_no_error (error);
  return document;
}

static void
test_state (void)
{
  g_autoptr (QnDocument) document = open_large ();
  check_state (document);
  large_drawing_move (document, 0.01);
  check_state (document);
  large_drawing_move (document, -0.01);
  check_state (document);
  for (int left = 3; left > 0; left--) {
    g_assert_true (qn_document_undo (document));
    check_state (document);
  }
  g_assert_false (qn_document_undo (document));
}

static int
move_once (void)
{
  g_autoptr (QnDocument) document = qn_document_new ();
  large_drawing_load (document);
  large_drawing_move (document, 0.01);
  return 0;
}

static void
test_instructions (gconstpointer data)
{
  const char *const arguments[] = { data, "--move", NULL };
  double move = count_instructions (arguments, "large_drawing_move", NULL);
  if (move == 0) {
    g_test_skip ("instructions cannot be counted here");
    return;
  }
  g_test_message ("%.1f million instructions to move a block", 1e-6 * move);
  g_assert_cmpfloat (move, >, 1e6); /* something was counted */
  g_assert_cmpfloat (move, <, MOST_PER_MOVE);
}

int
main (int argc, char **argv)
{
  if (argc == 2 && g_str_equal (argv[1], "--move"))
    return move_once ();
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/large/state", test_state);
  g_test_add_data_func ("/doc/large/instructions", argv[0], test_instructions);
  return g_test_run ();
}
