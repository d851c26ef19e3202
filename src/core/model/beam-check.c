/* The rules that nodes, sections, beams and ties must keep. */
#include "core/base/memory.h"
#include "core/model/beam-model.h"
#include "core/model/model-check.h"
#include "core/model/support.h"

#include <stdlib.h>

static QnStatus
check_name (const char *name, QnId namesake, QnEntity entity, QnId index, QnDiag *diag)
{
  if (name == NULL || name[0] == '\0')
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_MISSING, entity, index, "name", 0);
  if (namesake != index)
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_TAKEN, entity, index, "name", 0);
  return QN_OK;
}

static QnStatus
check_node (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnNode *node = &model->nodes[index];
  const QnEntity entity = QN_ENTITY_NODE;
  const bool rides = node->seat != QN_SEAT_FREE;

  if (node->beam != QN_NONE) { /* a name that the program gave */
    if (qn_model_find_node (model, node->name) != index)
      return qn_diag_set_field (diag, QN_PROBLEM_NAME_TAKEN, QN_ENTITY_BEAM, node->beam,
                                "name", 0);
    return QN_OK;
  }
  QnStatus status =
    check_name (node->name, qn_model_find_node (model, node->name), entity, index, diag);
  if (status != QN_OK)
    return status;
  if (rides && (node->block < 0 || (size_t) node->block >= model->block_count))
    return qn_diag_set_field (diag, QN_PROBLEM_BLOCK_UNKNOWN, entity, index, "block",
                              node->block);
  if (rides && qn_support_is_any (node->support))
    return qn_diag_set_field (diag, QN_PROBLEM_NODE_SUPPORTED_BY_BLOCK, entity, index,
                              "support", 0);
  if (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT) {
    QnProblem problem =
      qn_number_problem (qn_worse (fabs (node->at.x), fabs (node->at.y)), QN_RANGE_FINITE,
                         QN_MAX_COORDINATE);
    if (problem != QN_PROBLEM_NONE)
      return qn_diag_set_field (diag, problem, entity, index, "at", 0);
  }
  return QN_OK;
}

static QnStatus
check_section (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSection *section = &model->sections[index];
  const QnEntity entity = QN_ENTITY_SECTION;
  const QnNumberRule elastic[] = {
    { "young", section->young, QN_RANGE_POSITIVE },
    { "shear_modulus", section->shear_modulus, QN_RANGE_NOT_NEGATIVE },
  };
  const QnNumberRule strength[] = {
    { "shear_factor", section->shear_factor, QN_RANGE_POSITIVE },
    { "yield", section->yield, QN_RANGE_NOT_NEGATIVE },
    { "plastic_moment", section->plastic_moment, QN_RANGE_NOT_NEGATIVE },
  };
  const QnNumberRule rectangle[] = { { "width", section->width, QN_RANGE_POSITIVE },
                                     { "height", section->height, QN_RANGE_POSITIVE } };
  const QnNumberRule shapeless[] = {
    { "area", section->area, QN_RANGE_POSITIVE },
    { "inertia", section->inertia, QN_RANGE_POSITIVE },
  };
  bool has_shape = section->height != 0 || section->width != 0;
  QnStatus status = check_name (
    section->name, qn_model_find_section (model, section->name), entity, index, diag);

  if (status == QN_OK)
    status = qn_check_numbers (elastic, QN_N_ELEMENTS (elastic), entity, index, diag);
  if (status == QN_OK && !(section->poisson > -1 && section->poisson <= 0.5))
    status = qn_diag_set_field (diag, QN_PROBLEM_POISSON_RATIO, entity, index, "poisson",
                                section->poisson);
  if (status == QN_OK)
    status = qn_check_numbers (strength, QN_N_ELEMENTS (strength), entity, index, diag);
  if (status == QN_OK && !has_shape && section->yield != 0)
    status = qn_diag_set_field (diag, QN_PROBLEM_YIELD_SHAPELESS, entity, index, "yield",
                                section->yield);
  if (status == QN_OK)
    status = qn_check_numbers (has_shape ? rectangle : shapeless, 2, entity, index, diag);
  /* A negative density means that the unit weight counts. */
  if (status == QN_OK)
    status =
      qn_check_number (section->density, QN_RANGE_FINITE, entity, index, "density", diag);
  return status == QN_OK ? qn_check_number (section->unit_weight, QN_RANGE_NOT_NEGATIVE,
                                            entity, index, "unit_weight", diag)
                         : status;
}

