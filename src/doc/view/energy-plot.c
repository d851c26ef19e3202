#include "doc/view/energy-plot.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#define MOST_SAMPLES 600

/* The curve behind those of QnEnergyKind. */
#define ERROR QN_ENERGY_KIND_COUNT

static double
energy_of (const double *row, int curve)
{
  const double *sums = row + QN_HISTORY_ENERGY;
  double rest = sums[QN_ENERGY_INPUT];
  if (curve != ERROR)
    return sums[curve];
  for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
    rest -= sums[kind];
  return rest;
}

static void
choose_unit (QnEnergyPlot *plot)
{
  static const char *const symbols[] = { "J", "kJ", "MJ" };
  double largest = 0.0;
  int k = 0;
  for (gsize i = 0; i < QN_ENERGY_CURVES * plot->count; i++)
    largest = fmax (largest, fabs (plot->energies[i]));
  for (plot->unit = 1.0; k < 2 && largest >= 1e3 * plot->unit; k++)
    plot->unit *= 1e3;
  plot->symbol = symbols[k];
  for (gsize i = 0; i < QN_ENERGY_CURVES * plot->count; i++)
    plot->energies[i] /= plot->unit;
}

void
qn_energy_plot_init (QnEnergyPlot *plot, const QnHistory *history)
{
  gsize every = history->row_count / MOST_SAMPLES + 1;
  *plot = (QnEnergyPlot){ .count = (history->row_count + every - 1) / every };
  plot->times = g_new (double, plot->count + 1);
  plot->energies = g_new (double, QN_ENERGY_CURVES * plot->count + 1);
  for (gsize i = 0; i < plot->count; i++) {
    /* the last one is the last row */
    gsize at = i + 1 < plot->count ? i * every : history->row_count - 1;
    const double *row = history->rows + history->width * at;
    plot->times[i] = row[QN_HISTORY_TIME];
    for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
      plot->energies[plot->count * (gsize) curve + i] = energy_of (row, curve);
  }
  choose_unit (plot);
}

void
qn_energy_plot_clear (QnEnergyPlot *plot)
{
  g_free (plot->times);
  g_free (plot->energies);
  *plot = (QnEnergyPlot){ 0 };
}

const char *
qn_energy_text (int curve)
{
  switch (curve) {
  case QN_ENERGY_INPUT:
    return C_ ("energy", "input");
  case QN_ENERGY_KINETIC:
    return C_ ("energy", "kinetic");
  case QN_ENERGY_ELASTIC:
    return C_ ("energy", "elastic");
  case QN_ENERGY_FRICTION:
    return C_ ("energy", "friction");
  case QN_ENERGY_DAMPING:
    return C_ ("energy", "damping");
  case QN_ENERGY_NUMERICAL:
    return C_ ("energy", "numerical");
  default:
    return C_ ("energy", "error");
  }
}

int
qn_energy_series (int curve)
{
  return curve == ERROR ? QN_ENERGY_KINETIC : curve;
}

gboolean
qn_energy_is_dashed (int curve)
{
  return curve == ERROR;
}

gsize
qn_energy_plot_find (const QnEnergyPlot *plot, double time)
{
  gsize i = 0;
  while (i + 1 < plot->count
         && fabs (plot->times[i + 1] - time) <= fabs (plot->times[i] - time))
    i++;
  return i;
}

/* The plot of the arrays in `marks`, with labels where there is a legend. */
static QnDataPlot
describe (const QnEnergyPlot *plot, QnMarks marks[QN_ENERGY_CURVES], const char *y_label,
          gboolean legend)
{
  /* the input on top of what it is spent on */
  for (int i = 0; i < QN_ENERGY_CURVES; i++) {
    int curve = legend ? i : QN_ENERGY_CURVES - 1 - i;
    marks[i] = (QnMarks){ .kind = QN_MARKS_LINE,
                          .label = legend ? qn_energy_text (curve) : NULL,
                          .series = qn_energy_series (curve),
                          .dashed = qn_energy_is_dashed (curve),
                          .x = plot->times,
                          .y = plot->energies + plot->count * (gsize) curve,
                          .count = plot->count };
  }
  return (QnDataPlot){ .x_label = _ ("Time (s)"),
                       .y_label = y_label,
                       .x_from_zero = true,
                       .y_from_zero = true,
                       .marks = marks,
                       .mark_count = QN_ENERGY_CURVES };
}

static char *
dup_label (const QnEnergyPlot *plot)
{
  return g_strdup_printf (_ ("Energy (%s)"), plot->symbol);
}

void
qn_energy_plot_draw (const QnEnergyPlot *plot, gboolean legend, cairo_t *cr, double width,
                     double height, double unit, QnPlotPlace *place)
{
  QnMarks marks[QN_ENERGY_CURVES];
  g_autofree char *label = dup_label (plot);
  QnDataPlot data = describe (plot, marks, label, legend);
  qn_data_plot_draw (&data, cr, width, height, unit, place);
}

gboolean
qn_energy_plot_export (const QnEnergyPlot *plot, const char *title, gboolean monochrome,
                       const char *path, const QnOutput *output,
                       const QnMetadata *metadata, GError **error)
{
  QnMarks marks[QN_ENERGY_CURVES];
  g_autofree char *label = dup_label (plot);
  QnDataPlot data = describe (plot, marks, label, TRUE);
  data.title = title;
  data.monochrome = monochrome;
  return qn_data_plot_export (&data, path, output, metadata, error);
}
