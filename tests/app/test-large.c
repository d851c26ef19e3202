/* A drawing of ten thousand blocks in the window: what a move of one block costs until it is on
 * the screen. */
#include "driver.h"

#include "doc/large-drawing.h"
#include "support/room.h"

/* A move against loading and drawing all of it, both in processor time. */
#define MOST_OF_LOADING 0.8

static void
test_move (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.draw");
  QnDocument *document = qn_window_get_document (window);
  const double begin = large_drawing_seconds ();
  large_drawing_load (document);
  driver_activate (window, "win.fit");
  driver_settle ();
  const double loading = large_drawing_seconds () - begin;
  const QnId block = LARGE_DRAWING_BLOCK;
  qn_selection_set (document->selection, QN_PICK_BLOCK, &block, 1);
  driver_settle ();
  double least = G_MAXDOUBLE;
  for (int i = 0; i < 6; i++) {
    double by = i % 2 == 0 ? 0.01 : -0.01, start = large_drawing_seconds ();
    large_drawing_move (document, by);
    driver_settle ();
    least = MIN (least, large_drawing_seconds () - start);
  }
  g_test_message ("%.4f s until it is drawn, %.4f s for loading it", least, loading);
  g_assert_cmpfloat (least, <, MOST_OF_LOADING * loading);
  driver_screenshot (GTK_WIDGET (window), "large");
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/large/move", test_move);
}
