#include "doc/edit/edit-place.h"

#include "core/base/word.h"
#include "doc/edit/edit-masonry.h"
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Sides as long as the longest one, but for rounding. */
#define EQUAL_SIDES 1e-9

/* ---- extents ---- */

static void
add_beam (QnBox *box, const QnModel *model, QnId beam)
{
  for (int end = 0; end < 2; end++)
    qn_box_add_point (box, model->nodes[model->beams[beam].nodes[end]].at);
}

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
  for (guint i = 0; i < set.beams.count; i++)
    add_beam (&extent->box, model, set.beams.ids[i]);
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

/* ---- things ---- */

/* A part that moves as one; blocks by name, since edits change numbers. */
typedef struct Thing {
  GPtrArray *blocks; /* of char * */
  QnId beam;         /* or QN_NONE */
  QnBox box;
} Thing;

static void
clear_thing (gpointer data)
{
  g_ptr_array_unref (((Thing *) data)->blocks);
}

static Thing *
add_thing (GArray *things)
{
  Thing thing = { g_ptr_array_new_with_free_func (g_free), QN_NONE, QN_BOX_EMPTY };
  g_array_append_val (things, thing);
  return &g_array_index (things, Thing, things->len - 1);
}

/* The thing of every whole object and wall, by a key that no two share. */
static Thing *
thing_of_block (GArray *things, GHashTable *known, const QnBlock *block, gboolean whole)
{
  gint64 key = block->masonry != QN_NONE ? 2 * (gint64) block->masonry
                                         : 2 * (gint64) block->wall + 1;
  if (!whole)
    return add_thing (things);
  gpointer place = NULL;
  if (g_hash_table_lookup_extended (known, GSIZE_TO_POINTER ((gsize) key), NULL, &place))
    return &g_array_index (things, Thing, GPOINTER_TO_UINT (place));
  g_hash_table_insert (known, GSIZE_TO_POINTER ((gsize) key),
                       GUINT_TO_POINTER (things->len));
  return add_thing (things);
}

/* Whether all blocks of a wall are in the set; of masonry see qn_edit_whole_objects(). */
static gboolean
has_whole_wall (const QnModel *model, const gboolean *in_set, QnId wall)
{
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].wall == wall && !in_set[i])
      return FALSE;
  return TRUE;
}

/* Free the array. */
static GArray *
find_things (const QnModel *model, QnPartSet set)
{
  GArray *things = g_array_new (FALSE, FALSE, sizeof (Thing));
  g_array_set_clear_func (things, clear_thing);
  g_autoptr (GHashTable) known = g_hash_table_new (NULL, NULL);
  gsize objects = 0;
  g_autofree gboolean *whole = qn_edit_whole_objects (model, set.blocks, &objects);
  g_autofree gboolean *in_set = qn_block_set_to_flags (set.blocks, model);
  g_autofree char *walls = g_new0 (char, model->wall_count + 1); /* 1: whole, 2: not */
  for (guint i = 0; i < set.blocks.count; i++) {
    QnId id = set.blocks.ids[i];
    const QnBlock *block = &model->blocks[id];
    gboolean together = FALSE;
    if (block->masonry != QN_NONE)
      together = (gsize) block->masonry < objects && whole[block->masonry];
    else if (block->wall != QN_NONE) {
      if (walls[block->wall] == 0)
        walls[block->wall] = has_whole_wall (model, in_set, block->wall) ? 1 : 2;
      together = walls[block->wall] == 1;
    }
    Thing *thing = thing_of_block (things, known, block, together);
    g_ptr_array_add (thing->blocks, g_strdup (block->name));
    qn_box_add_box (&thing->box, qn_model_block_box (model, id));
  }
  for (guint i = 0; i < set.beams.count; i++) {
    Thing *thing = add_thing (things);
    thing->beam = set.beams.ids[i];
    add_beam (&thing->box, model, thing->beam);
  }
  return things;
}

static gboolean
move_thing (QnProject *draft, const Thing *thing, gboolean upward, double way,
            GError **error)
{
  const QnTransform by =
    qn_transform_translation (upward ? 0.0 : way, upward ? way : 0.0);
  if (way == 0.0)
    return TRUE;
  g_autofree QnId *ids = g_new (QnId, thing->blocks->len + 1);
  for (guint i = 0; i < thing->blocks->len; i++) {
    ids[i] = qn_model_find_block (&draft->model, thing->blocks->pdata[i]);
    if (ids[i] == QN_NONE)
      return qn_edit_refuse (error, _ ("Nothing is selected"));
  }
  QnPartSet set = { { ids, thing->blocks->len }, { NULL, 0 } };
  if (thing->beam != QN_NONE)
    set.beams = (QnBeamSet){ &thing->beam, 1 };
  return qn_edit_transform_all (draft, set, by, error);
}

