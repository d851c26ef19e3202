#include "render/drawing/camera.h"

QnBox
qn_camera_visible_box (const QnCamera *camera)
{
  QnVec2 a = qn_camera_to_model (camera, qn_vec2 (camera->x, camera->y));
  QnVec2 b = qn_camera_to_model (
    camera, qn_vec2 (camera->x + camera->width, camera->y + camera->height));
  return qn_box_of_segment (a, b);
}

void
qn_camera_fit (QnCamera *camera, QnBox box, double margin)
{
  if (qn_box_is_empty (box))
    box = (QnBox){ { 0, 0 }, { 0, 0 } };
  double width = fmax (camera->width - 2 * margin, 1);
  double height = fmax (camera->height - 2 * margin, 1);
  double size_x = box.max.x - box.min.x;
  double size_y = box.max.y - box.min.y;
  if (size_x <= 0 && size_y <= 0)
    size_x = 1;

  camera->center = qn_vec2_scale (0.5, qn_vec2_add (box.min, box.max));
  camera->scale = fmin (size_x > 0 ? width / size_x : (double) INFINITY,
                        size_y > 0 ? height / size_y : (double) INFINITY);
}

void
qn_camera_zoom_at (QnCamera *camera, QnVec2 s, double factor)
{
  QnVec2 fixed = qn_camera_to_model (camera, s);
  camera->scale *= factor;
  QnVec2 moved = qn_camera_to_model (camera, s);
  camera->center = qn_vec2_add (camera->center, qn_vec2_sub (fixed, moved));
}

void
qn_camera_pan (QnCamera *camera, QnVec2 delta)
{
  camera->center.x -= delta.x / camera->scale;
  camera->center.y += delta.y / camera->scale;
}
