/* What "solve" and "limit" share: a project in, an analysis, a result out. */
#pragma once

#include "cli/base/subcommand.h"
#include "core/result/result.h"
#include "io/project/project.h"

/* Runs the subcommand "solve" under the name, usage and help of `self`. `override` (nullable),
 * PATH=VALUE, comes before the user's own. */
void qn_cmd_solve_run (const QnSubcommand *self, const char *override, int argc,
                       char **argv);

/* Prints what limit analysis found about the model with this title. */
void qn_cmd_limit_print (const char *title, const QnResult *result);

/* The derivatives of the associative multiplier as a table. Where it has none: with non-associative flow
 * that ends the program, without collapse nothing is said. */
void qn_cmd_limit_print_sensitivity (const QnProject *project, const QnContacts *contacts,
                                     const QnResult *result);
