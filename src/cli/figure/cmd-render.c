#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "render/figure/figure.h"

#include <glib/gi18n.h>

#define SWITCHES "ghost,symbols,loads,dimensions,names,values,legend,titles,monochrome"

typedef struct RenderOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *result, *onion, *view, *step, *scale, *field, *diagram;
  char **show, **hide;
} RenderOptions;

/* Sets the switches that a --show or --hide names, several with commas between them. */
static void
parse_switches (char **lists, bool on, QnViewOptions *view)
{
  for (char **list = lists; list != NULL && *list != NULL; list++) {
    g_auto (GStrv) names = g_strsplit (*list, ",", -1);
    for (char **name = names; *name != NULL; name++) {
      bool *flag = qn_view_switch (view, *name);
      if (flag == NULL)
        qn_cli_refuse_name (*name, qn_view_switches,
                            g_strv_length ((char **) qn_view_switches));
      else
        *flag = on;
    }
  }
}

/* What can be judged before any file is read. */
static void
parse_view (const RenderOptions *options, QnViewOptions *view)
{
  QnView kind = QN_VIEW_MODEL;
  if (options->view != NULL
      && !qn_find_word (options->view, qn_view_names, QN_VIEW_COUNT, &kind))
    qn_cli_refuse_name (options->view, qn_view_names, QN_VIEW_COUNT);
  qn_view_options_init (view, kind);
  view->monochrome = options->picture.monochrome;
  if (options->field != NULL && !qn_view_options_set (view, "field", options->field))
    qn_cli_refuse_name (options->field, qn_field_names, QN_FIELD_COUNT);
  if (options->diagram != NULL
      && !qn_view_options_set (view, "diagram", options->diagram))
    qn_cli_refuse_name (options->diagram, qn_diagram_names, QN_DIAGRAM_COUNT);
  if (options->step != NULL && !qn_view_options_set (view, "step", options->step))
    qn_cli_usage_error ("%s: %s", options->step,
                        _ ("a step is a number from 0, or last"));
  if (options->scale != NULL && !qn_view_options_set (view, "scale", options->scale))
    qn_cli_usage_error ("%s: %s", options->scale,
                        _ ("a scale is a positive number, auto or true"));
  if (options->onion != NULL && kind != QN_VIEW_DEFORMED && kind != QN_VIEW_MECHANISM)
    qn_cli_usage_error ("%s: %s", options->onion,
                        _ ("only a deformed view or a mechanism takes a second result"));
  parse_switches (options->show, true, view);
  parse_switches (options->hide, false, view);
}

static void
render (const RenderOptions *options, const QnViewOptions *view, const char *path)
{
  gboolean solved = options->result != NULL || qn_view_needs_result (view->view)
                    || view->field != QN_FIELD_NONE;
  const QnInput *input =
    solved ? qn_input_load_or_solve (path, options->result, &options->input)
           : qn_input_load (path, &options->input);
  QnFigure figure;
  qn_figure_init (&figure, &input->project.model, &input->contacts,
                  solved ? &input->file.result : NULL, view->view);
  figure.options = *view;
  if (options->onion
      != NULL) /* of the same project; it may have been computed otherwise */
    figure.options.onion =
      &qn_input_load_with_result (path, options->onion, &options->input)->file.result;
  qn_cli_must (qn_picture_figure (&figure, input, &options->input, options->picture.path,
                                  &options->picture.output));
}

static void
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

  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  parse_view (&options, &view);
  qn_picture_output (&options.picture);
  render (&options, &view, argv[1]);
}

const QnSubcommand qn_cmd_render = {
  .name = "render",
  .arguments = "MODEL",
  .summary = N_ ("Draw a project or a result of it as PNG, SVG or PDF"),
  .help = N_ ("The ending of the output file chooses the format; - is PNG. A view of a "
              "result is solved first where none is given."),
  .run = run_render,
};
