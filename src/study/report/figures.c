#include "study/report/figures.h"

#include "core/base/integer.h"
#include "core/base/numbers.h"
#include "io/text/io-error.h"
#include "render/drawing/text.h"
#include "render/figure/compare-sheet.h"
#include "render/figure/plot.h"
#include "study/report/table.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Bars of a histogram; kinds of mechanism on a sheet. */
#define MOST_BARS  60
#define MOST_KINDS 16

/* Steps of a cumulative curve. */
#define MOST_STEPS 2000

/* Half the height of a bar of a tornado, where one is a row. */
#define HALF_BAR 0.36

const char *const qn_study_figure_names[QN_STUDY_FIGURE_COUNT] = {
  [QN_STUDY_FIGURE_SCATTER] = "scatter",       [QN_STUDY_FIGURE_HISTOGRAM] = "histogram",
  [QN_STUDY_FIGURE_CUMULATIVE] = "cumulative", [QN_STUDY_FIGURE_TORNADO] = "tornado",
  [QN_STUDY_FIGURE_SURFACE] = "surface",       [QN_STUDY_FIGURE_ENVELOPE] = "envelope",
  [QN_STUDY_FIGURE_MECHANISMS] = "mechanisms",
};

/* A figure, its table, and its error. */
typedef struct Page {
  const QnStudyFigure *figure;
  const QnTable *table;
  GError **error;
} Page;

static QnPlot *
fail (const Page *page, const char *message)
{
  g_set_error (page->error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s: %s",
               page->table->study->name, message);
  return NULL;
}

/* A plot whose axes hold 0 only where that is said. */
static QnPlot *
new_plot (const char *x_label, const char *y_label)
{
  QnPlot *plot = qn_plot_new (x_label, y_label);
  plot->x.from_zero = plot->y.from_zero = false;
  return plot;
}

static const char *
output_name (const Page *page, int column)
{
  return qn_table_column_text (page->table, (gsize) column);
}

static QnPlot *
draw_scatter (const Page *page)
{
  double *x = NULL, *y = NULL;
  gsize count = qn_table_dup_pairs (page->table, (gsize) page->figure->parameters[0],
                                    (gsize) page->figure->column, &x, &y);
  QnPlot *plot = new_plot (output_name (page, page->figure->parameters[0]),
                           output_name (page, page->figure->column));
  qn_plot_mark (plot, QN_MARKS_POINTS, NULL, 0, qn_plot_keep (plot, x),
                qn_plot_keep (plot, y), count);
  return plot;
}

static QnPlot *
draw_histogram (const Page *page)
{
  gsize count;
  QnPlot *plot = new_plot (output_name (page, page->figure->column), _ ("Cases"));
  const double *sorted = qn_plot_keep (
    plot, qn_table_dup_sorted (page->table, (gsize) page->figure->column, &count));
  if (count == 0)
    return plot;
  /* The rule of Freedman and Diaconis for the width of bars. */
  double spread = qn_quantile (sorted, count, 0.75) - qn_quantile (sorted, count, 0.25);
  double low = sorted[0], range = sorted[count - 1] - low;
  double step = 2 * spread / cbrt ((double) count);
  gsize bars = (gsize) qn_to_integer (ceil (range / step), 1, MOST_BARS);
  double width = range / (double) bars;
  if (!(width > 0)) {
    width = fmax (fabs (low), 1) * 1e-3;
    low -= 0.5 * width;
  }
  double *x = qn_plot_keep (plot, g_new (double, bars));
  double *x_end = qn_plot_keep (plot, g_new (double, bars));
  double *y = qn_plot_keep (plot, g_new0 (double, bars));
  double *y_end = qn_plot_keep (plot, g_new0 (double, bars));
  gsize before = 0;
  for (gsize i = 0; i < bars; i++) {
    x[i] = low + width * (double) i;
    x_end[i] = low + width * (double) (i + 1);
    gsize upto = i + 1 < bars ? qn_count_up_to (sorted, count, x_end[i]) : count;
    y_end[i] = (double) (upto - before);
    before = upto;
  }
  plot->y.from_zero = true;
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_RECTANGLES,
                                .x = x,
                                .x_end = x_end,
                                .y = y,
                                .y_end = y_end,
                                .count = bars });
  return plot;
}

