/* The scene of a large drawing by OpenGL, between two layers of Cairo: a GtkGLArea of the
 * canvas that stays hidden, without any context, while Cairo is quick enough. Where OpenGL 3.3
 * is not to be had the area hides for good and Cairo draws everything. */
#pragma once

#include "render/backend/gl-api.h"
#include "render/drawing/scene.h"

#include <gtk/gtk.h>

typedef struct QnGlLayer QnGlLayer;

/* Values of the setting "engine". */
typedef enum { QN_ENGINE_AUTOMATIC, QN_ENGINE_CAIRO, QN_ENGINE_OPENGL } QnEngine;

/* Puts its area into the canvas, without a context until it is asked to draw; freeing takes it out. */
QnGlLayer *qn_gl_layer_new (GtkWidget *canvas);
void qn_gl_layer_free (QnGlLayer *self);
GtkWidget *qn_gl_layer_get_area (QnGlLayer *self);

/* Says what the next frame holds; true where OpenGL draws it. Otherwise Cairo has to, be it
 * for this one frame, while the context is being made. */
gboolean qn_gl_layer_prepare (QnGlLayer *self, const QnScene *scene,
                              const QnCamera *camera);

/* Whether OpenGL turned out to be drawn by the processor. */
gboolean qn_gl_layer_is_software (QnGlLayer *self);

/* How many scenes and frames this layer has drawn, for tests and timings. */
unsigned qn_gl_layer_get_uploads (QnGlLayer *self);
unsigned qn_gl_layer_get_frames (QnGlLayer *self);
