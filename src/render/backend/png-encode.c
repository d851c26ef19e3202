#include "render/backend/png-encode.h"

#include "core/base/integer.h"
#include "render/backend/output.h"
#include "render/drawing/paint.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static void
append_bytes (png_structp png, png_bytep data, png_size_t length)
{
  g_byte_array_append (png_get_io_ptr (png), data, (guint) length);
}

static void
flush_nothing (png_structp png)
{
  (void) png;
}

/* Errors are reported by the return value, warnings do not concern a writer. */
static void
fail_quietly (png_structp png, png_const_charp message)
{
  (void) message;
  png_longjmp (png, 1);
}

static void
ignore_warning (png_structp png, png_const_charp message)
{
  (void) png;
  (void) message;
}

static bool
is_opaque (cairo_surface_t *surface)
{
  int width = cairo_image_surface_get_width (surface);
  int height = cairo_image_surface_get_height (surface);
  for (int y = 0; y < height; y++) {
    const uint32_t *row = qn_image_row (surface, y);
    for (int x = 0; x < width; x++)
      if (row[x] >> 24 != 255)
        return false;
  }
  return true;
}

/* One row from premultiplied ARGB to straight RGB or RGBA. */
static void
convert_row (const uint32_t *row, int width, bool opaque, unsigned char *out)
{
  for (int x = 0; x < width; x++) {
    uint32_t p = row[x], a = p >> 24;
    uint32_t c[3] = { p >> 16 & 255, p >> 8 & 255, p & 255 };
    for (int k = 0; k < 3; k++)
      *out++ = (unsigned char) (a == 0 ? 0 : a == 255 ? c[k] : (c[k] * 255 + a / 2) / a);
    if (!opaque)
      *out++ = (unsigned char) a;
  }
}

/* The part between setjmp and the end; false when libpng jumped. */
static bool
write_image (png_structp png, png_infop info, cairo_surface_t *surface, double dpi,
             const QnPngText *texts, size_t text_count, unsigned char *row)
{
  if (setjmp (png_jmpbuf (png)))
    return false;

  int width = cairo_image_surface_get_width (surface);
  int height = cairo_image_surface_get_height (surface);
  bool opaque = is_opaque (surface);
  png_set_IHDR (png, info, (png_uint_32) width, (png_uint_32) height, 8,
                opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
                PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                PNG_FILTER_TYPE_DEFAULT);
  if (dpi > 0) {
    png_uint_32 per_metre =
      (png_uint_32) qn_to_integer (round (dpi / 0.0254), 1, G_MAXINT32);
    png_set_pHYs (png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  for (size_t i = 0; i < text_count; i++) {
    /* More programs read the older kind of chunk, which holds no UTF-8. */
    bool plain = g_str_is_ascii (texts[i].text);
    png_text chunk = { .compression =
                         plain ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE };
    chunk.key = (png_charp) texts[i].key;
    chunk.text = (png_charp) texts[i].text;
    if (plain)
      chunk.text_length = strlen (texts[i].text);
    else
      chunk.itxt_length = strlen (texts[i].text);
    png_set_text (png, info, &chunk, 1);
  }
  png_write_info (png, info);
  for (int y = 0; y < height; y++) {
    convert_row (qn_image_row (surface, y), width, opaque, row);
    png_write_row (png, row);
  }
  png_write_end (png, NULL);
  return true;
}

GBytes *
qn_png_encode (cairo_surface_t *surface, double dpi, const QnPngText *texts,
               size_t text_count, GError **error)
{
  g_autoptr (GByteArray) bytes = g_byte_array_new ();
  png_infop info = NULL;
  png_structp png =
    png_create_write_struct (PNG_LIBPNG_VER_STRING, NULL, fail_quietly, ignore_warning);
  if (png != NULL)
    info = png_create_info_struct (png);
  g_autofree unsigned char *row =
    g_try_malloc ((size_t) cairo_image_surface_get_width (surface) * 4);
  cairo_surface_flush (surface);

  bool done = false;
  if (info != NULL && row != NULL) {
    png_set_write_fn (png, bytes, append_bytes, flush_nothing);
    done = write_image (png, info, surface, dpi, texts, text_count, row);
  }
  png_destroy_write_struct (&png, &info);
  if (!done) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                         _ ("the picture could not be encoded as PNG"));
    return NULL;
  }
  return g_byte_array_free_to_bytes (g_steal_pointer (&bytes));
}
