#include "render/drawing/render-error.h"

#include <glib/gi18n-lib.h>

/* The formatter would set spaces around dashes that are part of the name. */
/* clang-format off */
G_DEFINE_QUARK (qn-render-error-quark, qn_render_error)
/* clang-format on */

bool
qn_render_refuse (GError **error, const char *format, ...)
{
  va_list args;
  va_start (args, format);
  g_propagate_error (
    error, g_error_new_valist (QN_RENDER_ERROR, QN_RENDER_ERROR_USAGE, format, args));
  va_end (args);
  return false;
}

void
qn_render_error_set_unwritten (GError **error, const char *path, int trouble)
{
  g_set_error (
    error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE, _ ("%s: cannot be written: %s"),
    g_str_equal (path, "-") ? _ ("standard output") : path, g_strerror (trouble));
}
