#include "core/base/integer.h"
#include "io/exchange/drawing.h"
#include "io/exchange/dxf-scan.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Inserts that contain themselves, or each other by the million, end here. */
#define MAX_DEPTH    24
#define MAX_PATHS    1000000
#define MAX_POINTS   4000000 /* of all paths: an arc has many */
#define MAX_INSERTED 4000000

/* A direction in which a drawing has less than this part of its size is none of its plane. */
#define FLAT 1e-6

/* Columns: where the axes of the inner coordinates point, and where their origin lies. */
typedef struct Place {
  double axes[3][3], origin[3];
} Place;

typedef struct Importer {
  QnDrawing *drawing;
  const QnDxfScan *scan;
  GArray *points; /* Point: of all paths, one after the other, in the world */
  guint budget;   /* of entities of inserts, drawn or not */
  gboolean faces; /* there are no other outlines */
} Importer;

typedef struct Point {
  double at[3];
} Point;

/* Whether a drawing has more than is read. */
static gboolean
is_full (const Importer *importer)
{
  return importer->drawing->paths->len >= MAX_PATHS || importer->points->len >= MAX_POINTS
         || importer->budget == 0;
}

static const Place world = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0, 0, 0 } };

static Point
apply (const Place *place, double x, double y, double z)
{
  Point p;
  for (int i = 0; i < 3; i++)
    p.at[i] = place->origin[i] + x * place->axes[0][i] + y * place->axes[1][i]
              + z * place->axes[2][i];
  return p;
}

/* First `inner`, then `outer`. */
static Place
compose (const Place *outer, const Place *inner)
{
  Place all;
  Point origin = apply (outer, inner->origin[0], inner->origin[1], inner->origin[2]);
  for (int k = 0; k < 3; k++) {
    const double *axis = inner->axes[k];
    Point end = apply (outer, axis[0], axis[1], axis[2]);
    for (int i = 0; i < 3; i++)
      all.axes[k][i] = end.at[i] - outer->origin[i];
    all.origin[k] = origin.at[k];
  }
  return all;
}

