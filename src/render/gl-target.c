#include "render/gl-target.h"

#include <stddef.h>

bool
qn_gl_target_prepare (QnGlTarget *target, const QnGl *gl, int width, int height,
                      int samples)
{
  if (target->gl == gl && target->width == width && target->height == height
      && target->samples == samples)
    return true;
  qn_gl_target_clear (target);
  *target =
    (QnGlTarget){ .gl = gl, .width = width, .height = height, .samples = samples };
  gl->GenFramebuffers (2, target->framebuffers);
  gl->GenRenderbuffers (2, target->renderbuffers);
  bool complete = true;
  for (int i = 0; i < 2; i++) {
    gl->BindRenderbuffer (GL_RENDERBUFFER, target->renderbuffers[i]);
    gl->RenderbufferStorageMultisample (GL_RENDERBUFFER, i == 0 ? samples : 0, GL_RGBA8,
                                        width, height);
    gl->BindFramebuffer (GL_FRAMEBUFFER, target->framebuffers[i]);
    gl->FramebufferRenderbuffer (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 target->renderbuffers[i]);
    complete &= gl->CheckFramebufferStatus (GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  if (!complete)
    qn_gl_target_clear (target);
  return complete;
}

void
qn_gl_target_clear (QnGlTarget *target)
{
  if (target->gl != NULL) {
    target->gl->BindFramebuffer (GL_FRAMEBUFFER, 0);
    target->gl->DeleteFramebuffers (2, target->framebuffers);
    target->gl->DeleteRenderbuffers (2, target->renderbuffers);
  }
  *target = (QnGlTarget){ 0 };
}
