#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "cli/figure/sheet-input.h"
#include "doc/view/sheet.h"

#include <glib/gi18n.h>

typedef struct CurveOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *title;
  double until; /* m or rad, or 0 */
  gboolean whole, energy;
  char **references;
  GArray *lines; /* of QnReferenceLine, of `references` */
} CurveOptions;

static QnExit
parse_references (const QnSubcommand *self, CurveOptions *options)
{
  for (char **text = options->references; text != NULL && *text != NULL; text++) {
    QnReferenceLine line;
    if (!qn_reference_line_parse (*text, &line))
      return qn_cli_usage_error (
        self->name, _ ("%s: a reference is a number, or a number=text"), *text);
    if (line.label == NULL)
      line.label = _ ("reference");
    g_array_append_val (options->lines, line);
  }
  return QN_EXIT_DONE;
}

static QnExit
draw_curve (const CurveOptions *options, const QnOutput *output, const QnSheetItem *items,
            char **arguments, gsize count)
{
  GError *error = NULL;
  const char *path = options->picture.path;
  const QnCurveSheet sheet = {
    .title = options->title,
    .until = options->until,
    .whole = options->whole,
    .references = (const QnReferenceLine *) (void *) options->lines->data,
    .reference_count = options->lines->len,
    .monochrome = options->picture.monochrome,
  };
  g_autofree QnSheetRun *runs = qn_sheet_items_get_runs (items, arguments, count);
  if (options->energy)
    qn_energy_sheet_export (&sheet, runs, path, output, &error);
  else
    qn_curve_sheet_export (&sheet, runs, count, path, output, &error);
  return qn_cli_end (error);
}

static QnExit
run_curve (const QnSubcommand *self, int argc, char **argv)
{
  CurveOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "title", 0, 0, G_OPTION_ARG_STRING, &options.title, N_ ("Title of the plot"),
      N_ ("TEXT") },
    { "until", 0, 0, G_OPTION_ARG_DOUBLE, &options.until,
      N_ ("End the curves at this displacement, m or rad"), N_ ("LIMIT") },
    { "whole", 0, 0, G_OPTION_ARG_NONE, &options.whole,
      N_ ("Draw the last motion to its end"), NULL },
    { "energy", 0, 0, G_OPTION_ARG_NONE, &options.energy,
      N_ ("Of one analysis in time: its energies over the time"), NULL },
    { "reference", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.references,
      N_ ("Draw a line at this multiplier, for a known value; may be given again"),
      N_ ("VALUE[=TEXT]") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf|csv")),
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  QnOutput output;
  QnSheetItem *items = NULL;
  QnExit code = QN_EXIT_USAGE;

  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1000, &argc, &argv)) {
    if (options.until < 0)
      qn_cli_usage_error (self->name, _ ("--until must be positive"));
    else if (options.energy && (argc != 2 || qn_is_table (options.picture.path)))
      qn_cli_usage_error (
        self->name, _ ("--energy draws one analysis, as a picture; the history that "
                       "solve --csv writes is its table"));
    else
      code = qn_picture_or_table (self, &options.picture, &output);
  }
  options.lines = g_array_new (FALSE, FALSE, sizeof (QnReferenceLine));
  if (code == QN_EXIT_DONE)
    code = parse_references (self, &options);
  gsize count = (gsize) MAX (argc - 1, 0);
  if (code == QN_EXIT_DONE)
    code = qn_sheet_items_load (argv + 1, count, &options.input, &items);
  if (code == QN_EXIT_DONE)
    code = draw_curve (&options, &output, items, argv + 1, count);

  if (items != NULL)
    qn_sheet_items_free (items, count);
  qn_subcommand_free_values (entries);
  g_array_unref (options.lines);
  return code;
}

const QnSubcommand qn_cmd_curve = {
  .name = "curve",
  .arguments = "MODEL[=RESULT]…",
  .summary = N_ ("Plot load–displacement curves, several in one picture"),
  .help =
    N_ ("A project without a result is solved first. Each curve shows the block that the "
        "project controls, or else the one that moves furthest since the dead load. With "
        "the ending .csv a table is written."),
  .run = run_curve,
};
