#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"

#include <glib/gi18n.h>

typedef struct CurveOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *title;
  double until; /* m or rad, or 0 */
  gboolean whole, energy;
  char **references;
} CurveOptions;

static void
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
  if (!qn_subcommand_parse (self, entries, 1, 1000, &argc, &argv))
    return;
  const char *path = options.picture.path;
  if (options.until < 0)
    qn_cli_usage_error (_ ("--until must be positive"));
  if (options.energy && (argc != 2 || qn_is_table (path)))
    qn_cli_usage_error (_ ("--energy draws one analysis, as a picture; the history that "
                           "solve --csv writes is its table"));
  qn_picture_or_table (&options.picture);
  gsize count = (gsize) argc - 1,
        lines = options.references != NULL ? g_strv_length (options.references) : 0;
  g_autofree QnReferenceLine *references = g_new (QnReferenceLine, lines);
  for (gsize i = 0; i < lines; i++) {
    if (!qn_reference_line_parse (options.references[i], &references[i]))
      qn_cli_usage_error (_ ("%s: a reference is a number, or a number=text"),
                          options.references[i]);
    if (references[i].label == NULL)
      references[i].label = _ ("reference");
  }
  const QnSheetRun *runs = qn_input_load_runs (argv + 1, count, &options.input);
  const QnCurveSheet sheet = { .title = options.title,
                               .until = options.until,
                               .whole = options.whole,
                               .references = references,
                               .reference_count = lines,
                               .monochrome = options.picture.monochrome };
  const QnOutput *output = &options.picture.output;
  qn_cli_must (options.energy
                 ? qn_energy_sheet_export (&sheet, runs, path, output, QN_TROUBLE)
                 : qn_curve_sheet_export (&sheet, runs, count, path, output, QN_TROUBLE));
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
