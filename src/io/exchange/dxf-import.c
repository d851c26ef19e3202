#include "io/exchange/dxf-import.h"
#include "core/base/integer.h"
#include "io/exchange/dxf-scan.h"
#include "io/exchange/dxf-shim.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Inserts that contain themselves, or each other by the million, end here. */
#define MAX_DEPTH    24
#define MAX_PATHS    1000000
#define MAX_INSERTED 4000000

/* x' = xx x + xy y + x0 and so on. */
typedef struct Transform {
  double xx, xy, yx, yy, x0, y0;
} Transform;

typedef struct Entity {
  QnDxfEntity data; /* points and knots owned, strings kept by the drawing */
  QnDxfSource source;
} Entity;

typedef struct Definition {
  QnVec2 base;
  guint first, end; /* entities */
} Definition;

typedef struct Importer {
  QnDrawing *drawing;
  const QnDxfScan *scan;
  GArray *entities;        /* Entity, those of blocks included */
  GHashTable *definitions; /* name -> Definition */
  Definition *open;
  GArray *top;  /* guint: entities outside of blocks */
  guint budget; /* of entities of inserts, drawn or not */
} Importer;

static const Transform identity = { 1, 0, 0, 1, 0, 0 };

static QnVec2
apply (const Transform *t, QnVec2 p)
{
  return qn_vec2 (t->xx * p.x + t->xy * p.y + t->x0, t->yx * p.x + t->yy * p.y + t->y0);
}

/* First `inner`, then `outer`. */
static Transform
compose (const Transform *outer, const Transform *inner)
{
  QnVec2 origin = apply (outer, qn_vec2 (inner->x0, inner->y0));
  return (Transform){ outer->xx * inner->xx + outer->xy * inner->yx,
                      outer->xx * inner->xy + outer->xy * inner->yy,
                      outer->yx * inner->xx + outer->yy * inner->yx,
                      outer->yx * inner->xy + outer->yy * inner->yy,
                      origin.x,
                      origin.y };
}

static QnDxfSource
source_of (const Importer *importer, const char *layer)
{
  guint64 index = g_ascii_strtoull (layer != NULL ? layer : "", NULL, 10);
  if (index < importer->scan->sources->len)
    return g_array_index (importer->scan->sources, QnDxfSource, index);
  return (QnDxfSource){ "0", 0 };
}

/* Keeps what the shim hands over. */
static void
take_entity (const QnDxfEntity *entity, void *data)
{
  Importer *importer = data;
  if (entity->kind == QN_DXF_BLOCK) {
    importer->open = g_new (Definition, 1);
    *importer->open = (Definition){ qn_vec2 (entity->numbers[0], entity->numbers[1]),
                                    importer->entities->len, importer->entities->len };
    g_hash_table_replace (importer->definitions, g_strdup (entity->name), importer->open);
    return;
  }
  if (entity->kind == QN_DXF_BLOCK_END) {
    importer->open = NULL;
    return;
  }
  Entity own = { *entity, source_of (importer, entity->layer) };
  own.data.layer = NULL;
  own.data.name = entity->name != NULL
                    ? qn_drawing_keep_string (importer->drawing, entity->name)
                    : NULL;
  own.data.points = g_memdup2 (entity->points, 3 * entity->point_count * sizeof (double));
  own.data.knots = g_memdup2 (entity->knots, entity->knot_count * sizeof (double));
  guint index = importer->entities->len;
  g_array_append_val (importer->entities, own);
  if (importer->open != NULL)
    importer->open->end = importer->entities->len;
  else
    g_array_append_val (importer->top, index);
}

static void
add_polyline (QnDrawingPath *path, const QnDxfEntity *entity)
{
  gsize n = entity->point_count;
  gboolean closed = (entity->flags & 1) != 0;
  for (gsize i = 0; i < n; i++) {
    const double *p = entity->points + 3 * i;
    if (i == 0)
      qn_drawing_path_add (path, qn_vec2 (p[0], p[1]));
    else
      qn_drawing_path_add_bulge (path, qn_vec2 (p[0], p[1]), p[-1]);
  }
  if (closed && n > 1 && entity->points[3 * n - 1] != 0) {
    qn_drawing_path_add_bulge (path, qn_vec2 (entity->points[0], entity->points[1]),
                               entity->points[3 * n - 1]);
    path->count--;
  }
  path->closed = closed;
}

