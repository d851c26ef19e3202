#include "render/backend/draw-scene.h"

#include "render/backend/draw-cairo.h"
#include "render/backend/gl-painter.h"

bool
qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
               const QnPage *page, GError **error)
{
  if (page->painter == NULL) {
    qn_draw_cairo (scene, camera, QN_LAYERS_ALL, page->antialias, cr, NULL);
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
    qn_gl_painter_draw (page->painter, scene, &snapped, page->antialias, error);
  if (image == NULL)
    return false;
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_BELOW, page->antialias, cr, NULL);
  cairo_save (cr);
  cairo_set_source_surface (cr, image, snapped.x, snapped.y);
  cairo_pattern_set_filter (cairo_get_source (cr), CAIRO_FILTER_NEAREST);
  cairo_rectangle (cr, snapped.x, snapped.y, snapped.width, snapped.height);
  cairo_fill (cr);
  cairo_restore (cr);
  cairo_surface_destroy (image);
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_ABOVE, page->antialias, cr, NULL);
  return true;
}
