/* Is everything in a result file true?
 *
 * Here contacts and project are compared with the file; core/check/result-check.h compares the
 * rest. result-check.h, which uses nothing of the solver at all, adds the balance of the last step
 * from the points and directions in the file.
 */
#ifndef QN_IO_RESULT_CLAIMS_H
#define QN_IO_RESULT_CLAIMS_H

#include "core/check/result-check.h"
#include "io/result/result-check.h"
#include "io/result/result-file.h"

/* Refuses a file that was computed from another project than this, or whose contacts are not where
 * those of the project are; finds what else is not true. The project was loaded with the file's
 * overrides, `name` is the result file's. */
gboolean qn_result_file_find_faults (const QnResultFile *file, const char *name,
                                     const QnProject *project, const QnContacts *contacts,
                                     QnResultFaults *faults, GError **error);

/* Largest imbalance and largest yield violation, over the largest force, that a result may have to
 * pass the independent check; or ten times the residual tolerance of the project. */
#define QN_RESULT_TOLERANCE 1e-6

/* Whether a result passes: none of its claims is wrong, and forces balance and yield within tolerance.
 * `check` is NULL where there are no forces to check. */
bool qn_result_passes (const QnProject *project, const QnResultCheck *check,
                       const QnResultFaults *faults);

#endif
