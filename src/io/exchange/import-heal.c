#include "io/exchange/import-work.h"
#include "io/text/text-format.h"
#include "stereotomy/gaps.h"
#include "stereotomy/polygon-ops.h"

#include <glib/gi18n-lib.h>

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
  qn_import_tell_healing (work, _ ("vertices merged"), &welded);
  qn_import_tell_healing (work, _ ("gaps and overlaps between neighbours closed"),
                          &snapped);
  gsize slivers = qn_import_drop_empty (work);
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
    qn_gaps_close (&rings, work->tolerance, width, &closing);
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
      qn_import_add_outline (work, &bodies.items[i], &mortar);
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
          qn_import_add_outline (work, &parts.items[k], &outline);
      g_array_index (work->outlines, QnOutline, i).ring.count = 0;
    }
  }
  if (cutters.count > 0)
    qn_import_tell (work, FALSE, _ ("openings cut out: %zu, blocks cut or removed: %zu"),
                    cutters.count, changed);
  qn_import_drop_empty (work);
  return status;
}
