/* Rules of loads, settlements, the analysis and its stages. */
#include "core/model/model-check.h"

#include "core/base/tolerance.h"

#define RIGHT_ANGLE 1.57079632679489661923

static QnStatus
check_settlement (const QnModel *model, const QnLoad *load, QnEntity entity, QnId index,
                  QnDiag *diag)
{
  if (!model->blocks[load->block].support[load->dof])
    return qn_diag_set_field (diag, QN_PROBLEM_SETTLEMENT_FREE, entity, index,
                              "component", 0);
  return qn_check_number (load->value, QN_RANGE_FINITE, entity, index, "value", diag);
}

static QnStatus
check_index (QnId id, size_t count, QnProblem problem, QnEntity entity, QnId index,
             const char *field, QnDiag *diag)
{
  return id >= 0 && (size_t) id < count
           ? QN_OK
           : qn_diag_set_field (diag, problem, entity, index, field, id);
}

/* What a load acts on. */
static QnStatus
check_loaded (const QnModel *model, const QnLoad *load, QnEntity entity, QnId index,
              QnDiag *diag)
{
  if (load->kind == QN_LOAD_LINE)
    return check_index (load->beam, model->beam_count, QN_PROBLEM_BEAM_UNKNOWN, entity,
                        index, "beam", diag);
  if (load->kind == QN_LOAD_NODE)
    return check_index (load->node, model->node_count, QN_PROBLEM_NODE_UNKNOWN, entity,
                        index, "node", diag);
  return qn_check_block_reference (model, load->block, entity, index, "block", diag);
}

/* How often its weight acts on a block. */
static QnStatus
check_direction (QnVec2 direction, QnEntity entity, QnId index, QnDiag *diag)
{
  QnStatus status = qn_check_vector (direction, entity, index, "direction", diag);
  if (status == QN_OK && !(qn_vec2_length (direction) <= QN_LARGEST_DIRECTION))
    status = qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, entity, index, "direction",
                                qn_vec2_length (direction));
  return status;
}

static QnStatus
check_edge_load (const QnModel *model, const QnLoad *load, QnEntity entity, QnId index,
                 QnDiag *diag)
{
  QnStatus status =
    qn_check_block_reference (model, load->block, entity, index, "block", diag);
  if (status == QN_OK && !load->has_side)
    status = check_index (load->edge, (size_t) model->blocks[load->block].vertex_count,
                          QN_PROBLEM_EDGE_UNKNOWN, entity, index, "edge", diag);
  if (status == QN_OK && !load->has_side)
    status =
      check_index (load->edge_count - 1, (size_t) model->blocks[load->block].vertex_count,
                   QN_PROBLEM_EDGE_UNKNOWN, entity, index, "count", diag);
  for (int end = 0; end < 2 && status == QN_OK; end++)
    status = qn_check_number (load->intensity[end], QN_RANGE_FINITE, entity, index,
                              "intensity", diag);
  if (status == QN_OK && !(load->part[0] >= 0 && load->part[1] <= 1))
    status = qn_diag_set_field (diag, QN_PROBLEM_FRACTION, entity, index, "part", 0);
  if (status == QN_OK && !(load->part[0] < load->part[1]))
    status = qn_diag_set_field (diag, QN_PROBLEM_LOADED_PART, entity, index, "part", 0);
  return status == QN_OK && !load->normal
           ? check_direction (load->vector, entity, index, diag)
           : status;
}

/* Infinite ends are those that are not given. */
static QnStatus
check_span (const QnLoad *load, const char *const fields[2], QnEntity entity, QnId index,
            QnDiag *diag)
{
  for (int end = 0; end < 2; end++)
    if (isnan (load->span[end]))
      return qn_diag_set_field (diag, QN_PROBLEM_NOT_FINITE, entity, index, fields[end],
                                load->span[end]);
  return load->span[0] < load->span[1]
           ? QN_OK
           : qn_diag_set_field (diag, QN_PROBLEM_LOADED_PART, entity, index, fields[0],
                                load->span[0]);
}