/* The lower side of a box, its middle or its upper side (part 0, 1, 2), upward or to the right. */
static double
part_of (const QnBox *box, gboolean upward, int part)
{
  const double low = upward ? box->min.y : box->min.x;
  const double high = upward ? box->max.y : box->max.x;
  return part == 0 ? low : part == 1 ? 0.5 * (low + high) : high;
}

/* ---- in line ---- */

gboolean
qn_align_parse (const char *name, QnAlign *align)
{
  static const char *const names[QN_ALIGN_COUNT] = { "left", "center", "right",
                                                     "top",  "middle", "bottom" };
  return qn_find_word (name, names, QN_ALIGN_COUNT, align);
}

gboolean
qn_edit_align (QnProject *draft, QnPartSet set, QnAlign align, GError **error)
{
  static const int parts[QN_ALIGN_COUNT] = { 0, 1, 2, 2, 1, 0 };
  g_autoptr (GArray) things = find_things (&draft->model, set);
  QnBox all = QN_BOX_EMPTY;
  if (things->len < 2)
    return qn_edit_refuse (error,
                           _ ("Select at least two blocks or walls to align them"));
  for (guint i = 0; i < things->len; i++)
    qn_box_add_box (&all, g_array_index (things, Thing, i).box);
  for (guint i = 0; i < things->len; i++) {
    const Thing *thing = &g_array_index (things, Thing, i);
    const gboolean upward = align >= QN_ALIGN_TOP;
    if (!move_thing (draft, thing, upward,
                     part_of (&all, upward, parts[align])
                       - part_of (&thing->box, upward, parts[align]),
                     error))
      return FALSE;
  }
  return TRUE;
}

/* ---- at equal distances ---- */

gboolean
qn_spread_parse (const char *name, QnSpreadMode *spread)
{
  static const char *const names[QN_SPREAD_COUNT] = { "centers-x", "centers-y", "gaps-x",
                                                      "gaps-y" };
  return qn_find_word (name, names, QN_SPREAD_COUNT, spread);
}

static double
middle_along (const Thing *thing, gboolean upward)
{
  return part_of (&thing->box, upward, 1);
}

static double
size_along (const Thing *thing, gboolean upward)
{
  return part_of (&thing->box, upward, 2) - part_of (&thing->box, upward, 0);
}

static int
compare_middles (gconstpointer a, gconstpointer b, gpointer upward)
{
  double way = middle_along (a, GPOINTER_TO_INT (upward))
               - middle_along (b, GPOINTER_TO_INT (upward));
  return way < 0.0 ? -1 : way > 0.0;
}

gboolean
qn_edit_spread (QnProject *draft, QnPartSet set, QnSpreadMode spread, GError **error)
{
  g_autoptr (GArray) things = find_things (&draft->model, set);
  gboolean upward = spread == QN_SPREAD_CENTERS_Y || spread == QN_SPREAD_GAPS_Y;
  gboolean gaps = spread == QN_SPREAD_GAPS_X || spread == QN_SPREAD_GAPS_Y;
  guint count = things->len;
  if (count < 3)
    return qn_edit_refuse (
      error, _ ("Select at least three blocks or walls to distribute them"));
  g_array_sort_with_data (things, compare_middles, GINT_TO_POINTER (upward));
  const Thing *first = &g_array_index (things, Thing, 0);
  const Thing *last = &g_array_index (things, Thing, count - 1);
  double from = middle_along (first, upward), to = middle_along (last, upward);
  double between = 0.0; /* sizes between the first and the last middle */
  for (guint i = 0; i < count; i++)
    between += size_along (&g_array_index (things, Thing, i), upward)
               * (i == 0 || i + 1 == count ? 0.5 : 1.0);
  double gap = (to - from - between) / (count - 1);
  double at = from + 0.5 * size_along (first, upward) + gap; /* lower side of the next */
  for (guint i = 1; i + 1 < count; i++) {
    const Thing *thing = &g_array_index (things, Thing, i);
    double size = size_along (thing, upward);
    double goal = gaps ? at + 0.5 * size : from + (to - from) * i / (count - 1);
    double way = goal - middle_along (thing, upward);
    at += size + gap;
    if (!move_thing (draft, thing, upward, way, error))
      return FALSE;
  }
  return TRUE;
}
