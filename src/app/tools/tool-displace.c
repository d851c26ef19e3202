/* Initial displacement: drag a block to where an analysis in time lets it go; Shift turns it about the
 * lower corner of the side that it is drawn to, as it would rock. Numbers are the displacement of
 * every selected block. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "app/widgets/settings.h"
#include "doc/edit/edit-dynamic.h"

#include <glib/gi18n.h>
#include <math.h>

/* Corners so near to the lowest, over the height, are as low. */
#define AS_LOW 1e-3

typedef struct Displacement {
  QnBlockSet set;
  QnTransform transform;
  double angle;
  const double *typed; /* of the centroid; NULL: as the transform has it */
} Displacement;

static gboolean
edit_displace (QnModel *model, const Displacement *d, GError **error)
{
  if (d->typed == NULL)
    return qn_edit_displace (model, d->set, d->transform, d->angle, error);
  for (guint i = 0; i < d->set.count; i++) {
    QnInitialMotion motion = qn_initial_motion_of (model, d->set.ids[i]);
    if (!qn_edit_set_initial (model, (QnBlockSet){ d->set.ids + i, 1 }, d->typed,
                              motion.velocity, error))
      return FALSE;
  }
  return TRUE;
}

/* The lower corner of what is selected on the side that it is drawn to. */
static QnVec2
find_pivot (QnCanvas *canvas, gboolean right)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  QnVec2 low = { 0 }, high = { 0 };
  QnBlockSet set = qn_canvas_get_selected (canvas);
  qn_canvas_get_parts_box (canvas, &low, &high);
  double level = low.y + AS_LOW * (high.y - low.y);
  QnVec2 pivot = qn_vec2 (right ? -INFINITY : INFINITY, low.y);
  for (guint i = 0; i < set.count; i++) {
    const QnVec2 *v = qn_model_block_vertices (model, set.ids[i]);
    for (QnId k = 0; k < model->blocks[set.ids[i]].vertex_count; k++)
      if (v[k].y <= level && (right ? v[k].x > pivot.x : v[k].x < pivot.x))
        pivot = v[k];
  }
  return pivot;
}

static QnTransform
transform_of (QnCanvas *canvas, double *angle)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnVec2 way = qn_vec2_sub (gesture->to, gesture->from);
  *angle = 0.0;
  if (!gesture->turning)
    return qn_transform_translation (way.x, way.y);
  QnVec2 pivot = find_pivot (canvas, way.x >= 0.0);
  QnVec2 from = qn_vec2_sub (gesture->from, pivot), to = qn_vec2_sub (gesture->to, pivot);
  *angle = atan2 (qn_vec2_cross (from, to), qn_vec2_dot (from, to));
  return qn_transform_rotation (pivot, *angle);
}

static void
displace (QnCanvas *canvas, Displacement d)
{
  QnCanvasDraft draft;
  d.set = qn_canvas_get_selected (canvas);
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (d.set.count == 0)
    qn_canvas_tell (canvas, _ ("Select the blocks that start from elsewhere"));
  else if (qn_canvas_begin_edit (canvas, &draft))
    qn_canvas_end_edit (canvas, &draft, _ ("Set Initial Displacement"), NULL,
                        edit_displace (draft.model, &d, &draft.error));
}

static void
complete (QnCanvas *canvas)
{
  Displacement d = { 0 };
  d.transform = transform_of (canvas, &d.angle);
  displace (canvas, d);
}

static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  double typed[QN_DOF_COUNT] = { 0 };
  if (count < 1 || count > QN_DOF_COUNT)
    return FALSE;
  for (int i = 0; i < count; i++)
    typed[i] = values[i];
  displace (canvas, (Displacement){ .typed = typed });
  return TRUE;
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnSelection *selection = qn_canvas_get_selection (canvas);
  QnViewState *state = qn_canvas_get_state (canvas);
  if (!qn_canvas_is_in_gesture (canvas)) {
    /* Blocks start from where the model has them, whatever a result shows. */
    if (qn_view_needs_result (qn_view_state_get_view (state)))
      qn_view_state_set_view (state, QN_VIEW_MODEL);
    QnPick pick = qn_canvas_pick (canvas, event->screen, 1u << QN_PICK_BLOCK);
    if (pick.kind != QN_PICK_BLOCK)
      return;
    if (!qn_selection_has (selection, QN_PART_BLOCK, pick.id))
      qn_selection_set (selection, QN_PART_BLOCK, &pick.id, 1);
  }
  qn_gesture_press (canvas, event);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = qn_canvas_get_gesture (canvas);
  qn_gesture_motion (canvas, event);
  gesture->turning = (event->modifiers & GDK_SHIFT_MASK) != 0;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = qn_canvas_get_gesture (canvas);
  QnUnits units = qn_settings_get_units ();
  double angle;
  QnTransform transform = transform_of (canvas, &angle);
  qn_gesture_draw_moved (canvas, cr, transform);
  QnVec2 at = qn_canvas_to_screen (canvas, gesture->to);
  QnVec2 way = qn_vec2_sub (gesture->to, gesture->from);
  g_autofree char *x = qn_units_format_full (units, QN_QUANTITY_LENGTH, way.x, 3);
  g_autofree char *y = qn_units_format_full (units, QN_QUANTITY_LENGTH, way.y, 3);
  g_autofree char *turn = qn_units_format_full (units, QN_QUANTITY_ANGLE, angle, 3);
  g_autofree char *text =
    gesture->turning ? g_strdup (turn) : g_strdup_printf ("%s; %s", x, y);
  qn_canvas_draw_label (canvas, cr, text, qn_vec2 (at.x + 14.0, at.y - 24.0));
}

const QnTool qn_tool_displace = {
  .name = "displace",
  .icon = "quoin-displace-symbolic",
  .label = N_ ("Initial Displacement"),
  .hint =
    N_ ("Drag a block to where an analysis in time lets it go; Shift turns it about "
        "its lower corner; or select blocks and type “right; up; angle”, 0 for none"),
  .accel = "d",
  .magnetic = TRUE,
  .numbers_label = N_ ("right; up; angle"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_ANGLE },
  .numbers_at_rest = TRUE,
  .press = press,
  .motion = motion,
  .release = qn_gesture_release,
  .numbers = numbers,
  .complete = complete,
  .draw = draw,
};
