#include "doc/edit/edit.h"

#include "core/base/integer.h"
#include "core/base/name-index.h"
#include "core/base/polygon.h"
#include "doc/text/explain.h"
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Distance from a joint that is rounding, relative to the size of a block. */
#define ON_JOINT 1e-9

/* clang-format off */
G_DEFINE_QUARK (qn-edit-error-quark, qn_edit_error)
/* clang-format on */

/* Where the parts of the old model went; QN_NONE: they are gone. */
typedef struct Rebuild {
  const QnModel *from;
  QnModel *to;
  const QnMasonries *masonry; /* laid again; NULL: masonry blocks stay as they are */
  QnId *blocks;               /* of old free blocks */
  QnId *walls, *nodes, *beams;
} Rebuild;

gboolean
qn_edit_no_memory (GError **error)
{
  return qn_edit_refuse (error, _ ("Not enough memory"));
}

gboolean
qn_edit_refuse (GError **error, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *message = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_set_error_literal (error, QN_EDIT_ERROR, 0, message);
  return FALSE;
}

gboolean
qn_edit_refuse_diag (GError **error, const QnModel *model, const QnDiag *diag)
{
  g_autofree char *message = qn_explain_diag (model, diag);
  return qn_edit_refuse (error, "%s", message);
}

gboolean *
qn_block_set_to_flags (QnBlockSet set, const QnModel *model)
{
  gboolean *flags = g_new0 (gboolean, model->block_count + 1);
  for (guint i = 0; i < set.count; i++) {
    if (set.ids[i] >= 0 && (gsize) set.ids[i] < model->block_count)
      flags[set.ids[i]] = TRUE;
  }
  return flags;
}

static QnId *
new_ids (gsize count)
{
  QnId *ids = g_new (QnId, count + 1);
  for (gsize i = 0; i < count; i++)
    ids[i] = QN_NONE;
  return ids;
}

/* Blocks that the file lists, or those that parametric masonry was laid of. */
static gboolean
copy_blocks (Rebuild *r, gboolean laid)
{
  for (gsize i = 0; i < r->from->block_count; i++) {
    const QnBlock *old = &r->from->blocks[i];
    if (old->wall != QN_NONE || laid != (old->masonry != QN_NONE)
        || old->vertex_count == 0)
      continue;
    QnBlock *block =
      qn_model_add_block (r->to, old->name, qn_model_block_vertices (r->from, (QnId) i),
                          (gsize) old->vertex_count);
    if (block == NULL)
      return FALSE;
    qn_block_inherit (block, old);
    block->masonry = old->masonry;
    block->note = old->note;
    r->blocks[i] = (QnId) r->to->block_count - 1;
  }
  return TRUE;
}

static gboolean
copy_walls (Rebuild *r)
{
  for (gsize i = 0; i < r->from->wall_count; i++) {
    const QnWall *old = &r->from->walls[i];
    if (old->course_count == 0)
      continue;
    QnWall *wall = qn_model_add_wall (r->to, old->name);
    if (wall == NULL)
      return FALSE;
    wall->origin = old->origin;
    wall->unit = old->unit;
    wall->thickness = old->thickness;
    wall->unit_weight = old->unit_weight;
    wall->density = old->density;
    wall->law = old->law;
    wall->note = old->note;
    for (int32_t course = 0, first = 0; course < old->course_count; course++) {
      int32_t end = old->course_ends[course];
      if (!qn_wall_add_course (wall, old->lengths + first, (gsize) (end - first)))
        return FALSE;
      first = end;
    }
    r->walls[i] = (QnId) r->to->wall_count - 1;
  }
  return TRUE;
}

static QnVec2
middle_of_box (const QnModel *model, QnId block, QnVec2 *half)
{
  QnBox box = qn_model_block_box (model, block);
  *half = qn_vec2_scale (0.5, qn_vec2_sub (box.max, box.min));
  return qn_vec2_lerp (box.min, box.max, 0.5);
}

/* A block of masonry that was laid again is the one of the same name or, where there is none any
 * more, the one that lies where it was. */
