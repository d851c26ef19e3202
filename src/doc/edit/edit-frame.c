#include "doc/edit/edit-frame.h"

#include "core/base/integer.h"
#include "core/base/polygon.h"
#include "doc/edit/edit-masonry.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static gboolean
refuse_no_beam (GError **error)
{
  return qn_edit_refuse (error, _ ("No beam is selected"));
}

/* Places nearer to each other, relative to their coordinates, are one. */
#define SAME_PLACE 1e-9

static double
place_reach (QnVec2 at)
{
  return SAME_PLACE * MAX (1.0, MAX (fabs (at.x), fabs (at.y)));
}

/* ---- adding ---- */

/* The node at a place, added where there is none: riding on the block that lies there, or standing
 * free. QN_NONE where memory runs out. */
static QnId
take_node (QnModel *model, QnVec2 at)
{
  QnId there = qn_model_node_near (model, at, place_reach (at));
  if (there != QN_NONE)
    return there;
  g_autofree char *name =
    qn_edit_dup_new_name (model, offsetof (QnModel, nodes), "n", "", 1);
  QnNode *node = qn_model_add_node (model, name);
  if (node == NULL)
    return QN_NONE;
  node->at = at;
  node->block = qn_model_block_under (model, at);
  node->seat = node->block != QN_NONE ? QN_SEAT_POINT : QN_SEAT_FREE;
  return (QnId) model->node_count - 1;
}

static QnId
take_section (QnModel *model, const char *name, GError **error)
{
  QnId section = name != NULL ? qn_model_find_section (model, name) : QN_NONE;
  if (section != QN_NONE || model->section_count > 0)
    return section != QN_NONE ? section : 0;
  return qn_edit_add_section (model, QN_NONE, error) ? (QnId) model->section_count - 1
                                                     : QN_NONE;
}

/* Nodes that will cut the beam must not have the names of others. */
static char *
dup_beam_name (const QnModel *model)
{
  for (gsize number = model->beam_count + 1;; number++) {
    g_autofree char *name = g_strdup_printf ("beam%" G_GSIZE_FORMAT, number);
    g_autofree char *inner = g_strdup_printf ("%s.1", name);
    if (qn_model_find_beam (model, name) == QN_NONE
        && qn_model_find_node (model, inner) == QN_NONE)
      return g_steal_pointer (&name);
  }
}

gboolean
qn_edit_add_beam (QnModel *model, QnVec2 from, QnVec2 to, QnBeamStyle style,
                  GError **error)
{
  g_autofree char *name = dup_beam_name (model);
  QnId section = take_section (model, style.section, error);
  if (section == QN_NONE)
    return FALSE;
  QnId first = take_node (model, from);
  QnId second = first != QN_NONE ? take_node (model, to) : QN_NONE;
  QnBeam *beam = second != QN_NONE ? qn_model_add_beam (model, name) : NULL;
  if (beam == NULL)
    return qn_edit_no_memory (error);
  beam->kind = style.kind;
  beam->nodes[0] = first;
  beam->nodes[1] = second;
  beam->section = section;
  beam->hinge[0] = style.hinge[0];
  beam->hinge[1] = style.hinge[1];
  beam->element_count = MAX (style.element_count, 1);
  return TRUE;
}

/* ---- removing ---- */

/* A riding node of these beams that carries no other goes with them as a free one would. */
static void
let_go (QnModel *model, QnId node)
{
  if (qn_model_node_beams (model, node) == 0) {
    model->nodes[node].seat = QN_SEAT_FREE;
    model->nodes[node].block = QN_NONE;
  }
}

gboolean
qn_edit_delete_all (QnModel *model, QnPartSet set, GError **error)
{
  /* Rebuilding leaves out beams without nodes. */
  for (guint i = 0; i < set.beams.count; i++) {
    QnBeam *beam = &model->beams[set.beams.ids[i]];
    QnId ends[2] = { beam->nodes[0], beam->nodes[1] };
    beam->nodes[0] = beam->nodes[1] = QN_NONE;
    for (int end = 0; end < 2; end++)
      if (ends[end] != QN_NONE)
        let_go (model, ends[end]);
  }
  if (set.blocks.count == 0 && set.beams.count > 0)
    return TRUE;
  return qn_edit_delete_blocks (model, set.blocks, error);
}

