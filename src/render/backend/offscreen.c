#include "render/backend/offscreen.h"

#include "render/backend/output.h"

#include <glib/gi18n-lib.h>

QnOffscreen *
qn_offscreen_new (GError **error)
{
  QnOffscreen *self = qn_offscreen_new_egl ();
  if (self == NULL)
    self = qn_offscreen_new_osmesa ();
  if (self == NULL)
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                         _ ("OpenGL 3.3 is not available without a display here"));
  return self;
}

void
qn_offscreen_free (QnOffscreen *self)
{
  if (self == NULL)
    return;
  self->release (self);
  g_free (self);
}
