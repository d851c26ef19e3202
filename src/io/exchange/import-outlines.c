/* Outlines on their way to blocks: from paths and faces of line work, mended, with gaps and openings. */
#include "core/base/box-tree.h"
#include "core/base/polygon.h"
#include "io/exchange/import-work.h"
#include "io/text/text-format.h"
#include "stereotomy/gaps.h"
#include "stereotomy/linework.h"
#include "stereotomy/polygon-ops.h"

#include <glib/gi18n-lib.h>

/* Faces of line work so many times larger than the median are perhaps openings. */
#define SUSPICIOUS_SIZE 4.0

/* A line along a side is at most so far from its direction (sine), that across it farther. */
#define MOST_SLANT 0.2

/* "`what`: how often, how far, where"; nothing where nothing was healed. */
static void
tell_healing (QnImportWork *work, const char *what, const QnHealing *healing)
{
  if (healing->count > 0)
    qn_import_tell (work, FALSE, _ ("%s: %zu, by up to %.3g m, first near (%.6g, %.6g)"),
                    what, healing->count, healing->farthest, healing->at.x,
                    healing->at.y);
}

/* Adds a copy of a ring (m), turned counter-clockwise; all else is as of `like`. */
static void
add_outline (QnImportWork *work, const QnRing *ring, const QnOutline *like)
{
  QnOutline outline = *like;
  outline.ring = qn_ring_of (ring->points, ring->count);
  qn_ring_orient (&outline.ring);
  g_array_append_val (work->outlines, outline);
}

/* Adds the sides of a path (m) to the line work of a role. */
static void
add_segments (QnImportWork *work, const QnRing *path, gboolean closed, QnRole role)
{
  for (gsize i = 0; i + 1 < path->count + (closed ? 1 : 0); i++)
    qn_segments_add (&work->soups[role], path->points[i],
                     path->points[(i + 1) % path->count]);
}

/* Removes the outlines of fewer than three vertices, and so those whose count was set to 0; keeps the order.
 * Returns the number removed. */
static gsize
drop_empty (QnImportWork *work)
{
  guint count = work->outlines->len, kept = 0;
  for (guint i = 0; i < count; i++) {
    QnOutline outline = g_array_index (work->outlines, QnOutline, i);
    if (outline.ring.count >= 3)
      g_array_index (work->outlines, QnOutline, kept++) = outline;
    else
      qn_ring_clear (&outline.ring);
  }
  g_array_set_size (work->outlines, kept);
  return count - kept;
}

/* ---- paths ---- */

/* A point of the drawing, m. Decimal fractions keep their digits when divided by a power of ten. */
static QnVec2
to_metres (const QnImportWork *work, QnVec2 p)
{
  double per_metre = round (1 / work->unit);
  if (per_metre > 1 && fabs (per_metre * work->unit - 1) < 1e-12)
    return qn_vec2 (p.x / per_metre, p.y / per_metre);
  return qn_vec2_scale (work->unit, p);
}

/* Cuts the ring where it comes back to its beginning. FALSE for an open path. */
static gboolean
close_ring (QnImportWork *work, QnRing *ring, gboolean closed, gsize *ends,
            gsize *overruns)
{
  /* The points from `last` on run along the beginning again; that before it does not along the first
   * `apart` sides. */
  gsize last = ring->count, apart = 0;
  const QnVec2 *p = ring->points;
  for (gsize i = 3; i < ring->count; i++) {
    if (qn_vec2_length (qn_vec2_sub (p[i], p[0])) > work->tolerance)
      continue;
    while (last > i + 1 && apart < i) {
      gboolean again =
        qn_segment_distance (p[apart], p[apart + 1], p[last - 1]) <= work->tolerance;
      apart = again ? 0 : apart + 1;
      last -= again ? 1 : 0;
    }
    if (last > i + 1)
      continue;
    if (i + 1 < ring->count)
      (*overruns)++;
    else if (!closed)
      (*ends)++;
    ring->count = i;
    return TRUE;
  }
  return closed && ring->count >= 3;
}

void
qn_import_sort_paths (QnImportWork *work)
{
  gsize ends = 0, overruns = 0, collinear = 0, open = 0;
  for (guint i = 0; i < work->drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (work->drawing->paths, QnDrawingPath, i);
    guint number = GPOINTER_TO_UINT (g_hash_table_lookup (work->layers, path->layer));
    const QnImportLayer *layer =
      &g_array_index (work->report->layers, QnImportLayer, number - 1);
    QnRole role = path->support ? QN_ROLE_SUPPORT : layer->role;
    if (role == QN_ROLE_IGNORED || (path->hidden && !layer->asked))
      continue;
    g_auto (QnRing) ring = qn_ring_of (path->points, path->count);
    for (gsize k = 0; k < ring.count; k++)
      ring.points[k] = to_metres (work, ring.points[k]);
    if (close_ring (work, &ring, path->closed, &ends, &overruns)) {
      collinear += qn_ring_simplify (&ring, 1e-6 * work->tolerance);
      if (ring.count >= 3)
        add_outline (work, &ring,
                     &(QnOutline){ .role = role,
                                   .density = path->density,
                                   .thickness = path->thickness * work->unit,
                                   .line = path->line });
    } else if (ring.count >= 2) {
      open++;
      add_segments (work, &ring, FALSE, role);
    }
  }
  if (ends > 0)
    qn_import_tell (work, FALSE, _ ("outlines closed that end where they began: %zu"),
                    ends);
  if (overruns > 0)
    qn_import_tell (work, FALSE,
                    _ ("outlines closed that ended beyond their beginning: %zu"),
                    overruns);
  if (collinear > 0)
    qn_import_tell (work, FALSE, _ ("repeated and collinear vertices removed: %zu"),
                    collinear);
  if (open > 0)
    qn_import_tell (work, FALSE, _ ("open lines made into faces: %zu"), open);
}

