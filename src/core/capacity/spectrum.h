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
 *
 * Above ground, Circolare 7/2019 to NTC 2018, C7.2.3, for the first mode of the building, which is
 * linear over its height and normalised at its top:
 *
 *   gamma = 3n/(2n + 1)   psi = z/H                                                    [C7.2.10]
 *   aZ    = Se(T1, xi1) gamma psi sqrt(1 + 4 xi1^2)                           [C7.2.7], [C7.2.8]
 *   A     = 1.1 xi1^-0.5 eta(xi)                                              [C7.2.6], [C7.2.9]
 *   SeZ   = A aZ / (1 + (A - 1) (1 - T/(a T1))^1.6)    T <= a T1, a = 0.8
 *           A aZ                                       a T1 <= T <= b T1, b = 1.1
 *           A aZ / (1 + (A - 1) (T/(b T1) - 1)^1.2)    b T1 <= T
 *
 * xi1 is a ratio here. The code calls it a percentage: 0.0004 xi1^2 of [C7.2.7] is 4 xi1^2, but
 * 5^-0.5 in [C7.2.6] would make the peak of [C7.2.9] lower than SeZ(0) = aZ. SeZ is at least Se(T);
 * the code asks for that beyond T1, but one mode alone says too little near the ground.
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

/* Where the part stands in a building; all 0: at the level of the ground. */
typedef struct QnFloor {
  double height;   /* z, above the foundation, m */
  double building; /* H, of the building, m, >= z */
  int storeys;     /* n, >= 1 */
  double period;   /* T1, of the building, s, > 0 */
  double damping;  /* xi1, of the building, ratio, > 0 */
} QnFloor;

typedef struct QnSpectrum {
  QnSpectrumKind kind;
  double ground_acceleration; /* ag, m/s2, > 0; the importance factor included */
  QnSoil soil;
  double damping; /* ratio, 0.05 as a rule; of POINTS what they were made for */
  const QnVec2
    *points;          /* of POINTS, borrowed: period, s; acceleration, m/s2; ascending */
  size_t point_count; /* >= 1 */
  QnFloor floor;
} QnSpectrum;

/* Spectral acceleration, m/s2, of the floor where there is one, and displacement Se (T/2 pi)^2, m, at a
 * period >= 0 s. */
double qn_spectrum_acceleration (const QnSpectrum *spectrum, double period);
double qn_spectrum_displacement (const QnSpectrum *spectrum, double period);

/* The largest displacement at this period, at those of the points before it, for straight lines between
 * points that lie far apart would have larger ones, and at b T1 of the building, [C8.7.1.12]. */
double qn_spectrum_largest_displacement (const QnSpectrum *spectrum, double period);

/* TC, where the range of constant acceleration ends, s. Of POINTS 2 pi times the largest
 * pseudo-velocity over the largest acceleration, which is TC where they are those of EN 1998-1. */
double qn_spectrum_corner (const QnSpectrum *spectrum);
