#include "core/model/ground-motion.h"

const char *const qn_pulse_kind_names[QN_PULSE_KIND_COUNT] = {
  [QN_PULSE_HALF_SINE] = "half-sine",       [QN_PULSE_SINE] = "sine",
  [QN_PULSE_RECTANGLE] = "rectangle",       [QN_PULSE_RICKER] = "ricker",
  [QN_PULSE_STEP_IMPULSE] = "step-impulse",
};

const char *const qn_damping_stiffness_names[QN_DAMPING_STIFFNESS_COUNT] = {
  [QN_DAMPING_INITIAL] = "initial",
  [QN_DAMPING_CURRENT] = "current",
  [QN_DAMPING_IMPACT] = "impact",
};

double
qn_ground_motion_end (const QnGroundMotion *motion)
{
  static const double lengths[QN_PULSE_KIND_COUNT] = {
    [QN_PULSE_HALF_SINE] = 1, [QN_PULSE_SINE] = 1,         [QN_PULSE_RECTANGLE] = 1,
    [QN_PULSE_RICKER] = 2,    [QN_PULSE_STEP_IMPULSE] = 3,
  };

  if (motion->kind == QN_SIGNAL_PULSE)
    return motion->pulse.start + lengths[motion->pulse.kind] * motion->pulse.duration;
  return motion->point_count > 0 ? motion->points[motion->point_count - 1].x : 0;
}
