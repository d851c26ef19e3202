/* The energy balance of the time integration.
 *
 * Every term comes from its own formula (result.h says what they are), so that what is left of
 * the balance is the error: of the work that joints do while they turn within a step, and of
 * Newton's iteration that ends somewhere.
 */
#pragma once

#include "core/dynamics/time-step.h"
#include "core/result/result.h"

/* Sums since the start, J. */
typedef struct QnEnergy {
  double sums[QN_ENERGY_KIND_COUNT];
} QnEnergy;

/* At the start of everything: kinetic and elastic energy of step->start are the first input. */
QnEnergy qn_energy_start (const QnTimeStep *step);

/* After the step of h seconds just tried; the mean acceleration of the ground, and how much it
 * changed. Kinetic and elastic energy are those of step->end. */
QnEnergy qn_energy_after (const QnTimeStep *step, const QnEnergy *before, double h,
                          QnVec2 mean, QnVec2 change);

/* After contacts have changed at the start of a step: what they stored more or less before counts as
 * lost with them, in FRICTION. */
void qn_energy_renew (const QnTimeStep *step, QnEnergy *energy);

/* Input less all others. */
double qn_energy_error (const QnEnergy *energy);
