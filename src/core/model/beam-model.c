/* Nodes, sections and beams of a model: cutting beams into elements, and what is derived of them. */
#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/model/model-check.h"
#include "core/model/outline.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- Expanding --------------------------------------------------------------------------- */

static bool
add_inner_node (QnModel *model, QnId beam, int32_t number)
{
  const char *prefix = model->beams[beam].name != NULL ? model->beams[beam].name : "";
  size_t room = strlen (prefix) + sizeof ".2147483647";
  char *name = qn_alloc (room, 1);
  if (name == NULL)
    return false;
  snprintf (name, room, "%s.%d", prefix, number);
  QnNode *node = qn_model_add_node (model, name);
  free (name);
  if (node != NULL)
    node->beam = beam;
  return node != NULL;
}

static QnStatus
expand_beam (QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_BEAM, index, diag };
  int32_t count = model->beams[index].element_count;
  QnId first_node = (QnId) model->node_count;

  if (!qn_require (of, count >= 1, QN_PROBLEM_NOT_POSITIVE, "elements", count)
      || !qn_require (of, count <= QN_MAX_BEAM_ELEMENTS, QN_PROBLEM_TOO_LARGE, "elements",
                      count)
      || !qn_require (of, model->node_count + (size_t) count <= QN_MAX_NODES,
                      QN_PROBLEM_TOO_MANY_NODES, "elements", count))
    return QN_ERROR_INVALID;
  for (int32_t i = 1; i < count; i++)
    if (!add_inner_node (model, index, i))
      return qn_diag_no_memory (diag);

  if (!qn_array_reserve (&model->elements, &model->element_capacity,
                         model->element_count + (size_t) count, sizeof *model->elements))
    return qn_diag_no_memory (diag);
  QnBeam *beam = &model->beams[index];
  beam->first_element = (QnId) model->element_count;
  for (int32_t i = 0; i < count; i++) {
    const bool first = i == 0, last = i == count - 1;
    model->elements[model->element_count++] = (QnBeamElement){
      .beam = index,
      .nodes = { first ? beam->nodes[0] : first_node + i - 1,
                 last ? beam->nodes[1] : first_node + i },
      .hinge = { first && beam->hinge[0], last && beam->hinge[1] },
      .yields = { first, true },
    };
  }
  return QN_OK;
}

QnStatus
qn_model_expand_beams (QnModel *model, QnDiag *diag)
{
  for (; model->expanded_beam_count < model->beam_count; model->expanded_beam_count++) {
    QnStatus status = expand_beam (model, (QnId) model->expanded_beam_count, diag);
    if (status != QN_OK)
      return status;
  }
  return QN_OK;
}

/* --- Deriving ---------------------------------------------------------------------------- */

/* The middle of the straight part of a block's outline that faces a side most. */
static QnVec2
side_middle (const QnModel *model, QnId block, QnBlockSide side)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  QnId count = model->blocks[block].vertex_count;
  QnId best = qn_block_facing_edge (model, block, side);
  const QnVec2 start = v[best], edge = qn_vec2_sub (v[(best + 1) % count], start);
  const double best_length = qn_vec2_length (edge);
  const QnVec2 along = qn_vec2_scale (1 / best_length, edge);
  double low = 0, high = best_length;
  for (QnId i = 0; i < count; i++) { /* vertices in the middle of the side split it */
    QnVec2 from = qn_vec2_sub (v[i], start), to = qn_vec2_sub (v[(i + 1) % count], start);
    double flat = QN_TOLERANCE_CONVEX * best_length;
    if (fabs (qn_vec2_cross (along, from)) <= flat
        && fabs (qn_vec2_cross (along, to)) <= flat) {
      low = fmin (low, qn_vec2_dot (along, from));
      high = fmax (high, qn_vec2_dot (along, to));
    }
  }
  return qn_vec2_add_scaled (start, 0.5 * (low + high), along);
}

