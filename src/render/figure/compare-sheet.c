#include "render/figure/compare-sheet.h"

#include "core/base/integer.h"
#include "core/result/mechanism.h"
#include "render/backend/draw-cairo.h"
#include "render/drawing/text.h"
#include "render/figure/figure-furniture.h"
#include "render/figure/figure.h"

#include <gio/gio.h>
#include <glib/gi18n-lib.h>

/* Space around the sheet and between its parts, pt. */
#define SHEET_MARGIN   10.0
#define SHEET_CELL_GAP 12.0
/* Between the foot of a structure and the words beneath it: room for symbols at the foot. */
#define FOOT_GAP 4.0

typedef struct SheetLayout {
  const QnCompareSheet *sheet;
  const QnPage *page;
  cairo_t *cr;
  GPtrArray *scenes;               /* of QnScene */
  QnScene *legend;                 /* an empty scene with the legend of all */
  double left, top, width, height; /* of the grid, px */
  int columns, rows;
  double words; /* px under each picture */
  double scale; /* px per m, of all pictures */
  QnId *groups; /* of the figures: see qn_compare_sheet_groups() */
} SheetLayout;

/* ---- groups of mechanisms --------------------------------------------------------------- */

static bool
has_mechanism (const QnFigure *figure)
{
  return figure->result != NULL && figure->result->mechanism != NULL;
}

/* Whether two models have the same blocks in the same places. */
static bool
is_same_structure (const QnModel *a, const QnModel *b)
{
  double tolerance = 1e-6 * a->characteristic_length;
  if (a->block_count != b->block_count)
    return false;
  for (size_t i = 0; i < a->block_count; i++) {
    QnVec2 apart = qn_vec2_sub (a->blocks[i].centroid, b->blocks[i].centroid);
    if (qn_vec2_length (apart) > tolerance
        || fabs (a->blocks[i].area - b->blocks[i].area) > tolerance * tolerance)
      return false;
  }
  return true;
}

bool
qn_compare_sheet_groups (const QnFigure *figures, size_t count, QnId *groups)
{
  g_autofree const double **fields = g_new (const double *, count);
  g_autofree size_t *members = g_new (size_t, count);
  g_autofree int32_t *clusters = g_new (int32_t, count);
  g_autofree bool *seen = g_new0 (bool, count);
  QnId next = 0;

  for (size_t i = 0; i < count; i++)
    groups[i] = QN_NONE;
  for (size_t i = 0; i < count; i++) {
    int32_t alike = 0;
    for (size_t k = i; k < count && !seen[i]; k++)
      if (!seen[k] && has_mechanism (&figures[k])
          && is_same_structure (figures[i].model, figures[k].model)) {
        members[alike] = k;
        fields[alike++] = figures[k].result->mechanism;
      }
    if (!has_mechanism (&figures[i]) || alike < 2)
      continue;
    int32_t found =
      qn_mechanism_cluster (figures[i].model, fields, alike, QN_ALIKE_COSINE, clusters);
    if (found <= 0)
      return false;
    for (int32_t k = 0; k < alike; k++) {
      groups[members[k]] = next + clusters[k];
      seen[members[k]] = true;
    }
    next += found;
  }
  return true;
}

/* The words under a figure, with its group where it has one: A, B, … Z, 27, 28, … */
static char *
dup_caption (const SheetLayout *s, size_t index)
{
  const QnFigure *figure = &s->sheet->figures[index];
  if (figure->caption != NULL)
    return g_strdup (figure->caption);
  char *own = qn_figure_dup_caption (figure, g_ptr_array_index (s->scenes, index), true);
  QnId group = s->groups[index];
  if (group == QN_NONE)
    return own;
  g_autofree char *caption = own;
  g_autofree char *letter =
    group < 26 ? g_strdup_printf ("%c", 'A' + group) : g_strdup_printf ("%d", group + 1);
  g_autofree char *name = g_strdup_printf (_ ("group %s"), letter);
  return g_strdup_printf ("%s · %s", caption, name);
}

/* ---- layout ----------------------------------------------------------------------------- */

/* Height of the tallest structure in a row, m. */
static double
tallest_in_row (const SheetLayout *s, int columns, int row)
{
  double tallest = 0;
  guint first = (guint) (row * columns),
        end = MIN (first + (guint) columns, s->scenes->len);
  for (guint i = first; i < end; i++) {
    const QnScene *scene = g_ptr_array_index (s->scenes, i);
    tallest = fmax (tallest, scene->box.max.y - scene->box.min.y);
  }
  return tallest;
}

