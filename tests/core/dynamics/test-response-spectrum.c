#include "core/dynamics/response-spectrum.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

#define COUNT 4001
#define STEP  1e-3

/* A half-sine of 1 m/s2 and `duration` s. */
static void
fill_half_sine (double *a, double duration)
{
  for (int i = 0; i < COUNT; i++)
    a[i] = i * STEP < duration ? sin (G_PI * i * STEP / duration) : 0;
}

/* Undamped, against the solution in closed form during the pulse and after it (Clough & Penzien,
 * Dynamics of Structures, chapter 5); in resonance, a pulse of half a period, it is pi / 2. */
static void
test_half_sine (void)
{
  static const double ratios[] = { 0.25, 0.5, 1, 2, 4 }; /* duration / period */
  double a[COUNT];
  fill_half_sine (a, 0.5);
  for (gsize i = 0; i < G_N_ELEMENTS (ratios); i++) {
    double period = 0.5 / ratios[i], found, b = 1 / (2 * ratios[i]), expected = 0;
    qn_response_spectrum (a, COUNT, STEP, 0, &period, &found, 1);
    /* u(t) during the pulse, and the amplitude of the free vibration after it. */
    for (int k = 0; k <= 20000; k++) {
      double s = G_PI * k / 20000; /* pulse's phase; w t = s / b */
      double u = b == 1 ? 0.5 * (sin (s) - s * cos (s))
                        : (sin (s) - b * sin (s / b)) / (1 - b * b);
      expected = MAX (expected, fabs (u));
    }
    double after = b == 1 ? G_PI / 2 : fabs (2 * b / (1 - b * b) * cos (G_PI / (2 * b)));
    expected = MAX (expected, after);
    g_assert_cmpfloat (fabs (found - expected), <, 1e-2 * expected);
    if (b == 1)
      g_assert_cmpfloat (fabs (found - G_PI / 2), <, 1e-2);
  }
}

/* A constant acceleration of long duration: 1 + exp (-damping pi / sqrt (1 - damping^2)). */
static void
test_step (void)
{
  double a[COUNT], periods[] = { 0.1, 0.5, 2 }, found[3];
  static const double dampings[] = { 0, 0.05, 0.5 };
  for (int i = 0; i < COUNT; i++)
    a[i] = 2;
  for (gsize k = 0; k < G_N_ELEMENTS (dampings); k++) {
    double d = dampings[k], expected = 2 * (1 + exp (-d * G_PI / sqrt (1 - d * d)));
    qn_response_spectrum (a, COUNT, STEP, d, periods, found, 3);
    for (int i = 0; i < 3; i++)
      g_assert_cmpfloat (fabs (found[i] - expected), <, 1e-3 * expected);
  }
}

/* Very stiff oscillators follow the ground, very soft ones keep their place. */
static void
test_ends (void)
{
  double a[COUNT], periods[] = { 0.02, 1000 }, found[2];
  fill_half_sine (a, 1);
  qn_response_spectrum (a, COUNT, STEP, 0.05, periods, found, 2);
  g_assert_cmpfloat (fabs (found[0] - 1), <, 1e-2);
  g_assert_cmpfloat (found[1], <, 1e-2);
}

QN_TESTS
{
  g_test_add_func ("/core/response-spectrum/half-sine", test_half_sine);
  g_test_add_func ("/core/response-spectrum/step", test_step);
  g_test_add_func ("/core/response-spectrum/ends", test_ends);
}
