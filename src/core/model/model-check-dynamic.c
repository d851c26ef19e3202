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
  const QnSubject of = { QN_ENTITY_GROUND_MOTION, ground, diag };
  const QnGroundMotion *motion = &model->ground[ground];
  const size_t count = motion->point_count;

  if (!qn_require (of, count <= QN_MAX_SIGNAL_POINTS, QN_PROBLEM_SIGNAL_TOO_LONG,
                   "points", (double) count)
      || !qn_require (of, count >= 2, QN_PROBLEM_SIGNAL_EMPTY, "points", (double) count))
    return QN_ERROR_INVALID;
  for (size_t i = 0; i < count; i++) {
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

static bool
check_ground (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_GROUND_MOTION, index, diag };
  const QnGroundMotion *motion = &model->ground[index];
  const QnPulse *pulse = motion->kind == QN_SIGNAL_PULSE ? &motion->pulse : NULL;
  /* Of a record the points are known once it has been read. */
  bool has_points = motion->kind == QN_SIGNAL_POINTS
                    || (motion->kind == QN_SIGNAL_RECORD && motion->point_count > 0);

  return qn_require_vector (of, "direction", motion->direction)
         && qn_require (of, motion->direction.x != 0 || motion->direction.y != 0,
                        QN_PROBLEM_SIGNAL_WITHOUT_DIRECTION, "direction", 0)
         && qn_require_number (of, "scale", motion->scale, QN_RANGE_FINITE)
         && qn_require_number (of, "peak", motion->peak, QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "time_step", motion->time_step, QN_RANGE_NOT_NEGATIVE)
         && (pulse == NULL
             || (qn_require_number (of, "pulse.amplitude", pulse->amplitude,
                                    QN_RANGE_FINITE)
                 && qn_require_number (of, "pulse.duration", pulse->duration,
                                       QN_RANGE_POSITIVE)
                 && qn_require_number (of, "pulse.start", pulse->start,
                                       QN_RANGE_NOT_NEGATIVE)))
         && (!has_points || qn_model_check_signal (model, index, diag) == QN_OK);
}

static bool
check_initial (const QnModel *model, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_INITIAL_MOTION, index, diag };
  const QnInitialMotion *motion = &model->initial[index];
  bool holds = qn_require_block (of, "block", motion->block, model);

  for (int i = 0; i < QN_DOF_COUNT && holds; i++) {
    double shift = motion->displacement[i], velocity = motion->velocity[i];
    bool fixed = model->blocks[motion->block].support[i];
    holds = qn_require_number (of, "displacement", shift, QN_RANGE_FINITE)
            && qn_require_number (of, "velocity", velocity, QN_RANGE_FINITE)
            && qn_require (of, !fixed || shift == 0, QN_PROBLEM_INITIAL_FIXED,
                           "displacement", 0)
            && qn_require (of, !fixed || velocity == 0, QN_PROBLEM_INITIAL_FIXED,
                           "velocity", 0);
  }
  return holds;
}

QnStatus
qn_model_check_steps (const QnModel *model, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_ANALYSIS, QN_NONE, diag };
  double duration = qn_model_duration (model);
  double time_step = model->analysis.dynamic.time_step;

  return qn_required (qn_require (of, duration <= QN_MAX_TIME_STEPS * time_step,
                                  QN_PROBLEM_TOO_MANY_TIME_STEPS, "dynamic.time_step",
                                  duration / time_step));
}

static bool
check_integration (const QnModel *model, QnSubject of)
{
  const QnDynamicSettings *s = &model->analysis.dynamic;

  return qn_require_number (of, "dynamic.duration", s->duration,
                            model->ground_count > 0 ? QN_RANGE_NOT_NEGATIVE
                                                    : QN_RANGE_POSITIVE)
         && qn_require_number (of, "dynamic.time_step", s->time_step, QN_RANGE_POSITIVE)
         && qn_require_number (of, "dynamic.damping.mass", s->mass_damping,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require_number (of, "dynamic.damping.stiffness", s->joint_damping,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require (
           of,
           s->of != QN_DAMPING_IMPACT || s->joint_damping == 0 || model->beam_count > 0,
           QN_PROBLEM_DAMPING_UNUSED, "dynamic.damping.stiffness", s->joint_damping)
         && qn_require_number (of, "dynamic.tolerance", s->tolerance, QN_RANGE_POSITIVE)
         && qn_require_number (of, "dynamic.output_interval", s->output_interval,
                               QN_RANGE_NOT_NEGATIVE)
         && qn_require (of, s->rho >= 0 && s->rho <= 1, QN_PROBLEM_RADIUS_RANGE,
                        "dynamic.rho", s->rho)
         && qn_model_check_steps (model, of.diag) == QN_OK;
}

bool
qn_model_check_dynamic (const QnModel *model, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_ANALYSIS, QN_NONE, diag };
  bool holds =
    model->analysis.procedure != QN_PROCEDURE_DYNAMIC
    || (qn_require (of, model->stage_count == 0, QN_PROBLEM_STAGES_DYNAMIC, "stages", 0)
        && check_integration (model, of));

  for (size_t i = 0; i < model->ground_count && holds; i++)
    holds = check_ground (model, (QnId) i, diag);
  for (size_t i = 0; i < model->initial_count && holds; i++)
    holds = check_initial (model, (QnId) i, diag);
  for (size_t i = 0; i < model->track_count && holds; i++)
    holds = qn_require_block ((QnSubject){ QN_ENTITY_TRACK, (QnId) i, diag }, "block",
                              model->tracks[i].block, model);
  return holds;
}
