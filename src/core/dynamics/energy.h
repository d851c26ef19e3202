/* The energy balance of the time integration.
 *
 * Each term has its own formula (result.h), so that the residual of the balance is the error: of the work of
 * joints that turn within a step, and of Newton's iteration.
 */
#pragma once

#include "core/dynamics/time-step.h"
#include "core/result/result.h"

/* Sums since the start, J. */
typedef struct QnEnergy {
  double sums[QN_ENERGY_KIND_COUNT];
} QnEnergy;

/* At the start of the analysis: INPUT = kinetic + elastic energy of step->start. */
QnEnergy qn_energy_start (const QnTimeStep *step);

/* After the step of h seconds just tried; the mean acceleration of the ground, and how much it
 * changed. Kinetic and elastic energy are those of step->end. */
QnEnergy qn_energy_after (const QnTimeStep *step, const QnEnergy *before, double h,
                          QnVec2 mean, QnVec2 change);

/* After contacts have changed at the start of a step: adds the loss of elastic energy to FRICTION. */
void qn_energy_renew (const QnTimeStep *step, QnEnergy *energy);

/* INPUT less all other terms, J. */
double qn_energy_error (const QnEnergy *energy);
