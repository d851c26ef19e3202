#include "core/model/model-check.h"

#include "core/base/polygon.h"
#include "core/base/tolerance.h"

QnStatus
qn_check_number (double value, QnRange range, QnEntity entity, QnId index,
                 const char *field, QnDiag *diag)
{
  QnProblem problem = qn_number_problem (value, range, QN_LARGEST_NUMBER);
  return problem == QN_PROBLEM_NONE
           ? QN_OK
           : qn_diag_set_field (diag, problem, entity, index, field, value);
}

QnStatus
qn_check_numbers (const QnNumberRule *rules, size_t count, QnEntity entity, QnId index,
                  QnDiag *diag)
{
  QnStatus status = QN_OK;

  for (size_t i = 0; i < count && status == QN_OK; i++)
    status = qn_check_number (rules[i].value, rules[i].range, entity, index,
                              rules[i].field, diag);
  return status;
}

QnStatus
qn_check_vector (QnVec2 vector, QnEntity entity, QnId index, const char *field,
                 QnDiag *diag)
{
  const QnNumberRule rules[] = { { field, vector.x, QN_RANGE_FINITE },
                                 { field, vector.y, QN_RANGE_FINITE } };
  return qn_check_numbers (rules, 2, entity, index, diag);
}

/* A law by index; QN_NONE is left to the caller. */
static QnStatus
check_law_reference (const QnModel *model, QnId law, QnEntity entity, QnId index,
                     QnDiag *diag)
{
  if (law == QN_NONE || (law >= 0 && (size_t) law < model->law_count))
    return QN_OK;
  return qn_diag_set_field (diag, QN_PROBLEM_LAW_UNKNOWN, entity, index, "law", law);
}

QnStatus
qn_check_block_reference (const QnModel *model, QnId block, QnEntity entity, QnId index,
                          const char *field, QnDiag *diag)
{
  if (block >= 0 && (size_t) block < model->block_count)
    return QN_OK;
  return qn_diag_set_field (diag, QN_PROBLEM_BLOCK_UNKNOWN, entity, index, field, block);
}

static QnStatus
check_polygon (const QnModel *model, QnId index, QnEntity entity, QnId owner,
               QnDiag *diag)
{
  const QnBlock *block = &model->blocks[index];
  const QnVec2 *vertices = qn_model_block_vertices (model, index);
  QnPolygonFlaw flaw = qn_polygon_check (vertices, (size_t) block->vertex_count);
  if (flaw.problem == QN_PROBLEM_NONE)
    return QN_OK;
  if (flaw.problem == QN_PROBLEM_NO_MEMORY)
    return qn_diag_no_memory (diag);

  bool drawn = entity == QN_ENTITY_BLOCK;
  qn_diag_set_field (diag, flaw.problem, entity, owner, drawn ? "vertices" : "courses",
                     0);
  if (diag != NULL && drawn) {
    diag->sub = flaw.vertex;
    if (flaw.vertex != QN_NONE)
      diag->at = vertices[flaw.vertex];
    else if (block->vertex_count > 0)
      diag->at = vertices[0];
  }
  return QN_ERROR_INVALID;
}

QnStatus
qn_model_check_block (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnBlock *block = &model->blocks[index];
  QnEntity entity = block->wall == QN_NONE ? QN_ENTITY_BLOCK : QN_ENTITY_WALL;
  QnId owner = block->wall == QN_NONE ? index : block->wall;

  if (block->name == NULL || block->name[0] == '\0')
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_MISSING, entity, owner, "name", 0);
  QnId namesake = qn_model_find_block (model, block->name);
  if (namesake != index && namesake != QN_NONE)
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_TAKEN, entity, owner, "name", 0);

  QnStatus status = check_polygon (model, index, entity, owner, diag);
  if (status == QN_OK)
    status = qn_check_number (block->thickness, QN_RANGE_POSITIVE, entity, owner,
                              "thickness", diag);
  /* A negative density means that the unit weight counts. */
  if (status == QN_OK)
    status =
      qn_check_number (block->density, QN_RANGE_FINITE, entity, owner, "density", diag);
  if (status == QN_OK && block->density < 0)
    status = qn_check_number (block->unit_weight, QN_RANGE_NOT_NEGATIVE, entity, owner,
                              "unit_weight", diag);
  if (status == QN_OK)
    status = check_law_reference (model, block->law, entity, owner, diag);
  return status;
}

static QnStatus
check_laws (const QnModel *model, QnDiag *diag)
{
  for (size_t i = 0; i < model->law_count; i++) {
    QnStatus status = qn_law_check (&model->laws[i], (QnId) i, diag);
    if (status != QN_OK)
      return status;
    if (qn_model_find_law (model, model->laws[i].name) != (QnId) i)
      return qn_diag_set_field (diag, QN_PROBLEM_NAME_TAKEN, QN_ENTITY_LAW, (QnId) i,
                                "name", 0);
  }
  return QN_OK;
}

static QnStatus
check_explicit_pairs (const QnPairRule *rule, QnEntity entity, QnId index, QnDiag *diag)
{
  double sum = 0;
  if (rule->count > QN_MAX_EXPLICIT_PAIRS)
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, entity, index,
                              "pairs.positions", rule->count);
  for (int32_t i = 0; i < rule->count; i++) {
    double position = rule->positions[i], before = i > 0 ? rule->positions[i - 1] : -1;
    if (!(position >= 0 && position <= 1 && position > before))
      return qn_diag_set_field (diag, QN_PROBLEM_PAIR_POSITION, entity, index,
                                "pairs.positions", position);
    if (!(rule->weights[i] > 0))
      return qn_diag_set_field (diag, QN_PROBLEM_PAIR_WEIGHTS, entity, index,
                                "pairs.weights", rule->weights[i]);
    sum += rule->weights[i];
  }
  if (fabs (sum - 1) > QN_TOLERANCE_WEIGHTS)
    return qn_diag_set_field (diag, QN_PROBLEM_PAIR_WEIGHTS, entity, index,
                              "pairs.weights", sum);
  return QN_OK;
}

