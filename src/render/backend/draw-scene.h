/* Drawing a scene onto a page by the back end that the page has. */
#pragma once

#include "render/backend/output.h"
#include "render/drawing/scene.h"

/* With a painter the picture is drawn off screen, read back and laid onto the page;
 * labels are always Cairo's. */
bool qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
                    const QnPage *page, GError **error);
