/* A figure: one view of one model with title, legend and scale bar, ready for a report. */
#pragma once

#include "render/backend/output.h"
#include "render/figure/figure-furniture.h"
#include "render/scene/scene-build.h"

typedef struct QnFigure {
  const QnModel *model;       /* borrowed, prepared */
  const QnContacts *contacts; /* borrowed; NULL where the view does without */
  const QnResult *result;     /* borrowed; NULL where the view does without */
  QnViewOptions options;
  const char *title; /* above the picture; NULL: the model's title */
  const char
    *caption; /* second line; NULL: from the view, the step and the result; "": none */
} QnFigure;

void qn_figure_init (QnFigure *figure, const QnModel *model, const QnContacts *contacts,
                     const QnResult *result, QnView view);

/* Writes PNG, SVG or PDF by the ending of the path. Title and multiplier are added to the
 * metadata where it does not give them. */
bool qn_figure_export (const QnFigure *figure, const char *path, const QnOutput *output,
                       const QnMetadata *metadata, GError **error);

/* The same, into memory. Returns NULL with an error. */
GBytes *qn_figure_encode (const QnFigure *figure, QnFormat format, const QnOutput *output,
                          const QnMetadata *metadata, GError **error);

/* Its title, or that of its model; NULL where there is none. */
const char *qn_figure_title (const QnFigure *figure);

/* The metadata, with the title and the multiplier of the figure where they have none. */
QnMetadata qn_figure_metadata (const QnFigure *figure, const QnMetadata *metadata);

/* The second line of a figure as it would stand there by itself, or shorter for sheets; newly
 * allocated. */
char *qn_figure_dup_caption (const QnFigure *figure, const QnScene *scene, bool brief);

/* One figure within a rectangle of a page. */
typedef struct QnFrame {
  double x, y, width, height; /* px */
} QnFrame;

/* The page less a margin of so many points, at most a tenth of its smaller side. */
QnFrame qn_page_frame (const QnPage *page, double margin);

/* Draws scene and furniture. `camera`, nullable, receives the camera used. */
bool qn_figure_draw (const QnFigure *figure, cairo_t *cr, const QnPage *page,
                     const QnFrame *frame, QnCamera *camera, GError **error);

/* The same within the margin of a page, as it is exported. A QnPageFunc; `figure`: a QnFigure. */
bool qn_figure_draw_page (cairo_t *cr, const QnPage *page, void *figure, GError **error);

/* The least height of the frame, at most its own, in which the structure is drawn nearly as large as in
 * the whole frame: a wide wall needs less than a tower. False with an error where the figure cannot
 * be drawn. */
bool qn_figure_fit_height (const QnFigure *figure, cairo_t *cr, const QnPage *page,
                           const QnFrame *frame, double *height, GError **error);

/* Centres the scene in the camera's viewport, as large as it goes without clipping markers,
 * line ends and labels; at `scale` px per m where that is > 0. The camera's viewport and unit
 * are given, its centre and scale are set. */
void qn_scene_fit (QnCamera *camera, const QnScene *scene, cairo_t *cr, double scale);

/* Layout of a figure: titles, structure, furniture. Made once and drawn many times, so that the frames of
 * an animation do not jump. */
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
