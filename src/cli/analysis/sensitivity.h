/* The derivatives of the associative multiplier as a table. */
#pragma once

#include "cli/base/exit-code.h"
#include "core/result/result.h"
#include "io/project/project.h"

/* Prints them for the result of a limit analysis. Tells the user where it has none: with
 * non-associative flow (QN_EXIT_USAGE), or without collapse (nothing is said; QN_EXIT_DONE). */
QnExit qn_sensitivity_print (const QnProject *project, const QnContacts *contacts,
                             const QnResult *result);
