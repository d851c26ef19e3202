#include "doc/edit/edit-place.h"

#include "doc/edit/edit-masonry.h"
#include <glib/gi18n-lib.h>
#include <math.h>

/* Sides as long as the longest one, but for rounding. */
#define EQUAL_SIDES 1e-9

/* Of a side without direction, above -90 and up to 90 degrees. */
static double
side_angle (QnVec2 side)
{
  double angle = atan2 (side.y, side.x);
  if (angle > G_PI_2 + 1e-12)
    angle -= G_PI;
  else if (angle <= -G_PI_2 + 1e-12)
    angle += G_PI;
  return angle == 0.0 ? 0.0 : angle;
}

static double
block_angle (const QnModel *model, QnId block)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  QnId count = model->blocks[block].vertex_count;
  double longest = 0.0, angle = G_PI;
  for (QnId k = 0; k < count; k++)
    longest = fmax (longest, qn_vec2_length (qn_vec2_sub (v[(k + 1) % count], v[k])));
  for (QnId k = 0; k < count; k++) {
    QnVec2 side = qn_vec2_sub (v[(k + 1) % count], v[k]);
    double its = side_angle (side);
    if (qn_vec2_length (side) > longest * (1.0 - EQUAL_SIDES)
        && fabs (its) < fabs (angle))
      angle = its;
  }
  return angle;
}

gboolean
qn_extent_find (const QnModel *model, QnPartSet set, QnExtent *extent)
{
  *extent = (QnExtent){ .box = QN_BOX_EMPTY };
  for (guint i = 0; i < set.blocks.count; i++) {
    const QnBlock *block = &model->blocks[set.blocks.ids[i]];
    qn_box_add_box (&extent->box, qn_model_block_box (model, set.blocks.ids[i]));
    extent->area += block->area;
    extent->weight += block->weight;
    extent->centroid =
      qn_vec2_add_scaled (extent->centroid, block->area, block->centroid);
  }
  for (guint i = 0; i < 2 * set.beams.count; i++)
    qn_box_add_point (&extent->box,
                      model->nodes[model->beams[set.beams.ids[i / 2]].nodes[i % 2]].at);
  extent->centroid = extent->area > 0.0
                       ? qn_vec2_scale (1.0 / extent->area, extent->centroid)
                       : qn_vec2_lerp (extent->box.min, extent->box.max, 0.5);
  if (set.blocks.count == 1 && set.beams.count == 0)
    extent->angle = block_angle (model, set.blocks.ids[0]);
  return set.blocks.count + set.beams.count > 0;
}

gboolean
qn_extent_can_scale (const QnModel *model, QnPartSet set)
{
  for (guint i = 0; i < set.blocks.count; i++) {
    const QnBlock *block = &model->blocks[set.blocks.ids[i]];
    if (block->wall != QN_NONE || block->masonry != QN_NONE)
      return FALSE;
  }
  return set.blocks.count > 0 && set.beams.count == 0;
}

static QnTransform
scaling (QnVec2 fixed, double x, double y)
{
  return (QnTransform){ x, 0.0, 0.0, y, fixed.x * (1.0 - x), fixed.y * (1.0 - y) };
}

gboolean
qn_edit_set_extent (QnProject *draft, QnPartSet set, QnExtentField field, double value,
                    GError **error)
{
  QnExtent extent;
  QnTransform transform = qn_transform_translation (0.0, 0.0);
  if (!qn_extent_find (&draft->model, set, &extent))
    return qn_edit_refuse (error, _ ("Nothing is selected"));
  QnVec2 size = qn_vec2_sub (extent.box.max, extent.box.min);
  gboolean scales = field == QN_EXTENT_WIDTH || field == QN_EXTENT_HEIGHT;
  if (scales && !qn_extent_can_scale (&draft->model, set))
    return qn_edit_refuse (error, _ ("Blocks of walls have their sizes from the wall"));
  if (scales && !(value > 0.0))
    return qn_edit_refuse (error, _ ("Sizes must be positive"));
  switch (field) {
  case QN_EXTENT_X:
    transform = qn_transform_translation (value - extent.box.min.x, 0.0);
    break;
  case QN_EXTENT_Y:
    transform = qn_transform_translation (0.0, value - extent.box.min.y);
    break;
  case QN_EXTENT_WIDTH:
    transform = scaling (extent.box.min, value / size.x, 1.0);
    break;
  case QN_EXTENT_HEIGHT:
    transform = scaling (extent.box.min, 1.0, value / size.y);
    break;
  case QN_EXTENT_ANGLE:
    transform = qn_transform_rotation (extent.centroid, value - extent.angle);
    break;
  case QN_EXTENT_COUNT:
    break;
  }
  return qn_edit_transform_all (draft, set, transform, error);
}
