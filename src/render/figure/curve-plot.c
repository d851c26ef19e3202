#include "render/figure/curve-plot.h"

#include "render/backend/draw-cairo.h"
#include "render/drawing/camera.h"
#include "render/drawing/paint.h"
#include "render/drawing/scene.h"
#include "render/drawing/text.h"
#include "render/figure/figure-furniture.h"
#include "render/figure/figure.h"
#include "render/figure/plot-axes.h"

#include <glib/gi18n-lib.h>

typedef struct Plot {
  const QnCurvePlot *data;
  cairo_t *cr;
  double unit;
  double factor, factor_y; /* of x and y, from SI to the unit shown */
  QnAxis x, y;
} Plot;

/* Whether the point has a place on the axes. */
static bool
is_drawn (const QnCurvePlot *data, double x, double y)
{
  return isfinite (x) && isfinite (y) && (!data->x_log || x > 0)
         && (!data->y_log || y > 0);
}

static void
data_ranges (const QnCurvePlot *data, QnBox *box)
{
  *box = QN_BOX_EMPTY;
  for (size_t c = 0; c < data->curve_count; c++)
    for (size_t i = 0; i < data->curves[c].count; i++)
      if (is_drawn (data, data->curves[c].x[i], data->curves[c].y[i]))
        qn_box_add_point (box, qn_vec2 (data->curves[c].x[i], data->curves[c].y[i]));
  if (!(box->min.x <= box->max.x))
    *box = (QnBox){ { data->x_log, data->y_log }, { data->x_log, data->y_log } };
  for (size_t i = 0; i < data->reference_count; i++)
    if (is_drawn (data, 1, data->references[i].y))
      qn_box_add_point (box, qn_vec2 (box->min.x, data->references[i].y));
  /* Linear axes begin at 0. */
  if (!data->x_log)
    qn_box_add_point (box, qn_vec2 (0, box->min.y));
  if (!data->y_log)
    qn_box_add_point (box, qn_vec2 (box->min.x, 0));
  if (box->max.y > 0 && !data->y_log)
    box->max.y *= 1.04;
}

/* Curves and references differ by dashes as well as by colour. */
static bool
is_dashed (const QnCurvePlot *data, size_t curve)
{
  return data->curve_count > 1 && curve % 2 == 1;
}