/* ---- properties ---- */

gboolean
qn_edit_set_beams (QnModel *model, QnBeamSet set, QnBeamField field, double value,
                   GError **error)
{
  for (guint i = 0; i < set.count; i++) {
    QnBeam *beam = &model->beams[set.ids[i]];
    switch (field) {
    case QN_BEAM_SECTION:
      beam->section = (QnId) value;
      break;
    case QN_BEAM_KIND:
      beam->kind = (QnBeamKind) value;
      break;
    case QN_BEAM_ELEMENTS:
      beam->element_count = (int32_t) qn_to_integer (value, 0, G_MAXINT32);
      break;
    case QN_BEAM_FIRST_HINGE:
    case QN_BEAM_SECOND_HINGE:
      beam->hinge[field - QN_BEAM_FIRST_HINGE] = value != 0.0;
      break;
    }
  }
  return set.count > 0 || refuse_no_beam (error);
}

/* ---- loads along beams ---- */

static gboolean
is_line_load (const QnLoad *load, QnId beam)
{
  return load->kind == QN_LOAD_LINE && load->beam == beam && load->set == 0;
}

QnVec2
qn_model_line_load (const QnModel *model, QnId beam, gboolean live)
{
  gsize count;
  const QnLoad *loads = qn_model_loads (model, live, &count);
  QnVec2 sum = qn_vec2 (0.0, 0.0);
  for (gsize i = 0; i < count; i++)
    if (is_line_load (&loads[i], beam))
      sum = qn_vec2_add (sum, loads[i].vector);
  return sum;
}

gboolean
qn_edit_set_line_load (QnModel *model, QnBeamSet set, gboolean live, QnVec2 value,
                       GError **error)
{
  for (guint k = 0; k < set.count; k++) {
    gsize count;
    const QnLoad *loads = qn_model_loads (model, live, &count);
    for (gsize i = count; i > 0; i--)
      if (is_line_load (&loads[i - 1], set.ids[k])
          && !qn_edit_remove_item (model, QN_PICK_LOAD (live), (QnId) i - 1, error))
        return FALSE;
    if (value.x == 0.0 && value.y == 0.0)
      continue;
    QnLoad *load = qn_edit_new_load (model, live, error);
    if (load == NULL)
      return FALSE;
    load->kind = QN_LOAD_LINE;
    load->beam = set.ids[k];
    load->vector = value;
  }
  return set.count > 0 || refuse_no_beam (error);
}

void
qn_edit_transform_attached (QnModel *model, const gboolean *flags, QnTransform transform)
{
  gboolean all = TRUE;
  qn_edit_move_edge_loads (model, flags, transform);
  for (gsize i = 0; i < qn_model_load_count (model); i++) {
    QnLoad *load = qn_model_load (model, i);
    if (load->kind == QN_LOAD_FORCE && load->has_at && flags[load->block])
      load->at = qn_transform_apply (transform, load->at);
  }
  for (gsize i = 0; i < model->block_count; i++)
    all = all && flags[i];
  for (gsize i = 0; i < model->node_count; i++) {
    QnNode *node = &model->nodes[i];
    gboolean moves = node->block != QN_NONE ? flags[node->block] : all;
    if (moves && (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT))
      node->at = qn_transform_apply (transform, node->at);
  }
  for (gsize i = 0; i < 2 * model->tie_count; i++) {
    QnTieEnd *end = &model->ties[i / 2].ends[i % 2];
    if (end->block != QN_NONE ? flags[end->block] : all)
      end->at = qn_transform_apply (transform, end->at);
  }
}

/* ---- moving ---- */

/* A node that goes somewhere; told by name, because blocks that move may change numbers. */
typedef struct Target {
  char *name;
  QnVec2 at;
} Target;

