/* A palette of at most 256 colours for GIF, by median cut (Heckbert 1982). */
#pragma once

#include <cairo.h>
#include <stdint.h>

#define QN_PALETTE_MAX 256

typedef struct QnPalette {
  int count;
  uint8_t colors[QN_PALETTE_MAX][3];
  int16_t *nearest; /* index for every colour of five bits a channel, -1: not yet asked */
} QnPalette;

/* Chooses colours for these ARGB32 images. Large areas keep their exact colours. */
void qn_palette_init (QnPalette *palette, cairo_surface_t *const *images,
                      int image_count);
void qn_palette_clear (QnPalette *palette);

/* Index of the nearest colour to an ARGB pixel. */
uint8_t qn_palette_find (QnPalette *palette, uint32_t pixel);