void
qn_import_drop_flawed (QnImportWork *work)
{
  gsize crossing = 0, flat = 0;
  guint first_crossing = 0; /* line of the file */
  for (guint i = 0; i < work->outlines->len; i++) {
    QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    QnPolygonFlaw flaw = qn_polygon_check (outline->ring.points, outline->ring.count);
    qn_require_memory (flaw.problem != QN_PROBLEM_NO_MEMORY);
    if (flaw.problem == QN_PROBLEM_NONE)
      continue;
    if (flaw.problem != QN_PROBLEM_SELF_CROSSING)
      flat++;
    else if (crossing++ == 0)
      first_crossing = outline->line;
    outline->ring.count = 0;
  }
  drop_empty (work);
  if (crossing > 0)
    qn_import_tell (work, TRUE,
                    _ ("outlines left out that cross themselves: %zu, first at line %u"),
                    crossing, first_crossing);
  if (flat > 0)
    qn_import_tell (work, FALSE, _ ("outlines without area left out: %zu"), flat);
}

void
qn_import_drop_repeated (QnImportWork *work)
{
  g_autoptr (GHashTable) keys =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  for (guint i = 0; i < work->outlines->len; i++) {
    QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    const QnVec2 c = qn_ring_centroid (&outline->ring);
    const double t = 2 * work->tolerance,
                 size = sqrt (fabs (qn_ring_area (&outline->ring)));
    if (outline->role != QN_ROLE_OPENING
        && !g_hash_table_add (
          keys, g_strdup_printf ("%.0f %.0f %.0f", c.x / t, c.y / t, size / t)))
      outline->ring.count = 0;
  }
  gsize repeated = drop_empty (work);
  if (repeated > 0)
    qn_import_tell (work, FALSE, _ ("outlines drawn twice: %zu"), repeated);
}

/* ---- faces of line work ---- */

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
      add_segments (work, &outline->ring, TRUE, role);
  }
  g_auto (QnRings) faces = { 0 };
  QnHealing healing = { 0 };
  gsize holes = 0;
  QnStatus status =
    qn_linework_polygonize (soup, work->tolerance, &faces, &holes, &healing, diag);
  tell_healing (work, _ ("ends of lines joined"), &healing);
  if (holes > 0)
    qn_import_tell (work, TRUE, _ ("faces around other faces left out: %zu"), holes);
  if (status == QN_OK) {
    /* Faces that lie in no outline and are bounded by open lines are outlines. */
    QnBoxTree tree;
    g_auto (QnPool) room = { 0 };
    qn_segments_tree (&lines, 0, &tree, &room);
    for (gsize i = 0; i < faces.count; i++) {
      const QnRing *face = &faces.items[i];
      QnVec2 inner = qn_polygon_inner_point (face->points, face->count);
      if (!lies_in_outline (work, inner, outlines)
          && touches_lines (work, &tree, &lines, face))
        add_outline (work, face, &(QnOutline){ .role = role });
    }
    tell_of_idle_lines (work, &tree, &lines);
  }
  if (role == QN_ROLE_BLOCK && outlines == 0)
    look_for_openings (work, &faces);
  return status;
}

/* ---- neighbours, gaps and openings ---- */

/* Moves the rings of blocks and supports out of the outlines, or those that were moved back. */
static void
exchange_rings (QnImportWork *work, QnRings *rings, gboolean out)
{
  gsize next = 0;
  for (guint i = 0; i < work->outlines->len; i++) {
    QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    if (outline->role == QN_ROLE_OPENING)
      continue;
    if (out) {
      qn_rings_take (rings, &outline->ring);
    } else if (next < rings->count) {
      outline->ring = rings->items[next];
      rings->items[next++] = (QnRing){ 0 };
    }
  }
}

void
qn_import_heal (QnImportWork *work)
{
  g_auto (QnRings) rings = { 0 };
  QnHealing welded = { 0 }, snapped = { 0 };
  exchange_rings (work, &rings, TRUE);
  qn_weld_vertices (&rings, 1e-6 * work->tolerance, work->tolerance, NULL, &welded);
  qn_snap_neighbours (&rings, work->tolerance, &snapped);
  exchange_rings (work, &rings, FALSE);
  tell_healing (work, _ ("vertices merged"), &welded);
  tell_healing (work, _ ("gaps and overlaps between neighbours closed"), &snapped);
  gsize slivers = drop_empty (work);
  if (slivers > 0)
    qn_import_tell (work, FALSE, _ ("slivers left out: %zu"), slivers);
}

