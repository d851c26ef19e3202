/* Rules of loads, settlements, the analysis and its stages. */
#include "core/model/model-check.h"

#include "core/base/tolerance.h"

#define RIGHT_ANGLE 1.57079632679489661923

/* Checks the entity on which a load acts. */
static bool
check_loaded (const QnModel *model, const QnLoad *load, QnSubject of)
{
  if (load->kind == QN_LOAD_LINE)
    return qn_require_index (of, "beam", load->beam, model->beam_count,
                             QN_PROBLEM_BEAM_UNKNOWN);
  if (load->kind == QN_LOAD_NODE)
    return qn_require_index (of, "node", load->node, model->node_count,
                             QN_PROBLEM_NODE_UNKNOWN);
  return qn_require_block (of, "block", load->block, model);
}

/* How often its weight acts on a block. */
static bool
check_direction (QnVec2 direction, QnSubject of)
{
  return qn_require_vector (of, "direction", direction)
         && qn_require (of, qn_vec2_length (direction) <= QN_LARGEST_DIRECTION,
                        QN_PROBLEM_TOO_LARGE, "direction", qn_vec2_length (direction));
}

/* The edges that a load counts. */
static bool
check_edges (const QnModel *model, const QnLoad *load, QnSubject of)
{
  size_t count = (size_t) model->blocks[load->block].vertex_count;

  return qn_require_index (of, "edge", load->edge, count, QN_PROBLEM_EDGE_UNKNOWN)
         && qn_require_index (of, "count", load->edge_count - 1, count,
                              QN_PROBLEM_EDGE_UNKNOWN);
}

static bool
check_edge_load (const QnModel *model, const QnLoad *load, QnSubject of)
{
  const double *part = load->part;

  return qn_require_block (of, "block", load->block, model)
         && (load->has_side || check_edges (model, load, of))
         && qn_require_number (of, "intensity", load->intensity[0], QN_RANGE_FINITE)
         && qn_require_number (of, "intensity", load->intensity[1], QN_RANGE_FINITE)
         && qn_require (of, part[0] >= 0 && part[1] <= 1, QN_PROBLEM_FRACTION, "part", 0)
         && qn_require (of, part[0] < part[1], QN_PROBLEM_LOADED_PART, "part", 0)
         && (load->normal || check_direction (load->vector, of));
}

/* Surcharge and backfill. */
static bool
check_fill (const QnLoad *load, QnSubject of)
{
  const bool backfill = load->kind == QN_LOAD_BACKFILL;
  const double *span = load->span, angle = load->friction_angle;
  const char *from = backfill ? "bottom" : "from", *to = backfill ? "top" : "to";

  /* Infinite ends are those that are not given. */
  if (!qn_require_number (of, backfill ? "surcharge" : "pressure", load->pressure,
                          QN_RANGE_NOT_NEGATIVE)
      || !qn_require_number (of, "unit_weight", load->unit_weight, QN_RANGE_NOT_NEGATIVE)
      || !qn_require_number (of, "level", load->level, QN_RANGE_FINITE)
      || !qn_require_number (of, "coefficient", load->coefficient, QN_RANGE_NOT_NEGATIVE)
      || !qn_require (of, !isnan (span[0]), QN_PROBLEM_NOT_FINITE, from, span[0])
      || !qn_require (of, !isnan (span[1]), QN_PROBLEM_NOT_FINITE, to, span[1])
      || !qn_require (of, span[0] < span[1], QN_PROBLEM_LOADED_PART, from, span[0]))
    return false;
  return !backfill
         || (qn_require (
               of, load->side == QN_BLOCK_SIDE_LEFT || load->side == QN_BLOCK_SIDE_RIGHT,
               QN_PROBLEM_EARTH_SIDE, "side", 0)
             && qn_require_number (of, "top", load->span[1], QN_RANGE_FINITE)
             && qn_require (of, angle >= 0 && angle < RIGHT_ANGLE, QN_PROBLEM_EARTH_ANGLE,
                            "friction_angle", angle));
}

