#include "doc/edit/edit-frame.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

QnTransform
qn_transform_translation (double x, double y)
{
  return (QnTransform){ 1.0, 0.0, 0.0, 1.0, x, y };
}

QnTransform
qn_transform_rotation (QnVec2 center, double angle)
{
  double c = cos (angle), s = sin (angle);
  return (QnTransform){ c,
                        -s,
                        s,
                        c,
                        center.x - c * center.x + s * center.y,
                        center.y - s * center.x - c * center.y };
}

QnTransform
qn_transform_mirror (QnVec2 a, QnVec2 b)
{
  QnVec2 d = qn_vec2_sub (b, a);
  double square = qn_vec2_dot (d, d);
  if (square == 0.0)
    return qn_transform_translation (0.0, 0.0);
  double c = (d.x * d.x - d.y * d.y) / square, s = 2.0 * d.x * d.y / square;
  return (QnTransform){ c, s, s, -c, a.x - c * a.x - s * a.y, a.y - s * a.x + c * a.y };
}

QnTransform
qn_transform_compose (QnTransform f, QnTransform s)
{
  return (
    QnTransform){ s.xx * f.xx + s.xy * f.yx,        s.xx * f.xy + s.xy * f.yy,
                  s.yx * f.xx + s.yy * f.yx,        s.yx * f.xy + s.yy * f.yy,
                  s.xx * f.x0 + s.xy * f.y0 + s.x0, s.yx * f.x0 + s.yy * f.y0 + s.y0 };
}

QnVec2
qn_transform_apply (QnTransform t, QnVec2 p)
{
  return qn_vec2 (t.xx * p.x + t.xy * p.y + t.x0, t.yx * p.x + t.yy * p.y + t.y0);
}

static gboolean
refuse_nothing (GError **error)
{
  return qn_edit_refuse (error, _ ("No block is selected"));
}

gboolean
qn_edit_add_block (QnModel *model, const QnVec2 *vertices, guint count,
                   QnBlockStyle style, GError **error)
{
  g_autofree char *name = qn_edit_dup_new_name (model, offsetof (QnModel, blocks), "b",
                                                "", model->block_count + 1);
  QnBlock *block = qn_model_add_block (model, name, vertices, count);
  if (block == NULL)
    return qn_edit_no_memory (error);
  block->thickness = style.thickness;
  block->unit_weight = style.unit_weight;
  block->law = style.law;
  memcpy (block->support, style.support, sizeof block->support);
  return TRUE;
}

/* Wall of every block in the set, each once, as flags per wall. */
static gboolean *
walls_of (const QnModel *model, QnBlockSet set)
{
  gboolean *walls = g_new0 (gboolean, model->wall_count + 1);
  for (guint i = 0; i < set.count; i++) {
    QnId wall = model->blocks[set.ids[i]].wall;
    if (wall != QN_NONE)
      walls[wall] = TRUE;
  }
  return walls;
}

/* Blocks of a masonry object follow its parameters. A change of one of them makes all of them
 * plain blocks. */
static void
detach_masonry (QnModel *model, QnBlockSet set)
{
  for (guint i = 0; i < set.count; i++) {
    QnId object = model->blocks[set.ids[i]].masonry;
    for (gsize k = 0; object != QN_NONE && k < model->block_count; k++) {
      if (model->blocks[k].masonry == object)
        model->blocks[k].masonry = QN_NONE;
    }
  }
}

void
qn_wall_remove_courses (QnWall *wall)
{
  free (wall->lengths);
  free (wall->course_ends);
  wall->lengths = NULL;
  wall->course_ends = NULL;
  wall->course_count = 0;
}

/* Makes free blocks of the marked walls; block numbers stay what they are. */
static void
detach_walls (QnModel *model, const gboolean *walls)
{
  for (gsize i = 0; i < model->block_count; i++) {
    QnBlock *block = &model->blocks[i];
    if (block->wall == QN_NONE || !walls[block->wall])
      continue;
    block->wall = QN_NONE;
  }
  for (gsize i = 0; i < model->wall_count; i++) {
    if (walls[i])
      qn_wall_remove_courses (&model->walls[i]);
  }
}

gboolean
qn_edit_take_apart (QnModel *model, QnBlockSet set)
{
  g_autofree gboolean *walls = walls_of (model, set);
  gboolean any = FALSE;
  for (gsize i = 0; i < model->wall_count; i++)
    any = any || walls[i];
  for (guint i = 0; i < set.count; i++)
    any = any || model->blocks[set.ids[i]].masonry != QN_NONE;
  detach_masonry (model, set);
  detach_walls (model, walls);
  return any;
}

gboolean
qn_edit_detach (QnModel *model, QnBlockSet set, GError **error)
{
  return qn_edit_take_apart (model, set)
         || qn_edit_refuse (error, _ ("None of the selected blocks belongs to a wall"));
}

