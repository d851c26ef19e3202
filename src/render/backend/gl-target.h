/* A framebuffer to draw into and to read from, kept from picture to picture. */
#pragma once

#include "render/backend/gl-api.h"

typedef struct QnGlTarget {
  const QnGl *gl; /* NULL: there is nothing yet */
  GLuint framebuffer, renderbuffer;
  int width, height;
} QnGlTarget;

/* Makes a framebuffer of this size unless it is there; false where the driver cannot. */
bool qn_gl_target_prepare (QnGlTarget *target, const QnGl *gl, int width, int height);

void qn_gl_target_clear (QnGlTarget *target);

struct QnGlRenderer;

/* The target that a renderer keeps. */
QnGlTarget *qn_gl_renderer_target (struct QnGlRenderer *renderer);
