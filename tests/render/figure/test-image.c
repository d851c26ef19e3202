/* Pictures pixel by pixel: exact references for Cairo, OpenGL against Cairo, and variants of
 * one scene that must look alike. No text is drawn, so that no font matters. */
#include "render/backend/draw-cairo.h"
#include "render/backend/draw-gl.h"
#include "render/backend/offscreen.h"
#include "render/fixture.h"
#include "render/image-compare.h"
#include "render/scene/scene-build.h"
#include "support/room.h"

#include <dlfcn.h>
#include <glib.h>

enum { WIDTH = 480, HEIGHT = 360 };

/* Off the pixel grid, so that no edge lies exactly between two pixels. */
static const double pixel_shift = 0.1;

static const unsigned pictured = QN_LAYERS_ALL & ~QN_LAYERS_CAIRO_ABOVE;

static QnScene *
build (const Fixture *f, QnView view)
{
  QnViewOptions options;
  GError *error = NULL;
  qn_view_options_init (&options, view);
  options.dimensions = false;
  QnScene *scene = qn_scene_build (&f->model, &f->contacts, &f->result, &options, &error);
  g_assert_no_error (error);
  return scene;
}

static QnCamera
fit (const QnScene *scene, int width, int height)
{
  QnCamera camera = { .width = width, .height = height, .unit = 2, .scale = 1 };
  qn_camera_fit (&camera, scene->box, 16);
  qn_camera_pan (&camera, qn_vec2 (pixel_shift, pixel_shift));
  return camera;
}

static cairo_surface_t *
white_image (int width, int height)
{
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  cairo_t *cr = cairo_create (image);
  cairo_set_source_rgb (cr, 1, 1, 1);
  cairo_paint (cr);
  cairo_destroy (cr);
  return image;
}

static cairo_surface_t *
draw (const QnScene *scene, const QnCamera *camera, cairo_antialias_t antialias)
{
  cairo_surface_t *image = white_image ((int) camera->width, (int) camera->height);
  cairo_t *cr = cairo_create (image);
  cairo_set_antialias (cr, antialias);
  qn_draw_cairo (scene, camera, pictured, cr);
  cairo_destroy (cr);
  return image;
}

static void
test_golden (void)
{
  Fixture f;
  fixture_init_wall (&f, 4, 6);
  for (int view = 0; view < QN_VIEW_DIAGRAMS; view++) {
    g_autoptr (QnScene) scene = build (&f, (QnView) view);
    QnCamera camera = fit (scene, WIDTH, HEIGHT);
    g_autofree char *name = g_strdup_printf ("cairo-%s", qn_view_names[view]);
    cairo_surface_t *image = draw (scene, &camera, CAIRO_ANTIALIAS_NONE);
    image_assert_golden (name, image, IMAGE_EXACT);
    cairo_surface_destroy (image);
  }
  fixture_clear (&f);
}

/* Zoomed onto one face, where A, B, C and the springs show. */
static void
test_golden_zoomed (void)
{
  Fixture f;
  fixture_init_wall (&f, 4, 6);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_CONTACTS);
  QnCamera camera = fit (scene, WIDTH, HEIGHT);
  camera.center = qn_vec2 (0.8, 0.35);
  camera.scale = 1400.3;
  cairo_surface_t *image = draw (scene, &camera, CAIRO_ANTIALIAS_NONE);
  image_assert_golden ("cairo-contacts-zoomed", image, IMAGE_EXACT);
  cairo_surface_destroy (image);
  fixture_clear (&f);
}

/* ---- OpenGL ---------------------------------------------------------------------------- */

static void
compare_with_gl (QnOffscreen *offscreen, const Fixture *f)
{
  GError *error = NULL;
  QnGlRenderer *renderer = qn_gl_renderer_new (&offscreen->gl, &error);
  g_assert_no_error (error);
  for (int view = 0; view < QN_VIEW_DIAGRAMS; view++) {
    g_autoptr (QnScene) scene = build (f, (QnView) view);
    QnCamera camera = fit (scene, WIDTH, HEIGHT);
    cairo_surface_t *reference = draw (scene, &camera, CAIRO_ANTIALIAS_DEFAULT);
    cairo_surface_t *drawn = qn_gl_renderer_draw_image (renderer, scene, &camera, &error);
    g_assert_no_error (error);
    cairo_surface_t *out = white_image (WIDTH, HEIGHT);
    cairo_t *cr = cairo_create (out);
    cairo_set_source_surface (cr, drawn, 0, 0);
    cairo_paint (cr);
    cairo_destroy (cr);
    g_autofree char *name =
      g_strdup_printf ("%s-%s", offscreen->name, qn_view_names[view]);
    image_assert_equal (name, out, reference, (ImageTolerance){ 24, 96, 0.004, 0.0005 });
    cairo_surface_destroy (out);
    cairo_surface_destroy (drawn);
    cairo_surface_destroy (reference);
  }
  qn_gl_renderer_free (renderer);
}

