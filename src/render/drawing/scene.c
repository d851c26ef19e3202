#include "render/drawing/scene.h"

#include "core/base/polygon.h"

#include <stdarg.h>

static void
legend_entry_clear (gpointer data)
{
  g_free (((QnLegendEntry *) data)->text);
}

QnScene *
qn_scene_new (void)
{
  QnScene *scene = g_new0 (QnScene, 1);
  scene->commands = g_array_new (FALSE, TRUE, sizeof (QnCommand));
  scene->points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  scene->legend = g_array_new (FALSE, TRUE, sizeof (QnLegendEntry));
  g_array_set_clear_func (scene->legend, legend_entry_clear);
  scene->strings = g_string_chunk_new (1024);
  scene->box = QN_BOX_EMPTY;
  return scene;
}

void
qn_scene_free (QnScene *scene)
{
  if (scene == NULL)
    return;
  g_array_unref (scene->commands);
  g_array_unref (scene->points);
  g_array_unref (scene->legend);
  g_string_chunk_free (scene->strings);
  g_free (scene->bar.title);
  g_clear_pointer (&scene->image, cairo_surface_destroy);
  g_free (scene);
}

static QnCommand *
add_command (QnScene *scene, QnLayer layer, QnCommandKind kind, const QnVec2 *points,
             size_t count, QnColor color)
{
  QnCommand command = {
    .layer = (uint8_t) layer,
    .kind = (uint8_t) kind,
    .id = QN_NONE,
    .color = color,
    .first = scene->points->len,
    .count = (uint32_t) count,
    .box = QN_BOX_EMPTY,
  };
  for (size_t i = 0; i < count; i++)
    qn_box_add_point (&command.box, points[i]);
  g_array_append_vals (scene->points, points, (guint) count);
  g_array_append_val (scene->commands, command);
  return &g_array_index (scene->commands, QnCommand, scene->commands->len - 1);
}

QnCommand *
qn_scene_fill (QnScene *scene, QnLayer layer, const QnVec2 *points, size_t count,
               QnColor color)
{
  return add_command (scene, layer, QN_COMMAND_FILL, points, count, color);
}

QnCommand *
qn_scene_stroke (QnScene *scene, QnLayer layer, const QnVec2 *points, size_t count,
                 bool closed, double width, QnColor color)
{
  QnCommand *command =
    add_command (scene, layer, QN_COMMAND_STROKE, points, count, color);
  command->closed = closed;
  command->size = (float) width;
  return command;
}

QnCommand *
qn_scene_marker (QnScene *scene, QnLayer layer, QnMarker marker, QnVec2 at, double size,
                 double angle, QnColor color)
{
  QnCommand *command = add_command (scene, layer, QN_COMMAND_MARKER, &at, 1, color);
  command->marker = (uint8_t) marker;
  command->size = (float) size;
  command->angle = (float) angle;
  return command;
}

QnCommand *
qn_scene_text (QnScene *scene, QnLayer layer, QnVec2 at, double size, const char *text,
               QnColor color)
{
  QnCommand *command = add_command (scene, layer, QN_COMMAND_TEXT, &at, 1, color);
  command->size = (float) size;
  command->align_x = command->align_y = 0.5f;
  command->text = g_string_chunk_insert (scene->strings, text);
  return command;
}

/* Part of an arrow that its head takes at most, and half the width of a head over its length. */
#define HEAD_SHARE 0.6
#define HEAD_WIDTH 0.36

/* Below this length, pt, an arrow is a speck. */
#define LEAST_ARROW 3

void
qn_scene_arrow (QnScene *scene, QnLayer layer, QnVec2 from, QnVec2 to, double width,
                QnColor color, QnPickKind pick, QnId id, double extent)
{
  QnVec2 line[2] = { from, to };
  double angle = atan2 (to.y - from.y, to.x - from.x);
  QnCommand *shaft = qn_scene_stroke (scene, layer, line, 2, false, width, color);
  qn_command_set_pick (shaft, pick, id);
  qn_command_set_extent (shaft, extent, LEAST_ARROW);
  /* As long as for all arrows of this width where it fits, else in proportion. */
  double size = 3 + 2.5 * width, length = qn_vec2_length (qn_vec2_sub (to, from));
  QnCommand *head =
    qn_scene_marker (scene, layer, QN_MARKER_ARROW_HEAD, to, size, angle, color);
  qn_command_set_pick (head, pick, id);
  qn_command_set_extent (head, length, (float) (size / HEAD_SHARE));
  if (!(length > 0))
    return;
  QnVec2 back = qn_vec2_lerp (to, from, HEAD_SHARE);
  QnVec2 side =
    qn_vec2_scale (HEAD_SHARE * HEAD_WIDTH, qn_vec2_perp (qn_vec2_sub (to, from)));
  QnVec2 corners[3] = { to, qn_vec2_add (back, side), qn_vec2_sub (back, side) };
  head = qn_scene_fill (scene, layer, corners, 3, color);
  qn_command_set_pick (head, pick, id);
  qn_command_set_extent (head, length,
                         extent > 0 ? (float) (LEAST_ARROW * length / extent) : 0);
  head->most = (float) (size / HEAD_SHARE);
}

QnLegendEntry *
qn_scene_legend (QnScene *scene, QnCommandKind kind, double size, QnColor color,
                 const char *format, ...)
{
  QnLegendEntry entry = { .kind = (uint8_t) kind, .color = color, .size = (float) size };
  va_list args;
  va_start (args, format);
  entry.text = g_strdup_vprintf (format, args);
  va_end (args);
  g_array_append_val (scene->legend, entry);
  return &g_array_index (scene->legend, QnLegendEntry, scene->legend->len - 1);
}

