#include "app/canvas/gesture.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>
#include <math.h>

/* Objects with more blocks are drawn as a frame while they are dragged. */
#define MOST_DRAWN_BLOCKS 3000

/* px, of words about a point from it. */
#define LABEL_ASIDE 10.0

#define ANGLE_STEP (G_PI / 12.0)

/* A line is level or upright within so many px and this part of its length. */
#define STRAIGHT_PX   9.0
#define STRAIGHT_PART 0.1

void
qn_gesture_complete (QnCanvas *canvas)
{
  const QnTool *tool = canvas->tool;
  const QnGesture *gesture = &canvas->gesture;
  const gboolean x = gesture->from.x != gesture->to.x,
                 y = gesture->from.y != gesture->to.y;
  QnCanvasDraft draft;
  if (tool->complete != NULL) {
    tool->complete (canvas);
    return;
  }
  gboolean done = (tool->least_points > 0 || (tool->wide ? x && y : x || y))
                  && qn_canvas_begin_edit (canvas, &draft);
  if (done) {
    draft.step = tool->step;
    done = tool->edit (canvas, &draft, gesture);
    done = qn_canvas_end_edit (canvas, &draft, _ (draft.step), NULL, done);
  }
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (done && tool->added != NULL)
    tool->added (canvas);
}

void
qn_gesture_press (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->in_gesture) {
    canvas->tool->motion (canvas, event);
    qn_gesture_complete (canvas);
    return;
  }
  canvas->gesture.from = canvas->gesture.to = event->point;
  canvas->gesture.from_screen = event->screen;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

void
qn_gesture_motion (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->in_gesture)
    canvas->gesture.to = event->point;
}

/* Where a line ends that is level or upright but for a few px: it is so then, unless a corner, node or middle is
 * meant, or an edge that it would leave. */
static QnVec2
straighten (QnCanvas *canvas, const QnToolEvent *event)
{
  const QnVec2 from = canvas->gesture.from, to = event->point;
  const QnVec2 edge = qn_vec2_sub (event->hit.b, event->hit.a);
  const double x = fabs (to.x - from.x), y = fabs (to.y - from.y);
  const double reach = STRAIGHT_PX / canvas->camera.scale;
  const QnMagnetKind kind = event->hit.kind;
  if (!qn_canvas_snaps (canvas) || (kind != QN_MAGNET_NOTHING && kind < QN_MAGNET_EDGE))
    return to;
  if (y < fmin (reach, STRAIGHT_PART * x) && (kind != QN_MAGNET_EDGE || edge.x == 0.0))
    return qn_vec2 (to.x, from.y);
  if (x < fmin (reach, STRAIGHT_PART * y) && (kind != QN_MAGNET_EDGE || edge.y == 0.0))
    return qn_vec2 (from.x, to.y);
  return to;
}

void
qn_gesture_motion_straight (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (!canvas->in_gesture)
    return;
  gesture->to = straighten (canvas, event);
  if ((event->modifiers & GDK_SHIFT_MASK) == 0)
    return;
  QnVec2 d = qn_vec2_sub (event->model, gesture->from);
  double angle = round (atan2 (d.y, d.x) / ANGLE_STEP) * ANGLE_STEP;
  QnVec2 direction = qn_vec2 (cos (angle), sin (angle));
  gesture->to = qn_vec2_add_scaled (gesture->from, qn_vec2_dot (d, direction), direction);
}

void
qn_gesture_release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (!canvas->in_gesture || !qn_canvas_is_drag (canvas, event))
    return;
  canvas->tool->motion (canvas, event);
  qn_gesture_complete (canvas);
}

gboolean
qn_gesture_rectangle_numbers (QnCanvas *canvas, const double *values, int count)
{
  QnGesture *gesture = &canvas->gesture;
  if (count != 2)
    return FALSE;
  /* Towards the side on which the pointer is. */
  double right = gesture->to.x < gesture->from.x ? -1.0 : 1.0;
  double up = gesture->to.y < gesture->from.y ? -1.0 : 1.0;
  gesture->to =
    qn_vec2 (gesture->from.x + right * values[0], gesture->from.y + up * values[1]);
  qn_gesture_complete (canvas);
  return TRUE;
}