static bool
check_soil (const QnLoad *load, QnSubject of)
{
  const double angle = load->friction_angle, part = load->mobilisation;

  /* The points of a fill's surface, from left to right. */
  bool holds = qn_require (of, load->surface_count >= 2, QN_PROBLEM_SURFACE, "surface", 0)
               && qn_require (of, load->surface_count <= QN_MAX_SURFACE_POINTS,
                              QN_PROBLEM_TOO_LARGE, "surface", load->surface_count);
  for (int32_t i = 0; i < load->surface_count && holds; i++)
    holds = qn_require_vector (of, "surface", load->surface[i])
            && qn_require (of, i == 0 || load->surface[i - 1].x < load->surface[i].x,
                           QN_PROBLEM_SURFACE, "surface", 0);
  return holds
         && qn_require_number (of, "unit_weight", load->unit_weight,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require (of, angle >= 0 && angle < RIGHT_ANGLE, QN_PROBLEM_EARTH_ANGLE,
                        "friction_angle", angle)
         && qn_require (of, part >= 0 && part <= 1, QN_PROBLEM_FRACTION, "mobilisation",
                        part)
         && qn_require_number (of, "stiffness", load->stiffness, QN_RANGE_POSITIVE)
         && qn_require (of, !isnan (load->span[0]), QN_PROBLEM_NOT_FINITE, "bottom", 0);
}

static bool
check_vehicle (const QnVehicle *vehicle, QnSubject of)
{
  bool holds = qn_require_number (of, "patch", vehicle->patch[0], QN_RANGE_POSITIVE)
               && qn_require_number (of, "patch", vehicle->patch[1], QN_RANGE_POSITIVE)
               && qn_require_number (of, "track", vehicle->track, QN_RANGE_NOT_NEGATIVE)
               && qn_require (of, vehicle->axle_count + vehicle->line_count > 0,
                              QN_PROBLEM_VEHICLE_EMPTY, "axles", 0);

  for (int32_t i = 0; i < vehicle->axle_count && holds; i++)
    holds =
      qn_require_number (of, "axles", vehicle->axles[i].at, QN_RANGE_NOT_NEGATIVE)
      && qn_require_number (of, "axles", vehicle->axles[i].load, QN_RANGE_NOT_NEGATIVE);
  for (int32_t i = 0; i < vehicle->line_count && holds; i++) {
    const QnLineLoad *line = &vehicle->lines[i];
    holds =
      qn_require (of, line->from < line->to, QN_PROBLEM_LOADED_PART, "lines", line->from)
      && qn_require (of, fmax (fabs (line->from), fabs (line->to)) <= 1e4,
                     QN_PROBLEM_TOO_LARGE, "lines", line->to)
      && qn_require_number (of, "lines", line->intensity, QN_RANGE_NOT_NEGATIVE);
  }
  return holds;
}

static bool
check_load (const QnModel *model, const QnLoad *load, QnSubject of)
{
  if (!qn_require_index (of, "case", load->load_case, model->load_case_count + 1,
                         QN_PROBLEM_LOAD_CASE_UNKNOWN))
    return false;
  if (load->kind == QN_LOAD_WEIGHT)
    return check_direction (load->vector, of);
  if (load->kind == QN_LOAD_EDGE)
    return check_edge_load (model, load, of);
  if (load->kind == QN_LOAD_SURCHARGE || load->kind == QN_LOAD_BACKFILL)
    return check_fill (load, of);
  if (load->kind == QN_LOAD_FILL)
    return check_soil (load, of);
  if (load->kind == QN_LOAD_VEHICLE)
    return qn_require_index (of, "vehicle", load->vehicle, model->vehicle_count,
                             QN_PROBLEM_VEHICLE_UNKNOWN)
           && qn_require_number (of, "position", load->position, QN_RANGE_FINITE)
           && qn_require_number (of, "convoy", load->convoy, QN_RANGE_POSITIVE)
           && qn_require (of, load->convoy <= QN_MAX_CONVOY, QN_PROBLEM_TOO_LARGE,
                          "convoy", load->convoy)
           && qn_require_number (of, "headway", load->headway, QN_RANGE_NOT_NEGATIVE)
           && qn_require_number (of, "width", load->width, QN_RANGE_NOT_NEGATIVE)
           && qn_require_number (of, "effective_width", load->effective,
                                 QN_RANGE_NOT_NEGATIVE);
  if (!check_loaded (model, load, of))
    return false;
  if (load->kind == QN_LOAD_SETTLEMENT)
    return qn_require (of, model->blocks[load->block].support[load->dof],
                       QN_PROBLEM_SETTLEMENT_FREE, "component", 0)
           && qn_require_number (of, "value", load->value, QN_RANGE_FINITE);
  return qn_require_vector (of, "value", load->vector)
         && qn_require_number (of, "moment", load->moment, QN_RANGE_FINITE)
         && (!load->has_at || qn_require_vector (of, "at", load->at));
}

bool
qn_model_check_loads (const QnModel *model, QnDiag *diag)
{
  bool holds = true;
  QnSubject of = { QN_ENTITY_LOAD_CASE, 0, diag };

  for (; (size_t) of.index < model->load_case_count && holds; of.index++) {
    double factor = model->load_cases[of.index].factor;
    holds = qn_require_number (of, NULL, factor, QN_RANGE_NOT_NEGATIVE)
            && qn_require (of, factor <= QN_LARGEST_DIRECTION, QN_PROBLEM_TOO_LARGE, NULL,
                           factor);
  }
  for (size_t i = 0; i < model->vehicle_count && holds; i++)
    holds = check_vehicle (&model->vehicles[i],
                           (QnSubject){ QN_ENTITY_VEHICLE, (QnId) i, diag });
  for (size_t i = 0; i < model->live_load_count && holds; i++)
    holds = qn_require (qn_load_subject (model, model->dead_load_count + i, diag),
                        model->live_loads[i].kind != QN_LOAD_FILL, QN_PROBLEM_FILL_LIVE,
                        "kind", 0);
  for (size_t i = 0; i < qn_model_load_count (model) && holds; i++)
    holds =
      check_load (model, qn_model_load (model, i), qn_load_subject (model, i, diag));
  return holds;
}

/* The block or node whose displacement is controlled, that it is free to move, and how far it goes. `missing`:
 * there may be none; `still`: it may stay. */
static bool
check_control (const QnModel *model, const QnControl *control, bool missing, bool still,
               QnSubject of)
{
  const QnId node = control->node;
  const size_t body = qn_model_controlled_body (model, control);

  if (!qn_control_is_given (control))
    return qn_require (of, missing, QN_PROBLEM_CONTROL_MISSING, "control", 0);
  bool known = node == QN_NONE
                 ? qn_require_block (of, "control.block", control->block, model)
                 : qn_require_index (of, "control.node", node, model->node_count,
                                     QN_PROBLEM_NODE_UNKNOWN)
                     && qn_require (of, model->nodes[node].seat == QN_SEAT_FREE,
                                    QN_PROBLEM_CONTROL_NODE_RIDES, "control.node", 0);

  return known
         && qn_require (of, !qn_model_body_is_fixed (model, body, control->dof),
                        QN_PROBLEM_CONTROL_DOF_FIXED, "control.component", 0)
         && qn_require_number (of, "control.target", control->target, QN_RANGE_FINITE)
         && qn_require (of, still || control->target != 0, QN_PROBLEM_CONTROL_TARGET_ZERO,
                        "control.target", 0);
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

static bool
check_procedure (const QnModel *model, QnProcedure procedure, uint32_t sets, QnSubject of)
{
  bool work = procedure == QN_PROCEDURE_WORK, limit = procedure == QN_PROCEDURE_LIMIT;

  return qn_require (of, !((work || limit) && has_settlement (model, sets)),
                     work ? QN_PROBLEM_SETTLEMENT_WORK : QN_PROBLEM_SETTLEMENT_LIMIT,
                     "procedure", 0);
}

/* --- Stages ----------------------------------------------------------------------------- */

/* Load sets before a run. */
typedef struct {
  double multiplier[QN_MAX_LOAD_SETS];  /* NaN where only the analysis finds it */
  size_t last_driven[QN_MAX_LOAD_SETS]; /* number of the stage, from 1; 0: none */
} SetStates;

/* Sets that a stage drives together must have been driven together before. */
static bool
check_stage_sets (const QnModel *model, const SetStates *states, const QnStage *stage,
                  int *first, QnSubject of)
{
  *first = QN_NONE;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    if (!qn_require (of, (size_t) set <= model->load_set_count,
                     QN_PROBLEM_LOAD_SET_UNKNOWN, "loads", 0))
      return false;
    if (*first == QN_NONE)
      *first = set;
    if (!qn_require (of, states->last_driven[set] == states->last_driven[*first],
                     QN_PROBLEM_STAGE_SETS_APART, "loads", 0))
      return false;
  }
  return qn_require (of, *first != QN_NONE, QN_PROBLEM_STAGE_IDLE, "loads", 0);
}

static bool
check_stage (const QnModel *model, SetStates *states, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_STAGE, index, diag };
  const QnStage *stage = &model->stages[index];
  bool last = (size_t) index + 1 == model->stage_count;
  bool controlled = qn_control_is_given (&stage->control);
  bool ends =
    stage->has_target || controlled || !qn_model_sets_have_force (model, stage->sets);
  double target = stage->has_target ? stage->target : controlled ? NAN : 1;
  int first;

  if (!qn_require (of, stage->procedure != QN_PROCEDURE_LIMIT, QN_PROBLEM_STAGE_LIMIT,
                   "procedure", 0)
      || !qn_require (of, stage->procedure != QN_PROCEDURE_DYNAMIC,
                      QN_PROBLEM_STAGES_DYNAMIC, "procedure", 0)
      || !check_stage_sets (model, states, stage, &first, of)
      || !check_procedure (model, stage->procedure, stage->sets, of)
      || !qn_require (of, stage->increments >= 0, QN_PROBLEM_NOT_POSITIVE, "increments",
                      0)
      || (stage->has_target
          && !qn_require_number (of, "target", stage->target, QN_RANGE_FINITE))
      || !check_control (model, &stage->control,
                         stage->procedure != QN_PROCEDURE_DISPLACEMENT, index != 0, of)
      || !qn_require (of, !(controlled && stage->has_target), QN_PROBLEM_STAGE_TWO_ENDS,
                      "target", 0)
      || !qn_require (of, ends || last, QN_PROBLEM_STAGE_ENDLESS, "target", 0)
      || !qn_require (of, !(ends && target == states->multiplier[first]),
                      QN_PROBLEM_STAGE_NO_CHANGE, "target", 0))
    return false;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    if ((stage->sets >> set & 1) != 0) {
      states->multiplier[set] = target;
      states->last_driven[set] = (size_t) index + 1;
    }
  return true;
}

