/* What `quoin-cli study` and `quoin-cli ida` share. */
#pragma once

#include "cli/base/subcommand.h"
#include "study/cases/run.h"

/* Computes the cases of a study that are missing in its folder, as `settings` say but for the program, the
 * progress and, where `jobs` is 0, how many processes; shows on a terminal how far it has come: it is the one
 * with the number `part` of `parts` alike. Failure ends the program; FALSE where it was
 * cancelled. */
gboolean qn_study_compute (const QnStudy *study, const char *folder,
                           QnStudyRunSettings settings, gsize part, gsize parts,
                           QnStudyProgress *progress);

/* Ends the program since the study was cancelled; `name` is what the command calls it. */
void qn_study_cancelled (const char *name);
