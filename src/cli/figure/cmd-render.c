#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "render/figure/figure.h"

#include <glib/gi18n.h>

#define SWITCHES "ghost,symbols,loads,dimensions,names,values,legend,titles,monochrome"

static char *render_result, *render_onion, *render_view, *render_step, *render_scale,
  *render_field, *render_diagram;
static char **render_show, **render_hide;

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
parse_view (QnViewOptions *view)
{
  QnView kind = QN_VIEW_MODEL;
  if (render_view != NULL
      && !qn_find_word (render_view, qn_view_names, QN_VIEW_COUNT, &kind))
    qn_cli_refuse_name (render_view, qn_view_names, QN_VIEW_COUNT);
  qn_view_options_init (view, kind);
  view->monochrome = qn_picture.monochrome;
  if (render_field != NULL && !qn_view_options_set (view, "field", render_field))
    qn_cli_refuse_name (render_field, qn_field_names, QN_FIELD_COUNT);
  if (render_diagram != NULL && !qn_view_options_set (view, "diagram", render_diagram))
    qn_cli_refuse_name (render_diagram, qn_diagram_names, QN_DIAGRAM_COUNT);
  if (render_step != NULL && !qn_view_options_set (view, "step", render_step))
    qn_cli_usage_error ("%s: %s", render_step, _ ("a step is a number from 0, or last"));
  if (render_scale != NULL && !qn_view_options_set (view, "scale", render_scale))
    qn_cli_usage_error ("%s: %s", render_scale,
                        _ ("a scale is a positive number, auto or true"));
  if (render_onion != NULL && kind != QN_VIEW_DEFORMED && kind != QN_VIEW_MECHANISM)
    qn_cli_usage_error ("%s: %s", render_onion,
                        _ ("only a deformed view or a mechanism takes a second result"));
  parse_switches (render_show, true, view);
  parse_switches (render_hide, false, view);
}

static const GOptionEntry render_entries[] = {
  { "view", 0, 0, G_OPTION_ARG_STRING, &render_view, N_ ("What to show"),
    "model|contacts|deformed|mechanism|forces|diagrams" },
  { "result", 'r', 0, G_OPTION_ARG_FILENAME, &render_result, N_ ("Result that is shown"),
    N_ ("RESULT.json") },
  { "step", 0, 0, G_OPTION_ARG_STRING, &render_step, N_ ("Step of the result, from 0"),
    N_ ("N|last") },
  { "scale", 0, 0, G_OPTION_ARG_STRING, &render_scale,
    N_ ("Factor on displacements; auto: one for all steps; true: 1"),
    N_ ("F|auto|true") },
  { "diagram", 0, 0, G_OPTION_ARG_STRING, &render_diagram,
    N_ ("with --view diagrams: section force of the beams, N, V or M (M)"), "N|V|M" },
  { "field", 0, 0, G_OPTION_ARG_STRING, &render_field, N_ ("Quantity shown by colour"),
    "none|displacement|displacement-x|displacement-y|rotation|stress|stress-x|"
    "stress-y|stress-xy|principal|opening|sliding|crack|bodies" },
  { "onion", 0, 0, G_OPTION_ARG_FILENAME, &render_onion,
    N_ ("Second result of the same project, drawn over the first as outlines"),
    N_ ("RESULT.json") },
  { "show", 0, 0, G_OPTION_ARG_STRING_ARRAY, &render_show,
    N_ ("Show these also, commas between them"), SWITCHES },
  { "hide", 0, 0, G_OPTION_ARG_STRING_ARRAY, &render_hide, N_ ("Leave out these"),
    SWITCHES },
  QN_PICTURE_ENTRIES (N_ ("OUT.png|svg|pdf")),
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_render (char **arguments)
{
  QnViewOptions view;

  parse_view (&view);
  qn_picture_output ();
  gboolean solved = render_result != NULL || qn_view_needs_result (view.view)
                    || view.field != QN_FIELD_NONE;
  const QnInput *input = solved ? qn_input_load_or_solve (arguments[0], render_result)
                                : qn_input_load (arguments[0]);
  QnFigure figure;
  qn_figure_init (&figure, &input->project.model, &input->contacts,
                  solved ? &input->file.result : NULL, view.view);
  figure.options = view;
  if (render_onion != NULL) /* of the same project; it may have been computed otherwise */
    figure.options.onion =
      &qn_input_load_with_result (arguments[0], render_onion)->file.result;
  qn_cli_must (qn_picture_figure (&figure, input, qn_picture.path, &qn_picture.output));
}

const QnSubcommand qn_cmd_render = {
  .name = "render",
  .arguments = "MODEL",
  .summary = N_ ("Draw a project or a result of it as PNG, SVG or PDF"),
  .help = N_ ("The ending of the output file chooses the format; - is PNG. A view of a "
              "result is solved first where none is given."),
  .options = render_entries,
  .run = run_render,
};
