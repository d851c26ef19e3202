/* Errors of this layer, with a sentence in the user's language. */
#pragma once

#include <glib.h>
#include <stdbool.h>

#define QN_RENDER_ERROR (qn_render_error_quark ())

typedef enum {
  QN_RENDER_ERROR_USAGE,       /* what is asked for makes no sense: size, ending, step */
  QN_RENDER_ERROR_FILE,        /* a file cannot be read or written */
  QN_RENDER_ERROR_UNAVAILABLE, /* this build or machine lacks OpenGL or an encoder */
  QN_RENDER_ERROR_CANCELLED,
  QN_RENDER_ERROR_FAILED /* a library failed, no memory */
} QnRenderError;

GQuark qn_render_error_quark (void);

/* What is asked for makes no sense (USAGE), for the reason given; false. */
bool qn_render_refuse (GError **error, const char *format, ...) G_GNUC_PRINTF (2, 3);

/* The file ("-": standard output) cannot be written; an errno says why. */
void qn_render_error_set_unwritten (GError **error, const char *path, int trouble);
