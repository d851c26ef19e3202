/* Elastic response spectra of the horizontal acceleration of the ground.
 *
 * EN_1 and EN_2 are the recommended ones of type 1 and 2 of EN 1998-1:2004, 3.2.2.2 and tables 3.2
 * and 3.3: with the ground acceleration ag, the soil's S, TB, TC, TD and
 * eta = sqrt(10/(5 + 100 damping)) >= 0.55
 *
 *   Se = ag S (1 + T/TB (2.5 eta - 1))    T <= TB
 *        ag S 2.5 eta                     TB <= T <= TC
 *        ag S 2.5 eta TC/T                TC <= T <= TD
 *        ag S 2.5 eta TC TD/T^2           TD <= T
 *
 * Type 1 beyond TE by annex A: the displacement falls linearly from 2.5 eta dg at TE to
 * dg = 0.025 ag S TC TD at TF = 10 s. Type 2 has no such branch.
 *
 * POINTS are joined by straight lines; before the first period the acceleration is that of the
 * first point, after the last one the displacement that of the last.
 */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

typedef enum {
  QN_SPECTRUM_EN_1,
  QN_SPECTRUM_EN_2,
  QN_SPECTRUM_POINTS,
  QN_SPECTRUM_KIND_COUNT
} QnSpectrumKind;

typedef enum {
  QN_SOIL_A,
  QN_SOIL_B,
  QN_SOIL_C,
  QN_SOIL_D,
  QN_SOIL_E,
  QN_SOIL_COUNT
} QnSoil;

typedef struct QnSpectrum {
  QnSpectrumKind kind;
  double ground_acceleration; /* ag, m/s2, > 0; the importance factor included */
  QnSoil soil;
  double damping; /* ratio, 0.05 as a rule; of POINTS what they were made for */
  const QnVec2
    *points;          /* of POINTS, borrowed: period, s; acceleration, m/s2; ascending */
  size_t point_count; /* >= 1 */
} QnSpectrum;

/* Spectral acceleration, m/s2, and displacement Se (T/2 pi)^2, m, at a period >= 0 s. */
double qn_spectrum_acceleration (const QnSpectrum *spectrum, double period);
double qn_spectrum_displacement (const QnSpectrum *spectrum, double period);

/* The largest displacement at this period and at those of the points before it: straight lines between
 * points that lie far apart would have larger ones. */
double qn_spectrum_largest_displacement (const QnSpectrum *spectrum, double period);

/* TC, where the range of constant acceleration ends, s. Of POINTS 2 pi times the largest
 * pseudo-velocity over the largest acceleration, which is TC where they are those of EN 1998-1. */
double qn_spectrum_corner (const QnSpectrum *spectrum);
