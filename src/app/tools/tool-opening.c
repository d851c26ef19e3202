/* Opening: a rectangle dragged on a wall becomes a window or door that can be moved and changed; a
 * click with Shift fills it again. */
#include "app/canvas/gesture.h"
#include "app/canvas/handle.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-masonry.h"
#include "doc/masonry/masonry-shape.h"
#include "io/project/project-masonry.h"
#include <glib/gi18n.h>

/* What is cut. */
typedef struct Opening {
  QnCanvas *canvas; /* whose gesture says where */
  QnId object;
  int number;
} Opening;

/* The object whose rectangle contains a point, the last one first, or QN_NONE. */
static QnId
wall_at (const QnMasonries *list, QnVec2 point)
{
  for (gsize i = list->count; i > 0; i--) {
    if (list->items[i - 1].kind == QN_MASONRY_WALL
        && qn_masonry_wall_contains (&list->items[i - 1], point))
      return (QnId) (i - 1);
  }
  return QN_NONE;
}

static QnId
wall_of_gesture (const QnMasonries *list, const QnGesture *gesture)
{
  QnId wall = wall_at (list, qn_vec2_lerp (gesture->from, gesture->to, 0.5));
  return wall != QN_NONE ? wall : wall_at (list, gesture->from);
}

/* The opening that the gesture makes in a wall; FALSE where it is none. */
static gboolean
plan_opening (QnCanvas *canvas, const QnMasonry *wall, QnOpening *plan)
{
  return qn_plan_opening (wall, &canvas->settings->masonry, canvas->gesture.from,
                          canvas->gesture.to, qn_canvas_snaps (canvas), plan);
}

static gboolean
add_opening (QnMasonry *masonry, gpointer data, GError **error)
{
  Opening *o = data;
  QnOpening plan;
  if (!plan_opening (o->canvas, masonry, &plan))
    return qn_edit_refuse (
      error, _ ("The opening is smaller than half a block or outside the wall"));
  *qn_masonry_add_opening (masonry) = plan;
  o->number = (int) masonry->wall.opening_count - 1;
  return TRUE;
}

/* A wall that is listed course by course becomes an object first. */
static gboolean
cut (QnProject *draft, Opening *o, GError **error)
{
  QnMasonries list;
  if (!qn_project_get_masonry (draft, &list, error))
    return FALSE;
  o->object = wall_of_gesture (&list, &o->canvas->gesture);
  gsize count = list.count;
  qn_masonries_clear (&list);
  if (o->object == QN_NONE) {
    QnId wall = qn_model_wall_at (
      &draft->model, qn_vec2_lerp (o->canvas->gesture.from, o->canvas->gesture.to, 0.5));
    if (wall == QN_NONE)
      return qn_edit_refuse (error, _ ("Openings are cut into walls: drag on a wall"));
    if (!qn_edit_convert_wall (draft, wall, error))
      return FALSE;
    o->object = (QnId) count;
  }
  return qn_edit_change_masonry (draft, o->object, add_opening, o, error);
}

static void
complete (QnCanvas *canvas)
{
  const QnGesture *gesture = &canvas->gesture;
  Opening opening = { .canvas = canvas };
  QnCanvasDraft draft;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (gesture->from.x != gesture->to.x && gesture->from.y != gesture->to.y
      && qn_canvas_begin_edit (canvas, &draft)
      && qn_canvas_end_edit (canvas, &draft, _ ("Cut Opening"), NULL,
                             cut (&draft.project, &opening, &draft.error)))
    qn_selection_set_opening (canvas->selection, opening.object, opening.number);
}

static void
fill_at (QnCanvas *canvas, QnVec2 at)
{
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  const QnId object = wall_at (list, at);
  const int number =
    object != QN_NONE ? qn_masonry_opening_at (&list->items[object], at) : QN_NO_OPENING;
  QnCanvasDraft draft;
  if (number == QN_NO_OPENING)
    return;
  qn_selection_clear (canvas->selection);
  if (qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (
      canvas, &draft, _ ("Fill Opening"), NULL,
      qn_edit_remove_opening (&draft.project, object, (gsize) number, &draft.error));
}

/* ---- the one that is selected, by its handles ---- */

static gboolean
has_opening (QnCanvas *canvas)
{
  return canvas->selection->object != QN_NONE;
}

static gboolean
drags_handle (QnCanvas *canvas)
{
  return canvas->gesture.grip.kind != QN_GRIP_NONE;
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGrip grip;
  if (event->modifiers & GDK_SHIFT_MASK)
    fill_at (canvas, event->model);
  else if (!canvas->in_gesture && has_opening (canvas)
           && qn_handle_find (canvas, event->screen, &grip)) {
    canvas->gesture.from_screen = event->screen;
    qn_handle_begin (canvas, grip);
  } else
    qn_gesture_press (canvas, event);
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (!drags_handle (canvas))
    qn_gesture_release (canvas, event);
  else if (qn_canvas_is_drag (canvas, event))
    qn_handle_finish (canvas);
  else
    qn_canvas_set_in_gesture (canvas, FALSE);
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  return !drags_handle (canvas) && qn_gesture_rectangle_numbers (canvas, values, count);
}

static void
draw_ready (QnCanvas *canvas, cairo_t *cr)
{
  if (has_opening (canvas))
    qn_handle_draw_all (canvas, cr);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  if (drags_handle (canvas)) {
    qn_handle_draw_drag (canvas, cr);
    return;
  }
  const QnMasonries *list = qn_canvas_get_masonry (canvas);
  QnId wall = wall_of_gesture (list, &canvas->gesture);
  QnOpening plan;
  if (wall == QN_NONE || !plan_opening (canvas, &list->items[wall], &plan)) {
    qn_gesture_draw_rectangle (canvas, cr, canvas->gesture.from, canvas->gesture.to);
    return;
  }
  const QnMasonry *masonry = &list->items[wall];
  QnVec2 far = qn_vec2_add (plan.at, qn_vec2 (plan.width, plan.height));
  if (masonry->rotation == 0.0) {
    qn_gesture_draw_rectangle (canvas, cr, qn_masonry_to_model (masonry, plan.at),
                               qn_masonry_to_model (masonry, far));
    return;
  }
  QnVec2 corners[] = { qn_masonry_to_model (masonry, plan.at),
                       qn_masonry_to_model (masonry, qn_vec2 (far.x, plan.at.y)),
                       qn_masonry_to_model (masonry, far),
                       qn_masonry_to_model (masonry, qn_vec2 (plan.at.x, far.y)) };
  qn_canvas_trace (canvas, cr, corners, G_N_ELEMENTS (corners));
  qn_gesture_paint (cr);
}

const QnTool qn_tool_opening = {
  .name = "opening",
  .icon = "quoin-opening-symbolic",
  .label = N_ ("Opening"),
  .hint = N_ ("Drag on a wall: window or door; Shift+click fills an opening"),
  .accel = "o",
  .numbers_label = N_ ("width; height"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .press = press,
  .motion = qn_gesture_motion,
  .release = release,
  .numbers = numbers,
  .complete = complete,
  .draw_ready = draw_ready,
  .draw = draw,
};
