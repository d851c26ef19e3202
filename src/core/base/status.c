#include "core/base/status.h"

const char *
qn_problem_text (QnProblem problem)
{
#define QN_PROBLEM_TEXT(name, text) text,
  static const char *const texts[QN_PROBLEM_COUNT] = { QN_PROBLEMS (QN_PROBLEM_TEXT) };
#undef QN_PROBLEM_TEXT

  QN_ASSERT (problem >= 0 && problem < QN_PROBLEM_COUNT);
  return texts[problem];
}

bool
qn_problem_is_of_state (QnProblem problem)
{
  return problem == QN_PROBLEM_STATE_SLIPS || problem == QN_PROBLEM_STATE_SINGULAR
         || problem == QN_PROBLEM_STATE_UNSTABLE || problem == QN_PROBLEM_MODES_NOT_FOUND;
}

static QnStatus
set (QnDiag *diag, QnDiag to)
{
  to.sub = to.other = QN_NONE;
  if (diag != NULL)
    *diag = to;
  return to.status;
}

QnStatus
qn_diag_set (QnDiag *diag, QnStatus status, QnProblem problem)
{
  return set (diag, (QnDiag){ status, problem, .index = QN_NONE });
}

QnStatus
qn_diag_set_field (QnDiag *diag, QnProblem problem, QnEntity entity, QnId index,
                   const char *field, double value)
{
  return set (diag, (QnDiag){ QN_ERROR_INVALID, problem, entity, index, .field = field,
                              .value = value });
}

QnStatus
qn_refuse (QnDiag *diag, QnProblem problem, QnEntity entity, QnId index)
{
  return qn_diag_set_field (diag, problem, entity, index, NULL, 0);
}

QnStatus
qn_diag_no_memory (QnDiag *diag)
{
  return qn_diag_set (diag, QN_ERROR_NO_MEMORY, QN_PROBLEM_NO_MEMORY);
}
