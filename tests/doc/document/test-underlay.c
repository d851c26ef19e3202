#include "doc/document/underlay.h"
#include "render/drawing/rectify.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

static const char head[] =
  "{\"format\": \"quoin\", \"version\": 1,"
  "\"laws\": [{\"name\": \"dry\", \"kind\": \"coulomb\", \"kn\": 1e7, \"ks\": 1e7,"
  "\"friction\": 0.4}],"
  "\"blocks\": [{\"name\": \"base\", \"vertices\": [[0,-1],[4,-1],[4,0],[0,0]],"
  "\"thickness\": 1, \"unit_weight\": 1e4, \"support\": [true,true,true]}],"
  "\"contact\": {\"law\": \"dry\"}";

typedef struct Rig {
  char *folder, *photo, *model;
  QnProject project;
} Rig;

/* A project beside a red photo of 40 x 20 px. */
static void
rig_init (Rig *rig, const char *underlay)
{
  GError *error = NULL;
  rig->folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  rig->photo = g_build_filename (rig->folder, "photo.png", NULL);
  rig->model = g_build_filename (rig->folder, "m.quoin", NULL);
  cairo_surface_t *image = cairo_image_surface_create (CAIRO_FORMAT_RGB24, 40, 20);
  cairo_t *cr = cairo_create (image);
  cairo_set_source_rgb (cr, 1, 0, 0);
  cairo_paint (cr);
  cairo_destroy (cr);
  cairo_surface_write_to_png (image, rig->photo);
  cairo_surface_destroy (image);
  g_autofree char *text = underlay != NULL
                            ? g_strdup_printf ("%s,\n\"underlay\": %s}", head, underlay)
                            : g_strconcat (head, "}", NULL);
  g_assert_true (g_file_set_contents (rig->model, text, -1, NULL));
  g_assert_true (qn_project_load (rig->model, NULL, &rig->project, &error));
  g_assert_no_error (error);
}

static void
rig_clear (Rig *rig)
{
  qn_project_clear (&rig->project);
  g_unlink (rig->photo);
  g_unlink (rig->model);
  g_rmdir (rig->folder);
  g_free (rig->folder);
  g_free (rig->photo);
  g_free (rig->model);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Rig, rig_clear)

static void
test_reads (void)
{
  Rig rig;
  QnUnderlay underlay;
  GError *error = NULL;
  rig_init (&rig, "{\"image\": \"photo.png\", \"origin\": [1, -2], \"width\": 8,"
                  "\"angle\": 0.1, \"opacity\": 0.25}");
  g_assert_true (qn_underlay_read (&rig.project, FALSE, &underlay, &error));
  g_assert_no_error (error);
  g_assert_cmpint (cairo_image_surface_get_width (underlay.image), ==, 40);
  guint32 pixel = *(guint32 *) (void *) cairo_image_surface_get_data (underlay.image);
  g_assert_cmphex (pixel, ==, 0xffff0000);
  g_assert_cmpfloat (underlay.origin.y, ==, -2);
  g_assert_cmpfloat (underlay.width, ==, 8);
  g_assert_cmpfloat (underlay.angle, ==, 0.1);
  g_assert_cmpfloat (underlay.opacity, ==, 0.25);
  g_autofree char *json = qn_underlay_to_json ("photo.png", &underlay);
  g_assert_cmpstr (json, ==,
                   "{ \"image\": \"photo.png\", \"origin\": [1, -2], \"width\": 8, "
                   "\"angle\": 0.1, \"opacity\": 0.25 }");
  cairo_surface_destroy (underlay.image);
  rig_clear (&rig);

  rig_init (&rig, NULL);
  g_assert_true (qn_underlay_read (&rig.project, FALSE, &underlay, &error));
  g_assert_null (underlay.image);
  rig_clear (&rig);
}

static void
test_refusals (void)
{
  static const char *const wrong[][2] = {
    { "[]", "underlay" },
    { "{\"width\": 1}", "underlay.image" },
    { "{\"image\": \"photo.png\"}", "underlay.width" },
    { "{\"image\": \"photo.png\", \"width\": 0}", "underlay.width" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"opacity\": 2}", "underlay.opacity" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 1}}",
      "underlay.rectangle.corners" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 0,"
      "\"corners\": [[0,0],[1,0],[1,1],[0,1]]}}",
      "underlay.rectangle.height" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 1,"
      "\"corners\": [[0,0],[1,0],[1,1]]}}",
      "four points" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 1,"
      "\"corners\": [[0,0],[1,0],[0.1,0.1],[0,1]]}}",
      "convex" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 1,"
      "\"corners\": [[0,0],[0,1],[1,1],[1,0]]}}",
      "counter-clockwise" },
    { "{\"image\": \"photo.png\", \"width\": 1, \"rectangle\": {\"height\": 1,"
      "\"corners\": [[0,0],[1e9,0],[1,1],[0,1]]}}",
      "outside" },
    { "{\"image\": \"none.png\", \"width\": 1}", "none.png" },
    { "{\"image\": \"m.quoin\", \"width\": 1}", "m.quoin" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_auto (Rig) rig;
    QnUnderlay underlay;
    GError *error = NULL;
    rig_init (&rig, wrong[i][0]);
    g_assert_false (qn_underlay_read (&rig.project, FALSE, &underlay, &error));
    g_assert_nonnull (error);
    g_assert_nonnull (strstr (error->message, wrong[i][1]));
    g_assert_null (underlay.image);
    g_clear_error (&error);
  }
}

