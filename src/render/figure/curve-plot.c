#include "render/figure/curve-plot.h"

#include "render/drawing/text.h"

#include <glib/gi18n-lib.h>

/* What is shown of all curves. */
typedef struct Data {
  const QnCurve *curves;
  size_t count;
  double largest_x, largest_y;
} Data;

static bool
is_in_time (const Data *data)
{
  return data->count > 0 && data->curves[0].in_time;
}

static bool
settles (const Data *data)
{
  return data->count > 0 && data->curves[0].settles;
}

/* Quantity of the curves: displacements, rotations, or both. */
typedef enum Shown { SHOWN_DISPLACEMENTS, SHOWN_ROTATIONS, SHOWN_BOTH } Shown;

static Shown
find_shown (const Data *data)
{
  size_t turning = 0;
  for (size_t i = 0; i < data->count; i++)
    turning += data->curves[i].rotation;
  return turning == 0             ? SHOWN_DISPLACEMENTS
         : turning == data->count ? SHOWN_ROTATIONS
                                  : SHOWN_BOTH;
}

static const char *
motion_unit (const Data *data, double largest, double *factor)
{
  static const char *const units[][2] = { [SHOWN_DISPLACEMENTS] = { "m", "mm" },
                                          [SHOWN_ROTATIONS] = { "rad", "mrad" },
                                          [SHOWN_BOTH] = { "m, rad", "mm, mrad" } };
  Shown shown = find_shown (data);
  bool small = largest < (shown == SHOWN_ROTATIONS ? 0.1 : 1.0);
  *factor = small ? 1000 : 1;
  return units[shown][small];
}

/* "Displacement ux since the dead load"; without the component where curves show several. */
static char *
dup_motion_name (const Data *data)
{
  const char *component = data->count > 0 ? data->curves[0].component : NULL;
  bool since_dead = false;
  for (size_t i = 0; i < data->count; i++) {
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

/* Names and units of both axes. */
static void
name_axes (QnPlot *plot, const Data *data)
{
  char *motion = qn_plot_keep (plot, dup_motion_name (data));
  const char *set = data->count > 0 ? data->curves[0].set : NULL;
  double factor = 1;
  for (size_t i = 0; i < data->count; i++) /* the same loads may have several names */
    set = g_strcmp0 (data->curves[i].set, set) == 0 ? set : NULL;
  if (is_in_time (data)) {
    const char *unit = motion_unit (data, data->largest_y, &factor);
    plot->x.label = qn_plot_keep (plot, g_strdup_printf ("%s (s)", _ ("Time")));
    plot->y.label = qn_plot_keep (plot, g_strdup_printf ("%s (%s)", motion, unit));
    plot->y.factor = factor;
    return;
  }
  const char *unit = motion_unit (data, data->largest_x, &factor);
  plot->x.label = qn_plot_keep (plot, g_strdup_printf ("%s (%s)", motion, unit));
  plot->x.factor = factor;
  plot->y.label =
    settles (data) ? qn_plot_keep (plot, g_strdup_printf ("%s (kN)", _ ("Reaction")))
    : set != NULL
      ? qn_plot_keep (plot, g_strdup_printf (_ ("Load multiplier λ of “%s”"), set))
      : _ ("Load multiplier λ");
  plot->y.factor = settles (data) ? 1e-3 : 1;
}

static void
add_mark (QnPlot *plot, const QnCurve *curve, int series, ptrdiff_t at, QnMarker marker,
          double size)
{
  if (at >= 0 && (size_t) at < curve->count)
    qn_plot_points (plot, NULL, series, curve->x + at, curve->y + at, 1, marker, size);
}

static void
add_sample (QnPlot *plot, bool shown, QnMarker marker, double size, const char *label)
{
  if (shown)
    qn_plot_points (plot, label, QN_SERIES_INK, NULL, NULL, 0, marker, size);
}

QnPlot *
qn_curve_plot (const QnCurve *curves, size_t count, const QnReferenceLine *references,
               size_t reference_count)
{
  QnPlot *plot = qn_plot_new (NULL, NULL);
  Data data = { curves, count, 0, 0 };
  bool limit = false, collapse = false, runs_on = false;
  plot->y.room = QN_CURVE_ROOM;
  for (size_t c = 0; c < count; c++) {
    limit |= curves[c].limit_point >= 0;
    collapse |= curves[c].collapse_point >= 0;
    runs_on |= curves[c].runs_on;
    for (size_t i = 0; i < curves[c].count; i++) {
      data.largest_x = fmax (data.largest_x, fabs (curves[c].x[i]));
      data.largest_y = fmax (
        data.largest_y, fmax (-curves[c].y[i], (1 + QN_CURVE_ROOM) * curves[c].y[i]));
    }
  }
  name_axes (plot, &data);
  for (size_t i = 0; i < reference_count; i++)
    qn_plot_mark (plot, QN_MARKS_LEVEL, NULL,
                  i == 0 ? QN_SERIES_REFERENCE : (int) (count + i - 1), NULL,
                  &references[i].y, 1)
      ->dash = i / 2 % 2 == 0 ? 5 : 1.5;
  for (size_t i = 0; i < count; i++) {
    /* Curves differ by dashes as well as by colour. */
    const QnCurve *curve = &data.curves[i];
    const int series = (int) i;
    qn_plot_mark (plot, QN_MARKS_LINE, curve->label, series, curve->x, curve->y,
                  curve->count)
      ->dash = data.count > 1 && i % 2 == 1 ? QN_USUAL_DASH : 0;
    if (curve->runs_on && curve->count > 1) {
      const ptrdiff_t end = (ptrdiff_t) curve->count - 1;
      add_mark (plot, curve, series, end, QN_MARKER_ARROW_HEAD, 7);
      if (curve->x[end] < curve->x[end - 1])
        g_array_index (plot->marks, QnMarks, plot->marks->len - 1).angle = G_PI;
    }
    add_mark (plot, curve, series, curve->limit_point, QN_MARKER_DIAMOND, 7);
    add_mark (plot, curve, series, curve->collapse_point, QN_MARKER_CROSS, 6.5);
    add_mark (plot, curve, series, curve->dot, QN_MARKER_DOT, 7.5);
  }
  /* the lines at known values stand behind the curves, but after them in the legend */
  for (size_t i = 0; i < reference_count; i++) {
    QnMarks sample = g_array_index (plot->marks, QnMarks, i);
    g_autofree char *number = qn_label_number ("%.4g", references[i].y);
    sample.label =
      qn_plot_keep (plot, g_strdup_printf ("%s (%s)", references[i].label, number));
    sample.count = 0;
    qn_plot_add (plot, sample);
  }
  add_sample (plot, limit, QN_MARKER_DIAMOND, 7, _ ("first loss of stability"));
  add_sample (plot, collapse, QN_MARKER_CROSS, 6.5, _ ("collapse"));
  add_sample (plot, runs_on, QN_MARKER_ARROW_HEAD, 1, _ ("grows without limit"));
  return plot;
}
