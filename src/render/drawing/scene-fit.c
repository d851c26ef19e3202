#include "render/drawing/scene-fit.h"

#include "render/drawing/text.h"

#include <string.h>

/* A label of a block or joint is taken to reach no farther than so many times its size: where it is
 * farther from the edge it need not be measured. */
#define LONGEST_LABEL 12

/* How far markers, lines and labels reach beyond the box of the places: left, top, right and
 * bottom, px. */
static void
measure_overhang (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
                  double reach[4])
{
  QnVec2 low = qn_camera_to_screen (camera, scene->box.min);
  QnVec2 high = qn_camera_to_screen (camera, scene->box.max);
  memset (reach, 0, 4 * sizeof *reach);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *c = qn_scene_command (scene, i);
    double left = 0.6 * c->size * camera->unit, right = left, up = left, down = left;
    if (c->kind == QN_COMMAND_FILL || c->kind == QN_COMMAND_IMAGE)
      continue;
    if (!qn_command_has_size (c, camera))
      continue;
    QnVec2 a = qn_camera_to_screen (camera, c->box.min);
    QnVec2 b = qn_camera_to_screen (camera, c->box.max);
    if (c->kind == QN_COMMAND_TEXT) {
      double w, h, most = LONGEST_LABEL * c->size * camera->unit;
      if (c->extent > 0 && a.x - most > low.x && b.x + most < high.x && a.y + most < low.y
          && b.y - most > high.y)
        continue;
      qn_text_measure (cr, &(QnTextStyle){ .size = c->size * camera->unit }, c->text, &w,
                       &h);
      bool upright = fabs (sin (c->angle)) > 0.5;
      left = upright ? h * (1 - c->align_y) : w * c->align_x;
      right = upright ? h * c->align_y : w * (1 - c->align_x);
      up = upright ? w * (1 - c->align_x) : h * (1 - c->align_y);
      down = upright ? w * c->align_x : h * c->align_y;
    }
    reach[0] = fmax (reach[0], low.x - (a.x - left));
    reach[1] = fmax (reach[1], high.y - (b.y - up));
    reach[2] = fmax (reach[2], b.x + right - high.x);
    reach[3] = fmax (reach[3], a.y + down - low.y);
  }
}

void
qn_scene_fit (QnCamera *camera, const QnScene *scene, cairo_t *cr, double scale)
{
  double reach[4] = { 0, 0, 0, 0 };
  for (int pass = 0; pass < 4; pass++) {
    QnCamera inner = *camera;
    inner.width = fmax (camera->width - reach[0] - reach[2], 0.1 * camera->width);
    inner.height = fmax (camera->height - reach[1] - reach[3], 0.1 * camera->height);
    qn_camera_fit (&inner, scene->box, 0);
    if (scale > 0)
      inner.scale = scale;
    camera->scale = inner.scale;
    camera->center = inner.center;
    camera->center.x += 0.5 * (reach[2] - reach[0]) / camera->scale;
    camera->center.y += 0.5 * (reach[1] - reach[3]) / camera->scale;
    measure_overhang (scene, camera, cr, reach);
  }
}
