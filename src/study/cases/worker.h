/* Worker processes: each computes one case after the other, so that a case that crashes or takes
 * all memory ends its worker and nothing else.
 *
 * A worker is this program again (`quoin-cli study worker FOLDER`). It says "ready", then reads
 * lines "number, values" from standard input and answers each with one line on standard output,
 * a GVariant as text. It ends with its input, or with the process that started it.
 */
#pragma once

#include "study/cases/case.h"

#include <stdio.h>

/* The worker's side: serves until `input` ends. With `keep`, full results go to the folder. */
void qn_worker_serve (const QnStudy *study, const char *folder, gboolean keep,
                      FILE *input, FILE *output);

typedef struct QnWorker {
  int pid;           /* 0: none */
  int input, output; /* to write to and to read from; -1 */
  gboolean ready, busy;
  GString *received; /* what has come of the next line */
  gsize index;       /* place of its case, where it is busy, */
  double begun;      /* and when that began, where it is ready; qn_clock_seconds() */
} QnWorker;

/* Starts `program` with the arguments of a worker. Errors: QN_IO_ERROR. */
gboolean qn_worker_start (QnWorker *worker, const char *program, const char *folder,
                          gboolean keep, GError **error);

/* Hands over a case to a worker that has none. One that has gone is found at the end of its output. */
void qn_worker_give (QnWorker *worker, gsize index, const double *values, gsize width);

/* Reads the worker's output. FALSE at its end. */
gboolean qn_worker_receive (QnWorker *worker);

/* The result of its case, once that is complete: it is free for the next one then. FALSE where there is
 * none. *result is overwritten; to be cleared. */
gboolean qn_worker_answer (QnWorker *worker, QnCaseResult *result);

/* Waits for a worker that has ended, or kills it first; how it ended, in words, or NULL where it
 * ended as it should. Free with g_free(). */
char *qn_worker_end (QnWorker *worker, gboolean kill_it);
