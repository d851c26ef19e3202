/* Linear elastic while closed, nothing while open. There is no limit to slip: a closed joint
 * is elastic in shear, measured from where it last closed. */
#include "core/law/law-ops.h"

static void
evaluate (const QnSpring *spring, const QnSpringMemory *committed, const double q[2],
          QnSpringResponse *response)
{
  if (q[0] > 0) {
    *response = (QnSpringResponse){
      .memory = { .opening = 0, .slip = q[1] },
      .phase = QN_PHASE_OPEN,
    };
    return;
  }

  *response = (QnSpringResponse){
    .force = { spring->kn * q[0], spring->ks * (q[1] - committed->slip) },
    .tangent = { { spring->kn, 0 }, { 0, spring->ks } },
    .memory = *committed,
    .phase = QN_PHASE_STICK,
  };
}

static int
strength (const QnSpring *spring, QnStrengthRow rows[])
{
  (void) spring;
  rows[0] = (QnStrengthRow){ .normal = 1, .limit = 0, .opening = 1 };
  return 1;
}

const QnLawOps qn_law_ops_no_tension = { .evaluate = evaluate, .strength = strength };
