/* Colours of the palette as Cairo takes them, and the pixels of images. */
#pragma once

#include "render/drawing/color.h"

#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A row of an ARGB32 image: pixels as native words, premultiplied. */
static inline uint32_t *
qn_image_row (cairo_surface_t *image, int row)
{
  unsigned char *data = cairo_image_surface_get_data (image);
  return (uint32_t *) (void *) (data
                                + (size_t) row
                                    * (size_t) cairo_image_surface_get_stride (image));
}

/* Dashes of 4 pt with gaps of 2.5 pt, or a whole line; `unit` px are a point. */
static inline void
qn_set_dashes (cairo_t *cr, bool dashed, double unit)
{
  const double dashes[2] = { 4 * unit, 2.5 * unit };
  cairo_set_dash (cr, dashes, dashed ? 2 : 0, 0);
}

/* Sets the colour of the following drawing, its opacity multiplied by alpha, 0 .. 1. */
static inline void
qn_set_color (cairo_t *cr, QnColor color, double alpha)
{
  cairo_set_source_rgba (cr, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                         color.a / 255.0 * alpha);
}
