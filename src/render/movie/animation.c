#include "render/movie/animation.h"

#include "core/base/integer.h"
#include "render/backend/offscreen.h"
#include "render/figure/curve-plot.h"
#include "render/figure/figure.h"
#include "render/movie/movie.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#define FRAME_MARGIN 8.0 /* pt */

/* Share of the page that the curve takes. */
#define CURVE_SHARE 0.38

/* Frames over the whole run, the fullest among them, that a format looks at before the first. */
#define SAMPLES 4

typedef struct Player {
  const QnAnimation *animation;
  const QnPage *page;
  QnFigure figure;    /* of the frame being drawn */
  QnScene *reference; /* the fullest scene, with a box around all frames */
  QnFigureLayout layout;
  bool along_steps;
  int32_t *steps; /* of the result, one per frame */
  QnCurve curve;
  QnFrame plot; /* where the curve goes; no width: nowhere */
} Player;

void
qn_animation_init (QnAnimation *animation, const QnModel *model,
                   const QnContacts *contacts, const QnResult *result, QnView view)
{
  *animation = (QnAnimation){ .frames = 48, .rate = 24, .curve = true };
  qn_figure_init (&animation->figure, model, contacts, result, view);
}

/* s, of an analysis in time; else 0. */
static double
duration (const QnResult *result)
{
  return result != NULL && result->history.width > 0 && result->step_count > 1
           ? result->steps[result->step_count - 1].time
           : 0;
}

double
qn_animation_frames_at (const QnResult *result, double rate, double speed)
{
  double seconds = duration (result);
  return seconds > 0 ? fmax (1 + round (seconds * rate / speed), 2) : 0;
}

bool
qn_animation_set_speed (QnAnimation *animation, double speed, GError **error)
{
  double frames =
    qn_animation_frames_at (animation->figure.result, animation->rate, speed);
  if (frames > 0 && frames <= QN_MAX_FRAMES) {
    animation->frames = (int) qn_to_integer (frames, 2, QN_MAX_FRAMES);
    return true;
  }
  if (frames == 0)
    return qn_render_refuse (error,
                             _ ("--speed: the result is not one of an analysis in time"));
  return qn_render_refuse (
    error,
    _ ("--speed: these are %.0f pictures; at most %d can be written: choose a "
       "lower --rate or a higher speed"),
    frames, QN_MAX_FRAMES);
}

double
qn_animation_speed_of (const QnResult *result, double rate, int frames)
{
  return duration (result) * rate / (frames - 1);
}

/* ---- what a frame shows ---------------------------------------------------------------- */

/* The steps are taken at even distances along the curve, so that long stretches of small
 * increments do not stand still. */
static int32_t *
choose_steps (const QnCurve *curve, int frames)
{
  size_t n = curve->count;
  g_autofree double *along = g_new0 (double, n);
  double width = 0, height = 0;
  for (size_t i = 0; i < n; i++) {
    width = fmax (width, fabs (curve->x[i]));
    height = fmax (height, fabs (curve->y[i]));
  }
  for (size_t i = 1; i < n; i++) {
    double dx = width > 0 ? (curve->x[i] - curve->x[i - 1]) / width : 0;
    double dy =
      height > 0 && !curve->in_time ? (curve->y[i] - curve->y[i - 1]) / height : 0;
    along[i] = along[i - 1] + hypot (dx, dy);
  }
  int32_t *steps = g_new0 (int32_t, frames);
  size_t at = 0;
  for (int k = 0; k < frames; k++) {
    double target = along[n - 1] * k / (frames - 1);
    while (at + 1 < n && along[at + 1] <= target * (1 + 1e-12))
      at++;
    bool next = at + 1 < n && along[at + 1] - target < target - along[at];
    steps[k] = (int32_t) (next ? at + 1 : at);
  }
  steps[frames - 1] = (int32_t) n - 1;
  return steps;
}

