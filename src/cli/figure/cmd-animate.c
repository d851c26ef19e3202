#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/subcommand.h"
#include "core/base/word.h"
#include "doc/view/sheet.h"
#include "render/movie/animation.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef struct AnimateOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *result, *view, *scale;
  int frames;
  double rate, speed;
  gboolean once, no_curve, quiet;
} AnimateOptions;

/* What can be judged before any file is read. */
static void
check (const AnimateOptions *options, QnViewOptions *view)
{
  if (options->view != NULL && strcmp (options->view, "mechanism") != 0
      && strcmp (options->view, "deformed") != 0)
    qn_cli_usage_error (_ ("--view is mechanism or deformed"));
  view->scale = QN_SCALE_AUTO;
  if (options->scale != NULL && !qn_view_options_set (view, "scale", options->scale))
    qn_cli_usage_error (_ ("--scale is a positive number, or auto"));
  if (!isfinite (options->speed) || options->speed < 0)
    qn_cli_usage_error (_ ("--speed is a positive number"));
  if (options->speed > 0 && options->frames > 0)
    qn_cli_usage_error (_ ("either --speed or --frames, not both"));
  if (options->picture.transparent)
    qn_cli_usage_error (_ ("animations have a white background"));
  qn_cli_must (qn_animation_check_path (options->picture.path, QN_TROUBLE));
}

static bool
on_frame (int done, int total, void *user_data)
{
  const gboolean *shown = user_data;
  if (*shown) {
    fprintf (stderr, "\r\033[K");
    if (done < total)
      fprintf (stderr, _ ("frame %d of %d"), done, total);
    fflush (stderr);
  }
  return !qn_interrupt_seen ();
}

static void
animate (const AnimateOptions *options, double scale, const QnInput *input)
{
  const QnResult *result = &input->file.result;
  QnView view = result->mechanism != NULL ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED;
  gboolean shown = !options->quiet && isatty (STDERR_FILENO);
  QnAnimation animation;
  QnMetadata metadata;
  qn_find_word (options->view, qn_view_names, QN_VIEW_COUNT, &view);
  qn_animation_init (&animation, &input->project.model, &input->contacts, result, view);
  animation.figure.options.monochrome = options->picture.monochrome;
  animation.figure.options.scale = scale;
  animation.once = options->once;
  animation.curve = !options->no_curve;
  if (options->frames != 0)
    animation.frames = options->frames;
  animation.rate = options->rate;
  animation.progress = on_frame;
  animation.user_data = &shown;
  qn_project_get_metadata (&input->project, &metadata);
  qn_interrupt_install ();
  qn_cli_must (options->speed == 0
               || qn_animation_set_speed (&animation, options->speed, QN_TROUBLE));
  qn_cli_must (qn_animation_export (&animation, options->picture.path,
                                    &options->picture.output, &metadata, QN_TROUBLE));
}

static void
run_animate (const QnSubcommand *self, int argc, char **argv)
{
  AnimateOptions options = { .rate = 24, .picture.size = (char *) "960x720" };
  const GOptionEntry entries[] = {
    { "result", 'r', 0, G_OPTION_ARG_FILENAME, &options.result,
      N_ ("Result that is shown"), N_ ("RESULT.json") },
    { "view", 0, 0, G_OPTION_ARG_STRING, &options.view,
      N_ ("The mechanism, or the path of equilibria with its curve"),
      "mechanism|deformed" },
    { "scale", 0, 0, G_OPTION_ARG_STRING, &options.scale, N_ ("Factor on displacements"),
      N_ ("F|auto") },
    { "frames", 0, 0, G_OPTION_ARG_INT, &options.frames, N_ ("Number of pictures (48)"),
      N_ ("N") },
    { "rate", 0, 0, G_OPTION_ARG_DOUBLE, &options.rate, N_ ("Pictures per second (24)"),
      N_ ("N") },
    { "speed", 0, 0, G_OPTION_ARG_DOUBLE, &options.speed,
      N_ ("Of an analysis in time: its seconds in a second; 1 is real time"), N_ ("F") },
    { "once", 0, 0, G_OPTION_ARG_NONE, &options.once,
      N_ ("Play the mechanism once, not back and forth"), NULL },
    { "no-curve", 0, 0, G_OPTION_ARG_NONE, &options.no_curve,
      N_ ("Without the load–displacement curve"), NULL },
    { "quiet", 'q', 0, G_OPTION_ARG_NONE, &options.quiet, N_ ("No progress"), NULL },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.gif|webm|FOLDER/")),
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  QnViewOptions view = { 0 };

  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  qn_picture_page (&options.picture);
  check (&options, &view);
  animate (&options, view.scale,
           qn_input_load_or_solve (argv[1], options.result, &options.input));
}

const QnSubcommand qn_cmd_animate = {
  .name = "animate",
  .arguments = "MODEL",
  .summary = N_ ("Animate a mechanism or a load path: GIF, WebM or numbered pictures"),
  .help =
    N_ ("The ending of the output chooses the format; a name that ends in / is a "
        "folder for pictures frame-0001.png and so on. A project without a result is "
        "solved first."),
  .run = run_animate,
};
