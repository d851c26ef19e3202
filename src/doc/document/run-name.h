/* What runs are called: what differs from the first one, or what the user says; with the method. */
#pragma once

#include "doc/document/document.h"

/* The member of the project that keeps names the user gave, by the digest of the model. */
#define QN_RUN_NAMES_MEMBER "run_names"

/* Renames a run, and all others of the same model, as a step; "" or NULL: as proposed. */
gboolean qn_document_rename_run (QnDocument *document, const QnRun *run,
                                 const char *label, GError **error);

/* What the project of one run says otherwise than that of another, translated, each "friction 0.5"; NULL
 * where the text of one of them is not known. */
GPtrArray *qn_run_list_changes (const QnRun *from, const QnRun *to);
