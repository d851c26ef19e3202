#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "doc/edit/edit.h"
#include "doc/view/sheet.h"
#include "io/exchange/drawing-import.h"
#include "io/exchange/dxf-export.h"
#include "io/exchange/table-csv.h"
#include "io/exchange/vtu.h"

#include <glib/gi18n.h>

static char *export_output, *export_result, *export_unit, *export_given_table;
static QnResultTable export_table; /* QN_TABLE_COUNT: of cracks */
static double export_scale = 1;

typedef enum { FORMAT_DXF, FORMAT_PVD, FORMAT_CSV, FORMAT_QUOIN, FORMAT_COUNT } Format;

static const char *const endings[] = { ".dxf", ".pvd", ".csv", ".quoin" };

static Format
format_of (const char *path)
{
  int format = 0;
  g_autofree char *lower = g_ascii_strdown (path, -1);
  while (format < FORMAT_COUNT && !g_str_has_suffix (lower, endings[format]))
    format++;
  return (Format) format;
}

/* Walls and masonry become the polygons that they expand to, of the same names. */
static gboolean
write_polygons (QnInput *input, GError **error)
{
  QnModel *model = &input->project.model;
  g_autofree QnId *all = g_new (QnId, model->block_count + 1);
  for (gsize i = 0; i < model->block_count; i++)
    all[i] = (QnId) i;
  QnBlockSet set = { all, (guint) model->block_count };
  return (!qn_edit_take_apart (model, set) || qn_edit_rebuild (model, NULL, error))
         && qn_project_save (&input->project, export_output, error);
}

static gboolean
write_as (Format format, QnInput *input, GError **error)
{
  const QnModel *model = &input->project.model;
  const QnResult *result = export_result != NULL ? &input->file.result : NULL;
  double unit = export_unit != NULL ? qn_import_unit (export_unit) : 1;
  switch (format) {
  case FORMAT_DXF:
    return qn_dxf_export (model, &input->contacts, result, export_scale, unit,
                          export_output, error);
  case FORMAT_PVD:
    return qn_vtu_export (model, &input->contacts, result, export_output, error);
  case FORMAT_CSV:
    return export_table == QN_TABLE_COUNT
             ? qn_cracks_csv_write (export_output, &input->project, &input->contacts,
                                    result, error)
             : qn_result_table_write (export_output, export_table, &input->project,
                                      &input->contacts, result, error);
  case FORMAT_QUOIN:
    return write_polygons (input, error);
  case FORMAT_COUNT:
    break;
  }
  g_assert_not_reached ();
}

static Format
check_options (void)
{
  static const char *const tables[] = {
    [QN_TABLE_CURVE] = "curve",       [QN_TABLE_DISPLACEMENTS] = "displacements",
    [QN_TABLE_CONTACTS] = "contacts", [QN_TABLE_BEAMS] = "beams",
    [QN_TABLE_BARS] = "bars",         [QN_TABLE_TIES] = "ties",
    [QN_TABLE_COUNT] = "cracks",
  };
  Format format = FORMAT_COUNT;
  if (export_given_table != NULL
      && !qn_find_word (export_given_table, tables, G_N_ELEMENTS (tables), &export_table))
    qn_cli_refuse_name (export_given_table, tables, G_N_ELEMENTS (tables));
  if (export_output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  else
    format = format_of (export_output);
  if (format == FORMAT_COUNT)
    qn_cli_usage_error (_ ("the output must end in .dxf, .pvd, .csv or .quoin"));
  if (export_unit != NULL && qn_import_unit (export_unit) == 0)
    qn_cli_usage_error (_ ("--unit must be mm, cm, dm, m, in or ft"));
  if (format == FORMAT_CSV && export_result == NULL)
    qn_cli_usage_error (_ ("a table needs --result"));
  return format;
}

static const GOptionEntry export_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &export_output,
    N_ ("File to write; its ending chooses the format"), N_ ("OUT.dxf|pvd|csv|quoin") },
  { "result", 'r', 0, G_OPTION_ARG_FILENAME, &export_result,
    N_ ("Result of the project, for the deformed shape, steps and tables"),
    N_ ("RESULT.json") },
  { "unit", 'u', 0, G_OPTION_ARG_STRING, &export_unit, N_ ("Unit of the DXF file (m)"),
    "mm|cm|dm|m|in|ft" },
  { "scale", 0, 0, G_OPTION_ARG_DOUBLE, &export_scale,
    N_ ("Displacements of the layer DEFORMED times this"), N_ ("FACTOR") },
  { "table", 0, 0, G_OPTION_ARG_STRING, &export_given_table,
    N_ ("Table of the CSV file (curve)"),
    "curve|displacements|contacts|beams|bars|ties|cracks" },
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_export (char **arguments)
{
  Format format = check_options ();
  QnInput *input = qn_input_load_with_result (arguments[0], export_result);
  qn_cli_must (write_as (format, input, QN_TROUBLE));
}

const QnSubcommand qn_cmd_export = {
  .name = "export",
  .arguments = "MODEL -o OUT.dxf|pvd|csv|quoin",
  .summary = N_ ("Write DXF for CAD programs, PVD for ParaView, tables as CSV, polygons"),
  .help =
    N_ ("DXF has the layers BLOCKS, SUPPORTS, CONTACTS, BEAM_AXES and TIES where there "
        "are any and, with "
        "a result, DEFORMED. PVD lists one VTU file per step, written beside it, with "
        "beams one more, and one with the contact forces. A project is written with its "
        "walls and masonry as polygons."),
  .options = export_entries,
  .run = run_export,
};
