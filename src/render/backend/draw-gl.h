/* The OpenGL 3.3 back end: draws a scene but its photos and text, which are Cairo's on every
 * back end. All calls need the context current in which the renderer was made. */
#pragma once

#include "render/backend/draw-cairo.h"
#include "render/drawing/scene.h"

#include <GL/glcorearb.h>
#include <stdbool.h>

/* The OpenGL 3.3 functions that this program calls, as a table filled by whoever made the
 * context: no library to link, one table for GtkGLArea, EGL and OSMesa alike. */
#define QN_GL_FUNCTIONS(X)                                                               \
  X (PFNGLATTACHSHADERPROC, AttachShader)                                                \
  X (PFNGLBINDBUFFERPROC, BindBuffer)                                                    \
  X (PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                          \
  X (PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                        \
  X (PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                          \
  X (PFNGLBLENDFUNCPROC, BlendFunc)                                                      \
  X (PFNGLBUFFERDATAPROC, BufferData)                                                    \
  X (PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                            \
  X (PFNGLCLEARCOLORPROC, ClearColor)                                                    \
  X (PFNGLCLEARPROC, Clear)                                                              \
  X (PFNGLCOMPILESHADERPROC, CompileShader)                                              \
  X (PFNGLCREATEPROGRAMPROC, CreateProgram)                                              \
  X (PFNGLCREATESHADERPROC, CreateShader)                                                \
  X (PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                              \
  X (PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                    \
  X (PFNGLDELETEPROGRAMPROC, DeleteProgram)                                              \
  X (PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                  \
  X (PFNGLDELETESHADERPROC, DeleteShader)                                                \
  X (PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                    \
  X (PFNGLDISABLEPROC, Disable)                                                          \
  X (PFNGLENABLEPROC, Enable)                                                            \
  X (PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                          \
  X (PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)                          \
  X (PFNGLGENBUFFERSPROC, GenBuffers)                                                    \
  X (PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                          \
  X (PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                                        \
  X (PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                          \
  X (PFNGLGETINTEGERVPROC, GetIntegerv)                                                  \
  X (PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                \
  X (PFNGLGETSTRINGPROC, GetString)                                                      \
  X (PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                    \
  X (PFNGLLINKPROGRAMPROC, LinkProgram)                                                  \
  X (PFNGLMULTIDRAWELEMENTSPROC, MultiDrawElements)                                      \
  X (PFNGLPIXELSTOREIPROC, PixelStorei)                                                  \
  X (PFNGLREADPIXELSPROC, ReadPixels)                                                    \
  X (PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)                                  \
  X (PFNGLSCISSORPROC, Scissor)                                                          \
  X (PFNGLSHADERSOURCEPROC, ShaderSource)                                                \
  X (PFNGLUNIFORM2FPROC, Uniform2f)                                                      \
  X (PFNGLUNIFORM3FPROC, Uniform3f)                                                      \
  X (PFNGLUSEPROGRAMPROC, UseProgram)                                                    \
  X (PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                  \
  X (PFNGLVIEWPORTPROC, Viewport)

typedef struct QnGl {
#define QN_GL_MEMBER(type, name) type name;
  QN_GL_FUNCTIONS (QN_GL_MEMBER)
#undef QN_GL_MEMBER
} QnGl;

/* The address of "glName", or NULL. */
typedef void (*QnGlAddress) (void);
typedef QnGlAddress (*QnGlGetAddress) (const char *name);

/* Fills the table; false where a function is missing. */
bool qn_gl_load (QnGl *gl, QnGlGetAddress get_address);

/* Whether the current context is drawn by the processor, not by a graphics card. */
bool qn_gl_is_software (const QnGl *gl);

typedef struct QnGlRenderer QnGlRenderer;

/* Compiles what is needed; `gl` must outlive the renderer. NULL with an error (UNAVAILABLE). */
QnGlRenderer *qn_gl_renderer_new (const QnGl *gl, GError **error);
void qn_gl_renderer_free (QnGlRenderer *renderer);

/* Draws into the bound framebuffer of this height in px (GL counts rows from below), over what
 * is there, with premultiplied alpha. The scene's triangles are uploaded when its revision is
 * another than last time. */
void qn_gl_renderer_draw (QnGlRenderer *renderer, const QnScene *scene,
                          const QnCamera *camera, int framebuffer_height);

/* Draws the camera's viewport into a new image of its size with a transparent ground. NULL with
 * an error. */
cairo_surface_t *qn_gl_renderer_draw_image (QnGlRenderer *renderer, const QnScene *scene,
                                            const QnCamera *camera, GError **error);
