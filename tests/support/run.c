#include "support/run.h"

#include "core/check/result-check.h"

#include <glib.h>

void
test_run_prepare (TestRun *run)
{
  QnDiag diag = { 0 };
  QnStatus status = qn_model_prepare (&run->model, &diag);
  if (status == QN_OK)
    status = qn_contacts_detect (&run->model, &run->contacts, &diag);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, qn_problem_text (QN_PROBLEM_NONE));
  g_assert_cmpint (status, ==, QN_OK);
}

void
test_run_solve (TestRun *run)
{
  QnDiag diag = { 0 };
  test_run_prepare (run);
  g_assert_cmpint (
    qn_analysis_run (&run->model, &run->contacts, NULL, NULL, &run->result, &diag), ==,
    QN_OK);
}

void
test_analyse (QnModel *model, QnResult *result)
{
  TestRun run = { .model = *model };
  test_run_solve (&run);
  *model = run.model;
  *result = run.result;
  qn_contacts_clear (&run.contacts);
}

void
test_control (QnModel *model, QnProcedure procedure, const char *block, QnDof dof,
              double target)
{
  model->analysis.procedure = procedure;
  model->analysis.control.block = block ? qn_model_find_block (model, block) : QN_NONE;
  model->analysis.control.dof = dof;
  model->analysis.control.target = target;
}

static void
find_faults (const TestRun *run, QnResultFaults *faults)
{
  g_assert_cmpint (qn_result_find_faults (&run->model, &run->contacts, &run->result,
                                          QN_CHECK_STATED, faults, NULL),
                   ==, QN_OK);
}

int
test_run_count_faults (const TestRun *run)
{
  QnResultFaults faults;
  find_faults (run, &faults);
  return faults.count;
}

gboolean
test_run_tells (const TestRun *run, QnClaim claim)
{
  QnResultFaults faults;
  gboolean told = FALSE;
  find_faults (run, &faults);
  for (int i = 0; i < faults.count; i++)
    told |= faults.items[i].claim == claim;
  return told;
}

void
test_find_modes (QnModel *model, size_t wanted, QnModes *modes)
{
  g_auto (QnContacts) contacts;
  g_auto (QnResult) result;
  QnDiag diag = { 0 };
  g_assert_cmpint (qn_model_prepare (model, &diag), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, &contacts, &diag), ==, QN_OK);
  QnStatus status = qn_modal_run (model, &contacts, QN_MODAL_DEAD_LOAD, wanted, NULL,
                                  NULL, modes, &result, &diag);
  g_assert_cmpstr (qn_problem_text (diag.problem), ==, "no problem");
  g_assert_cmpint (status, ==, QN_OK);
}

void
test_run_clear (TestRun *run)
{
  qn_result_clear (&run->result);
  qn_contacts_clear (&run->contacts);
  qn_model_clear (&run->model);
}
