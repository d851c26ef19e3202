/* A pair of framebuffers to draw into and to read from, kept from picture to picture. */
#ifndef QN_RENDER_GL_TARGET_H
#define QN_RENDER_GL_TARGET_H

#include "render/gl-api.h"

typedef struct QnGlTarget {
  const QnGl *gl;                           /* NULL: there is nothing yet */
  GLuint framebuffers[2], renderbuffers[2]; /* drawn into; read from */
  int width, height, samples;
} QnGlTarget;

/* Makes the framebuffers of this size unless they are there; false where the driver cannot. */
bool qn_gl_target_prepare (QnGlTarget *target, const QnGl *gl, int width, int height,
                           int samples);

void qn_gl_target_clear (QnGlTarget *target);

struct QnGlRenderer;

/* The target that a renderer keeps. */
QnGlTarget *qn_gl_renderer_target (struct QnGlRenderer *renderer);

#endif
