#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "cli/figure/sheet-input.h"
#include "doc/document/underlay.h"
#include "doc/view/sheet.h"
#include "render/figure/figure.h"

#include <glib/gi18n.h>
#include <string.h>

#define SWITCHES "ghost,symbols,loads,dimensions,names,values,legend,titles,monochrome"

typedef struct RenderOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *result, *onion, *view, *step, *scale, *field, *diagram;
  char **show, **hide;
} RenderOptions;

/* Sets the switches that a --show or --hide names, several with commas between them. */
static QnExit
parse_switches (const QnSubcommand *self, char **lists, bool on, QnViewOptions *view)
{
  for (char **list = lists; list != NULL && *list != NULL; list++) {
    g_auto (GStrv) names = g_strsplit (*list, ",", -1);
    for (char **name = names; *name != NULL; name++) {
      bool *flag = qn_view_switch (view, *name);
      if (flag == NULL)
        return qn_cli_refuse_name (self->name, *name, qn_view_switches,
                                   g_strv_length ((char **) qn_view_switches));
      *flag = on;
    }
  }
  return QN_EXIT_DONE;
}

/* What can be judged before any file is read. */
static QnExit
parse_view (const QnSubcommand *self, const RenderOptions *options, QnViewOptions *view)
{
  QnView kind = QN_VIEW_MODEL;
  if (options->view != NULL && !qn_view_parse (options->view, &kind))
    return qn_cli_refuse_name (self->name, options->view, qn_view_names, QN_VIEW_COUNT);
  qn_view_options_init (view, kind);
  view->monochrome = options->picture.monochrome;
  if (options->field != NULL && !qn_view_options_set (view, "field", options->field))
    return qn_cli_refuse_name (self->name, options->field, qn_field_names,
                               QN_FIELD_COUNT);
  if (options->diagram != NULL
      && !qn_view_options_set (view, "diagram", options->diagram))
    return qn_cli_refuse_name (self->name, options->diagram, qn_diagram_names,
                               QN_DIAGRAM_COUNT);
  if (options->step != NULL && !qn_view_options_set (view, "step", options->step))
    return qn_cli_usage_error (self->name, "%s: %s", options->step,
                               _ ("a step is a number from 0, or last"));
  if (options->scale != NULL && !qn_view_options_set (view, "scale", options->scale))
    return qn_cli_usage_error (self->name, "%s: %s", options->scale,
                               _ ("a scale is a positive number, auto or true"));
  if (options->onion != NULL && kind != QN_VIEW_DEFORMED && kind != QN_VIEW_MECHANISM)
    return qn_cli_usage_error (
      self->name, "%s: %s", options->onion,
      _ ("only a deformed view or a mechanism takes a second result"));
  QnExit code = parse_switches (self, options->show, true, view);
  if (code == QN_EXIT_DONE)
    code = parse_switches (self, options->hide, false, view);
  return code;
}

static QnExit
draw_picture (const RenderOptions *options, const QnViewOptions *view,
              const QnOutput *output, const QnInput *input, const QnResult *result,
              const QnResult *onion)
{
  QnFigure figure;
  QnMetadata metadata;
  GError *error = NULL;
  qn_figure_init (&figure, &input->project.model, &input->contacts, result, view->view);
  figure.options = *view;
  figure.options.onion = onion;
  qn_project_get_metadata (&input->project, &metadata);
  bool done =
    qn_underlay_read (&input->project, options->input.allow_outside,
                      &figure.options.underlay, &error)
    && qn_figure_export (&figure, options->picture.path, output, &metadata, &error);
  g_clear_pointer (&figure.options.underlay.image, cairo_surface_destroy);
  return done ? QN_EXIT_DONE : qn_cli_fail (error);
}

/* With a second result of the same project, which may have been computed otherwise. */
static QnExit
draw_onion (const RenderOptions *options, const QnViewOptions *view,
            const QnOutput *output, const QnInput *input, const QnResult *result,
            const char *path)
{
  QnSheetItem other;
  QnExit code = qn_sheet_item_load (&other, path, options->onion, &options->input);
  if (code != QN_EXIT_DONE)
    return code;
  code = draw_picture (options, view, output, input, result, &other.file.result);
  qn_sheet_item_clear (&other);
  return code;
}

static QnExit
render (const RenderOptions *options, const QnViewOptions *view, const QnOutput *output,
        const char *path)
{
  QnSheetItem item = { 0 };
  gboolean solved = options->result != NULL || qn_view_needs_result (view->view)
                    || view->field != QN_FIELD_NONE;
  QnExit code = solved
                  ? qn_sheet_item_load (&item, path, options->result, &options->input)
                  : qn_input_load (&item.input, path, &options->input);
  if (code != QN_EXIT_DONE)
    return code;

  const QnResult *result = solved ? &item.file.result : NULL;
  code = options->onion != NULL
           ? draw_onion (options, view, output, &item.input, result, path)
           : draw_picture (options, view, output, &item.input, result, NULL);
  qn_sheet_item_clear (&item);
  return code;
}

static QnExit
run_render (const QnSubcommand *self, int argc, char **argv)
{
  RenderOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "view", 0, 0, G_OPTION_ARG_STRING, &options.view, N_ ("What to show"),
      "model|contacts|deformed|mechanism|forces|diagrams" },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Result that is shown"), N_ ("RESULT.json") },
    { "step", 0, 0, G_OPTION_ARG_STRING, &options.step, N_ ("Step of the result, from 0"),
      N_ ("N|last") },
    { "scale", 0, 0, G_OPTION_ARG_STRING, &options.scale,
      N_ ("Factor on displacements; auto: one for all steps; true: 1"),
      N_ ("F|auto|true") },
    { "diagram", 0, 0, G_OPTION_ARG_STRING, &options.diagram,
      N_ ("with --view diagrams: section force of the beams, N, V or M (M)"), "N|V|M" },
    { "field", 0, 0, G_OPTION_ARG_STRING, &options.field, N_ ("Quantity shown by colour"),
      "none|displacement|displacement-x|displacement-y|rotation|stress|stress-x|"
      "stress-y|stress-xy|principal|opening|sliding|crack|bodies" },
    { "onion", 0, 0, G_OPTION_ARG_FILENAME, &options.onion,
      N_ ("Second result of the same project, drawn over the first as outlines"),
      N_ ("RESULT.json") },
    { "show", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.show,
      N_ ("Show these also, commas between them"), SWITCHES },
    { "hide", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.hide, N_ ("Leave out these"),
      SWITCHES },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  QnViewOptions view;
  QnOutput output;
  QnExit code = QN_EXIT_USAGE;

  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = parse_view (self, &options, &view);
  if (code == QN_EXIT_DONE)
    code = qn_picture_output (self, &options.picture, &output);
  if (code == QN_EXIT_DONE)
    code = render (&options, &view, &output, argv[1]);

  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_render = {
  .name = "render",
  .arguments = "MODEL",
  .summary = N_ ("Draw a project or a result of it as PNG, SVG or PDF"),
  .help = N_ ("The ending of the output file chooses the format; - is PNG. A view of a "
              "result is solved first where none is given."),
  .run = run_render,
};
