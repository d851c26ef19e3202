#include "doc/document/bounds.h"

#include "doc/document/run.h"
#include "doc/fixture.h"
#include "support/edit-model.h"
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
  double bounds[QN_BOUND_KIND_COUNT];
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 0);
  g_assert_null (qn_bounds_dup_verdict (bounds));
  g_autofree char *nothing = qn_bounds_dup_text (bounds);
  g_assert_cmpstr (nothing, ==, "");

  analyse (document, QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE);
  qn_bounds_collect (document, bounds);
  g_assert_cmpfloat_with_epsilon (bounds[QN_BOUND_UPPER], 0.4037, 1e-4);
  g_autofree char *by_path = qn_bounds_dup_verdict (bounds);
  g_assert_nonnull (strstr (by_path, "below the associative bound"));
  analyse (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE);
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==,
                    3); /* its jump at 0.2604 is no snap */
  double path = bounds[QN_BOUND_PATH], upper = bounds[QN_BOUND_UPPER];
  g_assert_cmpfloat_with_epsilon (path, 0.3558, 1e-3);
  g_assert_cmpfloat (bounds[QN_BOUND_LOWER], <=, upper * (1.0 + 1e-9));
  g_assert_cmpfloat (path, <, upper);
  g_autofree char *verdict = qn_bounds_dup_verdict (bounds);
  g_autofree char *share = g_strdup_printf ("%.1f %%", 100.0 * (upper - path) / upper);
  g_assert_nonnull (strstr (verdict, share));
  g_autofree char *text = qn_bounds_dup_text (bounds);
  g_auto (GStrv) paragraphs = g_strsplit (text, "\n\n", -1);
  g_assert_cmpuint (g_strv_length (paragraphs), ==, 4);
  g_assert_true (
    g_str_has_prefix (text, "HybriDFEM, collapse multiplier of the path: 0.3558. Equil"));

  /* What was solved before an edit says nothing about the model after it. */
  g_assert_true (edit_model (document, "Nudge", NULL, nudge, NULL, NULL));
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 0);
  g_assert_true (qn_document_undo (document));
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 3);
}

/* A block that can only overturn: path and limit agree. */
static void
test_agreement (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  analyse (document, QN_PROCEDURE_LOAD, QN_FLOW_ASSOCIATIVE);
  analyse (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE);
  double bounds[QN_BOUND_KIND_COUNT];
  /* No first limit point apart from the last. */
  g_assert_cmpuint (qn_bounds_collect (document, bounds), ==, 3);
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
    const double bounds[QN_BOUND_KIND_COUNT] = {
      [QN_BOUND_PATH] = cases[i].path,
      [QN_BOUND_FIRST_LIMIT] = NAN,
      [QN_BOUND_LOWER] = NAN,
      [QN_BOUND_UPPER] = 0.4,
      [QN_BOUND_LEAST] = cases[i].least,
      [QN_BOUND_GREATEST] = cases[i].greatest,
    };
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
  const QnRun *run = document->run;
  guint told;
  g_autofree char *events = qn_run_dup_events (run, QN_UNITS_SI, &told);
  g_assert_cmpuint (told, ==, 1);
  g_assert_true (g_str_has_prefix (events, "Multiplier 0.2864: collapse"));
  g_assert_null (strchr (events, '\n'));
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
    g_autofree char *jumps = qn_run_dup_events (run, QN_UNITS_SI, &told);
    g_assert_null (strchr (jumps, '\n'));
    g_assert_cmpuint (told, ==, cases[i].told);
    g_assert_nonnull (strstr (jumps, cases[i].said));
  }
}

QN_TESTS
{
  g_test_add_func ("/doc/bounds/wall", test_wall);
  g_test_add_func ("/doc/bounds/agreement", test_agreement);
  g_test_add_func ("/doc/bounds/interval", test_interval);
  g_test_add_func ("/doc/bounds/events", test_events);
}