/* How many, how wide, and what was done with them. */
static void
tell_gaps (QnImportWork *work, const QnGapClosing *closing)
{
  QnImportReport *report = work->report;
  gsize count = report->gaps.count;
  double least, mean, most;
  for (gsize i = 0; i < count; i++)
    report->widest_gap = fmax (report->widest_gap, report->gaps.items[i].width);
  qn_gaps_widths (&report->gaps, &least, &mean, &most);
  g_autofree char *widths = qn_widths_dup_text (least, mean, most);
  switch (work->settings->gaps) {
  case QN_GAPS_CLOSED:
    qn_import_tell (work, FALSE,
                    _ ("joints of mortar: %zu, %s wide; closed: blocks grew to "
                       "their middle, by %.3g m² in all"),
                    count, widths, closing->grown);
    if (closing->left > 0)
      qn_import_tell (
        work, TRUE,
        _ ("joints of mortar that could not be closed: %zu, first near (%.6g, %.6g)"),
        closing->left, closing->left_at.x, closing->left_at.y);
    break;
  case QN_GAPS_FILLED:
    qn_import_tell (work, FALSE,
                    _ ("joints of mortar: %zu, %s wide; each became a block"), count,
                    widths);
    break;
  case QN_GAPS_OPEN:
  case QN_GAPS_TREATMENT_COUNT:
    qn_import_tell (work, TRUE,
                    _ ("joints of mortar: %zu, %s wide; left open, so that "
                       "blocks do not touch there"),
                    count, widths);
    break;
  }
}

void
qn_import_treat_gaps (QnImportWork *work)
{
  g_auto (QnRings) rings = { 0 };
  QnGapClosing closing = { 0 };
  QnGapTreatment treatment = work->settings->gaps;
  exchange_rings (work, &rings, TRUE);
  double width = work->settings->gap_width;
  if (!(width > 0))
    width = qn_gaps_usual_width (&rings);
  qn_gaps_find (&rings, work->tolerance, width, &work->report->gaps);
  gboolean any = work->report->gaps.count > 0;
  if (any && treatment == QN_GAPS_CLOSED)
    closing = qn_gaps_close (&rings, work->tolerance, width);
  exchange_rings (work, &rings, FALSE);
  if (any && treatment == QN_GAPS_FILLED) {
    /* A block for every gap; openings are no blocks. */
    g_auto (QnRings) bodies = { 0 };
    QnOutline mortar = { .role = QN_ROLE_BLOCK };
    for (guint i = 0; i < work->outlines->len; i++)
      mortar.thickness =
        fmax (mortar.thickness, g_array_index (work->outlines, QnOutline, i).thickness);
    qn_gaps_fill (&work->report->gaps, &bodies);
    for (gsize i = 0; i < bodies.count; i++)
      add_outline (work, &bodies.items[i], &mortar);
    work->has_mortar = TRUE;
  }
  if (any)
    tell_gaps (work, &closing);
}

QnStatus
qn_import_cut_openings (QnImportWork *work, QnDiag *diag)
{
  g_auto (QnRings) cutters = { 0 };
  gsize changed = 0;
  for (guint i = 0; i < work->outlines->len; i++) {
    QnOutline *outline = &g_array_index (work->outlines, QnOutline, i);
    if (outline->role != QN_ROLE_OPENING)
      continue;
    qn_rings_add (&cutters, outline->ring.points, outline->ring.count);
    outline->ring.count = 0;
  }
  QnStatus status = QN_OK;
  guint count = work->outlines->len;
  for (guint i = 0; cutters.count > 0 && i < count && status == QN_OK; i++) {
    QnOutline outline = g_array_index (work->outlines, QnOutline, i);
    if (outline.role == QN_ROLE_OPENING)
      continue;
    g_auto (QnRings) parts = { 0 };
    double area = qn_ring_area (&outline.ring), left = 0;
    status = qn_polygon_difference (&outline.ring, &cutters, &parts, diag);
    for (gsize k = 0; k < parts.count; k++)
      left += qn_ring_area (&parts.items[k]);
    /* What is left along the edge of an opening within the tolerance is no block. */
    if (status == QN_OK && left < area * (1 - 1e-9)) {
      changed++;
      for (gsize k = 0; k < parts.count; k++)
        if (2 * qn_ring_area (&parts.items[k])
            > work->tolerance * qn_ring_perimeter (&parts.items[k]))
          add_outline (work, &parts.items[k], &outline);
      g_array_index (work->outlines, QnOutline, i).ring.count = 0;
    }
  }
  if (cutters.count > 0)
    qn_import_tell (work, FALSE, _ ("openings cut out: %zu, blocks cut or removed: %zu"),
                    cutters.count, changed);
  drop_empty (work);
  return status;
}
