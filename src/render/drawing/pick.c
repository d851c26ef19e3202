#include "render/drawing/pick.h"

#include "core/base/polygon.h"

/* Even-odd rule. */
static bool
polygon_contains (const QnVec2 *v, uint32_t count, QnVec2 p)
{
  bool inside = false;
  for (uint32_t i = 0, j = count - 1; i < count; j = i++)
    if ((v[i].y > p.y) != (v[j].y > p.y)
        && p.x < (v[j].x - v[i].x) * (p.y - v[i].y) / (v[j].y - v[i].y) + v[i].x)
      inside = !inside;
  return inside;
}

/* Whether a command is within `reach` m of the model point p. */
static bool
command_hit (const QnScene *scene, const QnCommand *command, const QnCamera *camera,
             QnVec2 p, double reach)
{
  const QnVec2 *v = qn_scene_points (scene, command);
  double size = 0.5 * command->size * camera->unit / camera->scale;
  switch ((QnCommandKind) command->kind) {
  case QN_COMMAND_FILL:
    return polygon_contains (v, command->count, p);
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
  QnBox visible = qn_camera_visible_box (camera);
  QnVec2 p = qn_camera_to_model (camera, screen);
  double model_reach = reach / camera->scale;
  for (guint i = scene->commands->len; i-- > 0;) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->pick == QN_PICK_NOTHING
        || (kinds != 0 && !(kinds & 1u << command->pick)))
      continue;
    if (!qn_command_is_visible (command, camera, visible))
      continue;
    if (command_hit (scene, command, camera, p, model_reach))
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
