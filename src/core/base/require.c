#include "core/base/require.h"

bool
qn_require (QnSubject of, bool holds, QnProblem problem, const char *field, double value)
{
  if (!holds)
    qn_diag_set_field (of.diag, problem, of.entity, of.index, field, value);
  return holds;
}

bool
qn_require_name (QnSubject of, const char *name, QnId namesake, QnId own)
{
  return qn_require (of, name != NULL && name[0] != '\0', QN_PROBLEM_NAME_MISSING, "name",
                     0)
         && qn_require (of, namesake == own || namesake == QN_NONE, QN_PROBLEM_NAME_TAKEN,
                        "name", 0);
}

bool
qn_require_size (QnSubject of, const char *field, double value, QnRange range,
                 double largest)
{
  QnProblem problem = qn_number_problem (value, range, largest);
  return qn_require (of, problem == QN_PROBLEM_NONE, problem, field, value);
}

bool
qn_require_number (QnSubject of, const char *field, double value, QnRange range)
{
  return qn_require_size (of, field, value, range, QN_LARGEST_NUMBER);
}

bool
qn_require_vector (QnSubject of, const char *field, QnVec2 vector)
{
  return qn_require_number (of, field, vector.x, QN_RANGE_FINITE)
         && qn_require_number (of, field, vector.y, QN_RANGE_FINITE);
}

bool
qn_require_index (QnSubject of, const char *field, QnId id, size_t count,
                  QnProblem problem)
{
  return qn_require (of, id >= 0 && (size_t) id < count, problem, field, id);
}
