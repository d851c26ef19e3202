/* A picture of a heavy scene: moved and scaled while the camera moves, drawn anew when it
 * rests. It reaches beyond the viewport, so that panning does not meet its rim at once. */
#pragma once

#include "render/scene/scene-build.h"

typedef struct QnSceneCache {
  cairo_surface_t *surface; /* NULL: nothing yet */
  QnCamera camera;          /* that it was drawn with */
  int factor;               /* device pixels per pixel */
  uint64_t revision;        /* of the scene */
} QnSceneCache;

/* Scenes of fewer commands are quick enough without. */
#define QN_SCENE_CACHE_LEAST 6000

/* Draws the scene; `moving`: an older picture of it will do. The picture is kept at `factor`
 * device pixels per pixel. */
void qn_scene_cache_draw (QnSceneCache *cache, const QnScene *scene,
                          const QnCamera *camera, bool moving, int factor, cairo_t *cr);

void qn_scene_cache_clear (QnSceneCache *cache);
