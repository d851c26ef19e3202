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

QnTieState
qn_tie_weakest (const QnTie *tie)
{
  bool anchor =
    tie->anchor > 0 && (tie->yield == 0 || tie->anchor < tie->area * tie->yield);

  return anchor ? QN_TIE_ANCHOR : QN_TIE_YIELDS;
}

double
qn_tie_strength (const QnTie *tie)
{
  if (qn_tie_weakest (tie) == QN_TIE_ANCHOR)
    return tie->anchor;
  return tie->yield > 0 ? tie->area * tie->yield : INFINITY;
}

QnTieState
qn_tie_state (const QnTie *tie, double force, double little)
{
  if (force <= little)
    return QN_TIE_SLACK;
  return force >= qn_tie_strength (tie) - little ? qn_tie_weakest (tie) : QN_TIE_ELASTIC;
}
