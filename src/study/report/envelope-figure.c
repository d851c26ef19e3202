#include "study/report/envelope-figure.h"

#include "io/text/io-error.h"
#include "render/backend/offscreen.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Least share of the picture's height that the curves take; they are shown up to so many times the least
 * value. */
#define CURVE_SHARE 0.45
#define CURVE_TOP   5.0
#define MARGIN      10.0 /* pt */

/* Of the frame's width, what the axis of positions takes about; room for the wheels, of the structure's width, and
 * for what they weigh, pt. */
#define AXIS_SHARE  0.87
#define WHEEL_SHARE 0.08
#define LABEL_ROOM  9.0

/* Where the multiplier of a position stands, which lasts as long as the plot. */
static const double *
multiplier_at (const QnEnvelope *e, QnEnvelopePlace at)
{
  return &e->lines[at.line].results[at.position].collapse_multiplier;
}

static QnPlot *
make_plot (const QnEnvelopeFigure *figure, const QnBox *box)
{
  const QnEnvelope *e = figure->envelope;
  QnEnvelopePlace least;
  QnPlot *plot = qn_plot_new (_ ("position of the front (m)"), _ ("load multiplier"));
  const double *x = e->x, shown = qn_envelope_multiplier (e, figure->shown);
  plot->title =
    qn_plot_keep (plot, isnan (shown) ? qn_envelope_dup_line_name (e, figure->shown.line)
                                      : qn_envelope_dup_factor (e, figure->shown));
  plot->x.from_zero = false;
  plot->x.low = fmin (x[0], box->min.x);
  plot->x.high = fmax (x[e->count - 1], box->max.x);
  for (gsize k = 0; k < e->line_count; k++) {
    double *y = qn_plot_keep (plot, g_new (double, e->count));
    for (gsize i = 0; i < e->count; i++)
      y[i] = qn_envelope_multiplier (e, (QnEnvelopePlace){ k, i });
    qn_plot_mark (plot, QN_MARKS_LINE,
                  qn_plot_keep (plot, qn_envelope_dup_line_name (e, k)), (int) k, x, y,
                  e->count)
      ->dash = e->lines[k].reversed ? QN_USUAL_DASH : 0;
  }
  if (!isnan (shown))
    qn_plot_points (plot, NULL, QN_SERIES_INK, &x[figure->shown.position],
                    multiplier_at (e, figure->shown), 1, QN_MARKER_RING, 8);
  if (qn_envelope_find_least (e, &least)) {
    const double *y = multiplier_at (e, least);
    plot->y.high = CURVE_TOP * *y;
    qn_plot_points (plot, _ ("least"), QN_SERIES_REFERENCE, &x[least.position], y, 1,
                    QN_MARKER_DOT, 5);
  } else {
    plot->y.high = 1;
  }
  return plot;
}

/* The structure at the scale of the axis of positions, as it collapses there. */
static bool
draw_structure (const QnEnvelopeFigure *figure, cairo_t *cr, const QnPage *page,
                double top, double height, double highest, GError **error)
{
  const QnEnvelope *e = figure->envelope;
  const QnPlotPlace *place = &figure->place;
  const double width = place->frame.max.x - place->frame.min.x;
  const QnCamera camera = {
    .center = { (place->frame.min.x + 0.5 * width - place->x_zero) / place->x_scale,
                highest - 0.5 * height / place->x_scale },
    .scale = place->x_scale,
    .x = place->frame.min.x,
    .y = top,
    .width = width,
    .height = height,
    .unit = page->unit,
  };
  const bool found = !isnan (qn_envelope_multiplier (e, figure->shown));
  const QnResult *result = &e->lines[figure->shown.line].results[figure->shown.position];
  const bool moves = found && result->mechanism != NULL;
  QnViewOptions options;
  qn_view_options_init (&options, moves ? QN_VIEW_MECHANISM : QN_VIEW_MODEL);
  options.phase = figure->phase;
  options.loads = true;
  options.dimensions = false; /* the axis tells them, and they lie half outside */
  g_autoptr (QnScene) scene = qn_scene_build (figure->moved, moves ? &e->contacts : NULL,
                                              moves ? result : NULL, &options, error);
  if (scene == NULL)
    return false;
  cairo_save (cr);
  cairo_rectangle (cr, camera.x, camera.y, camera.width, camera.height);
  cairo_clip (cr);
  bool ok = qn_scene_draw (scene, &camera, cr, page, error);
  cairo_restore (cr);
  return ok;
}

bool
qn_envelope_draw (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  QnEnvelopeFigure *figure = data;
  const QnFrame whole = qn_page_frame (page, MARGIN);
  /* The structure with the surface of its fill, m. */
  QnBox box = qn_box_of_points (figure->moved->vertices, figure->moved->vertex_count);
  for (size_t i = 0; i < figure->moved->dead_load_count; i++)
    for (int32_t k = 0; k < figure->moved->dead_loads[i].surface_count; k++)
      qn_box_add_point (&box,
                        qn_vec2 (box.min.x, figure->moved->dead_loads[i].surface[k].y));
  box.max.y += WHEEL_SHARE * (box.max.x - box.min.x);
  g_autoptr (QnPlot) plot = make_plot (figure, &box);
  QnFrame below = whole;
  double scale = AXIS_SHARE * whole.width / (plot->x.high - plot->x.low);
  const double room = LABEL_ROOM * page->unit;
  double height = fmin (scale * (box.max.y - box.min.y) + MARGIN * page->unit + room,
                        (1 - CURVE_SHARE) * whole.height);
  below.y += height;
  below.height -= height;
  qn_plot_draw (plot, cr, page->unit, &below, &figure->place);
  return draw_structure (figure, cr, page, whole.y, height,
                         box.max.y + room / figure->place.x_scale, error);
}

gboolean
qn_envelope_export (const QnEnvelope *envelope, QnEnvelopePlace shown, const char *path,
                    const QnOutput *output, const QnMetadata *metadata, GError **error)
{
  QnModel moved;
  QnDiag diag = { 0 };
  QnEnvelopeFigure figure = { envelope, &moved, .shown = shown, .phase = 1 };
  if (qn_envelope_move (envelope, shown, &moved, &diag) != QN_OK)
    return qn_io_fail (error, QN_IO_ERROR_NO_MEMORY, "%s",
                       _ (qn_problem_text (diag.problem)));
  bool ok = qn_page_export (path, output, metadata, qn_envelope_draw, &figure, error);
  qn_model_clear (&moved);
  return ok;
}
