#include "render/drawing/color.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* Relative luminance of sRGB (IEC 61966-2-1). */
static double
luminance (QnColor c)
{
  const double weights[3] = { 0.2126, 0.7152, 0.0722 };
  const uint8_t bytes[3] = { c.r, c.g, c.b };
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    double v = bytes[i] / 255.0;
    sum += weights[i] * (v <= 0.04045 ? v / 12.92 : pow ((v + 0.055) / 1.055, 2.4));
  }
  return sum;
}

/* CIE lightness L*. */
static double
lightness (QnColor c)
{
  return 116 * cbrt (fmax (luminance (c), 0.008856)) - 16;
}

static void
test_sequential_is_even (void)
{
  double first = lightness (qn_map_sequential (0, 0));
  double last = lightness (qn_map_sequential (1, 0));
  g_assert_cmpfloat (last - first, >, 50);
  for (int i = 0; i < 10; i++) {
    double step = lightness (qn_map_sequential ((i + 1) / 10.0, 0))
                  - lightness (qn_map_sequential (i / 10.0, 0));
    g_assert_cmpfloat (step, >, 0.6 * (last - first) / 10);
    g_assert_cmpfloat (step, <, 1.4 * (last - first) / 10);
  }
}

/* A deuteranope sees red and green as one (Vienot, Brettel & Mollon 1999 average them nearly):
 * what is left, their mean against blue, must still tell the ends and the middle apart. */
static void
test_maps_survive_colour_blindness (void)
{
  double previous = -1;
  for (int i = 0; i <= 8; i++) {
    QnColor c = qn_map_sequential (i / 8.0, 0);
    double warm = 0.5 * (c.r + c.g);
    g_assert_cmpfloat (warm, >, previous + 4);
    previous = warm;
  }
  QnColor low = qn_map_diverging (-1, 0), high = qn_map_diverging (1, 0);
  double low_hue = 0.5 * (low.r + low.g) - low.b;
  double high_hue = 0.5 * (high.r + high.g) - high.b;
  g_assert_cmpfloat (high_hue - low_hue, >, 100);
}

static void
test_diverging_is_light_at_zero (void)
{
  double middle = lightness (qn_map_diverging (0, 0));
  g_assert_cmpfloat (middle, >, 90);
  g_assert_cmpfloat (lightness (qn_map_diverging (-1, 0)), <, middle - 30);
  g_assert_cmpfloat (lightness (qn_map_diverging (1, 0)), <, middle - 30);
}

static void
test_clamps (void)
{
  QnColor a = qn_map_sequential (-5, 0), b = qn_map_sequential (0, 0);
  g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  a = qn_map_sequential (9, 0);
  b = qn_map_sequential (1, 0);
  g_assert_cmpmem (&a, sizeof a, &b, sizeof b);
  a = qn_map_sequential ((double) NAN, 0);
  g_assert_cmpint (a.r, ==, a.g);
}

static void
test_monochrome_is_grey (void)
{
  for (int ink = 0; ink < QN_INK_COUNT; ink++) {
    QnColor c = qn_ink ((QnInk) ink, 1);
    g_assert_true (c.r == c.g && c.g == c.b);
  }
  for (int i = 0; i <= 4; i++) {
    QnColor c = qn_map_sequential (i / 4.0, 1);
    g_assert_true (ABS (c.r - c.g) <= 1 && ABS (c.g - c.b) <= 1);
  }
}

QN_TESTS
{
  g_test_add_func ("/render/color/sequential-even", test_sequential_is_even);
  g_test_add_func ("/render/color/colour-blind", test_maps_survive_colour_blindness);
  g_test_add_func ("/render/color/diverging", test_diverging_is_light_at_zero);
  g_test_add_func ("/render/color/clamp", test_clamps);
  g_test_add_func ("/render/color/monochrome", test_monochrome_is_grey);
}
