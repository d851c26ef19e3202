/* The camera: how model coordinates (m, y up) become picture coordinates (px, y down). */
#ifndef QN_RENDER_CAMERA_H
#define QN_RENDER_CAMERA_H

#include "core/base/vec2.h"

#include <stdbool.h>

/* An axis-aligned box; empty when min > max. */
typedef struct QnBox {
  QnVec2 min, max;
} QnBox;

#define QN_BOX_EMPTY                                                                     \
  ((QnBox){ { (double) INFINITY, (double) INFINITY },                                    \
            { -(double) INFINITY, -(double) INFINITY } })

static inline bool
qn_box_is_empty (QnBox box)
{
  return !(box.min.x <= box.max.x && box.min.y <= box.max.y);
}

static inline void
qn_box_add_point (QnBox *box, QnVec2 p)
{
  box->min.x = fmin (box->min.x, p.x);
  box->min.y = fmin (box->min.y, p.y);
  box->max.x = fmax (box->max.x, p.x);
  box->max.y = fmax (box->max.y, p.y);
}

static inline void
qn_box_add_box (QnBox *box, QnBox other)
{
  if (qn_box_is_empty (other))
    return;
  qn_box_add_point (box, other.min);
  qn_box_add_point (box, other.max);
}

static inline double
qn_box_diagonal (QnBox box)
{
  return qn_box_is_empty (box) ? 0 : qn_vec2_length (qn_vec2_sub (box.max, box.min));
}

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

#endif
