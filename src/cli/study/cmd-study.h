/* The actions of `quoin-cli study`: subcommands whose names begin with "study ". */
#ifndef QN_CLI_CMD_STUDY_H
#define QN_CLI_CMD_STUDY_H

#include "cli/base/subcommand.h"
#include "study/cases/run.h"

/* Path of this program, to be started again as a worker; the caller frees it. By its name where it is
 * there, so that tools that follow programs (valgrind) follow it; else by the file that is open. */
char *qn_study_dup_program (void);

/* How far a study has come, on a terminal. */
typedef struct QnStudyDisplay {
  gboolean shown;
  gint64 last_time; /* us */
} QnStudyDisplay;

void qn_study_display_init (QnStudyDisplay *display, gboolean quiet);

/* A QnStudyProgressFunc; data is a QnStudyDisplay. Ends the run at Ctrl+C. */
gboolean qn_study_display_update (const QnStudyProgress *progress, gpointer data);

/* Clears the line. */
void qn_study_display_done (QnStudyDisplay *display);

extern const QnSubcommand qn_study_action_table;
extern const QnSubcommand qn_study_action_summary;
extern const QnSubcommand qn_study_action_plot;

#endif