static void
cross (const double *a, const double *b, double *c)
{
  for (int i = 0; i < 3; i++)
    c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static gboolean
normalise (double *v)
{
  double length = hypot (hypot (v[0], v[1]), v[2]);
  for (int i = 0; i < 3; i++)
    v[i] /= length;
  return length > 0 && isfinite (length);
}

/* The coordinates of a plane with this normal ("arbitrary axis algorithm" of the DXF reference). */
static Place
plane_of (const double *normal)
{
  Place plane = world;
  double n[3] = { normal[0], normal[1], normal[2] };
  if (!normalise (n))
    return plane;
  gboolean steep = fabs (n[0]) < 1.0 / 64 && fabs (n[1]) < 1.0 / 64;
  cross (steep ? world.axes[1] : world.axes[2], n, plane.axes[0]);
  normalise (plane.axes[0]);
  cross (n, plane.axes[0], plane.axes[1]);
  memcpy (plane.axes[2], n, sizeof n);
  return plane;
}

static const QnDxfPoint *
points_of (const Importer *importer, const QnDxfEntity *entity)
{
  return &g_array_index (importer->scan->points, QnDxfPoint, entity->first_point);
}

static void
add_polyline (QnDrawingPath *path, const QnDxfEntity *entity, const QnDxfPoint *p)
{
  gsize n = entity->point_count;
  gboolean curved = entity->in_plane;
  for (gsize i = 0; i < n; i++)
    if (i == 0 || !curved)
      qn_drawing_path_add (path, qn_vec2 (p[i].x, p[i].y));
    else
      qn_drawing_path_add_bulge (path, qn_vec2 (p[i].x, p[i].y), p[i - 1].extra);
  if (entity->closed && curved && n > 1 && p[n - 1].extra != 0) {
    qn_drawing_path_add_bulge (path, qn_vec2 (p[0].x, p[0].y), p[n - 1].extra);
    path->count--;
  }
}

/* From one angle to another, rad, counter-clockwise; the whole of it where they are the same. */
static void
add_round (QnDrawingPath *path, QnVec2 centre, QnVec2 major, QnVec2 minor, double from,
           double to)
{
  while (to <= from)
    to += 2 * G_PI;
  gboolean whole = to - from >= 2 * G_PI - 1e-9;
  qn_drawing_path_add_ellipse (path, centre, major, minor, from,
                               whole ? from + 2 * G_PI : to);
  if (whole)
    path->count--;
  path->closed = whole;
}

static gboolean
add_spline (QnDrawingPath *path, const Importer *importer, const QnDxfEntity *entity,
            const QnDxfPoint *p)
{
  gsize n = entity->point_count;
  g_autofree QnVec2 *points = g_new (QnVec2, n);
  g_autofree double *weights = g_new (double, n);
  for (gsize i = 0; i < n; i++) {
    points[i] = qn_vec2 (p[i].x, p[i].y);
    weights[i] = p[i].extra;
  }
  return qn_drawing_path_add_spline (
    path, (guint) qn_to_integer (entity->numbers[0], 0, G_MAXINT),
    &g_array_index (importer->scan->knots, double, entity->first_knot),
    entity->knot_count, points, weights, n);
}

/* The entity's own points, in the coordinates that `own` places; FALSE for a curve that makes no
 * sense. */
static gboolean
add_points (const Importer *importer, QnDrawingPath *path, const QnDxfEntity *entity,
            Place *own)
{
  const double *n = entity->numbers;
  const QnDxfPoint *p = points_of (importer, entity);
  path->closed = entity->closed;
  switch (entity->kind) {
  case QN_DXF_LINE:
  case QN_DXF_FACE:
  case QN_DXF_POLYLINE:
  case QN_DXF_HATCH:
    add_polyline (path, entity, p);
    return entity->point_count > 0;
  case QN_DXF_ARC:
    if (!(n[0] > 0) || !(fabs (n[1]) <= 1e6) || !(fabs (n[2]) <= 1e6))
      return FALSE;
    add_round (path, qn_vec2 (p->x, p->y), qn_vec2 (n[0], 0), qn_vec2 (0, n[0]),
               n[1] * G_PI / 180, n[2] * G_PI / 180);
    return TRUE;
  case QN_DXF_ELLIPSE: {
    double major[3] = { p[1].x, p[1].y, p[1].z }, normal[3], minor[3];
    memcpy (normal, entity->normal, sizeof normal);
    if (!(fabs (n[1]) <= 1e4) || !(fabs (n[2]) <= 1e4) || !normalise (normal))
      return FALSE;
    cross (normal, major, minor);
    *own = (Place){ { { major[0], major[1], major[2] },
                      { n[0] * minor[0], n[0] * minor[1], n[0] * minor[2] },
                      { 0, 0, 0 } },
                    { p->x, p->y, p->z } };
    add_round (path, qn_vec2 (0, 0), qn_vec2 (1, 0), qn_vec2 (0, 1), n[1], n[2]);
    return TRUE;
  }
  case QN_DXF_SPLINE:
    return add_spline (path, importer, entity, p);
  case QN_DXF_INSERT:
    break;
  }
  return FALSE;
}

static const QnDxfEntity *
entity_at (const Importer *importer, guint index)
{
  return &g_array_index (importer->scan->entities, QnDxfEntity, index);
}

static QnDrawingNote *
leave_out (const Importer *importer, const QnDxfEntity *entity, const char *type)
{
  g_autofree char *text = g_strdup_printf (_ ("%s entities left out"), type);
  return qn_drawing_note (importer->drawing, text, entity->line);
}

static void add_entity (Importer *importer, const QnDxfEntity *entity, const Place *place,
                        const char *layer, int depth);

/* One element of the insert's array. */
static Place
insert_place (const QnDxfEntity *insert, const QnDxfPoint *at, const double *base,
              double column, double row)
{
  const double *n = insert->numbers;
  double angle = n[3] * G_PI / 180, c = cos (angle), s = sin (angle);
  double dx = column * n[6], dy = row * n[7];
  Place own = { { { c * n[0], s * n[0], 0 }, { -s * n[1], c * n[1], 0 }, { 0, 0, n[2] } },
                { at->x + c * dx - s * dy, at->y + s * dx + c * dy, at->z } };
  Point shift = apply (&own, base[0], base[1], base[2]);
  for (int i = 0; i < 3; i++)
    own.origin[i] -= shift.at[i] - own.origin[i];
  Place plane = plane_of (insert->normal);
  return compose (&plane, &own);
}

static void
add_insert (Importer *importer, const QnDxfEntity *insert, const Place *place,
            const char *layer, int depth)
{
  const QnDxfBlock *block = insert->name != NULL
                              ? g_hash_table_lookup (importer->scan->blocks, insert->name)
                              : NULL;
  const QnDxfPoint *at = points_of (importer, insert);
  if (block == NULL || depth >= MAX_DEPTH) {
    qn_drawing_note (importer->drawing,
                     block == NULL ? _ ("inserts of unknown blocks left out")
                                   : _ ("inserts nested too deeply left out"),
                     insert->line);
    return;
  }
  int columns = (int) qn_to_integer (insert->numbers[4], 1, MAX_PATHS);
  int rows = (int) qn_to_integer (insert->numbers[5], 1, MAX_PATHS);
  gboolean outlined = FALSE; /* then hatches fill what the block has */
  for (guint i = block->first; i < block->end; i++)
    outlined = outlined || entity_at (importer, i)->kind != QN_DXF_HATCH;
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < columns; column++) {
      Place own = insert_place (insert, at, block->base, column, row);
      Place all = compose (place, &own);
      for (guint i = block->first; i < block->end; i++) {
        if (is_full (importer))
          return;
        importer->budget--;
        const QnDxfEntity *entity = entity_at (importer, i);
        if (entity->kind == QN_DXF_HATCH)
          leave_out (importer, entity, "HATCH")->minor = outlined;
        else
          add_entity (importer, entity, &all, layer, depth + 1);
      }
      if (block->first == block->end)
        return;
    }
}

