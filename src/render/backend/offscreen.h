/* OpenGL contexts without a display. Each maker is a build option and lives in a file of its
 * own; a context is used by the thread that made it, while it is the current one. */
#pragma once

#include "render/backend/draw-gl.h"
#include "render/backend/output.h"

typedef struct QnOffscreen {
  QnGl gl;
  const char *name;       /* "EGL", "OSMesa" */
  QnGlRenderer *renderer; /* of qn_offscreen_new() */
  void *context;          /* of the maker's own kind */
  void (*release) (void *context);
} QnOffscreen;

/* Makes a context of OpenGL 3.3 core with a renderer, once for all pictures of a page or an animation, and makes
 * it current: EGL surfaceless, else OSMesa. NULL with an error (UNAVAILABLE). */
QnOffscreen *qn_offscreen_new (GError **error);
void qn_offscreen_free (QnOffscreen *self);
G_DEFINE_AUTOPTR_CLEANUP_FUNC (QnOffscreen, qn_offscreen_free)

/* How many of them this process has made: contexts are expensive. */
unsigned qn_offscreen_count (void);

/* Draws a scene onto a page, which may have one of these: the picture is then drawn off screen, read back and
 * laid onto the page; labels are always Cairo's. */
bool qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
                    const QnPage *page, GError **error);

/* The makers; NULL where the build does without or the machine cannot. */
QnOffscreen *qn_offscreen_new_egl (void);
QnOffscreen *qn_offscreen_new_osmesa (void);

/* Fills the table for the context that is current and that somebody else has made, such as a
 * GtkGLArea. False where it is older than OpenGL 3.3, or the build knows no EGL. */
bool qn_gl_load_current (QnGl *gl);
