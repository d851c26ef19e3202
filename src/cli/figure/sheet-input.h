/* A project with its result, as the subcommands that show results need it: what is not there is
 * solved. */
#pragma once

#include "cli/base/input.h"
#include "doc/view/sheet.h"

typedef struct QnSheetItem {
  QnInput input;
  QnResultFile file; /* only `result` is filled where it was computed here */
} QnSheetItem;

/* Solves the project that item->input holds; on failure the user has been told. An end without an
 * answer is a warning: what there is can be shown. */
QnExit qn_sheet_item_solve (QnSheetItem *item, const QnInputOptions *options);

/* Reads a project with the result of that name, or solves it where `result` is NULL. On failure the
 * user has been told and *item is empty. */
QnExit qn_sheet_item_load (QnSheetItem *item, const char *model, const char *result,
                           const QnInputOptions *options);

void qn_sheet_item_clear (QnSheetItem *item);

/* Loads count items of the form MODEL[=RESULT], several projects that are put side by side.
 * An argument that is itself the name of a file is taken as that, "=" or not. On failure the user
 * has been told and nothing is left. Free with qn_sheet_items_free(). */
QnExit qn_sheet_items_load (char **arguments, gsize count, const QnInputOptions *options,
                            QnSheetItem **items);
void qn_sheet_items_free (QnSheetItem *items, gsize count);

/* They as a sheet takes them: borrows from both, named by the results of the arguments. Free with g_free(). */
QnSheetRun *qn_sheet_items_get_runs (const QnSheetItem *items, char **arguments,
                                     gsize count);
