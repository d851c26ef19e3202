/* Picture behind the drawing: drag it; click two points on it and type how far they are from each
 * other; or click the corners of what is a rectangle in truth and type its width and height. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/document/underlay.h"
#include "render/drawing/rectify.h"
#include <glib/gi18n.h>
#include <string.h>

#define MARK_PX 7.0

static void
place (QnCanvas *canvas, const char *name, const QnUnderlay *underlay)
{
  g_autoptr (GError) error = NULL;
  QnUnderlay wanted = *underlay;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (!qn_document_place_picture (canvas->document, name, NULL, &wanted, &error))
    qn_canvas_tell (canvas, error->message);
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (canvas->state->options.underlay.image == NULL) {
    gtk_widget_activate_action (GTK_WIDGET (canvas), "win.picture", NULL);
    return;
  }
  gesture->from = gesture->to = event->model;
  gesture->from_screen = event->screen;
  gesture->dragging = FALSE;
  gesture->band = TRUE; /* the button is down */
}

/* The picture follows the pointer from where it was last, so that what was gripped comes to where the magnet
 * has the pointer. */
static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (!gesture->band)
    return;
  if (!gesture->dragging && !qn_canvas_is_drag (canvas, event))
    return;
  if (!gesture->dragging) {
    g_array_set_size (gesture->points, 0);
    qn_canvas_set_in_gesture (canvas, TRUE);
    gesture->dragging = TRUE;
  }
  QnVec2 *origin = &canvas->state->options.underlay.origin;
  *origin = qn_vec2_add (*origin, qn_vec2_sub (event->point, gesture->to));
  gesture->to = event->point;
  qn_view_state_changed (canvas->state);
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  if (!gesture->band)
    return;
  gesture->band = FALSE;
  if (gesture->dragging) {
    place (canvas, _ ("Move Picture"), &canvas->state->options.underlay);
    return;
  }
  if (gesture->points->len >= 4)
    g_array_set_size (gesture->points, 0);
  g_array_append_val (gesture->points, event->model);
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static gboolean
rectify (QnCanvas *canvas, double width, double height)
{
  QnVec2 shown[4];
  memcpy (shown, canvas->gesture.points->data, sizeof shown);
  QnUnderlay underlay = canvas->state->options.underlay;
  if (!qn_underlay_rectify (&underlay, shown, width, height)) {
    qn_canvas_tell (canvas, _ ("These four points cannot be the corners of a rectangle"));
    return FALSE;
  }
  underlay.origin = qn_canvas_snap (canvas, underlay.origin);
  place (canvas, _ ("Rectify Picture"), &underlay);
  return TRUE;
}

/* The distance of the two points, or width and height of the rectangle whose corners the four points are. The
 * first point, or the lower left corner, comes to where the magnet has it. */
static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  QnGesture *gesture = &canvas->gesture;
  if (count == 2 && gesture->points->len == 4)
    return rectify (canvas, values[0], values[1]);
  if (count != 1 || !(values[0] > 0.0) || gesture->points->len != 2)
    return FALSE;
  QnVec2 shown[] = { g_array_index (gesture->points, QnVec2, 0),
                     g_array_index (gesture->points, QnVec2, 1) };
  QnVec2 across = qn_vec2_sub (shown[1], shown[0]);
  double length = qn_vec2_length (across);
  if (!(length > 0.0))
    return FALSE;
  const QnVec2 start = qn_canvas_snap (canvas, shown[0]);
  QnVec2 wanted[] = { start, qn_vec2_add_scaled (start, values[0] / length, across) };
  QnUnderlay scaled = canvas->state->options.underlay;
  if (!qn_underlay_match (&scaled, shown, wanted))
    return FALSE;
  place (canvas, _ ("Scale Picture"), &scaled);
  return TRUE;
}

/* A picture that was being dragged goes back to where the document has it. */
static void
cancel (QnCanvas *canvas)
{
  canvas->gesture.band = FALSE;
  qn_view_state_refresh_underlay (canvas->state);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const GArray *points = canvas->gesture.points;
  if (points->len == 2)
    qn_canvas_draw_dimension (canvas, cr, g_array_index (points, QnVec2, 0),
                              g_array_index (points, QnVec2, 1));
  QnVec2 corners[4];
  if (points->len == 4) {
    memcpy (corners, points->data, sizeof corners);
    qn_rectify_sort (corners);
  }
  for (guint i = 0; points->len == 4 && i < 4; i++) {
    QnVec2 s = qn_canvas_to_screen (canvas, corners[i]);
    cairo_line_to (cr, s.x, s.y);
  }
  cairo_close_path (cr);
  for (guint i = 0; i < points->len; i++) {
    QnVec2 s = qn_canvas_to_screen (canvas, g_array_index (points, QnVec2, i));
    cairo_move_to (cr, s.x - MARK_PX, s.y);
    cairo_rel_line_to (cr, 2.0 * MARK_PX, 0.0);
    cairo_move_to (cr, s.x, s.y - MARK_PX);
    cairo_rel_line_to (cr, 0.0, 2.0 * MARK_PX);
    cairo_new_sub_path (cr);
    cairo_arc (cr, s.x, s.y, 0.5 * MARK_PX, 0.0, 2.0 * G_PI);
  }
  qn_gesture_stroke (cr, (GdkRGBA){ 1.0f, 1.0f, 1.0f, 1.0f }, 4.0,
                     (GdkRGBA){ 0.75f, 0.0f, 0.4f, 1.0f }, 1.5);
}

const QnTool qn_tool_picture = {
  .name = "picture",
  .icon = "quoin-picture-symbolic",
  .label = N_ ("Place the Picture"),
  .hint =
    N_ ("Drag to move; click two points and type their distance, or four corners of a "
        "rectangle and type its width; height"),
  .accel = "i",
  .numbers_label = N_ ("distance, or width; height"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
  .press = press,
  .motion = motion,
  .release = release,
  .numbers = numbers,
  .cancel = cancel,
  .draw = draw,
};
