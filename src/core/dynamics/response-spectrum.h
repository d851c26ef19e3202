/* Elastic response spectrum of a motion of the ground.
 *
 * The largest displacement u of a mass on a damped spring, u'' + 2 damping w u' + w^2 u = -a(t), at
 * rest to begin with, times w^2: the pseudo-acceleration. The acceleration is linear between samples,
 * and each interval is solved exactly (Nigam & Jennings 1969, Bull. Seismol. Soc. Am. 59, 909-922); the
 * oscillator is followed for one more period after the motion has ended. The largest is that at the
 * samples and at twenty places of the period after the end: choose steps of a twentieth of the
 * shortest period or less. */
#pragma once

#include <stddef.h>

/* spectrum[k], in the unit of `acceleration` (count >= 1 samples, `step` s apart), for a period
 * periods[k] > 0, s. 0 <= damping < 1. */
void qn_response_spectrum (const double *acceleration, size_t count, double step,
                           double damping, const double *periods, double *spectrum,
                           size_t period_count);
