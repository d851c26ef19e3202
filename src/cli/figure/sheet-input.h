/* Arguments of the form MODEL[=RESULT]: several projects, each with a result, as the
 * subcommands that put many of them side by side need it. */
#ifndef QN_CLI_SHEET_INPUT_H
#define QN_CLI_SHEET_INPUT_H

#include "cli/base/input.h"

typedef struct QnSheetItem {
  QnInput input;
  QnResultFile file; /* only `result` is filled where it was computed here */
} QnSheetItem;

/* Solves the project that item->input holds; on failure the user has been told. */
QnExit qn_sheet_item_solve (QnSheetItem *item);

void qn_sheet_item_clear (QnSheetItem *item);

/* Loads count items: reads the result named behind "=", or solves the project where none is named.
 * An argument that is itself the name of a file is taken as that, "=" or not. On failure the user
 * has been told and nothing is left. Free with qn_sheet_items_free(). */
QnExit qn_sheet_items_load (char **arguments, gsize count, QnSheetItem **items);
void qn_sheet_items_free (QnSheetItem *items, gsize count);

/* Title of the project, or else the name of its file without folders; borrowed. */
const char *qn_sheet_item_title (const QnSheetItem *item);

#endif