static void
free_target (gpointer data)
{
  g_free (((Target *) data)->name);
}

/* Nodes of the beams that their blocks do not take along. */
static GArray *
collect_targets (const QnModel *model, QnPartSet set, QnTransform transform)
{
  GArray *targets = g_array_new (FALSE, FALSE, sizeof (Target));
  g_array_set_clear_func (targets, free_target);
  g_autofree gboolean *moved = qn_block_set_to_flags (set.blocks, model);
  g_autofree gboolean *known = g_new0 (gboolean, model->node_count + 1);
  for (guint i = 0; i < set.beams.count; i++) {
    for (int end = 0; end < 2; end++) {
      QnId id = model->beams[set.beams.ids[i]].nodes[end];
      const QnNode *node = &model->nodes[id];
      gboolean goes = node->seat == QN_SEAT_FREE
                      || (node->seat == QN_SEAT_POINT && !moved[node->block]);
      if (!goes || known[id])
        continue;
      known[id] = TRUE;
      Target target = { g_strdup (node->name), qn_transform_apply (transform, node->at) };
      g_array_append_val (targets, target);
    }
  }
  return targets;
}

gboolean
qn_edit_transform_all (QnProject *draft, QnPartSet set, QnTransform transform,
                       GError **error)
{
  if (set.beams.count == 0)
    return qn_edit_transform (draft, set.blocks, transform, error);
  g_autoptr (GArray) targets = collect_targets (&draft->model, set, transform);
  if (set.blocks.count > 0 && !qn_edit_transform (draft, set.blocks, transform, error))
    return FALSE;
  for (guint i = 0; i < targets->len; i++) {
    const Target *target = &g_array_index (targets, Target, i);
    QnId node = qn_model_find_node (&draft->model, target->name);
    if (node != QN_NONE)
      draft->model.nodes[node].at = target->at;
  }
  return TRUE;
}

/* ---- copying ---- */

static gboolean
copy_beam (QnModel *model, QnId id, QnTransform step, GError **error)
{
  const QnBeam old = model->beams[id];
  QnNode from[2];
  QnVec2 ends[2];
  gboolean is_new[2];
  for (int end = 0; end < 2; end++) {
    gsize before = model->node_count;
    from[end] = model->nodes[old.nodes[end]];
    ends[end] = qn_transform_apply (step, from[end].at);
    if (take_node (model, ends[end]) == QN_NONE)
      return qn_edit_no_memory (error);
    is_new[end] = model->node_count > before;
  }
  QnBeamStyle style = { .section = model->sections[old.section].name,
                        .kind = old.kind,
                        .hinge = { old.hinge[0], old.hinge[1] },
                        .element_count = old.element_count };
  if (!qn_edit_add_beam (model, ends[0], ends[1], style, error))
    return FALSE;
  const QnBeam *beam = &model->beams[model->beam_count - 1];
  for (int end = 0; end < 2; end++) {
    QnNode *node = &model->nodes[beam->nodes[end]];
    if (is_new[end] && node->block == QN_NONE)
      memcpy (node->support, from[end].support, sizeof node->support);
  }
  return TRUE;
}

gboolean
qn_edit_copy_all (QnProject *draft, QnPartSet set, QnTransform transform, int copies,
                  GError **error)
{
  if ((set.blocks.count > 0 || set.beams.count == 0)
      && !qn_edit_copy (draft, set.blocks, transform, copies, error))
    return FALSE;
  QnTransform step = qn_transform_translation (0.0, 0.0);
  for (int k = 0; k < copies; k++) {
    step = qn_transform_compose (step, transform);
    for (guint i = 0; i < set.beams.count; i++)
      if (!copy_beam (&draft->model, set.beams.ids[i], step, error))
        return FALSE;
  }
  return TRUE;
}

/* Plain concrete, where nothing is known. */
#define FIRST_YOUNG       30e9
#define FIRST_POISSON     0.2
#define FIRST_SIZE        0.2
#define FIRST_UNIT_WEIGHT 24e3

