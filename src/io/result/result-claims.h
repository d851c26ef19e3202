/* Is everything in a result file true?
 *
 * Here the project is compared with the file; core/check/result-check.h compares the rest.
 */
#pragma once

#include "core/check/result-check.h"
#include "io/result/result-file.h"

/* Refuses a file that was computed from another project than this; finds what else is not true. The project was
 * loaded with the file's overrides, `name` is the result file's. */
gboolean qn_result_file_find_faults (const QnResultFile *file, const char *name,
                                     const QnProject *project, const QnContacts *contacts,
                                     QnResultFaults *faults, GError **error);
