#include "render/image-compare.h"

#include <glib.h>
#include <stdbool.h>
#include <stdlib.h>

typedef struct Tally {
  gsize slight, gross, total;
} Tally;

static guint32 *
pixel (cairo_surface_t *image, int x, int y)
{
  guint8 *data = cairo_image_surface_get_data (image);
  return (guint32 *) (void *) (data + (gsize) y * cairo_image_surface_get_stride (image))
         + x;
}

static int
difference (guint32 p, guint32 q)
{
  int largest = 0;
  for (int shift = 0; shift < 24; shift += 8)
    largest = MAX (largest, abs ((int) (p >> shift & 255) - (int) (q >> shift & 255)));
  return largest;
}

/* Counts and draws the differences: grey where equal, red where not. */
static Tally
compare (cairo_surface_t *out, cairo_surface_t *reference, ImageTolerance tolerance,
         cairo_surface_t *diff)
{
  int width = cairo_image_surface_get_width (out);
  int height = cairo_image_surface_get_height (out);
  Tally tally = { 0, 0, (gsize) width * height };
  for (int y = 0; y < height; y++) {
    for (int x = 0; x < width; x++) {
      int d = difference (*pixel (out, x, y), *pixel (reference, x, y));
      tally.slight += d > tolerance.slight;
      tally.gross += d > tolerance.gross;
      guint32 faint = 192 + (*pixel (reference, x, y) >> 10 & 63);
      *pixel (diff, x, y) =
        d > tolerance.slight ? 0xffff0000 : 0xff000000 | faint * 0x10101;
    }
  }
  return tally;
}

static void
keep (const char *name, const char *kind, cairo_surface_t *image)
{
  const char *folder = g_getenv ("QUOIN_IMAGE_DIFFS");
  if (folder == NULL)
    return;
  g_mkdir_with_parents (folder, 0777);
  g_autofree char *file = g_strdup_printf ("%s/%s-%s.png", folder, name, kind);
  cairo_surface_write_to_png (image, file);
}

void
image_assert_equal (const char *name, cairo_surface_t *out, cairo_surface_t *reference,
                    ImageTolerance tolerance)
{
  int width = cairo_image_surface_get_width (out);
  int height = cairo_image_surface_get_height (out);
  g_assert_cmpint (cairo_image_surface_get_width (reference), ==, width);
  g_assert_cmpint (cairo_image_surface_get_height (reference), ==, height);
  cairo_surface_flush (out);
  cairo_surface_flush (reference);
  cairo_surface_t *diff = cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  Tally tally = compare (out, reference, tolerance, diff);
  cairo_surface_mark_dirty (diff);
  double slight = (double) tally.slight / tally.total;
  double gross = (double) tally.gross / tally.total;
  if (slight > tolerance.slight_share || gross > tolerance.gross_share) {
    keep (name, "out", out);
    keep (name, "ref", reference);
    keep (name, "diff", diff);
    g_test_message ("%s: %.4f %% differ, %.4f %% grossly", name, 100 * slight,
                    100 * gross);
    g_test_fail_printf ("pictures differ: %s", name);
  }
  cairo_surface_destroy (diff);
}

void
image_assert_golden (const char *name, cairo_surface_t *out, ImageTolerance tolerance)
{
  g_autofree char *file = g_strdup_printf ("%s.png", name);
  g_autofree char *path = g_test_build_filename (G_TEST_DIST, "golden", file, NULL);
  if (g_getenv ("QUOIN_ACCEPT_IMAGES") != NULL) {
    g_assert_cmpint (cairo_surface_write_to_png (out, path), ==, CAIRO_STATUS_SUCCESS);
    return;
  }
  cairo_surface_t *reference = cairo_image_surface_create_from_png (path);
  if (cairo_surface_status (reference) == CAIRO_STATUS_SUCCESS) {
    image_assert_equal (name, out, reference, tolerance);
  } else {
    keep (name, "out", out);
    g_test_fail_printf ("no reference %s", path);
  }
  cairo_surface_destroy (reference);
}

cairo_surface_t *
image_transform (cairo_surface_t *source, int a, int b, int c, int d)
{
  int width = cairo_image_surface_get_width (source);
  int height = cairo_image_surface_get_height (source);
  bool turned = a == 0;
  int out_width = turned ? height : width, out_height = turned ? width : height;
  cairo_surface_t *out =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, out_width, out_height);
  cairo_surface_flush (source);
  for (int y = 0; y < out_height; y++) {
    for (int x = 0; x < out_width; x++) {
      int u = a * x + b * y, v = c * x + d * y;
      u += a + b < 0 ? width - 1 : 0;
      v += c + d < 0 ? height - 1 : 0;
      *pixel (out, x, y) = *pixel (source, u, v);
    }
  }
  cairo_surface_mark_dirty (out);
  return out;
}
