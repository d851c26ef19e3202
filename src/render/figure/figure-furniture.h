/* Legend, colour bar and scale bar of a figure, laid out as a row below the structure or a column
 * beside it. Private to figures and sheets. */
#pragma once

#include "render/backend/output.h"
#include "render/drawing/scene.h"

/* Sizes of the type, pt. */
#define QN_TYPE_TITLE  10.0
#define QN_TYPE_TEXT   8.0
#define QN_TYPE_LEGEND 7.5

typedef struct QnFurniture {
  const QnScene *scene;
  double unit;
  bool scale_bar;
  double
    *widths; /* px, of the items: scale bar, colour bar where shown, legend entries */
  double *heights; /* px, of the same */
  size_t count;
  double x, y, width, height; /* px, where it goes */
} QnFurniture;

/* Measures the items; none is wider than `limit` px, unless one of its words is. A scale bar is
 * part of it where asked for. */
void qn_furniture_init (QnFurniture *furniture, const QnScene *scene, cairo_t *cr,
                        double unit, double limit, bool scale_bar);
void qn_furniture_clear (QnFurniture *furniture);

/* Height in px of the items flowing in rows of a given width. */
double qn_furniture_row_height (const QnFurniture *furniture, double width);

/* Width and height in px of the items one below the other. */
void qn_furniture_column_size (const QnFurniture *furniture, double *width,
                               double *height);

/* Draws the items flowing within the rectangle x, y, width; `scale` is in px per m. */
void qn_furniture_draw (const QnFurniture *furniture, cairo_t *cr, double scale,
                        bool as_column);