static void
set_frame (Player *player, int k)
{
  int frames = player->animation->frames;
  if (player->along_steps) {
    player->figure.options.step = player->steps[k];
    return;
  }
  double t = (double) k / (player->animation->once ? frames - 1 : frames);
  player->figure.options.phase =
    player->animation->once ? 0.5 * (1 - cos (G_PI * t)) : 0.5 * (1 - cos (2 * G_PI * t));
}

static QnScene *
build_scene (const Player *player, GError **error)
{
  const QnFigure *f = &player->figure;
  return qn_scene_build (f->model, f->contacts, f->result, &f->options, error);
}

/* The scene of the fullest frame; its box is widened to hold the others too. */
static QnScene *
build_reference (Player *player, GError **error)
{
  QnFigure *figure = &player->figure;
  figure->options.step = QN_STEP_LAST;
  figure->options.phase = 1;
  QnScene *reference = build_scene (player, error);
  if (reference == NULL)
    return NULL;
  /* One scale for all frames, although steps left to themselves would each choose theirs. */
  figure->options.scale = reference->scale;
  QnBox box = reference->box;
  for (int k = 0; k < player->animation->frames; k++) {
    set_frame (player, k);
    if (k > 0 && player->along_steps && player->steps[k] == player->steps[k - 1])
      continue;
    g_autoptr (QnScene) scene = build_scene (player, error);
    if (scene == NULL) {
      qn_scene_free (reference);
      return NULL;
    }
    qn_box_add_box (&box, scene->box);
  }
  reference->box = box;
  return reference;
}

static QnFrame
divide_page (Player *player)
{
  const QnPage *page = player->page;
  QnFrame frame = qn_page_frame (page, FRAME_MARGIN);
  if (!player->along_steps || !player->animation->curve || player->curve.count < 2)
    return frame;
  player->plot = frame;
  if (page->width >= page->height) {
    player->plot.width = CURVE_SHARE * frame.width;
    player->plot.x = frame.x + frame.width - player->plot.width;
    player->plot.y += 0.15 * frame.height;
    player->plot.height *= 0.7;
    frame.width -= player->plot.width + 2 * frame.x;
  } else {
    player->plot.height = CURVE_SHARE * frame.height;
    player->plot.y = frame.y + frame.height - player->plot.height;
    frame.height -= player->plot.height + 2 * frame.y;
  }
  return frame;
}

static bool
player_init (Player *player, const QnAnimation *animation, const QnPage *page,
             cairo_t *cr, GError **error)
{
  *player = (Player){ .animation = animation, .page = page, .figure = animation->figure };
  player->along_steps = animation->figure.options.view != QN_VIEW_MECHANISM;
  const QnResult *result = animation->figure.result;
  if (player->along_steps) {
    if (animation->figure.options.view == QN_VIEW_MODEL)
      player->figure.options.view = QN_VIEW_DEFORMED;
    if (result == NULL || result->step_count == 0)
      return qn_render_refuse (error, _ ("the result has no steps"));
    qn_curve_from_result (&player->curve, animation->figure.model, result,
                          qn_result_curve_motion (animation->figure.model, result));
    player->steps = choose_steps (&player->curve, animation->frames);
    qn_curve_cut_runaway (&player->curve);
  }
  player->reference = build_reference (player, error);
  if (player->reference == NULL)
    return false;
  QnFrame frame = divide_page (player);
  player->figure.options.step = QN_STEP_LAST;
  qn_figure_layout_init (&player->layout, &player->figure, player->reference, cr, page,
                         &frame);
  return true;
}

/* ---- frames ---------------------------------------------------------------------------- */

static bool
draw_frame (Player *player, cairo_t *cr, int k, GError **error)
{
  set_frame (player, k);
  g_autoptr (QnScene) scene = build_scene (player, error);
  if (scene == NULL)
    return false;
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  if (!qn_figure_layout_draw (&player->layout, &player->figure, scene, cr, player->page,
                              error))
    return false;
  if (player->plot.width > 0) {
    player->curve.dot =
      MIN ((ptrdiff_t) player->steps[k], (ptrdiff_t) player->curve.count - 1);
    g_autoptr (QnPlot) plot = qn_curve_plot (&player->curve, 1, NULL, 0);
    plot->monochrome = player->figure.options.monochrome;
    qn_plot_draw (plot, cr, player->page->unit, &player->plot, NULL);
  }
  cairo_surface_flush (cairo_get_target (cr));
  return qn_output_succeeded (cairo_status (cr), error);
}

