/* Progress on a terminal, and Ctrl+C. */
#pragma once

#include "core/base/progress.h"

#include <glib.h>

typedef struct QnTerminalProgress {
  gboolean shown;   /* standard error is a terminal and the user wants to see it */
  gint64 last_time; /* of the last update, us */
  gsize idle_heap;  /* in use before the computation, bytes */
  gsize
    peak_memory; /* most that any update found in use beyond that, in whole MiB, so that
                        equal computations report the same whatever else takes memory */
} QnTerminalProgress;

/* From now on Ctrl+C is only recorded, a second one ends the program at once. Analyses do that first. */
void qn_interrupt_install (void);

/* Whether Ctrl+C was pressed. */
gboolean qn_interrupt_seen (void);

void qn_terminal_progress_begin (QnTerminalProgress *progress, gboolean quiet);

/* A QnProgressFunc; user_data is a QnTerminalProgress. */
bool qn_terminal_progress_update (const QnProgress *progress, void *user_data);

/* Clears the line. */
void qn_terminal_progress_done (QnTerminalProgress *progress);
