/* Linear elastic in both directions, in tension as in compression: f = k q. */
#include "core/law/law-ops.h"

static void
evaluate_elastic (const QnSpring *spring, const QnSpringMemory *committed,
                  const double q[2], QnSpringResponse *response)
{
  *response = (QnSpringResponse){
    .force = { spring->kn * q[0], spring->ks * q[1] },
    .tangent = { { spring->kn, 0 }, { 0, spring->ks } },
    .memory = *committed,
    .state = QN_PAIR_STICK,
  };
}

static int
strength (const QnSpring *spring, QnStrengthRow rows[])
{
  (void) spring;
  (void) rows;
  return 0;
}

const QnLawOps qn_law_ops_elastic = { .evaluate = evaluate_elastic,
                                      .strength = strength };
