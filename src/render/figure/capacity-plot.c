#include "render/figure/capacity-plot.h"

#include "render/figure/data-plot.h"

#include <math.h>

/* Points of the spectrum, evenly spread over periods from 0 to LONGEST s. */
#define PERIODS 800
#define LONGEST 10.0

/* The spectrum is shown up to so many times the end of the curve. */
#define BEYOND 1.3

/* Limit states of a plot. */
#define MOST_MARKS 4

/* Points of the spectrum, as displacement and acceleration; returns how many. */
static size_t
find_spectrum (const QnCapacityPlot *plot, double farthest, double *x, double *y)
{
  size_t count = 0;
  for (size_t i = 0; i < PERIODS; i++) {
    double period = LONGEST * (double) i / (PERIODS - 1);
    x[count] = qn_spectrum_displacement (plot->spectrum, period);
    y[count] = qn_spectrum_acceleration (plot->spectrum, period);
    count += x[count] <= farthest;
  }
  return count;
}

bool
qn_capacity_plot_export (const QnCapacityPlot *plot, const char *path,
                         const QnOutput *output, const QnMetadata *metadata,
                         GError **error)
{
  const QnCapacity *c = plot->capacity;
  QnMarks marks[2 + 2 * MOST_MARKS];
  g_autofree double *x = g_new (double, c->count), *y = g_new (double, c->count);
  g_autofree double *sx = g_new (double, PERIODS), *sy = g_new (double, PERIODS);
  double px[MOST_MARKS][3], py[MOST_MARKS][3];
  size_t count = 0, shown = MIN (plot->mark_count, MOST_MARKS);
  double farthest = c->end;

  for (size_t i = 0; i < c->count; i++) {
    x[i] = c->points[i].displacement;
    y[i] = c->points[i].acceleration;
  }
  for (size_t i = 0; i < shown; i++)
    farthest = fmax (farthest, plot->marks[i].state.demand);
  marks[count++] = (QnMarks){ .kind = QN_MARKS_LINE,
                              .label = plot->curve_label,
                              .series = 0,
                              .x = x,
                              .y = y,
                              .count = c->count };
  if (plot->spectrum != NULL)
    marks[count++] =
      (QnMarks){ .kind = QN_MARKS_LINE,
                 .label = plot->spectrum_label,
                 .series = 1,
                 .dashed = true,
                 .x = sx,
                 .y = sy,
                 .count = find_spectrum (plot, BEYOND * farthest, sx, sy) };
  for (size_t i = 0; i < shown; i++) {
    const QnCapacityState *state = &plot->marks[i].state;
    double omega = 2 * G_PI / state->period;
    /* the demand ends the line from the origin whose slope is that of its period */
    px[i][0] = py[i][0] = 0;
    px[i][1] = state->demand;
    py[i][1] = omega * omega * state->demand;
    px[i][2] = state->capacity;
    py[i][2] = qn_capacity_acceleration (c, state->capacity);
    marks[count++] = (QnMarks){ .kind = QN_MARKS_LINE,
                                .label = plot->marks[i].demand_label,
                                .series = (int) (2 + i),
                                .x = px[i],
                                .y = py[i],
                                .count = 2 };
    marks[count++] = (QnMarks){ .kind = QN_MARKS_POINTS,
                                .label = plot->marks[i].capacity_label,
                                .series = (int) (2 + i),
                                .x = px[i] + 2,
                                .y = py[i] + 2,
                                .count = 1 };
  }
  QnDataPlot data = { .title = plot->title,
                      .x_label = plot->x_label,
                      .y_label = plot->y_label,
                      .x_from_zero = true,
                      .y_from_zero = true,
                      .marks = marks,
                      .mark_count = count,
                      .monochrome = plot->monochrome };
  return qn_data_plot_export (&data, path, output, metadata, error);
}