gboolean
qn_gesture_typed_way (const QnGesture *gesture, const double *values, int count,
                      QnVec2 *way)
{
  if (count < 1 || count > 2)
    return FALSE;
  QnVec2 d = qn_vec2_sub (gesture->to, gesture->from);
  double angle = count == 2 ? values[1] : atan2 (d.y, d.x);
  *way = qn_vec2_scale (values[0], qn_vec2 (cos (angle), sin (angle)));
  return TRUE;
}

gboolean
qn_gesture_line_numbers (QnCanvas *canvas, const double *values, int count)
{
  QnVec2 way;
  if (!qn_gesture_typed_way (&canvas->gesture, values, count, &way))
    return FALSE;
  canvas->gesture.to = qn_vec2_add (canvas->gesture.from, way);
  qn_gesture_complete (canvas);
  return TRUE;
}

/* ---- many points ---- */

void
qn_gesture_press_point (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (event->press_count == 2 && gesture->points->len >= canvas->tool->least_points)
    qn_gesture_complete (canvas);
  else if (event->press_count == 1) {
    g_array_append_val (gesture->points, event->point);
    gesture->to = event->point;
    qn_canvas_set_in_gesture (canvas, TRUE);
  }
}

gboolean
qn_gesture_point_numbers (QnCanvas *canvas, const double *values, int count)
{
  GArray *points = canvas->gesture.points;
  if (count == 0 && points->len >= canvas->tool->least_points) {
    qn_gesture_complete (canvas);
    return TRUE;
  }
  if (count != 2 || points->len == 0)
    return FALSE;
  QnVec2 last = g_array_index (points, QnVec2, points->len - 1);
  QnVec2 next = qn_vec2 (last.x + values[0], last.y + values[1]);
  g_array_append_val (points, next);
  return TRUE;
}

void
qn_gesture_trace_points (QnCanvas *canvas, cairo_t *cr)
{
  const QnGesture *gesture = &canvas->gesture;
  for (guint i = 0; i <= gesture->points->len; i++) {
    QnVec2 s = qn_canvas_to_screen (canvas, i < gesture->points->len
                                              ? g_array_index (gesture->points, QnVec2, i)
                                              : gesture->to);
    cairo_line_to (cr, s.x, s.y);
  }
}

/* ---- drawing ---- */

void
qn_gesture_stroke (cairo_t *cr, GdkRGBA below, double wide, GdkRGBA ink, double narrow)
{
  gdk_cairo_set_source_rgba (cr, &below);
  cairo_set_line_width (cr, wide);
  cairo_stroke_preserve (cr);
  gdk_cairo_set_source_rgba (cr, &ink);
  cairo_set_line_width (cr, narrow);
  cairo_stroke (cr);
}

void
qn_gesture_paint (cairo_t *cr)
{
  cairo_set_source_rgba (cr, 0.1, 0.4, 0.9, 0.15);
  cairo_fill_preserve (cr);
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
  cairo_set_line_width (cr, 1.5);
  cairo_stroke (cr);
}

void
qn_gesture_draw_frame (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  QnVec2 corners[] = { a, { b.x, a.y }, b, { a.x, b.y } };
  qn_canvas_trace (canvas, cr, corners, G_N_ELEMENTS (corners));
  qn_gesture_paint (cr);
}

void
qn_gesture_draw_rectangle (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  qn_gesture_draw_frame (canvas, cr, a, b);
  double low = MIN (a.y, b.y), right = MAX (a.x, b.x);
  qn_canvas_draw_dimension (canvas, cr, qn_vec2 (a.x, low), qn_vec2 (b.x, low));
  qn_canvas_draw_dimension (canvas, cr, qn_vec2 (right, a.y), qn_vec2 (right, b.y));
}

void
qn_gesture_draw_line (QnCanvas *canvas, cairo_t *cr, QnVec2 a, QnVec2 b)
{
  qn_canvas_trace_line (canvas, cr, a, b);
  cairo_set_source_rgb (cr, 0.1, 0.4, 0.9);
  cairo_set_line_width (cr, 2.0);
  cairo_stroke (cr);
  if (qn_vec2_length (qn_vec2_sub (b, a)) > 0.0)
    qn_canvas_draw_dimension (canvas, cr, a, b);
}

