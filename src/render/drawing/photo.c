#include "render/drawing/photo.h"

#include "render/drawing/paint.h"
#include "render/drawing/render-error.h"

#include <gdk-pixbuf/gdk-pixbuf.h>
#include <glib/gi18n-lib.h>

/* One row from straight RGB or RGBA to Cairo's premultiplied native words. */
static void
convert_row (const guint8 *in, int width, int channels, guint32 *out)
{
  for (int x = 0; x < width; x++, in += channels) {
    guint32 a = channels == 4 ? in[3] : 255, c[3];
    for (int k = 0; k < 3; k++)
      c[k] = (in[k] * a + 127) / 255;
    out[x] = a << 24 | c[0] << 16 | c[1] << 8 | c[2];
  }
}

cairo_surface_t *
qn_photo_load (const char *path, GError **error)
{
  g_autoptr (GError) cause = NULL;
  int across, up;
  if (gdk_pixbuf_get_file_info (path, &across, &up) != NULL
      && (gint64) across * up > QN_PHOTO_MOST_PIXELS) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: the picture has %d x %d pixels, more than %d million in all"),
                 path, across, up, QN_PHOTO_MOST_PIXELS / 1000000);
    return NULL;
  }
  g_autoptr (GdkPixbuf) raw = gdk_pixbuf_new_from_file (path, &cause);
  if (raw == NULL) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: cannot be read: %s"), path, cause->message);
    return NULL;
  }
  g_autoptr (GdkPixbuf) photo = gdk_pixbuf_apply_embedded_orientation (raw);
  g_clear_object (&raw);
  int width = gdk_pixbuf_get_width (photo), height = gdk_pixbuf_get_height (photo);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  if (cairo_surface_status (image) != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy (image);
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: the picture is too large"), path);
    return NULL;
  }
  const guint8 *in = gdk_pixbuf_read_pixels (photo);
  for (int y = 0; y < height; y++)
    convert_row (in + (gsize) y * gdk_pixbuf_get_rowstride (photo), width,
                 gdk_pixbuf_get_n_channels (photo), qn_image_row (image, y));
  cairo_surface_mark_dirty (image);
  return image;
}