static void
add_arc (QnDrawingPath *path, const QnDxfEntity *entity)
{
  const double *n = entity->numbers;
  double from = n[3] * G_PI / 180, to = n[4] * G_PI / 180;
  while (to <= from)
    to += 2 * G_PI;
  gboolean circle = to - from >= 2 * G_PI - 1e-12;
  qn_drawing_path_add_ellipse (path, qn_vec2 (n[0], n[1]), qn_vec2 (n[2], 0),
                               qn_vec2 (0, n[2]), from, circle ? from + 2 * G_PI : to);
  if (circle)
    path->count--;
  path->closed = circle;
}

static void
add_ellipse (QnDrawingPath *path, const QnDxfEntity *entity)
{
  const double *n = entity->numbers;
  double from = n[5], to = n[6];
  if (to <= from)
    to += 2 * G_PI;
  gboolean whole = to - from >= 2 * G_PI - 1e-9;
  QnVec2 major = { n[2], n[3] };
  qn_drawing_path_add_ellipse (path, qn_vec2 (n[0], n[1]), major,
                               qn_vec2_scale (n[4], qn_vec2_perp (major)), from,
                               whole ? from + 2 * G_PI : to);
  if (whole)
    path->count--;
  path->closed = whole;
}

static gboolean
add_spline (QnDrawingPath *path, const QnDxfEntity *entity)
{
  gsize n = entity->point_count;
  g_autofree QnVec2 *points = g_new (QnVec2, n);
  g_autofree double *weights = g_new (double, n);
  for (gsize i = 0; i < n; i++) {
    points[i] = qn_vec2 (entity->points[3 * i], entity->points[3 * i + 1]);
    weights[i] = entity->points[3 * i + 2] != 0 ? entity->points[3 * i + 2] : 1;
  }
  path->closed = (entity->flags & 1) != 0;
  guint degree = (guint) qn_to_integer (entity->numbers[0], 0, G_MAXINT);
  return qn_drawing_path_add_spline (path, degree, entity->knots, entity->knot_count,
                                     points, weights, n);
}

/* The entity's own points; FALSE for a curve that makes no sense. */
static gboolean
add_points (QnDrawingPath *path, const QnDxfEntity *entity)
{
  const double *n = entity->numbers;
  switch (entity->kind) {
  case QN_DXF_LINE:
    qn_drawing_path_add (path, qn_vec2 (n[0], n[1]));
    qn_drawing_path_add (path, qn_vec2 (n[2], n[3]));
    return TRUE;
  case QN_DXF_ARC:
    if (!(n[2] > 0) || !isfinite (n[3]) || !isfinite (n[4]) || fabs (n[3]) > 1e6
        || fabs (n[4]) > 1e6)
      return FALSE;
    add_arc (path, entity);
    return TRUE;
  case QN_DXF_ELLIPSE:
    if (fabs (n[5]) > 1e4 || fabs (n[6]) > 1e4)
      return FALSE;
    add_ellipse (path, entity);
    return TRUE;
  case QN_DXF_POLYLINE:
    add_polyline (path, entity);
    return entity->point_count > 0;
  case QN_DXF_SPLINE:
    return add_spline (path, entity);
  case QN_DXF_FACE:
    for (int i = 0; i < 4; i++)
      qn_drawing_path_add (path, qn_vec2 (n[2 * i], n[2 * i + 1]));
    path->closed = TRUE;
    return TRUE;
  case QN_DXF_BLOCK:
  case QN_DXF_BLOCK_END:
  case QN_DXF_INSERT:
    break;
  }
  return FALSE;
}

/* Lines, ellipses and splines are in world coordinates whatever their extrusion. */
static gboolean
is_mirrored (const QnDxfEntity *entity)
{
  return entity->extrusion_z < 0 && entity->kind != QN_DXF_LINE
         && entity->kind != QN_DXF_ELLIPSE && entity->kind != QN_DXF_SPLINE;
}

static void add_entity (Importer *importer, const Entity *entity,
                        const Transform *transform, const char *layer, int depth);

/* One element of the insert's array. */
static Transform
insert_transform (const QnDxfEntity *insert, QnVec2 base, int column, int row)
{
  const double *n = insert->numbers;
  double angle = n[4] * G_PI / 180, c = cos (angle), s = sin (angle);
  double dx = column * n[7], dy = row * n[8];
  Transform t = { c * n[2],
                  -s * n[3],
                  s * n[2],
                  c * n[3],
                  n[0] + c * dx - s * dy,
                  n[1] + s * dx + c * dy };
  QnVec2 shift = apply (&(Transform){ t.xx, t.xy, t.yx, t.yy, 0, 0 }, base);
  t.x0 -= shift.x;
  t.y0 -= shift.y;
  if (insert->extrusion_z < 0) {
    t.xx = -t.xx;
    t.xy = -t.xy;
    t.x0 = -t.x0;
  }
  return t;
}

