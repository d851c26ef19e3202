#include "render/figure/capacity-plot.h"

#include "render/figure/data-plot.h"

#include <math.h>

/* Points of the spectrum, evenly spread over periods from 0 to LONGEST s. */
#define PERIODS 800
#define LONGEST 10.0

/* The spectrum is shown up to so many times the end of the curve. */
#define BEYOND_END 1.3

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

/* The plot as a table's, with the numbers that it points to. */
typedef struct Drawn {
  QnDataPlot data;
  QnMarks marks[2 + 2 * MOST_MARKS];
  double *x, *y;                   /* of the curve; owned */
  double sx[PERIODS], sy[PERIODS]; /* of the spectrum */
  double px[MOST_MARKS][3], py[MOST_MARKS][3];
} Drawn;

static Drawn *
prepare (const QnCapacityPlot *plot)
{
  const QnCapacity *c = plot->capacity;
  Drawn *d = g_new0 (Drawn, 1);
  size_t count = 0, shown = MIN (plot->mark_count, MOST_MARKS);
  double farthest = c->end, highest = 0;

  d->x = g_new (double, c->count);
  d->y = g_new (double, c->count);
  for (size_t i = 0; i < c->count; i++) {
    d->x[i] = c->points[i].displacement;
    d->y[i] = c->points[i].acceleration;
  }
  for (size_t i = 0; i < shown; i++)
    if (!plot->marks[i].state.refused)
      farthest = fmax (farthest, plot->marks[i].state.demand);
  d->marks[count++] = (QnMarks){ .kind = QN_MARKS_LINE,
                                 .label = plot->curve_label,
                                 .series = 0,
                                 .x = d->x,
                                 .y = d->y,
                                 .count = c->count };
  if (plot->spectrum != NULL)
    d->marks[count++] =
      (QnMarks){ .kind = QN_MARKS_LINE,
                 .label = plot->spectrum_label,
                 .series = 1,
                 .dashed = true,
                 .x = d->sx,
                 .y = d->sy,
                 .count = find_spectrum (plot, BEYOND_END * farthest, d->sx, d->sy) };
  for (size_t i = 0; i < c->count; i++)
    highest = fmax (highest, d->y[i]);
  for (size_t i = 0; plot->spectrum != NULL && i < d->marks[1].count; i++)
    highest = fmax (highest, d->sy[i]);
  for (size_t i = 0; i < shown; i++) {
    const QnCapacityState *state = &plot->marks[i].state;
    double omega = 2 * G_PI / state->period, *px = d->px[i], *py = d->py[i];
    if (state->refused)
      continue;
    /* the demand ends the line from the origin whose slope is that of its period; it is cut where curve
     * and spectrum end */
    px[1] = fmin (state->demand, highest / (omega * omega));
    py[1] = omega * omega * px[1];
    px[2] = state->capacity;
    py[2] = qn_capacity_acceleration (c, state->capacity);
    d->marks[count++] = (QnMarks){ .kind = QN_MARKS_LINE,
                                   .label = plot->marks[i].demand_label,
                                   .series = (int) (2 + i),
                                   .x = px,
                                   .y = py,
                                   .count = 2 };
    d->marks[count++] = (QnMarks){ .kind = QN_MARKS_POINTS,
                                   .label = plot->marks[i].capacity_label,
                                   .series = (int) (2 + i),
                                   .x = px + 2,
                                   .y = py + 2,
                                   .count = 1 };
  }
  d->data = (QnDataPlot){ .title = plot->title,
                          .x_label = plot->x_label,
                          .y_label = plot->y_label,
                          .x_from_zero = true,
                          .y_from_zero = true,
                          .marks = d->marks,
                          .mark_count = count,
                          .monochrome = plot->monochrome };
  return d;
}

static void
drawn_free (Drawn *d)
{
  g_free (d->x);
  g_free (d->y);
  g_free (d);
}

void
qn_capacity_plot_draw (const QnCapacityPlot *plot, cairo_t *cr, double width,
                       double height, double unit)
{
  Drawn *d = prepare (plot);
  qn_data_plot_draw (&d->data, cr, width, height, unit, NULL);
  drawn_free (d);
}

bool
qn_capacity_plot_export (const QnCapacityPlot *plot, const char *path,
                         const QnOutput *output, const QnMetadata *metadata,
                         GError **error)
{
  Drawn *d = prepare (plot);
  bool ok = qn_data_plot_export (&d->data, path, output, metadata, error);
  drawn_free (d);
  return ok;
}
