#include "doc/document/bounds.h"

#include "doc/fixture.h"

#include <math.h>
#include <string.h>

static void
analyse (QnDocument *document, QnProcedure procedure, QnFlow flow)
{
  g_autoptr (GError) error = NULL;
  qn_document_analyse_with (document, procedure, flow, &error);
  g_assert_no_error (error);
  wait_for_job (document);
}

static gboolean
nudge (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->laws[0].friction *= 0.9;
  return TRUE;
}

/* Path and both limit analyses of wall 3: the numbers, their order, and what is said of them. */
static void
test_wall (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  g_autoptr (GArray) empty = qn_bounds_collect (document);
  g_assert_cmpuint (empty->len, ==, 0);
  g_assert_null (qn_bounds_dup_verdict (empty));

  analyse (document, QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE);
  analyse (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE);
  g_autoptr (GArray) bounds = qn_bounds_collect (document);
  g_assert_cmpuint (bounds->len, ==, 4);
  double path = g_array_index (bounds, QnBound, 0).value;
  double first_limit = g_array_index (bounds, QnBound, 1).value;
  double lower = g_array_index (bounds, QnBound, 2).value;
  double upper = g_array_index (bounds, QnBound, 3).value;
  g_assert_cmpfloat_with_epsilon (path, 0.3558, 1e-3);
  g_assert_cmpfloat_with_epsilon (first_limit, 0.2603, 2e-3);
  g_assert_cmpfloat (lower, <=, upper * (1.0 + 1e-9));
  g_assert_cmpfloat (path, <, upper);
  for (guint i = 0; i < bounds->len; i++)
    g_assert_cmpuint (strlen (g_array_index (bounds, QnBound, i).guarantee), >, 20);
  g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
  g_autofree char *share = g_strdup_printf ("%.1f %%", 100.0 * (upper - path) / upper);
  g_assert_nonnull (strstr (verdict, share));

  /* What was solved before an edit says nothing about the model after it. */
  g_assert_true (qn_document_edit (document, "Nudge", NULL, nudge, NULL, NULL));
  g_autoptr (GArray) stale = qn_bounds_collect (document);
  g_assert_cmpuint (stale->len, ==, 0);
  g_assert_true (qn_document_undo (document));
  g_autoptr (GArray) again = qn_bounds_collect (document);
  g_assert_cmpuint (again->len, ==, 4);
}

/* A block that can only overturn: path and limit agree. */
static void
test_agreement (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  analyse (document, QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE);
  analyse (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE);
  g_autoptr (GArray) bounds = qn_bounds_collect (document);
  g_assert_cmpuint (bounds->len, ==, 3); /* no first limit point apart from the last */
  g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
  g_assert_nonnull (strstr (verdict, "reaches the bound"));
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/doc/bounds/wall", test_wall);
  g_test_add_func ("/doc/bounds/agreement", test_agreement);
  return g_test_run ();
}
