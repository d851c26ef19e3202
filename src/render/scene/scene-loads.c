/* Loads as arrows and overall dimensions. */
#include "core/base/integer.h"
#include "core/model/outline.h"
#include "render/drawing/text.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Largest length of a weight or force arrow in block sizes. */
#define WEIGHT_ARROW 0.45
#define FORCE_ARROW  1.4

/* Length of the arrow of a settling support, in block sizes. */
#define SETTLEMENT_ARROW 1.2

/* Arrows of a load along a beam, less one. */
#define LINE_ARROWS 10

/* Length of the longest arrow of a load on edges, and the least distance between two, in block
 * sizes. */
#define EDGE_ARROW   0.8
#define EDGE_SPACING 0.25

/* Most arrows of one stretch of an edge. */
#define MAX_EDGE_ARROWS 40

/* Most blocks that get an arrow of their own for a load on every block. */
#define MAX_WEIGHT_ARROWS 20000

/* A load proportional to weight: one arrow per block, as long as its share of the heaviest. */
static void
add_weight_load (QnSceneBuilder *b, const QnLoad *load, QnPickKind pick, QnId index,
                 QnColor color)
{
  const QnModel *model = b->model;
  double norm = qn_vec2_length (load->vector), heaviest = 0;
  for (size_t i = 0; i < model->block_count; i++)
    if (!qn_support_is_full (model->blocks[i].support))
      heaviest = fmax (heaviest, model->blocks[i].weight);
  if (!(norm > 0) || !(heaviest > 0) || model->block_count > MAX_WEIGHT_ARROWS)
    return;
  if (norm > qn_vec2_length (b->weight_arrow))
    b->weight_arrow = load->vector;
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    if (qn_support_is_full (block->support) || !(block->weight > 0))
      continue;
    /* Half blocks are marked by shorter arrows, not by arrows too short to read. */
    double share = sqrt (block->weight / heaviest);
    double length = WEIGHT_ARROW * b->block_size * share / norm;
    QnVec2 from = qn_builder_place (b, (QnId) i, block->centroid);
    from = qn_vec2_add_scaled (from, -0.5 * length, load->vector);
    qn_scene_arrow (b->scene, QN_LAYER_LOADS, from,
                    qn_vec2_add_scaled (from, length, load->vector), QN_WIDTH_ARROW,
                    color, pick, index, length * norm);
  }
}

/* A number with its unit as a label. */
static QnCommand *
add_quantity (QnSceneBuilder *b, QnVec2 at, const char *format, double number,
              const char *unit, QnColor color)
{
  g_autofree char *digits = qn_label_number (format, number);
  g_autofree char *text = g_strconcat (digits, unit, NULL);
  return qn_scene_text (b->scene, QN_LAYER_LABELS, at, QN_SIZE_LABEL, text, color);
}

/* How large a load is, and the factor of its case where that is not 1. */
static QnCommand *
add_size (QnSceneBuilder *b, const QnLoad *load, QnVec2 at, double size, const char *unit,
          QnColor color)
{
  const double factor = qn_model_load_factor (b->model, load);
  g_autofree char *times = qn_label_number ("%.4g", factor);
  g_autofree char *suffix =
    factor != 1 ? g_strconcat (unit, " × ", times, NULL) : g_strdup (unit);
  return add_quantity (b, at, "%.4g", size, suffix, color);
}

/* Places a label at the tail of an arrow, out of its way. */
static void
set_behind (QnCommand *label, QnVec2 arrow, double length)
{
  label->align_x = arrow.x > 0.3 * length ? 1.1f : arrow.x < -0.3 * length ? -0.1f : 0.5f;
  label->align_y = arrow.y < -0.3 * length ? -0.2f : arrow.y > 0.3 * length ? 1.2f : 0.5f;
}

