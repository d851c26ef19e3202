#include "core/base/polygon.h"
#include "core/base/tolerance.h"
#include "doc/edit/edit.h"

#include <glib/gi18n-lib.h>

QnLoad *
qn_edit_new_load (QnModel *model, gboolean live, GError **error)
{
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  if (load == NULL)
    qn_edit_no_memory (error);
  return load;
}

gboolean
qn_edit_add_force (QnModel *model, QnId block, gboolean live, QnVec2 force, QnVec2 at,
                   GError **error)
{
  QnLoad *load = qn_edit_new_load (model, live, error);
  if (load == NULL)
    return FALSE;
  load->kind = QN_LOAD_FORCE;
  load->block = block;
  load->vector = force;
  load->has_at = true;
  load->at = at;
  return TRUE;
}

QnEdgeChain
qn_model_find_edge (const QnModel *model, QnVec2 at, double reach, QnId of)
{
  QnEdgeChain found = { QN_NONE, 0, 1 };
  for (QnId b = 0; b < (QnId) model->block_count; b++) {
    const QnVec2 *v = qn_model_block_vertices (model, b);
    const QnId n = model->blocks[b].vertex_count;
    for (QnId edge = 0; edge < n && (of == QN_NONE || of == b); edge++) {
      const QnVec2 start = v[edge], way = qn_vec2_sub (v[(edge + 1) % n], start);
      double distance = qn_segment_distance (start, v[(edge + 1) % n], at);
      if (qn_vec2_cross (way, qn_vec2_sub (at, start)) > 0.0)
        distance -= QN_TOLERANCE_CONVEX * qn_vec2_length (way);
      if (distance >= reach)
        continue;
      reach = distance;
      found = (QnEdgeChain){ b, edge, 1 };
    }
  }
  return found;
}

QnEdgeChain
qn_model_join_edges (const QnModel *model, QnEdgeChain from, QnEdgeChain to)
{
  const QnId n = model->blocks[from.block].vertex_count;
  const QnId forward = (to.first - from.first + n) % n + 1;
  const QnId backward = (from.first - to.first + n) % n + 1;
  if (forward <= backward)
    to.first = from.first;
  to.count = MIN (forward, backward);
  return to;
}

void
qn_load_set_chain (QnLoad *load, QnEdgeChain chain)
{
  load->block = chain.block;
  load->has_side = false;
  load->edge = chain.first;
  load->edge_count = chain.count;
}

gboolean
qn_edit_add_edge_load (QnModel *model, QnEdgeChain chain, gboolean live, double intensity,
                       GError **error)
{
  QnLoad *load = qn_edit_new_load (model, live, error);
  if (load == NULL)
    return FALSE;
  load->kind = QN_LOAD_EDGE;
  load->normal = true;
  load->part[1] = 1.0;
  load->intensity[0] = load->intensity[1] = intensity;
  qn_load_set_chain (load, chain);
  return TRUE;
}

void
qn_edit_move_edge_loads (QnModel *model, const gboolean *blocks, QnTransform t)
{
  const gboolean turns = t.xx != 1.0 || t.yy != 1.0 || t.xy != 0.0 || t.yx != 0.0;
  for (gsize i = 0; turns && i < qn_model_load_count (model); i++) {
    QnLoad *load = qn_model_load (model, i);
    QnEdgeChain chain = { .block = load->block };
    if (load->kind != QN_LOAD_EDGE || !load->has_side || !blocks[load->block])
      continue;
    qn_load_chain (model, load, &chain.first, &chain.count);
    qn_load_set_chain (load, chain);
  }
}

/* Where points of an edge of another block lie along the edge ab, as parts of it; FALSE where that edge
 * lies elsewhere. */
static gboolean
lies_along (QnVec2 a, QnVec2 b, QnVec2 from, QnVec2 to, double at[2])
{
  QnVec2 ab = qn_vec2_sub (b, a), other = qn_vec2_sub (to, from);
  double length = qn_vec2_length (ab), off = QN_TOLERANCE_CONVEX * length;
  QnVec2 along = qn_vec2_scale (1.0 / length, ab);
  at[0] = qn_vec2_dot (along, qn_vec2_sub (from, a)) / length;
  at[1] = qn_vec2_dot (along, qn_vec2_sub (to, a)) / length;
  return fabs (qn_vec2_cross (along, qn_vec2_sub (from, a))) <= off
         && fabs (qn_vec2_cross (along, other)) <= off && at[1] > at[0];
}

/* One edge of a load, from `low` to `high` of its length with these intensities. */
typedef struct Loaded {
  QnVec2 a, b;
  double low, high, intensity[2];
} Loaded;

