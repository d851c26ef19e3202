#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "cli/figure/curve-table.h"
#include "cli/figure/sheet-input.h"
#include "doc/view/energy-plot.h"
#include "render/figure/curve-plot.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

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
take_curve (QnCurve *curve, const QnSheetItem *item, const CurveOptions *options)
{
  const QnModel *model = &item->input.project.model;
  const QnResult *result = &item->file.result;
  QnCurveMotion motion = qn_result_curve_motion (model, result);
  if (motion.body == QN_NONE) {
    qn_cli_error (_ ("%s: no step to show"), item->input.project.name);
    return QN_EXIT_INVALID;
  }
  if (!qn_curve_from_result (curve, model, result, motion)) {
    qn_cli_error (_ ("not enough memory"));
    return QN_EXIT_INTERNAL;
  }
  if (options->until > 0)
    qn_curve_cut (curve, options->until);
  else if (!options->whole && !qn_is_table (options->picture.path))
    qn_curve_cut_runaway (curve);
  return QN_EXIT_DONE;
}

/* Runs of one project are distinguished by the names of their results. */
static void
label_curves (QnCurve *curves, const QnSheetItem *items, char **arguments, gsize count,
              GPtrArray *labels)
{
  for (gsize i = 0; i < count; i++) {
    const char *title = qn_sheet_item_title (&items[i]);
    gsize alike = 0;
    for (gsize k = 0; k < count; k++)
      alike += strcmp (title, qn_sheet_item_title (&items[k])) == 0;
    const char *equals = strrchr (arguments[i], '=');
    g_autofree char *file =
      g_path_get_basename (equals != NULL ? equals + 1 : arguments[i]);
    curves[i].label =
      alike > 1 ? g_strdup_printf ("%s (%s)", title, file) : g_strdup (title);
    g_ptr_array_add (labels, (gpointer) curves[i].label);
  }
}

/* "0.36" or "0.36=Ferris and Tin-Loi". */
static QnExit
parse_references (const QnSubcommand *self, CurveOptions *options)
{
  for (char **text = options->references; text != NULL && *text != NULL; text++) {
    char *end = NULL;
    QnReferenceLine line = { .y = g_ascii_strtod (*text, &end) };
    if (end == *text || (*end != '\0' && *end != '=') || !isfinite (line.y))
      return qn_cli_usage_error (
        self->name, _ ("%s: a reference is a number, or a number=text"), *text);
    line.label = *end == '=' ? end + 1 : _ ("reference");
    g_array_append_val (options->lines, line);
  }
  return QN_EXIT_DONE;
}

static gboolean export(const CurveOptions *options, const QnOutput *output,
                       const QnCurve *curves, gsize count, const QnProject *project,
                       GError **error)
{
  QnMetadata metadata;
  if (qn_is_table (options->picture.path))
    return qn_curve_table_write (options->picture.path, curves, count, error);
  qn_picture_metadata (project, &metadata);
  g_autoptr (QnPlot) plot =
    qn_curve_plot (curves, count, (const QnReferenceLine *) (void *) options->lines->data,
                   options->lines->len);
  plot->title = options->title;
  plot->monochrome = options->picture.monochrome;
  return qn_plot_export (plot, options->picture.path, output, &metadata, error);
}

static QnExit
draw_curve (const CurveOptions *options, const QnOutput *output, const QnSheetItem *items,
            char **arguments, gsize count)
{
  g_autofree QnCurve *curves = g_new0 (QnCurve, count);
  g_autoptr (GPtrArray) labels = g_ptr_array_new_with_free_func (g_free);
  QnExit code = QN_EXIT_DONE;
  for (gsize i = 0; i < count && code == QN_EXIT_DONE; i++)
    code = take_curve (&curves[i], &items[i], options);

  for (gsize i = 1; i < count && code == QN_EXIT_DONE; i++)
    if (!qn_curve_shares_axes (&curves[i], &curves[0])) {
      qn_cli_error (
        _ ("%s and %s: paths of different loads, settlements and analyses in time have "
           "no axes in common"),
        arguments[0], arguments[i]);
      code = QN_EXIT_INVALID;
    }
  label_curves (curves, items, arguments, count, labels);

  GError *error = NULL;
  if (code == QN_EXIT_DONE
      && !export(options, output, curves, count,
                 count == 1 ? &items[0].input.project : NULL, &error))
    code = qn_cli_fail (error);
  for (gsize i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);
  return code;
}

/* The energies of one analysis in time. */
static QnExit
draw_energy (const CurveOptions *options, const QnOutput *output, const QnSheetItem *item)
{
  const QnProject *project = &item->input.project;
  const char *unit;
  QnMetadata metadata;
  GError *error = NULL;
  if (item->file.result.history.row_count == 0) {
    qn_cli_error (_ ("%s: only analyses in time have energies"), project->name);
    return QN_EXIT_INVALID;
  }
  qn_picture_metadata (project, &metadata);
  g_autoptr (QnPlot) plot = qn_energy_plot (&item->file.result.history, &unit);
  plot->title = options->title;
  plot->monochrome = options->picture.monochrome;
  qn_plot_export (plot, options->picture.path, output, &metadata, &error);
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
    code = options.energy ? draw_energy (&options, &output, &items[0])
                          : draw_curve (&options, &output, items, argv + 1, count);

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
