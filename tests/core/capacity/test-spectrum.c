/* Spectra beside values computed by hand from the tables of EN 1998-1. */
#include "core/capacity/capacity.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static void
check_close (double value, double expected)
{
  g_assert_cmpfloat (fabs (value / expected - 1), <, 1e-5);
}

static void
test_type_1 (void)
{
  /* soil C: S 1.15, TB 0.2, TC 0.6, TD 2, TE 6; ag 2 m/s2, so ag S = 2.3 */
  const QnSpectrum s = {
    .kind = QN_SPECTRUM_EN_1, .ground_acceleration = 2, .soil = QN_SOIL_C, .damping = 0.05
  };
  check_close (qn_spectrum_acceleration (&s, 0), 2.3);
  check_close (qn_spectrum_acceleration (&s, 0.1), 2.3 * 1.75);
  check_close (qn_spectrum_acceleration (&s, 0.2), 5.75);
  check_close (qn_spectrum_acceleration (&s, 0.6), 5.75);
  check_close (qn_spectrum_acceleration (&s, 1.2), 2.875);
  check_close (qn_spectrum_acceleration (&s, 4), 5.75 * 0.6 * 2 / 16);
  /* the displacement is constant from TD to TE: 0.025 ag S TC TD 2.5 */
  check_close (qn_spectrum_displacement (&s, 5),
               0.025 * 2.3 * 1.2 * 2.5 * 40 / (4 * G_PI * G_PI));
  /* half way from TE to TF, and beyond, annex A */
  check_close (qn_spectrum_displacement (&s, 8), 0.025 * 2.3 * 1.2 * 1.75);
  check_close (qn_spectrum_displacement (&s, 10), 0.025 * 2.3 * 1.2);
  check_close (qn_spectrum_displacement (&s, 20), 0.025 * 2.3 * 1.2);
  check_close (qn_spectrum_corner (&s), 0.6);
}

static void
test_type_2 (void)
{
  /* soil D: S 1.8, TB 0.1, TC 0.3, TD 1.2; damping 0.1: eta = sqrt(10/15) */
  const QnSpectrum s = {
    .kind = QN_SPECTRUM_EN_2, .ground_acceleration = 1, .soil = QN_SOIL_D, .damping = 0.1
  };
  check_close (qn_spectrum_acceleration (&s, 0.2), 1.8 * 2.5 * 0.8164966);
  check_close (qn_spectrum_acceleration (&s, 2.4),
               1.8 * 2.5 * 0.8164966 * 0.3 * 1.2 / 5.76);
  /* eta is never less than 0.55 */
  const QnSpectrum damped = {
    .kind = QN_SPECTRUM_EN_2, .ground_acceleration = 1, .soil = QN_SOIL_A, .damping = 0.5
  };
  check_close (qn_spectrum_acceleration (&damped, 0.2), 2.5 * 0.55);
}

static void
test_points (void)
{
  const QnVec2 points[] = { { 0.1, 2 }, { 0.5, 5 }, { 1, 2.5 }, { 2, 1.25 } };
  const QnSpectrum s = { .kind = QN_SPECTRUM_POINTS, .points = points, .point_count = 4 };
  check_close (qn_spectrum_acceleration (&s, 0), 2);
  check_close (qn_spectrum_acceleration (&s, 0.3), 3.5);
  check_close (qn_spectrum_acceleration (&s, 1), 2.5);
  check_close (qn_spectrum_acceleration (&s, 4), 1.25 / 4);
  check_close (qn_spectrum_displacement (&s, 4), qn_spectrum_displacement (&s, 2));
  check_close (qn_spectrum_corner (&s), 0.5);
  /* 5 x 0.5^2 is more than what is left at 0.9 s. */
  const QnVec2 falling[] = { { 0.2, 8 }, { 0.5, 5 }, { 0.9, 1 } };
  const QnSpectrum f = { .kind = QN_SPECTRUM_POINTS,
                         .points = falling,
                         .point_count = 3 };
  check_close (qn_spectrum_largest_displacement (&f, 5), 1.25 / (4 * G_PI * G_PI));
  check_close (qn_spectrum_largest_displacement (&f, 0.4),
               qn_spectrum_displacement (&f, 0.4));
  const QnVec2 still[] = { { 0, 0 }, { 1, 0 } };
  const QnSpectrum none = { .kind = QN_SPECTRUM_POINTS,
                            .points = still,
                            .point_count = 2 };
  g_assert_cmpfloat (qn_spectrum_corner (&none), ==, 0);
}

/* Circolare 7/2019, C7.2.3: at the top of a building of 5 storeys, gamma = 15/11; T1 = 0.5 s, xi1 = 0.1,
 * where Se = 2.5 ag S sqrt(10/15) = 2.041241; the part has 0.08: eta = sqrt(10/13) = 0.877058. */
static void
test_floor (void)
{
  const double a = 2.041241 * 15 / 11 * 1.0198039, factor = 1.1 / 0.3162278 * 0.877058;
  const QnSpectrum s = { .kind = QN_SPECTRUM_EN_1,
                         .ground_acceleration = 1,
                         .soil = QN_SOIL_A,
                         .damping = 0.08,
                         .floor = { 15, 15, 5, 0.4, 0.1 } };
  check_close (qn_spectrum_acceleration (&s, 0), a);
  check_close (
    qn_spectrum_acceleration (&s, 0.16), /* half of a T1: 0.5^1.6 = 0.3298770 */
    factor * a / (1 + (factor - 1) * 0.3298770));
  check_close (qn_spectrum_acceleration (&s, 0.32), factor * a);
  check_close (qn_spectrum_acceleration (&s, 0.44), factor * a);
  check_close (qn_spectrum_acceleration (&s, 0.66), /* 0.5^1.2 = 0.4352753 */
               factor * a / (1 + (factor - 1) * 0.4352753));
  /* the displacement of b T1 is not undercut: [C8.7.1.12] */
  check_close (
    qn_spectrum_largest_displacement (&s, 0.45),
    fmax (qn_spectrum_displacement (&s, 0.45), factor * a * 0.44 * 0.44 / 39.47842));
  g_assert_cmpfloat (qn_spectrum_largest_displacement (&s, 0.44), ==,
                     qn_spectrum_displacement (&s, 0.44));
  /* near the ground no less than there */
  const QnSpectrum low = { .kind = QN_SPECTRUM_EN_1,
                           .ground_acceleration = 1,
                           .soil = QN_SOIL_A,
                           .damping = 0.05,
                           .floor = { 0.1, 15, 5, 0.4, 0.05 } };
  check_close (qn_spectrum_acceleration (&low, 0), 1);
}

QN_TESTS
{
  g_test_add_func ("/spectrum/type-1", test_type_1);
  g_test_add_func ("/spectrum/type-2", test_type_2);
  g_test_add_func ("/spectrum/points", test_points);
  g_test_add_func ("/spectrum/floor", test_floor);
}