void
qn_gesture_draw_words (QnCanvas *canvas, cairo_t *cr, const char *text, QnVec2 at)
{
  QnVec2 screen = qn_canvas_to_screen (canvas, at);
  qn_canvas_draw_label (canvas, cr, text,
                        qn_vec2 (screen.x + LABEL_ASIDE, screen.y + LABEL_ASIDE));
}

char *
qn_gesture_dup_angle (const QnGesture *gesture)
{
  const QnVec2 way = qn_vec2_sub (gesture->to, gesture->from);
  return qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_ANGLE,
                               atan2 (way.y, way.x), 4);
}

void
qn_gesture_draw_held (QnCanvas *canvas, cairo_t *cr,
                      char *(*dup_text) (const QnModel *model, QnVec2 at))
{
  const QnVec2 ends[] = { canvas->gesture.from, canvas->gesture.to };
  g_autofree char *angle = qn_gesture_dup_angle (&canvas->gesture);
  qn_gesture_draw_line (canvas, cr, ends[0], ends[1]);
  for (gsize i = 0; i < G_N_ELEMENTS (ends); i++) {
    g_autofree char *held = dup_text (qn_canvas_get_model (canvas), ends[i]);
    g_autofree char *text =
      i == 0 ? g_strdup (held) : g_strconcat (angle, "; ", held, NULL);
    /* Beside the length, which stands at the middle of the line. */
    const double aside =
      i == 0 && ends[1].y <= ends[0].y ? -3 * LABEL_ASIDE : LABEL_ASIDE;
    const QnVec2 screen = qn_canvas_to_screen (canvas, ends[i]);
    qn_canvas_draw_label (canvas, cr, text,
                          qn_vec2 (screen.x + LABEL_ASIDE, screen.y + aside));
  }
}

void
qn_gesture_draw_masonry (QnCanvas *canvas, cairo_t *cr, const QnMasonry *masonry)
{
  if (!(qn_masonry_estimate_blocks (masonry) <= MOST_DRAWN_BLOCKS))
    return;
  QnMasonry named = *masonry;
  named.name = masonry->name != NULL ? masonry->name : (char *) "new";
  QnModel model;
  qn_model_init (&model);
  if (qn_masonry_expand (&named, 0, &model, NULL) == QN_OK) {
    for (QnId i = 0; i < (QnId) model.block_count; i++)
      qn_canvas_trace (canvas, cr, qn_model_block_vertices (&model, i),
                       (gsize) model.blocks[i].vertex_count);
    qn_gesture_paint (cr);
  }
  qn_model_clear (&model);
}

void
qn_gesture_trace_block (QnCanvas *canvas, cairo_t *cr, QnId block, QnTransform transform)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  gsize n = (gsize) model->blocks[block].vertex_count;
  const QnVec2 *v = qn_model_block_vertices (model, block);
  g_autofree QnVec2 *moved = g_new (QnVec2, n);
  for (gsize k = 0; k < n; k++)
    moved[k] = qn_transform_apply (transform, v[k]);
  qn_canvas_trace (canvas, cr, moved, n);
}

void
qn_gesture_draw_moved (QnCanvas *canvas, cairo_t *cr, QnTransform transform)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnPartSet set = qn_selection_get_parts (canvas->selection);
  for (guint i = 0; i < set.blocks.count; i++)
    qn_gesture_trace_block (canvas, cr, set.blocks.ids[i], transform);
  qn_gesture_paint (cr);
  for (guint i = 0; i < set.beams.count; i++) {
    const QnId *ends = model->beams[set.beams.ids[i]].nodes;
    QnVec2 line[2] = { qn_transform_apply (transform, model->nodes[ends[0]].at),
                       qn_transform_apply (transform, model->nodes[ends[1]].at) };
    qn_canvas_trace (canvas, cr, line, 2);
  }
  cairo_stroke (cr);
}
