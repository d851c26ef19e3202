#include "io/exchange/drawing.h"

#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "stereotomy/polygon-ops.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#define MAX_SPLINE_DEGREE 11
#define MAX_CHORDS        240

/* Of half a circle: chords of 0.75 degrees, whose sagitta is 2.1e-5 of the radius. */
#define ARC_CHORDS 240

/* Of the ends of an arc, rad. */
#define LARGEST_ANGLE 1e5

/* No vertex lies nearer to the end of an arc than this part of a chord. */
#define NEAR_END 0.25

/* Names of layers, by the piece; bytes. */
#define STRINGS_SIZE 1024

void
qn_drawing_init (QnDrawing *drawing)
{
  *drawing = (QnDrawing){ .paths = g_array_new (FALSE, TRUE, sizeof (QnDrawingPath)),
                          .notes = g_ptr_array_new (),
                          .strings = g_string_chunk_new (STRINGS_SIZE) };
}

void
qn_drawing_clear (QnDrawing *drawing)
{
  for (guint i = 0; drawing->paths != NULL && i < drawing->paths->len; i++)
    g_free (g_array_index (drawing->paths, QnDrawingPath, i).points);
  for (guint i = 0; drawing->notes != NULL && i < drawing->notes->len; i++) {
    QnDrawingNote *note = drawing->notes->pdata[i];
    g_free (note->text);
    g_free (note);
  }
  g_clear_pointer (&drawing->paths, g_array_unref);
  g_clear_pointer (&drawing->notes, g_ptr_array_unref);
  g_clear_pointer (&drawing->strings, g_string_chunk_free);
}

gboolean
qn_drawing_read (QnDrawingReader *reader, const char *text, gsize length,
                 const char *name, QnDrawing *drawing, GError **error)
{
  qn_drawing_init (drawing);
  gboolean done = reader (text, length, name, drawing, error);
  if (!done)
    qn_drawing_clear (drawing);
  return done;
}

const char *
qn_drawing_keep_string (QnDrawing *drawing, const char *string)
{
  return g_string_chunk_insert_const (drawing->strings, string);
}

QnDrawingPath *
qn_drawing_add_path (QnDrawing *drawing, const char *layer, guint line)
{
  QnDrawingPath path = { .layer = qn_drawing_keep_string (drawing, layer), .line = line };
  g_array_append_val (drawing->paths, path);
  return &g_array_index (drawing->paths, QnDrawingPath, drawing->paths->len - 1);
}

/* Capacity doubles when the count is a power of two. */
void
qn_drawing_path_add (QnDrawingPath *path, QnVec2 point)
{
  if ((path->count & (path->count - 1)) == 0)
    path->points =
      g_renew (QnVec2, path->points, path->count == 0 ? 4 : 2 * path->count + 4);
  path->points[path->count++] = point;
}

QnDrawingNote *
qn_drawing_note (QnDrawing *drawing, const char *text, guint line)
{
  for (guint i = 0; i < drawing->notes->len; i++) {
    QnDrawingNote *note = drawing->notes->pdata[i];
    if (strcmp (note->text, text) == 0) {
      note->count++;
      return note;
    }
  }
  QnDrawingNote *note = g_new (QnDrawingNote, 1);
  *note = (QnDrawingNote){ g_strdup (text), 1, line, FALSE };
  g_ptr_array_add (drawing->notes, note);
  return note;
}

static gboolean
is_bounded (const QnDrawingPath *path)
{
  for (gsize i = 0; i < path->count; i++)
    if (!(fabs (path->points[i].x) <= QN_DRAWING_LARGEST
          && fabs (path->points[i].y) <= QN_DRAWING_LARGEST))
      return FALSE;
  return TRUE;
}

void
qn_drawing_drop_unbounded (QnDrawing *drawing)
{
  guint kept = 0;
  for (guint i = 0; i < drawing->paths->len; i++) {
    QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
    if (!is_bounded (path))
      qn_drawing_note (drawing, _ ("shapes with coordinates beyond 1e15 left out"),
                       path->line);
    if (path->count > 0 && is_bounded (path))
      g_array_index (drawing->paths, QnDrawingPath, kept++) = *path;
    else
      g_free (path->points);
  }
  g_array_set_size (drawing->paths, kept);
}

/* Ends lie where they are given; between them vertices lie at whole multiples of one angle, so that two
 * arcs of one circle have them in common. */
