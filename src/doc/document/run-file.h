/* Runs as result files: kept beside the project, and looked at again without solving. */
#pragma once

#include "doc/document/document.h"

/* Writes a run of the document as `quoin-cli solve -o` would. Refuses one of an earlier model, for
 * the file must name the project that it belongs to, and those that are no load path or limit
 * analysis. */
gboolean qn_document_write_result (QnDocument *document, const QnRun *run,
                                   const char *path, GError **error);

/* What was set for the run alone, as for `--set`; NULL where that is nothing. Free with g_strfreev(). */
char **qn_run_dup_overrides (const QnRun *run, const QnAnalysisSettings *projects);

/* Whether the file says of itself, at its beginning, that it is a result. */
gboolean qn_is_result_file (const char *path);

/* Adds what a result file says to the runs and makes it the current one. It counts as outdated
 * where the project has changed since; refused where blocks or contacts are others. */
gboolean qn_document_open_result (QnDocument *document, const char *path, GError **error);
