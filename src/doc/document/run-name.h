/* Names of runs: the difference from the first run or the user's text, and the method. */
#pragma once

#include "doc/document/document.h"

/* The member of the project that keeps names the user gave, by the digest of the model. */
#define QN_RUN_NAMES_MEMBER "run_names"

/* Renames a run, and all others of the same model, as a step; "" or NULL: as proposed. */
gboolean qn_document_rename_run (QnDocument *document, const QnRun *run,
                                 const char *label, GError **error);

/* Differences between the projects of two runs, translated, such as "friction 0.5"; NULL if the text of one
 * project is unknown. */
GPtrArray *qn_run_list_changes (const QnRun *from, const QnRun *to);
