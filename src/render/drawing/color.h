/* Colours of pictures: the palette and the colour maps of fields.
 *
 * The palette keeps to hues that red-green blind readers tell apart and to lightness steps
 * that survive a black-and-white copier; nothing is ever told by colour alone.
 */
#pragma once

#include <stdint.h>

typedef struct QnColor {
  uint8_t r, g, b, a; /* sRGB, straight alpha */
} QnColor;

static inline QnColor
qn_rgb (uint32_t hex)
{
  return (QnColor){ (uint8_t) (hex >> 16), (uint8_t) (hex >> 8), (uint8_t) hex, 255 };
}

/* Purpose of a colour; the palette has colours and greys. */
typedef enum {
  QN_INK_LINE,  /* outlines, text, axes */
  QN_INK_FAINT, /* ghost outlines, grid lines, secondary text */
  QN_INK_BLOCK, /* free blocks */
  QN_INK_SOIL,
  QN_INK_SUPPORT, /* supported blocks */
  QN_INK_FACE,    /* contact faces */
  QN_INK_PAIR,    /* contact pairs */
  QN_INK_OPEN,    /* open joints */
  QN_INK_SLIDE,   /* sliding joints */
  QN_INK_HINGE,   /* rim of hinges */
  QN_INK_FORCE,   /* contact forces */
  QN_INK_THRUST,  /* line of thrust */
  QN_INK_BAR,     /* reinforcing bars */
  QN_INK_DEAD_LOAD,
  QN_INK_LIVE_LOAD,
  QN_INK_GROUND, /* the paper */
  QN_INK_SELECTION,
  QN_INK_COUNT
} QnInk;

/* The ink in colour, or its grey where `monochrome` is set. */
QnColor qn_ink (QnInk ink, int monochrome);

/* Fill of the index-th material; the first is QN_INK_BLOCK. Repeats after a few. */
QnColor qn_material_color (int index, int monochrome);

/* Stroke of the index-th curve of a plot. */
QnColor qn_series_color (int index, int monochrome);

/* A colour map from dark to light for 0 <= t <= 1 (clamped; not-a-number gives grey).
 *
 * Perceptually uniform by construction: a path in the OKLab space (Ottosson 2020) along the
 * blue-yellow axis, which colour-blind readers keep, with lightness linear in t. */
QnColor qn_map_sequential (double t, int monochrome);

/* A map for signed values, -1 <= t <= 1: blue, near white at 0, orange. */
QnColor qn_map_diverging (double t, int monochrome);

/* `color` with its opacity multiplied by alpha, 0 .. 1. */
QnColor qn_color_fade (QnColor color, double alpha);
