#include "io/exchange/import-work.h"
#include "core/base/numbers.h"

#include <glib/gi18n-lib.h>

void
qn_import_tell (QnImportWork *work, gboolean warn, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *line = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_ptr_array_add (work->report->lines, line);
  if (warn)
    g_ptr_array_add (work->report->warnings, g_strdup (line));
}

void
qn_import_tell_healing (QnImportWork *work, const char *what, const QnHealing *healing)
{
  if (healing->count > 0)
    qn_import_tell (work, FALSE, _ ("%s: %zu, by up to %.3g m, first near (%.6g, %.6g)"),
                    what, healing->count, healing->farthest, healing->at.x,
                    healing->at.y);
}

void
qn_import_add_outline (QnImportWork *work, const QnRing *ring, const QnOutline *like)
{
  QnOutline outline = *like;
  outline.ring = qn_ring_of (ring->points, ring->count);
  qn_ring_orient (&outline.ring);
  g_array_append_val (work->outlines, outline);
}

void
qn_import_add_segments (QnImportWork *work, const QnRing *path, gboolean closed,
                        QnRole role)
{
  for (gsize i = 0; i + 1 < path->count + (closed ? 1 : 0); i++)
    qn_segments_add (&work->soups[role], path->points[i],
                     path->points[(i + 1) % path->count]);
}

gsize
qn_import_drop_empty (QnImportWork *work)
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

double
qn_import_median (GArray *values)
{
  g_array_sort (values, qn_compare_doubles);
  return values->len > 0 ? g_array_index (values, double, values->len / 2) : 0;
}
