#include "render/figure/pages.h"

#include <cairo-pdf.h>
#include <glib/gi18n-lib.h>
#include <pango/pangocairo.h>
#include <string.h>

/* pt */
#define MARGIN       54.0
#define FOOT         30.0
#define SIZE_TITLE   20.0
#define SIZE_HEADING 13.0
#define SIZE_TEXT    9.5
#define SIZE_TABLE   8.0
#define SIZE_FOOT    7.5
#define CELL_GAP     8.0
#define ROW_GAP      3.0
#define HEADING_ROOM 32.0
#define LEAST_TEXT   36.0  /* of a paragraph that is divided */
#define LEAST_BELOW  60.0  /* a heading */
#define KEPT_WHOLE   150.0 /* paragraphs up to this height are not divided */

/* Bytes of a word that are shown at most: the work of breaking one into lines grows with the square of
 * its length. */
#define MOST_OF_WORD 400

static const struct {
  const char *name;
  double width, height;
} papers[QN_PAPER_COUNT] = {
  [QN_PAPER_A4] = { "a4", 595.276, 841.89 },
  [QN_PAPER_LETTER] = { "letter", 612, 792 },
};

struct QnPages {
  QnPaper paper;
  char *footer;
  char *heading; /* waits for what it stands above; or NULL */
  GByteArray *bytes;
  cairo_surface_t *surface;
  cairo_t *cr;
  double y; /* where the next line begins, pt */
  int number;
  int figures; /* drawn so far */
  bool breaks; /* what comes next begins a page */
};

bool
qn_paper_parse (const char *name, QnPaper *paper)
{
  for (int i = 0; i < QN_PAPER_COUNT; i++)
    if (g_ascii_strcasecmp (name, papers[i].name) == 0) {
      *paper = (QnPaper) i;
      return true;
    }
  return false;
}

QnPages *
qn_pages_new (QnPaper paper, const char *footer, const QnMetadata *metadata)
{
  QnPages *pages = g_new0 (QnPages, 1);
  pages->paper = paper;
  pages->footer = g_strdup (footer);
  pages->bytes = g_byte_array_new ();
  pages->surface = cairo_pdf_surface_create_for_stream (
    qn_output_append, pages->bytes, papers[paper].width, papers[paper].height);
  qn_output_describe_pdf (pages->surface, metadata);
  pages->cr = cairo_create (pages->surface);
  pages->y = MARGIN;
  pages->number = 1;
  return pages;
}

static double
text_width (const QnPages *pages)
{
  return papers[pages->paper].width - 2 * MARGIN;
}

static double
bottom (const QnPages *pages)
{
  return papers[pages->paper].height - MARGIN - FOOT;
}

/* The text, of its very long words only the beginning. */
static char *
dup_shown (const char *text)
{
  GString *shown = g_string_new (NULL);
  while (*text != '\0') {
    gsize length = strcspn (text, " \n");
    gsize kept = length;
    if (length > MOST_OF_WORD)
      kept = (gsize) (g_utf8_find_prev_char (text, text + MOST_OF_WORD) - text);
    g_string_append_len (shown, text, (gssize) kept);
    if (kept < length)
      g_string_append (shown, "…");
    text += length;
    gsize blanks = strspn (text, " \n");
    g_string_append_len (shown, text, (gssize) blanks);
    text += blanks;
  }
  return g_string_free (shown, FALSE);
}