/* Surcharge and backfill. */
static QnStatus
check_fill (const QnLoad *load, QnEntity entity, QnId index, QnDiag *diag)
{
  static const char *const across[] = { "from", "to" }, *const up[] = { "bottom", "top" };
  bool backfill = load->kind == QN_LOAD_BACKFILL;
  const QnNumberRule rules[] = {
    { backfill ? "surcharge" : "pressure", load->pressure, QN_RANGE_NOT_NEGATIVE },
    { "unit_weight", load->unit_weight, QN_RANGE_NOT_NEGATIVE },
    { "level", load->level, QN_RANGE_FINITE },
    { "coefficient", load->coefficient, QN_RANGE_NOT_NEGATIVE },
  };
  QnStatus status = qn_check_numbers (rules, QN_N_ELEMENTS (rules), entity, index, diag);
  if (status == QN_OK)
    status = check_span (load, backfill ? up : across, entity, index, diag);
  if (status != QN_OK || !backfill)
    return status;
  if (load->side != QN_BLOCK_SIDE_LEFT && load->side != QN_BLOCK_SIDE_RIGHT)
    return qn_diag_set_field (diag, QN_PROBLEM_EARTH_SIDE, entity, index, "side", 0);
  status = qn_check_number (load->span[1], QN_RANGE_FINITE, entity, index, "top", diag);
  if (status == QN_OK
      && !(load->friction_angle >= 0 && load->friction_angle < RIGHT_ANGLE))
    status = qn_diag_set_field (diag, QN_PROBLEM_EARTH_ANGLE, entity, index,
                                "friction_angle", load->friction_angle);
  return status;
}

static QnStatus
check_load (const QnModel *model, const QnLoad *load, QnEntity entity, QnId index,
            QnDiag *diag)
{
  if (load->load_case < 0 || (size_t) load->load_case > model->load_case_count)
    return qn_diag_set_field (diag, QN_PROBLEM_LOAD_CASE_UNKNOWN, entity, index, "case",
                              load->load_case);
  if (load->kind == QN_LOAD_WEIGHT)
    return check_direction (load->vector, entity, index, diag);
  if (load->kind == QN_LOAD_EDGE)
    return check_edge_load (model, load, entity, index, diag);
  if (load->kind == QN_LOAD_SURCHARGE || load->kind == QN_LOAD_BACKFILL)
    return check_fill (load, entity, index, diag);

  QnStatus status = check_loaded (model, load, entity, index, diag);
  if (status == QN_OK && load->kind == QN_LOAD_SETTLEMENT)
    return check_settlement (model, load, entity, index, diag);
  if (status == QN_OK)
    status = qn_check_vector (load->vector, entity, index, "value", diag);
  if (status == QN_OK)
    status =
      qn_check_number (load->moment, QN_RANGE_FINITE, entity, index, "moment", diag);
  if (status == QN_OK && load->has_at)
    status = qn_check_vector (load->at, entity, index, "at", diag);
  return status;
}

QnStatus
qn_model_check_loads (const QnModel *model, QnDiag *diag)
{
  QnStatus status = QN_OK;
  for (size_t i = 0; i < model->load_case_count && status == QN_OK; i++) {
    double factor = model->load_cases[i].factor;
    status = qn_check_number (factor, QN_RANGE_NOT_NEGATIVE, QN_ENTITY_LOAD_CASE,
                              (QnId) i, NULL, diag);
    if (status == QN_OK && factor > QN_LARGEST_DIRECTION)
      status = qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, QN_ENTITY_LOAD_CASE,
                                  (QnId) i, NULL, factor);
  }
  for (size_t i = 0; i < model->dead_load_count && status == QN_OK; i++)
    status =
      check_load (model, &model->dead_loads[i], QN_ENTITY_DEAD_LOAD, (QnId) i, diag);
  for (size_t i = 0; i < model->live_load_count && status == QN_OK; i++)
    status =
      check_load (model, &model->live_loads[i], QN_ENTITY_LIVE_LOAD, (QnId) i, diag);
  return status;
}

