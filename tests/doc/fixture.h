/* Documents to begin with, and edits of them, for the tests of this folder. What must not fail
 * fails the test. */
#pragma once

#include "support/edit-model.h"

/* A document with a file of the examples, or with a project given as text. */
QnDocument *open_example (const char *name);
QnDocument *open_text (const char *text);

/* Edits, undoes it to the byte, and makes it again. Returns the model, borrowed. */
const QnModel *edit (QnDocument *document, ModelEdit func, gconstpointer data);

/* An edit that is refused, with an error, and leaves everything as it was. */
void refuse (QnDocument *document, ModelEdit func, gconstpointer data);

/* Runs the main loop until no analysis runs (fails after a minute). */
void wait_for_job (QnDocument *document);

/* Solves by the document's own procedure and returns the run, borrowed. */
QnRun *solve_example (QnDocument *document);

/* Aborts where the state of a document differs from what its text reads back as. */
void check_state (QnDocument *document);