static QnId
follow_masonry_block (const Rebuild *r, QnId old)
{
  QnId same = qn_model_find_block (r->to, r->from->blocks[old].name);
  if (same != QN_NONE && r->to->blocks[same].masonry != QN_NONE)
    return same;
  QnVec2 place = qn_polygon_inner_point (qn_model_block_vertices (r->from, old),
                                         (gsize) r->from->blocks[old].vertex_count);
  /* The place may be on a joint of the new ones. */
  double depth;
  QnId best = qn_model_deepest_block (r->to, 0, true, place, &depth);
  return depth > -ON_JOINT * sqrt (r->from->blocks[old].area) ? best : QN_NONE;
}

/* A wall block becomes the one that lies where its middle was. */
static QnId
follow_block (const Rebuild *r, QnId old)
{
  if (old == QN_NONE || r->blocks[old] != QN_NONE)
    return old == QN_NONE ? QN_NONE : r->blocks[old];
  if (r->masonry != NULL && r->from->blocks[old].masonry != QN_NONE)
    return follow_masonry_block (r, old);
  QnId old_wall = r->from->blocks[old].wall;
  if (old_wall == QN_NONE)
    return QN_NONE;
  if (r->walls[old_wall] == QN_NONE)
    return r->masonry != NULL ? follow_masonry_block (r, old) : QN_NONE;

  QnVec2 half;
  QnVec2 middle = middle_of_box (r->from, old, &half);
  for (gsize i = 0; i < r->to->block_count; i++) {
    if (r->to->blocks[i].wall != r->walls[old_wall])
      continue;
    QnVec2 at = qn_vec2_sub (middle, middle_of_box (r->to, (QnId) i, &half));
    if (fabs (at.x) <= half.x && fabs (at.y) <= half.y)
      return (QnId) i;
  }
  return QN_NONE;
}

static gboolean
has_ends (const QnBeam *beam)
{
  return beam->nodes[0] != QN_NONE && beam->nodes[1] != QN_NONE;
}

static gboolean
copy_nodes (Rebuild *r)
{
  const QnModel *from = r->from;
  /* Riding nodes stay whose block is there, free ones with a beam that stays. */
  g_autofree gboolean *stays = g_new0 (gboolean, from->node_count + 1);
  for (gsize i = 0; i < from->node_count; i++)
    stays[i] = from->nodes[i].block == QN_NONE
               || follow_block (r, from->nodes[i].block) != QN_NONE;
  g_autofree gboolean *used = g_new0 (gboolean, from->node_count + 1);
  for (gsize i = 0; i < from->beam_count; i++) {
    const QnId *ends = from->beams[i].nodes;
    if (has_ends (&from->beams[i]) && stays[ends[0]] && stays[ends[1]])
      used[ends[0]] = used[ends[1]] = TRUE;
  }
  for (gsize i = 0; i < from->node_count; i++)
    stays[i] = stays[i] && (used[i] || from->nodes[i].block != QN_NONE);
  for (gsize i = 0; i < from->node_count; i++) {
    const QnNode *old = &from->nodes[i];
    if (old->beam != QN_NONE || !stays[i])
      continue;
    QnNode *node = qn_model_add_node (r->to, old->name);
    if (node == NULL)
      return FALSE;
    char *name = node->name;
    *node = *old;
    node->name = name;
    node->block = follow_block (r, old->block);
    r->nodes[i] = (QnId) r->to->node_count - 1;
  }
  return TRUE;
}

static gboolean
copy_beams (Rebuild *r)
{
  for (gsize i = 0; i < r->from->beam_count; i++) {
    const QnBeam *old = &r->from->beams[i];
    if (!has_ends (old) || r->nodes[old->nodes[0]] == QN_NONE
        || r->nodes[old->nodes[1]] == QN_NONE)
      continue;
    QnBeam *beam = qn_model_add_beam (r->to, old->name);
    if (beam == NULL)
      return FALSE;
    char *name = beam->name;
    *beam = *old;
    beam->name = name;
    for (int end = 0; end < 2; end++)
      beam->nodes[end] = r->nodes[old->nodes[end]];
    r->beams[i] = (QnId) r->to->beam_count - 1;
  }
  return TRUE;
}

/* Nodes that cut a beam become those nearest to their places, for it may be cut into another
 * number of elements. */