/* The block or node whose displacement is controlled, and that it is free to move. */
static QnStatus
check_controlled (const QnModel *model, QnId block, QnId node, QnDof dof, QnEntity entity,
                  QnId index, QnDiag *diag)
{
  QnStatus status =
    node == QN_NONE
      ? qn_check_block_reference (model, block, entity, index, "control.block", diag)
      : check_index (node, model->node_count, QN_PROBLEM_NODE_UNKNOWN, entity, index,
                     "control.node", diag);
  if (status == QN_OK && node != QN_NONE && model->nodes[node].seat != QN_SEAT_FREE)
    status = qn_diag_set_field (diag, QN_PROBLEM_CONTROL_NODE_RIDES, entity, index,
                                "control.node", 0);
  if (status == QN_OK
      && qn_model_body_is_fixed (model, qn_model_controlled_body (model, block, node),
                                 dof))
    status = qn_diag_set_field (diag, QN_PROBLEM_CONTROL_DOF_FIXED, entity, index,
                                "control.component", 0);
  return status;
}

static QnStatus
check_control (const QnModel *model, QnDiag *diag)
{
  const QnAnalysisSettings *analysis = &model->analysis;
  const QnEntity entity = QN_ENTITY_ANALYSIS;
  if (analysis->control_block == QN_NONE && analysis->control_node == QN_NONE) {
    if (analysis->procedure != QN_PROCEDURE_DISPLACEMENT || model->stage_count > 0)
      return QN_OK;
    return qn_diag_set_field (diag, QN_PROBLEM_CONTROL_MISSING, entity, QN_NONE,
                              "control", 0);
  }

  QnStatus status =
    check_controlled (model, analysis->control_block, analysis->control_node,
                      analysis->control_dof, entity, QN_NONE, diag);
  if (status == QN_OK)
    status = qn_check_number (analysis->control_target, QN_RANGE_FINITE, entity, QN_NONE,
                              "control.target", diag);
  if (status == QN_OK && analysis->control_target == 0)
    status = qn_diag_set_field (diag, QN_PROBLEM_CONTROL_TARGET_ZERO, entity, QN_NONE,
                                "control.target", 0);
  return status;
}

/* Whether a settlement is among the loads of some sets, bit by bit as in QnStage. */
static bool
has_settlement (const QnModel *model, uint32_t sets)
{
  for (size_t i = 0; i < model->live_load_count; i++)
    if (model->live_loads[i].kind == QN_LOAD_SETTLEMENT
        && (sets >> model->live_loads[i].set & 1) != 0)
      return true;
  return false;
}

static QnStatus
check_procedure (const QnModel *model, QnProcedure procedure, uint32_t sets,
                 QnEntity entity, QnId index, QnDiag *diag)
{
  bool work = procedure == QN_PROCEDURE_WORK, limit = procedure == QN_PROCEDURE_LIMIT;

  if ((work || limit) && has_settlement (model, sets))
    return qn_diag_set_field (
      diag, work ? QN_PROBLEM_SETTLEMENT_WORK : QN_PROBLEM_SETTLEMENT_LIMIT, entity,
      index, "procedure", 0);
  return QN_OK;
}

/* --- Stages ----------------------------------------------------------------------------- */

/* What is known of the load sets before a run. */
typedef struct {
  double multiplier[QN_MAX_LOAD_SETS];  /* NaN where only the analysis finds it */
  size_t last_driven[QN_MAX_LOAD_SETS]; /* number of the stage, from 1; 0: none */
} SetStates;

static QnStatus
refuse_stage (QnDiag *diag, QnProblem problem, QnId index, const char *field)
{
  return qn_diag_set_field (diag, problem, QN_ENTITY_STAGE, index, field, 0);
}