static void
add_force_load (QnSceneBuilder *b, const QnLoad *load, double largest, QnPickKind pick,
                QnId index, QnColor color)
{
  double force = qn_vec2_length (load->vector);
  QnVec2 at;
  if (load->kind == QN_LOAD_NODE) {
    at = qn_builder_place_node (b, load->node);
  } else {
    at = load->has_at ? load->at : b->model->blocks[load->block].centroid;
    at = qn_builder_place (b, load->block, at);
  }
  if (force > 0) {
    double length = FORCE_ARROW * b->block_size * fmax (force / largest, 0.2);
    QnVec2 from = qn_vec2_add_scaled (at, -length / force, load->vector);
    qn_scene_arrow (b->scene, QN_LAYER_LOADS, from, at, 1.4, color, pick, index, 0);
    set_behind (add_size (b, load, from, force / 1000, " kN", color), load->vector,
                force);
  }
  if (load->moment != 0) {
    QnVec2 arc[25];
    double r = 0.35 * b->block_size, turn = load->moment > 0 ? 1 : -1;
    for (size_t i = 0; i < G_N_ELEMENTS (arc); i++) {
      double a = turn * (-0.75 + 1.5 * (double) i / (G_N_ELEMENTS (arc) - 1)) * G_PI;
      arc[i] = qn_vec2 (at.x + r * cos (a), at.y + r * sin (a));
    }
    size_t last = G_N_ELEMENTS (arc) - 1;
    QnCommand *turning =
      qn_scene_stroke (b->scene, QN_LAYER_LOADS, arc, last, false, 1.2, color);
    qn_command_set_pick (turning, pick, index);
    QnVec2 d = qn_vec2_sub (arc[last], arc[last - 1]);
    qn_scene_marker (b->scene, QN_LAYER_LOADS, QN_MARKER_ARROW_HEAD, arc[last], 6,
                     atan2 (d.y, d.x), color);
  }
}

/* A row of arrows that reach from tails to ends, so many and one more, joined at their tails. */
static void
add_arrows (QnSceneBuilder *b, const QnVec2 tails[2], const QnVec2 ends[2], int count,
            QnPickKind pick, QnId index, QnColor color)
{
  for (int i = 0; i <= count; i++) {
    double s = (double) i / count;
    QnVec2 from = qn_vec2_lerp (tails[0], tails[1], s);
    QnVec2 to = qn_vec2_lerp (ends[0], ends[1], s);
    if (from.x != to.x || from.y != to.y)
      qn_scene_arrow (b->scene, QN_LAYER_LOADS, from, to, QN_WIDTH_ARROW, color, pick,
                      index, 0);
  }
  QnCommand *line =
    qn_scene_stroke (b->scene, QN_LAYER_LOADS, tails, 2, false, QN_WIDTH_ARROW, color);
  qn_command_set_pick (line, pick, index);
}

static void
add_line_load (QnSceneBuilder *b, const QnLoad *load, QnPickKind pick, QnId index,
               QnColor color)
{
  const QnBeam *beam = &b->model->beams[load->beam];
  QnVec2 ends[2] = { qn_builder_place_node (b, beam->nodes[0]),
                     qn_builder_place_node (b, beam->nodes[1]) };
  double force = qn_vec2_length (load->vector);
  if (!(force > 0))
    return;
  QnVec2 arrow = qn_vec2_scale (0.6 * b->block_size / force, load->vector);
  QnVec2 tails[2] = { qn_vec2_sub (ends[0], arrow), qn_vec2_sub (ends[1], arrow) };
  add_arrows (b, tails, ends, LINE_ARROWS, pick, index, color);
  add_size (b, load, qn_vec2_lerp (tails[0], tails[1], 0.5), force / 1000, " kN/m", color)
    ->align_y = load->vector.y > 0 ? 1.2f : -0.2f;
}

/* By which the pressure of a surcharge or backfill was multiplied: the thickness, and of a load
 * downwards what the edge is long in plan. */
static double
loaded_width (const QnModel *model, const QnEdgeForce *force)
{
  QnVec2 edge = qn_vec2_sub (force->ends[1], force->ends[0]);
  QnLoadKind kind = qn_model_load (model, force->source)->kind;
  bool down = kind == QN_LOAD_SURCHARGE || kind == QN_LOAD_VEHICLE;
  return model->blocks[force->block].thickness
         * (down ? fabs (edge.x) / qn_vec2_length (edge) : 1);
}

