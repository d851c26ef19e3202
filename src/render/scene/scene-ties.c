/* Ties and soil. Ties are lines between their ends as these have moved, with a plate across either end; of
 * a result with the force, dashed where they hang slack, in the colour of what opens where they have their
 * strength. Soil is what lies between the surface of a fill and the blocks below it; and what it presses
 * beyond its active pressure, as arrows on the blocks. */
#include "core/model/outline.h"
#include "render/drawing/text.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

#define WIDTH_TIE   1.4F
#define WIDTH_PLATE 3.2F

/* Half the length of a plate, as a part of the structure's diagonal. */
#define PLATE 0.009

/* Legend texts of ties by state. */
static const char *const state_words[QN_TIE_STATE_COUNT] = {
  [QN_TIE_SLACK] = N_ ("tie, slack"),
  [QN_TIE_ELASTIC] = N_ ("tie, elastic"),
  [QN_TIE_YIELDS] = N_ ("tie that yields"),
  [QN_TIE_ANCHOR] = N_ ("tie whose anchor gives"),
};

static QnColor
color_of (const QnSceneBuilder *b, QnTieState state)
{
  return qn_builder_ink (b, state == QN_TIE_SLACK     ? QN_INK_FAINT
                            : state == QN_TIE_ELASTIC ? QN_INK_BAR
                                                      : QN_INK_OPEN);
}

static void
add_tie (QnSceneBuilder *b, size_t index, const QnTieResult *result)
{
  const QnTie *tie = &b->model->ties[index];
  const QnTieState state = result != NULL ? result->state : QN_TIE_ELASTIC;
  const QnColor color = color_of (b, state);
  QnVec2 line[2];
  for (int end = 0; end < 2; end++) {
    QnId block = tie->ends[end].block;
    line[end] = tie->ends[end].at;
    if (block != QN_NONE)
      line[end] = qn_builder_place (b, block, line[end]);
  }
  QnVec2 along = qn_vec2_sub (line[1], line[0]);
  QnVec2 across = qn_vec2_scale (
    PLATE * qn_box_diagonal (b->box) / qn_vec2_length (along), qn_vec2_perp (along));
  QnCommand *command =
    qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, 2, false, WIDTH_TIE, color);
  command->dashed = state == QN_TIE_SLACK;
  qn_command_set_pick (command, QN_PICK_TIE, (QnId) index);
  for (int end = 0; end < 2; end++) {
    QnVec2 plate[2] = { qn_vec2_sub (line[end], across),
                        qn_vec2_add (line[end], across) };
    qn_scene_stroke (b->scene, QN_LAYER_JOINTS, plate, 2, false, WIDTH_PLATE, color);
  }
  if (!b->options->names && (result == NULL || !b->options->symbols))
    return;
  g_autoptr (GString) label = g_string_new (b->options->names ? tie->name : NULL);
  if (result != NULL && b->options->symbols) {
    g_autofree char *force = qn_label_number ("%.3g", 1e-3 * result->force);
    g_string_append (label, label->len > 0 ? ": " : "");
    g_string_append_printf (label, _ ("%s kN"), force);
  }
  qn_scene_text (b->scene, QN_LAYER_LABELS, qn_vec2_lerp (line[0], line[1], 0.5),
                 QN_SIZE_LABEL, label->str, color)
    ->align_y = -0.4f;
}

/* ---- soil ------------------------------------------------------------------------------- */

/* Of the largest arrow, in sizes of blocks. */
#define ARROW 1.2

/* The lower side of a fill from right to left: the blocks seen from above, and where there are none its
 * lower end. */
static void
add_bottom (GArray *outline, const QnSeenEdges *top, const QnLoad *fill, double lowest)
{
  const double bottom = isfinite (fill->span[0]) ? fill->span[0] : lowest;
  const double from = fill->surface[0].x, to = fill->surface[fill->surface_count - 1].x;
  double x = to;
  for (size_t i = top->count; i > 0; i--) {
    QnVec2 left = top->items[i - 1].ends[1], right = top->items[i - 1].ends[0], ends[2];
    if (right.x <= from || left.x >= to)
      continue;
    if (right.x < x) {
      QnVec2 gap[] = { { x, bottom }, { right.x, bottom } };
      g_array_append_vals (outline, gap, 2);
    }
    for (int end = 0; end < 2; end++) {
      double at = fmin (fmax (end == 0 ? right.x : left.x, from), to);
      double y = left.y + (right.y - left.y) * ((at - left.x) / (right.x - left.x));
      ends[end] = qn_vec2 (at, fmin (y, qn_load_surface_at (fill, at)));
    }
    g_array_append_vals (outline, ends, 2);
    x = ends[1].x;
  }
  if (x > from) {
    QnVec2 gap[] = { { x, bottom }, { from, bottom } };
    g_array_append_vals (outline, gap, 2);
  }
}

