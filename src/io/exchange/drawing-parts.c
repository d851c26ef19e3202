/* Shapes of several parts: holes, and what others cover. */
#include "core/base/polygon.h"
#include "io/exchange/drawing.h"
#include "io/text/io-error.h"
#include "stereotomy/polygon-ops.h"

#include <glib/gi18n-lib.h>

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
