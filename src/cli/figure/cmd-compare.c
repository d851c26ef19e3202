#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"

#include <glib/gi18n.h>

/* Where --columns is not given. */
#define CHOSEN_BY_FORMAT G_MININT

static char *compare_title;
static int compare_columns = CHOSEN_BY_FORMAT;

static const GOptionEntry compare_entries[] = {
  { "columns", 0, 0, G_OPTION_ARG_INT, &compare_columns,
    N_ ("Figures in a row; chosen by the format otherwise"), N_ ("N") },
  { "title", 0, 0, G_OPTION_ARG_STRING, &compare_title, N_ ("Title of the sheet"),
    N_ ("TEXT") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf|csv")),
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_compare (char **arguments)
{
  if (compare_columns < 1 && compare_columns != CHOSEN_BY_FORMAT)
    qn_cli_usage_error (_ ("--columns must be positive"));
  qn_picture_or_table ();
  gsize count = g_strv_length (arguments);
  const QnSheetRun *runs = qn_input_load_runs (arguments, count);
  qn_cli_must (qn_comparison_export (runs, count, MAX (compare_columns, 0), compare_title,
                                     qn_picture.monochrome, qn_picture.path,
                                     &qn_picture.output, QN_TROUBLE));
}

const QnSubcommand qn_cmd_compare = {
  .name = "compare",
  .arguments = "MODEL[=RESULT]…",
  .summary = N_ ("Put several mechanisms on one sheet, at one scale"),
  .help =
    N_ ("A project without a result is solved first. Below each figure are its load "
        "multiplier and the name of its mechanism; results of the same structure that "
        "move alike have the same letter. With the ending .csv a table is written."),
  .options = compare_entries,
  .many = TRUE,
  .run = run_compare,
};
