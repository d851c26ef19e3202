#include "core/model-check.h"

#include "core/polygon.h"
#include "core/tolerance.h"

/* Range that a number must keep. */
typedef enum { ANY, NOT_NEGATIVE, POSITIVE } Range;

static QnProblem
number_problem (double value, Range range)
{
  if (!isfinite (value))
    return QN_PROBLEM_NOT_FINITE;
  if (range == POSITIVE && value <= 0)
    return QN_PROBLEM_NOT_POSITIVE;
  if (range == NOT_NEGATIVE && value < 0)
    return QN_PROBLEM_NEGATIVE;
  return QN_PROBLEM_NONE;
}

static QnStatus
check_number (double value, Range range, QnEntity entity, QnId index, const char *field,
              QnDiag *diag)
{
  QnProblem problem = number_problem (value, range);
  if (problem == QN_PROBLEM_NONE)
    return QN_OK;
  return qn_diag_set_field (diag, problem, entity, index, field, value);
}

static QnStatus
check_vector (QnVec2 vector, QnEntity entity, QnId index, const char *field, QnDiag *diag)
{
  QnStatus status = check_number (vector.x, ANY, entity, index, field, diag);
  return status == QN_OK ? check_number (vector.y, ANY, entity, index, field, diag)
                         : status;
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

static QnStatus
check_block_reference (const QnModel *model, QnId block, QnEntity entity, QnId index,
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
    status = check_number (block->thickness, POSITIVE, entity, owner, "thickness", diag);
  /* A negative density means that the unit weight counts. */
  if (status == QN_OK && !isfinite (block->density))
    status = check_number (block->density, ANY, entity, owner, "density", diag);
  if (status == QN_OK && block->density < 0)
    status =
      check_number (block->unit_weight, NOT_NEGATIVE, entity, owner, "unit_weight", diag);
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
  if (rule->placement == QN_PLACEMENT_ENDS)
    return check_number (rule->offset, NOT_NEGATIVE, entity, index, "pairs.offset", diag);
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
    status = check_number (bar->area, POSITIVE, entity, index, "area", diag);
  if (status == QN_OK)
    status = check_vector (bar->start, entity, index, "start", diag);
  if (status == QN_OK)
    status = check_vector (bar->end, entity, index, "end", diag);
  if (status == QN_OK && bar->start.x == bar->end.x && bar->start.y == bar->end.y)
    status = qn_diag_set_field (diag, QN_PROBLEM_BAR_SHORT, entity, index, "end", 0);
  return status;
}

static QnStatus
check_contact (const QnModel *model, QnDiag *diag)
{
  const QnContactSettings *contact = &model->contact;
  QnStatus status = check_number (contact->tolerance, NOT_NEGATIVE, QN_ENTITY_CONTACT,
                                  QN_NONE, "tolerance", diag);
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
    check_block_reference (model, override->block_a, entity, index, "blocks", diag);
  if (status == QN_OK)
    status =
      check_block_reference (model, override->block_b, entity, index, "blocks", diag);
  if (status == QN_OK && override->block_a == override->block_b)
    status = qn_diag_set_field (diag, QN_PROBLEM_SAME_BLOCK, entity, index, "blocks",
                                override->block_a);
  if (status == QN_OK)
    status = check_law_reference (model, override->law, entity, index, diag);
  if (status == QN_OK && override->has_pairs)
    status = check_pairs (&override->pairs, entity, index, diag);
  return status;
}

static QnStatus
check_load (const QnModel *model, const QnLoad *load, QnEntity entity, QnId index,
            QnDiag *diag)
{
  if (load->kind == QN_LOAD_WEIGHT)
    return check_vector (load->vector, entity, index, "direction", diag);

  QnStatus status =
    check_block_reference (model, load->block, entity, index, "block", diag);
  if (status == QN_OK)
    status = check_vector (load->vector, entity, index, "value", diag);
  if (status == QN_OK)
    status = check_number (load->moment, ANY, entity, index, "moment", diag);
  if (status == QN_OK && load->has_at)
    status = check_vector (load->at, entity, index, "at", diag);
  return status;
}

static QnStatus
check_loads (const QnModel *model, QnDiag *diag)
{
  QnStatus status = QN_OK;
  for (size_t i = 0; i < model->dead_load_count && status == QN_OK; i++)
    status =
      check_load (model, &model->dead_loads[i], QN_ENTITY_DEAD_LOAD, (QnId) i, diag);
  for (size_t i = 0; i < model->live_load_count && status == QN_OK; i++)
    status =
      check_load (model, &model->live_loads[i], QN_ENTITY_LIVE_LOAD, (QnId) i, diag);
  return status;
}

static QnStatus
check_control (const QnModel *model, QnDiag *diag)
{
  const QnAnalysisSettings *analysis = &model->analysis;
  const QnEntity entity = QN_ENTITY_ANALYSIS;
  if (analysis->control_block == QN_NONE) {
    if (analysis->procedure != QN_PROCEDURE_DISPLACEMENT)
      return QN_OK;
    return qn_diag_set_field (diag, QN_PROBLEM_CONTROL_MISSING, entity, QN_NONE,
                              "control", 0);
  }

  QnStatus status = check_block_reference (model, analysis->control_block, entity,
                                           QN_NONE, "control.block", diag);
  if (status == QN_OK)
    status = check_number (analysis->control_target, ANY, entity, QN_NONE,
                           "control.target", diag);
  if (status == QN_OK && analysis->control_target == 0)
    status = qn_diag_set_field (diag, QN_PROBLEM_CONTROL_TARGET_ZERO, entity, QN_NONE,
                                "control.target", 0);
  if (status == QN_OK
      && model->blocks[analysis->control_block].support[analysis->control_dof])
    status = qn_diag_set_field (diag, QN_PROBLEM_CONTROL_DOF_FIXED, entity, QN_NONE,
                                "control.component", 0);
  return status;
}

static QnStatus
check_analysis (const QnModel *model, QnDiag *diag)
{
  const QnAnalysisSettings *analysis = &model->analysis;
  const QnEntity entity = QN_ENTITY_ANALYSIS;
  QnStatus status =
    check_number (analysis->increments, POSITIVE, entity, QN_NONE, "increments", diag);
  /* Infinity is the default and allowed here. */
  if (status == QN_OK && !(analysis->max_multiplier > 0))
    status = qn_diag_set_field (
      diag,
      isnan (analysis->max_multiplier) ? QN_PROBLEM_NOT_FINITE : QN_PROBLEM_NOT_POSITIVE,
      entity, QN_NONE, "max_multiplier", analysis->max_multiplier);
  if (status == QN_OK)
    status = check_number (analysis->multiplier_tolerance, POSITIVE, entity, QN_NONE,
                           "multiplier_tolerance", diag);
  if (status == QN_OK)
    status = check_number (analysis->residual_tolerance, POSITIVE, entity, QN_NONE,
                           "residual_tolerance", diag);
  return status == QN_OK ? check_control (model, diag) : status;
}

QnStatus
qn_model_check_settings (const QnModel *model, QnDiag *diag)
{
  QnStatus status = check_number (model->gravity, NOT_NEGATIVE, QN_ENTITY_MODEL, QN_NONE,
                                  "gravity", diag);
  if (status == QN_OK)
    status = check_laws (model, diag);
  if (status == QN_OK)
    status = check_contact (model, diag);
  for (size_t i = 0; i < model->override_count && status == QN_OK; i++)
    status = check_override (model, (QnId) i, diag);
  for (size_t i = 0; i < model->bar_count && status == QN_OK; i++)
    status = check_bar (model, (QnId) i, diag);
  if (status == QN_OK)
    status = check_loads (model, diag);
  if (status == QN_OK)
    status = check_analysis (model, diag);
  return status;
}
