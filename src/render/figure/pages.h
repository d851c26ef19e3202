/* A document of pages: headings, paragraphs, tables, figures and curves, one below the other, as a
 * PDF whose text can be selected. Contents that do not fit begin the next page. Equal input gives
 * equal bytes. */
#pragma once

#include "render/figure/curve-plot.h"
#include "render/figure/figure.h"

typedef enum { QN_PAPER_A4, QN_PAPER_LETTER, QN_PAPER_COUNT } QnPaper;

/* "a4", "letter" in any case; false when unknown. */
bool qn_paper_parse (const char *name, QnPaper *paper);

typedef struct QnPages QnPages;

/* An empty document; `footer` (copied) stands beneath every page with its number. */
QnPages *qn_pages_new (QnPaper paper, const char *footer, const QnMetadata *metadata);

/* Begins a new page, unless this one is empty. */
void qn_pages_break (QnPages *pages);

/* A title is larger than a heading; a heading stays with what follows it. */
void qn_pages_title (QnPages *pages, const char *text);
void qn_pages_heading (QnPages *pages, const char *text);

/* Wraps, over pages where it must; newlines begin new lines. */
void qn_pages_paragraph (QnPages *pages, const char *text);

/* `cells`: rows x columns, the first row being the head, repeated on every page. Columns of numbers are
 * set to the right. */
void qn_pages_table (QnPages *pages, const char *const *cells, size_t rows,
                     size_t columns);

/* Text at the foot of the page; then a new page begins. */
void qn_pages_foot (QnPages *pages, const char *text);

/* Figures and plots are numbered in the order they are drawn in, before their titles: the number that the
 * next one has, for words that refer to it. */
int qn_pages_next_figure (const QnPages *pages);

/* Figures beside each other, `columns` in a row, of one height: at most this share of the page's, no more than
 * their structures fill, and somewhat less where they then stay on the page. False with an error where one
 * cannot be drawn. A plot has the width of the page. */
bool qn_pages_figures (QnPages *pages, const QnFigure *figures, size_t count,
                       size_t columns, double share, GError **error);
void qn_pages_plot (QnPages *pages, const QnPlot *plot, double share);

/* Frees the document; its PDF, or NULL with an error. */
GBytes *qn_pages_finish (QnPages *pages, GError **error);
