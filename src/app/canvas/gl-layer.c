#include "app/canvas/gl-layer.h"

#include "app/canvas/scene-cache.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "render/backend/offscreen.h"

/* ---- the area ---- */

static void
on_realize (GtkGLArea *area, QnGlLayer *self)
{
  g_autoptr (GError) error = NULL;
  gtk_gl_area_make_current (area);
  self->revision = 0;
  if (gtk_gl_area_get_error (area) == NULL && qn_gl_load_current (&self->gl)) {
    self->software = qn_gl_is_software (&self->gl);
    self->renderer = qn_gl_renderer_new (&self->gl, &error);
  }
  self->failed = self->renderer == NULL;
  if (self->failed)
    g_info ("OpenGL is not available to the window: %s",
            error != NULL ? error->message : "no context of version 3.3");
}

static void
on_unrealize (GtkGLArea *area, QnGlLayer *self)
{
  gtk_gl_area_make_current (area);
  g_clear_pointer (&self->renderer, qn_gl_renderer_free);
}

/* Labels and photos are Cairo's, below and above this layer. */
static gboolean
on_render (GtkGLArea *area, GdkGLContext *context, QnGlLayer *self)
{
  int factor = gtk_widget_get_scale_factor (GTK_WIDGET (area));
  self->gl.Disable (GL_SCISSOR_TEST);
  self->gl.ClearColor (0, 0, 0, 0);
  self->gl.Clear (GL_COLOR_BUFFER_BIT);
  if (self->scene == NULL || self->renderer == NULL)
    return TRUE;
  QnCamera camera = self->camera;
  camera.x *= factor;
  camera.y *= factor;
  camera.width *= factor;
  camera.height *= factor;
  camera.scale *= factor;
  camera.unit *= factor;
  qn_gl_renderer_draw (self->renderer, self->scene, &camera,
                       (int) qn_to_integer (camera.height, 0, G_MAXINT16));
  self->revision = self->scene->revision;
  self->frames++;
  return TRUE;
}

/* ---- layer ---- */

static gboolean
on_wake (gpointer data)
{
  QnGlLayer *self = data;
  self->wake = 0;
  gtk_widget_set_visible (self->area, self->wanted && !self->failed);
  /* What was never drawn does not ask for it. */
  gtk_widget_queue_draw (gtk_widget_get_parent (self->area));
  return G_SOURCE_REMOVE;
}

/* Few commands are drawn by Cairo in less time than a picture takes to the screen, and without
 * a graphics card moving a picture of many is quicker than drawing them for every frame. */
static gboolean
is_worthwhile (QnGlLayer *self, const QnScene *scene)
{
  switch ((QnEngine) g_settings_get_enum (qn_settings_get (), "engine")) {
  case QN_ENGINE_CAIRO:
    return FALSE;
  case QN_ENGINE_OPENGL:
    return TRUE;
  case QN_ENGINE_AUTOMATIC:
    break;
  }
  return scene->commands->len >= QN_SCENE_CACHE_LEAST && !self->software;
}

gboolean
qn_gl_layer_prepare (QnGlLayer *self, const QnScene *scene, const QnCamera *camera)
{
  self->wanted = scene != NULL && !self->failed && is_worthwhile (self, scene);
  self->scene = self->wanted ? scene : NULL;
  if (gtk_widget_get_visible (self->area) != self->wanted && self->wake == 0)
    self->wake = g_idle_add (on_wake, self);
  /* The area has its size from the allocation after it was shown. */
  if (!self->wanted || self->renderer == NULL || !gtk_widget_get_mapped (self->area)
      || gtk_widget_get_width (self->area)
           != (int) qn_to_integer (camera->width, 0, G_MAXINT16))
    return FALSE;
  const QnCamera *drawn = &self->camera;
  if (self->revision != scene->revision || drawn->center.x != camera->center.x
      || drawn->center.y != camera->center.y || drawn->scale != camera->scale
      || drawn->width != camera->width || drawn->height != camera->height) {
    self->camera = *camera;
    gtk_widget_queue_draw (self->area);
  }
  return TRUE;
}

void
qn_gl_layer_init (QnGlLayer *self)
{
  gtk_gl_area_set_required_version (GTK_GL_AREA (self->area), 3, 3);
  g_signal_connect_after (self->area, "realize", G_CALLBACK (on_realize), self);
  g_signal_connect (self->area, "unrealize", G_CALLBACK (on_unrealize), self);
  g_signal_connect (self->area, "render", G_CALLBACK (on_render), self);
}
