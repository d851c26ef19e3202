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

static const char *
name_of (int curve)
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

QnPlot *
qn_energy_plot (const QnHistory *history, const char **unit)
{
  static const char *const units[] = { "J", "kJ", "MJ" };
  gsize every = history->row_count / MOST_SAMPLES + 1;
  gsize count = (history->row_count + every - 1) / every;
  double largest = 0.0, scale = 1.0;
  int k = 0;
  QnPlot *plot = qn_plot_new (_ ("Time (s)"), NULL);
  double *times = qn_plot_keep (plot, g_new (double, count + 1));
  double *energies = qn_plot_keep (plot, g_new (double, QN_ENERGY_CURVES *count + 1));
  for (gsize i = 0; i < count; i++) {
    /* the last one is the last row */
    gsize at = i + 1 < count ? i * every : history->row_count - 1;
    const double *row = history->rows + history->width * at;
    times[i] = row[QN_HISTORY_TIME];
    for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
      energies[count * (gsize) curve + i] = energy_of (row, curve);
  }
  for (gsize i = 0; i < QN_ENERGY_CURVES * count; i++)
    largest = fmax (largest, fabs (energies[i]));
  for (; k < 2 && largest >= 1e3 * scale; k++)
    scale *= 1e3;
  for (gsize i = 0; i < QN_ENERGY_CURVES * count; i++)
    energies[i] /= scale;
  *unit = units[k];
  plot->y.label = qn_plot_keep (plot, g_strdup_printf (_ ("Energy (%s)"), *unit));
  for (int curve = 0; curve < QN_ENERGY_CURVES; curve++)
    qn_plot_mark (plot, QN_MARKS_LINE, name_of (curve),
                  curve == ERROR ? QN_ENERGY_KINETIC : curve, times,
                  energies + count * (gsize) curve, count)
      ->dash = curve == ERROR ? QN_USUAL_DASH : 0;
  return plot;
}
