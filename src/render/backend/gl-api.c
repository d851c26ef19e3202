#include "render/backend/gl-api.h"

#include <string.h>

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

bool
qn_gl_is_software (const QnGl *gl)
{
  static const char *const names[] = { "llvmpipe", "softpipe", "swrast", "SWR",
                                       "Software" };
  const char *renderer = (const char *) gl->GetString (GL_RENDERER);
  for (size_t i = 0; renderer != NULL && i < sizeof names / sizeof *names; i++) {
    if (strstr (renderer, names[i]) != NULL)
      return true;
  }
  return false;
}
