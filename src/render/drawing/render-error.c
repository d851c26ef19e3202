#include "render/drawing/render-error.h"

#include <glib/gi18n-lib.h>

/* The formatter would set spaces around dashes that are part of the name. */
/* clang-format off */
G_DEFINE_QUARK (qn-render-error-quark, qn_render_error)
/* clang-format on */

void
qn_render_error_set_unwritten (GError **error, const char *path, int trouble)
{
  g_set_error (
    error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE, _ ("%s: cannot be written: %s"),
    g_str_equal (path, "-") ? _ ("standard output") : path, g_strerror (trouble));
}
