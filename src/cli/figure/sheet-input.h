/* Several projects with their results, side by side. */
#pragma once

#include "cli/base/input.h"
#include "doc/view/sheet.h"

/* Loads count arguments of the form MODEL[=RESULT], or solves those without a result. An argument that is
 * itself the name of a file is taken as that, "=" or not. The runs, for the rest of the program, are named
 * by their results. */
QnSheetRun *qn_sheet_runs_load (char **arguments, gsize count,
                                const QnInputOptions *options);
