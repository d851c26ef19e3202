#include "doc/view/ground-preview.h"

#include "core/base/integer.h"
#include "core/dynamics/ground.h"
#include "core/dynamics/response-spectrum.h"
#include "render/figure/plot.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Samples: as near as 5 ms where that is not too many. */
#define NEAR   5e-3
#define LEAST  501
#define MOST   20001
#define BEFORE 0.05 /* of the duration, at rest after the end */

/* Periods of the spectrum, s. */
#define PREVIEW_PERIODS 120
#define SHORTEST_PERIOD 0.05
#define LONGEST_PERIOD  4.0

/* Along the direction of the motion, which has any length. */
static double
along (const QnGroundMotion *motion, QnVec2 vector)
{
  double length = qn_vec2_length (motion->direction);
  return length > 0 ? qn_vec2_dot (vector, motion->direction) / length : 0;
}

static void
sample (QnGroundPreview *preview, const QnGround *ground, QnGroundPreviewKind kind)
{
  const QnGroundMotion *motion = &ground->model->ground[0];
  double duration = (1 + BEFORE) * ground->end, v = 0, d = 0;
  gsize count = (gsize) qn_to_integer (ceil (duration / NEAR) + 1, LEAST, MOST);
  double step = duration / (double) (count - 1);
  preview->count = count;
  preview->x = g_new (double, count);
  preview->y = g_new (double, count);
  for (gsize i = 0; i < count; i++) {
    double time = step * (double) i;
    double a = along (motion, qn_ground_acceleration (ground, time));
    preview->x[i] = time;
    preview->y[i] = kind == QN_GROUND_VELOCITY       ? v
                    : kind == QN_GROUND_DISPLACEMENT ? d
                                                     : a;
    double mean = along (motion, qn_ground_mean (ground, time, time + step));
    d += step * (v + 0.5 * step * mean);
    v += step * mean;
  }
}

void
qn_ground_preview_init (QnGroundPreview *preview, const QnModel *model, gsize motion,
                        QnGroundPreviewKind kind)
{
  QnModel alone = *model;
  QnGround ground;
  *preview = (QnGroundPreview){ 0 };
  if (motion >= model->ground_count)
    return;
  alone.ground = &model->ground[motion];
  alone.ground_count = 1;
  gboolean has_points =
    alone.ground->kind == QN_SIGNAL_PULSE || alone.ground->point_count > 1;
  if (!has_points || !qn_ground_init (&ground, &alone))
    return;
  if (ground.end > 0)
    sample (preview, &ground, kind);
  if (preview->count > 0 && kind == QN_GROUND_SPECTRUM) {
    /* Periods in equal ratios, and the accelerations in place of those in time. */
    double *periods = g_new (double, PREVIEW_PERIODS),
           *spectrum = g_new (double, PREVIEW_PERIODS);
    for (int k = 0; k < PREVIEW_PERIODS; k++)
      periods[k] = SHORTEST_PERIOD
                   * pow (LONGEST_PERIOD / SHORTEST_PERIOD, k / (PREVIEW_PERIODS - 1.0));
    qn_response_spectrum (preview->y, preview->count, preview->x[1], QN_GROUND_DAMPING,
                          periods, spectrum, PREVIEW_PERIODS);
    qn_ground_preview_clear (preview);
    *preview = (QnGroundPreview){ periods, spectrum, PREVIEW_PERIODS };
  }
  qn_ground_clear (&ground);
}

void
qn_ground_preview_clear (QnGroundPreview *preview)
{
  g_free (preview->x);
  g_free (preview->y);
  *preview = (QnGroundPreview){ 0 };
}

QnPlot *
qn_ground_preview_plot (const QnGroundPreview *preview, QnGroundPreviewKind kind)
{
  const char *const labels[QN_GROUND_PREVIEW_COUNT] = {
    [QN_GROUND_ACCELERATION] = _ ("Acceleration (m/s²)"),
    [QN_GROUND_VELOCITY] = _ ("Velocity (m/s)"),
    [QN_GROUND_DISPLACEMENT] = _ ("Displacement (m)"),
    [QN_GROUND_SPECTRUM] = _ ("Spectral acceleration (m/s²)"),
  };
  QnPlot *plot = qn_plot_new (kind == QN_GROUND_SPECTRUM ? _ ("Period (s), damping 5 %")
                                                         : _ ("Time (s)"),
                              labels[kind]);
  qn_plot_mark (plot, QN_MARKS_LINE, NULL, 0, preview->x, preview->y, preview->count);
  return plot;
}

void
qn_ground_preview_add_periods (QnPlot *plot, const QnGroundPreview *spectrum,
                               const double *omegas, gsize count)
{
  double *x = qn_plot_keep (plot, g_new (double, count + 1));
  double *y = qn_plot_keep (plot, g_new (double, count + 1));
  gsize inside = 0;
  for (gsize i = 0; i < count; i++) {
    double period = omegas[i] > 0 ? 2 * G_PI / omegas[i] : INFINITY;
    gsize k = 1;
    while (k < spectrum->count && spectrum->x[k] < period)
      k++;
    if (k >= spectrum->count || period < spectrum->x[0])
      continue;
    double part = (period - spectrum->x[k - 1]) / (spectrum->x[k] - spectrum->x[k - 1]);
    x[inside] = period;
    y[inside++] = spectrum->y[k - 1] + part * (spectrum->y[k] - spectrum->y[k - 1]);
  }
  if (inside > 0)
    qn_plot_mark (plot, QN_MARKS_POINTS, _ ("modes"), 1, x, y, inside);
}
