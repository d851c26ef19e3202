/* Fitting a scene into a rectangle with everything that does not scale with it. */
#pragma once

#include "render/drawing/scene.h"

/* Centres the scene in the camera's viewport, as large as it goes without clipping markers,
 * line ends and labels; at `scale` px per m where that is > 0. The camera's viewport and unit
 * are given, its centre and scale are set. */
void qn_scene_fit (QnCamera *camera, const QnScene *scene, cairo_t *cr, double scale);