gboolean
qn_edit_set_section_shape (QnModel *model, QnId id, gboolean rectangle, GError **error)
{
  QnSection *section = &model->sections[id];
  if (rectangle == (section->height > 0.0))
    return TRUE;
  if (rectangle) { /* of the same area and inertia */
    section->height = sqrt (12.0 * section->inertia / section->area);
    section->width = section->area / section->height;
  } else {
    section->area = section->width * section->height;
    section->inertia = section->area * section->height * section->height / 12.0;
    double plastic = qn_section_plastic_moment (section);
    section->plastic_moment = isfinite (plastic) ? plastic : 0.0;
    section->width = section->height = section->yield = 0.0;
  }
  return TRUE;
}

gboolean
qn_edit_add_section (QnModel *model, QnId like, GError **error)
{
  g_autofree char *name = qn_edit_dup_new_name (
    model, offsetof (QnModel, sections), _ ("section"), " ", model->section_count + 1);
  QnSection *section = qn_model_add_section (model, name);
  if (section == NULL)
    return qn_edit_no_memory (error);
  if (like != QN_NONE) {
    char *own = section->name;
    *section = model->sections[like];
    section->name = own;
    section->note = 0;
    return TRUE;
  }
  section->young = FIRST_YOUNG;
  section->poisson = FIRST_POISSON;
  section->width = section->height = FIRST_SIZE;
  section->unit_weight = FIRST_UNIT_WEIGHT;
  return TRUE;
}

void
qn_edit_remove_unused_sections (QnModel *model)
{
  g_autofree QnId *follow = g_new (QnId, model->section_count + 1);
  for (gsize i = 0; i < model->section_count; i++)
    follow[i] = QN_NONE;
  for (gsize i = 0; i < model->beam_count; i++)
    follow[model->beams[i].section] = 0;
  gsize kept = 0;
  for (gsize i = 0; i < model->section_count; i++) {
    if (follow[i] == QN_NONE) {
      free (model->sections[i].name);
      continue;
    }
    follow[i] = (QnId) kept;
    model->sections[kept++] = model->sections[i];
  }
  model->section_count = kept;
  for (gsize i = 0; i < model->beam_count; i++)
    model->beams[i].section = follow[model->beams[i].section];
}

/* ---- where nodes are ---- */

QnId
qn_model_block_under (const QnModel *model, QnVec2 at)
{
  const double reach = place_reach (at);
  for (QnId i = (QnId) model->block_count - 1; i >= 0; i--) {
    const QnVec2 *v = qn_model_block_vertices (model, i);
    if (qn_polygon_depth (v, (gsize) model->blocks[i].vertex_count, at) >= -reach)
      return i;
  }
  return QN_NONE;
}

static char *
dup_end_text (const QnModel *model, QnVec2 at, const char *nothing)
{
  QnId block = qn_model_block_under (model, at);
  return block != QN_NONE ? g_strdup_printf (_ ("on block %s"), model->blocks[block].name)
                          : g_strdup (nothing);
}

char *
qn_beam_end_dup_text (const QnModel *model, QnVec2 at)
{
  QnId node = qn_model_node_near (model, at, place_reach (at));
  return node != QN_NONE ? g_strdup_printf (_ ("at node %s"), model->nodes[node].name)
                         : dup_end_text (model, at, _ ("free"));
}

char *
qn_tie_end_dup_text (const QnModel *model, QnVec2 at)
{
  return dup_end_text (model, at, _ ("in the ground"));
}

QnId
qn_model_node_near (const QnModel *model, QnVec2 at, double reach)
{
  QnId best = QN_NONE;
  double nearest = reach;
  for (QnId i = 0; i < (QnId) model->node_count; i++) {
    double distance = qn_vec2_length (qn_vec2_sub (model->nodes[i].at, at));
    if (model->nodes[i].beam == QN_NONE && distance <= nearest) {
      nearest = distance;
      best = i;
    }
  }
  return best;
}

guint
qn_model_node_beams (const QnModel *model, QnId node)
{
  guint count = 0;
  for (gsize i = 0; i < model->beam_count; i++)
    count += model->beams[i].nodes[0] == node || model->beams[i].nodes[1] == node;
  return count;
}

