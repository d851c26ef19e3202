#include "cli/message.h"
#include "cli/picture.h"
#include "cli/sheet-input.h"
#include "cli/subcommand.h"
#include "io/table-csv.h"
#include "render/curve-plot.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

typedef struct Options {
  QnPictureOptions picture;
  char *title;
  double until; /* m or rad, or 0 */
} Options;

/* Component of the block's displacement that a curve shows: the controlled one, else the
 * larger at the last step. */
static QnDof
choose_dof (const QnModel *model, const QnResult *result, QnId block)
{
  if (model->analysis.control_block == block)
    return model->analysis.control_dof;
  const double *u = qn_result_step_displacements (result, result->step_count - 1)
                    + (size_t) block * QN_DOF_COUNT;
  return ABS (u[QN_DOF_UX]) >= ABS (u[QN_DOF_UY]) ? QN_DOF_UX : QN_DOF_UY;
}

/* Ends the curve where it first leaves -until .. until. */
static void
cut_curve (QnCurve *curve, double until)
{
  size_t i = 0;
  while (i < curve->count && fabs (curve->x[i]) <= until)
    i++;
  if (until <= 0 || i == 0 || i == curve->count)
    return;

  double edge = copysign (until, curve->x[i]);
  double share = (edge - curve->x[i - 1]) / (curve->x[i] - curve->x[i - 1]);
  curve->y[i] = curve->y[i - 1] + share * (curve->y[i] - curve->y[i - 1]);
  curve->x[i] = edge;
  curve->count = i + 1;
  if (curve->limit_point >= (ptrdiff_t) i)
    curve->limit_point = -1;
  if (curve->collapse_point >= (ptrdiff_t) i)
    curve->collapse_point = -1;
}

static QnExit
take_curve (QnCurve *curve, const QnSheetItem *item, double until)
{
  const QnModel *model = &item->input.project.model;
  const QnResult *result = &item->file.result;
  QnId block = qn_result_curve_block (model, result);
  if (block == QN_NONE) {
    qn_cli_error (_ ("%s: no step to show"), item->input.project.name);
    return QN_EXIT_INVALID;
  }
  if (!qn_curve_from_result (curve, result, block, choose_dof (model, result, block),
                             NULL, NULL)) {
    qn_cli_error (_ ("not enough memory"));
    return QN_EXIT_INTERNAL;
  }
  cut_curve (curve, until);
  curve->label = qn_sheet_item_title (item);
  return QN_EXIT_DONE;
}

static QnExit
draw (const Options *options, const QnOutput *output, const QnSheetItem *items,
      gsize count)
{
  g_autofree QnCurve *curves = g_new0 (QnCurve, count);
  QnExit code = QN_EXIT_DONE;
  for (gsize i = 0; i < count && code == QN_EXIT_DONE; i++)
    code = take_curve (&curves[i], &items[i], options->until);

  if (code == QN_EXIT_DONE) {
    QnMetadata metadata;
    GError *error = NULL;
    QnCurvePlot plot = {
      .title = options->title,
      .x_label = _ ("Displacement"),
      .curves = curves,
      .curve_count = count,
      .monochrome = options->picture.monochrome,
    };
    qn_picture_metadata (count == 1 ? &items[0].input.project : NULL, &metadata);
    metadata.title = options->title;
    if (!qn_curve_export (&plot, options->picture.path, output, &metadata, &error))
      code = qn_cli_fail (error);
  }
  for (gsize i = 0; i < count; i++)
    qn_curve_clear (&curves[i]);
  return code;
}

static QnExit
run (const QnSubcommand *self, int argc, char **argv)
{
  Options options = { 0 };
  const GOptionEntry entries[] = {
    { "title", 0, 0, G_OPTION_ARG_STRING, &options.title, N_ ("Title of the plot"),
      N_ ("TEXT") },
    { "until", 0, 0, G_OPTION_ARG_DOUBLE, &options.until,
      N_ ("End the curves at this displacement, m or rad"), N_ ("LIMIT") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    G_OPTION_ENTRY_NULL,
  };
  QnOutput output;
  QnSheetItem *items = NULL;
  QnExit code = QN_EXIT_USAGE;

  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1000, &argc, &argv)) {
    if (options.until < 0)
      qn_cli_usage_error (self->name, _ ("--until must be positive"));
    else
      code = qn_picture_output (self, &options.picture, &output);
  }
  gsize count = (gsize) MAX (argc - 1, 0);
  if (code == QN_EXIT_DONE)
    code = qn_sheet_items_load (argv + 1, count, &items);
  if (code == QN_EXIT_DONE)
    code = draw (&options, &output, items, count);

  if (items != NULL)
    qn_sheet_items_free (items, count);
  qn_picture_options_clear (&options.picture);
  g_free (options.title);
  return code;
}

const QnSubcommand qn_cmd_curve = {
  .name = "curve",
  .arguments = "MODEL[=RESULT]…",
  .summary = N_ ("Plot load–displacement curves, several in one picture"),
  .help =
    N_ ("A project without a result is solved first. Each curve shows the block that "
        "the project controls, or else the one that moves furthest."),
  .run = run,
};
