#include "core/model/tie.h"

#include <math.h>

const char *const qn_tie_state_names[QN_TIE_STATE_COUNT] = {
  [QN_TIE_SLACK] = "slack",
  [QN_TIE_ELASTIC] = "elastic",
  [QN_TIE_YIELDS] = "yields",
  [QN_TIE_ANCHOR] = "anchor",
};

double
qn_tie_length (const QnTie *tie)
{
  return qn_vec2_length (qn_vec2_sub (tie->ends[1].at, tie->ends[0].at));
}

double
qn_tie_stiffness (const QnTie *tie)
{
  return tie->elasticity * tie->area / qn_tie_length (tie);
}

double
qn_tie_plate_punching (const QnTiePlate *p)
{
  double strength = p->shear * QN_PI * p->wall * (p->diameter + p->wall);

  return p->diameter > 0 && strength > 0 ? strength : INFINITY;
}

double
qn_tie_plate_bearing (const QnTiePlate *p)
{
  double strength = p->compression * 0.25 * QN_PI * p->diameter * p->diameter;

  return strength > 0 ? strength : INFINITY;
}

double
qn_tie_debonding (const QnTie *tie)
{
  double energy = tie->strip.width * tie->strip.fracture_energy;

  return energy > 0 ? sqrt (2 * tie->elasticity * tie->area * energy) : INFINITY;
}

double
qn_tie_anchor (const QnTie *tie)
{
  double wall =
    fmin (fmin (qn_tie_plate_punching (&tie->plate), qn_tie_plate_bearing (&tie->plate)),
          qn_tie_debonding (tie));

  return tie->anchor > 0 ? fmin (tie->anchor, wall) : wall;
}

static double
steel (const QnTie *tie)
{
  return tie->yield > 0 ? tie->area * tie->yield : INFINITY;
}

QnTieState
qn_tie_weakest (const QnTie *tie)
{
  return qn_tie_anchor (tie) < steel (tie) ? QN_TIE_ANCHOR : QN_TIE_YIELDS;
}

double
qn_tie_strength (const QnTie *tie)
{
  return fmin (qn_tie_anchor (tie), steel (tie));
}

QnTieState
qn_tie_state (const QnTie *tie, double force, double little)
{
  if (force <= little)
    return QN_TIE_SLACK;
  return force >= qn_tie_strength (tie) - little ? qn_tie_weakest (tie) : QN_TIE_ELASTIC;
}