/* ---- moving ---- */

static void
replace_id (QnId *id, QnId gone, QnId by)
{
  if (*id == gone)
    *id = by;
}

static void
seat_on (QnNode *node, QnSeat seat, QnId block)
{
  node->seat = seat;
  node->block = seat == QN_SEAT_FREE ? QN_NONE : block;
  for (int dof = 0; dof < QN_DOF_COUNT && seat != QN_SEAT_FREE; dof++)
    node->support[dof] = false;
}

gboolean
qn_edit_place_node (QnModel *model, QnId id, QnVec2 at, GError **error)
{
  QnNode *node = &model->nodes[id];
  QnVec2 from = node->at;
  node->at = qn_vec2 (INFINITY, INFINITY); /* not found as its own neighbour */
  QnId other = qn_model_node_near (model, at, place_reach (at));
  if (other != QN_NONE) {
    node->at = from;
    /* Everything that named the one names the other; rebuilding leaves out a node without beams. */
    for (gsize i = 0; i < model->beam_count; i++) {
      replace_id (&model->beams[i].nodes[0], id, other);
      replace_id (&model->beams[i].nodes[1], id, other);
    }
    for (gsize i = 0; i < qn_model_load_count (model); i++)
      if (qn_model_load (model, i)->kind == QN_LOAD_NODE)
        replace_id (&qn_model_load (model, i)->node, id, other);
    replace_id (&model->analysis.control.node, id, other);
    for (gsize i = 0; i < model->stage_count; i++)
      replace_id (&model->stages[i].control.node, id, other);
    model->nodes[id].seat = QN_SEAT_FREE;
    model->nodes[id].block = QN_NONE;
    return TRUE;
  }
  node->at = at;
  QnId block = qn_model_block_under (model, at);
  seat_on (node, block != QN_NONE ? QN_SEAT_POINT : QN_SEAT_FREE, block);
  return TRUE;
}

/* ---- how nodes are held ---- */

gboolean
qn_edit_set_node_seat (QnModel *model, QnId id, QnSeat seat, QnId block, QnBlockSide side,
                       GError **error)
{
  if (seat != QN_SEAT_FREE && block == QN_NONE)
    return qn_edit_refuse (
      error, _ ("There is no block here: move the end of the beam onto one"));
  seat_on (&model->nodes[id], seat, block);
  model->nodes[id].side = side;
  return TRUE;
}

gboolean
qn_edit_set_node_support (QnModel *model, QnId id, const bool support[QN_DOF_COUNT],
                          GError **error)
{
  QnNode *node = &model->nodes[id];
  if (node->block != QN_NONE)
    return qn_edit_refuse (error,
                           _ ("A node on a block is held by its block: fix the block"));
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    node->support[dof] = support[dof];
  return TRUE;
}

gboolean
qn_edit_part_beam (QnModel *model, QnId beam, int end, GError **error)
{
  QnId shared = model->beams[beam].nodes[end];
  if (qn_model_node_beams (model, shared) < 2)
    return qn_edit_refuse (error, _ ("No other beam ends here"));
  g_autofree char *name = qn_edit_dup_new_name (model, offsetof (QnModel, nodes),
                                                model->nodes[shared].name, "-", 2);
  QnNode *node = qn_model_add_node (model, name);
  if (node == NULL)
    return qn_edit_no_memory (error);
  char *own = node->name;
  *node = model->nodes[shared];
  node->name = own;
  node->note = 0;
  model->beams[beam].nodes[end] = (QnId) model->node_count - 1;
  return TRUE;
}

gboolean
qn_edit_add_node_force (QnModel *model, QnId node, gboolean live, QnVec2 force,
                        GError **error)
{
  QnLoad *load = qn_edit_new_load (model, live, error);
  if (load == NULL)
    return FALSE;
  load->kind = QN_LOAD_NODE;
  load->node = node;
  load->vector = force;
  return TRUE;
}
