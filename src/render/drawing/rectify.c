#include "render/drawing/rectify.h"

#include "render/drawing/paint.h"
#include "render/drawing/render-error.h"

#include <gdk-pixbuf/gdk-pixbuf.h>
#include <glib/gi18n-lib.h>
#include <math.h>

/* Areas below are none: of a photo of 60 million pixels they hold less than one. */
#define LEAST_AREA 1e-8

/* Coordinates (x, y, w) of plane to photo: rows of a 3 by 3 matrix. */
typedef struct Projection {
  double m[3][3];
} Projection;

bool
qn_rectify_is_convex (const QnVec2 points[4])
{
  for (int i = 0; i < 4; i++) {
    QnVec2 a = points[i], b = points[(i + 1) % 4], c = points[(i + 2) % 4];
    if (!(qn_vec2_cross (qn_vec2_sub (b, a), qn_vec2_sub (c, b)) > LEAST_AREA))
      return false;
  }
  return true;
}

bool
qn_rectify_sort (QnVec2 points[4])
{
  QnVec2 middle = qn_vec2 (0, 0), sorted[4];
  double angles[4];
  for (int i = 0; i < 4; i++)
    middle = qn_vec2_add_scaled (middle, 0.25, points[i]);
  for (int i = 0; i < 4;
       i++) { /* by the angle about the middle, from the lower left on */
    QnVec2 arm = qn_vec2_sub (points[i], middle), p = points[i];
    double angle = atan2 (arm.y, arm.x);
    int k = i;
    for (; k > 0 && angles[k - 1] > angle; k--) {
      angles[k] = angles[k - 1];
      sorted[k] = sorted[k - 1];
    }
    angles[k] = angle;
    sorted[k] = p;
  }
  int first = 0;
  for (int i = 1; i < 4; i++)
    if (sorted[i].x + sorted[i].y < sorted[first].x + sorted[first].y)
      first = i;
  for (int i = 0; i < 4; i++)
    points[i] = sorted[(first + i) % 4];
  return qn_rectify_is_convex (points);
}

/* The unit square onto the four points. */
static Projection
projection_of (const QnVec2 p[4])
{
  QnVec2 sum = qn_vec2_sub (qn_vec2_add (p[0], p[2]), qn_vec2_add (p[1], p[3]));
  QnVec2 d1 = qn_vec2_sub (p[1], p[2]), d2 = qn_vec2_sub (p[3], p[2]);
  double det = qn_vec2_cross (d1, d2);
  double g = qn_vec2_cross (sum, d2) / det, h = qn_vec2_cross (d1, sum) / det;
  return (Projection){ {
    { p[1].x - p[0].x + g * p[1].x, p[3].x - p[0].x + h * p[3].x, p[0].x },
    { p[1].y - p[0].y + g * p[1].y, p[3].y - p[0].y + h * p[3].y, p[0].y },
    { g, h, 1 },
  } };
}

static bool
project (const Projection *q, QnVec2 p, QnVec2 *image)
{
  double w = q->m[2][0] * p.x + q->m[2][1] * p.y + q->m[2][2];
  if (!(w > 1e-9))
    return false;
  image->x = (q->m[0][0] * p.x + q->m[0][1] * p.y + q->m[0][2]) / w;
  image->y = (q->m[1][0] * p.x + q->m[1][1] * p.y + q->m[1][2]) / w;
  return true;
}

bool
qn_rectify_to_photo (const QnVec2 points[4], QnVec2 plane, QnVec2 *photo)
{
  Projection projection = projection_of (points);
  return project (&projection, plane, photo);
}

bool
qn_rectify_to_plane (const QnVec2 points[4], QnVec2 photo, QnVec2 *plane)
{
  /* The inverse, times the determinant, which is positive: the corners run counter-clockwise. */
  Projection projection = projection_of (points), inverse;
  double (*m)[3] = projection.m;
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++) {
      int a = (k + 1) % 3, b = (k + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      inverse.m[i][k] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  return project (&inverse, photo, plane);
}

/* What of the plane the photo shows, within the margin. */
static QnBox
find_seen (const QnVec2 points[4], double margin)
{
  const double least = -margin, most = 1 + margin;
  QnBox box = { { 0, 0 }, { 1, 1 } };
  for (int i = 0; i < 4; i++) {
    QnVec2 at;
    /* A corner beyond the horizon: the plane goes on in all directions that may lead there. */
    if (!qn_rectify_to_plane (points, qn_vec2 (i % 2, i / 2), &at))
      return (QnBox){ { least, least }, { most, most } };
    box.min = qn_vec2 (fmin (box.min.x, at.x), fmin (box.min.y, at.y));
    box.max = qn_vec2 (fmax (box.max.x, at.x), fmax (box.max.y, at.y));
  }
  box.min = qn_vec2 (fmax (box.min.x, least), fmax (box.min.y, least));
  box.max = qn_vec2 (fmin (box.max.x, most), fmin (box.max.y, most));
  return box;
}

/* Bilinear between the middles of four pixels; clear beyond the photo's edge. */
static guint32
sample (cairo_surface_t *photo, double x, double y)
{
  int columns = cairo_image_surface_get_width (photo);
  int rows = cairo_image_surface_get_height (photo);
  if (!(x >= 0 && y >= 0 && x < columns && y < rows))
    return 0;
  double u = CLAMP (x - 0.5, 0, columns - 1), v = CLAMP (y - 0.5, 0, rows - 1);
  int left = (int) u, top = (int) v;
  int right = MIN (left + 1, columns - 1), low = MIN (top + 1, rows - 1);
  double a = u - left, b = v - top;
  const guint32 *upper = qn_image_row (photo, top), *lower = qn_image_row (photo, low);
  guint32 pixel = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    double above =
      (1 - a) * (upper[left] >> shift & 255) + a * (upper[right] >> shift & 255);
    double below =
      (1 - a) * (lower[left] >> shift & 255) + a * (lower[right] >> shift & 255);
    pixel |= (guint32) ((1 - b) * above + b * below + 0.5) << shift;
  }
  return pixel;
}

