/* Every analysis is cancelled at every asking: once refused it asks no more, ends soon, says that
 * it was cancelled, keeps what had converged to the last bit, writes that as a file that reads
 * back, and leaves model and contacts fit for another run. */
#include "faults/fault-case.h"
#include "io/result/result-file.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <time.h>
#include <unistd.h>

/* CPU time from the refusal to the end, s; generous for sanitizers. */
#define SOON 2.0

/* Of analyses that ask more often only every so-manieth asking is refused, unless thorough. */
#define MOST_REFUSALS 60

typedef struct Asking {
  int refused; /* number of the asking that is refused, from 1; 0: none */
  int asked;
  double refused_at;
} Asking;

static double
cpu_seconds (void)
{
  struct timespec now;
  clock_gettime (CLOCK_THREAD_CPUTIME_ID, &now);
  return (double) now.tv_sec + 1e-9 * (double) now.tv_nsec;
}

/* Refuses once: whoever asks again has not understood. */
static bool
ask (const QnProgress *progress, void *data)
{
  Asking *asking = data;
  g_assert_cmpint (progress->iterations, >=, 0);
  if (++asking->asked != asking->refused)
    return true;
  asking->refused_at = cpu_seconds ();
  return false;
}

/* Steps of the cancelled run are the first ones of the whole run; the event of the last is for
 * the end of a path to say. */
static void
check_kept (const QnResult *cancelled, const QnResult *whole)
{
  size_t row = qn_result_body_count (whole) * QN_DOF_COUNT * sizeof (double);
  g_assert_cmpuint (cancelled->step_count, <=, whole->step_count);
  for (size_t i = 0; i < cancelled->step_count; i++) {
    g_assert_cmpfloat (cancelled->steps[i].multiplier, ==, whole->steps[i].multiplier);
    g_assert_cmpint (cancelled->steps[i].stage, ==, whole->steps[i].stage);
    g_assert_cmpmem (qn_result_step_displacements (cancelled, i), row,
                     qn_result_step_displacements (whole, i), row);
  }
  g_assert_null (cancelled->mechanism);
  g_assert_false (cancelled->has_collapse_multiplier);
}

static void
check_file (const QnProject *project, const QnContacts *contacts, const QnResult *result)
{
  g_autofree char *path =
    g_strdup_printf ("%s/quoin-cancel-%d.json", g_get_tmp_dir (), (int) getpid ());
  QnResultFile file;
  GError *error = NULL;
  qn_result_file_write (path, project, contacts, result, QN_DETAIL_FORCES, &error);
  g_assert_no_error (error);
  qn_result_file_read (path, &file, &error);
  g_assert_no_error (error);
  g_assert_cmpint (file.result.outcome, ==, QN_OUTCOME_CANCELLED);
  g_assert_cmpuint (file.result.step_count, ==, result->step_count);
  qn_result_file_clear (&file);
  g_unlink (path);
}

/* What the refused asking came to: whether it was still in time to cancel anything. Collapse that was
 * found before it stays; only the bound beside it is left out. */
static bool
cancel_at (const FaultCase *self, const QnProject *project, const QnContacts *contacts,
           int refused, const FaultAnswer *whole)
{
  Asking asking = { .refused = refused };
  QnDiag diag = { 0 };
  FaultAnswer answer;
  QnStatus status =
    fault_case_run (self, project, contacts, ask, &asking, &answer, &diag);
  double spent = cpu_seconds () - asking.refused_at;

  g_test_message ("asking %d", refused);
  g_assert_cmpint (status, ==, QN_OK);
  g_assert_cmpint (asking.asked, ==, refused);
  g_assert_cmpfloat (spent, <, SOON);
  bool cancelled = answer.result.outcome == QN_OUTCOME_CANCELLED;
  if (cancelled) {
    check_kept (&answer.result, &whole->result);
    g_assert_cmpuint (answer.modes.count, ==, 0);
    if (self->kind == FAULT_SOLVE)
      check_file (project, contacts, &answer.result);
  } else {
    g_assert_cmpint (answer.result.outcome, ==, whole->result.outcome);
  }
  bool unbounded =
    whole->result.has_associative_bound && !answer.result.has_associative_bound;
  fault_answer_clear (&answer);
  return cancelled || unbounded;
}

static void
test_case (gconstpointer data)
{
  const FaultCase *self = data;
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  FaultAnswer whole, again;
  Asking asking = { 0 };
  fault_case_load (self, &project, &contacts);
  g_assert_cmpint (fault_case_run (self, &project, &contacts, ask, &asking, &whole, NULL),
                   ==, QN_OK);
  g_assert_cmpint (whole.result.outcome, !=, QN_OUTCOME_CANCELLED);
  g_assert_cmpint (asking.asked, >, 0);

  int stride = g_test_thorough () ? 1 : 1 + asking.asked / MOST_REFUSALS, too_late = 0;
  for (int refused = 1; refused <= asking.asked; refused += stride)
    too_late += !cancel_at (self, &project, &contacts, refused, &whole);
  g_test_message ("%d askings, every %d. refused, %d too late", asking.asked, stride,
                  too_late);
  g_assert_cmpint (too_late, <=, 1 + asking.asked / 10);

  g_assert_cmpint (fault_case_run (self, &project, &contacts, NULL, NULL, &again, NULL),
                   ==, QN_OK);
  g_autofree char *before = fault_answer_dup_digest (&whole);
  g_autofree char *after = fault_answer_dup_digest (&again);
  g_assert_cmpstr (before, ==, after);
  fault_answer_clear (&whole);
  fault_answer_clear (&again);
}

QN_TESTS
{
  for (size_t i = 0; i < fault_case_count; i++) {
    g_autofree char *path = g_strdup_printf ("/faults/cancel/%s", fault_cases[i].name);
    g_test_add_data_func (path, &fault_cases[i], test_case);
  }
}