/* Where a picture goes. Rows share the height as their tallest structures need it: a sheet of
 * low and high walls has no empty bands. */
static QnCamera
cell_viewport (const SheetLayout *s, size_t cell, int columns, int rows)
{
  double gap = SHEET_CELL_GAP * s->page->unit, foot = s->words + FOOT_GAP * s->page->unit;
  double width = (s->width - (columns - 1) * gap) / columns;
  double pictures = fmax (s->height - (rows - 1) * gap - rows * foot, 1), total = 0;
  int column = (int) cell % columns, row = (int) cell / columns;
  for (int r = 0; r < rows; r++)
    total += tallest_in_row (s, columns, r);

  double y = s->top, height = 0;
  for (int r = 0; r <= row; r++) {
    double part = total > 0 ? tallest_in_row (s, columns, r) / total : 1.0 / rows;
    y += r > 0 ? height + foot + gap : 0;
    height = pictures * part;
  }
  return (QnCamera){ .x = s->left + column * (width + gap),
                     .y = y,
                     .width = fmax (width, 1),
                     .height = fmax (height, 1),
                     .scale = 1,
                     .unit = s->page->unit };
}

/* The largest scale at which every scene fits its cell. */
static double
common_scale (const SheetLayout *s, int columns, int rows)
{
  double scale = (double) INFINITY;
  for (guint i = 0; i < s->scenes->len; i++) {
    QnCamera view = cell_viewport (s, i, columns, rows);
    qn_scene_fit (&view, g_ptr_array_index (s->scenes, i), s->cr, 0);
    scale = fmin (scale, view.scale);
  }
  return scale;
}

/* Draws title and caption under a picture, centred about x, or only measures them; returns their
 * height, px. */
static double
lay_words (const SheetLayout *s, size_t index, double width, double x, double y,
           bool draw)
{
  const QnFigure *figure = &s->sheet->figures[index];
  const double u = s->page->unit;
  QnColor ink = qn_ink (QN_INK_LINE, figure->options.monochrome);
  QnTextStyle bold = { .size = 8.5 * u, .bold = true, .width = width };
  QnTextStyle plain = { .size = QN_TYPE_LEGEND * u, .width = width };
  const char *title = qn_figure_title (figure);
  g_autofree char *caption = dup_caption (s, index);
  double w, above = 0, below;
  if (title != NULL && *title != '\0') {
    qn_text_measure (s->cr, &bold, title, &w, &above);
    if (draw)
      qn_text_draw (s->cr, &bold, title, x, y, 0.5, 0, 0, ink);
  }
  qn_text_measure (s->cr, &plain, caption, &w, &below);
  if (draw)
    qn_text_draw (s->cr, &plain, caption, x, y + above, 0.5, 0, 0, ink);
  return above + below;
}