static bool
add_frames (Player *player, cairo_t *cr, const QnMovieFormat *format, void *movie,
            GError **error)
{
  const QnAnimation *animation = player->animation;
  for (int k = 0; k < animation->frames; k++) {
    if (!draw_frame (player, cr, k, error)
        || !format->add (movie, cairo_get_target (cr), error))
      return false;
    if (animation->progress != NULL
        && !animation->progress (k + 1, animation->frames, animation->user_data)) {
      g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_CANCELLED,
                           _ ("cancelled"));
      return false;
    }
  }
  return true;
}

static bool
play (Player *player, cairo_t *cr, const QnMovieFormat *format, const char *path,
      const QnMetadata *metadata, GError **error)
{
  const QnAnimation *animation = player->animation;
  int frames = animation->frames;
  int last = player->along_steps || animation->once ? frames - 1 : frames / 2;
  void *movie = format->open (path, player->page, animation->rate, metadata, error);
  bool done = movie != NULL;
  for (int i = 0; i < SAMPLES && done && format->look != NULL; i++) {
    done = draw_frame (player, cr, last * i / (SAMPLES - 1), error);
    if (done)
      format->look (movie, cairo_get_target (cr));
  }
  if (done && add_frames (player, cr, format, movie, error))
    return format->finish (movie, error);
  if (movie != NULL)
    format->abandon (movie);
  return false;
}

/* ---- export ---------------------------------------------------------------------------- */

static const QnMovieFormat *
format_of_path (const char *path, GError **error)
{
  g_autofree char *lower = g_ascii_strdown (path, -1);
  if (g_str_has_suffix (lower, G_DIR_SEPARATOR_S)
      || g_file_test (path, G_FILE_TEST_IS_DIR))
    return &qn_movie_frames;
  if (g_str_has_suffix (lower, ".gif"))
    return &qn_movie_gif;
  if (g_str_has_suffix (lower, ".webm"))
    return qn_movie_webm (error);
  g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE,
               _ ("%s: an animation's name ends in .gif, .webm or / for a folder"), path);
  return NULL;
}

bool
qn_animation_check_path (const char *path, GError **error)
{
  return format_of_path (path, error) != NULL;
}

bool
qn_animation_export (const QnAnimation *animation, const char *path,
                     const QnOutput *output, const QnMetadata *metadata, GError **error)
{
  const QnMovieFormat *format = format_of_path (path, error);
  QnPage page;
  if (format == NULL || !qn_output_page (output, &page, error))
    return false;
  if (animation->frames < 2 || animation->frames > QN_MAX_FRAMES
      || !(animation->rate >= 1 && animation->rate <= 60))
    return qn_render_refuse (
      error, _ ("an animation has 2 to %d frames, 1 to 60 in a second"), QN_MAX_FRAMES);
  g_autoptr (QnOffscreen) offscreen = NULL;
  if (output->backend == QN_BACKEND_GL && (offscreen = qn_offscreen_new (error)) == NULL)
    return false;
  page.offscreen = offscreen;
  QnMetadata full = qn_figure_metadata (&animation->figure, metadata);

  cairo_surface_t *surface = qn_page_create_image (&page);
  cairo_t *cr = cairo_create (surface);
  Player player;
  bool done = player_init (&player, animation, &page, cr, error)
              && play (&player, cr, format, path, &full, error);
  qn_furniture_clear (&player.layout.furniture);
  qn_scene_free (player.reference);
  qn_curve_clear (&player.curve);
  g_free (player.steps);
  cairo_destroy (cr);
  cairo_surface_destroy (surface);
  return done;
}
