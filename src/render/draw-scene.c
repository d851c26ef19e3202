#include "render/draw-scene.h"

#include "render/draw-cairo.h"

bool
qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
               const QnPage *page, GError **error)
{
  (void) error;
  qn_draw_cairo (scene, camera, QN_LAYERS_ALL, page->antialias, cr, NULL);
  return true;
}
