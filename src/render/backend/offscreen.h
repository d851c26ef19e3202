/* OpenGL contexts without a display. Each maker is a build option and lives in a file of its
 * own; a context is used by the thread that made it, while it is the current one. */
#pragma once

#include "render/backend/gl-api.h"

#include <glib.h>

typedef struct QnOffscreen {
  QnGl gl;
  const char *name; /* "EGL", "OSMesa" */
  void *state;      /* the maker's own */
  void (*release) (struct QnOffscreen *self);
} QnOffscreen;

/* Makes a context of OpenGL 3.3 core and makes it current: EGL surfaceless, else OSMesa.
 * NULL with an error (UNAVAILABLE). */
QnOffscreen *qn_offscreen_new (GError **error);
void qn_offscreen_free (QnOffscreen *self);

/* The makers; NULL where the build does without or the machine cannot. */
QnOffscreen *qn_offscreen_new_egl (void);
QnOffscreen *qn_offscreen_new_osmesa (void);

/* Fills the table for the context that is current and that somebody else has made, such as a
 * GtkGLArea. False where it is older than OpenGL 3.3, or the build knows no EGL. */
bool qn_gl_load_current (QnGl *gl);
