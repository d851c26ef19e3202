#include "core/base/polygon.h"
#include "io/exchange/import-work.h"

#include <glib/gi18n-lib.h>

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
      ring.points[k] = qn_import_to_metres (work, ring.points[k]);
    if (close_ring (work, &ring, path->closed, &ends, &overruns)) {
      collinear += qn_ring_simplify (&ring, 1e-6 * work->tolerance);
      if (ring.count >= 3)
        qn_import_add_outline (work, &ring,
                               &(QnOutline){ .role = role,
                                             .density = path->density,
                                             .thickness = path->thickness * work->unit,
                                             .line = path->line });
    } else if (ring.count >= 2) {
      open++;
      qn_import_add_segments (work, &ring, FALSE, role);
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
  qn_import_drop_empty (work);
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
  gsize repeated = qn_import_drop_empty (work);
  if (repeated > 0)
    qn_import_tell (work, FALSE, _ ("outlines drawn twice: %zu"), repeated);
}
