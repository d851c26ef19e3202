/* Edge load: click the edge of a block that is loaded, or drag along its edges from the first to the
 * last. Asked for by the list of loads, the same puts the selected load on other edges. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "app/widgets/settings.h"
#include <glib/gi18n.h>

/* px: an edge this near to the pointer is meant. */
#define REACH_PX 16.0

/* Phases of the gesture: the button is up, or down, for a new load or for the selected one. */
enum { UP, DOWN, UP_TO_CHANGE, DOWN_TO_CHANGE };

/* The edge under a place of the screen; with `of`, the one of this block that is nearest to it. */
static QnEdgeChain
edge_at (QnCanvas *canvas, QnVec2 screen, QnId of)
{
  const QnCamera *camera = &canvas->camera;
  return qn_model_find_edge (qn_canvas_get_model (canvas),
                             qn_camera_to_model (camera, screen),
                             of == QN_NONE ? REACH_PX / camera->scale : INFINITY, of);
}

/* From where the button went down to where the pointer is; the edge under the pointer before. */
static QnEdgeChain
find_chain (QnCanvas *canvas)
{
  const QnVec2 from = canvas->gesture.from_screen;
  QnEdgeChain first = edge_at (canvas, from, QN_NONE);
  if (first.block == QN_NONE || !canvas->gesture.dragging)
    return first;
  QnVec2 to = qn_canvas_to_screen (canvas, canvas->gesture.to);
  return qn_model_join_edges (qn_canvas_get_model (canvas), first,
                              edge_at (canvas, to, first.block));
}

typedef struct Put {
  QnEdgeChain chain;
  gboolean live;
  double intensity;
  QnId load; /* that gets the edges; QN_NONE: a new one */
} Put;

static gboolean
put_load (QnCanvas *canvas, const char *name, const Put *put)
{
  QnCanvasDraft draft;
  gboolean done = TRUE;
  if (!qn_canvas_begin_edit (canvas, &draft))
    return FALSE;
  if (put->load == QN_NONE)
    done = qn_edit_add_edge_load (draft.model, put->chain, put->live, put->intensity,
                                  &draft.error);
  else
    qn_load_set_chain (&qn_model_loads (draft.model, put->live, NULL)[put->load],
                       put->chain);
  return qn_canvas_end_edit (canvas, &draft, name, NULL, done);
}

static void
complete (QnCanvas *canvas)
{
  const QnToolSettings *settings = canvas->settings;
  Put put = { find_chain (canvas), settings->live, settings->intensity, QN_NONE };
  gboolean change = canvas->gesture.phase == DOWN_TO_CHANGE;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (put.chain.block == QN_NONE)
    qn_canvas_tell (canvas, _ ("There is no edge of a block here"));
  else if (!change) {
    /* The new load is selected, so that its numbers are there. */
    const QnPickKind kind = QN_PICK_LOAD (put.live);
    if (put_load (canvas, _ ("Add Edge Load"), &put))
      qn_selection_set_one (
        canvas->selection, kind,
        (QnId) qn_model_count_items (qn_canvas_get_model (canvas), kind) - 1);
  } else {
    const QnPick item = qn_selection_get_item (canvas->selection);
    const QnModel *model = qn_canvas_get_model (canvas);
    put.load = item.id;
    put.live = item.kind == QN_PICK_LIVE_LOAD;
    if (put.load != QN_NONE && (put.live || item.kind == QN_PICK_DEAD_LOAD)
        && qn_model_loads (model, put.live, NULL)[put.load].kind == QN_LOAD_EDGE)
      put_load (canvas, _ ("Choose Edges"), &put);
  }
}

static void
press (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  gesture->from_screen = event->screen;
  gesture->to = event->model;
  gesture->phase = gesture->phase == UP_TO_CHANGE ? DOWN_TO_CHANGE : DOWN;
  qn_canvas_set_in_gesture (canvas, TRUE);
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  QnGesture *gesture = &canvas->gesture;
  gesture->to = event->model;
  if (gesture->phase == UP || gesture->phase == UP_TO_CHANGE)
    gesture->from_screen = event->screen;
  else if (qn_canvas_is_drag (canvas, event))
    gesture->dragging = TRUE;
}

static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  motion (canvas, event);
  if (canvas->in_gesture)
    complete (canvas);
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  const QnModel *model = qn_canvas_get_model (canvas);
  const QnEdgeChain chain = find_chain (canvas);
  if (chain.block == QN_NONE)
    return;
  const QnVec2 *v = qn_model_block_vertices (model, chain.block);
  const QnId n = model->blocks[chain.block].vertex_count;
  double length = 0.0;
  for (QnId i = 0; i <= chain.count; i++) {
    const QnVec2 corner = v[(chain.first + i) % n];
    const QnVec2 at = qn_canvas_to_screen (canvas, corner);
    cairo_line_to (cr, at.x, at.y);
    if (i > 0)
      length += qn_vec2_length (qn_vec2_sub (corner, v[(chain.first + i - 1) % n]));
  }
  cairo_set_line_cap (cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join (cr, CAIRO_LINE_JOIN_ROUND);
  qn_gesture_stroke (cr, (GdkRGBA){ 0.1f, 0.4f, 0.9f, 0.3f }, 12.0,
                     (GdkRGBA){ 0.1f, 0.4f, 0.9f, 1.0f }, 3.0);
  g_autofree char *size =
    qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_LENGTH, length, 4);
  g_autofree char *text =
    g_strdup_printf ("%s: %s", model->blocks[chain.block].name, size);
  QnVec2 pointer = qn_canvas_to_screen (canvas, canvas->gesture.to);
  qn_canvas_draw_label (canvas, cr, text, qn_vec2 (pointer.x + 16.0, pointer.y + 12.0));
}

void
qn_tool_edge_load_choose (QnCanvas *canvas)
{
  gtk_widget_activate_action (GTK_WIDGET (canvas), "win.tool", "s", "edge-load");
  qn_canvas_set_in_gesture (canvas, TRUE);
  canvas->gesture.phase = UP_TO_CHANGE;
  gtk_widget_grab_focus (GTK_WIDGET (canvas));
}

const QnTool qn_tool_edge_load = {
  .name = "edge-load",
  .icon = "quoin-edge-load-symbolic",
  .label = N_ ("Edge Load"),
  .hint =
    N_ ("Click an edge of a block, or drag along several of its edges; the load pushes "
        "into the block; Escape leaves"),
  .accel = "q",
  .press = press,
  .motion = motion,
  .release = release,
  .complete = complete,
  .draw_ready = draw,
  .draw = draw,
};
