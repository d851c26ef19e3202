/* OpenGL without a display: a context with a renderer, made once for all pictures of a page or
 * an animation. It becomes the current context of its thread. */
#pragma once

#include "render/drawing/scene.h"

typedef struct QnGlPainter QnGlPainter;

/* NULL with an error (UNAVAILABLE). */
QnGlPainter *qn_gl_painter_new (GError **error);
void qn_gl_painter_free (QnGlPainter *painter);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnGlPainter, qn_gl_painter_free)

/* Draws the camera's viewport, photos and text left out, into a new image of its size with a
 * transparent ground. NULL with an error. */
cairo_surface_t *qn_gl_painter_draw (QnGlPainter *painter, const QnScene *scene,
                                     const QnCamera *camera, bool antialias,
                                     GError **error);

/* How many painters this process has made: contexts are expensive. */
unsigned qn_gl_painter_count (void);
