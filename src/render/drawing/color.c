#include "render/drawing/color.h"

#include "core/base/base.h"
#include "core/base/integer.h"

#include <math.h>

/* In colours, and in greys. */
static const uint32_t inks[QN_INK_COUNT][2] = {
  [QN_INK_LINE] = { 0x1a1a1a, 0x000000 },
  [QN_INK_FAINT] = { 0x8c8c8c, 0x8c8c8c },
  [QN_INK_BLOCK] = { 0xf1e6d2, 0xf2f2f2 },
  [QN_INK_SUPPORT] = { 0xdcdcdc, 0xd8d8d8 },
  [QN_INK_SOIL] = { 0xd8cfc0, 0xe2e2e2 },
  [QN_INK_FACE] = { 0x0072b2, 0x505050 },
  [QN_INK_PAIR] = { 0xd55e00, 0x000000 },
  [QN_INK_OPEN] = { 0xc8321e, 0x303030 },
  [QN_INK_SLIDE] = { 0x0060a8, 0x000000 },
  [QN_INK_HINGE] = { 0x1a1a1a, 0x000000 },
  [QN_INK_FORCE] = { 0x005a8c, 0x000000 },
  [QN_INK_DEAD_LOAD] = { 0x5a5a5a, 0x5a5a5a },
  [QN_INK_LIVE_LOAD] = { 0xb33a00, 0x000000 },
  [QN_INK_GROUND] = { 0xffffff, 0xffffff },
  [QN_INK_SELECTION] = { 0x1c71d8, 0x404040 },
  [QN_INK_THRUST] = { 0x96266e, 0x202020 },
  [QN_INK_BAR] = { 0x262659, 0x202020 },
};

QnColor
qn_ink (QnInk ink, int monochrome)
{
  return qn_rgb (inks[ink][monochrome != 0]);
}

QnColor
qn_material_color (int index, int monochrome)
{
  static const uint32_t colors[] = { 0xf1e6d2, 0xd9b48f, 0xc5d3dc,
                                     0xb9a6c4, 0xcfd8a8, 0xa3826a };
  static const uint32_t greys[] = { 0xf2f2f2, 0xd0d0d0, 0xb0b0b0,
                                    0xe2e2e2, 0xc0c0c0, 0x989898 };
  index %= (int) QN_N_ELEMENTS (colors);
  return qn_rgb (monochrome ? greys[index] : colors[index]);
}

QnColor
qn_series_color (int index, int monochrome)
{
  static const uint32_t colors[] = { 0x0060a8, 0xc8501e, 0x00845f,
                                     0x8a4f9e, 0x9a7000, 0x3f3f3f };
  static const uint32_t greys[] = { 0x000000, 0x606060, 0x909090 };
  return qn_rgb (monochrome ? greys[index % (int) QN_N_ELEMENTS (greys)]
                            : colors[index % (int) QN_N_ELEMENTS (colors)]);
}

/* ---- OKLab ------------------------------------------------------------------------- */

static double
gamma_encode (double linear)
{
  if (linear <= 0.0031308)
    return 12.92 * linear;
  return 1.055 * pow (linear, 1.0 / 2.4) - 0.055;
}

static uint8_t
to_byte (double linear)
{
  double v = gamma_encode (fmin (fmax (linear, 0.0), 1.0)) * 255.0;
  return (uint8_t) qn_to_integer (round (v), 0, 255);
}

/* OKLab to sRGB; the matrices are those of B. Ottosson, "A perceptual color space for image
 * processing", 2020. */
static QnColor
from_oklab (double L, double a, double b)
{
  double l = L + 0.3963377774 * a + 0.2158037573 * b;
  double m = L - 0.1055613458 * a - 0.0638541728 * b;
  double s = L - 0.0894841775 * a - 1.2914855480 * b;
  l = l * l * l;
  m = m * m * m;
  s = s * s * s;
  return (QnColor){
    to_byte (4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    to_byte (-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    to_byte (-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s),
    255,
  };
}

QnColor
qn_map_sequential (double t, int monochrome)
{
  if (isnan (t))
    return qn_rgb (0xb4b4b4);
  t = fmin (fmax (t, 0.0), 1.0);
  double L = 0.30 + 0.64 * t;
  if (monochrome)
    return from_oklab (0.97 - 0.62 * t, 0, 0); /* darker = more, as in print */

  /* A straight chord from dark blue to pale yellow. */
  return from_oklab (L, -0.010 - 0.015 * t, -0.135 + 0.265 * t);
}

QnColor
qn_map_diverging (double t, int monochrome)
{
  if (isnan (t))
    return qn_rgb (0xb4b4b4);
  t = fmin (fmax (t, -1.0), 1.0);
  double u = fabs (t);
  if (monochrome)
    return from_oklab (t < 0 ? 0.97 - 0.30 * u : 0.97 - 0.70 * u, 0, 0);
  double L = 0.97 - 0.47 * u;
  return t < 0 ? from_oklab (L, -0.030 * u, -0.135 * u)
               : from_oklab (L, 0.105 * u, 0.095 * u);
}

QnColor
qn_color_fade (QnColor color, double alpha)
{
  color.a = (uint8_t) qn_to_integer (round (color.a * alpha), 0, color.a);
  return color;
}