static bool
check_stages (const QnModel *model, QnSubject of)
{
  SetStates states = { 0 };
  const double largest = model->analysis.max_multiplier;

  if (model->stage_count == 0)
    return true;
  bool holds = qn_require (of, model->analysis.procedure != QN_PROCEDURE_LIMIT,
                           QN_PROBLEM_STAGE_LIMIT, "stages", 0)
               && qn_require (of, model->stage_count <= QN_MAX_STAGES,
                              QN_PROBLEM_TOO_LARGE, "stages", (double) model->stage_count)
               && qn_require (of, !isfinite (largest), QN_PROBLEM_STAGE_MULTIPLIER,
                              "max_multiplier", largest);
  for (size_t i = 0; i < model->stage_count && holds; i++)
    holds = check_stage (model, &states, (QnId) i, of.diag);
  return holds;
}

/* ---------------------------------------------------------------------------------------- */

/* A tolerance that double precision resolves, and that is small enough for an equilibrium. */
static bool
check_tolerance (double value, double least, double largest, const char *field,
                 QnSubject of)
{
  return qn_require_number (of, field, value, QN_RANGE_POSITIVE)
         && qn_require (of, value >= least, QN_PROBLEM_TOLERANCE_FINE, field, value)
         && qn_require (of, value <= largest, QN_PROBLEM_TOLERANCE_COARSE, field, value);
}