/* Share of the values up to each of them, and its bounds where they are a sample. */
static QnPlot *
draw_cumulative (const Page *page)
{
  gsize count;
  const char *share_text =
    qn_table_fragility_text (page->table, (gsize) page->figure->column);
  QnPlot *plot =
    new_plot (output_name (page, page->figure->column),
              share_text != NULL ? share_text : _ ("Share up to this value"));
  double *sorted = qn_plot_keep (
    plot, qn_table_dup_sorted (page->table, (gsize) page->figure->column, &count));
  if (count == 0)
    return plot;
  /* Of very many values, evenly spaced ones. */
  gsize every = (count + MOST_STEPS - 1) / MOST_STEPS, steps = 0;
  double *share = qn_plot_keep (plot, g_new (double, count));
  double *low = qn_plot_keep (plot, g_new (double, count));
  double *high = qn_plot_keep (plot, g_new (double, count));
  for (gsize i = (count - 1) % every; i < count; i += every, steps++) {
    QnInterval interval = qn_share_interval (i + 1, count);
    sorted[steps] = sorted[i];
    share[steps] = (double) (i + 1) / (double) count;
    low[steps] = interval.low;
    high[steps] = interval.high;
  }
  plot->y.from_zero = true;
  if (qn_table_is_sample (page->table))
    /* xgettext:no-c-format */
    qn_plot_mark (plot, QN_MARKS_BAND, _ ("95 % interval"), 0, sorted, low, steps)
      ->y_end = high;
  qn_plot_mark (plot, QN_MARKS_STEPS, _ ("share of the cases"), 0, sorted, share, steps);
  return plot;
}

/* Rows of a tornado, the longest on top. */
typedef struct Bar {
  const char *name;
  double from, to;        /* of the bar, */
  double second;          /* of a second one that begins with it; NaN: none */
  QnInterval whiskers[2]; /* of both; NaN: none */
} Bar;

static double
length_of (const Bar *bar)
{
  return fmax (fabs (bar->to - bar->from),
               isnan (bar->second) ? 0 : fabs (bar->second - bar->from));
}

static int
compare_bars (gconstpointer a, gconstpointer b)
{
  double x = length_of (a), y = length_of (b);
  return (x < y) - (x > y);
}

/* Adds bars from `top` to `bottom` about the middle of each row, to `to` or to `second`; with a label
 * they have whiskers. */
static void
add_bars (QnPlot *plot, const GArray *bars, int series, const char *label, double top,
          double bottom)
{
  enum { FROM, TO, TOP, BOTTOM, LOW, HIGH, MIDDLE, COLUMNS };
  gsize count = bars->len;
  double *numbers = qn_plot_keep (plot, g_new (double, COLUMNS *count));
  for (gsize i = 0; i < count; i++) {
    const Bar *bar = &g_array_index (bars, Bar, i);
    const double row = (double) i;
    const double values[COLUMNS] = {
      [FROM] = bar->from,
      [TO] = series == 0 ? bar->to : bar->second,
      [TOP] = row + top,
      [BOTTOM] = row + bottom,
      [LOW] = bar->whiskers[series].low,
      [HIGH] = bar->whiskers[series].high,
      [MIDDLE] = row + 0.5 * (top + bottom),
    };
    for (gsize k = 0; k < COLUMNS; k++)
      numbers[k * count + i] = values[k];
  }
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_RECTANGLES,
                                .label = label,
                                .series = series,
                                .x = numbers + FROM * count,
                                .y = numbers + TOP * count,
                                .x_end = numbers + TO * count,
                                .y_end = numbers + BOTTOM * count,
                                .count = count });
  if (label != NULL)
    qn_plot_mark (plot, QN_MARKS_WHISKERS, NULL, 0, numbers + LOW * count,
                  numbers + MIDDLE * count, count)
      ->x_end = numbers + HIGH * count;
}

