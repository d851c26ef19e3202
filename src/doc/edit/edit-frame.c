#include "doc/edit/edit-frame.h"

#include <glib/gi18n-lib.h>
#include <math.h>

static gboolean
refuse_no_beam (GError **error)
{
  return qn_edit_refuse_nothing (error, _ ("No beam is selected"));
}

/* ---- adding ---- */

QnId
qn_edit_take_node (QnModel *model, QnVec2 at)
{
  QnId there = qn_model_node_near (model, at, qn_place_reach (at));
  if (there != QN_NONE)
    return there;
  g_autofree char *name = qn_edit_dup_new_name (model, qn_model_find_node, "n", "", 1);
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
  QnId first = qn_edit_take_node (model, from);
  QnId second = first != QN_NONE ? qn_edit_take_node (model, to) : QN_NONE;
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
    return qn_edit_rebuild (model, NULL, error);
  return qn_edit_delete_blocks (model, set.blocks, error);
}

/* ---- properties ---- */

gboolean
qn_edit_set_beam_kind (QnModel *model, QnBeamSet set, QnBeamKind kind, GError **error)
{
  for (guint i = 0; i < set.count; i++)
    model->beams[set.ids[i]].kind = kind;
  return set.count > 0 || refuse_no_beam (error);
}

gboolean
qn_edit_set_beam_section (QnModel *model, QnBeamSet set, QnId section, GError **error)
{
  for (guint i = 0; i < set.count; i++)
    model->beams[set.ids[i]].section = section;
  return set.count > 0 || refuse_no_beam (error);
}

gboolean
qn_edit_set_beam_hinge (QnModel *model, QnBeamSet set, int end, gboolean hinge,
                        GError **error)
{
  for (guint i = 0; i < set.count; i++)
    model->beams[set.ids[i]].hinge[end] = hinge;
  return set.count > 0 || refuse_no_beam (error);
}

gboolean
qn_edit_set_beam_elements (QnModel *model, QnBeamSet set, int32_t count, GError **error)
{
  if (set.count == 0)
    return refuse_no_beam (error);
  for (guint i = 0; i < set.count; i++)
    model->beams[set.ids[i]].element_count = count;
  return qn_edit_rebuild (model, NULL, error);
}

gboolean
qn_edit_rename_beam (QnModel *model, QnId id, const char *name, GError **error)
{
  if (qn_model_find_beam (model, name) != QN_NONE)
    return qn_edit_refuse (error, _ ("There is a beam named “%s” already"), name);
  /* Nodes between elements are named by their beam. */
  return qn_edit_take_name (&model->beams[id].name, name, error)
         && qn_edit_rebuild (model, NULL, error);
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
          && !qn_edit_delete_load (model, live, (QnId) i - 1, error))
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
