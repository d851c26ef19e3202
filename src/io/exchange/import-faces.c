#include "core/base/box-tree.h"
#include "core/base/polygon.h"
#include "io/exchange/import-work.h"

#include <glib/gi18n-lib.h>

/* Faces of line work so many times larger than the median are perhaps openings. */
#define SUSPICIOUS_SIZE 4.0

/* A line along a side is at most so far from its direction (sine), that across it farther. */
#define MOST_SLANT 0.2

static gboolean
lies_in_outline (const QnImportWork *work, QnVec2 point, guint count)
{
  for (guint i = 0; i < count; i++) {
    const QnRing *ring = &g_array_index (work->outlines, QnOutline, i).ring;
    QnBox b = qn_ring_bounds (ring);
    if (point.x >= b.min.x && point.x <= b.max.x && point.y >= b.min.y
        && point.y <= b.max.y && qn_polygon_depth (ring->points, ring->count, point) > 0)
      return TRUE;
  }
  return FALSE;
}

/* Warns of faces that are much larger than the others. */
static void
look_for_openings (QnImportWork *work, const QnRings *faces)
{
  g_autoptr (GArray) areas = g_array_new (FALSE, FALSE, sizeof (double));
  for (gsize i = 0; i < faces->count; i++) {
    double area = qn_ring_area (&faces->items[i]);
    g_array_append_val (areas, area);
  }
  double median = qn_import_median (areas);
  gsize count = 0;
  QnVec2 at = { 0, 0 };
  for (gsize i = 0; i < faces->count; i++)
    if (qn_ring_area (&faces->items[i]) > SUSPICIOUS_SIZE * median) {
      if (count++ == 0)
        at = qn_ring_centroid (&faces->items[i]);
    }
  if (count > 0)
    qn_import_tell (
      work, TRUE,
      _ ("faces much larger than the others, perhaps openings or the ground: %zu, "
         "first at "
         "(%.6g, %.6g); outlines on a layer OPENINGS cut them out"),
      count, at.x, at.y);
}

/* Whether a face is bounded by open lines at all, and not only by outlines around it. */
static gboolean
touches_lines (const QnImportWork *work, const QnBoxTree *tree, const QnSegments *lines,
               const QnRing *face)
{
  for (gsize i = 0; i < face->count; i++) {
    QnVec2 a = face->points[i], b = face->points[(i + 1) % face->count];
    QnVec2 middle = qn_vec2_lerp (a, b, 0.5);
    QnBoxQuery query =
      qn_box_tree_query (tree, qn_box_grow ((QnBox){ middle, middle }, work->tolerance));
    for (QnId k; (k = qn_box_query_next (&query)) != QN_NONE;)
      if (qn_segment_distance (lines->items[k].a, lines->items[k].b, middle)
          <= work->tolerance)
        return TRUE;
  }
  return FALSE;
}

/* Warns of open lines beside every outline, which a joint drawn across a closed outline is, and a block
 * whose line does not come back to its beginning. */
static void
tell_of_idle_lines (QnImportWork *work, const QnBoxTree *tree, const QnSegments *lines)
{
  g_autofree gboolean *used = g_new0 (gboolean, lines->count);
  for (guint i = 0; i < work->outlines->len; i++) {
    const QnRing *ring = &g_array_index (work->outlines, QnOutline, i).ring;
    for (gsize s = 0; s < ring->count; s++) {
      QnVec2 a = ring->points[s], b = ring->points[(s + 1) % ring->count];
      QnBoxQuery query =
        qn_box_tree_query (tree, qn_box_grow (qn_box_of_segment (a, b), work->tolerance));
      for (QnId k; (k = qn_box_query_next (&query)) != QN_NONE;) {
        QnVec2 c = lines->items[k].a, d = lines->items[k].b;
        QnVec2 along = qn_vec2_sub (b, a), line = qn_vec2_sub (d, c);
        gboolean meets =
          qn_segment_distance (a, b, qn_vec2_lerp (c, d, 0.5)) <= work->tolerance
          || qn_segment_distance (c, d, qn_vec2_lerp (a, b, 0.5)) <= work->tolerance;
        if (meets
            && fabs (qn_vec2_cross (along, line))
                 <= MOST_SLANT * qn_vec2_length (along) * qn_vec2_length (line))
          used[k] = TRUE;
      }
    }
  }
  double length = 0;
  QnVec2 at = { 0, 0 };
  for (gsize k = 0; k < lines->count; k++)
    if (!used[k]) {
      if (length == 0)
        at = qn_vec2_lerp (lines->items[k].a, lines->items[k].b, 0.5);
      length += qn_vec2_length (qn_vec2_sub (lines->items[k].b, lines->items[k].a));
    }
  if (length > work->tolerance)
    qn_import_tell (work, TRUE,
                    _ ("open lines that bound no block left out: %.3g m of them, first "
                       "near (%.6g, %.6g)"),
                    length, at.x, at.y);
}

/* Turns the faces that lie in no outline and are bounded by open lines, of which there are
 * `lines`, into outlines. */
static void
take_faces (QnImportWork *work, QnRole role, const QnRings *faces,
            const QnSegments *lines, guint outlines)
{
  QnBoxTree tree;
  g_auto (QnPool) room = { 0 };
  qn_segments_tree (lines, 0, &tree, &room);
  for (gsize i = 0; i < faces->count; i++) {
    const QnRing *face = &faces->items[i];
    QnVec2 inner = qn_polygon_inner_point (face->points, face->count);
    if (!lies_in_outline (work, inner, outlines)
        && touches_lines (work, &tree, lines, face))
      qn_import_add_outline (work, face, &(QnOutline){ .role = role });
  }
  tell_of_idle_lines (work, &tree, lines);
}

QnStatus
qn_import_take_faces (QnImportWork *work, QnRole role, QnDiag *diag)
{
  QnSegments *soup = &work->soups[role];
  if (soup->count == 0)
    return QN_OK;
  guint outlines = work->outlines->len;
  g_auto (QnSegments) lines = { 0 };
  for (gsize i = 0; i < soup->count; i++)
    qn_segments_add (&lines, soup->items[i].a, soup->items[i].b);
  for (guint i = 0; i < outlines; i++) {
    const QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    if (outline->role == role)
      qn_import_add_segments (work, &outline->ring, TRUE, role);
  }
  g_auto (QnRings) faces = { 0 };
  QnHealing healing = { 0 };
  gsize holes = 0;
  QnStatus status =
    qn_linework_polygonize (soup, work->tolerance, &faces, &holes, &healing, diag);
  qn_import_tell_healing (work, _ ("ends of lines joined"), &healing);
  if (holes > 0)
    qn_import_tell (work, TRUE, _ ("faces around other faces left out: %zu"), holes);
  if (status == QN_OK)
    take_faces (work, role, &faces, &lines, outlines);
  if (role == QN_ROLE_BLOCK && outlines == 0)
    look_for_openings (work, &faces);
  return status;
}
