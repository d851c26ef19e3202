#include "render/backend/gl-painter.h"

#include "render/backend/draw-gl.h"
#include "render/backend/offscreen.h"

struct QnGlPainter {
  QnOffscreen *offscreen;
  QnGlRenderer *renderer;
};

static gint painter_count;

QnGlPainter *
qn_gl_painter_new (GError **error)
{
  QnOffscreen *offscreen = qn_offscreen_new (error);
  if (offscreen == NULL)
    return NULL;
  QnGlPainter *painter = g_new0 (QnGlPainter, 1);
  painter->offscreen = offscreen;
  painter->renderer = qn_gl_renderer_new (&offscreen->gl, error);
  if (painter->renderer == NULL)
    g_clear_pointer (&painter, qn_gl_painter_free);
  else
    g_atomic_int_inc (&painter_count);
  return painter;
}

void
qn_gl_painter_free (QnGlPainter *painter)
{
  if (painter == NULL)
    return;
  qn_gl_renderer_free (painter->renderer);
  qn_offscreen_free (painter->offscreen);
  g_free (painter);
}

cairo_surface_t *
qn_gl_painter_draw (QnGlPainter *painter, const QnScene *scene, const QnCamera *camera,
                    bool antialias, GError **error)
{
  return qn_gl_renderer_draw_image (painter->renderer, scene, camera, antialias, NULL,
                                    error);
}

unsigned
qn_gl_painter_count (void)
{
  return (unsigned) g_atomic_int_get (&painter_count);
}
