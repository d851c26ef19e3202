#include "render/figure/figure-layout.h"

#include "render/backend/offscreen.h"
#include "render/drawing/scene-fit.h"
#include "render/drawing/text.h"

/* Space between the parts, pt. */
#define PART_GAP 7.0

/* Least share of a frame that the structure keeps; furniture that would take more is left
 * out. */
#define LEAST_SHARE 0.35

/* Draws title and caption from the top of the frame, or only measures them; returns their
 * height with the gap. */
static double
draw_titles (const QnFigure *figure, const QnScene *scene, cairo_t *cr,
             const QnPage *page, const QnFrame *frame, bool draw)
{
  if (!figure->options.titles)
    return 0;
  g_autofree char *own =
    figure->caption == NULL ? qn_figure_dup_caption (figure, scene, false) : NULL;
  const char *caption = figure->caption != NULL ? figure->caption : own;
  const char *title = qn_figure_title (figure);
  QnTextStyle big = { .size = QN_TYPE_TITLE * page->unit,
                      .bold = true,
                      .width = frame->width };
  QnTextStyle small = { .size = QN_TYPE_TEXT * page->unit, .width = frame->width };
  double y = 0, width, height;
  if (title != NULL && *title != '\0') {
    qn_text_measure (cr, &big, title, &width, &height);
    if (draw)
      qn_text_draw (cr, &big, title, frame->x, frame->y, 0, 0, 0,
                    qn_ink (QN_INK_LINE, figure->options.monochrome));
    y += height + page->unit;
  }
  if (*caption != '\0') {
    qn_text_measure (cr, &small, caption, &width, &height);
    if (draw)
      qn_text_draw (cr, &small, caption, frame->x, frame->y + y, 0, 0, 0,
                    qn_ink (QN_INK_LINE, figure->options.monochrome));
    y += height;
  }
  return y > 0 ? y + PART_GAP * page->unit : 0;
}

/* Divides what the titles leave between the structure and the furniture, beside or below,
 * whichever lets the structure be larger. */
static bool
place_furniture (QnFurniture *furniture, QnCamera *view, const QnScene *scene,
                 double unit)
{
  double gap = PART_GAP * unit, column, column_height;
  double row = qn_furniture_row_height (furniture, view->width);
  qn_furniture_column_size (furniture, &column, &column_height);
  QnCamera below = *view, beside = *view;
  below.height = view->height - row - gap;
  beside.width = view->width - column - 2 * gap;

  bool below_fits = below.height > LEAST_SHARE * view->height;
  bool beside_fits =
    beside.width > LEAST_SHARE * view->width && column_height <= view->height;
  qn_camera_fit (&below, scene->box, 0);
  qn_camera_fit (&beside, scene->box, 0);
  bool as_column = beside_fits && (!below_fits || beside.scale > below.scale);
  if (!as_column && !below_fits) {
    furniture->count = 0;
    return false;
  }
  furniture->width = as_column ? column : view->width;
  furniture->height = as_column ? column_height : row;
  furniture->x = view->x + (as_column ? view->width - column : 0);
  furniture->y = view->y + view->height - furniture->height;
  *view = as_column ? beside : below;
  return as_column;
}

void
qn_figure_layout_init (QnFigureLayout *layout, const QnFigure *figure,
                       const QnScene *scene, cairo_t *cr, const QnPage *page,
                       const QnFrame *frame)
{
  double titles = draw_titles (figure, scene, cr, page, frame, false);
  *layout = (QnFigureLayout){ .frame = *frame,
                              .titles = titles <= (1 - LEAST_SHARE) * frame->height };
  if (!layout->titles)
    titles = 0;
  layout->camera = (QnCamera){ .scale = 1,
                               .unit = page->unit,
                               .x = frame->x,
                               .y = frame->y + titles,
                               .width = frame->width,
                               .height = frame->height - titles };
  if (figure->options.legend) {
    qn_furniture_init (&layout->furniture, scene, cr, page->unit, frame->width, true);
    layout->as_column =
      place_furniture (&layout->furniture, &layout->camera, scene, page->unit);
  }
  qn_scene_fit (&layout->camera, scene, cr, 0);
}

bool
qn_figure_layout_draw (const QnFigureLayout *layout, const QnFigure *figure,
                       const QnScene *scene, cairo_t *cr, const QnPage *page,
                       GError **error)
{
  if (layout->titles)
    draw_titles (figure, scene, cr, page, &layout->frame, true);
  if (!qn_scene_draw (scene, &layout->camera, cr, page, error))
    return false;
  if (layout->furniture.count > 0)
    qn_furniture_draw (&layout->furniture, cr, layout->camera.scale, layout->as_column);
  return true;
}

void
qn_figure_layout_clear (QnFigureLayout *layout)
{
  qn_furniture_clear (&layout->furniture);
}
