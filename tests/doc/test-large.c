/* Editing a large drawing: one block of ten thousand moves within the patience of a hand. */
#include "doc/document.h"
#include "doc/edit-masonry.h"

#include <string.h>
#include <sys/resource.h>

/* s of processor time; sanitizers take their share. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SLOWER 10
#else
#define SLOWER 1
#endif
#define MOST_PER_EDIT (0.1 * SLOWER)

#define COURSES 100
#define LENGTH  100

/* A running bond of single blocks on a foundation. */
static char *
make_wall (void)
{
  GString *text = g_string_new (
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "    \"friction\": 0.6 } ], \"contact\": { \"law\": \"dry\" }, \"blocks\": [");
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
  const QnId block = 5050;
  return qn_edit_transform (draft, (QnBlockSet){ &block, 1 },
                            qn_transform_translation (0, *(const double *) data), error);
}

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
  g_autofree char *text = make_wall ();
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_text (document, text, "wall", &error);
  g_assert_no_error (error);
  /* Coordinates of many digits, as sines and thirds make them. */
  qn_document_edit_project (document, "Move", NULL, move_all, NULL, &error);
  g_assert_no_error (error);
  double least = G_MAXDOUBLE;
  for (int i = 0; i < 6; i++) {
    double by = i % 2 == 0 ? 0.01 : -0.01, start = cpu_seconds ();
    qn_document_edit_project (document, "Move", NULL, move_one, &by, &error);
    least = MIN (least, cpu_seconds () - start);
    g_assert_no_error (error);
  }
  g_test_message ("%.4f s per edit", least);
  g_assert_cmpfloat (least, <, MOST_PER_EDIT);
  check_state (document);
  double start = cpu_seconds ();
  g_assert_true (qn_document_undo (document));
  g_test_message ("%.4f s to undo it", cpu_seconds () - start);
  g_assert_cmpfloat (cpu_seconds () - start, <, MOST_PER_EDIT);
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