static void
add_insert (Importer *importer, const Entity *entity, const Transform *transform,
            const char *layer, int depth)
{
  const QnDxfEntity *insert = &entity->data;
  const Definition *definition =
    insert->name != NULL ? g_hash_table_lookup (importer->definitions, insert->name)
                         : NULL;
  QnVec2 at = apply (transform, qn_vec2 (insert->numbers[0], insert->numbers[1]));
  if (definition == NULL || depth >= MAX_DEPTH) {
    qn_drawing_note (importer->drawing,
                     definition == NULL ? _ ("inserts of unknown blocks left out")
                                        : _ ("inserts nested too deeply left out"),
                     entity->source.line, at);
    return;
  }
  int columns = (int) qn_to_integer (insert->numbers[5], 1, MAX_PATHS);
  int rows = (int) qn_to_integer (insert->numbers[6], 1, MAX_PATHS);
  for (int row = 0; row < rows; row++)
    for (int column = 0; column < columns; column++) {
      Transform own = insert_transform (insert, definition->base, column, row);
      Transform all = compose (transform, &own);
      for (guint i = definition->first; i < definition->end; i++) {
        if (importer->drawing->paths->len >= MAX_PATHS || importer->budget == 0)
          return;
        importer->budget--;
        add_entity (importer, &g_array_index (importer->entities, Entity, i), &all, layer,
                    depth + 1);
      }
      if (definition->first == definition->end)
        return;
    }
}

static void
add_entity (Importer *importer, const Entity *entity, const Transform *transform,
            const char *layer, int depth)
{
  const char *own = entity->source.layer;
  if (depth > 0 && strcmp (own, "0") == 0)
    own = layer;
  if (entity->data.kind == QN_DXF_INSERT)
    add_insert (importer, entity, transform, own, depth);
  else {
    QnDrawing *drawing = importer->drawing;
    QnDrawingPath *path = qn_drawing_add_path (drawing, own, entity->source.line);
    gboolean sound = add_points (path, &entity->data);
    for (gsize i = 0; i < path->count; i++) {
      QnVec2 p = path->points[i];
      if (is_mirrored (&entity->data))
        p.x = -p.x;
      path->points[i] = apply (transform, p);
      sound = sound && isfinite (path->points[i].x) && isfinite (path->points[i].y);
    }
    if (!sound) {
      qn_drawing_note (drawing, _ ("invalid curves left out"), entity->source.line,
                       qn_vec2 (NAN, NAN));
      g_free (path->points);
      g_array_set_size (drawing->paths, drawing->paths->len - 1);
    }
  }
}

static void
clear_importer (Importer *importer)
{
  for (guint i = 0; i < importer->entities->len; i++) {
    QnDxfEntity *entity = &g_array_index (importer->entities, Entity, i).data;
    g_free ((double *) entity->points);
    g_free ((double *) entity->knots);
  }
  g_array_unref (importer->entities);
  g_array_unref (importer->top);
  g_hash_table_unref (importer->definitions);
}

gboolean
qn_dxf_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
               GError **error)
{
  QnDxfScan scan;
  qn_drawing_init (drawing);
  if (!qn_dxf_scan (text, length, name, drawing, &scan, error)) {
    qn_drawing_clear (drawing);
    return FALSE;
  }
  Importer importer = { .drawing = drawing,
                        .scan = &scan,
                        .budget = MAX_INSERTED,
                        .entities = g_array_new (FALSE, FALSE, sizeof (Entity)),
                        .top = g_array_new (FALSE, FALSE, sizeof (guint)),
                        .definitions = g_hash_table_new_full (g_str_hash, g_str_equal,
                                                              g_free, g_free) };
  gboolean done = qn_dxf_parse (scan.text->str, scan.text->len, take_entity, &importer);
  for (guint i = 0; done && i < importer.top->len; i++)
    add_entity (
      &importer,
      &g_array_index (importer.entities, Entity, g_array_index (importer.top, guint, i)),
      &identity, "0", 0);
  if (done && (drawing->paths->len >= MAX_PATHS || importer.budget == 0)) {
    done = FALSE;
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: more than %d outlines"), name, MAX_PATHS);
  } else if (!done) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: the DXF reader failed on this file"), name);
  }
  clear_importer (&importer);
  qn_dxf_scan_clear (&scan);
  if (!done)
    qn_drawing_clear (drawing);
  return done;
}