void
qn_drawing_path_add_ellipse (QnDrawingPath *path, QnVec2 centre, QnVec2 major,
                             QnVec2 minor, double from, double to)
{
  const double step = G_PI / ARC_CHORDS, way = to > from ? step : -step;
  double t = from, next = way * (floor (from / way + NEAR_END) + 1);
  if (!(fabs (from) <= LARGEST_ANGLE && fabs (to) <= LARGEST_ANGLE)) {
    /* It will be left out, and told, whichever of its ends the caller replaces. */
    qn_drawing_path_add (path, qn_vec2 (NAN, NAN));
    qn_drawing_path_add (path, qn_vec2 (NAN, NAN));
    return;
  }
  for (;; next += way) {
    qn_drawing_path_add (
      path,
      qn_vec2_add_scaled (qn_vec2_add_scaled (centre, cos (t), major), sin (t), minor));
    if (t == to)
      return;
    t = (to - next) / way > NEAR_END ? next : to;
  }
}

void
qn_drawing_path_add_bulge (QnDrawingPath *path, QnVec2 end, double bulge)
{
  g_return_if_fail (path->count > 0);
  QnVec2 start = path->points[path->count - 1];
  QnVec2 chord = qn_vec2_sub (end, start);
  /* Centre on the perpendicular through the middle of the chord. */
  double away = (1 - bulge * bulge) / (4 * bulge);
  QnVec2 centre =
    qn_vec2_add_scaled (qn_vec2_lerp (start, end, 0.5), away, qn_vec2_perp (chord));
  QnVec2 radius = qn_vec2_sub (start, centre);
  double r = qn_vec2_length (radius), from = atan2 (radius.y, radius.x);
  gsize first = path->count - 1;
  if (bulge == 0 || !isfinite (r) || !isfinite (from)) {
    qn_drawing_path_add (path, end);
    return;
  }
  path->count--;
  qn_drawing_path_add_ellipse (path, centre, qn_vec2 (r, 0), qn_vec2 (0, r), from,
                               from + 4 * atan (bulge));
  path->points[first] = start;
  path->points[path->count - 1] = end;
}

/* From the second differences of the control points, whose largest bounds the distance of curve and
 * chords: d (d - 1) / 8 of it for one chord, and less with their number squared. */
static int
count_chords (const QnVec2 *control, guint degree)
{
  double bend = 0, length = 0;
  for (guint i = 0; i < degree; i++) {
    length += qn_vec2_length (qn_vec2_sub (control[i + 1], control[i]));
    if (i + 1 < degree)
      bend = fmax (bend, qn_vec2_length (qn_vec2_add_scaled (
                           qn_vec2_sub (control[i + 2], control[i + 1]), -1,
                           qn_vec2_sub (control[i + 1], control[i]))));
  }
  double part = length > 0 ? bend / (QN_DRAWING_SAGITTA * length) : 0;
  return (int) qn_to_integer (ceil (sqrt (0.125 * degree * (degree - 1) * part)), 1,
                              MAX_CHORDS);
}

/* de Boor's algorithm in homogeneous coordinates. */
static QnVec2
spline_point (guint degree, const double *knots, gsize span, const QnVec2 *points,
              const double *weights, double t)
{
  double x[MAX_SPLINE_DEGREE + 1], y[MAX_SPLINE_DEGREE + 1], w[MAX_SPLINE_DEGREE + 1];
  for (guint i = 0; i <= degree; i++) {
    gsize k = span - degree + i;
    w[i] = weights != NULL ? weights[k] : 1;
    x[i] = points[k].x * w[i];
    y[i] = points[k].y * w[i];
  }
  for (guint round = 1; round <= degree; round++)
    for (guint i = degree; i >= round; i--) {
      gsize k = span - degree + i;
      double width = knots[k + degree - round + 1] - knots[k];
      double a = width > 0 ? (t - knots[k]) / width : 0;
      x[i] = (1 - a) * x[i - 1] + a * x[i];
      y[i] = (1 - a) * y[i - 1] + a * y[i];
      w[i] = (1 - a) * w[i - 1] + a * w[i];
    }
  return qn_vec2 (x[degree] / w[degree], y[degree] / w[degree]);
}

