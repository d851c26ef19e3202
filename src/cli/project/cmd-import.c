#include "cli/base/message.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "io/exchange/drawing-import.h"
#include "io/text/text-format.h"

#include <glib/gi18n.h>
#include <stdio.h>

typedef struct ImportOptions {
  char *output;
  gboolean report;
  QnImportSettings settings;
} ImportOptions;

/* The report goes to standard output, or to standard error where that takes the project. */
static void
tell_import (const ImportOptions *options, const QnImportReport *report)
{
  if (report->lines == NULL) /* the file could not be read */
    return;
  if (options->report) {
    for (guint i = 0; i < report->lines->len; i++) {
      g_autofree char *line = qn_text_printf ("%s\n", (char *) report->lines->pdata[i]);
      g_autofree char *shown = qn_shown_text_dup (line);
      fputs (shown, g_strcmp0 (options->output, "-") != 0 ? stdout : stderr);
    }
    return;
  }
  for (guint i = 0; i < report->warnings->len; i++)
    qn_cli_warning ("%s", (char *) report->warnings->pdata[i]);
}

static void
run_import (const QnSubcommand *self, int argc, char **argv)
{
  ImportOptions options = { .settings = QN_IMPORT_DEFAULTS };
  static const char *const names[] = { "unit",          "tolerance", "close-joints",
                                       "mortar-joints", "thickness", "unit-weight",
                                       "friction",      NULL };
  char *values[G_N_ELEMENTS (names)] = { NULL };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
      N_ ("Project file to write"), N_ ("MODEL.quoin") },
    { names[0], 'u', 0, G_OPTION_ARG_STRING, &values[0], N_ ("Unit of the drawing"),
      "mm|cm|dm|m|in|ft" },
    { "report", 0, 0, G_OPTION_ARG_NONE, &options.report,
      N_ ("List everything that was repaired or left out"), NULL },
    { "layer", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.settings.layers,
      N_ ("What a layer holds: block, support, opening or ignored; * and ? in NAME"),
      N_ ("NAME=ROLE") },
    { names[1], 0, 0, G_OPTION_ARG_STRING, &values[1],
      /* xgettext:no-c-format */
      N_ ("Gaps up to this are closed, m (0.2 % of a block)"), N_ ("LENGTH") },
    { names[2], 0, 0, G_OPTION_ARG_STRING, &values[2],
      N_ ("Close joints of mortar up to this width, m (0: automatic): blocks grow to "
          "their "
          "middle"),
      N_ ("WIDTH") },
    { names[3], 0, 0, G_OPTION_ARG_STRING, &values[3],
      N_ ("Fill joints of mortar up to this width, m (0: automatic) with blocks of "
          "mortar"),
      N_ ("WIDTH") },
    { names[4], 0, 0, G_OPTION_ARG_STRING, &values[4],
      N_ ("Thickness of the blocks, m (1)"), N_ ("LENGTH") },
    { names[5], 0, 0, G_OPTION_ARG_STRING, &values[5],
      N_ ("Unit weight of the blocks, N/m3 (20000)"), N_ ("WEIGHT") },
    { names[6], 0, 0, G_OPTION_ARG_STRING, &values[6],
      N_ ("Friction coefficient of the dry joints (0.65)"), N_ ("MU") },
    G_OPTION_ENTRY_NULL,
  };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  for (gsize i = 0; names[i] != NULL; i++)
    if (values[i] != NULL
        && !qn_import_settings_set (&options.settings, names[i], values[i], QN_TROUBLE))
      qn_cli_usage_error ("--%s", qn_cli_trouble->message);
  if (options.output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  QnProject *project = qn_cli_keep (g_new0 (QnProject, 1));
  QnImportReport report;
  gboolean done =
    qn_import_file (argv[1], &options.settings, project, &report, QN_TROUBLE);
  tell_import (&options, &report);
  qn_import_report_clear (&report);
  qn_cli_must (done && qn_project_save (project, options.output, QN_TROUBLE));
}

const QnSubcommand qn_cmd_import = {
  .name = "import",
  .arguments = "FILE -o MODEL.quoin",
  .summary = N_ ("Make a project from a drawing: DXF, SVG, COMPAS, text of HybriDFEM"),
  .help =
    N_ ("Closed outlines become blocks, line work the faces it encloses. Layers named "
        "like SUPPORTS, OPENINGS or TEXT are fixed, cut out or ignored; --layer decides "
        "otherwise. Without a layer of supports the lowest row is fixed."),
  .run = run_import,
};
