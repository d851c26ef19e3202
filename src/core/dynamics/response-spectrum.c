#include "core/dynamics/response-spectrum.h"
#include "core/base/base.h"

#include <math.h>

/* Places of the period after the end of the motion. */
#define PLACES 20

typedef struct Oscillator {
  double w, damping, damped; /* circular frequencies, 1/s */
  double u, v;
} Oscillator;

/* The state after a time t without any acceleration. */
static void
swing (Oscillator *o, double t)
{
  double decay = exp (-o->damping * o->w * t), s = sin (o->damped * t),
         c = cos (o->damped * t), u = o->u, v = o->v;

  o->u = decay * (u * c + (v + o->damping * o->w * u) / o->damped * s);
  o->v = decay * (v * c - (o->w * o->w * u + o->damping * o->w * v) / o->damped * s);
}

void
qn_response_spectrum (const double *acceleration, size_t count, double step,
                      double damping, const double *periods, double *spectrum,
                      size_t period_count)
{
  for (size_t k = 0; k < period_count; k++) {
    double w = 2 * QN_PI / periods[k], largest = 0;
    Oscillator o = { .w = w,
                     .damping = damping,
                     .damped = w * sqrt (1 - damping * damping) };

    for (size_t i = 1; i < count; i++) {
      /* Under an acceleration that goes from a to b the particular solution is linear in
       * time, p + q t, and what is left swings freely. */
      double a = acceleration[i - 1], b = acceleration[i], square = w * w;
      double q = -(b - a) / (step * square), p = -a / square - 2 * damping * q / w;
      o.u -= p;
      o.v -= q;
      swing (&o, step);
      o.u += p + q * step;
      o.v += q;
      largest = fmax (largest, fabs (o.u));
    }
    for (int i = 0; i < PLACES; i++) {
      swing (&o, periods[k] / PLACES);
      largest = fmax (largest, fabs (o.u));
    }
    spectrum[k] = w * w * largest;
  }
}