gboolean
qn_drawing_path_add_spline (QnDrawingPath *path, guint degree, const double *knots,
                            gsize knot_count, const QnVec2 *points, const double *weights,
                            gsize point_count)
{
  if (degree < 1 || degree > MAX_SPLINE_DEGREE || point_count <= degree
      || knot_count != point_count + degree + 1)
    return FALSE;
  for (gsize i = 1; i < knot_count; i++)
    if (!(knots[i] >= knots[i - 1]))
      return FALSE;
  for (gsize span = degree; span < point_count; span++) {
    double t0 = knots[span], t1 = knots[span + 1];
    if (!(t1 > t0))
      continue;
    int chords = count_chords (points + span - degree, degree);
    for (int i = path->count == 0 ? 0 : 1; i <= chords; i++)
      qn_drawing_path_add (path, spline_point (degree, knots, span, points, weights,
                                               t0 + (t1 - t0) * i / chords));
  }
  return path->count > 1;
}

/* ---- shapes of several parts ---- */

/* Of one shape; more are not searched for holes. */
#define MAX_PARTS 5000

/* A part of a shape of several. */
typedef struct Part {
  QnRing ring; /* of the path, counter-clockwise; empty where it is open */
  double area; /* negative where they were drawn clockwise */
  QnBox box;
  QnVec2 inner;  /* a point in it */
  guint depth;   /* of how many others */
  guint parent;  /* the smallest of them */
  QnRings holes; /* in it */
} Part;

static gboolean
encloses (const Part *outer, const Part *inner)
{
  QnVec2 p = inner->inner;
  return inner->area != 0 && p.x > outer->box.min.x && p.x < outer->box.max.x
         && p.y > outer->box.min.y && p.y < outer->box.max.y
         && fabs (outer->area) > fabs (inner->area)
         && qn_polygon_depth (outer->ring.points, outer->ring.count, p) > 0;
}

/* Makes a part what is left of it around its holes; false where that is not one simple ring. */
static gboolean
cut_holes (QnDrawingPath *path, const Part *part)
{
  g_auto (QnRings) left = { 0 };
  if (qn_polygon_difference (&part->ring, &part->holes, &left, NULL) != QN_OK
      || left.count != 1)
    return FALSE;
  path->count = 0;
  for (gsize i = 0; i < left.items[0].count; i++)
    qn_drawing_path_add (path, left.items[0].points[i]);
  return TRUE;
}

void
qn_drawing_join_parts (QnDrawing *drawing, guint first, guint end, gboolean even_odd)
{
  guint count = end - first;
  QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, first);
  if (count < 2 || count > MAX_PARTS)
    return;
  g_autofree Part *parts = g_new0 (Part, count);
  for (guint i = 0; i < count; i++) {
    if (!path[i].closed || path[i].count < 3)
      continue;
    parts[i].ring = qn_ring_of (path[i].points, path[i].count);
    parts[i].area = qn_ring_area (&parts[i].ring);
    parts[i].box = qn_ring_bounds (&parts[i].ring);
    qn_ring_orient (&parts[i].ring);
    parts[i].inner = qn_polygon_inner_point (parts[i].ring.points, parts[i].ring.count);
  }
  for (guint i = 0; i < count; i++)
    for (guint k = 0; k < count; k++)
      if (k != i && encloses (&parts[k], &parts[i])
          && (parts[i].depth++ == 0
              || fabs (parts[k].area) < fabs (parts[parts[i].parent].area)))
        parts[i].parent = k;
  for (guint i = 0; i < count; i++) {
    const Part *part = &parts[i];
    Part *parent = &parts[part->parent];
    if (part->depth % 2 == 1 && (even_odd || part->area * parent->area < 0))
      qn_rings_add (&parent->holes, part->ring.points, part->ring.count);
    else if (part->depth % 2 == 1)
      qn_drawing_note (drawing, _ ("parts of shapes that others cover left out"),
                       path[i].line);
  }
  for (guint i = 0; i < count; i++) {
    if (parts[i].holes.count > 0 && !cut_holes (&path[i], &parts[i]))
      qn_drawing_note (drawing, _ ("shapes with holes, whose blocks are solid"),
                       path[i].line);
    qn_rings_clear (&parts[i].holes);
    qn_ring_clear (&parts[i].ring);
  }
  for (guint i = 0; i < count; i++)
    if (parts[i].depth % 2 == 1) {
      g_clear_pointer (&path[i].points, g_free);
      path[i].count = 0;
    }
}
