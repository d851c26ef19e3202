/* A document with a file of the examples, for the tests of this folder. */
#ifndef TESTS_DOC_OPEN_EXAMPLE_H
#define TESTS_DOC_OPEN_EXAMPLE_H

#include "doc/document.h"

/* Fails the test where it cannot be opened. */
QnDocument *open_example (const char *name);

/* Runs the main loop until no analysis runs (fails after a minute). */
void wait_for_job (QnDocument *document);

/* Solves by the document's own procedure and returns the run, borrowed. */
QnRun *solve_example (QnDocument *document);

#endif
