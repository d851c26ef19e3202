/* Rules of input. A chain of them joined by && ends at the first rule that does not hold; `diag` then has its
 * problem. */
#pragma once

#include "core/base/numbers.h"
#include "core/base/status.h"

/* The entity that is checked; diag may be NULL. */
typedef struct QnSubject {
  QnEntity entity;
  QnId index;
  QnDiag *diag;
} QnSubject;

/* Returns `holds`; if false, sets of.diag to the problem of this field with this value. */
bool qn_require (QnSubject of, bool holds, QnProblem problem, const char *field,
                 double value);

/* A name, which must not be the name of another one: `namesake` is the first that has it, or QN_NONE. */
bool qn_require_name (QnSubject of, const char *name, QnId namesake, QnId own);

/* A number, at most QN_LARGEST_NUMBER or `largest`; the components of a vector; an index below `count`. */
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