/* Of all loads on edges at an end of one of them, N/m: where there is most, arrows of others are in
 * the way of its label. */
static double
total_intensity (const QnModel *model, const QnEdgeForce *force, int end)
{
  double total = 0;
  for (size_t i = 0; i < model->edge_force_count; i++) {
    const QnEdgeForce *other = &model->edge_forces[i];
    for (int k = 0; k < 2 && other->block == force->block; k++)
      if (other->ends[k].x == force->ends[end].x
          && other->ends[k].y == force->ends[end].y)
        total += qn_vec2_length (other->intensity[k]);
  }
  return total;
}

/* The load on edges with its largest intensity or pressure beside the arrow of it; of equal ones
 * beside that where it stands most alone. */
static void
add_edge_load (QnSceneBuilder *b, size_t source, double largest, QnPickKind pick,
               QnId index, QnColor color)
{
  const QnModel *model = b->model;
  const QnLoad *load = qn_model_load (model, source);
  const bool pressure = load->kind != QN_LOAD_EDGE;
  double scale = EDGE_ARROW * b->block_size / largest, most = 0, shown = 0;
  double crowd = INFINITY, rise = 0;
  QnVec2 at = { 0, 0 }, direction = { 0, 0 };
  size_t count;
  const QnEdgeForce *forces = qn_model_edge_forces_of (model, source, &count);
  for (size_t i = 0; i < count; i++) {
    const QnEdgeForce *force = &forces[i];
    /* Arrows as long as the load is large at the edge. */
    QnVec2 ends[2], tails[2];
    for (int end = 0; end < 2; end++) {
      ends[end] = qn_builder_place (b, force->block, force->ends[end]);
      tails[end] = qn_vec2_add_scaled (ends[end], -scale, force->intensity[end]);
    }
    double length = qn_vec2_length (qn_vec2_sub (ends[1], ends[0]));
    int arrows =
      (int) qn_to_integer (length / (EDGE_SPACING * b->block_size), 1, MAX_EDGE_ARROWS);
    add_arrows (b, tails, ends, arrows, pick, index, color);
    for (int end = 0; end < 2; end++) {
      double size = qn_vec2_length (force->intensity[end]);
      double others = size >= most * (1 - 1e-9) ? total_intensity (model, force, end) : 0;
      if (size < most * (1 - 1e-9) || (size <= most * (1 + 1e-9) && others >= crowd))
        continue;
      most = size;
      crowd = others;
      shown = pressure ? size / loaded_width (model, force) : size;
      direction = force->intensity[end];
      at = qn_builder_place (b, force->block, force->ends[end]);
      rise = qn_builder_place (b, force->block, force->ends[1 - end]).y - at.y;
    }
  }
  if (!(most > 0))
    return;
  QnCommand *label = add_size (b, load, qn_vec2_add_scaled (at, -scale, direction),
                               shown / 1000, pressure ? " kPa" : " kN/m", color);
  qn_command_set_pick (label, pick, index);
  set_behind (label, direction, most);
  /* Beside the edge, not beyond its end, where other things stand. */
  if (fabs (direction.y) <= 0.3 * most && rise != 0)
    label->align_y = rise > 0 ? -0.2f : 1.2f;
}

/* A settling support: an arrow in its direction with how far. Of a moment only the size is written.
 * */
static void
add_settlement (QnSceneBuilder *b, const QnLoad *load, QnPickKind pick, QnId index,
                QnColor color)
{
  bool turns = load->dof == QN_DOF_RZ;
  double sign = load->value < 0 ? -1 : 1, length = SETTLEMENT_ARROW * b->block_size;
  QnVec2 along = turns                    ? qn_vec2 (0, 0)
                 : load->dof == QN_DOF_UX ? qn_vec2 (sign, 0)
                                          : qn_vec2 (0, sign);
  QnVec2 from = qn_builder_place (b, load->block, b->model->blocks[load->block].centroid);
  QnVec2 to = qn_vec2_add_scaled (from, length, along);
  if (!turns)
    qn_scene_arrow (b->scene, QN_LAYER_LOADS, from, to, 1.4, color, pick, index, 0);
  QnCommand *label =
    add_quantity (b, to, "%.3g", turns ? 1e3 * load->value : 1e3 * fabs (load->value),
                  turns ? " mrad" : " mm", color);
  set_behind (label, qn_vec2_scale (-1, along), 1);
}

