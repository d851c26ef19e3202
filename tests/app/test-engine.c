/* What draws the structure in the window: OpenGL and Cairo show the same, at the resolution of
 * the screen, and where there is no OpenGL Cairo draws it all. The test is run at one and at
 * two device pixels a pixel, and without OpenGL (environment variable QUOIN_NO_GL). */
#include "app/canvas/canvas.h"
#include "app/canvas/gl-layer.h"
#include "app/widgets/settings.h"
#include "driver.h"
#include "support/room.h"

#include <glib.h>
#include <time.h>

static gboolean
expects_gl (void)
{
  return g_getenv ("QUOIN_NO_GL") == NULL;
}

static QnGlLayer *
layer_of (QnWindow *window)
{
  return gl_layer_of (canvas_of (window));
}

static void
set_engine (QnWindow *window, QnEngine engine)
{
  g_settings_set_enum (qn_settings_get (), "engine", (int) engine);
  gtk_widget_queue_draw (GTK_WIDGET (canvas_of (window)));
  driver_settle ();
}

/* Share of pixels of which a colour differs by more than `most`. */
static double
difference (cairo_surface_t *a, cairo_surface_t *b, int most)
{
  int width = cairo_image_surface_get_width (a), count = 0;
  int height = cairo_image_surface_get_height (a);
  g_assert_cmpint (cairo_image_surface_get_width (b), ==, width);
  g_assert_cmpint (cairo_image_surface_get_height (b), ==, height);
  int stride = cairo_image_surface_get_stride (a);
  for (int y = 0; y < height; y++) {
    const guint8 *p = cairo_image_surface_get_data (a) + y * stride;
    const guint8 *q = cairo_image_surface_get_data (b) + y * stride;
    for (int x = 0; x < width; x++) {
      gboolean differs = FALSE;
      for (int c = 0; c < 3; c++)
        differs |= ABS (p[4 * x + c] - q[4 * x + c]) > most;
      count += differs;
    }
  }
  return (double) count / width / height;
}

static void
test_same_picture (void)
{
  const char *const names[] = { "12-facade.quoin", "06-arch.quoin" };
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    QnWindow *window = driver_open_example (names[i]);
    set_engine (window, QN_ENGINE_CAIRO);
    g_assert_cmpuint (layer_of (window)->frames, ==, 0);
    cairo_surface_t *cairo = driver_picture (GTK_WIDGET (window));
    set_engine (window, QN_ENGINE_OPENGL);
    cairo_surface_t *gl = driver_picture (GTK_WIDGET (window));
    g_assert_cmpint (layer_of (window)->frames > 0, ==, expects_gl ());
    driver_screenshot (GTK_WIDGET (window), i == 0 ? "engine-gl" : "engine-gl-arch");
    g_assert_cmpfloat (difference (cairo, gl, 64), <, 0.002);
    g_assert_cmpfloat (difference (cairo, gl, 160), <, 0.0002);
    int factor = gtk_widget_get_scale_factor (GTK_WIDGET (window));
    g_assert_cmpint (cairo_image_surface_get_width (gl), >=,
                     gtk_widget_get_width (GTK_WIDGET (window)) * factor);
    cairo_surface_destroy (cairo);
    cairo_surface_destroy (gl);
    g_settings_reset (qn_settings_get (), "engine");
    driver_discard (window);
  }
}

static QnWindow *
open_large_wall (void)
{
  QnWindow *window = driver_open_window (1280, 800);
  driver_activate (window, "win.draw");
  driver_lay_large_wall (window);
  driver_activate (window, "win.fit");
  return window;
}

/* Moves and zooms the paper; tells how long a frame takes. */
static void
move_paper (QnWindow *window, const char *engine)
{
  enum { FRAMES = 30 };
  QnCanvas *canvas = canvas_of (window);
  gint64 start = g_get_monotonic_time ();
  clock_t busy = clock ();
  for (int i = 0; i < FRAMES; i++) {
    QnCamera camera = canvas->camera;
    qn_camera_pan (&camera, qn_vec2 (5.0, 2.0));
    qn_camera_zoom_at (&camera, qn_vec2 (400, 300), 1.03);
    move_camera (canvas, &camera);
    driver_settle ();
  }
  g_test_message ("%s: %.1f ms a frame, processors %.1f ms", engine,
                  1e-3 * (double) (g_get_monotonic_time () - start) / FRAMES,
                  1e3 * (double) (clock () - busy) / CLOCKS_PER_SEC / FRAMES);
}

static PFNGLBUFFERDATAPROC buffer_data;
static unsigned uploads;

static void APIENTRY
count_upload (GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
  uploads++;
  buffer_data (target, size, data, usage);
}

/* Small drawings make no context; large ones are drawn by a graphics card where there is one,
 * and uploaded once, however the paper moves. */
static void
test_automatic (void)
{
  QnWindow *window = driver_open_example ("06-arch.quoin");
  g_assert_cmpuint (layer_of (window)->frames, ==, 0);
  driver_discard (window);

  window = open_large_wall ();
  if (expects_gl ()) {
    g_assert_cmpint (layer_of (window)->frames > 0, ==, !layer_of (window)->software);
    set_engine (window, QN_ENGINE_OPENGL);
    buffer_data = layer_of (window)->gl.BufferData;
    layer_of (window)->gl.BufferData = count_upload;
    unsigned frames = layer_of (window)->frames;
    g_assert_cmpuint (frames, >, 0);
    move_paper (window, "OpenGL");
    driver_settle ();
    g_assert_cmpuint (layer_of (window)->frames, >, frames + 5);
    g_assert_cmpuint (uploads, ==, 0);
    driver_screenshot (GTK_WIDGET (window), "engine-large");
    set_engine (window, QN_ENGINE_CAIRO);
  }
  unsigned frames = layer_of (window)->frames;
  move_paper (window, "Cairo");
  g_assert_cmpuint (layer_of (window)->frames, ==, frames);
  g_settings_reset (qn_settings_get (), "engine");
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/engine/same-picture", test_same_picture);
  g_test_add_func ("/app/engine/automatic", test_automatic);
}
