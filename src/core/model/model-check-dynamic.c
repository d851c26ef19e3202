/* Rules of an analysis in time. */
#include "core/model/model-check.h"

static QnStatus
refuse_point (QnDiag *diag, QnProblem problem, QnId ground, size_t point, double value)
{
  qn_diag_set_field (diag, problem, QN_ENTITY_GROUND_MOTION, ground, "points", value);
  if (diag != NULL)
    diag->sub = (QnId) point;
  return QN_ERROR_INVALID;
}

QnStatus
qn_model_check_signal (const QnModel *model, QnId ground, QnDiag *diag)
{
  const QnGroundMotion *motion = &model->ground[ground];

  if (motion->point_count > QN_MAX_SIGNAL_POINTS)
    return qn_diag_set_field (diag, QN_PROBLEM_SIGNAL_TOO_LONG, QN_ENTITY_GROUND_MOTION,
                              ground, "points", (double) motion->point_count);
  if (motion->point_count < 2)
    return qn_diag_set_field (diag, QN_PROBLEM_SIGNAL_EMPTY, QN_ENTITY_GROUND_MOTION,
                              ground, "points", (double) motion->point_count);
  for (size_t i = 0; i < motion->point_count; i++) {
    QnVec2 point = motion->points[i];
    QnProblem problem = qn_number_problem (qn_worse (fabs (point.x), fabs (point.y)),
                                           QN_RANGE_FINITE, QN_LARGEST_NUMBER);
    if (problem != QN_PROBLEM_NONE)
      return refuse_point (diag, problem, ground, i, point.x);
    if (i == 0 ? point.x < 0 : point.x <= motion->points[i - 1].x)
      return refuse_point (diag, i == 0 ? QN_PROBLEM_NEGATIVE : QN_PROBLEM_SIGNAL_ORDER,
                           ground, i, point.x);
  }
  return QN_OK;
}

double
qn_model_duration (const QnModel *model)
{
  double end = model->analysis.dynamic.duration;
  bool given = end > 0;
  for (size_t i = 0; i < model->ground_count && !given; i++)
    end = fmax (end, qn_ground_motion_end (&model->ground[i]));
  return end;
}

static QnStatus
check_ground (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnGroundMotion *motion = &model->ground[index];
  const QnEntity entity = QN_ENTITY_GROUND_MOTION;
  const QnNumberRule numbers[] = {
    { "scale", motion->scale, QN_RANGE_FINITE },
    { "peak", motion->peak, QN_RANGE_NOT_NEGATIVE },
    { "time_step", motion->time_step, QN_RANGE_NOT_NEGATIVE },
    /* of pulses alone */
    { "pulse.amplitude", motion->pulse.amplitude, QN_RANGE_FINITE },
    { "pulse.duration", motion->pulse.duration, QN_RANGE_POSITIVE },
    { "pulse.start", motion->pulse.start, QN_RANGE_NOT_NEGATIVE },
  };
  bool pulse = motion->kind == QN_SIGNAL_PULSE;
  QnStatus status = qn_check_vector (motion->direction, entity, index, "direction", diag);

  if (status == QN_OK && motion->direction.x == 0 && motion->direction.y == 0)
    status = qn_diag_set_field (diag, QN_PROBLEM_SIGNAL_WITHOUT_DIRECTION, entity, index,
                                "direction", 0);
  if (status == QN_OK)
    status = qn_check_numbers (numbers, pulse ? 6 : 3, entity, index, diag);
  /* Of a record the points are known once it has been read. */
  if (status == QN_OK
      && (motion->kind == QN_SIGNAL_POINTS
          || (motion->kind == QN_SIGNAL_RECORD && motion->point_count > 0)))
    status = qn_model_check_signal (model, index, diag);
  return status;
}

static QnStatus
check_initial (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnInitialMotion *motion = &model->initial[index];
  const QnEntity entity = QN_ENTITY_INITIAL_MOTION;
  QnStatus status =
    qn_check_block_reference (model, motion->block, entity, index, "block", diag);

  for (int i = 0; i < QN_DOF_COUNT && status == QN_OK; i++) {
    status = qn_check_number (motion->displacement[i], QN_RANGE_FINITE, entity, index,
                              "displacement", diag);
    if (status == QN_OK)
      status = qn_check_number (motion->velocity[i], QN_RANGE_FINITE, entity, index,
                                "velocity", diag);
    bool moves = motion->displacement[i] != 0 || motion->velocity[i] != 0;
    if (status == QN_OK && moves && model->blocks[motion->block].support[i])
      status =
        qn_diag_set_field (diag, QN_PROBLEM_INITIAL_FIXED, entity, index,
                           motion->displacement[i] != 0 ? "displacement" : "velocity", 0);
  }
  return status;
}

QnStatus
qn_model_check_steps (const QnModel *model, QnDiag *diag)
{
  double duration = qn_model_duration (model);
  double time_step = model->analysis.dynamic.time_step;
  if (duration <= QN_MAX_TIME_STEPS * time_step)
    return QN_OK;
  return qn_diag_set_field (diag, QN_PROBLEM_TOO_MANY_TIME_STEPS, QN_ENTITY_ANALYSIS,
                            QN_NONE, "dynamic.time_step", duration / time_step);
}

static QnStatus
check_integration (const QnModel *model, QnDiag *diag)
{
  const QnDynamicSettings *s = &model->analysis.dynamic;
  const QnNumberRule numbers[] = {
    { "dynamic.duration", s->duration,
      model->ground_count > 0 ? QN_RANGE_NOT_NEGATIVE : QN_RANGE_POSITIVE },
    { "dynamic.time_step", s->time_step, QN_RANGE_POSITIVE },
    { "dynamic.damping.mass", s->mass_damping, QN_RANGE_NOT_NEGATIVE },
    { "dynamic.damping.stiffness", s->joint_damping, QN_RANGE_NOT_NEGATIVE },
    { "dynamic.tolerance", s->tolerance, QN_RANGE_POSITIVE },
    { "dynamic.output_interval", s->output_interval, QN_RANGE_NOT_NEGATIVE },
  };
  const QnEntity entity = QN_ENTITY_ANALYSIS;
  QnStatus status =
    qn_check_numbers (numbers, QN_N_ELEMENTS (numbers), entity, QN_NONE, diag);
  if (status != QN_OK)
    return status;
  if (!(s->rho >= 0 && s->rho <= 1))
    return qn_diag_set_field (diag, QN_PROBLEM_RADIUS_RANGE, entity, QN_NONE,
                              "dynamic.rho", s->rho);
  return qn_model_check_steps (model, diag);
}

QnStatus
qn_model_check_dynamic (const QnModel *model, QnDiag *diag)
{
  bool runs = model->analysis.procedure == QN_PROCEDURE_DYNAMIC;
  QnStatus status = QN_OK;

  if (runs && model->stage_count > 0)
    return qn_diag_set_field (diag, QN_PROBLEM_STAGES_DYNAMIC, QN_ENTITY_ANALYSIS,
                              QN_NONE, "stages", 0);
  if (runs)
    status = check_integration (model, diag);
  for (size_t i = 0; i < model->ground_count && status == QN_OK; i++)
    status = check_ground (model, (QnId) i, diag);
  for (size_t i = 0; i < model->initial_count && status == QN_OK; i++)
    status = check_initial (model, (QnId) i, diag);
  for (size_t i = 0; i < model->track_count && status == QN_OK; i++)
    status = qn_check_block_reference (model, model->tracks[i].block, QN_ENTITY_TRACK,
                                       (QnId) i, "block", diag);
  return status;
}