/* The axles of a vehicle where they stand, as wheels on the surface. */
static void
add_axles (QnSceneBuilder *b, const QnLoad *load, QnPickKind pick, QnId index,
           QnColor color)
{
  const QnModel *model = b->model;
  const QnVehicle *vehicle = &model->vehicles[load->vehicle];
  const double r = 0.25 * b->block_size;
  QnSeenEdges top;
  QnPool room = { 0 };
  qn_model_find_seen_edges (model, QN_BLOCK_SIDE_TOP, &top, &room);
  for (int32_t n = 0; n < load->convoy; n++)
    for (int32_t i = 0; i < vehicle->axle_count; i++) {
      double x = qn_load_behind_front (model, load, n, vehicle->axles[i].at);
      double y;
      qn_model_find_road (model, &top, x, &y);
      if (isnan (y))
        continue;
      QnVec2 wheel[24];
      for (size_t k = 0; k < G_N_ELEMENTS (wheel); k++) {
        double a = 2 * G_PI * (double) k / G_N_ELEMENTS (wheel);
        wheel[k] = qn_vec2 (x + r * cos (a), y + r + r * sin (a));
      }
      QnCommand *circle = qn_scene_stroke (b->scene, QN_LAYER_LOADS, wheel,
                                           G_N_ELEMENTS (wheel), true, 1.2F, color);
      qn_command_set_pick (circle, pick, index);
      QnCommand *label = add_size (b, load, qn_vec2 (x, y + 2 * r),
                                   vehicle->axles[i].load / 1000, " kN", color);
      label->align_y = -0.2F;
      qn_command_set_pick (label, pick, index);
    }
  qn_pool_clear (&room);
}

static void
add_loads (QnSceneBuilder *b, const QnLoad *loads, size_t count, QnPickKind pick,
           QnInk ink, const char *name)
{
  QnColor color = qn_builder_ink (b, ink);
  double largest = 0;
  for (size_t i = 0; i < count; i++)
    if (loads[i].kind == QN_LOAD_FORCE || loads[i].kind == QN_LOAD_NODE)
      largest = fmax (largest, qn_vec2_length (loads[i].vector));
  /* Of the loads on edges, dead and live together, N/m. */
  double intensity = 0;
  for (size_t i = 0; i < b->model->edge_force_count; i++)
    for (int end = 0; end < 2; end++)
      intensity =
        fmax (intensity, qn_vec2_length (b->model->edge_forces[i].intensity[end]));
  bool on_edges = false;
  for (size_t i = 0; i < count; i++) {
    const QnLoad *load = &loads[i];
    /* Loads of sets are called by the name of their set. */
    const char *called =
      load->set > 0 ? qn_model_load_set_name (b->model, load->set) : name;
    if (load->kind == QN_LOAD_FILL) /* drawn as soil */
      continue;
    if (load->kind == QN_LOAD_VEHICLE) {
      add_axles (b, load, pick, (QnId) i, color);
      qn_scene_legend (b->scene, QN_COMMAND_MARKER, QN_WIDTH_ARROW, color,
                       _ ("%s: vehicle %s"), called,
                       b->model->vehicles[load->vehicle].name)
        ->marker = QN_MARKER_ARROW_HEAD;
    }
    if (qn_load_is_on_edges (load->kind)) {
      size_t source = i + (loads == b->model->live_loads ? b->model->dead_load_count : 0);
      add_edge_load (b, source, intensity, pick, (QnId) i, color);
      on_edges = on_edges || load->kind != QN_LOAD_VEHICLE;
      continue;
    }
    if (load->kind == QN_LOAD_FORCE || load->kind == QN_LOAD_NODE)
      add_force_load (b, load, largest, pick, (QnId) i, color);
    else if (load->kind == QN_LOAD_LINE)
      add_line_load (b, load, pick, (QnId) i, color);
    else if (load->kind == QN_LOAD_SETTLEMENT) {
      add_settlement (b, load, pick, (QnId) i, color);
      qn_scene_legend (b->scene, QN_COMMAND_MARKER, 1.4f, color, _ ("%s: settlement"),
                       called)
        ->marker = QN_MARKER_ARROW_HEAD;
    }
    if (load->kind != QN_LOAD_WEIGHT)
      continue;
    /* Own weight downwards goes without saying: the legend names it, no arrow is spent. */
    bool own = load->vector.x == 0 && load->vector.y < 0 && pick == QN_PICK_DEAD_LOAD;
    if (!own)
      add_weight_load (b, load, pick, (QnId) i, color);
    g_autofree char *x = qn_label_number ("%.3g", load->vector.x);
    g_autofree char *y = qn_label_number ("%.3g", load->vector.y);
    g_autofree char *what = own && load->vector.y == -1
                              ? g_strdup (_ ("own weight"))
                              : g_strdup_printf (_ ("weight × (%s, %s)"), x, y);
    qn_scene_legend (b->scene, own ? QN_COMMAND_TEXT : QN_COMMAND_MARKER, QN_WIDTH_ARROW,
                     color, _ ("%s: %s"), called, what)
      ->marker = QN_MARKER_ARROW_HEAD;
  }
  if (on_edges)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, QN_WIDTH_ARROW, color,
                     _ ("%s: load on edges"), name)
      ->marker = QN_MARKER_ARROW_HEAD;
  if (largest > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 1.4f, color, _ ("%s: force"), name)
      ->marker = QN_MARKER_ARROW_HEAD;
}

