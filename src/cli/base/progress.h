/* Progress on a terminal, and Ctrl+C. */
#pragma once

#include "core/base/progress.h"

#include <glib.h>

/* --quiet: the user wants to see errors and warnings alone. */
extern gboolean qn_cli_quiet;

#define QN_QUIET_ENTRY                                                                   \
  {                                                                                      \
    "quiet", 'q', 0, G_OPTION_ARG_NONE, &qn_cli_quiet,                                   \
      N_ ("Print errors and warnings only"), NULL                                        \
  }

/* Whether progress is shown: standard error is a terminal, and the user wants to see it. */
gboolean qn_progress_is_shown (void);

/* From now on Ctrl+C is only recorded, a second one ends the program at once. Analyses do that first. */
void qn_interrupt_install (void);

/* Whether Ctrl+C was pressed. */
gboolean qn_interrupt_seen (void);

/* Before an analysis. */
void qn_terminal_progress_begin (void);

/* A QnProgressFunc without user data. */
bool qn_terminal_progress_update (const QnProgress *progress, void *user_data);

/* Clears the line. Most memory that any update has found in use beyond that at the begin, in whole MiB, so
 * that equal computations report the same whatever else takes memory; bytes. */
gsize qn_terminal_progress_done (void);