static PangoLayout *
new_layout (const QnPages *pages, const char *text, double size, bool bold, double width)
{
  PangoLayout *layout = pango_cairo_create_layout (pages->cr);
  PangoFontDescription *font = pango_font_description_from_string ("Sans");
  pango_font_description_set_absolute_size (font, size * PANGO_SCALE);
  pango_font_description_set_weight (font,
                                     bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_layout_set_font_description (layout, font);
  pango_font_description_free (font);
  if (width > 0)
    pango_layout_set_width (layout, (int) (width * PANGO_SCALE));
  pango_layout_set_wrap (layout, PANGO_WRAP_WORD_CHAR);
  g_autofree char *shown = dup_shown (text);
  pango_layout_set_text (layout, shown, -1);
  return layout;
}

static void
draw_footer (QnPages *pages)
{
  double width = text_width (pages), y = bottom (pages) + FOOT;
  g_autofree char *number = g_strdup_printf ("%d", pages->number);
  g_autoptr (PangoLayout) left =
    new_layout (pages, pages->footer, SIZE_FOOT, false, width - 40);
  g_autoptr (PangoLayout) right = new_layout (pages, number, SIZE_FOOT, false, width);
  pango_layout_set_ellipsize (left, PANGO_ELLIPSIZE_END);
  pango_layout_set_alignment (right, PANGO_ALIGN_RIGHT);
  cairo_set_source_rgb (pages->cr, 0.35, 0.35, 0.35);
  cairo_move_to (pages->cr, MARGIN, y);
  pango_cairo_show_layout (pages->cr, left);
  cairo_move_to (pages->cr, MARGIN, y);
  pango_cairo_show_layout (pages->cr, right);
}

static void
next_page (QnPages *pages)
{
  draw_footer (pages);
  cairo_show_page (pages->cr);
  pages->number++;
  pages->y = MARGIN;
}

static void
need (QnPages *pages, double height)
{
  if (pages->y > MARGIN && pages->y + height > bottom (pages))
    next_page (pages);
}

/* Line by line, so that long texts continue on the next page. */
static void
flow (QnPages *pages, PangoLayout *layout)
{
  PangoLayoutIter *iter = pango_layout_get_iter (layout);
  do {
    PangoRectangle extents;
    pango_layout_iter_get_line_extents (iter, NULL, &extents);
    double height = (double) extents.height / PANGO_SCALE;
    double base =
      (double) (pango_layout_iter_get_baseline (iter) - extents.y) / PANGO_SCALE;
    need (pages, height);
    cairo_set_source_rgb (pages->cr, 0, 0, 0);
    cairo_move_to (pages->cr, MARGIN + (double) extents.x / PANGO_SCALE, pages->y + base);
    pango_cairo_show_layout_line (pages->cr, pango_layout_iter_get_line_readonly (iter));
    pages->y += height;
  } while (pango_layout_iter_next_line (iter));
  pango_layout_iter_free (iter);
}

static void
write_text (QnPages *pages, const char *text, double size, bool bold, double gap)
{
  g_autoptr (PangoLayout) layout =
    new_layout (pages, text, size, bold, text_width (pages));
  flow (pages, layout);
  pages->y += gap;
}

/* Room for what comes next, with its heading above it. */
static void
begin (QnPages *pages, double height)
{
  g_autofree char *heading = g_steal_pointer (&pages->heading);
  if (pages->breaks && pages->y > MARGIN)
    next_page (pages);
  pages->breaks = false;
  need (pages, heading != NULL ? HEADING_ROOM + MAX (height, LEAST_BELOW) : height);
  if (heading == NULL)
    return;
  if (pages->y > MARGIN)
    pages->y += 10;
  write_text (pages, heading, SIZE_HEADING, true, 5);
}

void
qn_pages_break (QnPages *pages)
{
  if (pages->heading != NULL)
    begin (pages, 0);
  pages->breaks = true;
}

void
qn_pages_foot (QnPages *pages, const char *text)
{
  int height;
  begin (pages, LEAST_TEXT);
  g_autoptr (PangoLayout) layout =
    new_layout (pages, text, SIZE_TABLE, false, text_width (pages));
  pango_layout_get_pixel_size (layout, NULL, &height);
  need (pages, height);
  pages->y = MAX (pages->y, bottom (pages) - height);
  flow (pages, layout);
  qn_pages_break (pages);
}

void
qn_pages_title (QnPages *pages, const char *text)
{
  begin (pages, 100);
  write_text (pages, text, SIZE_TITLE, true, 10);
}

void
qn_pages_heading (QnPages *pages, const char *text)
{
  if (pages->heading != NULL)
    begin (pages, 0);
  pages->heading = g_strdup (text);
}

void
qn_pages_paragraph (QnPages *pages, const char *text)
{
  int height;
  g_autoptr (PangoLayout) layout =
    new_layout (pages, text, SIZE_TEXT, false, text_width (pages));
  pango_layout_get_pixel_size (layout, NULL, &height);
  begin (pages, height <= KEPT_WHOLE ? height : LEAST_TEXT);
  flow (pages, layout);
  pages->y += 6;
}

/* Width of a cell, pt: of its text in one line, or of its longest word. */
static double
measure_cell (const QnPages *pages, const char *cell, bool bold, bool by_word)
{
  int width;
  g_autoptr (PangoLayout) layout =
    new_layout (pages, cell, SIZE_TABLE, bold, by_word ? 1 : 0);
  if (by_word)
    pango_layout_set_wrap (layout, PANGO_WRAP_WORD);
  pango_layout_get_pixel_size (layout, &width, NULL);
  return width + 1.0;
}

/* Columns as wide as their widest cell. Where all are too wide for the page, cells wrap, first those that
 * give most room for each row that becomes taller, down to their longest word; where words are too wide,
 * words are divided. */
static void
measure_columns (const QnPages *pages, const char *const *cells, size_t rows,
                 size_t columns, double *widths)
{
  double excess = CELL_GAP * (double) (columns - 1) - text_width (pages), least_sum = 0;
  g_autofree double *wide = g_new (double, rows *columns);
  g_autofree double *least = g_new0 (double, columns);
  for (size_t c = 0; c < columns; c++) {
    widths[c] = 0;
    for (size_t i = c; i < rows * columns; i += columns) {
      wide[i] = measure_cell (pages, cells[i], i < columns, false);
      widths[c] = MAX (widths[c], wide[i]);
    }
    excess += widths[c];
  }
  for (size_t c = 0; c < columns && excess > 0; c++) {
    for (size_t i = c; i < rows * columns; i += columns)
      least[c] = MAX (least[c], measure_cell (pages, cells[i], i < columns, true));
    least_sum += least[c];
  }
  while (excess > 0) {
    size_t best = columns;
    double gain = 0, cut = 0;
    for (size_t c = 0; c < columns; c++) {
      double next = least[c], taller = 0;
      for (size_t i = c; i < rows * columns; i += columns)
        if (wide[i] < widths[c])
          next = MAX (next, wide[i]);
        else
          taller++;
      if ((widths[c] - next) / taller > gain) {
        best = c;
        cut = widths[c] - next;
        gain = cut / taller;
      }
    }
    if (best == columns)
      break;
    widths[best] -= MIN (cut, excess);
    excess -= cut;
  }
  for (size_t c = 0; c < columns && excess > 0; c++)
    widths[c] *= 1 - excess / least_sum;
}

/* The height of a row, pt; drawn at the pages' y where asked for. */
static double
lay_row (QnPages *pages, const char *const *cells, size_t columns, const double *widths,
         const bool *numbers, bool bold, bool draw)
{
  double tallest = 0, x = MARGIN;
  for (size_t c = 0; c < columns; c++) {
    int height;
    g_autoptr (PangoLayout) layout =
      new_layout (pages, cells[c], SIZE_TABLE, bold, widths[c]);
    if (numbers[c])
      pango_layout_set_alignment (layout, PANGO_ALIGN_RIGHT);
    pango_layout_get_pixel_size (layout, NULL, &height);
    tallest = MAX (tallest, height + ROW_GAP);
    if (draw) {
      cairo_set_source_rgb (pages->cr, 0, 0, 0);
      cairo_move_to (pages->cr, x, pages->y);
      pango_cairo_show_layout (pages->cr, layout);
    }
    x += widths[c] + CELL_GAP;
  }
  return tallest;
}

static void
draw_head (QnPages *pages, const char *const *cells, size_t columns, const double *widths,
           const bool *numbers)
{
  pages->y += lay_row (pages, cells, columns, widths, numbers, true, true);
  cairo_set_source_rgb (pages->cr, 0, 0, 0);
  cairo_set_line_width (pages->cr, 0.6);
  cairo_move_to (pages->cr, MARGIN, pages->y - 0.5 * ROW_GAP);
  cairo_rel_line_to (pages->cr, text_width (pages), 0);
  cairo_stroke (pages->cr);
}

void
qn_pages_table (QnPages *pages, const char *const *cells, size_t rows, size_t columns)
{
  g_autofree double *widths = g_new (double, columns);
  g_autofree bool *numbers = g_new (bool, columns);
  measure_columns (pages, cells, rows, columns, widths);
  /* Columns of numbers, which are set to the right. */
  for (size_t c = 0; c < columns; c++) {
    numbers[c] = rows > 1;
    for (size_t r = 1; r < rows; r++) {
      const char *cell = cells[r * columns + c];
      numbers[c] &=
        strcmp (cell, "–") == 0 || strspn (cell, "0123456789.,-+e") == strlen (cell);
    }
  }
  begin (pages, 40);
  draw_head (pages, cells, columns, widths, numbers);
  for (size_t r = 1; r < rows; r++) {
    const char *const *row = cells + r * columns;
    double height = lay_row (pages, row, columns, widths, numbers, false, false);
    if (pages->y + height > bottom (pages)) {
      next_page (pages);
      draw_head (pages, cells, columns, widths, numbers);
    }
    lay_row (pages, row, columns, widths, numbers, false, true);
    pages->y += height;
  }
  pages->y += 8;
}

int
qn_pages_next_figure (const QnPages *pages)
{
  return pages->figures + 1;
}

/* "Figure 3: Mechanism" */
static char *
dup_caption (QnPages *pages, const char *title)
{
  pages->figures++;
  return title == NULL || *title == '\0'
           ? g_strdup_printf (_ ("Figure %d"), pages->figures)
           : g_strdup_printf (_ ("Figure %d: %s"), pages->figures, title);
}

static QnPage
page_of (const QnPages *pages)
{
  return (QnPage){ .width = papers[pages->paper].width,
                   .height = papers[pages->paper].height,
                   .unit = 1 };
}

/* A figure is made lower by so much rather than begun on the next page. */
#define LOWER 0.7

static bool
fit_figures (QnPages *pages, const QnFigure *figures, size_t count, QnFrame *frame,
             const QnPage *page, GError **error)
{
  double tallest = 0;
  for (size_t i = 0; i < count; i++) {
    double height;
    if (!qn_figure_fit_height (&figures[i], pages->cr, page, frame, &height, error))
      return false;
    tallest = MAX (tallest, height);
  }
  double room = bottom (pages) - pages->y - (pages->heading != NULL ? HEADING_ROOM : 0);
  frame->height =
    !pages->breaks && room < tallest && room > LOWER * tallest ? room : tallest;
  return true;
}

bool
qn_pages_figures (QnPages *pages, const QnFigure *figures, size_t count, size_t columns,
                  double share, GError **error)
{
  QnPage page = page_of (pages);
  double step = (text_width (pages) + CELL_GAP) / (double) columns;
  g_autofree QnFigure *numbered = g_memdup2 (figures, count * sizeof *figures);
  g_autoptr (GPtrArray) captions = g_ptr_array_new_with_free_func (g_free);
  for (size_t i = 0; i < count; i++) {
    g_ptr_array_add (captions, dup_caption (pages, qn_figure_title (&figures[i])));
    numbered[i].title = captions->pdata[i];
  }
  for (size_t first = 0; first < count; first += columns) {
    size_t row = MIN (columns, count - first);
    QnFrame frame = { .x = MARGIN,
                      .width = step - CELL_GAP,
                      .height = share * (bottom (pages) - MARGIN) };
    if (!fit_figures (pages, numbered + first, row, &frame, &page, error))
      return false;
    begin (pages, frame.height);
    frame.y = pages->y;
    cairo_save (pages->cr);
    bool done = true;
    for (size_t i = 0; i < row && done; i++, frame.x += step)
      done = qn_figure_draw (&numbered[first + i], pages->cr, &page, &frame, NULL, error);
    cairo_restore (pages->cr);
    if (!done)
      return false;
    pages->y += frame.height + 8;
  }
  return true;
}

void
qn_pages_plot (QnPages *pages, const QnPlot *plot, double share)
{
  double height = share * (bottom (pages) - MARGIN);
  begin (pages, height);
  const QnFrame frame = { MARGIN, pages->y, text_width (pages), height };
  QnPlot numbered = *plot;
  g_autofree char *caption = dup_caption (pages, plot->title);
  numbered.title = caption;
  cairo_save (pages->cr);
  qn_plot_draw (&numbered, pages->cr, 1, &frame, NULL);
  cairo_restore (pages->cr);
  pages->y += height + 8;
}

GBytes *
qn_pages_finish (QnPages *pages, GError **error)
{
  if (pages->heading != NULL)
    begin (pages, 0);
  draw_footer (pages);
  cairo_show_page (pages->cr);
  cairo_destroy (pages->cr);
  cairo_surface_finish (pages->surface);
  cairo_status_t status = cairo_surface_status (pages->surface);
  cairo_surface_destroy (pages->surface);
  GBytes *bytes = g_byte_array_free_to_bytes (pages->bytes);
  g_free (pages->footer);
  g_free (pages);
  if (!qn_output_succeeded (status, error))
    g_clear_pointer (&bytes, g_bytes_unref);
  return bytes;
}
