#include "doc/edit/edit-shape.h"

#include "core/base/numbers.h"
#include "core/base/polygon.h"
#include "stereotomy/polygon-ops.h"
#include <glib/gi18n-lib.h>
#include <math.h>

/* Lengths below this part of a block's size are rounding. */
#define LEAST_PART 1e-9

/* ---- common ---- */

QnRing
qn_block_to_ring (const QnModel *model, QnId block)
{
  return qn_ring_of (qn_model_block_vertices (model, block),
                     (gsize) model->blocks[block].vertex_count);
}

static gsize
largest_ring (const QnRings *rings)
{
  gsize best = 0;
  for (gsize i = 1; i < rings->count; i++) {
    if (fabs (qn_ring_area (&rings->items[i]))
        > fabs (qn_ring_area (&rings->items[best])))
      best = i;
  }
  return best;
}

/* New polygons, as blocks from `first` on, of which `keeper` takes the place of the block `main`. */
typedef struct Parts {
  QnId first, keeper, main;
} Parts;

/* The part that a point of application belongs to: the one it is deepest in. */
static QnId
part_at (const QnModel *model, const Parts *parts, QnVec2 at)
{
  double depth;
  QnId part = qn_model_deepest_block (model, parts->first, false, at, &depth);
  return part == parts->keeper ? parts->main : part;
}

/* Everything that pointed at a block points at one of the parts. */
static void
redirect (QnModel *model, QnId gone, const Parts *parts)
{
  for (gsize i = 0; i < qn_model_load_count (model); i++) {
    QnLoad *load = qn_model_load (model, i);
    if (load->kind == QN_LOAD_WEIGHT || load->kind == QN_LOAD_EDGE || load->block != gone)
      continue;
    if (load->kind == QN_LOAD_SETTLEMENT) {
      load->block = parts->main;
      continue;
    }
    if (!load->has_at) {
      load->has_at = true;
      load->at = model->blocks[gone].centroid;
    }
    load->block = part_at (model, parts, load->at);
  }
  gsize kept = 0;
  for (gsize i = 0; i < model->override_count; i++) {
    QnFaceOverride override = model->overrides[i];
    if (override.block_a == gone)
      override.block_a = parts->main;
    if (override.block_b == gone)
      override.block_b = parts->main;
    if (override.block_a != override.block_b)
      model->overrides[kept++] = override;
  }
  model->override_count = kept;
  if (model->analysis.control.block == gone)
    model->analysis.control.block = parts->main;
  for (gsize i = 0; i < 2 * model->tie_count; i++) {
    QnTieEnd *end = &model->ties[i / 2].ends[i % 2];
    if (end->block == gone)
      end->block = part_at (model, parts, end->at);
  }
  for (gsize i = 0; i < model->node_count; i++) {
    QnNode *node = &model->nodes[i];
    if (node->block != gone)
      continue;
    node->seat = QN_SEAT_POINT;
    node->block = part_at (model, parts, node->at);
  }
}

gboolean
qn_edit_replace_blocks (QnModel *model, const QnId *gone, guint count,
                        const QnRings *rings, GError **error)
{
  const QnId first = (QnId) model->block_count;
  const Parts parts = { first, first + (QnId) largest_ring (rings), gone[0] };
  for (gsize i = 0; i < rings->count; i++) {
    g_autofree char *name = qn_edit_dup_new_name (model, offsetof (QnModel, blocks), "b",
                                                  "", model->block_count + 1);
    QnBlock *block =
      qn_model_add_block (model, name, rings->items[i].points, rings->items[i].count);
    if (block == NULL)
      return qn_edit_no_memory (error);
    qn_block_inherit (block, &model->blocks[gone[0]]);
    block->note = 0;
  }
  for (guint i = 0; i < count; i++) {
    redirect (model, gone[i], &parts);
    if (!qn_edit_carry_edge_loads (model, gone[i], first, error))
      return FALSE;
    model->blocks[gone[i]].vertex_count = 0;
  }
  for (gsize i = 0; i < qn_model_load_count (model); i++)
    if (qn_model_load (model, i)->block == parts.keeper)
      qn_model_load (model, i)->block = parts.main;
  QnBlock *keeper = &model->blocks[parts.keeper], *main = &model->blocks[parts.main];
  main->first_vertex = keeper->first_vertex;
  main->vertex_count = keeper->vertex_count;
  keeper->vertex_count = 0;
  return TRUE;
}

/* ---- cutting ---- */

/* Where the segment ab meets the edge pq, as a part of ab; NAN where it does not. */
static double
meet (QnVec2 a, QnVec2 b, QnVec2 p, QnVec2 q)
{
  QnVec2 d = qn_vec2_sub (b, a), e = qn_vec2_sub (q, p), to = qn_vec2_sub (p, a);
  double cross = qn_vec2_cross (d, e);
  if (cross == 0.0)
    return NAN;
  double t = qn_vec2_cross (to, e) / cross, s = qn_vec2_cross (to, d) / cross;
  return s >= 0.0 && s <= 1.0 && t > 0.0 && t < 1.0 ? t : NAN;
}

gboolean
qn_block_is_crossed (const QnModel *model, QnId block, QnVec2 a, QnVec2 b)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  gsize count = (gsize) model->blocks[block].vertex_count;
  g_autoptr (GArray) cuts = g_array_new (FALSE, FALSE, sizeof (double));
  double ends[] = { 0.0, 1.0 }, size = 0.0;
  g_array_append_vals (cuts, ends, 2);
  for (gsize i = 0; i < count; i++) {
    double t = meet (a, b, v[i], v[(i + 1) % count]);
    size = MAX (size, qn_vec2_length (qn_vec2_sub (v[i], v[0])));
    if (!isnan (t))
      g_array_append_val (cuts, t);
  }
  g_array_sort (cuts, qn_compare_doubles);
  for (guint i = 1; i < cuts->len; i++) {
    double from = g_array_index (cuts, double, i - 1);
    double to = g_array_index (cuts, double, i);
    if (qn_polygon_depth (v, count, qn_vec2_lerp (a, b, 0.5 * (from + to)))
        > LEAST_PART * size)
      return TRUE;
  }
  return FALSE;
}