static void
follow_inner_nodes (Rebuild *r)
{
  g_autofree guint *counts = g_new0 (guint, r->from->beam_count + 1);
  g_autofree guint *seen = g_new0 (guint, r->from->beam_count + 1);
  for (gsize i = 0; i < r->from->node_count; i++)
    if (r->from->nodes[i].beam != QN_NONE)
      counts[r->from->nodes[i].beam]++;
  for (gsize i = 0; i < r->from->node_count; i++) {
    QnId old = r->from->nodes[i].beam;
    if (old == QN_NONE || r->beams[old] == QN_NONE)
      continue;
    const QnBeam *beam = &r->to->beams[r->beams[old]];
    int32_t last = beam->element_count;
    int32_t number = (int32_t) qn_to_integer (
      round ((double) ++seen[old] / (counts[old] + 1) * last), 0, last);
    r->nodes[i] = number <= 0 ? beam->nodes[0]
                  : number >= last
                    ? beam->nodes[1]
                    : r->to->elements[beam->first_element + number].nodes[0];
  }
}

/* FALSE where what the load acts on is gone. */
static gboolean
follow_load (const Rebuild *r, QnLoad *load)
{
  switch (load->kind) {
  case QN_LOAD_WEIGHT:
  case QN_LOAD_SURCHARGE:
  case QN_LOAD_BACKFILL:
  case QN_LOAD_FILL:
  case QN_LOAD_VEHICLE:
  case QN_LOAD_KIND_COUNT:
    return TRUE;
  case QN_LOAD_NODE:
    load->node = r->nodes[load->node];
    return load->node != QN_NONE;
  case QN_LOAD_LINE:
    load->beam = r->beams[load->beam];
    return load->beam != QN_NONE;
  case QN_LOAD_FORCE:
  case QN_LOAD_SETTLEMENT:
  case QN_LOAD_EDGE:
    break;
  }
  load->block = follow_block (r, load->block);
  return load->block != QN_NONE
         && (load->kind != QN_LOAD_EDGE || load->has_side
             || load->edge < r->to->blocks[load->block].vertex_count);
}

/* Set by set, as files list them. */
static void
keep_loads (const Rebuild *r, QnLoad *loads, size_t *count)
{
  const size_t all = *count;
  g_autofree QnLoad *old = g_memdup2 (loads, all * sizeof *loads);
  *count = 0;
  for (int32_t set = 0; set <= (int32_t) r->to->load_set_count; set++)
    for (size_t i = 0; i < all; i++)
      if (old[i].set == set && follow_load (r, &old[i]))
        loads[(*count)++] = old[i];
}

/* Keeps those items of an array, in their order, that `follow` still finds something for. */
static void
keep_items (const Rebuild *r, gpointer items, gsize size, size_t *count,
            gboolean (*follow) (const Rebuild *r, gpointer item))
{
  size_t kept = 0;
  for (size_t i = 0; i < *count; i++) {
    char *item = (char *) items + i * size;
    if (follow (r, item))
      memmove ((char *) items + kept++ * size, item, size);
  }
  *count = kept;
}

static gboolean
follow_override (const Rebuild *r, gpointer item)
{
  QnFaceOverride *override = item;
  override->block_a = follow_block (r, override->block_a);
  override->block_b = follow_block (r, override->block_b);
  return override->block_a != QN_NONE && override->block_b != QN_NONE;
}

/* Not where a block is gone, or where both have become one. */
static gboolean
follow_tie (const Rebuild *r, gpointer item)
{
  QnTie *tie = item;
  gboolean gone = FALSE;
  for (int end = 0; end < 2; end++) {
    QnId block = tie->ends[end].block;
    tie->ends[end].block = follow_block (r, block);
    gone = gone || (block != QN_NONE && tie->ends[end].block == QN_NONE);
  }
  gone = gone || tie->ends[0].block == tie->ends[1].block;
  if (gone)
    free (tie->name);
  return !gone;
}

static gboolean
follow_initial (const Rebuild *r, gpointer item)
{
  QnInitialMotion *motion = item;
  motion->block = follow_block (r, motion->block);
  return motion->block != QN_NONE;
}

static gboolean
follow_track (const Rebuild *r, gpointer item)
{
  QnTrack *track = item;
  track->block = follow_block (r, track->block);
  return track->block != QN_NONE;
}

/* Of the analysis, then of its stages. */
static void
keep_controls (const Rebuild *r)
{
  for (gsize i = 0; i <= r->to->stage_count; i++) {
    QnControl *control =
      i == 0 ? &r->to->analysis.control : &r->to->stages[i - 1].control;
    control->block = follow_block (r, control->block);
    control->node = control->node == QN_NONE ? QN_NONE : r->nodes[control->node];
  }
}

