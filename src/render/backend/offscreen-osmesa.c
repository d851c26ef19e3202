/* OSMesa: Mesa's software renderer drawing into memory. Removed from Mesa 25.1. */
#include "render/backend/offscreen.h"

#ifdef QN_HAVE_OSMESA

#include <GL/osmesa.h>

typedef struct State {
  OSMesaContext context;
  guint8 pixels[4]; /* a context needs a buffer; pictures are drawn into framebuffers */
} State;

static QnGlAddress
get_address (const char *name)
{
  return (QnGlAddress) OSMesaGetProcAddress (name);
}

static void
release (QnOffscreen *self)
{
  State *state = self->state;
  OSMesaDestroyContext (state->context);
  g_free (state);
}

QnOffscreen *
qn_offscreen_new_osmesa (void)
{
  static const int attributes[] = { OSMESA_FORMAT,
                                    OSMESA_RGBA,
                                    OSMESA_PROFILE,
                                    OSMESA_CORE_PROFILE,
                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                    3,
                                    OSMESA_CONTEXT_MINOR_VERSION,
                                    3,
                                    0 };
  OSMesaContext context = OSMesaCreateContextAttribs (attributes, NULL);
  if (context == NULL)
    return NULL;
  State *state = g_new0 (State, 1);
  state->context = context;
  QnOffscreen *self = g_new0 (QnOffscreen, 1);
  *self = (QnOffscreen){ .name = "OSMesa", .state = state, .release = release };
  if (!OSMesaMakeCurrent (context, state->pixels, GL_UNSIGNED_BYTE, 1, 1)
      || !qn_gl_load (&self->gl, get_address))
    g_clear_pointer (&self, qn_offscreen_free);
  return self;
}

#else

QnOffscreen *
qn_offscreen_new_osmesa (void)
{
  return NULL;
}

#endif
