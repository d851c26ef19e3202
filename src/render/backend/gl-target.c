#include "render/backend/gl-target.h"

#include <stddef.h>

bool
qn_gl_target_prepare (QnGlTarget *target, const QnGl *gl, int width, int height)
{
  if (target->gl == gl && target->width == width && target->height == height)
    return true;
  qn_gl_target_clear (target);
  *target = (QnGlTarget){ .gl = gl, .width = width, .height = height };
  gl->GenFramebuffers (1, &target->framebuffer);
  gl->GenRenderbuffers (1, &target->renderbuffer);
  gl->BindRenderbuffer (GL_RENDERBUFFER, target->renderbuffer);
  gl->RenderbufferStorage (GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl->BindFramebuffer (GL_FRAMEBUFFER, target->framebuffer);
  gl->FramebufferRenderbuffer (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               target->renderbuffer);
  bool complete = gl->CheckFramebufferStatus (GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  if (!complete)
    qn_gl_target_clear (target);
  return complete;
}

void
qn_gl_target_clear (QnGlTarget *target)
{
  if (target->gl != NULL) {
    target->gl->BindFramebuffer (GL_FRAMEBUFFER, 0);
    target->gl->DeleteFramebuffers (1, &target->framebuffer);
    target->gl->DeleteRenderbuffers (1, &target->renderbuffer);
  }
  *target = (QnGlTarget){ 0 };
}
