#include "render/figure.h"

#include "render/draw-cairo.h"
#include "render/figure-furniture.h"
#include "render/motion.h"
#include "render/scene-fit.h"
#include "render/text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Space around everything and between the parts, pt. */
#define PAGE_MARGIN 8.0
#define PART_GAP    7.0

/* Least share of a frame that the structure keeps; furniture that would take more is left
 * out. */
#define LEAST_SHARE 0.35

void
qn_figure_init (QnFigure *figure, const QnModel *model, const QnContacts *contacts,
                const QnResult *result, QnView view)
{
  *figure = (QnFigure){ .model = model, .contacts = contacts, .result = result };
  qn_view_options_init (&figure->options, view);
}

static size_t
shown_step (const QnFigure *figure)
{
  const QnResult *result = figure->result;
  return figure->options.step == QN_STEP_LAST
           ? result->step_count - 1
           : MIN ((size_t) MAX (figure->options.step, 0), result->step_count - 1);
}

static bool
shows_result (const QnFigure *figure)
{
  return figure->result != NULL && figure->options.view != QN_VIEW_MODEL
         && figure->options.view != QN_VIEW_CONTACTS;
}

double
qn_figure_multiplier (const QnFigure *figure)
{
  const QnResult *result = figure->result;
  if (!shows_result (figure))
    return (double) NAN;
  if (figure->options.view == QN_VIEW_MECHANISM && result->has_collapse_multiplier)
    return result->collapse_multiplier;
  return result->step_count > 0 ? result->steps[shown_step (figure)].multiplier
                                : (double) NAN;
}

/* ---- words ----------------------------------------------------------------------------- */

static void
append_part (GString *text, const char *part)
{
  if (text->len > 0)
    g_string_append (text, " · ");
  g_string_append (text, part);
}

static void
append_multiplier (GString *text, const QnFigure *figure, bool brief)
{
  double multiplier = qn_figure_multiplier (figure);
  const QnResult *result = figure->result;
  if (isnan (multiplier))
    return;
  g_autofree char *part =
    g_strdup_printf (brief ? "λ = %.4g" : _ ("load multiplier λ = %.4g"), multiplier);
  append_part (text, part);
  if (brief || figure->options.view == QN_VIEW_MECHANISM || result->step_count == 0)
    return;
  size_t step = shown_step (figure);
  if (result->steps[step].event == QN_EVENT_COLLAPSE)
    append_part (text, _ ("last equilibrium before collapse"));
  else if (result->steps[step].event == QN_EVENT_SNAP)
    append_part (text, _ ("after a snap"));
}

static void
append_mechanism (GString *text, const QnFigure *figure)
{
  if (figure->options.view != QN_VIEW_MECHANISM || figure->contacts == NULL
      || figure->result->mechanism == NULL
      || figure->result->block_count != figure->model->block_count)
    return;
  QnMotion motion = { .model = figure->model,
                      .displacements = figure->result->mechanism,
                      .linear = true,
                      .scale = 1 };
  g_autofree QnJoint *joints = qn_motion_joints (&motion, figure->contacts, NULL);
  QnMechanismClass mechanism =
    qn_joints_class (joints, figure->contacts->face_count, NULL, NULL);
  append_part (text, qn_mechanism_class_text (mechanism));
}

char *
qn_figure_dup_caption (const QnFigure *figure, const QnScene *scene, bool brief)
{
  g_autoptr (GString) text = g_string_new (NULL);
  const QnModel *model = figure->model;
  if (!shows_result (figure)) {
    g_autofree char *blocks = g_strdup_printf (
      ngettext ("%zu block", "%zu blocks", model->block_count), model->block_count);
    append_part (text, blocks);
    return g_strdup (text->str);
  }
  append_multiplier (text, figure, brief);
  append_mechanism (text, figure);
  if (figure->options.view == QN_VIEW_DEFORMED && scene->scale > 0) {
    g_autofree char *scale = g_strdup_printf (_ ("displacements × %g"), scene->scale);
    append_part (text, scale);
  }
  return g_strdup (text->str);
}

/* ---- layout ---------------------------------------------------------------------------- */

/* Draws title and caption from the top of the frame; returns their height with the gap. */
static double
draw_titles (const QnFigure *figure, const QnScene *scene, cairo_t *cr,
             const QnPage *page, const QnFrame *frame, bool draw)
{
  if (!figure->options.titles)
    return 0;
  g_autofree char *own =
    figure->caption == NULL ? qn_figure_dup_caption (figure, scene, false) : NULL;
  const char *caption = figure->caption != NULL ? figure->caption : own;
  const char *title = figure->title != NULL ? figure->title : figure->model->title;
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

static bool
draw_scene (const QnScene *scene, const QnCamera *camera, cairo_t *cr, const QnPage *page,
            GError **error)
{
  (void) error;
  qn_draw_cairo (scene, camera, QN_LAYERS_ALL, page->antialias, cr, NULL);
  return true;
}

bool
qn_figure_draw (const QnFigure *figure, cairo_t *cr, const QnPage *page,
                const QnFrame *frame, QnCamera *camera, GError **error)
{
  g_autoptr (QnScene) scene = qn_scene_build (figure->model, figure->contacts,
                                              figure->result, &figure->options, error);
  if (scene == NULL)
    return false;
  cairo_set_antialias (cr,
                       page->antialias ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);

  double titles = draw_titles (figure, scene, cr, page, frame, false);
  if (titles > (1 - LEAST_SHARE) * frame->height)
    titles = 0;
  else
    draw_titles (figure, scene, cr, page, frame, true);
  QnCamera view = { .scale = 1,
                    .unit = page->unit,
                    .x = frame->x,
                    .y = frame->y + titles,
                    .width = frame->width,
                    .height = frame->height - titles };
  QnFurniture furniture = { 0 };
  bool as_column = false;
  if (figure->options.legend) {
    qn_furniture_init (&furniture, scene, cr, page->unit, view.width, true);
    as_column = place_furniture (&furniture, &view, scene, page->unit);
  }
  qn_scene_fit (&view, scene, cr, frame->scale);
  bool done = draw_scene (scene, &view, cr, page, error);
  if (done && furniture.count > 0)
    qn_furniture_draw (&furniture, cr, view.scale, as_column);
  qn_furniture_clear (&furniture);
  if (camera != NULL)
    *camera = view;
  return done;
}

/* ---- export ---------------------------------------------------------------------------- */

static bool
draw_figure_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  double margin = fmin (PAGE_MARGIN * page->unit, 0.1 * fmin (page->width, page->height));
  QnFrame frame = { .x = margin,
                    .y = margin,
                    .width = page->width - 2 * margin,
                    .height = page->height - 2 * margin };
  return qn_figure_draw (data, cr, page, &frame, NULL, error);
}

bool
qn_figure_export (const QnFigure *figure, const char *path, const QnOutput *output,
                  const QnMetadata *metadata, GError **error)
{
  QnMetadata full = *metadata;
  if (full.title == NULL)
    full.title = figure->title != NULL ? figure->title : figure->model->title;
  if (isnan (full.multiplier))
    full.multiplier = qn_figure_multiplier (figure);
  QnFigure copy = *figure;
  return qn_page_export (path, output, &full, draw_figure_page, &copy, error);
}
