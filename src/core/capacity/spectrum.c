#include "core/capacity/spectrum.h"

#include <math.h>

/* End of the long periods of annex A, s. */
#define TF 10.0

/* a and b of [C7.2.6]: where the largest accelerations of a floor are, over T1. */
#define PLATEAU_START 0.8
#define PLATEAU_END   1.1

typedef struct {
  double s, tb, tc, td, te;
} Soil;

/* Tables 3.2, 3.3 and A.1 of EN 1998-1:2004. */
static const Soil soils[2][QN_SOIL_COUNT] = {
  { [QN_SOIL_A] = { 1.0, 0.15, 0.4, 2.0, 4.5 },
    [QN_SOIL_B] = { 1.2, 0.15, 0.5, 2.0, 5.0 },
    [QN_SOIL_C] = { 1.15, 0.20, 0.6, 2.0, 6.0 },
    [QN_SOIL_D] = { 1.35, 0.20, 0.8, 2.0, 6.0 },
    [QN_SOIL_E] = { 1.4, 0.15, 0.5, 2.0, 6.0 } },
  { [QN_SOIL_A] = { 1.0, 0.05, 0.25, 1.2, INFINITY },
    [QN_SOIL_B] = { 1.35, 0.05, 0.25, 1.2, INFINITY },
    [QN_SOIL_C] = { 1.5, 0.10, 0.25, 1.2, INFINITY },
    [QN_SOIL_D] = { 1.8, 0.10, 0.30, 1.2, INFINITY },
    [QN_SOIL_E] = { 1.6, 0.05, 0.25, 1.2, INFINITY } },
};

static const Soil *
soil_of (const QnSpectrum *spectrum)
{
  return &soils[spectrum->kind == QN_SPECTRUM_EN_2][spectrum->soil];
}

static double
points_acceleration (const QnSpectrum *spectrum, double t)
{
  const QnVec2 *p = spectrum->points;
  size_t last = spectrum->point_count - 1, i = 0;

  if (t <= p[0].x)
    return p[0].y;
  if (t >= p[last].x)
    return p[last].y * (p[last].x / t) * (p[last].x / t);
  while (p[i + 1].x < t)
    i++;
  return p[i].y + (t - p[i].x) / (p[i + 1].x - p[i].x) * (p[i + 1].y - p[i].y);
}

static double
eta (double damping)
{
  return fmax (sqrt (10 / (5 + 100 * damping)), 0.55);
}

/* That of the ground, of another damping too. */
static double
ground_acceleration (const QnSpectrum *spectrum, double t, double damping)
{
  if (spectrum->kind == QN_SPECTRUM_POINTS)
    return points_acceleration (spectrum, t) * eta (damping) / eta (spectrum->damping);
  const Soil *soil = soil_of (spectrum);
  double ground = spectrum->ground_acceleration * soil->s, top = 2.5 * eta (damping);

  if (t <= soil->tb)
    return ground * (1 + t / soil->tb * (top - 1));
  if (t <= soil->tc)
    return ground * top;
  if (t <= soil->td)
    return ground * top * soil->tc / t;
  if (t <= soil->te)
    return ground * top * soil->tc * soil->td / (t * t);
  double part = fmin ((t - soil->te) / (TF - soil->te), 1); /* annex A */
  double displacement = 0.025 * ground * soil->tc * soil->td * (top + part * (1 - top));
  return displacement * 4 * QN_PI * QN_PI / (t * t);
}

double
qn_spectrum_acceleration (const QnSpectrum *spectrum, double t)
{
  const QnFloor *f = &spectrum->floor;
  double ground = ground_acceleration (spectrum, t, spectrum->damping);

  if (!(f->height > 0))
    return ground;
  double participation = 3.0 * f->storeys / (2 * f->storeys + 1);
  double peak = ground_acceleration (spectrum, f->period, f->damping) * participation
                * f->height / f->building * sqrt (1 + 4 * f->damping * f->damping);
  double amplification = 1.1 / sqrt (f->damping) * eta (spectrum->damping), beside = 0;
  if (t < PLATEAU_START * f->period)
    beside = pow (1 - t / (PLATEAU_START * f->period), 1.6);
  else if (t > PLATEAU_END * f->period)
    beside = pow (t / (PLATEAU_END * f->period) - 1, 1.2);
  return fmax (amplification * peak / (1 + (amplification - 1) * beside), ground);
}

double
qn_spectrum_displacement (const QnSpectrum *spectrum, double t)
{
  double omega_inverse = t / (2 * QN_PI);

  return qn_spectrum_acceleration (spectrum, t) * omega_inverse * omega_inverse;
}

double
qn_spectrum_largest_displacement (const QnSpectrum *spectrum, double t)
{
  double largest = qn_spectrum_displacement (spectrum, t);

  if (spectrum->floor.height > 0 && t > PLATEAU_END * spectrum->floor.period)
    largest = fmax (
      largest, qn_spectrum_displacement (spectrum, PLATEAU_END * spectrum->floor.period));
  for (size_t i = 0; i < spectrum->point_count && spectrum->points[i].x < t; i++)
    largest = fmax (largest, qn_spectrum_displacement (spectrum, spectrum->points[i].x));
  return largest;
}

double
qn_spectrum_corner (const QnSpectrum *spectrum)
{
  double acceleration = 0, velocity = 0; /* of the latter 2 pi times */

  if (spectrum->kind != QN_SPECTRUM_POINTS)
    return soil_of (spectrum)->tc;
  for (size_t i = 0; i < spectrum->point_count; i++) {
    acceleration = fmax (acceleration, spectrum->points[i].y);
    velocity = fmax (velocity, spectrum->points[i].y * spectrum->points[i].x);
  }
  return acceleration > 0 ? velocity / acceleration : 0;
}
