/* Layout of a figure: titles, structure, furniture. Made once and drawn many times, so that the frames of
 * an animation do not jump. */
#pragma once

#include "render/figure/figure-furniture.h"
#include "render/figure/figure.h"

typedef struct QnFigureLayout {
  QnFrame frame;
  bool titles; /* whether there is room for them */
  bool as_column;
  QnFurniture furniture;
  QnCamera camera;
} QnFigureLayout;

/* Lays out for `scene`, which must live as long as the layout: legend and colour bar are read
 * off it. */
void qn_figure_layout_init (QnFigureLayout *layout, const QnFigure *figure,
                            const QnScene *scene, cairo_t *cr, const QnPage *page,
                            const QnFrame *frame);

/* Draws the titles of `figure`, any scene of the same model, and the furniture. */
bool qn_figure_layout_draw (const QnFigureLayout *layout, const QnFigure *figure,
                            const QnScene *scene, cairo_t *cr, const QnPage *page,
                            GError **error);

void qn_figure_layout_clear (QnFigureLayout *layout);