static QnStatus
check_pairs (const QnPairRule *rule, QnEntity entity, QnId index, QnDiag *diag)
{
  if (rule->placement == QN_PLACEMENT_LOBATTO && rule->count != 0
      && (rule->count < QN_LEAST_LOBATTO_PAIRS || rule->count > QN_MOST_LOBATTO_PAIRS))
    return qn_diag_set_field (diag, QN_PROBLEM_LOBATTO_COUNT, entity, index,
                              "pairs.count", rule->count);
  if (rule->placement <= QN_PLACEMENT_LOBATTO)
    return qn_check_number (rule->offset, QN_RANGE_NOT_NEGATIVE, entity, index,
                            "pairs.offset", diag);
  if (rule->count < 1)
    return qn_diag_set_field (diag, QN_PROBLEM_PAIR_COUNT, entity, index, "pairs.count",
                              rule->count);
  if (rule->count > QN_MAX_PAIRS_PER_FACE)
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, entity, index, "pairs.count",
                              rule->count);
  return rule->placement == QN_PLACEMENT_EXPLICIT
           ? check_explicit_pairs (rule, entity, index, diag)
           : QN_OK;
}

static QnStatus
check_bar (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnBar *bar = &model->bars[index];
  const QnEntity entity = QN_ENTITY_BAR;
  QnStatus status =
    bar->law == QN_NONE
      ? qn_diag_set_field (diag, QN_PROBLEM_LAW_UNKNOWN, entity, index, "law", 0)
      : check_law_reference (model, bar->law, entity, index, diag);
  if (status == QN_OK && model->laws[bar->law].basis == QN_BASIS_CONTACT)
    status = qn_diag_set_field (diag, QN_PROBLEM_BAR_BASIS, entity, index, "law", 0);
  if (status == QN_OK)
    status = qn_check_number (bar->area, QN_RANGE_POSITIVE, entity, index, "area", diag);
  if (status == QN_OK)
    status = qn_check_vector (bar->start, entity, index, "start", diag);
  if (status == QN_OK)
    status = qn_check_vector (bar->end, entity, index, "end", diag);
  if (status == QN_OK && bar->start.x == bar->end.x && bar->start.y == bar->end.y)
    status = qn_diag_set_field (diag, QN_PROBLEM_BAR_SHORT, entity, index, "end", 0);
  return status;
}

static QnStatus
check_contact (const QnModel *model, QnDiag *diag)
{
  const QnContactSettings *contact = &model->contact;
  QnStatus status = qn_check_number (contact->tolerance, QN_RANGE_NOT_NEGATIVE,
                                     QN_ENTITY_CONTACT, QN_NONE, "tolerance", diag);
  if (status == QN_OK && contact->tolerance > QN_MAX_CONTACT_TOLERANCE)
    status = qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, QN_ENTITY_CONTACT, QN_NONE,
                                "tolerance", contact->tolerance);
  if (status == QN_OK)
    status = check_pairs (&contact->pairs, QN_ENTITY_CONTACT, QN_NONE, diag);
  if (status == QN_OK)
    status = check_law_reference (model, contact->law, QN_ENTITY_CONTACT, QN_NONE, diag);
  if (status != QN_OK || contact->law != QN_NONE)
    return status;

  for (size_t i = 0; i < model->block_count; i++) {
    if (model->blocks[i].law == QN_NONE)
      return qn_diag_set_field (diag, QN_PROBLEM_LAW_MISSING, QN_ENTITY_CONTACT, QN_NONE,
                                "law", 0);
  }
  return QN_OK;
}

static QnStatus
check_override (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnFaceOverride *override = &model->overrides[index];
  QnEntity entity = QN_ENTITY_FACE_OVERRIDE;
  QnStatus status =
    qn_check_block_reference (model, override->block_a, entity, index, "blocks", diag);
  if (status == QN_OK)
    status =
      qn_check_block_reference (model, override->block_b, entity, index, "blocks", diag);
  if (status == QN_OK && override->block_a == override->block_b)
    status = qn_diag_set_field (diag, QN_PROBLEM_SAME_BLOCK, entity, index, "blocks",
                                override->block_a);
  if (status == QN_OK)
    status = check_law_reference (model, override->law, entity, index, diag);
  if (status == QN_OK && override->has_pairs)
    status = check_pairs (&override->pairs, entity, index, diag);
  return status;
}

QnStatus
qn_model_check_settings (const QnModel *model, QnDiag *diag)
{
  /* Masses are weights over gravity: none or one to divide by. */
  QnStatus status = qn_check_number (
    model->gravity, model->gravity > 0 ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE,
    QN_ENTITY_MODEL, QN_NONE, "gravity", diag);
  if (status == QN_OK)
    status = check_laws (model, diag);
  if (status == QN_OK)
    status = check_contact (model, diag);
  for (size_t i = 0; i < model->override_count && status == QN_OK; i++)
    status = check_override (model, (QnId) i, diag);
  for (size_t i = 0; i < model->bar_count && status == QN_OK; i++)
    status = check_bar (model, (QnId) i, diag);
  if (status == QN_OK)
    status = qn_model_check_loads (model, diag);
  if (status == QN_OK)
    status = qn_model_check_analysis (model, diag);
  return status;
}
