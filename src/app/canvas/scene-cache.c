#include "app/canvas/scene-cache.h"

#include "core/base/integer.h"
#include "render/backend/draw-cairo.h"

/* Part of the viewport that the picture reaches beyond it on every side. */
#define RIM 0.4

void
qn_scene_cache_clear (QnSceneCache *cache)
{
  g_clear_pointer (&cache->surface, cairo_surface_destroy);
  cache->revision = 0;
}

static void
redraw (QnSceneCache *cache, const QnScene *scene, const QnCamera *camera, int factor)
{
  qn_scene_cache_clear (cache);
  cache->camera = *camera;
  cache->camera.width = ceil (camera->width * (1.0 + 2.0 * RIM));
  cache->camera.height = ceil (camera->height * (1.0 + 2.0 * RIM));
  cache->revision = scene->revision;
  cache->factor = factor;
  cache->surface = cairo_image_surface_create (
    CAIRO_FORMAT_ARGB32,
    (int) qn_to_integer (cache->camera.width, 0, G_MAXINT16) * factor,
    (int) qn_to_integer (cache->camera.height, 0, G_MAXINT16) * factor);
  cairo_surface_set_device_scale (cache->surface, factor, factor);
  cairo_t *cr = cairo_create (cache->surface);
  qn_draw_cairo (scene, &cache->camera, QN_LAYERS_ALL, cr);
  cairo_destroy (cr);
}

void
qn_scene_cache_draw (QnSceneCache *cache, const QnScene *scene, const QnCamera *camera,
                     bool moving, int factor, cairo_t *cr)
{
  if (scene->commands->len < QN_SCENE_CACHE_LEAST) {
    qn_scene_cache_clear (cache);
    qn_draw_cairo (scene, camera, QN_LAYERS_ALL, cr);
    return;
  }
  bool same_place = cache->camera.center.x == camera->center.x
                    && cache->camera.center.y == camera->center.y
                    && cache->camera.scale == camera->scale
                    && cache->camera.width == ceil (camera->width * (1.0 + 2.0 * RIM));
  if (cache->surface == NULL || cache->revision != scene->revision
      || cache->factor != factor || (!same_place && !moving))
    redraw (cache, scene, camera, factor);

  double zoom = camera->scale / cache->camera.scale;
  QnVec2 middle = qn_camera_to_screen (camera, cache->camera.center);
  cairo_save (cr);
  cairo_translate (cr, middle.x, middle.y);
  cairo_scale (cr, zoom, zoom);
  cairo_set_source_surface (cr, cache->surface, -0.5 * cache->camera.width,
                            -0.5 * cache->camera.height);
  cairo_pattern_set_filter (cairo_get_source (cr), CAIRO_FILTER_BILINEAR);
  cairo_paint (cr);
  cairo_restore (cr);
}