static void
add_entity (Importer *importer, const QnDxfEntity *entity, const Place *place,
            const char *layer, int depth)
{
  QnDrawing *drawing = importer->drawing;
  gboolean inherits = depth > 0 && strcmp (entity->layer, "0") == 0;
  const char *own_layer = inherits ? layer : entity->layer;
  g_autofree char *folded = g_utf8_strdown (own_layer, -1);
  int hidden = GPOINTER_TO_INT (g_hash_table_lookup (importer->scan->hidden, folded));
  gboolean insert = entity->kind == QN_DXF_INSERT;
  /* A layer that is off does not hide what a block on it has on other layers. */
  if (entity->invisible || (insert && hidden == QN_DXF_FROZEN)) {
    qn_drawing_note (drawing,
                     entity->invisible ? _ ("invisible shapes left out")
                                       : _ ("blocks on frozen layers left out"),
                     entity->line);
    return;
  }
  if (insert) {
    add_insert (importer, entity, place, own_layer, depth);
    return;
  }
  guint first = importer->points->len;
  QnDrawingPath *path = qn_drawing_add_path (drawing, own_layer, entity->line);
  Place own = entity->in_plane ? plane_of (entity->normal) : world;
  gboolean sound = add_points (importer, path, entity, &own);
  Place all = compose (place, &own);
  const QnDxfPoint *p = points_of (importer, entity);
  gboolean each = !entity->in_plane && path->count == entity->point_count;
  path->hidden = hidden != 0;
  for (gsize i = 0; i < path->count; i++) {
    double z = entity->kind == QN_DXF_ELLIPSE ? 0 : each ? p[i].z : p[0].z;
    Point point = apply (&all, path->points[i].x, path->points[i].y, z);
    for (int k = 0; k < 3; k++)
      sound = sound && isfinite (point.at[k]);
    path->points[i] = qn_vec2 (point.at[0], point.at[1]);
    g_array_append_val (importer->points, point);
  }
  if (!sound) {
    qn_drawing_note (drawing, _ ("invalid curves left out"), entity->line);
    g_free (path->points);
    g_array_set_size (drawing->paths, drawing->paths->len - 1);
    g_array_set_size (importer->points, first);
  }
}

