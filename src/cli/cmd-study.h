/* The actions of `quoin-cli study`: subcommands whose names begin with "study ". */
#ifndef QN_CLI_CMD_STUDY_H
#define QN_CLI_CMD_STUDY_H

#include "cli/subcommand.h"

extern const QnSubcommand qn_study_action_table;
extern const QnSubcommand qn_study_action_summary;
extern const QnSubcommand qn_study_action_plot;

#endif