static void
draw_sheet (SheetLayout *s)
{
  double u = s->page->unit, margin = SHEET_MARGIN * u;
  s->left = margin;
  s->top = margin;
  s->width = s->page->width - 2 * margin;
  s->height = s->page->height - 2 * margin;
  if (s->sheet->title != NULL && *s->sheet->title != '\0') {
    QnTextStyle style = { .size = 11 * u, .bold = true, .width = s->width };
    double width, height;
    qn_text_measure (s->cr, &style, s->sheet->title, &width, &height);
    qn_text_draw (s->cr, &style, s->sheet->title, s->left, s->top, 0, 0, 0,
                  qn_ink (QN_INK_LINE, s->legend->monochrome));
    s->top += height + 8 * u;
    s->height -= height + 8 * u;
  }

  QnFurniture furniture;
  qn_furniture_init (&furniture, s->legend, s->cr, u, s->width, true);
  furniture.width = s->width;
  furniture.height = qn_furniture_row_height (&furniture, s->width);
  bool legend = s->sheet->figures[0].options.legend && furniture.height < 0.4 * s->height;
  if (legend)
    s->height -= furniture.height + 10 * u;
  furniture.x = s->left;
  furniture.y = s->page->height - margin - furniture.height;

  int guess =
    s->sheet->columns > 0
      ? s->sheet->columns
      : (int) qn_to_integer (ceil (sqrt ((double) s->sheet->count)), 1, G_MAXINT16);
  double cell = (s->width - (MAX (guess, 1) - 1) * SHEET_CELL_GAP * u) / MAX (guess, 1);
  for (size_t i = 0; i < s->sheet->count; i++)
    s->words = fmax (s->words, lay_words (s, i, cell, 0, 0, false));
  int count = (int) s->sheet->count;
  int first = s->sheet->columns > 0 ? MIN (s->sheet->columns, count) : 1;
  int last = s->sheet->columns > 0 ? first : MIN (count, 12);
  for (int columns = first; columns <= last; columns++) {
    int rows = (count + columns - 1) / columns;
    double scale = common_scale (s, columns, rows);
    if (scale > s->scale * (1 + 1e-9)) {
      s->scale = scale;
      s->columns = columns;
      s->rows = rows;
    }
  }
  for (guint i = 0; i < s->scenes->len; i++) {
    const QnScene *scene = g_ptr_array_index (s->scenes, i);
    QnCamera view = cell_viewport (s, i, s->columns, s->rows);
    qn_scene_fit (&view, scene, s->cr, s->scale);
    /* The structures of a row stand on one ground. */
    QnVec2 foot = qn_camera_to_screen (&view, scene->box.min);
    view.center.y += (view.y + view.height - foot.y) / view.scale;
    view.height += FOOT_GAP * view.unit;
    view.center.y -= 0.5 * FOOT_GAP * view.unit / view.scale;
    qn_draw_cairo (scene, &view, QN_LAYERS_ALL, s->cr);
    lay_words (s, i, view.width, view.x + 0.5 * view.width, view.y + view.height, true);
  }
  if (legend)
    qn_furniture_draw (&furniture, s->cr, s->scale, false);
  qn_furniture_clear (&furniture);
}

static bool
draw_sheet_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  const QnCompareSheet *sheet = data;
  g_autoptr (GPtrArray) scenes =
    g_ptr_array_new_with_free_func ((GDestroyNotify) qn_scene_free);
  for (size_t i = 0; i < sheet->count; i++) {
    const QnFigure *figure = &sheet->figures[i];
    QnViewOptions options = figure->options;
    options.counts = false; /* one legend is of all pictures */
    QnScene *scene =
      qn_scene_build (figure->model, figure->contacts, figure->result, &options, error);
    if (scene == NULL) {
      const char *title = qn_figure_title (figure);
      g_prefix_error (error, "%s: ", title != NULL ? title : _ ("untitled"));
      return false;
    }
    g_ptr_array_add (scenes, scene);
  }
  /* Entries of all scenes, each text once. */
  g_autoptr (QnScene) legend = qn_scene_new ();
  g_autoptr (GHashTable) known = g_hash_table_new (g_str_hash, g_str_equal);
  for (guint i = 0; i < scenes->len; i++) {
    const QnScene *one = g_ptr_array_index (scenes, i);
    legend->monochrome = one->monochrome;
    for (guint k = 0; k < one->legend->len; k++) {
      QnLegendEntry entry = g_array_index (one->legend, QnLegendEntry, k);
      if (!g_hash_table_add (known, entry.text))
        continue;
      entry.text = g_strdup (entry.text);
      g_array_append_val (legend->legend, entry);
    }
  }
  g_autofree QnId *groups = g_new (QnId, sheet->count);
  if (!qn_compare_sheet_groups (sheet->figures, sheet->count, groups)) {
    g_set_error_literal (error, G_IO_ERROR, G_IO_ERROR_FAILED, _ ("not enough memory"));
    return false;
  }
  SheetLayout layout = { .sheet = sheet,
                         .page = page,
                         .cr = cr,
                         .scenes = scenes,
                         .legend = legend,
                         .groups = groups };
  draw_sheet (&layout);
  return true;
}

bool
qn_compare_sheet_export (const QnCompareSheet *sheet, const char *path,
                         const QnOutput *output, const QnMetadata *metadata,
                         GError **error)
{
  if (sheet->count == 0)
    return qn_render_refuse (error, _ ("there is nothing to compare"));
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = sheet->title;
  QnCompareSheet copy = *sheet;
  return qn_page_export (path, output, &full, draw_sheet_page, &copy, error);
}