/* How far what is outside of blocks is an outline by itself. Faces in space and hatches repeat outlines
 * where there are any. */
typedef enum { OUTLINES, FACES, HATCHES, RANK_COUNT } Rank;

static Rank
rank_of (const QnDxfEntity *entity)
{
  return entity->kind == QN_DXF_HATCH                       ? HATCHES
         : entity->kind == QN_DXF_FACE && !entity->in_plane ? FACES
                                                            : OUTLINES;
}

/* Adds what is of a rank, or counts it where there is something else. */
static void
add_rank (Importer *importer, Rank rank)
{
  static const char *const taken[] = { NULL, N_ ("read as outlines: faces in space"),
                                       N_ ("read as outlines: hatches") };
  static const char *const types[] = { "", "3DFACE", "HATCH" };
  gboolean repeat = rank != OUTLINES && importer->drawing->paths->len > 0;
  for (guint i = 0; i < importer->scan->entities->len; i++) {
    const QnDxfEntity *entity = entity_at (importer, i);
    if (!entity->outside || rank_of (entity) != rank)
      continue;
    gboolean counts = rank == FACES || (rank == HATCHES && entity->numbers[0] == 1);
    if (counts && repeat)
      leave_out (importer, entity, types[rank])->minor = rank == HATCHES;
    else if (counts)
      qn_drawing_note (importer->drawing, _ (taken[rank]), entity->line);
    if (repeat)
      continue;
    const QnDxfPoint *p = points_of (importer, entity);
    if (rank == FACES
        && (entity->point_count == 3
            || (entity->point_count == 4 && memcmp (&p[2], &p[3], sizeof *p) == 0)))
      qn_drawing_note (importer->drawing,
                       _ ("triangles of meshes, each of which becomes a block"),
                       entity->line);
    importer->faces = importer->faces || rank == FACES;
    add_entity (importer, entity, &world, "0", 0);
  }
}

/* Direction in plan of the upright plane that the points, in a box, lie in; the zero vector where there is
 * none. */
static QnVec2
direction_of_plane (const Importer *importer, const double least[3], const double most[3],
                    double size)
{
  guint count = importer->points->len;
  const Point *points = (const Point *) (const void *) importer->points->data;
  QnVec2 mean = { 0 };
  double xx = 0, yy = 0, xy = 0, aside = 0;
  if (!(most[1] - least[1] > FLAT * size))
    return qn_vec2 (1, 0);
  if (!(most[0] - least[0] > FLAT * size))
    return qn_vec2 (0, 1);
  for (guint i = 0; i < count; i++)
    mean =
      qn_vec2_add_scaled (mean, 1.0 / count, qn_vec2 (points[i].at[0], points[i].at[1]));
  for (guint i = 0; i < count; i++) {
    double x = points[i].at[0] - mean.x, y = points[i].at[1] - mean.y;
    xx += x * x;
    yy += y * y;
    xy += x * y;
  }
  double angle = 0.5 * atan2 (2 * xy, xx - yy);
  QnVec2 along = qn_vec2 (cos (angle), sin (angle));
  for (guint i = 0; i < count; i++)
    aside = fmax (aside, fabs ((points[i].at[1] - mean.y) * along.x
                               - (points[i].at[0] - mean.x) * along.y));
  return 2 * aside > FLAT * size ? qn_vec2 (0, 0) : along;
}

