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

static char *animate_result, *animate_view, *animate_scale;
static int animate_frames;
static double animate_rate = 24, animate_speed;
static gboolean animate_once, animate_no_curve;

/* What can be judged before any file is read. */
static void
check (QnViewOptions *view)
{
  if (animate_view != NULL && strcmp (animate_view, "mechanism") != 0
      && strcmp (animate_view, "deformed") != 0)
    qn_cli_usage_error (_ ("--view is mechanism or deformed"));
  view->scale = QN_SCALE_AUTO;
  if (animate_scale != NULL && !qn_view_options_set (view, "scale", animate_scale))
    qn_cli_usage_error (_ ("--scale is a positive number, or auto"));
  if (!isfinite (animate_speed) || animate_speed < 0)
    qn_cli_usage_error (_ ("--speed is a positive number"));
  if (animate_speed > 0 && animate_frames > 0)
    qn_cli_usage_error (_ ("either --speed or --frames, not both"));
  if (qn_picture.transparent)
    qn_cli_usage_error (_ ("animations have a white background"));
  qn_cli_must (qn_animation_check_path (qn_picture.path, QN_TROUBLE));
}

static bool
on_frame (int done, int total, void *user_data)
{
  (void) user_data;
  if (qn_progress_is_shown ()) {
    fprintf (stderr, "\r\033[K");
    if (done < total)
      fprintf (stderr, _ ("frame %d of %d"), done, total);
    fflush (stderr);
  }
  return !qn_interrupt_seen ();
}

static const GOptionEntry animate_entries[] = {
  { "result", 'r', 0, G_OPTION_ARG_FILENAME, &animate_result, N_ ("Result that is shown"),
    N_ ("RESULT.json") },
  { "view", 0, 0, G_OPTION_ARG_STRING, &animate_view,
    N_ ("The mechanism, or the path of equilibria with its curve"),
    "mechanism|deformed" },
  { "scale", 0, 0, G_OPTION_ARG_STRING, &animate_scale, N_ ("Factor on displacements"),
    N_ ("F|auto") },
  { "frames", 0, 0, G_OPTION_ARG_INT, &animate_frames, N_ ("Number of pictures (48)"),
    N_ ("N") },
  { "rate", 0, 0, G_OPTION_ARG_DOUBLE, &animate_rate, N_ ("Pictures per second (24)"),
    N_ ("N") },
  { "speed", 0, 0, G_OPTION_ARG_DOUBLE, &animate_speed,
    N_ ("Of an analysis in time: its seconds in a second; 1 is real time"), N_ ("F") },
  { "once", 0, 0, G_OPTION_ARG_NONE, &animate_once,
    N_ ("Play the mechanism once, not back and forth"), NULL },
  { "no-curve", 0, 0, G_OPTION_ARG_NONE, &animate_no_curve,
    N_ ("Without the load–displacement curve"), NULL },
  { "quiet", 'q', 0, G_OPTION_ARG_NONE, &qn_cli_quiet, N_ ("No progress"), NULL },
  QN_PICTURE_ENTRIES (N_ ("OUT.gif|webm|FOLDER/")),
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_animate (char **arguments)
{
  QnViewOptions view = { 0 };
  if (qn_picture.size == NULL)
    qn_picture.size = (char *) "960x720";
  qn_picture_page ();
  check (&view);
  const QnInput *input = qn_input_load_or_solve (arguments[0], animate_result);
  const QnResult *result = &input->file.result;
  QnView shown = result->mechanism != NULL ? QN_VIEW_MECHANISM : QN_VIEW_DEFORMED;
  QnAnimation animation;
  QnMetadata metadata;
  qn_find_word (animate_view, qn_view_names, QN_VIEW_COUNT, &shown);
  qn_animation_init (&animation, &input->project.model, &input->contacts, result, shown);
  animation.figure.options.monochrome = qn_picture.monochrome;
  animation.figure.options.scale = view.scale;
  animation.once = animate_once;
  animation.curve = !animate_no_curve;
  if (animate_frames != 0)
    animation.frames = animate_frames;
  animation.rate = animate_rate;
  animation.progress = on_frame;
  qn_project_get_metadata (&input->project, &metadata);
  qn_interrupt_install ();
  qn_cli_must (animate_speed == 0
               || qn_animation_set_speed (&animation, animate_speed, QN_TROUBLE));
  qn_cli_must (qn_animation_export (&animation, qn_picture.path, &qn_picture.output,
                                    &metadata, QN_TROUBLE));
}

const QnSubcommand qn_cmd_animate = {
  .name = "animate",
  .arguments = "MODEL",
  .summary = N_ ("Animate a mechanism or a load path: GIF, WebM or numbered pictures"),
  .help =
    N_ ("The ending of the output chooses the format; a name that ends in / is a "
        "folder for pictures frame-0001.png and so on. A project without a result is "
        "solved first."),
  .options = animate_entries,
  .run = run_animate,
};
