/* The inside of a document, shared by the files that make it up. */
#pragma once

#include "doc/document/document.h"

struct _QnDocument {
  GObject parent_instance;

  char *path;
  char *folder;        /* that relative paths start from; NULL: nowhere */
  QnProject project;   /* the state; its digest is computed when it is asked for */
  QnProjectText *text; /* what it is written as: for the history and for files */
  QnContacts contacts;
  char *fingerprint; /* see below; NULL: to be computed */
  char *file_digest; /* of the file as it was read or written; NULL: not known */
  QnEditHistory *history;
  gboolean dissolved; /* a wall, by the last edit */
  QnSelection *selection;
  gboolean never_saved;   /* came from memory: counts as modified */
  gboolean keeps_history; /* in the file */

  QnJob *job;
  char *job_text; /* what the project was written as when it began; NULL: a live one */
  GError *job_error;
  QnDiag job_diag;
  GPtrArray *runs;
  QnRun *run;
  guint run_number;
};

/* What an analysis depends on: a digest of all of it, a space, and one of the model alone. */
const char *qn_document_get_fingerprint (QnDocument *document);

/* run-name.c: proposes a name for a run that is to be added, whose name is its method so far, and drops
 * those that it repeats; `text` is what the project was written as. */
void qn_document_take_run (QnDocument *document, QnRun *run, const char *text);
/* Names of all runs from what the project keeps; TRUE where one is new. */
gboolean qn_document_name_runs (QnDocument *document);

/* Ends the running analysis, if any, and forgets its outcome. */
void qn_document_drop_job (QnDocument *document);
