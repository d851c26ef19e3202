/* The scene of a large drawing by OpenGL, between two layers of Cairo: a GtkGLArea of the
 * canvas that stays hidden, without any context, while Cairo is quick enough. Where OpenGL 3.3
 * is not to be had the area hides for good and Cairo draws everything. */
#pragma once

#include "render/backend/draw-gl.h"

#include <gtk/gtk.h>

typedef struct QnGlLayer {
  GtkWidget *area; /* visible only while OpenGL draws */
  QnGl gl;
  QnGlRenderer *renderer; /* of the area's context */
  const QnScene *scene;   /* of the frame being drawn */
  QnCamera camera;
  uint64_t revision; /* last drawn, with camera */
  guint wake;        /* shows or hides the area outside of any frame */
  gboolean wanted;
  gboolean failed;
  gboolean software; /* OpenGL turned out to be drawn by the processor */
  unsigned frames;   /* drawn so far */
} QnGlLayer;

/* Values of the setting "engine". */
typedef enum { QN_ENGINE_AUTOMATIC, QN_ENGINE_CAIRO, QN_ENGINE_OPENGL } QnEngine;

/* Of a layer that has its area, which gets a context once it is asked to draw. */
void qn_gl_layer_init (QnGlLayer *self);

/* Says what the next frame holds; true where OpenGL draws it. Otherwise Cairo has to, be it
 * for this one frame, while the context is being made. */
gboolean qn_gl_layer_prepare (QnGlLayer *self, const QnScene *scene,
                              const QnCamera *camera);