static void
draw_curve (const Plot *plot, size_t index)
{
  const QnCurve *curve = &plot->data->curves[index];
  double u = plot->unit, dashes[2] = { 4 * u, 2.5 * u };
  QnColor c = qn_series_color ((int) index, plot->data->monochrome);
  cairo_save (plot->cr);
  qn_set_color (plot->cr, c, 1);
  cairo_set_line_width (plot->cr, 1.3 * u);
  cairo_set_line_join (plot->cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash (plot->cr, dashes, is_dashed (plot->data, index) ? 2 : 0, 0);
  for (size_t i = 0; i < curve->count; i++)
    if (is_drawn (plot->data, curve->x[i], curve->y[i]))
      cairo_line_to (plot->cr, qn_axis_place (&plot->x, curve->x[i] * plot->factor),
                     qn_axis_place (&plot->y, curve->y[i] * plot->factor_y));
  cairo_stroke (plot->cr);
  cairo_restore (plot->cr);
  for (size_t i = 0; i < curve->count && plot->data->points; i++)
    if (is_drawn (plot->data, curve->x[i], curve->y[i]))
      qn_draw_cairo_marker (
        plot->cr, QN_MARKER_DOT, qn_axis_place (&plot->x, curve->x[i] * plot->factor),
        qn_axis_place (&plot->y, curve->y[i] * plot->factor_y), 4.5 * u, 0, u, c);

  if (curve->runs_on && curve->count > 1) {
    const double *end = curve->x + curve->count - 1;
    double angle = end[0] < end[-1] ? G_PI : 0;
    qn_draw_cairo_marker (
      plot->cr, QN_MARKER_ARROW_HEAD,
      qn_axis_place (&plot->x, end[0] * plot->factor) + (angle > 0 ? -7 : 7) * u,
      qn_axis_place (&plot->y, curve->y[curve->count - 1] * plot->factor_y), 7 * u, angle,
      u, c);
  }

  const struct {
    ptrdiff_t at;
    QnMarker marker;
    double size;
  } marks[] = { { curve->limit_point, QN_MARKER_DIAMOND, 7 },
                { curve->collapse_point, QN_MARKER_CROSS, 6.5 },
                { curve->dot, QN_MARKER_DOT, 7.5 } };
  for (size_t k = 0; k < G_N_ELEMENTS (marks); k++)
    if (marks[k].at >= 0 && (size_t) marks[k].at < curve->count)
      qn_draw_cairo_marker (
        plot->cr, marks[k].marker,
        qn_axis_place (&plot->x, curve->x[marks[k].at] * plot->factor),
        qn_axis_place (&plot->y, curve->y[marks[k].at] * plot->factor_y),
        marks[k].size * u, 0, u, c);
}

static QnColor
reference_color (const QnCurvePlot *data, size_t index)
{
  return index == 0
           ? qn_ink (QN_INK_DEAD_LOAD, data->monochrome)
           : qn_series_color ((int) (data->curve_count + index - 1), data->monochrome);
}

static void
draw_references (const Plot *plot)
{
  double u = plot->unit;
  for (size_t i = 0; i < plot->data->reference_count; i++) {
    double dashes[2] = { (i / 2 % 2 == 0 ? 5 : 1.5) * u, 2.5 * u };
    QnColor c = reference_color (plot->data, i);
    double y = qn_axis_place (&plot->y, plot->data->references[i].y * plot->factor_y);
    cairo_save (plot->cr);
    qn_set_color (plot->cr, c, 1);
    cairo_set_line_width (plot->cr, 0.8 * u);
    cairo_set_dash (plot->cr, dashes, 2, 0);
    cairo_move_to (plot->cr, plot->x.start, y);
    cairo_line_to (plot->cr, plot->x.end, y);
    cairo_stroke (plot->cr);
    cairo_restore (plot->cr);
  }
}

/* The legend as that of a scene without commands. */
static QnScene *
create_legend (const QnCurvePlot *data)
{
  QnScene *scene = qn_scene_new ();
  scene->monochrome = data->monochrome;
  QnColor ink = qn_ink (QN_INK_LINE, data->monochrome);
  bool limit = false, collapse = false, runs_on = false;
  for (size_t i = 0; i < data->curve_count; i++) {
    const QnCurve *curve = &data->curves[i];
    limit |= curve->limit_point >= 0;
    collapse |= curve->collapse_point >= 0;
    runs_on |= curve->runs_on;
    if (curve->label != NULL)
      qn_scene_legend (scene, QN_COMMAND_STROKE,
                       qn_series_color ((int) i, data->monochrome), "%s", curve->label)
        ->dashed = is_dashed (data, i);
  }
  for (size_t i = 0; i < data->reference_count; i++) {
    g_autofree char *number = qn_label_number ("%.4g", data->references[i].y);
    QnLegendEntry *entry =
      qn_scene_legend (scene, QN_COMMAND_STROKE, reference_color (data, i), "%s (%s)",
                       data->references[i].label, number);
    entry->dashed = true;
    entry->size = 0.8f;
  }
  if (limit)
    qn_scene_legend_marker (scene, QN_MARKER_DIAMOND, 7, ink, "%s",
                            _ ("first loss of stability"));
  if (collapse)
    qn_scene_legend_marker (scene, QN_MARKER_CROSS, 6.5f, ink, "%s", _ ("collapse"));
  if (runs_on)
    qn_scene_legend_marker (scene, QN_MARKER_ARROW_HEAD, 1, ink, "%s",
                            _ ("grows without limit"));
  return scene;
}

static bool
is_in_time (const QnCurvePlot *data)
{
  return data->curve_count > 0 && data->curves[0].in_time;
}

static bool
settles (const QnCurvePlot *data)
{
  return data->curve_count > 0 && data->curves[0].settles;
}

/* What the curves show: displacements, rotations, or some of each. */
typedef enum Shown { SHOWN_DISPLACEMENTS, SHOWN_ROTATIONS, SHOWN_BOTH } Shown;

static Shown
find_shown (const QnCurvePlot *data)
{
  size_t turning = 0;
  for (size_t i = 0; i < data->curve_count; i++)
    turning += data->curves[i].rotation;
  return turning == 0                   ? SHOWN_DISPLACEMENTS
         : turning == data->curve_count ? SHOWN_ROTATIONS
                                        : SHOWN_BOTH;
}

static const char *
motion_unit (const QnCurvePlot *data, double largest, double *factor)
{
  static const char *const units[][2] = { [SHOWN_DISPLACEMENTS] = { "m", "mm" },
                                          [SHOWN_ROTATIONS] = { "rad", "mrad" },
                                          [SHOWN_BOTH] = { "m, rad", "mm, mrad" } };
  Shown shown = find_shown (data);
  bool small = largest < (shown == SHOWN_ROTATIONS ? 0.1 : 1.0);
  *factor = small ? 1000 : 1;
  return units[shown][small];
}

static const char *
x_unit (const QnCurvePlot *data, double largest, double *factor)
{
  *factor = 1;
  return data->x_unit != NULL ? data->x_unit
         : is_in_time (data)  ? "s"
                              : motion_unit (data, largest, factor);
}

/* NULL: a multiplier, or what the plot's own label says. */
static const char *
y_unit (const QnCurvePlot *data, double largest, double *factor)
{
  *factor = 1;
  if (data->y_label == NULL && settles (data)) {
    *factor = 1e-3;
    return "kN";
  }
  return data->y_label == NULL && is_in_time (data) ? motion_unit (data, largest, factor)
                                                    : NULL;
}

/* "Displacement ux since the dead load"; without the component where curves show several. */
static char *
dup_motion_name (const QnCurvePlot *data)
{
  const char *component = data->curve_count > 0 ? data->curves[0].component : NULL;
  bool since_dead = false;
  for (size_t i = 0; i < data->curve_count; i++) {
    since_dead |= data->curves[i].since_dead;
    if (g_strcmp0 (data->curves[i].component, component) != 0)
      component = NULL;
  }
  Shown shown = find_shown (data);
  if (shown == SHOWN_BOTH)
    return g_strdup (_ ("Displacement or rotation"));
  if (settles (data) && component != NULL)
    return g_strdup_printf (_ ("Settlement %s"), component);
  if (component == NULL)
    return g_strdup (since_dead ? _ ("Displacement since the dead load")
                                : _ ("Displacement"));
  return g_strdup_printf (shown == SHOWN_ROTATIONS
                            ? since_dead ? _ ("Rotation %s since the dead load")
                                         : _ ("Rotation %s")
                          : since_dead ? _ ("Displacement %s since the dead load")
                                       : _ ("Displacement %s"),
                          component);
}

static void
draw_names (const Plot *plot, const char *unit, const char *unit_y, double x,
            double bottom)
{
  g_autofree char *motion = dup_motion_name (plot->data);
  const char *name = plot->data->x_label != NULL ? plot->data->x_label
                     : is_in_time (plot->data)   ? _ ("Time")
                                                 : motion;
  g_autofree char *label =
    *unit != '\0' ? g_strdup_printf ("%s (%s)", name, unit) : g_strdup (name);
  const char *set = plot->data->curve_count > 0 ? plot->data->curves[0].set : NULL;
  g_autofree char *label_y =
    unit_y != NULL ? g_strdup_printf (
      "%s (%s)", settles (plot->data) ? _ ("Reaction") : motion, unit_y)
    : plot->data->y_label != NULL ? g_strdup (plot->data->y_label)
    : set != NULL ? g_strdup_printf (_ ("Load multiplier λ of “%s”"), set)
                  : g_strdup (_ ("Load multiplier λ"));
  qn_axes_draw_names (&plot->x, &plot->y, plot->cr, plot->unit, label, label_y, x, bottom,
                      plot->data->monochrome);
}

void
qn_curve_plot_draw (const QnCurvePlot *data, cairo_t *cr, const QnPage *page, double x,
                    double y, double width, double height)
{
  double u = page->unit;
  Plot plot = { .data = data, .cr = cr, .unit = u };
  cairo_set_antialias (cr,
                       page->antialias ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
  QnBox box;
  data_ranges (data, &box);
  const char *unit =
    x_unit (data, fmax (fabs (box.min.x), fabs (box.max.x)), &plot.factor);
  const char *unit_y =
    y_unit (data, fmax (fabs (box.min.y), fabs (box.max.y)), &plot.factor_y);

  double top = y, bottom = y + height;
  g_autoptr (QnScene) legend = create_legend (data);
  QnFurniture furniture;
  qn_furniture_init_plot (&furniture, legend, cr, u, data->title, data->monochrome, x,
                          width, &top, &bottom);

  plot.y.start = bottom - (3.1 * QN_TYPE_TICK + 4) * u;
  plot.y.end = top + 0.6 * QN_TYPE_TICK * u;
  (data->y_log ? qn_axis_set_log : qn_axis_set) (
    &plot.y, box.min.y * plot.factor_y, box.max.y * plot.factor_y,
    plot.y.start - plot.y.end, QN_TICK_SPACING_Y * u);
  plot.x.start =
    x + 1.8 * QN_TYPE_LABEL * u + qn_axis_text_width (&plot.y, cr, u) + 5 * u;
  plot.x.end = x + width - 2.2 * QN_TYPE_TICK * u;
  (data->x_log ? qn_axis_set_log
               : qn_axis_set) (&plot.x, box.min.x * plot.factor, box.max.x * plot.factor,
                               plot.x.end - plot.x.start, QN_TICK_SPACING_X * u);
  if (plot.y.start > plot.y.end && plot.x.end > plot.x.start) {
    qn_axes_draw (&plot.x, &plot.y, cr, u, data->monochrome);
    draw_references (&plot);
    for (size_t i = 0; i < data->curve_count; i++)
      draw_curve (&plot, i);
    draw_names (&plot, unit, unit_y, x, bottom);
  }
  qn_furniture_draw (&furniture, cr, 1, false);
  qn_furniture_clear (&furniture);
}

static bool
draw_curve_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  (void) error;
  QnFrame frame = qn_page_frame (page, 10);
  qn_curve_plot_draw (data, cr, page, frame.x, frame.y, frame.width, frame.height);
  return true;
}

bool
qn_curve_export (const QnCurvePlot *plot, const char *path, const QnOutput *output,
                 const QnMetadata *metadata, GError **error)
{
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = plot->title;
  QnCurvePlot copy = *plot;
  return qn_page_export (path, output, &full, draw_curve_page, &copy, error);
}
