#include "cli/input.h"
#include "cli/message.h"
#include "cli/picture.h"
#include "cli/subcommand.h"
#include "render/figure.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

typedef struct Options {
  QnPictureOptions picture;
  char *result, *view, *step, *scale, *field;
  char **overrides;
} Options;

/* `text` is what stands on the command line. */
static QnExit
refuse (const QnSubcommand *self, const char *reason, const char *text)
{
  g_autofree char *message = g_strdup_printf ("%s: %s", text, reason);
  qn_cli_usage_error (self->name, message);
  return QN_EXIT_USAGE;
}

static gboolean
parse_step (const char *text, int32_t *step)
{
  guint64 number;
  if (text == NULL || strcmp (text, "last") == 0) {
    *step = QN_STEP_LAST;
    return TRUE;
  }
  if (!g_ascii_string_to_unsigned (text, 10, 0, G_MAXINT32, &number, NULL))
    return FALSE;
  *step = (int32_t) number;
  return TRUE;
}

static gboolean
parse_scale (const char *text, double *scale)
{
  char *end = NULL;
  if (text == NULL || strcmp (text, "auto") == 0) {
    *scale = QN_SCALE_AUTO;
    return TRUE;
  }
  *scale = g_ascii_strtod (text, &end);
  return end != text && *end == '\0' && isfinite (*scale) && *scale > 0;
}

/* What can be judged before any file is read. */
static QnExit
parse_view (const QnSubcommand *self, const Options *options, QnViewOptions *view)
{
  QnView kind = QN_VIEW_MODEL;
  if (options->view != NULL && !qn_view_parse (options->view, &kind))
    return refuse (self, _ ("no such view"), options->view);
  qn_view_options_init (view, kind);
  view->monochrome = options->picture.monochrome;
  if (options->field != NULL && !qn_field_parse (options->field, &view->field))
    return refuse (self, _ ("no such field"), options->field);
  if (!parse_step (options->step, &view->step))
    return refuse (self, _ ("a step is a number from 0, or last"), options->step);
  if (!parse_scale (options->scale, &view->scale))
    return refuse (self, _ ("a scale is a positive number, or auto"), options->scale);
  if (options->result == NULL && kind != QN_VIEW_MODEL && kind != QN_VIEW_CONTACTS)
    return refuse (self, _ ("this view needs --result"), options->view);
  return QN_EXIT_DONE;
}

static QnExit
render (const Options *options, const QnViewOptions *view, const QnOutput *output,
        const char *path)
{
  QnInput input;
  QnResultFile file = { 0 };
  QnExit code = options->result != NULL
                  ? qn_input_load_with_result (&input, &file, path, options->result,
                                               options->overrides, FALSE)
                  : qn_input_load (&input, path, options->overrides, FALSE);
  if (code != QN_EXIT_DONE)
    return code;

  QnFigure figure;
  QnMetadata metadata;
  GError *error = NULL;
  const QnResult *result = options->result != NULL ? &file.result : NULL;
  qn_figure_init (&figure, &input.project.model, &input.contacts, result, view->view);
  figure.options = *view;
  qn_picture_metadata (&input.project, &metadata);
  if (!qn_figure_export (&figure, options->picture.path, output, &metadata, &error))
    code = qn_cli_fail (error);

  if (result != NULL)
    qn_result_file_clear (&file);
  qn_input_clear (&input);
  return code;
}

static QnExit
run (const QnSubcommand *self, int argc, char **argv)
{
  Options options = { 0 };
  const GOptionEntry entries[] = {
    { "view", 0, 0, G_OPTION_ARG_STRING, &options.view, N_ ("What to show"),
      "model|contacts|deformed|mechanism|forces" },
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Result that is shown"), N_ ("RESULT.json") },
    { "step", 0, 0, G_OPTION_ARG_STRING, &options.step, N_ ("Step of the result, from 0"),
      N_ ("N|last") },
    { "scale", 0, 0, G_OPTION_ARG_STRING, &options.scale, N_ ("Factor on displacements"),
      N_ ("F|auto") },
    { "field", 0, 0, G_OPTION_ARG_STRING, &options.field,
      N_ ("Quantity shown by colour: displacement, rotation, stress, opening, …"),
      N_ ("NAME") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    QN_INPUT_SET_ENTRY (&options.overrides),
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

  qn_picture_options_clear (&options.picture);
  g_free (options.result);
  g_free (options.view);
  g_free (options.step);
  g_free (options.scale);
  g_free (options.field);
  g_strfreev (options.overrides);
  return code;
}

const QnSubcommand qn_cmd_render = {
  .name = "render",
  .arguments = "MODEL",
  .summary = N_ ("Draw a project or a result of it as PNG, SVG or PDF"),
  .help = N_ ("The ending of the output file chooses the format; - is PNG."),
  .run = run,
};