/* One row for each bar, the longest on top. */
static QnPlot *
new_bars (GArray *bars, char *x_label)
{
  QnPlot *plot = new_plot (NULL, _ ("Parameter"));
  const char **names = qn_plot_keep (plot, g_new (const char *, bars->len));
  g_array_sort (bars, compare_bars);
  for (guint i = 0; i < bars->len; i++)
    names[i] = g_array_index (bars, Bar, i).name;
  plot->x.label = qn_plot_keep (plot, x_label);
  plot->y.names = names;
  plot->y.name_count = bars->len;
  return plot;
}

static QnPlot *
draw_sobol_plot (const Page *page)
{
  const QnTable *table = page->table;
  g_autofree QnSobolIndex *indices = g_new (QnSobolIndex, table->parameters);
  g_autoptr (GArray) bars = g_array_new (FALSE, FALSE, sizeof (Bar));
  if (!qn_table_sobol (table, (gsize) page->figure->column, indices))
    return fail (page, _ ("too few cases are known for Sobol indices"));
  for (gsize k = 0; k < table->parameters; k++) {
    Bar bar = { .name = qn_table_column_name (table, k),
                .to = indices[k].first,
                .second = indices[k].total,
                .whiskers = { indices[k].of_first, indices[k].of_total } };
    g_array_append_val (bars, bar);
  }
  QnPlot *plot =
    new_bars (bars, g_strdup_printf (_ ("Sobol index: %s"),
                                     output_name (page, page->figure->column)));
  plot->x.from_zero = true;
  add_bars (plot, bars, 0, _ ("first order"), -HALF_BAR, 0);
  add_bars (plot, bars, 1, _ ("total"), 0, HALF_BAR);
  return plot;
}

/* Ranges have a line through all, where the project as it is stands. */
static QnPlot *
draw_tornado (const Page *page)
{
  const QnTable *table = page->table;
  gsize column = (gsize) page->figure->column;
  const char *name = output_name (page, page->figure->column);
  gboolean single = table->study->plan == QN_PLAN_ONE_AT_A_TIME;
  double base = NAN;
  g_autoptr (GArray) bars = g_array_new (FALSE, FALSE, sizeof (Bar));
  if (table->study->plan == QN_PLAN_SOBOL)
    return draw_sobol_plot (page);
  for (gsize k = 0; k < table->parameters; k++) {
    g_autofree double *x = NULL, *y = NULL;
    double r = 0;
    QnInterval effect = { 0, 0 };
    Bar bar = { .name = qn_table_column_name (table, k), .second = NAN };
    if (!single) {
      gsize count = qn_table_dup_pairs (table, k, column, &x, &y);
      r = qn_rank_correlation (x, y, count);
    }
    if (single ? !qn_table_effect (table, k, column, &base, &effect) : isnan (r) != 0)
      continue;
    bar.from = single ? effect.low : 0;
    bar.to = single ? effect.high : r;
    g_array_append_val (bars, bar);
  }
  QnPlot *plot = new_bars (
    bars, single ? g_strdup (name) : g_strdup_printf (_ ("Rank correlation: %s"), name));
  if (bars->len > 0)
    add_bars (plot, bars, 0, NULL, -HALF_BAR, HALF_BAR);
  if (bars->len == 0 || isnan (base))
    return plot;
  double *line = qn_plot_keep (plot, g_new (double, 4));
  line[0] = line[1] = base;
  line[2] = -0.5;
  line[3] = (double) bars->len - 0.5;
  qn_plot_mark (plot, QN_MARKS_LINE, _ ("the project as it is"), 1, line, line + 2, 2);
  return plot;
}

