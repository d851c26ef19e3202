#include "large-drawing.h"

#include "doc/edit/edit-masonry.h"

#include <sys/resource.h>

#define COURSES 100
#define LENGTH  100

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

void
large_drawing_load (QnDocument *document)
{
  g_autofree char *text = make_wall ();
  g_autoptr (GError) error = NULL;
  qn_document_load_recovered (document, text, NULL, &error);
  g_assert_no_error (error);
}

static gboolean
move_one (QnProject *draft, gpointer data, GError **error)
{
  const QnId block = LARGE_DRAWING_BLOCK;
  return qn_edit_transform (draft, (QnBlockSet){ &block, 1 },
                            qn_transform_translation (0, *(const double *) data), error);
}

void
large_drawing_move (QnDocument *document, double by)
{
  g_autoptr (GError) error = NULL;
  qn_document_edit (document, "Move", NULL, move_one, &by, &error);
  g_assert_no_error (error);
}

double
large_drawing_seconds (void)
{
  struct rusage usage;
  getrusage (RUSAGE_SELF, &usage);
  return (double) usage.ru_utime.tv_sec + (double) usage.ru_stime.tv_sec
         + 1e-6 * (double) (usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}
