/* EGL without a surface: any driver, also none but software, and no window system. */
#include "render/backend/offscreen.h"

#ifdef QN_HAVE_EGL

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <string.h>

static QnGlAddress
get_address (const char *name)
{
  return (QnGlAddress) eglGetProcAddress (name);
}

static EGLDisplay
open_display (void)
{
  const char *extensions = eglQueryString (EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (extensions == NULL || strstr (extensions, "EGL_MESA_platform_surfaceless") == NULL)
    return EGL_NO_DISPLAY;
  EGLDisplay display =
    eglGetPlatformDisplay (EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (display != EGL_NO_DISPLAY && !eglInitialize (display, NULL, NULL))
    return EGL_NO_DISPLAY;
  return display;
}

/* The display is not terminated: the window of this process may be using it. */
static void
release (void *context)
{
  EGLDisplay display = open_display ();
  eglMakeCurrent (display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext (display, context);
}

static EGLContext
create_context (EGLDisplay display)
{
  static const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION,
                                       3,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       3,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                       EGL_NONE };
  const char *extensions = eglQueryString (display, EGL_EXTENSIONS);
  if (!eglBindAPI (EGL_OPENGL_API) || extensions == NULL
      || strstr (extensions, "EGL_KHR_no_config_context") == NULL
      || strstr (extensions, "EGL_KHR_surfaceless_context") == NULL)
    return EGL_NO_CONTEXT;
  return eglCreateContext (display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

QnOffscreen *
qn_offscreen_new_egl (void)
{
  EGLDisplay display = open_display ();
  EGLContext context =
    display != EGL_NO_DISPLAY ? create_context (display) : EGL_NO_CONTEXT;
  if (context == EGL_NO_CONTEXT)
    return NULL;
  QnOffscreen *self = g_new0 (QnOffscreen, 1);
  *self = (QnOffscreen){ .name = "EGL", .context = context, .release = release };
  if (!eglMakeCurrent (display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)
      || !qn_gl_load (&self->gl, get_address))
    g_clear_pointer (&self, qn_offscreen_free);
  return self;
}

bool
qn_gl_load_current (QnGl *gl)
{
  GLint major = 0, minor = 0;
  if (!qn_gl_load (gl, get_address))
    return false;
  gl->GetIntegerv (GL_MAJOR_VERSION, &major);
  gl->GetIntegerv (GL_MINOR_VERSION, &minor);
  return major * 10 + minor >= 33;
}

#else

bool
qn_gl_load_current (QnGl *gl)
{
  (void) gl;
  return false;
}

QnOffscreen *
qn_offscreen_new_egl (void)
{
  return NULL;
}

#endif