/* The different values of a column, ascending; of double. */
static GArray *
dup_levels (const double *numbers, gsize count)
{
  GArray *levels = g_array_new (FALSE, FALSE, sizeof (double));
  g_array_append_vals (levels, numbers, (guint) count);
  g_array_sort (levels, qn_compare_doubles);
  guint kept = 0;
  for (guint i = 0; i < levels->len; i++) {
    double value = g_array_index (levels, double, i);
    if (kept == 0 || value > g_array_index (levels, double, kept - 1))
      g_array_index (levels, double, kept++) = value;
  }
  g_array_set_size (levels, kept);
  return levels;
}

/* Where the cell of a level ends: half way to its neighbours. */
static double
cell_edge (const GArray *levels, gsize edge)
{
  gsize last = levels->len - 1;
  const double *v = (const double *) (const void *) levels->data;
  if (last == 0)
    return v[0] + ((double) edge - 0.5) * fmax (fabs (v[0]), 1) * 0.1;
  if (edge == 0)
    return 1.5 * v[0] - 0.5 * v[1];
  return edge > last ? 1.5 * v[last] - 0.5 * v[last - 1] : 0.5 * (v[edge - 1] + v[edge]);
}

static gsize
level_of (const GArray *levels, double value)
{
  gsize i = 0;
  while (i + 1 < levels->len && g_array_index (levels, double, i) < value)
    i++;
  return i;
}

/* A cell for each two levels, with the mean over what else varies. */
static void
add_cells (QnPlot *plot, const double *x, const double *y, const double *z, gsize count)
{
  g_autoptr (GArray) across = dup_levels (x, count), up = dup_levels (y, count);
  gsize cells = (gsize) across->len * up->len, known = 0;
  g_autofree double *sum = g_new0 (double, cells), *weight = g_new0 (double, cells);
  double *numbers = qn_plot_keep (plot, g_new (double, 5 * cells));
  for (gsize i = 0; i < count; i++) {
    gsize cell = level_of (across, x[i]) * up->len + level_of (up, y[i]);
    sum[cell] += z[i];
    weight[cell] += 1;
  }
  for (gsize i = 0; i < cells; i++) {
    if (!(weight[i] > 0))
      continue;
    numbers[known] = cell_edge (across, i / up->len);
    numbers[cells + known] = cell_edge (across, i / up->len + 1);
    numbers[2 * cells + known] = cell_edge (up, i % up->len);
    numbers[3 * cells + known] = cell_edge (up, i % up->len + 1);
    numbers[4 * cells + known++] = sum[i] / weight[i];
  }
  qn_plot_add (plot, (QnMarks){ .kind = QN_MARKS_RECTANGLES,
                                .x = numbers,
                                .x_end = numbers + cells,
                                .y = numbers + 2 * cells,
                                .y_end = numbers + 3 * cells,
                                .values = numbers + 4 * cells,
                                .count = known });
}

static QnPlot *
draw_surface (const Page *page)
{
  const QnTable *table = page->table;
  const int *parameters = page->figure->parameters;
  QnPlot *plot =
    new_plot (output_name (page, parameters[0]), output_name (page, parameters[1]));
  double *x = qn_plot_keep (plot, g_new (double, 3 * table->rows->len + 1));
  double *y = x + table->rows->len, *z = y + table->rows->len;
  gsize count = 0;
  for (gsize i = 0; i < table->rows->len; i++) {
    z[count] = qn_table_number (table, i, (gsize) page->figure->column);
    x[count] = qn_table_number (table, i, (gsize) parameters[0]);
    y[count] = qn_table_number (table, i, (gsize) parameters[1]);
    count += isfinite (z[count]) != 0;
  }
  plot->bar_title = output_name (page, page->figure->column);
  if (qn_plan_is_by_levels (table->study->plan) && count > 0)
    add_cells (plot, x, y, z, count);
  else
    qn_plot_mark (plot, QN_MARKS_POINTS, NULL, 0, x, y, count)->values = z;
  return plot;
}

