/* Rules that an input must keep, one after the other: a chain joined by && ends at the first one that is
 * broken, which the diagnosis then holds. */
#pragma once

#include "core/base/numbers.h"
#include "core/base/status.h"

/* Whose numbers they are; diag may be NULL. */
typedef struct QnSubject {
  QnEntity entity;
  QnId index;
  QnDiag *diag;
} QnSubject;

/* Returns whether the rule holds; where not, its problem is diagnosed, of a field and its value. */
bool qn_require (QnSubject of, bool holds, QnProblem problem, const char *field,
                 double value);

/* A name, which must not be the name of another one: `namesake` is the first that has it, or QN_NONE. */
bool qn_require_name (QnSubject of, const char *name, QnId namesake, QnId own);

/* Numbers: one, of usual or given largest size; both of a vector; an index below `count`. */
bool qn_require_number (QnSubject of, const char *field, double value, QnRange range);
bool qn_require_size (QnSubject of, const char *field, double value, QnRange range,
                      double largest);
bool qn_require_vector (QnSubject of, const char *field, QnVec2 vector);
bool qn_require_index (QnSubject of, const char *field, QnId id, size_t count,
                       QnProblem problem);

/* Result of a chain. */
static inline QnStatus
qn_required (bool holds)
{
  return holds ? QN_OK : QN_ERROR_INVALID;
}
