#include "render/backend/gl-batch.h"

#include "render/backend/gl-shape.h"
#include "render/drawing/marker-shape.h"

static void
add_marker (QnGlBrush brush, const QnScene *scene, const QnCommand *command)
{
  QnMarkerPath path;
  brush.at = *qn_scene_points (scene, command);
  brush.in_points = true;
  for (int part = 0; qn_marker_path ((QnMarker) command->marker, part, command->angle,
                                     command->mirrored, &path);
       part++) {
    uint32_t count = (uint32_t) path.count;
    for (uint32_t i = 0; i < count; i++)
      path.points[i] = qn_vec2_scale (command->size, path.points[i]);
    if (path.paint == QN_MARKER_RIM) {
      QnGlBrush paper = brush;
      paper.color = qn_rgb (0xffffff);
      qn_gl_add_fill (&paper, path.points, count);
    }
    if (path.paint == QN_MARKER_INK)
      qn_gl_add_fill (&brush, path.points, count);
    else
      qn_gl_add_line (&brush, path.points, count, path.closed, false, QN_RIM_WIDTH);
  }
}

void
qn_gl_batch_init (QnGlBatch *batch, const QnScene *scene)
{
  guint count = scene->commands->len;
  g_autoptr (GArray) scratch = g_array_new (FALSE, FALSE, sizeof (uint32_t));
  g_autoptr (GArray) scratch_points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  *batch = (QnGlBatch){
    .vertices = g_array_sized_new (FALSE, FALSE, sizeof (QnGlVertex), 8 * count),
    .indices = g_array_sized_new (FALSE, FALSE, sizeof (uint32_t), 16 * count),
    .ranges = g_new0 (QnGlRange, MAX (count, 1)),
  };
  if (!qn_box_is_empty (scene->box))
    batch->origin = qn_vec2_lerp (scene->box.min, scene->box.max, 0.5);
  for (guint i = 0; i < count; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    QnGlBrush brush = { .batch = batch,
                        .scratch = scratch,
                        .scratch_points = scratch_points,
                        .color = command->color,
                        .thin = qn_command_is_thinned (command) };
    const QnVec2 *points = qn_scene_points (scene, command);
    batch->ranges[i].first = batch->indices->len;
    switch ((QnCommandKind) command->kind) {
    case QN_COMMAND_FILL:
      qn_gl_add_fill (&brush, points, command->count);
      break;
    case QN_COMMAND_STROKE:
      qn_gl_add_line (&brush, points, command->count, command->closed, command->dashed,
                      command->size);
      break;
    case QN_COMMAND_MARKER:
      add_marker (brush, scene, command);
      break;
    case QN_COMMAND_TEXT:
    case QN_COMMAND_IMAGE:
      break;
    }
    batch->ranges[i].count = batch->indices->len - batch->ranges[i].first;
  }
}

void
qn_gl_batch_clear (QnGlBatch *batch)
{
  g_clear_pointer (&batch->vertices, g_array_unref);
  g_clear_pointer (&batch->indices, g_array_unref);
  g_clear_pointer (&batch->ranges, g_free);
}