/* Least and greatest value at every level of a parameter, with a gap where no case has one, and where
 * the least of all is. */
static QnPlot *
draw_envelope (const Page *page)
{
  g_autofree double *x = NULL, *y = NULL;
  const QnTable *table = page->table;
  const gsize parameter = (gsize) page->figure->parameters[0], rows = table->rows->len;
  gsize least = 0, count = qn_table_dup_pairs (table, parameter,
                                               (gsize) page->figure->column, &x, &y);
  QnPlot *plot = new_plot (output_name (page, page->figure->parameters[0]),
                           output_name (page, page->figure->column));
  if (count == 0)
    return plot;
  g_autofree double *all = g_new (double, rows);
  for (gsize i = 0; i < rows; i++)
    all[i] = qn_table_number (table, i, parameter);
  GArray *levels = dup_levels (all, rows);
  const guint level_count = levels->len;
  double *low = qn_plot_keep (plot, g_new (double, level_count));
  double *high = qn_plot_keep (plot, g_new (double, level_count));
  gboolean wide = FALSE;
  for (guint i = 0; i < level_count; i++)
    low[i] = high[i] = NAN;
  for (gsize i = 0; i < count; i++) {
    gsize level = level_of (levels, x[i]);
    low[level] = fmin (low[level], y[i]);
    high[level] = fmax (high[level], y[i]);
  }
  const double *at = qn_plot_keep (plot, g_array_free (levels, FALSE));
  for (gsize i = 0; i < level_count; i++) {
    least = !isnan (low[i]) && !(low[least] <= low[i]) ? i : least;
    wide |= high[i] > low[i];
  }
  g_autofree char *number = qn_label_number ("%.5g", low[least]);
  g_autofree char *place = qn_label_number ("%.4g", at[least]);
  const QnCombination *of = qn_study_combination (table->study, parameter, at[least]);
  char *label = qn_plot_keep (plot, g_strdup_printf (_ ("least: %s at %s"), number,
                                                     of != NULL ? of->label : place));
  QnMarks line = { .kind = of != NULL ? QN_MARKS_POINTS : QN_MARKS_LINE,
                   .label = wide ? _ ("least value") : NULL,
                   .x = at,
                   .y = low,
                   .count = level_count };
  plot->y.from_zero = true;
  qn_plot_add (plot, line);
  qn_plot_mark (plot, QN_MARKS_POINTS, label, 1, at + least, low + least, 1);
  line.label = _ ("greatest value");
  line.series = 2;
  line.y = high;
  if (wide)
    qn_plot_add (plot, line);
  return plot;
}

static char *
dup_caption (const QnTable *table, const QnMechanismShare *share, gsize whole)
{
  double percent = 100.0 * (double) share->count / (double) whole;
  g_autofree char *name = qn_mechanism_share_dup_name (share);
  if (isnan (share->range.low))
    return g_strdup_printf (_ ("%s: %zu cases (%.1f %%)"), name, share->count, percent);
  return g_strdup_printf (_ ("%s: %zu cases (%.1f %%), %s %.3f … %.3f"), name,
                          share->count, percent,
                          qn_table_column_text (table, (gsize) share->column),
                          share->range.low, share->range.high);
}