/* Sets that a stage drives together must have been driven together before. */
static QnStatus
check_stage_sets (const QnModel *model, const SetStates *states, QnId index, int *first,
                  QnDiag *diag)
{
  const QnStage *stage = &model->stages[index];

  *first = QN_NONE;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    if ((size_t) set > model->load_set_count)
      return refuse_stage (diag, QN_PROBLEM_LOAD_SET_UNKNOWN, index, "loads");
    if (*first == QN_NONE)
      *first = set;
    else if (states->last_driven[set] != states->last_driven[*first])
      return refuse_stage (diag, QN_PROBLEM_STAGE_SETS_APART, index, "loads");
  }
  return *first != QN_NONE ? QN_OK
                           : refuse_stage (diag, QN_PROBLEM_STAGE_IDLE, index, "loads");
}

static QnStatus
check_stage_control (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnStage *stage = &model->stages[index];
  const QnEntity entity = QN_ENTITY_STAGE;

  if (stage->control_block == QN_NONE && stage->control_node == QN_NONE)
    return stage->procedure == QN_PROCEDURE_DISPLACEMENT
             ? refuse_stage (diag, QN_PROBLEM_CONTROL_MISSING, index, "control")
             : QN_OK;
  QnStatus status = check_controlled (model, stage->control_block, stage->control_node,
                                      stage->control_dof, entity, index, diag);
  if (status == QN_OK)
    status = qn_check_number (stage->control_target, QN_RANGE_FINITE, entity, index,
                              "control.target", diag);
  if (status == QN_OK && index == 0 && stage->control_target == 0)
    status = refuse_stage (diag, QN_PROBLEM_CONTROL_TARGET_ZERO, index, "control.target");
  if (status == QN_OK && stage->has_target)
    status = refuse_stage (diag, QN_PROBLEM_STAGE_TWO_ENDS, index, "target");
  return status;
}

static QnStatus
check_stage (const QnModel *model, SetStates *states, QnId index, QnDiag *diag)
{
  const QnStage *stage = &model->stages[index];
  bool last = (size_t) index + 1 == model->stage_count;
  int first;

  if (stage->procedure == QN_PROCEDURE_LIMIT)
    return refuse_stage (diag, QN_PROBLEM_STAGE_LIMIT, index, "procedure");
  if (stage->procedure == QN_PROCEDURE_DYNAMIC)
    return refuse_stage (diag, QN_PROBLEM_STAGES_DYNAMIC, index, "procedure");
  QnStatus status = check_stage_sets (model, states, index, &first, diag);
  if (status == QN_OK)
    status = check_procedure (model, stage->procedure, stage->sets, QN_ENTITY_STAGE,
                              index, diag);
  if (status == QN_OK && stage->increments < 0)
    status = refuse_stage (diag, QN_PROBLEM_NOT_POSITIVE, index, "increments");
  if (status == QN_OK && stage->has_target)
    status = qn_check_number (stage->target, QN_RANGE_FINITE, QN_ENTITY_STAGE, index,
                              "target", diag);
  if (status == QN_OK)
    status = check_stage_control (model, index, diag);
  if (status != QN_OK)
    return status;

  bool controlled = stage->control_block != QN_NONE || stage->control_node != QN_NONE;
  bool ends =
    stage->has_target || controlled || !qn_model_sets_have_force (model, stage->sets);
  if (!ends && !last)
    return refuse_stage (diag, QN_PROBLEM_STAGE_ENDLESS, index, "target");
  double target = stage->has_target ? stage->target : controlled ? NAN : 1;
  if (ends && target == states->multiplier[first])
    return refuse_stage (diag, QN_PROBLEM_STAGE_NO_CHANGE, index, "target");
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    states->multiplier[set] = target;
    states->last_driven[set] = (size_t) index + 1;
  }
  return QN_OK;
}