/* The load on what lies there of the edges of new blocks. */
static void
add_carried (GArray *carried, const QnModel *model, const QnLoad *load, QnId first,
             const Loaded *old)
{
  for (QnId block = first; block < (QnId) model->block_count; block++) {
    const QnVec2 *v = qn_model_block_vertices (model, block);
    const QnId count = model->blocks[block].vertex_count;
    for (QnId edge = 0; edge < count; edge++) {
      double at[2];
      if (!lies_along (old->a, old->b, v[edge], v[(edge + 1) % count], at))
        continue;
      double ends[2] = { MAX (old->low, at[0]), MIN (old->high, at[1]) };
      if (!(ends[1] - ends[0] > QN_TOLERANCE_CONVEX))
        continue;
      QnLoad part = *load;
      part.block = block;
      part.has_side = false;
      part.edge = edge;
      part.edge_count = 1;
      for (int end = 0; end < 2; end++) {
        double s = (ends[end] - old->low) / (old->high - old->low);
        part.part[end] = CLAMP ((ends[end] - at[0]) / (at[1] - at[0]), 0.0, 1.0);
        part.intensity[end] = (1.0 - s) * old->intensity[0] + s * old->intensity[1];
      }
      g_array_append_val (carried, part);
    }
  }
}

/* A load on a chain of edges, edge by edge. */
static void
carry (GArray *carried, const QnModel *model, const QnLoad *load, QnId first)
{
  const QnVec2 *v = qn_model_block_vertices (model, load->block);
  const QnId count = model->blocks[load->block].vertex_count;
  double whole = 0.0, start = 0.0;
  QnId begin, edges;
  qn_load_chain (model, load, &begin, &edges);
  for (QnId i = begin; i < begin + edges; i++)
    whole += qn_vec2_length (qn_vec2_sub (v[(i + 1) % count], v[i % count]));
  for (QnId i = begin; i < begin + edges; i++) {
    Loaded old = { .a = v[i % count], .b = v[(i + 1) % count] };
    double length = qn_vec2_length (qn_vec2_sub (old.b, old.a)), ends[2];
    ends[0] = MAX (load->part[0] * whole, start);
    ends[1] = MIN (load->part[1] * whole, start + length);
    for (int end = 0; end < 2; end++) {
      double s = (ends[end] / whole - load->part[0]) / (load->part[1] - load->part[0]);
      old.intensity[end] = (1.0 - s) * load->intensity[0] + s * load->intensity[1];
    }
    old.low = (ends[0] - start) / length;
    old.high = (ends[1] - start) / length;
    if (old.low < old.high)
      add_carried (carried, model, load, first, &old);
    start += length;
  }
}

gboolean
qn_edit_carry_edge_loads (QnModel *model, QnId gone, QnId first, GError **error)
{
  for (int live = 0; live < 2; live++) {
    gsize count;
    const QnLoad *loads = qn_model_loads (model, live, &count);
    g_autoptr (GArray) carried = g_array_new (FALSE, FALSE, sizeof (QnLoad));
    for (gsize i = 0; i < count; i++)
      if (loads[i].kind == QN_LOAD_EDGE && loads[i].block == gone)
        carry (carried, model, &loads[i], first);
    for (gsize i = count; i-- > 0;)
      if (loads[i].kind == QN_LOAD_EDGE && loads[i].block == gone)
        qn_edit_remove_item (model, QN_PICK_LOAD (live), (QnId) i, NULL);
    for (guint i = 0; i < carried->len; i++) {
      QnLoad *added = qn_edit_new_load (model, live, error);
      if (added == NULL)
        return FALSE;
      *added = g_array_index (carried, QnLoad, i);
    }
  }
  return TRUE;
}

gboolean
qn_edit_set_weight_load (QnModel *model, gboolean live, QnVec2 direction, GError **error)
{
  gsize count;
  QnLoad *loads = qn_model_loads (model, live, &count);
  gboolean wanted = direction.x != 0.0 || direction.y != 0.0, found = FALSE;
  for (gsize i = count; i > 0; i--) {
    if (loads[i - 1].kind != QN_LOAD_WEIGHT || loads[i - 1].set != 0)
      continue;
    if (wanted && !found)
      loads[i - 1].vector = direction;
    else
      qn_edit_remove_item (model, QN_PICK_LOAD (live), (QnId) i - 1, NULL);
    found = TRUE;
  }
  if (!wanted || found)
    return TRUE;
  QnLoad *load = qn_edit_new_load (model, live, error);
  if (load == NULL)
    return FALSE;
  load->kind = QN_LOAD_WEIGHT;
  load->vector = direction;
  return TRUE;
}

gboolean
qn_edit_add_law (QnModel *model, QnId like, const char *name, GError **error)
{
  g_autofree char *free_name =
    qn_edit_dup_free_name (model, offsetof (QnModel, laws), name);
  QnLaw *law = qn_model_add_law (model, free_name);
  return (law != NULL && qn_law_assign (law, &model->laws[like]))
         || qn_edit_no_memory (error);
}