/* The typical case of every kind is analysed again: the same numbers give the same mechanism. */
static gboolean
export_mechanisms (const Page *page, const char *path, const QnOutput *output,
                   const QnMetadata *metadata)
{
  const QnTable *table = page->table;
  gsize whole;
  g_autoptr (GArray) shares = qn_table_dup_mechanisms (table, &whole);
  guint count = MIN (shares->len, MOST_KINDS);
  g_autofree QnCaseModel *models = g_new0 (QnCaseModel, count + 1);
  g_autofree QnFigure *figures = g_new0 (QnFigure, count + 1);
  g_autoptr (GPtrArray) captions = g_ptr_array_new_with_free_func (g_free);
  QnCompareSheet sheet = { .figures = figures, .title = table->study->title };
  if (count == 0) {
    fail (page, _ ("no case has a mechanism: is mechanism_shape among the outputs?"));
    return FALSE;
  }
  for (guint i = 0; i < count; i++) {
    const QnMechanismShare *share = &g_array_index (shares, QnMechanismShare, i);
    QnCaseResult result;
    qn_case_solve (table->study, table->numbers + share->row * table->width, NULL,
                   &models[i], &result);
    qn_case_result_clear (&result);
    if (models[i].result.mechanism == NULL)
      continue;
    QnFigure *figure = &figures[sheet.count++];
    qn_figure_init (figure, &models[i].project.model, &models[i].contacts,
                    &models[i].result, QN_VIEW_MECHANISM);
    figure->options.monochrome = page->figure->monochrome;
    g_autofree char *title = g_strdup_printf (
      _ ("Case %zu"), g_array_index (table->rows, QnRow, share->row).index + 1);
    g_ptr_array_add (captions, g_steal_pointer (&title));
    figure->title = g_ptr_array_index (captions, captions->len - 1);
    g_ptr_array_add (captions, dup_caption (table, share, whole));
    figure->caption = g_ptr_array_index (captions, captions->len - 1);
  }
  gboolean ok = qn_compare_sheet_export (&sheet, path, output, metadata, page->error);
  for (guint i = 0; i < count; i++)
    qn_case_model_clear (&models[i]);
  return ok;
}

QnPlot *
qn_study_figure_plot (const QnStudyFigure *figure, const QnTable *table, GError **error)
{
  static QnPlot *(*const kinds[QN_STUDY_FIGURE_MECHANISMS]) (const Page *) = {
    [QN_STUDY_FIGURE_SCATTER] = draw_scatter,
    [QN_STUDY_FIGURE_HISTOGRAM] = draw_histogram,
    [QN_STUDY_FIGURE_CUMULATIVE] = draw_cumulative,
    [QN_STUDY_FIGURE_TORNADO] = draw_tornado,
    [QN_STUDY_FIGURE_SURFACE] = draw_surface,
    [QN_STUDY_FIGURE_ENVELOPE] = draw_envelope,
  };
  const Page page = { figure, table, error };
  g_return_val_if_fail (figure->kind < QN_STUDY_FIGURE_MECHANISMS, NULL);
  QnPlot *plot = kinds[figure->kind](&page);
  if (plot == NULL)
    return NULL;
  if (plot->marks->len == 0 || g_array_index (plot->marks, QnMarks, 0).count == 0) {
    qn_plot_free (plot);
    return fail (&page, _ ("no case has this output yet"));
  }
  plot->title = table->study->title;
  plot->monochrome = figure->monochrome;
  return plot;
}

gboolean
qn_study_figure_export (const QnStudyFigure *figure, const QnTable *table,
                        const char *path, const QnOutput *output, GError **error)
{
  const QnStudy *study = table->study;
  g_autofree char *model = g_path_get_basename (study->model);
  QnMetadata metadata;
  qn_metadata_init (&metadata);
  metadata.title = study->title;
  metadata.model = model;
  metadata.model_sha256 = study->project.sha256;
  metadata.generator = "quoin " QN_VERSION;
  const Page page = { figure, table, error };
  if (figure->kind == QN_STUDY_FIGURE_MECHANISMS)
    return export_mechanisms (&page, path, output, &metadata);
  g_autoptr (QnPlot) plot = qn_study_figure_plot (figure, table, error);
  return plot != NULL && qn_plot_export (plot, path, output, &metadata, error);
}