void
qn_scene_finish (QnScene *scene)
{
  /* Process-wide, so that a batch can never take one scene for another. */
  static gint next_revision;

  /* Stable counting sort by layer: within a layer the order of addition stays. */
  guint start[QN_LAYER_COUNT + 1] = { 0 };
  const guint count = scene->commands->len;
  for (guint i = 0; i < count; i++)
    start[qn_scene_command (scene, i)->layer + 1]++;
  for (int layer = 0; layer < QN_LAYER_COUNT; layer++)
    start[layer + 1] += start[layer];
  GArray *sorted = g_array_sized_new (FALSE, FALSE, sizeof (QnCommand), count);
  g_array_set_size (sorted, count);
  for (guint i = 0; i < count; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    g_array_index (sorted, QnCommand, start[command->layer]++) = *command;
  }
  g_array_unref (scene->commands);
  scene->commands = sorted;
  scene->box = QN_BOX_EMPTY;
  for (guint i = 0; i < scene->commands->len; i++)
    qn_box_add_box (&scene->box, qn_scene_command (scene, i)->box);
  scene->revision = (uint64_t) (guint) g_atomic_int_add (&next_revision, 1) + 1;
}

bool
qn_command_is_visible (const QnCommand *command, const QnCamera *camera, QnBox visible)
{
  if (!qn_command_has_size (command, camera))
    return false;

  /* Sizes in points reach beyond the box of the places. A line of text is taken to be no
   * longer than forty times its height. */
  double reach = command->kind == QN_COMMAND_TEXT ? 20 * command->size : command->size;
  reach *= camera->unit / camera->scale;
  return command->box.min.x - reach <= visible.max.x
         && command->box.max.x + reach >= visible.min.x
         && command->box.min.y - reach <= visible.max.y
         && command->box.max.y + reach >= visible.min.y;
}

/* A line may take a twelfth of the height of a block and is never thinner than a quarter of
 * its width. */
double
qn_scene_line_factor (const QnScene *scene, const QnCamera *camera)
{
  double full = 0.55 * camera->unit;
  if (!(scene->fineness > 0))
    return 1;
  return fmin (fmax (scene->fineness * camera->scale / 12 / full, 0.25), 1);
}

QnColor
qn_color_bar_color (const QnColorBar *bar, double value, int monochrome)
{
  if (bar->diverging) {
    double largest = fmax (fabs (bar->min), fabs (bar->max));
    return qn_map_diverging (largest > 0 ? value / largest : 0, monochrome);
  }
  double range = bar->max - bar->min;
  return qn_map_sequential (range > 0 ? (value - bar->min) / range : 0, monochrome);
}

/* ---- picking --------------------------------------------------------------------------- */

/* Whether a command is within `reach` m of the model point p. */
static bool
command_hit (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
             QnVec2 p, double reach)
{
  const QnVec2 *v = qn_scene_points (scene, command);
  double size = 0.5 * command->size * camera->unit / camera->scale;
  switch ((QnCommandKind) command->kind) {
  case QN_COMMAND_FILL:
    return qn_polygon_depth (v, command->count, p) >= 0;
  case QN_COMMAND_STROKE:
    for (uint32_t i = command->closed ? 0 : 1; i < command->count; i++) {
      uint32_t before = i > 0 ? i - 1 : command->count - 1;
      if (qn_segment_distance (v[before], v[i], p) <= reach + size)
        return true;
    }
    return false;
  case QN_COMMAND_MARKER:
  case QN_COMMAND_TEXT:
    return qn_vec2_length (qn_vec2_sub (p, v[0])) <= reach + size;
  case QN_COMMAND_IMAGE:
    break;
  }
  return false;
}

QnPick
qn_pick_at (const QnScene *scene, const QnCamera *camera, QnVec2 screen, double reach,
            unsigned kinds)
{
  QnVec2 p = qn_camera_to_model (camera, screen);
  double model_reach = reach / camera->scale;
  const QnBox near = { { p.x - model_reach, p.y - model_reach },
                       { p.x + model_reach, p.y + model_reach } };
  for (guint i = scene->commands->len; i-- > 0;) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->pick != QN_PICK_NOTHING && (kinds == 0 || (kinds & 1u << command->pick))
        && qn_command_is_visible (command, camera, near)
        && command_hit (scene, command, camera, p, model_reach))
      return (QnPick){ (QnPickKind) command->pick, command->id };
  }
  return (QnPick){ QN_PICK_NOTHING, QN_NONE };
}

void
qn_pick_inside (const QnScene *scene, const QnCamera *camera, QnVec2 corner_a,
                QnVec2 corner_b, QnPickKind kind, GArray *ids)
{
  QnBox box = QN_BOX_EMPTY;
  qn_box_add_point (&box, qn_camera_to_model (camera, corner_a));
  qn_box_add_point (&box, qn_camera_to_model (camera, corner_b));
  g_autoptr (GHashTable) known = g_hash_table_new (NULL, NULL);
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *c = qn_scene_command (scene, i);
    /* Fills stand for blocks, whatever else is drawn of them; other entities are lines and
     * points. */
    if (c->pick != kind || c->id == QN_NONE
        || (kind == QN_PICK_BLOCK && c->kind != QN_COMMAND_FILL))
      continue;
    bool inside = c->box.min.x >= box.min.x && c->box.max.x <= box.max.x
                  && c->box.min.y >= box.min.y && c->box.max.y <= box.max.y;
    if (inside && g_hash_table_add (known, GINT_TO_POINTER (c->id)))
      g_array_append_val (ids, c->id);
  }
}