bool
qn_model_check_analysis (const QnModel *model, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_ANALYSIS, QN_NONE, diag };
  const QnAnalysisSettings *a = &model->analysis;

  /* Infinity is the default of the multiplier and of seconds. */
  return qn_require_number (of, "increments", a->increments, QN_RANGE_POSITIVE)
         && qn_require (of, a->max_multiplier >= 0,
                        isnan (a->max_multiplier) ? QN_PROBLEM_NOT_FINITE
                                                  : QN_PROBLEM_NEGATIVE,
                        "max_multiplier", a->max_multiplier)
         && check_tolerance (a->multiplier_tolerance, QN_LEAST_MULTIPLIER_TOLERANCE,
                             QN_LARGEST_MULTIPLIER_TOLERANCE, "multiplier_tolerance", of)
         && check_tolerance (a->residual_tolerance, QN_LEAST_RESIDUAL_TOLERANCE,
                             QN_LARGEST_RESIDUAL_TOLERANCE, "residual_tolerance", of)
         && qn_require_number (of, "max_factorizations", a->max_factorizations,
                               QN_RANGE_POSITIVE)
         && qn_require (of, a->max_seconds > 0,
                        isnan (a->max_seconds) ? QN_PROBLEM_NOT_FINITE
                                               : QN_PROBLEM_NOT_POSITIVE,
                        "max_seconds", a->max_seconds)
         && check_control (
           model, &a->control,
           a->procedure != QN_PROCEDURE_DISPLACEMENT || model->stage_count > 0, false, of)
         && (model->stage_count > 0 || check_procedure (model, a->procedure, 1, of))
         && qn_model_check_dynamic (model, diag) && check_stages (model, of);
}
