/* OSMesa: Mesa's software renderer drawing into memory. Removed from Mesa 25.1. It brings LLVM
 * with it, which takes longer to load than all else that Quoin links: it is loaded when it is
 * asked for, and then kept. */
#include "render/backend/offscreen.h"

#ifdef QN_HAVE_OSMESA

#include <GL/osmesa.h>
#include <gmodule.h>

/* The functions of the library that are used here. */
static struct {
  __typeof__ (OSMesaCreateContextAttribs) *create_context;
  __typeof__ (OSMesaDestroyContext) *destroy_context;
  __typeof__ (OSMesaMakeCurrent) *make_current;
  __typeof__ (OSMesaGetProcAddress) *get_address;
} osmesa;

/* Whether the library and its functions are there. */
static gboolean
load_library (void)
{
  static gsize result = 0; /* 1 there, 2 missing */
  if (g_once_init_enter (&result)) {
    GModule *library =
      g_module_open ("libOSMesa.so.8", G_MODULE_BIND_LAZY | G_MODULE_BIND_LOCAL);
    gboolean found =
      library != NULL
      && g_module_symbol (library, "OSMesaCreateContextAttribs",
                          (gpointer *) &osmesa.create_context)
      && g_module_symbol (library, "OSMesaDestroyContext",
                          (gpointer *) &osmesa.destroy_context)
      && g_module_symbol (library, "OSMesaMakeCurrent", (gpointer *) &osmesa.make_current)
      && g_module_symbol (library, "OSMesaGetProcAddress",
                          (gpointer *) &osmesa.get_address);
    g_once_init_leave (&result, found ? 1 : 2);
  }
  return result == 1;
}

static QnGlAddress
get_osmesa_address (const char *name)
{
  return (QnGlAddress) osmesa.get_address (name);
}

static void
release_osmesa (void *context)
{
  osmesa.destroy_context (context);
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
  /* A context needs a buffer; pictures are drawn into framebuffers. */
  static guint8 pixels[4];
  if (!load_library ())
    return NULL;
  OSMesaContext context = osmesa.create_context (attributes, NULL);
  if (context == NULL)
    return NULL;
  QnOffscreen *self = g_new0 (QnOffscreen, 1);
  *self =
    (QnOffscreen){ .name = "OSMesa", .context = context, .release = release_osmesa };
  if (!osmesa.make_current (context, pixels, GL_UNSIGNED_BYTE, 1, 1)
      || !qn_gl_load (&self->gl, get_osmesa_address))
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