void
qn_build_soil (QnSceneBuilder *b)
{
  const QnModel *model = b->model;
  const QnColor color = qn_builder_ink (b, QN_INK_SOIL);
  QnSeenEdges top = { 0 };
  QnPool room = { 0 };
  for (size_t i = 0; i < model->dead_load_count; i++) {
    const QnLoad *load = &model->dead_loads[i];
    if (load->kind != QN_LOAD_FILL)
      continue;
    if (top.items == NULL)
      qn_model_find_seen_edges (model, QN_BLOCK_SIDE_TOP, &top, &room);
    g_autoptr (GArray) outline = g_array_new (FALSE, FALSE, sizeof (QnVec2));
    g_array_append_vals (outline, load->surface, (guint) load->surface_count);
    add_bottom (outline, &top, load, b->box.min.y);
    QnCommand *fill = qn_scene_fill (b->scene, QN_LAYER_UNDERLAY,
                                     (const QnVec2 *) outline->data, outline->len, color);
    qn_command_set_pick (fill, QN_PICK_DEAD_LOAD, (QnId) i);
    qn_scene_stroke (b->scene, QN_LAYER_GHOST, load->surface,
                     (size_t) load->surface_count, false, 1.0F,
                     qn_builder_ink (b, QN_INK_DEAD_LOAD));
    qn_scene_legend (b->scene, QN_COMMAND_FILL, 0, color, "%s", _ ("fill"));
  }
  qn_pool_clear (&room);
}

static void
add_soil_forces (QnSceneBuilder *b, const QnTieResult *ties)
{
  const QnModel *model = b->model;
  const QnColor color = qn_builder_ink (b, QN_INK_DEAD_LOAD);
  double largest = 0;
  for (size_t i = 0; i < model->soil_tie_count; i++)
    largest = fmax (largest, ties[model->tie_count + i].force);
  for (size_t i = 0; i < model->soil_tie_count && largest > 0; i++) {
    const QnTie *tie = &model->soil_ties[i];
    double side = tie->ends[1].at.x > tie->ends[0].at.x ? 1 : -1;
    double part = ties[model->tie_count + i].force / largest;
    QnVec2 at = qn_builder_place (b, tie->ends[0].block, tie->ends[0].at);
    if (part > 0.01)
      qn_scene_arrow (b->scene, QN_LAYER_FORCES,
                      qn_vec2 (at.x - side * part * ARROW * b->block_size, at.y), at,
                      QN_WIDTH_ARROW, color, QN_PICK_NOTHING, QN_NONE, 0);
  }
  if (largest > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, QN_WIDTH_ARROW, color, "%s",
                     _ ("pressure of the soil beyond the active"))
      ->marker = QN_MARKER_ARROW_HEAD;
}

void
qn_build_ties (QnSceneBuilder *b)
{
  /* NULL where no step is shown, or its ties are not known. */
  const QnTieResult *results =
    qn_builder_shows_step (b) ? qn_result_step_ties (b->result, b->step) : NULL;
  bool met[QN_TIE_STATE_COUNT] = { false };
  for (size_t i = 0; i < b->model->tie_count; i++) {
    const QnTieResult *result = results != NULL ? &results[i] : NULL;
    add_tie (b, i, result);
    met[result != NULL ? result->state : QN_TIE_ELASTIC] = true;
  }
  if (results != NULL && b->options->symbols)
    add_soil_forces (b, results);
  for (int state = 0; state < QN_TIE_STATE_COUNT; state++) {
    if (!met[state])
      continue;
    QnLegendEntry *entry = qn_scene_legend (
      b->scene, QN_COMMAND_STROKE, WIDTH_TIE, color_of (b, (QnTieState) state), "%s",
      results != NULL ? _ (state_words[state]) : _ ("tie"));
    entry->dashed = state == QN_TIE_SLACK;
  }
}