/* Names may have changed behind the model's back: they are found by new places. */
static gboolean
index_names (QnModel *model)
{
  gboolean done = TRUE;
  for (gsize i = 0; done && i < model->law_count; i++)
    done =
      qn_name_index_add (&model->law_names, model->laws, sizeof *model->laws, (QnId) i);
  for (gsize i = 0; done && i < model->section_count; i++)
    done = qn_name_index_add (&model->section_names, model->sections,
                              sizeof *model->sections, (QnId) i);
  for (gsize i = 0; done && i < model->tie_count; i++)
    done =
      qn_name_index_add (&model->tie_names, model->ties, sizeof *model->ties, (QnId) i);
  return done;
}

/* A copy of the model without blocks, walls, nodes, beams and what follows from them. */
static gboolean
copy_rest (const QnModel *model, QnModel *copy)
{
  const QnNameIndex none = { 0 };
  QnModel rest = *model;
  rest.vertex_count = rest.block_count = rest.wall_count = rest.expanded_wall_count = 0;
  rest.node_count = rest.beam_count = rest.element_count = rest.expanded_beam_count = 0;
  rest.edge_force_count = rest.soil_tie_count = 0;
  rest.law_names = rest.block_names = rest.node_names = rest.section_names =
    rest.beam_names = rest.tie_names = none;
  return qn_model_copy (&rest, copy, NULL) == QN_OK;
}

static gboolean
lay_masonry (const Rebuild *r, GError **error)
{
  for (gsize i = 0; i < r->masonry->count; i++) {
    gsize first = r->to->block_count;
    QnDiag diag = { 0 };
    if (qn_masonry_expand (&r->masonry->items[i], (QnId) i, r->to, &diag) != QN_OK) {
      g_autofree char *message = qn_explain_diag (r->to, &diag);
      return qn_edit_refuse (error, "%s: %s", r->masonry->items[i].name, message);
    }
    for (gsize k = first; k < r->to->block_count; k++)
      r->to->blocks[k].masonry = (QnId) i;
  }
  return TRUE;
}

gboolean
qn_edit_rebuild (QnModel *model, const QnMasonries *masonry, GError **error)
{
  QnModel fresh;
  if (!copy_rest (model, &fresh))
    return qn_edit_no_memory (error);

  g_autofree QnId *blocks = new_ids (model->block_count);
  g_autofree QnId *walls = new_ids (model->wall_count);
  g_autofree QnId *nodes = new_ids (model->node_count);
  g_autofree QnId *beams = new_ids (model->beam_count);
  Rebuild r = { model, &fresh, masonry, blocks, walls, nodes, beams };
  QnDiag diag = { 0 };
  gboolean laid = copy_blocks (&r, FALSE);
  if (laid && masonry != NULL && !lay_masonry (&r, error)) {
    qn_model_clear (&fresh);
    return FALSE;
  }
  gboolean done = laid && (masonry != NULL || copy_blocks (&r, TRUE)) && copy_walls (&r)
                  && qn_model_expand_walls (&fresh, &diag) == QN_OK && copy_nodes (&r)
                  && copy_beams (&r) && qn_model_expand_beams (&fresh, &diag) == QN_OK;
  if (done) {
    follow_inner_nodes (&r);
    keep_loads (&r, fresh.dead_loads, &fresh.dead_load_count);
    keep_loads (&r, fresh.live_loads, &fresh.live_load_count);
    keep_items (&r, fresh.overrides, sizeof *fresh.overrides, &fresh.override_count,
                follow_override);
    keep_items (&r, fresh.ties, sizeof *fresh.ties, &fresh.tie_count, follow_tie);
    keep_items (&r, fresh.initial, sizeof *fresh.initial, &fresh.initial_count,
                follow_initial);
    keep_items (&r, fresh.tracks, sizeof *fresh.tracks, &fresh.track_count, follow_track);
    keep_controls (&r);
    done = index_names (&fresh);
  }
  if (!done && diag.status == QN_ERROR_INVALID)
    qn_edit_refuse_diag (error, &fresh, &diag);
  else if (!done)
    qn_edit_no_memory (error);
  if (!done) {
    qn_model_clear (&fresh);
    return FALSE;
  }

  qn_model_clear (model);
  *model = fresh;
  return TRUE;
}
