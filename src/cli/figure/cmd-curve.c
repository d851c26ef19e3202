#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"

#include <glib/gi18n.h>

static char *curve_title;
static double curve_until; /* m or rad, or 0 */
static gboolean curve_whole, curve_energy;
static char **curve_references;

static const GOptionEntry curve_entries[] = {
  { "title", 0, 0, G_OPTION_ARG_STRING, &curve_title, N_ ("Title of the plot"),
    N_ ("TEXT") },
  { "until", 0, 0, G_OPTION_ARG_DOUBLE, &curve_until,
    N_ ("End the curves at this displacement, m or rad"), N_ ("LIMIT") },
  { "whole", 0, 0, G_OPTION_ARG_NONE, &curve_whole,
    N_ ("Draw the last motion to its end"), NULL },
  { "energy", 0, 0, G_OPTION_ARG_NONE, &curve_energy,
    N_ ("Of one analysis in time: its energies over the time"), NULL },
  { "reference", 0, 0, G_OPTION_ARG_STRING_ARRAY, &curve_references,
    N_ ("Draw a line at this multiplier, for a known value; may be given again"),
    N_ ("VALUE[=TEXT]") },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf|csv")),
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_curve (char **arguments)
{
  const char *path = qn_picture.path;
  if (curve_until < 0)
    qn_cli_usage_error (_ ("--until must be positive"));
  if (curve_energy && (arguments[1] != NULL || qn_is_table (path)))
    qn_cli_usage_error (_ ("--energy draws one analysis, as a picture; the history that "
                           "solve --csv writes is its table"));
  qn_picture_or_table ();
  gsize count = g_strv_length (arguments),
        lines = curve_references != NULL ? g_strv_length (curve_references) : 0;
  g_autofree QnReferenceLine *references = g_new (QnReferenceLine, lines);
  for (gsize i = 0; i < lines; i++) {
    if (!qn_reference_line_parse (curve_references[i], &references[i]))
      qn_cli_usage_error (_ ("%s: a reference is a number, or a number=text"),
                          curve_references[i]);
    if (references[i].label == NULL)
      references[i].label = _ ("reference");
  }
  const QnSheetRun *runs = qn_input_load_runs (arguments, count);
  const QnCurveSheet sheet = { .title = curve_title,
                               .until = curve_until,
                               .whole = curve_whole,
                               .references = references,
                               .reference_count = lines,
                               .monochrome = qn_picture.monochrome };
  const QnOutput *output = &qn_picture.output;
  qn_cli_must (curve_energy
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
  .options = curve_entries,
  .many = TRUE,
  .run = run_curve,
};
