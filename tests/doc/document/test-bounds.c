#include "doc/document/bounds.h"

#include "doc/document/run.h"
#include "doc/fixture.h"
#include "support/room.h"

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
  g_autoptr (GArray) alone = qn_bounds_collect (document);
  g_assert_cmpfloat_with_epsilon (qn_bounds_find (alone, QN_BOUND_UPPER), 0.4037, 1e-4);
  g_autofree char *by_path = qn_bounds_dup_verdict (alone);
  g_assert_nonnull (strstr (by_path, "below the associative bound"));
  analyse (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE);
  g_autoptr (GArray) bounds = qn_bounds_collect (document);
  g_assert_cmpuint (bounds->len, ==, 3); /* its jump at 0.2604 is no snap */
  double path = g_array_index (bounds, QnBound, 0).value;
  double lower = g_array_index (bounds, QnBound, 1).value;
  double upper = g_array_index (bounds, QnBound, 2).value;
  g_assert_cmpfloat_with_epsilon (path, 0.3558, 1e-3);
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
  g_assert_cmpuint (again->len, ==, 3);
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
  g_assert_nonnull (strstr (verdict, "To be used: "));
}

/* "Within the interval" is said of what lies in it, and of nothing else. */
static void
test_interval (void)
{
  const struct {
    double path, least, greatest;
    const char *said;
  } cases[] = {
    { 0.300, 0.300, 0.350, "within the interval" },
    { 0.320, 0.300, 0.350, "within the interval" },
    { 0.350, 0.300, 0.350, "within the interval" },
    { 0.29999, 0.300, 0.350, "within the interval" },
    { 0.298, 0.300, 0.350, "0.7 % below the least value" },
    { 0.200, 0.300, 0.350, "33.3 % below the least value" },
    { 0.352, 0.300, 0.350, "0.6 % above the greatest value" },
    { 0.300, NAN, NAN, "can be the cause" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    const QnBound all[] = { { QN_BOUND_PATH, "path", cases[i].path, "" },
                            { QN_BOUND_UPPER, "upper", 0.4, "" },
                            { QN_BOUND_LEAST, "least", cases[i].least, "" },
                            { QN_BOUND_GREATEST, "greatest", cases[i].greatest, "" } };
    g_autoptr (GArray) bounds = g_array_new (FALSE, FALSE, sizeof (QnBound));
    g_array_append_vals (bounds, all, isnan (cases[i].least) ? 2 : 4);
    g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
    g_assert_nonnull (strstr (verdict, cases[i].said));
    g_assert_true (strstr (cases[i].said, "within") != NULL
                   || strstr (verdict, "within") == NULL);
  }
}

/* Events of a path with their size, and the mechanism in one sentence. */
static void
test_events (void)
{
  g_autoptr (QnDocument) document = open_example ("06-arch.quoin");
  analyse (document, QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE);
  const QnRun *run = qn_document_get_run (document);
  guint told;
  g_autoptr (GPtrArray) events = qn_run_dup_events (run, QN_UNITS_SI, &told);
  g_assert_cmpuint (events->len, ==, 1);
  g_assert_cmpuint (told, ==, 1);
  g_assert_nonnull (strstr (events->pdata[0], "Multiplier 0.2864: collapse"));
  g_autofree char *sentence = qn_run_dup_mechanism_sentence (run);
  g_assert_cmpstr (sentence, ==, "Hinges as in an arch: 4 joints hinge.");
  /* A jump is told by how far it goes. */
  QnPathEvent *event = &((QnResult *) &run->result)->events[0];
  event->displacement_before = 0.003;
  event->displacement_after = 0.005;
  /* Those of joints that settle, and those at a load that is not felt, are counted. */
  static const struct {
    QnEventKind kind;
    double multiplier;
    guint told;
    const char *said;
  } cases[] = {
    { QN_EVENT_KIND_SNAP, 0.2, 1,
      "a jump, the largest displacement grows from 3\302\240mm to 5\302\240mm" },
    { QN_EVENT_KIND_SNAP, 1e-5, 0, "1 small jump" },
    { QN_EVENT_KIND_LOCAL, 0.2, 0, "1 small jump" },
    { QN_EVENT_KIND_BUCKLING, 0.2, 1, "buckles" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    event->kind = cases[i].kind;
    event->multiplier = cases[i].multiplier;
    g_autoptr (GPtrArray) jumps = qn_run_dup_events (run, QN_UNITS_SI, &told);
    g_assert_cmpuint (jumps->len, ==, 1);
    g_assert_cmpuint (told, ==, cases[i].told);
    g_assert_nonnull (strstr (jumps->pdata[0], cases[i].said));
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/bounds/wall", test_wall);
  g_test_add_func ("/doc/bounds/agreement", test_agreement);
  g_test_add_func ("/doc/bounds/interval", test_interval);
  g_test_add_func ("/doc/bounds/events", test_events);
}