/* Turns a drawing that lies in an upright plane, and so has no depth, to be seen from the front. False
 * where faces of solids lie about in space. */
static gboolean
choose_view (Importer *importer)
{
  double least[3] = { INFINITY, INFINITY, INFINITY },
         most[3] = { -INFINITY, -INFINITY, -INFINITY }, size = 0;
  for (guint i = 0; i < importer->points->len; i++)
    for (int k = 0; k < 3; k++) {
      double x = g_array_index (importer->points, Point, i).at[k];
      least[k] = fmin (least[k], x);
      most[k] = fmax (most[k], x);
    }
  for (int k = 0; k < 3; k++)
    size = fmax (size, most[k] - least[k]);
  if (!(most[2] - least[2] > FLAT * size))
    return TRUE;
  QnVec2 right = direction_of_plane (importer, least, most, size);
  gboolean flat = right.x != 0 || right.y != 0;
  if (!flat && importer->faces)
    return FALSE;
  qn_drawing_note (
    importer->drawing,
    !flat          ? _ ("shapes are drawn in space and seen from above; shapes")
    : right.y == 0 ? _ ("drawn in the x-z plane and seen from the front; shapes")
    : right.x == 0 ? _ ("drawn in the y-z plane and seen from the side; shapes")
                   : _ ("drawn in an upright plane and seen square to it; shapes"),
    0)
    ->count = importer->drawing->paths->len;
  guint next = 0;
  for (guint i = 0; flat && i < importer->drawing->paths->len; i++) {
    QnDrawingPath *path = &g_array_index (importer->drawing->paths, QnDrawingPath, i);
    for (gsize k = 0; k < path->count; k++) {
      const Point *point = &g_array_index (importer->points, Point, next++);
      path->points[k] =
        qn_vec2 (right.x * point->at[0] + right.y * point->at[1], point->at[2]);
    }
  }
  return TRUE;
}

gboolean
qn_dxf_import (const char *bytes, gsize size, const char *name, QnDrawing *drawing,
               GError **error)
{
  QnDxfScan scan;
  gsize length;
  g_autofree char *charset = qn_dxf_dup_charset (bytes, size);
  g_autofree char *text = qn_text_decode (bytes, size, charset, &length);
  if (!qn_dxf_scan (text, name, drawing, &scan, error))
    return FALSE;
  Importer importer = { .drawing = drawing,
                        .scan = &scan,
                        .budget = MAX_INSERTED,
                        .points = g_array_new (FALSE, FALSE, sizeof (Point)) };
  gboolean alone = FALSE; /* the last rank, hatches */
  for (int rank = 0; rank < RANK_COUNT; rank++) {
    alone = drawing->paths->len == 0;
    add_rank (&importer, (Rank) rank);
  }
  gboolean full = is_full (&importer), seen = !full && choose_view (&importer);
  if (seen && alone) {
    /* The boundaries of each hatch, which have its line, are parts of one shape. Nothing
     * else is there. */
    for (guint first = 0, end; first < drawing->paths->len; first = end) {
      guint line = g_array_index (drawing->paths, QnDrawingPath, first).line;
      for (end = first + 1;
           end < drawing->paths->len
           && g_array_index (drawing->paths, QnDrawingPath, end).line == line;)
        end++;
      qn_drawing_join_parts (drawing, first, end, TRUE);
    }
  }
  if (full && importer.points->len >= MAX_POINTS)
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: outlines of more than %d corners"), name, MAX_POINTS);
  else if (full)
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: more than %d outlines"), name, MAX_PATHS);
  else if (!seen)
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: faces of solids (3DFACE) that lie in no upright plane: write "
                    "them as OBJ or COMPAS to read them as prisms, or draw their front"),
                 name);
  g_array_unref (importer.points);
  qn_dxf_scan_clear (&scan);
  return seen;
}
