#include "render/backend/offscreen.h"

#include <glib/gi18n-lib.h>
#include <math.h>

static gint made;

QnOffscreen *
qn_offscreen_new (GError **error)
{
  QnOffscreen *self = qn_offscreen_new_egl ();
  if (self == NULL)
    self = qn_offscreen_new_osmesa ();
  if (self == NULL) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_UNAVAILABLE,
                         _ ("OpenGL 3.3 is not available without a display here"));
    return NULL;
  }
  self->renderer = qn_gl_renderer_new (&self->gl, error);
  if (self->renderer == NULL)
    g_clear_pointer (&self, qn_offscreen_free);
  else
    g_atomic_int_inc (&made);
  return self;
}

void
qn_offscreen_free (QnOffscreen *self)
{
  if (self == NULL)
    return;
  qn_gl_renderer_free (self->renderer);
  self->release (self->context);
  g_free (self);
}

unsigned
qn_offscreen_count (void)
{
  return (unsigned) g_atomic_int_get (&made);
}

bool
qn_scene_draw (const QnScene *scene, const QnCamera *camera, cairo_t *cr,
               const QnPage *page, GError **error)
{
  if (page->offscreen == NULL) {
    qn_draw_cairo (scene, camera, QN_LAYERS_ALL, cr);
    return true;
  }

  /* The viewport on whole pixels, so that the image is laid down without being resampled. */
  QnCamera snapped = *camera;
  snapped.x = floor (camera->x);
  snapped.y = floor (camera->y);
  snapped.width = ceil (camera->x + camera->width) - snapped.x;
  snapped.height = ceil (camera->y + camera->height) - snapped.y;
  QnVec2 middle = { snapped.x + 0.5 * snapped.width, snapped.y + 0.5 * snapped.height };
  snapped.center = qn_camera_to_model (camera, middle);
  cairo_surface_t *image =
    qn_gl_renderer_draw_image (page->offscreen->renderer, scene, &snapped, error);
  if (image == NULL)
    return false;
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_BELOW, cr);
  cairo_save (cr);
  cairo_set_source_surface (cr, image, snapped.x, snapped.y);
  cairo_pattern_set_filter (cairo_get_source (cr), CAIRO_FILTER_NEAREST);
  cairo_rectangle (cr, snapped.x, snapped.y, snapped.width, snapped.height);
  cairo_fill (cr);
  cairo_restore (cr);
  cairo_surface_destroy (image);
  qn_draw_cairo (scene, camera, QN_LAYERS_CAIRO_ABOVE, cr);
  return true;
}
