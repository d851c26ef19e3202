/* Wall, and column, buttress, portal or rubble: a dragged rectangle becomes parametric masonry. */
#include "app/canvas/gesture.h"
#include "app/tools/tools.h"

#include "doc/edit/edit-masonry.h"
#include <glib/gi18n.h>

/* What the gesture would lay, by the current tool. */
static void
make_plan (QnCanvas *canvas, QnMasonry *masonry)
{
  const QnMasonryStyle *style = &canvas->settings->masonry;
  (canvas->tool == &qn_tool_wall ? qn_plan_wall : qn_plan_in_box) (
    masonry, style, canvas->gesture.from, canvas->gesture.to);
}

static gboolean
edit (QnCanvas *canvas, QnCanvasDraft *draft, const QnGesture *gesture)
{
  static const char *const steps[QN_MASONRY_NAME_COUNT] = {
    [QN_MASONRY_WALL] = N_ ("Add Wall"),
    [QN_MASONRY_COLUMN] = N_ ("Add Column"),
    [QN_MASONRY_BUTTRESS] = N_ ("Add Buttress"),
    [QN_MASONRY_PORTAL] = N_ ("Add Portal"),
    [QN_MASONRY_RUBBLE] = N_ ("Add Rubble"),
    [QN_MASONRY_GRID] = N_ ("Add Grid of Cells"),
    [QN_MASONRY_VORONOI] = N_ ("Add Voronoi Cells"),
  };
  QnMasonry masonry;
  draft->step = steps[canvas->tool == &qn_tool_wall ? QN_MASONRY_WALL
                                                    : canvas->settings->masonry.kind];
  make_plan (canvas, &masonry);
  return qn_edit_add_masonry (&draft->project, &masonry, &draft->error);
}

/* The frame is that of whole blocks where a wall has rounded it. */
static void
draw (QnCanvas *canvas, cairo_t *cr)
{
  QnMasonry masonry;
  make_plan (canvas, &masonry);
  QnVec2 from = canvas->gesture.from, to = canvas->gesture.to;
  if (masonry.kind == QN_MASONRY_WALL) {
    from = masonry.origin;
    to = qn_vec2 (from.x + masonry.wall.leaves[0].length, from.y + masonry.wall.height);
  }
  qn_gesture_draw_masonry (canvas, cr, &masonry);
  qn_gesture_draw_rectangle (canvas, cr, from, to);
  qn_masonry_clear (&masonry);
}

const QnTool qn_tool_wall = {
  .name = "wall",
  .begins = TRUE,
  .icon = "quoin-wall-symbolic",
  .label = N_ ("Wall"),
  .hint =
    N_ ("Drag a rectangle: it becomes a bonded wall; or click a corner and type width; "
        "height"),
  .accel = "w",
  QN_GESTURE_RECTANGLE,
  .edit = edit,
  .draw = draw,
};

const QnTool qn_tool_column = {
  .name = "column",
  .begins = TRUE,
  .icon = "quoin-column-symbolic",
  .label = N_ ("Column"),
  .hint =
    N_ ("Drag a rectangle: it becomes a column of drums, or, chosen in the panel, a "
        "buttress, portal, rubble or cells; or click a corner and type width; height"),
  .accel = "c",
  QN_GESTURE_RECTANGLE,
  .edit = edit,
  .draw = draw,
};