static QnStatus
derive_beam (QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_BEAM, index, diag };
  const QnBeam *beam = &model->beams[index];
  QnVec2 a = model->nodes[beam->nodes[0]].at, b = model->nodes[beam->nodes[1]].at;
  double size = fmax (fmax (fabs (a.x), fabs (a.y)), fmax (fabs (b.x), fabs (b.y)));

  const QnSection *section = &model->sections[beam->section];
  double whole = qn_vec2_length (qn_vec2_sub (b, a)),
         length = whole / beam->element_count;
  if (!qn_require (of, whole > QN_TOLERANCE_COORDINATE * size, QN_PROBLEM_BEAM_SHORT,
                   "nodes", 0)
      || !qn_require_number (of, "section", section->young * section->area / length,
                             QN_RANGE_POSITIVE)
      || !qn_require_number (of, "section",
                             section->young * section->inertia / pow (length, 3),
                             QN_RANGE_POSITIVE))
    return QN_ERROR_INVALID;
  for (int32_t i = 0; i < beam->element_count; i++) {
    const QnBeamElement *element = &model->elements[beam->first_element + i];
    QnNode *end = &model->nodes[element->nodes[1]];
    if (i + 1 < beam->element_count)
      end->at = qn_vec2_lerp (a, b, (double) (i + 1) / beam->element_count);
  }
  return QN_OK;
}

static bool
check_moments (const QnModel *model, QnDiag *diag)
{
  bool holds = true;

  for (size_t i = 0; i < qn_model_load_count (model) && holds; i++) {
    const QnLoad *load = qn_model_load (model, i);
    holds = qn_require (qn_load_subject (model, i, diag),
                        load->kind != QN_LOAD_NODE || load->moment == 0
                          || model->nodes[load->node].turns,
                        QN_PROBLEM_NODE_MOMENT, "moment", load->moment);
  }
  return holds;
}

void
qn_model_mark_turning_nodes (QnModel *model)
{
  for (size_t i = 0; i < model->node_count; i++)
    model->nodes[i].turns = model->nodes[i].block != QN_NONE;
  for (size_t i = 0; i < model->element_count; i++)
    for (int end = 0; end < 2; end++)
      if (!model->elements[i].hinge[end])
        model->nodes[model->elements[i].nodes[end]].turns = true;
}

QnStatus
qn_model_derive_beams (QnModel *model, QnDiag *diag)
{
  QnStatus status = QN_OK;

  for (size_t i = 0; i < model->section_count; i++) {
    QnSection *section = &model->sections[i];
    if (section->height > 0) {
      section->area = section->width * section->height;
      section->inertia = section->area * section->height * section->height / 12;
    }
    if (section->density >= 0)
      section->unit_weight = section->density * model->gravity;
  }
  for (size_t i = 0; i < model->node_count; i++) {
    QnNode *node = &model->nodes[i];
    if (node->seat == QN_SEAT_CENTROID)
      node->at = model->blocks[node->block].centroid;
    else if (node->seat == QN_SEAT_SIDE)
      node->at = side_middle (model, node->block, node->side);
  }
  for (size_t i = 0; i < model->beam_count && status == QN_OK; i++)
    status = derive_beam (model, (QnId) i, diag);
  return status == QN_OK ? qn_required (check_moments (model, diag)) : status;
}

bool
qn_model_body_is_fixed (const QnModel *model, size_t body, QnDof dof)
{
  if (body < model->block_count)
    return model->blocks[body].support[dof];
  const QnNode *node = &model->nodes[body - model->block_count];
  return node->block != QN_NONE || node->support[dof]
         || (dof == QN_DOF_RZ && !node->turns);
}

void
qn_model_move_riding_nodes (const QnModel *model, bool finite, double *displacements)
{
  for (size_t i = 0; i < model->node_count; i++) {
    const QnNode *node = &model->nodes[i];
    if (node->block == QN_NONE)
      continue;
    const double *block = displacements + QN_DOF_COUNT * node->block;
    double *out = displacements + QN_DOF_COUNT * (model->block_count + i);
    QnVec2 arm = qn_vec2_sub (node->at, model->blocks[node->block].centroid);
    qn_body_velocity_at (block, arm, out);
    if (finite) {
      QnVec2 turned =
        qn_vec2_rotate (arm, cos (block[QN_DOF_RZ]), sin (block[QN_DOF_RZ]));
      out[QN_DOF_UX] = block[QN_DOF_UX] + turned.x - arm.x;
      out[QN_DOF_UY] = block[QN_DOF_UY] + turned.y - arm.y;
    }
  }
}
