/* PNG files with text chunks and resolution, which Cairo's own writer cannot carry. */
#pragma once

#include <cairo.h>
#include <glib.h>

typedef struct QnPngText {
  const char *key;  /* "Title", "Software", … or a private one, Latin-1 */
  const char *text; /* UTF-8 */
} QnPngText;

/* Encodes an ARGB32 image surface. `dpi` <= 0: no resolution chunk. An image without any
 * transparent pixel is written without alpha. NULL with an error (FAILED). */
GBytes *qn_png_encode (cairo_surface_t *surface, double dpi, const QnPngText *texts,
                       size_t text_count, GError **error);
