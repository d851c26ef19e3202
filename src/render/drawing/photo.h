/* Photos and scans as images that can be drawn. */
#pragma once

#include <cairo.h>
#include <glib.h>

/* Pictures of more pixels are refused before they are decoded: some hundred bytes of PNG can stand for
 * gigabytes. Decoding and turning take up to eight bytes a pixel. */
#define QN_PHOTO_MOST_PIXELS 60000000

/* Reads a PNG, JPEG, TIFF … file, turned the right way up as the camera noted. NULL with an
 * error (QN_RENDER_ERROR_FILE). */
cairo_surface_t *qn_photo_load (const char *path, GError **error);
