#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"

#include <glib/gi18n.h>

/* Where --columns is not given. */
#define CHOSEN_BY_FORMAT G_MININT

typedef struct CompareOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *title;
  int columns;
} CompareOptions;

static void
run_compare (const QnSubcommand *self, int argc, char **argv)
{
  CompareOptions options = { .columns = CHOSEN_BY_FORMAT };
  const GOptionEntry entries[] = {
    { "columns", 0, 0, G_OPTION_ARG_INT, &options.columns,
      N_ ("Figures in a row; chosen by the format otherwise"), N_ ("N") },
    { "title", 0, 0, G_OPTION_ARG_STRING, &options.title, N_ ("Title of the sheet"),
      N_ ("TEXT") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf|csv")),
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  if (!qn_subcommand_parse (self, entries, 1, 1000, &argc, &argv))
    return;
  if (options.columns < 1 && options.columns != CHOSEN_BY_FORMAT)
    qn_cli_usage_error (_ ("--columns must be positive"));
  qn_picture_or_table (&options.picture);
  gsize count = (gsize) argc - 1;
  const QnSheetRun *runs = qn_input_load_runs (argv + 1, count, &options.input);
  qn_cli_must (qn_comparison_export (runs, count, MAX (options.columns, 0), options.title,
                                     options.picture.monochrome, options.picture.path,
                                     &options.picture.output, QN_TROUBLE));
}

const QnSubcommand qn_cmd_compare = {
  .name = "compare",
  .arguments = "MODEL[=RESULT]…",
  .summary = N_ ("Put several mechanisms on one sheet, at one scale"),
  .help =
    N_ ("A project without a result is solved first. Below each figure are its load "
        "multiplier and the name of its mechanism; results of the same structure that "
        "move alike have the same letter. With the ending .csv a table is written."),
  .run = run_compare,
};
