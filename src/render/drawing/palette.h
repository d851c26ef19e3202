/* A palette of at most 256 colours for GIF, by median cut (Heckbert 1982). */
#pragma once

#include <cairo.h>
#include <stdint.h>

#define QN_PALETTE_MAX 256

typedef struct QnPaletteCell {
  uint64_t count, sums[3];
} QnPaletteCell;

typedef struct QnPalette {
  int count;
  uint8_t colors[QN_PALETTE_MAX][3];
  QnPaletteCell *cells; /* of every colour of five bits a channel: what was looked at */
  int16_t *nearest;     /* index for the same, -1: not yet asked */
} QnPalette;

/* Looks at ARGB32 images, then chooses colours for them. Large areas keep their exact colours. */
QnPalette *qn_palette_new (void);
void qn_palette_free (QnPalette *palette);
void qn_palette_look (QnPalette *palette, cairo_surface_t *image);
void qn_palette_choose (QnPalette *palette);

/* Index of the nearest colour to an ARGB pixel. */
uint8_t qn_palette_find (QnPalette *palette, uint32_t pixel);
