/* The rules that nodes, sections and beams must keep. */
#include "core/base/memory.h"
#include "core/base/tolerance.h"
#include "core/model/beam-model.h"

#include <stdlib.h>

static QnStatus
fail (QnDiag *diag, QnProblem problem, QnEntity entity, QnId index, const char *field,
      double value)
{
  return qn_diag_set_field (diag, problem, entity, index, field, value);
}

static QnStatus
check_positive (double value, QnEntity entity, QnId index, const char *field,
                QnDiag *diag)
{
  if (!isfinite (value))
    return fail (diag, QN_PROBLEM_NOT_FINITE, entity, index, field, value);
  if (value <= 0)
    return fail (diag, QN_PROBLEM_NOT_POSITIVE, entity, index, field, value);
  return QN_OK;
}

static QnStatus
check_not_negative (double value, QnEntity entity, QnId index, const char *field,
                    QnDiag *diag)
{
  if (!isfinite (value))
    return fail (diag, QN_PROBLEM_NOT_FINITE, entity, index, field, value);
  if (value < 0)
    return fail (diag, QN_PROBLEM_NEGATIVE, entity, index, field, value);
  return QN_OK;
}

static QnStatus
check_name (const char *name, QnId namesake, QnEntity entity, QnId index, QnDiag *diag)
{
  if (name == NULL || name[0] == '\0')
    return fail (diag, QN_PROBLEM_NAME_MISSING, entity, index, "name", 0);
  if (namesake != index)
    return fail (diag, QN_PROBLEM_NAME_TAKEN, entity, index, "name", 0);
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
      return fail (diag, QN_PROBLEM_NAME_TAKEN, QN_ENTITY_BEAM, node->beam, "name", 0);
    return QN_OK;
  }
  QnStatus status =
    check_name (node->name, qn_model_find_node (model, node->name), entity, index, diag);
  if (status != QN_OK)
    return status;
  if (rides && (node->block < 0 || (size_t) node->block >= model->block_count))
    return fail (diag, QN_PROBLEM_BLOCK_UNKNOWN, entity, index, "block", node->block);
  if (rides && (node->support[0] || node->support[1] || node->support[2]))
    return fail (diag, QN_PROBLEM_NODE_SUPPORTED_BY_BLOCK, entity, index, "support", 0);
  if (node->seat == QN_SEAT_FREE || node->seat == QN_SEAT_POINT) {
    if (!isfinite (node->at.x) || !isfinite (node->at.y))
      return fail (diag, QN_PROBLEM_NOT_FINITE, entity, index, "at", 0);
    if (fmax (fabs (node->at.x), fabs (node->at.y)) > QN_MAX_COORDINATE)
      return fail (diag, QN_PROBLEM_TOO_LARGE, entity, index, "at", 0);
  }
  return QN_OK;
}

static QnStatus
check_shape (const QnSection *section, QnId index, QnDiag *diag)
{
  const QnEntity entity = QN_ENTITY_SECTION;
  QnStatus status = QN_OK;

  if (section->height != 0 || section->width != 0) {
    status = check_positive (section->width, entity, index, "width", diag);
    return status == QN_OK
             ? check_positive (section->height, entity, index, "height", diag)
             : status;
  }
  if (section->yield != 0)
    return fail (diag, QN_PROBLEM_YIELD_SHAPELESS, entity, index, "yield",
                 section->yield);
  status = check_positive (section->area, entity, index, "area", diag);
  return status == QN_OK
           ? check_positive (section->inertia, entity, index, "inertia", diag)
           : status;
}

static QnStatus
check_section (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSection *section = &model->sections[index];
  const QnEntity entity = QN_ENTITY_SECTION;
  QnStatus status = check_name (
    section->name, qn_model_find_section (model, section->name), entity, index, diag);

  if (status == QN_OK)
    status = check_positive (section->young, entity, index, "young", diag);
  if (status == QN_OK)
    status =
      check_not_negative (section->shear_modulus, entity, index, "shear_modulus", diag);
  if (status == QN_OK && !(section->poisson > -1 && section->poisson <= 0.5))
    status =
      fail (diag, QN_PROBLEM_POISSON_RATIO, entity, index, "poisson", section->poisson);
  if (status == QN_OK)
    status = check_positive (section->shear_factor, entity, index, "shear_factor", diag);
  if (status == QN_OK)
    status = check_not_negative (section->yield, entity, index, "yield", diag);
  if (status == QN_OK)
    status =
      check_not_negative (section->plastic_moment, entity, index, "plastic_moment", diag);
  if (status == QN_OK)
    status = check_shape (section, index, diag);
  /* A negative density means that the unit weight counts. */
  if (status == QN_OK && !isfinite (section->density))
    status =
      fail (diag, QN_PROBLEM_NOT_FINITE, entity, index, "density", section->density);
  if (status == QN_OK)
    status =
      check_not_negative (section->unit_weight, entity, index, "unit_weight", diag);
  return status;
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
      status =
        fail (diag, QN_PROBLEM_NODE_UNKNOWN, entity, index, "nodes", beam->nodes[end]);
  if (status == QN_OK
      && (beam->section < 0 || (size_t) beam->section >= model->section_count))
    status =
      fail (diag, QN_PROBLEM_SECTION_UNKNOWN, entity, index, "section", beam->section);
  if (status != QN_OK)
    return status;
  const QnNode *first = &model->nodes[beam->nodes[0]],
               *second = &model->nodes[beam->nodes[1]];
  if (first == second)
    return fail (diag, QN_PROBLEM_BEAM_SHORT, entity, index, "nodes", 0);
  if (first->block != QN_NONE && first->block == second->block)
    return fail (diag, QN_PROBLEM_BEAM_ON_ONE_BLOCK, entity, index, "nodes",
                 first->block);
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
      status = fail (diag, QN_PROBLEM_NODE_UNUSED, QN_ENTITY_NODE, (QnId) i, NULL, 0);
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
  return status == QN_OK ? check_use (model, diag) : status;
}