/* Pixels along a side of the rectangle: as many as the longer of two sides opposite of each other has. */
static double
pixels_along (cairo_surface_t *photo, const QnVec2 p[4], int side)
{
  double columns = cairo_image_surface_get_width (photo);
  double rows = cairo_image_surface_get_height (photo), longest = 1;
  for (int i = side; i < 4; i += 2) {
    QnVec2 way = qn_vec2_sub (p[(i + 1) % 4], p[i]);
    longest = fmax (longest, hypot (way.x * columns, way.y * rows));
  }
  return longest;
}

cairo_surface_t *
qn_rectify (cairo_surface_t *photo, const QnVec2 points[4], double margin, QnBox *seen)
{
  Projection projection = projection_of (points);
  *seen = find_seen (points, margin);
  QnVec2 size = qn_vec2_sub (seen->max, seen->min);
  double across = size.x * pixels_along (photo, points, 0);
  double up = size.y * pixels_along (photo, points, 1);
  double shrink = fmin (1, sqrt (QN_RECTIFY_MOST_PIXELS / (across * up)));
  int columns = MAX (1, (int) (shrink * across)), rows = MAX (1, (int) (shrink * up));
  cairo_surface_flush (photo);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, columns, rows);
  if (cairo_surface_status (image) != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy (image);
    return NULL;
  }
  double photo_columns = cairo_image_surface_get_width (photo);
  double photo_rows = cairo_image_surface_get_height (photo);
  for (int y = 0; y < rows; y++) {
    guint32 *out = qn_image_row (image, y);
    for (int x = 0; x < columns; x++) {
      QnVec2 at, plane = { seen->min.x + size.x * (x + 0.5) / columns,
                           seen->max.y - size.y * (y + 0.5) / rows };
      out[x] = project (&projection, plane, &at)
                 ? sample (photo, at.x * photo_columns, (1 - at.y) * photo_rows)
                 : 0;
    }
  }
  cairo_surface_mark_dirty (image);
  return image;
}

/* ---- files ------------------------------------------------------------------------------ */

/* Pictures of more pixels are refused before they are decoded: some hundred bytes of PNG can stand for
 * gigabytes. Decoding and turning take up to eight bytes a pixel. */
#define MOST_PIXELS 60000000

/* One row from straight RGB or RGBA to Cairo's premultiplied native words. */
static void
convert_row (const guint8 *in, int width, int channels, guint32 *out)
{
  for (int x = 0; x < width; x++, in += channels) {
    guint32 a = channels == 4 ? in[3] : 255, c[3];
    for (int k = 0; k < 3; k++)
      c[k] = (in[k] * a + 127) / 255;
    out[x] = a << 24 | c[0] << 16 | c[1] << 8 | c[2];
  }
}

cairo_surface_t *
qn_photo_load (const char *path, GError **error)
{
  g_autoptr (GError) cause = NULL;
  int across, up;
  if (gdk_pixbuf_get_file_info (path, &across, &up) != NULL
      && (gint64) across * up > MOST_PIXELS) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: the picture has %d x %d pixels, more than %d million in all"),
                 path, across, up, MOST_PIXELS / 1000000);
    return NULL;
  }
  g_autoptr (GdkPixbuf) raw = gdk_pixbuf_new_from_file (path, &cause);
  if (raw == NULL) {
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: cannot be read: %s"), path, cause->message);
    return NULL;
  }
  g_autoptr (GdkPixbuf) photo = gdk_pixbuf_apply_embedded_orientation (raw);
  g_clear_object (&raw);
  int width = gdk_pixbuf_get_width (photo), height = gdk_pixbuf_get_height (photo);
  cairo_surface_t *image =
    cairo_image_surface_create (CAIRO_FORMAT_ARGB32, width, height);
  if (cairo_surface_status (image) != CAIRO_STATUS_SUCCESS) {
    cairo_surface_destroy (image);
    g_set_error (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FILE,
                 _ ("%s: the picture is too large"), path);
    return NULL;
  }
  const guint8 *in = gdk_pixbuf_read_pixels (photo);
  for (int y = 0; y < height; y++)
    convert_row (in + (gsize) y * gdk_pixbuf_get_rowstride (photo), width,
                 gdk_pixbuf_get_n_channels (photo), qn_image_row (image, y));
  cairo_surface_mark_dirty (image);
  return image;
}
