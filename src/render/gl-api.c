#include "render/gl-api.h"

#include <stddef.h>

bool
qn_gl_load (QnGl *gl, QnGlGetAddress get_address)
{
#define QN_GL_LOAD(type, name)                                                           \
  gl->name = (type) get_address ("gl" #name);                                            \
  if (gl->name == NULL)                                                                  \
    return false;
  QN_GL_FUNCTIONS (QN_GL_LOAD)
#undef QN_GL_LOAD
  return true;
}
