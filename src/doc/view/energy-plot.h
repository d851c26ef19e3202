/* Energies of an analysis in time over its time. */
#pragma once

#include "core/result/result.h"
#include "render/figure/plot.h"

/* The kinds of QnEnergyKind, then the error of the balance. */
#define QN_ENERGY_CURVES (QN_ENERGY_KIND_COUNT + 1)

/* A line for each of them at the same times, a few hundred at most: what lies between is left out. The
 * unit, "J", "kJ" or "MJ", goes by the largest energy. */
QnPlot *qn_energy_plot (const QnHistory *history, const char **unit);
