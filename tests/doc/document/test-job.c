#include "doc/document/job.h"
#include "doc/document/run.h"

#include "doc/fixture.h"
#include "doc/long-analysis.h"
#include "support/room.h"

#include <string.h>

typedef struct Outcome {
  gboolean done;
  GPtrArray *runs;
  QnRun *run; /* the first of them */
  QnDiag diag;
  GError *error;
} Outcome;

static void
on_done (GObject *source, GAsyncResult *result, gpointer data)
{
  Outcome *outcome = data;
  outcome->runs =
    qn_job_finish (QN_JOB (source), result, &outcome->diag, &outcome->error);
  outcome->run = outcome->runs != NULL ? outcome->runs->pdata[0] : NULL;
  outcome->done = TRUE;
}

static void
wait_for (Outcome *outcome)
{
  while (!outcome->done)
    g_main_context_iteration (NULL, TRUE);
}

static void
outcome_clear (Outcome *outcome)
{
  g_clear_pointer (&outcome->runs, g_ptr_array_unref);
  g_clear_error (&outcome->error);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Outcome, outcome_clear)

static QnJob *
make_job_of (QnDocument *document)
{
  g_autoptr (GError) error = NULL;
  QnJob *job = qn_job_new (&document->project.model, "one", "mark", &error);
  g_assert_no_error (error);
  return job;
}

static QnJob *
make_job (const char *example)
{
  g_autoptr (QnDocument) document = open_example (example);
  return make_job_of (document); /* the document goes; the job keeps a model of its own */
}