static void
check_backend (QnOffscreen *offscreen)
{
  Fixture f;
  if (offscreen == NULL) {
    g_test_skip ("not in this build or not on this machine");
    return;
  }
  fixture_init_wall (&f, 4, 6);
  compare_with_gl (offscreen, &f);
  fixture_clear (&f);
  qn_offscreen_free (offscreen);
}

static void
test_gl_egl (void)
{
  check_backend (qn_offscreen_new_egl ());
}

static void
test_gl_osmesa (void)
{
  QnOffscreen *offscreen = qn_offscreen_new_osmesa ();
#ifdef QN_HAVE_OSMESA
  void *library = dlopen ("libOSMesa.so.8", RTLD_LAZY);
  g_assert_cmpint (offscreen != NULL, ==, library != NULL);
  if (library != NULL)
    dlclose (library);
#endif
  check_backend (offscreen);
}

static PFNGLBUFFERDATAPROC buffer_data;
static unsigned uploads;

static void APIENTRY
count_upload (GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
  uploads += target == GL_ARRAY_BUFFER;
  buffer_data (target, size, data, usage);
}

/* A scene is uploaded once, whatever the cameras; another scene uploads anew. */
static void
test_gl_batches (void)
{
  Fixture f;
  GError *error = NULL;
  QnOffscreen *offscreen = qn_offscreen_new (NULL);
  if (offscreen == NULL) {
    g_test_skip ("no OpenGL");
    return;
  }
  fixture_init_wall (&f, 20, 20);
  buffer_data = offscreen->gl.BufferData;
  offscreen->gl.BufferData = count_upload;
  QnGlRenderer *renderer = qn_gl_renderer_new (&offscreen->gl, &error);
  g_assert_no_error (error);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_MODEL);
  g_autoptr (QnScene) other = build (&f, QN_VIEW_MODEL);
  for (int i = 0; i < 4; i++) {
    QnCamera camera = fit (scene, WIDTH, HEIGHT);
    camera.scale *= i * i + 1;
    cairo_surface_destroy (qn_gl_renderer_draw_image (renderer, scene, &camera, &error));
    g_assert_cmpuint (uploads, ==, 1);
  }
  QnCamera camera = fit (other, WIDTH, HEIGHT);
  cairo_surface_destroy (qn_gl_renderer_draw_image (renderer, other, &camera, &error));
  g_assert_cmpuint (uploads, ==, 2);
  qn_gl_renderer_free (renderer);
  qn_offscreen_free (offscreen);
  fixture_clear (&f);
}

/* A joint that has opened to both sides of a hinge: its two sides cross. */
static void
test_gl_crossed (void)
{
  GError *error = NULL;
  const QnVec2 shapes[][4] = {
    { { 0, 0 }, { 1, 0.1 }, { 0, 0.4 }, { 1, 0.2 } },
    { { 0, 0 }, { 1, 0.3 }, { 1, 0.1 }, { 0, 0.2 } },
    { { 0, 0 }, { 0.5, 0.1 }, { 1, 0 }, { 0.5, 0.4 } },
    { { 0, 0 }, { 1, 0.1 }, { 1, 0.4 }, { 0, 0 } },
    { { 0, 0 }, { 1, 0.1 }, { 1, 0.1 }, { 0, 0.4 } },
  };
  QnOffscreen *offscreen = qn_offscreen_new (NULL);
  if (offscreen == NULL) {
    g_test_skip ("no OpenGL");
    return;
  }
  QnGlRenderer *renderer = qn_gl_renderer_new (&offscreen->gl, &error);
  g_assert_no_error (error);
  for (size_t i = 0; i < G_N_ELEMENTS (shapes); i++) {
    g_autoptr (QnScene) scene = qn_scene_new ();
    qn_scene_fill (scene, QN_LAYER_GAPS, shapes[i], 4, qn_rgb (0xc81e1e));
    qn_scene_finish (scene);
    QnCamera camera = fit (scene, 200, 100);
    cairo_surface_t *reference = draw (scene, &camera, CAIRO_ANTIALIAS_DEFAULT);
    cairo_surface_t *drawn = qn_gl_renderer_draw_image (renderer, scene, &camera, &error);
    g_assert_no_error (error);
    cairo_surface_t *out = white_image (200, 100);
    cairo_t *cr = cairo_create (out);
    cairo_set_source_surface (cr, drawn, 0, 0);
    cairo_paint (cr);
    cairo_destroy (cr);
    image_assert_equal ("crossed", out, reference,
                        (ImageTolerance){ 24, 96, 0.003, 0.0005 });
    cairo_surface_destroy (out);
    cairo_surface_destroy (drawn);
    cairo_surface_destroy (reference);
  }
  qn_gl_renderer_free (renderer);
  qn_offscreen_free (offscreen);
}

/* ---- variants of one picture ----------------------------------------------------------- */

