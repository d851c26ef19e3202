#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "io/exchange/drawing-import.h"
#include "io/text/text-format.h"

#include <glib/gi18n.h>
#include <stdio.h>

static char *import_output;
static gboolean import_report;
static char **import_layers;
static char *import_values[7]; /* of settings */

static const GOptionEntry import_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &import_output, N_ ("Project file to write"),
    N_ ("MODEL.quoin") },
  { "unit", 'u', 0, G_OPTION_ARG_STRING, &import_values[0], N_ ("Unit of the drawing"),
    "mm|cm|dm|m|in|ft" },
  { "report", 0, 0, G_OPTION_ARG_NONE, &import_report,
    N_ ("List everything that was repaired or left out"), NULL },
  { "layer", 0, 0, G_OPTION_ARG_STRING_ARRAY, &import_layers,
    N_ ("What a layer holds: block, support, opening or ignored; * and ? in NAME"),
    N_ ("NAME=ROLE") },
  { "tolerance", 0, 0, G_OPTION_ARG_STRING, &import_values[1],
    /* xgettext:no-c-format */
    N_ ("Gaps up to this are closed, m (0.2 % of a block)"), N_ ("LENGTH") },
  { "close-joints", 0, 0, G_OPTION_ARG_STRING, &import_values[2],
    N_ ("Close joints of mortar up to this width, m (0: automatic): blocks grow to "
        "their "
        "middle"),
    N_ ("WIDTH") },
  { "mortar-joints", 0, 0, G_OPTION_ARG_STRING, &import_values[3],
    N_ ("Fill joints of mortar up to this width, m (0: automatic) with blocks of "
        "mortar"),
    N_ ("WIDTH") },
  { "thickness", 0, 0, G_OPTION_ARG_STRING, &import_values[4],
    N_ ("Thickness of the blocks, m (1)"), N_ ("LENGTH") },
  { "unit-weight", 0, 0, G_OPTION_ARG_STRING, &import_values[5],
    N_ ("Unit weight of the blocks, N/m3 (20000)"), N_ ("WEIGHT") },
  { "friction", 0, 0, G_OPTION_ARG_STRING, &import_values[6],
    N_ ("Friction coefficient of the dry joints (0.65)"), N_ ("MU") },
  G_OPTION_ENTRY_NULL,
};

/* The report goes to standard output, or to standard error where that takes the project. */
static void
tell_import (const QnImportReport *report)
{
  if (report->lines == NULL) /* the file could not be read */
    return;
  if (import_report) {
    for (guint i = 0; i < report->lines->len; i++) {
      g_autofree char *line = qn_text_printf ("%s\n", (char *) report->lines->pdata[i]);
      g_autofree char *shown = qn_shown_text_dup (line);
      fputs (shown, g_strcmp0 (import_output, "-") != 0 ? stdout : stderr);
    }
    return;
  }
  for (guint i = 0; i < report->warnings->len; i++)
    qn_cli_warning ("%s", (char *) report->warnings->pdata[i]);
}

static void
run_import (char **arguments)
{
  QnImportSettings settings = QN_IMPORT_DEFAULTS;
  settings.layers = import_layers;
  for (const GOptionEntry *e = import_entries; e->long_name != NULL; e++)
    if (e->arg == G_OPTION_ARG_STRING && *(char **) e->arg_data != NULL
        && !qn_import_settings_set (&settings, e->long_name, *(char **) e->arg_data,
                                    QN_TROUBLE))
      qn_cli_usage_error ("--%s", qn_cli_trouble->message);
  if (import_output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  QnProject *project = qn_cli_keep (g_new0 (QnProject, 1));
  QnImportReport report;
  gboolean done = qn_import_file (arguments[0], &settings, project, &report, QN_TROUBLE);
  tell_import (&report);
  qn_import_report_clear (&report);
  qn_cli_must (done && qn_project_save (project, import_output, QN_TROUBLE));
}

const QnSubcommand qn_cmd_import = {
  .name = "import",
  .arguments = "FILE -o MODEL.quoin",
  .summary = N_ ("Make a project from a drawing: DXF, SVG, COMPAS, text of HybriDFEM"),
  .help =
    N_ ("Closed outlines become blocks, line work the faces it encloses. Layers named "
        "like SUPPORTS, OPENINGS or TEXT are fixed, cut out or ignored; --layer decides "
        "otherwise. Without a layer of supports the lowest row is fixed."),
  .options = import_entries,
  .run = run_import,
};