static QnStatus
check_beam (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnBeam *beam = &model->beams[index];
  const QnEntity entity = QN_ENTITY_BEAM;
  QnStatus status =
    check_name (beam->name, qn_model_find_beam (model, beam->name), entity, index, diag);

  for (int end = 0; end < 2 && status == QN_OK; end++)
    if (beam->nodes[end] < 0 || (size_t) beam->nodes[end] >= model->node_count)
      status = qn_diag_set_field (diag, QN_PROBLEM_NODE_UNKNOWN, entity, index, "nodes",
                                  beam->nodes[end]);
  if (status == QN_OK
      && (beam->section < 0 || (size_t) beam->section >= model->section_count))
    status = qn_diag_set_field (diag, QN_PROBLEM_SECTION_UNKNOWN, entity, index,
                                "section", beam->section);
  if (status != QN_OK)
    return status;
  const QnNode *first = &model->nodes[beam->nodes[0]],
               *second = &model->nodes[beam->nodes[1]];
  if (first == second)
    return qn_diag_set_field (diag, QN_PROBLEM_BEAM_SHORT, entity, index, "nodes", 0);
  if (first->block != QN_NONE && first->block == second->block)
    return qn_diag_set_field (diag, QN_PROBLEM_BEAM_ON_ONE_BLOCK, entity, index, "nodes",
                              first->block);
  return QN_OK;
}

static QnStatus
check_tie (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnTie *tie = &model->ties[index];
  const QnEntity entity = QN_ENTITY_TIE;
  const QnTieEnd *ends = tie->ends;
  const QnNumberRule rules[] = {
    { "area", tie->area, QN_RANGE_POSITIVE },
    { "elasticity", tie->elasticity, QN_RANGE_POSITIVE },
    { "yield", tie->yield, QN_RANGE_NOT_NEGATIVE },
    { "prestress", tie->prestress, QN_RANGE_NOT_NEGATIVE },
    { "slack", tie->slack, QN_RANGE_NOT_NEGATIVE },
    { "anchor", tie->anchor, QN_RANGE_NOT_NEGATIVE },
    { "plate.diameter", tie->plate.diameter, QN_RANGE_NOT_NEGATIVE },
    { "plate.wall", tie->plate.wall, QN_RANGE_NOT_NEGATIVE },
    { "plate.shear", tie->plate.shear, QN_RANGE_NOT_NEGATIVE },
    { "plate.compression", tie->plate.compression, QN_RANGE_NOT_NEGATIVE },
  };
  QnStatus status =
    check_name (tie->name, qn_model_find_tie (model, tie->name), entity, index, diag);

  if (status == QN_OK)
    status = qn_check_numbers (rules, QN_N_ELEMENTS (rules), entity, index, diag);
  for (int end = 0; end < 2 && status == QN_OK; end++) {
    if (ends[end].block != QN_NONE)
      status =
        qn_check_block_reference (model, ends[end].block, entity, index, "ends", diag);
    if (status == QN_OK)
      status = qn_check_vector (ends[end].at, entity, index, "ends", diag);
  }
  if (status != QN_OK)
    return status;
  if (ends[0].block == ends[1].block)
    return qn_diag_set_field (diag,
                              ends[0].block == QN_NONE ? QN_PROBLEM_TIE_ON_GROUND
                                                       : QN_PROBLEM_TIE_ON_ONE_BLOCK,
                              entity, index, "ends", ends[0].block);
  if (!(qn_tie_length (tie) > 0))
    return qn_diag_set_field (diag, QN_PROBLEM_TIE_SHORT, entity, index, "ends", 0);
  if (!isfinite (qn_tie_stiffness (tie)))
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, entity, index, "elasticity",
                              tie->elasticity);
  if (tie->prestress > qn_tie_strength (tie))
    return qn_diag_set_field (diag, QN_PROBLEM_TIE_PRESTRESS, entity, index, "prestress",
                              tie->prestress);
  if (tie->prestress > 0 && tie->slack > 0)
    return qn_diag_set_field (diag, QN_PROBLEM_TIE_SLACK, entity, index, "slack",
                              tie->slack);
  return QN_OK;
}

/* A node that stands free must carry a beam: nothing else holds it. */
static QnStatus
check_use (const QnModel *model, QnDiag *diag)
{
  bool *used = qn_alloc (model->node_count, sizeof *used);
  QnStatus status = QN_OK;

  if (used == NULL)
    return qn_diag_no_memory (diag);
  for (size_t i = 0; i < model->beam_count; i++)
    used[model->beams[i].nodes[0]] = used[model->beams[i].nodes[1]] = true;
  for (size_t i = 0; i < model->node_count && status == QN_OK; i++) {
    const QnNode *node = &model->nodes[i];
    if (!used[i] && node->beam == QN_NONE && node->seat == QN_SEAT_FREE)
      status = qn_diag_set_field (diag, QN_PROBLEM_NODE_UNUSED, QN_ENTITY_NODE, (QnId) i,
                                  NULL, 0);
  }
  free (used);
  return status;
}

QnStatus
qn_model_check_beams (const QnModel *model, QnDiag *diag)
{
  QnStatus status = QN_OK;

  for (size_t i = 0; i < model->section_count && status == QN_OK; i++)
    status = check_section (model, (QnId) i, diag);
  for (size_t i = 0; i < model->node_count && status == QN_OK; i++)
    status = check_node (model, (QnId) i, diag);
  for (size_t i = 0; i < model->beam_count && status == QN_OK; i++)
    status = check_beam (model, (QnId) i, diag);
  for (size_t i = 0; i < model->tie_count && status == QN_OK; i++)
    status = check_tie (model, (QnId) i, diag);
  return status == QN_OK ? check_use (model, diag) : status;
}
