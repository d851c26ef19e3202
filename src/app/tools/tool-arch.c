/* Arch: first the span, from springing to springing, then the rise. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "core/base/integer.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

/* Rise of which the user says nothing, in parts of the span. */
#define USUAL_RISE 0.3

enum { PHASE_SPAN, PHASE_RISE };

typedef struct Arch {
  QnMasonryStyle style;
  QnVec2 left, right;
  double rise;
} Arch;

/* The crown is above, whichever way the span was drawn; of an upright one, to its left. */
static Arch
arch_of_gesture (QnCanvas *canvas)
{
  const QnGesture *gesture = &canvas->gesture;
  Arch arch = { canvas->settings->masonry, gesture->from, gesture->to, 0.0 };
  if (gesture->phase == PHASE_RISE)
    arch.right = g_array_index (gesture->points, QnVec2, 0);
  if (arch.left.x > arch.right.x) {
    QnVec2 left = arch.right;
    arch.right = arch.left;
    arch.left = left;
  }
  double span = qn_vec2_length (qn_vec2_sub (arch.right, arch.left));
  arch.rise = gesture->phase == PHASE_RISE
                ? qn_plan_arch_rise (arch.left, arch.right, gesture->to)
                : USUAL_RISE * span;
  return arch;
}

static void
add (QnCanvas *canvas, Arch arch)
{
  QnCanvasDraft draft;
  QnMasonry masonry;
  qn_canvas_set_in_gesture (canvas, FALSE);
  if (!qn_canvas_begin_edit (canvas, &draft))
    return;
  qn_plan_arch (&masonry, &arch.style, arch.left, arch.right, arch.rise);
  qn_canvas_end_edit (canvas, &draft, _ ("Add Arch"), NULL,
                      qn_edit_add_masonry (&draft.project, &masonry, &draft.error));
}

/* The span is known: on to the rise; or all is. */
static void
complete (QnCanvas *canvas)
{
  QnGesture *gesture = &canvas->gesture;
  if (gesture->phase == PHASE_RISE) {
    add (canvas, arch_of_gesture (canvas));
    return;
  }
  QnVec2 end = gesture->to;
  if (end.x == gesture->from.x && end.y == gesture->from.y) {
    qn_canvas_set_in_gesture (canvas, FALSE);
    return;
  }
  g_array_append_val (gesture->points, end);
  gesture->phase = PHASE_RISE;
}

static void
motion (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->gesture.phase == PHASE_SPAN)
    qn_gesture_motion_straight (canvas, event);
  else
    qn_gesture_motion (canvas, event);
}

/* The release that ends the span does not end the arch, and one that comes after it neither. */
static void
release (QnCanvas *canvas, const QnToolEvent *event)
{
  if (canvas->gesture.phase == PHASE_SPAN)
    qn_gesture_release (canvas, event);
}

/* Span, rise, thickness of the ring and number of voussoirs; or without the span once that is
 * drawn. What is not typed is as in the panel. */
static gboolean
numbers (QnCanvas *canvas, const double *values, int count)
{
  QnGesture *gesture = &canvas->gesture;
  Arch arch = arch_of_gesture (canvas);
  int first = gesture->phase == PHASE_SPAN ? 1 : 0;
  if (count < 1 || count > first + 3)
    return FALSE;
  if (gesture->phase == PHASE_SPAN) {
    QnVec2 d = qn_vec2_sub (gesture->to, gesture->from);
    double length = qn_vec2_length (d);
    QnVec2 direction = length > 0.0 ? qn_vec2_scale (1.0 / length, d) : qn_vec2 (1, 0);
    gesture->to = qn_vec2_add_scaled (gesture->from, values[0], direction);
    if (count == 1) {
      complete (canvas);
      return TRUE;
    }
    arch = arch_of_gesture (canvas);
  }
  if (count > first)
    arch.rise = values[first];
  if (count > first + 1)
    arch.style.ring = values[first + 1];
  if (count > first + 2)
    arch.style.voussoirs = (int32_t) qn_to_integer (values[first + 2], 2, 1000);
  add (canvas, arch);
  return TRUE;
}

static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  Arch arch = arch_of_gesture (canvas);
  QnMasonry masonry;
  if (qn_vec2_length (qn_vec2_sub (arch.right, arch.left)) > 0.0) {
    qn_plan_arch (&masonry, &arch.style, arch.left, arch.right, arch.rise);
    qn_gesture_draw_masonry (canvas, cr, &masonry);
    qn_masonry_clear (&masonry);
  }
  qn_gesture_draw_line (canvas, cr, arch.left, arch.right);
  if (canvas->gesture.phase == PHASE_RISE) {
    QnVec2 chord = qn_vec2_sub (arch.right, arch.left);
    double span = qn_vec2_length (chord);
    QnVec2 middle = qn_vec2_lerp (arch.left, arch.right, 0.5);
    QnVec2 crown = qn_vec2_add_scaled (middle, arch.rise / span, qn_vec2_perp (chord));
    qn_canvas_draw_dimension (canvas, cr, middle, crown);
  }
}

const QnTool qn_tool_arch = {
  .name = "arch",
  .begins = TRUE,
  .icon = "quoin-arch-symbolic",
  .label = N_ ("Arch"),
  .hint =
    N_ ("Drag from springing to springing, then click at the height of the crown; or "
        "type span; rise; thickness; voussoirs"),
  .accel = "a",
  .magnetic = TRUE,
  .numbers_label = N_ ("span; rise; thickness; voussoirs"),
  .quantities = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH,
                  QN_QUANTITY_NUMBER },
  .press = qn_gesture_press,
  .motion = motion,
  .release = release,
  .numbers = numbers,
  .complete = complete,
  .draw = draw,
};
