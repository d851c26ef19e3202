/* The rules that nodes, sections, beams and ties must keep. */
#include "core/base/memory.h"
#include "core/model/model-check.h"

#include <stdlib.h>

static bool
check_node (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnNode *node = &model->nodes[index];
  const bool given = node->beam != QN_NONE; /* the program gave its name */
  const bool rides = node->seat != QN_SEAT_FREE;
  const QnSubject of = { given ? QN_ENTITY_BEAM : QN_ENTITY_NODE,
                         given ? node->beam : index, diag };

  if (!qn_require_name (of, node->name, qn_model_find_node (model, node->name), index))
    return false;
  if (given)
    return true;
  if (rides
      && !(qn_require_block (of, "block", node->block, model)
           && qn_require (of, !qn_support_is_any (node->support),
                          QN_PROBLEM_NODE_SUPPORTED_BY_BLOCK, "support", 0)))
    return false;
  QnProblem problem = qn_number_problem (qn_worse (fabs (node->at.x), fabs (node->at.y)),
                                         QN_RANGE_FINITE, QN_MAX_COORDINATE);
  return (rides && node->seat != QN_SEAT_POINT)
         || qn_require (of, problem == QN_PROBLEM_NONE, problem, "at", 0);
}

static bool
check_section (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_SECTION, index, diag };
  const QnSection *s = &model->sections[index];
  const bool has_shape = s->height != 0 || s->width != 0;

  return qn_require_name (of, s->name, qn_model_find_section (model, s->name), index)
         && qn_require_number (of, "young", s->young, QN_RANGE_POSITIVE)
         && qn_require_number (of, "shear_modulus", s->shear_modulus,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require (of, s->poisson > -1 && s->poisson <= 0.5,
                        QN_PROBLEM_POISSON_RATIO, "poisson", s->poisson)
         && qn_require_number (of, "shear_factor", s->shear_factor, QN_RANGE_POSITIVE)
         && qn_require_number (of, "yield", s->yield, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "plastic_moment", s->plastic_moment,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require (of, has_shape || s->yield == 0, QN_PROBLEM_YIELD_SHAPELESS,
                        "yield", s->yield)
         && qn_require_number (of, has_shape ? "width" : "area",
                               has_shape ? s->width : s->area, QN_RANGE_POSITIVE)
         && qn_require_number (of, has_shape ? "height" : "inertia",
                               has_shape ? s->height : s->inertia, QN_RANGE_POSITIVE)
         /* A negative density means that the unit weight counts. */
         && qn_require_number (of, "density", s->density, QN_RANGE_FINITE)
         && qn_require_number (of, "unit_weight", s->unit_weight, QN_RANGE_NOT_NEGATIVE);
}

static bool
check_beam (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_BEAM, index, diag };
  const QnBeam *beam = &model->beams[index];
  const QnId *ends = beam->nodes;

  if (!qn_require_name (of, beam->name, qn_model_find_beam (model, beam->name), index)
      || !qn_require_index (of, "nodes", ends[0], model->node_count,
                            QN_PROBLEM_NODE_UNKNOWN)
      || !qn_require_index (of, "nodes", ends[1], model->node_count,
                            QN_PROBLEM_NODE_UNKNOWN)
      || !qn_require_index (of, "section", beam->section, model->section_count,
                            QN_PROBLEM_SECTION_UNKNOWN))
    return false;
  const QnId first = model->nodes[ends[0]].block, second = model->nodes[ends[1]].block;
  return qn_require (of, ends[0] != ends[1], QN_PROBLEM_BEAM_SHORT, "nodes", 0)
         && qn_require (of, first == QN_NONE || first != second,
                        QN_PROBLEM_BEAM_ON_ONE_BLOCK, "nodes", first);
}

static bool
check_tie_end (const QnModel *model, const QnTieEnd *end, QnSubject of)
{
  return (end->block == QN_NONE || qn_require_block (of, "ends", end->block, model))
         && qn_require_vector (of, "ends", end->at);
}

static bool
check_tie (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_TIE, index, diag };
  const QnTie *tie = &model->ties[index];
  const QnTiePlate *plate = &tie->plate;
  const QnId first = tie->ends[0].block;

  return qn_require_name (of, tie->name, qn_model_find_tie (model, tie->name), index)
         && qn_require_number (of, "area", tie->area, QN_RANGE_POSITIVE)
         && qn_require_number (of, "elasticity", tie->elasticity, QN_RANGE_POSITIVE)
         && qn_require_number (of, "yield", tie->yield, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "prestress", tie->prestress, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "slack", tie->slack, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "anchor", tie->anchor, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "plate.diameter", plate->diameter,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "plate.wall", plate->wall, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "plate.shear", plate->shear, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "plate.compression", plate->compression,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "strip.width", tie->strip.width, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "strip.fracture_energy", tie->strip.fracture_energy,
                               QN_RANGE_NOT_NEGATIVE)
         && check_tie_end (model, &tie->ends[0], of)
         && check_tie_end (model, &tie->ends[1], of)
         && qn_require (of, first != tie->ends[1].block,
                        first == QN_NONE ? QN_PROBLEM_TIE_ON_GROUND
                                         : QN_PROBLEM_TIE_ON_ONE_BLOCK,
                        "ends", first)
         && qn_require (of, qn_tie_length (tie) > 0, QN_PROBLEM_TIE_SHORT, "ends", 0)
         && qn_require (of, isfinite (qn_tie_stiffness (tie)), QN_PROBLEM_TOO_LARGE,
                        "elasticity", tie->elasticity)
         && qn_require (of, !(tie->prestress > qn_tie_strength (tie)),
                        QN_PROBLEM_TIE_PRESTRESS, "prestress", tie->prestress)
         && qn_require (of, tie->prestress == 0 || tie->slack == 0, QN_PROBLEM_TIE_SLACK,
                        "slack", tie->slack);
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
      status = qn_refuse (diag, QN_PROBLEM_NODE_UNUSED, QN_ENTITY_NODE, (QnId) i);
  }
  free (used);
  return status;
}

QnStatus
qn_model_check_beams (const QnModel *model, QnDiag *diag)
{
  bool holds = true;

  for (size_t i = 0; i < model->section_count && holds; i++)
    holds = check_section (model, (QnId) i, diag);
  for (size_t i = 0; i < model->node_count && holds; i++)
    holds = check_node (model, (QnId) i, diag);
  for (size_t i = 0; i < model->beam_count && holds; i++)
    holds = check_beam (model, (QnId) i, diag);
  for (size_t i = 0; i < model->tie_count && holds; i++)
    holds = check_tie (model, (QnId) i, diag);
  return holds ? check_use (model, diag) : QN_ERROR_INVALID;
}