/* The fixture with every coordinate mapped by a matrix of determinant +-1. */
static void
map_fixture (Fixture *f, double a, double b, double c, double d)
{
  for (size_t i = 0; i < f->model.vertex_count; i++) {
    QnVec2 p = f->model.vertices[i];
    f->model.vertices[i] = qn_vec2 (a * p.x + b * p.y, c * p.x + d * p.y);
  }
  for (size_t i = 0; i < f->model.block_count; i++) {
    QnVec2 p = f->model.blocks[i].centroid;
    f->model.blocks[i].centroid = qn_vec2 (a * p.x + b * p.y, c * p.x + d * p.y);
  }
}

/* Draws the model's blocks alone, at a camera given by its centre. */
static cairo_surface_t *
draw_blocks (const Fixture *f, int width, int height)
{
  g_autoptr (QnScene) scene = build (f, QN_VIEW_MODEL);
  unsigned layers = 1u << QN_LAYER_BLOCKS | 1u << QN_LAYER_OUTLINES;
  QnCamera camera = { .width = width, .height = height, .unit = 1, .scale = 1 };
  qn_camera_fit (&camera, scene->box, 12.3);
  cairo_surface_t *image = white_image (width, height);
  cairo_t *cr = cairo_create (image);
  qn_draw_cairo (scene, &camera, layers, cr);
  cairo_destroy (cr);
  return image;
}

static void
check_variant (const char *name, const double matrix[4], const int back[4], bool turned)
{
  Fixture f;
  fixture_init_wall (&f, 4, 6);
  cairo_surface_t *reference = draw_blocks (&f, WIDTH, HEIGHT);
  map_fixture (&f, matrix[0], matrix[1], matrix[2], matrix[3]);
  cairo_surface_t *drawn =
    draw_blocks (&f, turned ? HEIGHT : WIDTH, turned ? WIDTH : HEIGHT);
  cairo_surface_t *out = image_transform (drawn, back[0], back[1], back[2], back[3]);
  image_assert_equal (name, out, reference, (ImageTolerance){ 24, 64, 0.002, 0 });
  cairo_surface_destroy (out);
  cairo_surface_destroy (drawn);
  cairo_surface_destroy (reference);
  fixture_clear (&f);
}

static void
test_mirrored (void)
{
  check_variant ("mirrored", (double[]){ -1, 0, 0, 1 }, (int[]){ -1, 0, 0, 1 }, false);
  check_variant ("upside-down", (double[]){ 1, 0, 0, -1 }, (int[]){ 1, 0, 0, -1 }, false);
}

static void
test_rotated (void)
{
  check_variant ("half-turn", (double[]){ -1, 0, 0, -1 }, (int[]){ -1, 0, 0, -1 }, false);
  check_variant ("quarter-turn", (double[]){ 0, -1, 1, 0 }, (int[]){ 0, 1, -1, 0 }, true);
}

/* Four viewports side by side show what one shows. */
static void
test_clipped (void)
{
  Fixture f;
  fixture_init_wall (&f, 4, 6);
  g_autoptr (QnScene) scene = build (&f, QN_VIEW_MECHANISM);
  QnCamera camera = fit (scene, WIDTH, HEIGHT);
  cairo_surface_t *reference = draw (scene, &camera, CAIRO_ANTIALIAS_NONE);
  cairo_surface_t *out = white_image (WIDTH, HEIGHT);
  cairo_t *cr = cairo_create (out);
  cairo_set_antialias (cr, CAIRO_ANTIALIAS_NONE);
  for (int i = 0; i < 4; i++) {
    QnCamera part = camera;
    part.x = i % 2 * WIDTH / 2;
    part.y = i / 2 * HEIGHT / 2;
    part.width = WIDTH / 2;
    part.height = HEIGHT / 2;
    part.center.x += (i % 2 ? 0.25 : -0.25) * WIDTH / camera.scale;
    part.center.y -= (i / 2 ? 0.25 : -0.25) * HEIGHT / camera.scale;
    qn_draw_cairo (scene, &part, pictured, cr);
  }
  cairo_destroy (cr);
  /* The four cameras round places in their own way. */
  image_assert_equal ("clipped", out, reference, (ImageTolerance){ 0, 0, 5e-4, 5e-4 });
  cairo_surface_destroy (out);
  cairo_surface_destroy (reference);
  fixture_clear (&f);
}

QN_TESTS
{
  g_test_add_func ("/render/image/golden", test_golden);
  g_test_add_func ("/render/image/golden-zoomed", test_golden_zoomed);
  g_test_add_func ("/render/image/gl-egl", test_gl_egl);
  g_test_add_func ("/render/image/gl-osmesa", test_gl_osmesa);
  g_test_add_func ("/render/image/gl-batches", test_gl_batches);
  g_test_add_func ("/render/image/gl-crossed", test_gl_crossed);
  g_test_add_func ("/render/image/mirrored", test_mirrored);
  g_test_add_func ("/render/image/rotated", test_rotated);
  g_test_add_func ("/render/image/clipped", test_clipped);
}