/* What shakes the ground has no place in the drawing: the legend names it. */
static void
name_ground_motion (QnSceneBuilder *b, const QnGroundMotion *motion)
{
  QnColor line = qn_builder_ink (b, QN_INK_LINE);
  g_autofree char *peak =
    qn_label_number ("%.4g", motion->scale * motion->pulse.amplitude);
  if (motion->kind == QN_SIGNAL_PULSE)
    qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, line,
                     _ ("ground motion: pulse of %s m/s²"), peak);
  else if (motion->record != NULL)
    qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, line, _ ("ground motion: %s"),
                     motion->record);
  else
    qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, line, "%s", _ ("ground motion"));
}

void
qn_build_loads (QnSceneBuilder *b)
{
  const QnModel *model = b->model;
  add_loads (b, model->dead_loads, model->dead_load_count, QN_PICK_DEAD_LOAD,
             QN_INK_DEAD_LOAD, _ ("dead load"));
  add_loads (b, model->live_loads, model->live_load_count, QN_PICK_LIVE_LOAD,
             QN_INK_LIVE_LOAD, _ ("live load"));
  if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    for (size_t i = 0; i < model->ground_count; i++)
      name_ground_motion (b, &model->ground[i]);
}

/* A dimension line from a to b, with ticks, extension lines from the object and its length on the
 * far side. `text_angle` is 0 or 90 degrees; `clear` is left free at the object. */
static void
add_dimension (QnSceneBuilder *b, QnVec2 from, QnVec2 to, QnVec2 object_from,
               QnVec2 object_to, double text_angle, bool above, double clear)
{
  QnScene *scene = b->scene;
  QnColor color = qn_builder_ink (b, QN_INK_LINE);
  QnVec2 line[2] = { from, to };
  const double part = clear / qn_vec2_length (qn_vec2_sub (from, object_from));
  QnVec2 extensions[2][2] = { { qn_vec2_lerp (object_from, from, part),
                                qn_vec2_lerp (object_from, from, 1 + part) },
                              { qn_vec2_lerp (object_to, to, part),
                                qn_vec2_lerp (object_to, to, 1 + part) } };
  qn_scene_stroke (scene, QN_LAYER_DIMENSIONS, line, 2, false, 0.5, color);
  for (int i = 0; i < 2; i++) {
    qn_scene_stroke (scene, QN_LAYER_DIMENSIONS, extensions[i], 2, false, 0.35, color);
    qn_scene_marker (scene, QN_LAYER_DIMENSIONS, QN_MARKER_TICK, line[i], 6, 0, color);
  }
  double length = qn_vec2_length (qn_vec2_sub (to, from));
  const bool odd = fabs (rint (100 * length) - 100 * length) > 0.04; /* 0.4 mm */
  g_autofree char *number = length >= 1 ? qn_label_number (odd ? "%.3f" : "%.2f", length)
                                        : qn_label_number ("%.4g", 1000 * length);
  g_autofree char *text = g_strconcat (number, length >= 1 ? " m" : " mm", NULL);
  QnCommand *label = qn_scene_text (scene, QN_LAYER_LABELS, qn_vec2_lerp (from, to, 0.5),
                                    7.5, text, color);
  label->angle = (float) text_angle;
  label->align_y = above ? -0.25f : 1.25f;
}