static void
test_finish (void)
{
  g_autoptr (QnJob) job = make_job ("02-overturning-block.quoin");
  g_auto (Outcome) outcome = { 0 };
  qn_job_start (job, on_done, &outcome);
  wait_for (&outcome);
  g_assert_no_error (outcome.error);
  g_assert_cmpint (outcome.run->result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpfloat_with_epsilon (outcome.run->result.collapse_multiplier, 0.5, 1e-4);
  g_assert_cmpstr (outcome.run->name, ==, "one");
  g_assert_cmpstr (outcome.run->fingerprint, ==, "mark");
  g_assert_false (outcome.run->live);
}

/* The same analysis twice is the same bit for bit, in threads as elsewhere. */
static void
test_repeatable (void)
{
  double multipliers[2];
  for (int i = 0; i < 2; i++) {
    g_autoptr (QnJob) job = make_job ("ferris-tin-loi/wall1.quoin");
    g_auto (Outcome) outcome = { 0 };
    qn_job_start (job, on_done, &outcome);
    wait_for (&outcome);
    g_assert_no_error (outcome.error);
    multipliers[i] = outcome.run->result.collapse_multiplier;
  }
  g_assert_cmpfloat (multipliers[0], ==, multipliers[1]);
}

static void
spin (guint milliseconds)
{
  gint64 end = g_get_monotonic_time () + milliseconds * 1000;
  while (g_get_monotonic_time () < end)
    if (!g_main_context_iteration (NULL, FALSE))
      g_usleep (2000);
}

/* While it is paused it does not advance; afterwards it ends as if nothing had been. */
static void
test_pause (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall6.quoin");
  long_analysis_ask (document);
  g_autoptr (QnJob) job = make_job_of (document);
  g_auto (Outcome) outcome = { 0 };
  qn_job_set_paused (job, TRUE);
  qn_job_start (job, on_done, &outcome);
  spin (150);
  g_assert_true (qn_job_is_paused (job));
  QnProgress first = qn_job_get_progress (job);
  spin (150);
  QnProgress second = qn_job_get_progress (job);
  g_assert_cmpint (first.iterations, ==, second.iterations);
  g_assert_false (outcome.done);

  qn_job_set_paused (job, FALSE);
  gsize count = 0;
  while (count < 3 && !outcome.done) {
    g_main_context_iteration (NULL, TRUE);
    qn_job_get_curve (job, &count);
  }
  g_assert_cmpuint (count, >=, 3);
  const QnVec2 *curve = qn_job_get_curve (job, &count);
  g_assert_cmpfloat (curve[1].x, >, curve[0].x);
  double reached = curve[count - 1].x;

  /* Cancelling keeps what has converged. */
  qn_job_set_paused (job, TRUE);
  qn_job_cancel (job);
  wait_for (&outcome);
  g_assert_no_error (outcome.error);
  g_assert_cmpint (outcome.run->result.outcome, ==, QN_OUTCOME_CANCELLED);
  gsize last = outcome.run->result.step_count - 1;
  g_assert_cmpfloat (outcome.run->result.steps[last].time, >=, reached);
}

/* An analysis in time tells its history and when it ends. */
static void
test_history (void)
{
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall6.quoin");
  long_analysis_ask (document);
  g_autoptr (QnJob) job = make_job_of (document);
  g_auto (Outcome) outcome = { 0 };
  QnId block;
  QnDof dof;
  gsize count = 0;
  double duration = document->project.model.analysis.dynamic.duration;
  g_assert_cmpfloat (qn_job_get_followed (job, &block, &dof), ==, duration);
  g_assert_cmpint (block, !=, QN_NONE);
  qn_job_start (job, on_done, &outcome);
  while ((count < 3 || qn_job_get_remaining (job) < 0.0) && !outcome.done) {
    g_main_context_iteration (NULL, TRUE);
    qn_job_get_curve (job, &count);
  }
  g_assert_cmpuint (count, >=, 3);
  const QnVec2 *curve = qn_job_get_curve (job, &count);
  g_assert_cmpfloat (curve[0].x, >=, 0.0);
  for (gsize i = 1; i < count; i++)
    g_assert_cmpfloat (curve[i].x, >, curve[i - 1].x);
  QnProgress progress = qn_job_get_progress (job);
  g_assert_cmpfloat (progress.end, ==, duration);
  g_assert_cmpfloat (progress.time, >=, curve[count - 1].x);
  qn_job_cancel (job);
  wait_for (&outcome);
  g_assert_no_error (outcome.error);
  g_assert_cmpint (outcome.run->result.outcome, ==, QN_OUTCOME_CANCELLED);
}

static void
test_cancelled_at_once (void)
{
  g_autoptr (QnJob) job = make_job ("ferris-tin-loi/wall6.quoin");
  g_auto (Outcome) outcome = { 0 };
  qn_job_cancel (job);
  qn_job_start (job, on_done, &outcome);
  wait_for (&outcome);
  /* Before the first step there is nothing to keep. */
  if (outcome.run == NULL)
    g_assert_error (outcome.error, G_IO_ERROR, G_IO_ERROR_CANCELLED);
  else
    g_assert_cmpint (outcome.run->result.outcome, ==, QN_OUTCOME_CANCELLED);
}

/* What cannot be analysed is an error that names the block. */
static void
test_unsound (void)
{
  static const char text[] =
    "{ \"format\": \"quoin\", \"version\": 1,"
    "  \"laws\": [ { \"name\": \"j\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
    "               \"friction\": 0.6 } ],"
    "  \"blocks\": ["
    "    { \"name\": \"ground\", \"vertices\": [[0,0],[1,0],[1,1],[0,1]], \"thickness\": "
    "1,"
    "      \"unit_weight\": 1, \"support\": [true, true, true] },"
    "    { \"name\": \"cloud\", \"vertices\": [[0,3],[1,3],[1,4],[0,4]], \"thickness\": "
    "1,"
    "      \"unit_weight\": 1 } ],"
    "  \"contact\": { \"law\": \"j\" } }";
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (GError) error = NULL;
  qn_document_load_recovered (document, text, NULL, &error);
  g_assert_no_error (error);
  g_autoptr (QnJob) job = qn_job_new (&document->project.model, "one", "mark", &error);
  g_auto (Outcome) outcome = { 0 };
  qn_job_start (job, on_done, &outcome);
  wait_for (&outcome);
  g_assert_error (outcome.error, QN_EDIT_ERROR, 0);
  g_assert_nonnull (strstr (outcome.error->message, "cloud"));
  g_assert_cmpint (outcome.diag.entity, ==, QN_ENTITY_BLOCK);
  g_assert_cmpint (outcome.diag.index, ==, 1);
}

/* A run for every mode, the first from the job itself; they share model and contacts, and outlive
 * each other. */
static void
test_modes (void)
{
  g_autoptr (QnJob) job = make_job ("11-vibrating-beam.quoin");
  Outcome outcome = { 0 };
  qn_job_get_run (job)->kind = QN_RUN_MODE;
  qn_job_get_run (job)->mode_count = 3;
  qn_job_start (job, on_done, &outcome);
  wait_for (&outcome);
  g_assert_no_error (outcome.error);
  g_assert_cmpuint (outcome.runs->len, ==, 3);
  g_assert_cmpint (outcome.run->kind, ==, QN_RUN_MODE);
  g_assert_cmpuint (outcome.run->result.vibration.mode, ==, 1);
  g_assert_cmpuint (outcome.run->mode_count, ==, 3);
  g_assert_cmpfloat_with_epsilon (outcome.run->result.vibration.omega, 315.711, 0.01);
  g_autoptr (QnRun) second = qn_run_ref (outcome.runs->pdata[1]);
  g_assert_cmpfloat_with_epsilon (second->result.vibration.omega, 1150.488, 0.01);
  g_assert_true (second->model.blocks == outcome.run->model.blocks);
  g_assert_nonnull (second->result.mechanism);
  g_assert_cmpuint (second->result.step_count, ==, 1);
  g_autofree char *title = qn_run_dup_title (second);
  g_assert_nonnull (strstr (title, "183.1 Hz"));
  g_autofree char *words = qn_run_dup_explanation (second);
  g_assert_nonnull (strstr (words, "2 of 3"));
  outcome_clear (&outcome);
  g_assert_cmpstr (second->model.blocks[0].name, !=, "");
}

/* The Euler load of a pinned column. */
static void
test_stability (void)
{
  g_autoptr (QnJob) job = make_job ("21-column-pinned.quoin");
  g_auto (Outcome) outcome = { 0 };
  qn_job_get_run (job)->kind = QN_RUN_STABILITY;
  qn_job_start (job, on_done, &outcome);
  wait_for (&outcome);
  g_assert_no_error (outcome.error);
  g_assert_cmpint (outcome.run->result.outcome, ==, QN_OUTCOME_SNAP);
  g_assert_cmpfloat_with_epsilon (outcome.run->result.first_limit_multiplier, 2470.2,
                                  0.1);
  g_autofree char *title = qn_run_dup_title (outcome.run);
  g_assert_nonnull (strstr (title, "2470."));
}

QN_TESTS
{
  g_test_add_func ("/doc/job/finish", test_finish);
  g_test_add_func ("/doc/job/repeatable", test_repeatable);
  g_test_add_func ("/doc/job/pause", test_pause);
  g_test_add_func ("/doc/job/history", test_history);
  g_test_add_func ("/doc/job/cancelled-at-once", test_cancelled_at_once);
  g_test_add_func ("/doc/job/unsound", test_unsound);
  g_test_add_func ("/doc/job/modes", test_modes);
  g_test_add_func ("/doc/job/stability", test_stability);
}
