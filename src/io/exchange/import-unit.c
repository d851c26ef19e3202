#include "io/exchange/import-work.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Sizes of blocks, m, that a drawing may have in the unit it declares. */
#define SMALLEST_BLOCK 0.03
#define LARGEST_BLOCK  4.0

double
qn_import_unit (const char *name)
{
  static const struct {
    const char *name;
    double metres;
  } units[] = { { "mm", 0.001 }, { "cm", 0.01 },   { "dm", 0.1 },
                { "m", 1 },      { "in", 0.0254 }, { "ft", 0.3048 } };
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (strcmp (units[i].name, name) == 0)
      return units[i].metres;
  return 0;
}

double
qn_import_block_size (const QnDrawing *drawing)
{
  g_autoptr (GArray) sizes = g_array_new (FALSE, FALSE, sizeof (double));
  for (int pass = 0; pass < 2 && sizes->len == 0; pass++)
    for (guint i = 0; i < drawing->paths->len; i++) {
      const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
      if (path->hidden)
        continue;
      QnRing ring = { path->points, path->count };
      double size = pass == 1 ? qn_box_size (qn_ring_bounds (&ring))
                    : path->count >= 4 || path->closed
                      ? sqrt (fabs (qn_ring_area (&ring)))
                      : 0;
      if (size > 0)
        g_array_append_val (sizes, size);
    }
  return qn_import_median (sizes);
}

static gboolean
is_plausible (double size)
{
  return size >= SMALLEST_BLOCK && size <= LARGEST_BLOCK;
}

void
qn_import_choose_unit (QnImportWork *work)
{
  static const double guesses[] = { 1, 0.001, 0.01 };
  static const char *const names[] = { "m", "mm", "cm" };
  const QnDrawing *drawing = work->drawing;
  double size = qn_import_block_size (drawing), declared = drawing->unit;
  QnBox bounds = QN_BOX_EMPTY;
  for (guint i = 0; i < drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
    if (!path->hidden)
      qn_box_add_box (&bounds, qn_box_of_points (path->points, path->count));
  }
  double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  work->unit = work->settings->unit;
  if (work->unit > 0) {
    qn_import_tell (work, FALSE, _ ("unit: %g m as given; extents %.6g x %.6g m"),
                    work->unit, width * work->unit, height * work->unit);
    return;
  }
  if (size == 0) { /* nothing to see */
    work->unit = declared > 0 ? declared : 1;
    return;
  }
  if (declared > 0 && is_plausible (size * declared)) {
    work->unit = declared;
    qn_import_tell (work, FALSE,
                    _ ("unit: %g m as the file declares; extents %.6g x %.6g m"),
                    declared, width * declared, height * declared);
    return;
  }
  gsize guess = 0;
  while (guess < G_N_ELEMENTS (guesses) && !is_plausible (size * guesses[guess]))
    guess++;
  gboolean fits = guess < G_N_ELEMENTS (guesses);
  work->unit = fits ? guesses[guess] : declared > 0 ? declared : 1;
  if (declared > 0 && fits)
    qn_import_tell (
      work, TRUE,
      _ ("unit: the file declares %g m, which would make blocks of about %.3g m; "
         "read as %s "
         "instead, extents %.6g x %.6g m (--unit decides)"),
      declared, size * declared, names[guess], width * work->unit, height * work->unit);
  else if (fits)
    qn_import_tell (
      work, TRUE,
      _ ("unit: not declared; read as %s from its extents, %.6g x %.6g m (--unit "
         "decides)"),
      names[guess], width * work->unit, height * work->unit);
  else
    qn_import_tell (
      work, TRUE,
      _ ("unit: blocks of about %.3g m are not plausible in any unit; read as %g m "
         "(--unit decides)"),
      size * work->unit, work->unit);
}

/* Decimal fractions keep their digits when divided by a power of ten. */
QnVec2
qn_import_to_metres (const QnImportWork *work, QnVec2 p)
{
  double per_metre = round (1 / work->unit);
  if (per_metre > 1 && fabs (per_metre * work->unit - 1) < 1e-12)
    return qn_vec2 (p.x / per_metre, p.y / per_metre);
  return qn_vec2_scale (work->unit, p);
}