static QnStatus
check_stages (const QnModel *model, QnDiag *diag)
{
  SetStates states = { 0 };
  QnStatus status = QN_OK;

  if (model->stage_count == 0)
    return QN_OK;
  if (model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_diag_set_field (diag, QN_PROBLEM_STAGE_LIMIT, QN_ENTITY_ANALYSIS, QN_NONE,
                              "stages", 0);
  if (model->stage_count > QN_MAX_STAGES)
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_LARGE, QN_ENTITY_ANALYSIS, QN_NONE,
                              "stages", (double) model->stage_count);
  if (isfinite (model->analysis.max_multiplier))
    return qn_diag_set_field (diag, QN_PROBLEM_STAGE_MULTIPLIER, QN_ENTITY_ANALYSIS,
                              QN_NONE, "max_multiplier", model->analysis.max_multiplier);
  for (size_t i = 0; i < model->stage_count && status == QN_OK; i++)
    status = check_stage (model, &states, (QnId) i, diag);
  return status;
}

/* ---------------------------------------------------------------------------------------- */

/* A tolerance that double precision resolves, and that is small enough for an equilibrium. */
static QnStatus
check_tolerance (double value, double least, double largest, const char *field,
                 QnDiag *diag)
{
  QnStatus status =
    qn_check_number (value, QN_RANGE_POSITIVE, QN_ENTITY_ANALYSIS, QN_NONE, field, diag);
  if (status != QN_OK || (value >= least && value <= largest))
    return status;
  return qn_diag_set_field (
    diag, value < least ? QN_PROBLEM_TOLERANCE_FINE : QN_PROBLEM_TOLERANCE_COARSE,
    QN_ENTITY_ANALYSIS, QN_NONE, field, value);
}

QnStatus
qn_model_check_analysis (const QnModel *model, QnDiag *diag)
{
  const QnAnalysisSettings *analysis = &model->analysis;
  const QnEntity entity = QN_ENTITY_ANALYSIS;
  QnStatus status = qn_check_number (analysis->increments, QN_RANGE_POSITIVE, entity,
                                     QN_NONE, "increments", diag);
  /* Infinity is the default and allowed here. */
  if (status == QN_OK && !(analysis->max_multiplier >= 0))
    status = qn_diag_set_field (
      diag,
      isnan (analysis->max_multiplier) ? QN_PROBLEM_NOT_FINITE : QN_PROBLEM_NEGATIVE,
      entity, QN_NONE, "max_multiplier", analysis->max_multiplier);
  if (status == QN_OK)
    status =
      check_tolerance (analysis->multiplier_tolerance, QN_LEAST_MULTIPLIER_TOLERANCE,
                       QN_LARGEST_MULTIPLIER_TOLERANCE, "multiplier_tolerance", diag);
  if (status == QN_OK)
    status = check_tolerance (analysis->residual_tolerance, QN_LEAST_RESIDUAL_TOLERANCE,
                              QN_LARGEST_RESIDUAL_TOLERANCE, "residual_tolerance", diag);
  if (status == QN_OK)
    status = qn_check_number (analysis->max_factorizations, QN_RANGE_POSITIVE, entity,
                              QN_NONE, "max_factorizations", diag);
  if (status == QN_OK && !(analysis->max_seconds > 0))
    status = qn_diag_set_field (diag,
                                isnan (analysis->max_seconds) ? QN_PROBLEM_NOT_FINITE
                                                              : QN_PROBLEM_NOT_POSITIVE,
                                entity, QN_NONE, "max_seconds", analysis->max_seconds);
  if (status == QN_OK)
    status = check_control (model, diag);
  if (status == QN_OK && model->stage_count == 0)
    status = check_procedure (model, analysis->procedure, 1, entity, QN_NONE, diag);
  if (status == QN_OK)
    status = qn_model_check_dynamic (model, diag);
  return status == QN_OK ? check_stages (model, diag) : status;
}
