/* The camera: how model coordinates (m, y up) become picture coordinates (px, y down). */
#pragma once

#include "core/base/box.h"

typedef struct QnCamera {
  QnVec2 center;              /* m, model point in the middle of the viewport */
  double scale;               /* px per m, > 0 */
  double x, y, width, height; /* viewport, px */
  double unit; /* px per typographic point: line widths, markers and text scale with it */
} QnCamera;

static inline QnVec2
qn_camera_to_screen (const QnCamera *camera, QnVec2 p)
{
  return qn_vec2 (
    camera->x + 0.5 * camera->width + (p.x - camera->center.x) * camera->scale,
    camera->y + 0.5 * camera->height - (p.y - camera->center.y) * camera->scale);
}

static inline QnVec2
qn_camera_to_model (const QnCamera *camera, QnVec2 s)
{
  return qn_vec2 (
    camera->center.x + (s.x - camera->x - 0.5 * camera->width) / camera->scale,
    camera->center.y - (s.y - camera->y - 0.5 * camera->height) / camera->scale);
}

/* The part of the model that the viewport shows. */
QnBox qn_camera_visible_box (const QnCamera *camera);

/* Centres `box` in the viewport, as large as `margin` px on every side allow. A box without
 * extent is shown 1 m wide. */
void qn_camera_fit (QnCamera *camera, QnBox box, double margin);

/* Zooms by `factor` and keeps the model point under the screen point `s` where it is. */
void qn_camera_zoom_at (QnCamera *camera, QnVec2 s, double factor);

/* Moves the picture by `delta` px. */
void qn_camera_pan (QnCamera *camera, QnVec2 delta);
