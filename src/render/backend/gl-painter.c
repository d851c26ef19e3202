#include "render/backend/gl-painter.h"

#include "render/backend/draw-gl.h"
#include "render/backend/offscreen.h"

struct QnGlPainter {
  QnOffscreen *offscreen;
  QnGlRenderer *renderer;
};

static gint painter_count;

QnGlPainter *
qn_gl_painter_new (GError **error)
{
  QnOffscreen *offscreen = qn_offscreen_new (error);
  if (offscreen == NULL)
    return NULL;
  QnGlPainter *painter = g_new0 (QnGlPainter, 1);
  painter->offscreen = offscreen;
  painter->renderer = qn_gl_renderer_new (&offscreen->gl, error);
  if (painter->renderer == NULL)
    g_clear_pointer (&painter, qn_gl_painter_free);
  else
    g_atomic_int_inc (&painter_count);
  return painter;
}

void
qn_gl_painter_free (QnGlPainter *painter)
{
  if (painter == NULL)
    return;
  qn_gl_renderer_free (painter->renderer);
  qn_offscreen_free (painter->offscreen);
  g_free (painter);
}

bool
qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
               const QnPage *page, GError **error)
{
  if (page->painter == NULL) {
    qn_draw_cairo (scene, camera, QN_LAYERS_ALL, cr, NULL);
    return true;
  }

  /* The viewport on whole pixels, so that the image is laid down without being resampled. */
  QnCamera snapped = *camera;
  snapped.x = floor (camera->x);
  snapped.y = floor (camera->y);
  snapped.width = ceil (camera->x + camera->width) - snapped.x;
  snapped.height = ceil (camera->y + camera->height) - snapped.y;
  QnVec2 middle = { snapped.x + 0.5 * snapped.width, snapped.y + 0.5 * snapped.height };
  snapped.center = qn_camera_to_model (camera, middle);
  cairo_surface_t *image =
    qn_gl_renderer_draw_image (page->painter->renderer, scene, &snapped, NULL, error);
  if (image == NULL)
    return false;
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_BELOW, cr, NULL);
  cairo_save (cr);
  cairo_set_source_surface (cr, image, snapped.x, snapped.y);
  cairo_pattern_set_filter (cairo_get_source (cr), CAIRO_FILTER_NEAREST);
  cairo_rectangle (cr, snapped.x, snapped.y, snapped.width, snapped.height);
  cairo_fill (cr);
  cairo_restore (cr);
  cairo_surface_destroy (image);
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_ABOVE, cr, NULL);
  return true;
}

unsigned
qn_gl_painter_count (void)
{
  return (unsigned) g_atomic_int_get (&painter_count);
}