/* Room for the words of a load, in diagonals of the structure: what they take on a page of a report. */
#define LABEL_LENGTH 0.09
#define LABEL_HEIGHT 0.03

/* By how much loads with their labels, and the depth of beams, stand out of the structure at each
 * side, m. */
static void
measure_loads (const QnSceneBuilder *b, QnVec2 *low, QnVec2 *high)
{
  QnBox box = b->box;
  double diagonal = qn_box_diagonal (box);
  const QnVec2 room = { LABEL_LENGTH * diagonal, LABEL_HEIGHT * diagonal };
  for (guint i = 0; i < b->scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (b->scene, i);
    const QnVec2 *points = qn_scene_points (b->scene, command);
    bool counts = command->layer == QN_LAYER_LOADS || command->layer == QN_LAYER_BLOCKS;
    for (uint32_t k = 0; counts && k < command->count; k++)
      qn_box_add_point (&box, points[k]);
    if (command->kind != QN_COMMAND_TEXT || command->layer != QN_LAYER_LABELS
        || command->extent > 0)
      continue;
    QnVec2 corner = { points->x - command->align_x * room.x,
                      points->y - command->align_y * room.y };
    qn_box_add_point (&box, corner);
    qn_box_add_point (&box, qn_vec2_add (corner, room));
  }
  *low = qn_vec2_sub (b->box.min, box.min);
  *high = qn_vec2_sub (box.max, b->box.max);
}

void
qn_build_dimensions (QnSceneBuilder *b)
{
  if (qn_box_is_empty (b->box) || !(qn_box_diagonal (b->box) > 0))
    return;
  /* What is measured: the structure without the blocks that hold it, unless there are no others. */
  const QnModel *model = b->model;
  QnBox box = QN_BOX_EMPTY;
  for (size_t i = 0; i < model->block_count; i++)
    if (!qn_support_is_full (model->blocks[i].support))
      qn_box_add_box (&box, qn_model_block_box (model, (QnId) i));
  for (size_t i = 0; i < model->node_count; i++)
    qn_box_add_point (&box, model->nodes[i].at);
  const QnBox measured = qn_box_is_empty (box) ? b->box : box;
  QnVec2 low = measured.min, high = measured.max;
  double gap = 0.045 * qn_box_diagonal (b->box);
  QnVec2 below, above;
  measure_loads (b, &below, &above);
  /* On the side where no load, bar or tie is in the way. A line of beams has no height. */
  bool top = above.y < below.y;
  bool right =
    b->box.max.x + above.x - high.x + 1e-6 * gap < low.x - b->box.min.x + below.x;
  double y = top ? b->box.max.y + above.y + gap : b->box.min.y - below.y - gap;
  double x = right ? b->box.max.x + above.x + gap : b->box.min.x - below.x - gap;
  if (high.x > low.x)
    add_dimension (b, qn_vec2 (low.x, y), qn_vec2 (high.x, y),
                   qn_vec2 (low.x, top ? high.y : low.y),
                   qn_vec2 (high.x, top ? high.y : low.y), 0, top, gap / 4);
  if (high.y > low.y)
    add_dimension (b, qn_vec2 (x, low.y), qn_vec2 (x, high.y),
                   qn_vec2 (right ? high.x : low.x, low.y),
                   qn_vec2 (right ? high.x : low.x, high.y), G_PI / 2, !right, gap / 4);
}
