/* OpenGL without a display: a context with a renderer, made once for all pictures of a page or
 * an animation. It becomes the current context of its thread. */
#pragma once

#include "render/backend/output.h"
#include "render/drawing/scene.h"

typedef struct QnGlPainter QnGlPainter;

/* NULL with an error (UNAVAILABLE). */
QnGlPainter *qn_gl_painter_new (GError **error);
void qn_gl_painter_free (QnGlPainter *painter);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnGlPainter, qn_gl_painter_free)

/* Draws a scene onto a page. With a painter the picture is drawn off screen, read back and laid onto the page;
 * labels are always Cairo's. */
bool qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
                    const QnPage *page, GError **error);

/* How many painters this process has made: contexts are expensive. */
unsigned qn_gl_painter_count (void);