/* Calls for every place of the model that names a law. */
static void
each_law (QnModel *model, void (*visit) (QnId *law, gpointer data), gpointer data)
{
  visit (&model->contact.law, data);
  for (gsize i = 0; i < model->bar_count; i++)
    visit (&model->bars[i].law, data);
  for (gsize i = 0; i < model->block_count; i++) {
    if (model->blocks[i].wall == QN_NONE)
      visit (&model->blocks[i].law, data);
    visit (&model->blocks[i].ring_law, data);
  }
  for (gsize i = 0; i < model->wall_count; i++)
    visit (&model->walls[i].law, data);
  for (gsize i = 0; i < model->override_count; i++)
    visit (&model->overrides[i].law, data);
}

typedef struct Uses {
  QnId law, by;
  guint count;
} Uses;

static void
count_use (QnId *law, gpointer data)
{
  Uses *uses = data;
  uses->count += *law == uses->law;
}

guint
qn_edit_count_law_uses (const QnModel *model, QnId law)
{
  Uses uses = { .law = law };
  each_law ((QnModel *) model, count_use, &uses);
  return uses.count;
}

static void
shift_law (QnId *law, gpointer data)
{
  const Uses *uses = data;
  if (*law == uses->law)
    *law = uses->by;
  if (*law > uses->law)
    (*law)--;
}

gboolean
qn_edit_delete_law (QnModel *model, QnId id, QnId by, GError **error)
{
  if (by == QN_NONE && model->contact.law == id)
    return qn_edit_refuse (error,
                           _ ("The law of all other contacts cannot be removed; choose "
                              "another one for them first"));
  for (gsize i = 0; by == QN_NONE && i < model->bar_count; i++) {
    if (model->bars[i].law == id)
      return qn_edit_refuse (error, _ ("The law of a reinforcing bar cannot be removed"));
  }
  Uses uses = { .law = id, .by = by };
  each_law (model, shift_law, &uses);
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].wall != QN_NONE)
      shift_law (&model->blocks[i].law, &uses);
  qn_law_clear (&model->laws[id]);
  qn_edit_drop (model->laws, &model->law_count, sizeof *model->laws, (gsize) id);
  return TRUE;
}

/* ---- exceptions for faces ---- */

gboolean
qn_override_concerns (const QnFaceOverride *override, QnId a, QnId b)
{
  return (override->block_a == a && override->block_b == b)
         || (override->block_a == b && override->block_b == a);
}

/* Of two exceptions for the same blocks the later counts. */
const QnFaceOverride *
qn_model_find_override (const QnModel *model, const QnContactFace *face)
{
  for (gsize i = model->override_count; i > 0; i--) {
    if (qn_override_concerns (&model->overrides[i - 1], face->a, face->b))
      return &model->overrides[i - 1];
  }
  return NULL;
}

/* Puts an exception in the place of those there were. */
static gboolean
replace_override (QnModel *model, const QnContactFace *face, QnFaceOverride override,
                  GError **error)
{
  override.block_a = face->a;
  override.block_b = face->b;
  gboolean wanted = override.law != QN_NONE || override.has_pairs;
  gsize kept = 0;
  for (gsize i = 0; i < model->override_count; i++) {
    if (!qn_override_concerns (&model->overrides[i], face->a, face->b))
      model->overrides[kept++] = model->overrides[i];
    else if (wanted) {
      model->overrides[kept++] = override;
      wanted = FALSE;
    }
  }
  model->override_count = kept;
  if (!wanted)
    return TRUE;
  QnFaceOverride *added = qn_model_add_override (model);
  if (added == NULL)
    return qn_edit_no_memory (error);
  *added = override;
  return TRUE;
}

gboolean
qn_edit_set_faces (QnModel *model, QnFaceSet set, const QnId *law, const QnPairRule *rule,
                   GError **error)
{
  if (set.count == 0)
    return qn_edit_refuse (error, _ ("No contact face is selected"));
  for (guint i = 0; i < set.count; i++) {
    if ((gsize) set.ids[i] >= set.contacts->face_count)
      continue;
    const QnContactFace *face = &set.contacts->faces[set.ids[i]];
    const QnFaceOverride *old = qn_model_find_override (model, face);
    QnFaceOverride override = old != NULL ? *old : (QnFaceOverride){ .law = QN_NONE };
    if (law != NULL)
      override.law = *law;
    else {
      override.has_pairs = rule != NULL;
      override.pairs = rule != NULL ? *rule : (QnPairRule){ 0 };
    }
    if (!replace_override (model, face, override, error))
      return FALSE;
  }
  return TRUE;
}
