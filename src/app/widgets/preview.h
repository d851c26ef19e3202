/* Small pictures of models. */
#pragma once

#include "core/model/model.h"
#include "render/drawing/camera.h"

#include <cairo.h>
#include <glib.h>

/* Draws a model on white, with its loads where asked for. `camera` (out, nullable): where everything is. */
void qn_preview_draw (const QnModel *model, gboolean loads, cairo_t *cr, int width,
                      int height, QnCamera *camera);
