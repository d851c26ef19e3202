#include "app/widgets/preview.h"

#include "render/backend/draw-cairo.h"
#include "render/scene/scene-build.h"

#define MARGIN_PX 12.0

void
qn_preview_draw (const QnModel *model, gboolean loads, cairo_t *cr, int width, int height,
                 QnCamera *camera)
{
  QnCamera fitted = { .width = width, .height = height, .scale = 1.0, .unit = 0.8 };
  QnContacts contacts = { 0 };
  QnViewOptions options;
  cairo_set_source_rgb (cr, 1.0, 1.0, 1.0);
  cairo_paint (cr);
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.loads = loads;
  options.dimensions = false;
  QnScene *scene = qn_scene_build (model, &contacts, NULL, &options, NULL);
  if (scene != NULL) {
    qn_camera_fit (&fitted, scene->box, MARGIN_PX);
    qn_draw_cairo (scene, &fitted, QN_LAYERS_ALL, cr);
    qn_scene_free (scene);
  }
  if (camera != NULL)
    *camera = fitted;
}
