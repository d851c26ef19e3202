/* The Cairo back end: walks a scene and draws it. */
#pragma once

#include "render/drawing/scene.h"

/* Which layers to draw: a bit for each. */
#define QN_LAYERS_ALL ((1u << QN_LAYER_COUNT) - 1)
/* Photos and text are drawn by Cairo on every back end. */
#define QN_LAYERS_CAIRO_BELOW (1u << QN_LAYER_UNDERLAY)
#define QN_LAYERS_CAIRO_ABOVE (1u << QN_LAYER_LABELS)

/* Draws the visible commands of the layers in the set, clipped to the camera's viewport. */
void qn_draw_cairo (const QnScene *scene, const QnCamera *camera, unsigned layers,
                    cairo_t *cr);

/* Draws one marker of `size` px at a place of the page. `angle` is counter-clockwise on the page; `unit`
 * px are a point. */
void qn_draw_cairo_marker (cairo_t *cr, QnMarker marker, double x, double y, double size,
                           double angle, bool mirrored, double unit, QnColor color);