/* The model point of a place on the photo given in shares of its width and height. */
static QnVec2
place_on (const QnUnderlay *u, double across, double up)
{
  QnVec2 arm = qn_vec2 (across * u->width, up * u->width / 2);
  return qn_vec2_add (u->origin, qn_vec2_rotate (arm, cos (u->angle), sin (u->angle)));
}

static void
test_match (void)
{
  QnUnderlay u = { .origin = { 3, 1 }, .width = 2, .angle = 0.3 };
  const QnVec2 shown[2] = { place_on (&u, 0.2, 0.1), place_on (&u, 0.9, 0.6) };
  const QnVec2 wanted[2] = { { 10, -5 }, { 12, 4 } };
  g_assert_true (qn_underlay_match (&u, shown, wanted));
  QnVec2 a = place_on (&u, 0.2, 0.1), b = place_on (&u, 0.9, 0.6);
  g_assert_cmpfloat_with_epsilon (a.x, 10, 1e-9);
  g_assert_cmpfloat_with_epsilon (a.y, -5, 1e-9);
  g_assert_cmpfloat_with_epsilon (b.x, 12, 1e-9);
  g_assert_cmpfloat_with_epsilon (b.y, 4, 1e-9);
  const QnVec2 same[2] = { { 1, 1 }, { 1, 1 } };
  g_assert_false (qn_underlay_match (&u, same, wanted));
  g_assert_false (qn_underlay_match (&u, shown, same));
}

/* Rectified by places where they are shown, a photo shows them at the rectangle's corners; again by
 * other corners, it shows the same places of the plane. */
static void
test_rectify (void)
{
  Rig rig;
  QnUnderlay u;
  GError *error = NULL;
  rig_init (&rig, "{\"image\": \"photo.png\", \"origin\": [1, -2], \"width\": 8}");
  g_assert_true (qn_underlay_read (&rig.project, FALSE, &u, &error));
  /* Out of order; the photo is 8 m by 4 m as it is shown. */
  const QnVec2 shown[4] = { { 7, 1.4 }, { 2, -1.5 }, { 3, 1 }, { 6, -1.2 } };
  g_assert_true (qn_underlay_rectify (&u, shown, 3, 1.5));
  g_assert_cmpfloat_with_epsilon (u.points[0].x, 0.125, 1e-12);
  g_assert_cmpfloat_with_epsilon (u.points[0].y, 0.125, 1e-12);
  g_assert_cmpfloat_with_epsilon (u.points[2].x, 0.75, 1e-12);
  g_assert_cmpfloat_with_epsilon (u.points[2].y, 0.85, 1e-12);
  g_assert_cmpfloat (u.origin.x, ==, 2);
  g_assert_cmpfloat (u.width, ==, 3);
  cairo_surface_destroy (u.image);
  g_autofree char *json = qn_underlay_to_json ("photo.png", &u);
  rig_clear (&rig);

  rig_init (&rig, json);
  QnUnderlay read;
  g_assert_true (qn_underlay_read (&rig.project, FALSE, &read, &error));
  g_assert_no_error (error);
  g_assert_true (read.rectified);
  g_assert_cmpfloat (read.height, ==, 1.5);
  g_autofree char *again = qn_underlay_to_json ("photo.png", &read);
  g_assert_cmpstr (again, ==, json);

  /* The lower half of the rectangle, as another one: the same plane, the same picture. */
  const QnVec2 half[4] = { { 2, -1.5 }, { 5, -1.5 }, { 5, -0.75 }, { 2, -0.75 } };
  QnVec2 place, before;
  g_assert_true (qn_rectify_to_photo (read.points, qn_vec2 (0.3, 0.4), &before));
  g_assert_true (qn_underlay_rectify (&read, half, 3, 0.75));
  g_assert_true (qn_rectify_to_photo (read.points, qn_vec2 (0.3, 0.8), &place));
  g_assert_cmpfloat_with_epsilon (place.x, before.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (place.y, before.y, 1e-12);

  const QnVec2 line[4] = { { 2, 0 }, { 3, 0 }, { 4, 0 }, { 5, 0 } };
  const QnVec2 inside[4] = { { 2, -1.5 }, { 5, -1.5 }, { 3, -1 }, { 2, 1 } };
  g_assert_false (qn_underlay_rectify (&read, line, 1, 1));
  g_assert_false (qn_underlay_rectify (&read, inside, 1, 1));
  cairo_surface_destroy (read.image);
  rig_clear (&rig);
}

QN_TESTS
{
  g_test_add_func ("/doc/underlay/reads", test_reads);
  g_test_add_func ("/doc/underlay/refusals", test_refusals);
  g_test_add_func ("/doc/underlay/match", test_match);
  g_test_add_func ("/doc/underlay/rectify", test_rectify);
}
