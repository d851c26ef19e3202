/* Drawing into images: through a framebuffer that is read back tile by tile. */
#include "core/base/integer.h"
#include "render/backend/draw-gl.h"
#include "render/backend/gl-target.h"
#include "render/backend/output.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Larger pictures are drawn in tiles, so that no driver's limit and no great memory matters. */
#define TILE 2048

/* Copies what was drawn into the image at (left, top), upside down as GL has it. */
static void
read_back (const QnGlTarget *target, cairo_surface_t *image, int left, int top, int width,
           int height, guint8 *rows)
{
  const QnGl *gl = target->gl;
  gl->PixelStorei (GL_PACK_ALIGNMENT, 4);
  /* Cairo's ARGB32 is a native 32-bit word with alpha on top. */
  gl->ReadPixels (0, target->height - height, width, height, GL_BGRA,
                  GL_UNSIGNED_INT_8_8_8_8_REV, rows);
  int stride = cairo_image_surface_get_stride (image);
  guint8 *data = cairo_image_surface_get_data (image);
  for (int y = 0; y < height; y++)
    memcpy (data + (size_t) (top + y) * stride + (size_t) left * 4,
            rows + (size_t) (height - 1 - y) * width * 4, (size_t) width * 4);
}

/* The camera that shows one tile of another's viewport. */
static QnCamera
tile_camera (const QnCamera *whole, int left, int top, int width, int height)
{
  QnCamera tile = *whole;
  tile.x = tile.y = 0;
  tile.width = width;
  tile.height = height;
  tile.center.x += (left + 0.5 * width - 0.5 * whole->width) / whole->scale;
  tile.center.y -= (top + 0.5 * height - 0.5 * whole->height) / whole->scale;
  return tile;
}

static void
draw_tiles (QnGlRenderer *renderer, const QnGlTarget *target, const QnScene *scene,
            const QnCamera *camera, bool antialias, cairo_surface_t *image, guint8 *rows,
            QnDrawCounts *counts)
{
  const QnGl *gl = target->gl;
  int width = cairo_image_surface_get_width (image);
  int height = cairo_image_surface_get_height (image);
  for (int top = 0; top < height; top += target->height) {
    for (int left = 0; left < width; left += target->width) {
      int w = MIN (target->width, width - left), h = MIN (target->height, height - top);
      QnCamera tile = tile_camera (camera, left, top, w, h);
      gl->BindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
      gl->Disable (GL_SCISSOR_TEST);
      gl->ClearColor (0, 0, 0, 0);
      gl->Clear (GL_COLOR_BUFFER_BIT);
      qn_gl_renderer_draw (renderer, scene, &tile, target->height, antialias, counts);
      read_back (target, image, left, top, w, h, rows);
    }
  }
}

cairo_surface_t *
qn_gl_renderer_draw_image (QnGlRenderer *renderer, const QnScene *scene,
                           const QnCamera *camera, bool antialias, QnDrawCounts *counts,
                           GError **error)
{
  int width = (int) qn_to_integer (ceil (camera->width), 1, G_MAXINT16);
  int height = (int) qn_to_integer (ceil (camera->height), 1, G_MAXINT16);
  int tile_width = MIN (width, TILE), tile_height = MIN (height, TILE);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  g_autofree guint8 *rows = g_try_malloc ((gsize) tile_width * tile_height * 4);
  QnGlTarget *target = qn_gl_renderer_target (renderer);
  bool ready =
    qn_gl_target_prepare (target, qn_gl_renderer_api (renderer), tile_width, tile_height);
  if (ready && rows != NULL && cairo_surface_status (image) == CAIRO_STATUS_SUCCESS) {
    QnCamera whole = *camera;
    whole.width = width;
    whole.height = height;
    whole.center.x += 0.5 * (width - camera->width) / camera->scale;
    whole.center.y -= 0.5 * (height - camera->height) / camera->scale;
    cairo_surface_flush (image);
    draw_tiles (renderer, target, scene, &whole, antialias, image, rows, counts);
    cairo_surface_mark_dirty (image);
  } else {
    g_clear_pointer (&image, cairo_surface_destroy);
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                         _ ("the OpenGL driver cannot draw a picture of this size"));
  }
  return image;
}
