/* A drawing of ten thousand blocks in the window: what a move of one block costs until it is on
 * the screen. */
#include "driver.h"

#include "doc/edit-masonry.h"

#include <sys/resource.h>

/* s of processor time; sanitizers take their share. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SLOWER 10
#else
#define SLOWER 1
#endif
#define MOST_UNTIL_DRAWN (0.2 * SLOWER)

#define COURSES 100
#define LENGTH  100
#define MOVED   5050

/* A running bond of single blocks on a foundation. */
static char *
make_wall (void)
{
  GString *text = g_string_new (
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ], \"contact\": { \"law\": \"dry\" },"
    "  \"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],"
    "    \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] }, \"blocks\": [");
  for (int y = 0; y < COURSES; y++)
    for (int x = 0; x < LENGTH; x++) {
      double left = 0.4 * x + (y % 2) * 0.2, low = 0.175 * y;
      g_string_append_printf (text,
                              "%s{ \"name\": \"b%d.%d\", \"vertices\": [[%.10g,%.10g],"
                              "[%.10g,%.10g],[%.10g,%.10g],[%.10g,%.10g]],"
                              "\"thickness\": 1, \"unit_weight\": 1e4%s }",
                              x + y > 0 ? ",\n" : "\n", y, x, left, low, left + 0.4, low,
                              left + 0.4, low + 0.175, left, low + 0.175,
                              y == 0 ? ", \"support\": [true, true, true]" : "");
    }
  g_string_append (text, "] }");
  return g_string_free (text, FALSE);
}

static double
cpu_seconds (void)
{
  struct rusage usage;
  getrusage (RUSAGE_SELF, &usage);
  return (double) usage.ru_utime.tv_sec + (double) usage.ru_stime.tv_sec
         + 1e-6 * (double) (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static gboolean
move_one (QnProject *draft, gpointer data, GError **error)
{
  const QnId block = MOVED;
  return qn_edit_transform (draft, (QnBlockSet){ &block, 1 },
                            qn_transform_translation (0, *(const double *) data), error);
}

static void
test_move (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.draw");
  QnDocument *document = qn_window_get_document (window);
  g_autofree char *text = make_wall ();
  g_autoptr (GError) error = NULL;
  qn_document_load_text (document, text, "wall", &error);
  g_assert_no_error (error);
  driver_activate (window, "win.fit");
  const QnId block = MOVED;
  qn_selection_set_blocks (qn_document_get_selection (document), &block, 1);
  driver_run (1500);
  double least = G_MAXDOUBLE;
  for (int i = 0; i < 6; i++) {
    double by = i % 2 == 0 ? 0.01 : -0.01, start = cpu_seconds ();
    qn_document_edit_project (document, "Move", NULL, move_one, &by, &error);
    g_assert_no_error (error);
    driver_run (400);
    least = MIN (least, cpu_seconds () - start);
  }
  g_test_message ("%.4f s until it is drawn", least);
  g_assert_cmpfloat (least, <, MOST_UNTIL_DRAWN);
  driver_screenshot (GTK_WIDGET (window), "large");
  driver_discard (window);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  gtk_init ();
  g_test_add_func ("/app/large/move", test_move);
  return g_test_run ();
}
