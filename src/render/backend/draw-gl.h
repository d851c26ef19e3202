/* The OpenGL 3.3 back end: draws a scene but its photos and text, which are Cairo's on every
 * back end. All calls need the context current in which the renderer was made. */
#pragma once

#include "render/backend/draw-cairo.h"
#include "render/backend/gl-api.h"
#include "render/drawing/scene.h"

typedef struct QnGlRenderer QnGlRenderer;

/* Compiles what is needed; `gl` must outlive the renderer. NULL with an error (UNAVAILABLE). */
QnGlRenderer *qn_gl_renderer_new (const QnGl *gl, GError **error);
void qn_gl_renderer_free (QnGlRenderer *renderer);

/* Draws into the bound framebuffer of this height in px (GL counts rows from below), over what
 * is there, with premultiplied alpha. The scene's triangles are uploaded when its revision is
 * another than last time. */
void qn_gl_renderer_draw (QnGlRenderer *renderer, const QnScene *scene,
                          const QnCamera *camera, int framebuffer_height);

/* Draws the camera's viewport into a new image of its size with a transparent ground. NULL with
 * an error. */
cairo_surface_t *qn_gl_renderer_draw_image (QnGlRenderer *renderer, const QnScene *scene,
                                            const QnCamera *camera, GError **error);