gboolean
qn_edit_delete_blocks (QnModel *model, QnBlockSet set, GError **error)
{
  if (set.count == 0)
    return refuse_nothing (error);
  detach_masonry (model, set);
  for (guint i = 0; i < set.count; i++)
    model->blocks[set.ids[i]].vertex_count = 0;
  /* Turns the entries of deleted wall blocks into openings. Blocks of a wall follow each
   * other in the model in the order of the positive entries. */
  for (gsize w = 0, block = 0; w < model->wall_count; w++) {
    QnWall *wall = &model->walls[w];
    while (block < model->block_count && model->blocks[block].wall != (QnId) w)
      block++;
    int32_t end = wall->course_count > 0 ? wall->course_ends[wall->course_count - 1] : 0;
    gboolean any_left = FALSE;
    for (int32_t entry = 0; entry < end; entry++) {
      if (wall->lengths[entry] < 0.0)
        continue;
      if (model->blocks[block].vertex_count == 0)
        wall->lengths[entry] = -wall->lengths[entry];
      else
        any_left = TRUE;
      block++;
    }
    if (!any_left)
      qn_wall_remove_courses (wall);
  }
  return TRUE;
}

static gboolean
is_translation (QnTransform t)
{
  return t.xx == 1.0 && t.yy == 1.0 && t.xy == 0.0 && t.yx == 0.0;
}

gboolean
qn_edit_transform_blocks (QnModel *model, QnBlockSet set, QnTransform transform,
                          GError **error)
{
  if (set.count == 0)
    return refuse_nothing (error);
  g_autofree gboolean *flags = qn_block_set_to_flags (set, model);
  detach_masonry (model, set);
  g_autofree gboolean *walls = walls_of (model, set);
  g_autofree gboolean *broken = g_new0 (gboolean, model->wall_count + 1);
  for (gsize i = 0; i < model->block_count; i++) {
    QnId wall = model->blocks[i].wall;
    if (wall != QN_NONE && walls[wall] && (!flags[i] || !is_translation (transform)))
      broken[wall] = TRUE;
  }
  for (gsize w = 0; w < model->wall_count; w++) {
    if (walls[w] && !broken[w])
      model->walls[w].origin = qn_transform_apply (transform, model->walls[w].origin);
  }
  qn_edit_transform_attached (model, flags, transform);
  for (gsize i = 0; i < model->block_count; i++) {
    if (!flags[i])
      continue;
    QnVec2 *v = model->vertices + model->blocks[i].first_vertex;
    for (QnId k = 0; k < model->blocks[i].vertex_count; k++)
      v[k] = qn_transform_apply (transform, v[k]);
  }
  detach_walls (model, broken);
  return TRUE;
}

gboolean
qn_edit_copy_blocks (QnModel *model, QnBlockSet set, QnTransform transform, int copies,
                     GError **error)
{
  if (set.count == 0)
    return refuse_nothing (error);
  QnTransform step = qn_transform_translation (0.0, 0.0);
  for (int k = 0; k < copies; k++) {
    step = qn_transform_compose (step, transform);
    for (guint i = 0; i < set.count; i++) {
      const QnBlock old = model->blocks[set.ids[i]];
      gsize count = (gsize) old.vertex_count;
      g_autofree QnVec2 *vertices = g_new (QnVec2, count);
      for (gsize v = 0; v < count; v++)
        vertices[v] =
          qn_transform_apply (step, qn_model_block_vertices (model, set.ids[i])[v]);
      g_autofree char *name = qn_edit_dup_new_name (model, offsetof (QnModel, blocks),
                                                    "b", "", model->block_count + 1);
      QnBlock *block = qn_model_add_block (model, name, vertices, count);
      if (block == NULL)
        return qn_edit_no_memory (error);
      qn_block_inherit (block, &old);
    }
  }
  return TRUE;
}

gboolean
qn_edit_set_support (QnModel *model, QnBlockSet set, int first, int count,
                     const bool *support, GError **error)
{
  if (set.count == 0)
    return refuse_nothing (error);
  /* The courses of a wall say nothing of supports. */
  detach_masonry (model, set);
  g_autofree gboolean *walls = walls_of (model, set);
  for (guint i = 0; i < set.count; i++) {
    for (int dof = 0; dof < count; dof++)
      model->blocks[set.ids[i]].support[first + dof] = support[dof];
  }
  detach_walls (model, walls);
  return TRUE;
}

gboolean
qn_edit_set_blocks (QnModel *model, QnBlockSet set, QnBlockField field, double value,
                    GError **error)
{
  if (set.count == 0)
    return refuse_nothing (error);
  detach_masonry (model, set);
  for (guint i = 0; i < set.count; i++) {
    QnBlock *block = &model->blocks[set.ids[i]];
    QnWall *wall = block->wall != QN_NONE ? &model->walls[block->wall] : NULL;
    switch (field) {
    case QN_BLOCK_THICKNESS:
      *(wall != NULL ? &wall->thickness : &block->thickness) = value;
      break;
    case QN_BLOCK_UNIT_WEIGHT:
      *(wall != NULL ? &wall->unit_weight : &block->unit_weight) = value;
      *(wall != NULL ? &wall->density : &block->density) = -1.0;
      break;
    case QN_BLOCK_LAW:
      *(wall != NULL ? &wall->law : &block->law) = (QnId) value;
      break;
    }
  }
  return TRUE;
}

gboolean
qn_edit_rename_block (QnModel *model, QnId id, const char *name, GError **error)
{
  QnBlock *block = &model->blocks[id];
  detach_masonry (model, (QnBlockSet){ &id, 1 });
  if (block->wall != QN_NONE)
    return qn_edit_refuse (error,
                           _ ("Blocks of a wall are named by their course and position; "
                              "detach the wall to rename them"));
  return qn_edit_take_name (&block->name, name, error);
}