static gboolean
cut_block (QnModel *model, QnId id, QnVec2 a, QnVec2 b, gboolean *done, GError **error)
{
  g_auto (QnRing) ring = qn_block_to_ring (model, id);
  g_auto (QnRings) parts = { 0 };
  QnDiag diag = { 0 };
  if (qn_polygon_cut (&ring, a, b, &parts, &diag) != QN_OK)
    return qn_edit_refuse_diag (error, model, &diag);
  if (parts.count <= 1)
    return TRUE;
  *done = TRUE;
  return qn_edit_replace_blocks (model, &id, 1, &parts, error);
}

/* Blocks of the set, or all, that the segment passes through. */
static GArray *
crossed_blocks (const QnModel *model, QnBlockSet set, QnVec2 a, QnVec2 b)
{
  GArray *crossed = g_array_new (FALSE, FALSE, sizeof (QnId));
  g_autofree gboolean *flags = qn_block_set_to_flags (set, model);
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    if ((set.count == 0 || flags[i]) && qn_block_is_crossed (model, i, a, b))
      g_array_append_val (crossed, i);
  }
  return crossed;
}

gboolean
qn_edit_cut_blocks (QnModel *model, QnBlockSet set, QnVec2 a, QnVec2 b, GError **error)
{
  g_autoptr (GArray) crossed = crossed_blocks (model, set, a, b);
  const QnBlockSet cut = { (const QnId *) crossed->data, crossed->len };
  gboolean any = FALSE;
  qn_edit_take_apart (model, cut);
  for (guint i = 0; i < cut.count; i++)
    if (!cut_block (model, cut.ids[i], a, b, &any, error))
      return FALSE;
  return any
         || qn_edit_refuse (error, set.count > 0
                                     ? _ ("The line crosses none of the selected blocks")
                                     : _ ("The line crosses no block"));
}

/* ---- joining ---- */

gboolean
qn_edit_join_blocks (QnModel *model, QnBlockSet set, GError **error)
{
  if (set.count < 2)
    return qn_edit_refuse (error, _ ("Select the blocks that are to become one"));
  qn_edit_take_apart (model, set);
  g_auto (QnRings) rings = { 0 };
  g_auto (QnRing) whole = { 0 };
  QnDiag diag = { 0 };
  for (guint i = 0; i < set.count; i++)
    qn_rings_add (&rings, qn_model_block_vertices (model, set.ids[i]),
                  (gsize) model->blocks[set.ids[i]].vertex_count);
  if (qn_polygons_union (&rings, &whole, &diag) != QN_OK)
    return qn_edit_refuse_diag (error, model, &diag);
  const QnRings joined = { .items = &whole, .count = 1 };
  return qn_edit_replace_blocks (model, set.ids, set.count, &joined, error);
}

gboolean
qn_edit_join_bodies (QnModel *model, const QnMechanism *mechanism, GError **error)
{
  const QnId *body = mechanism->body_of_block, count = (QnId) mechanism->block_count;
  for (QnId first = 0; first < count; first++) {
    g_autoptr (GArray) ids = g_array_new (FALSE, FALSE, sizeof (QnId));
    const QnBlock *lead = &model->blocks[first];
    for (QnId b = first; body[first] != QN_NONE && b < count; b++)
      if (body[b] == body[first] && model->blocks[b].vertex_count > 0
          && model->blocks[b].thickness == lead->thickness
          && model->blocks[b].unit_weight == lead->unit_weight)
        g_array_append_val (ids, b);
    const QnBlockSet set = { (QnId *) ids->data, ids->len };
    if (ids->len > 1 && !qn_edit_join_blocks (model, set, error))
      return FALSE;
  }
  return TRUE;
}

/* ---- corners ---- */

gboolean
qn_edit_move_corner (QnModel *model, QnBlockSet set, QnVec2 from, QnVec2 to,
                     GError **error)
{
  double reach = LEAST_PART * MAX (1.0, model->characteristic_length);
  g_autofree gboolean *flags = qn_block_set_to_flags (set, model);
  g_autoptr (GArray) touched = g_array_new (FALSE, FALSE, sizeof (QnId));
  for (QnId i = 0; i < (QnId) model->block_count; i++) {
    const QnVec2 *v = qn_model_block_vertices (model, i);
    gboolean at = FALSE;
    for (QnId k = 0; k < model->blocks[i].vertex_count; k++)
      at = at || qn_vec2_length (qn_vec2_sub (v[k], from)) <= reach;
    if (at && (set.count == 0 || flags[i]))
      g_array_append_val (touched, i);
  }
  QnId *ids = (QnId *) touched->data;
  if (touched->len == 0)
    return qn_edit_refuse (error, _ ("There is no corner of a block here"));
  qn_edit_take_apart (model, (QnBlockSet){ ids, touched->len });
  for (guint i = 0; i < touched->len; i++) {
    QnVec2 *v = model->vertices + model->blocks[ids[i]].first_vertex;
    for (QnId k = 0; k < model->blocks[ids[i]].vertex_count; k++) {
      if (qn_vec2_length (qn_vec2_sub (v[k], from)) <= reach)
        v[k] = to;
    }
  }
  return TRUE;
}
