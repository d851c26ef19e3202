/* Linear elastic while closed, nothing while open: a closed joint sticks, and its shear is measured from
 * where it last closed.
 *
 * Were the shear force to vanish at once where a joint opens, many structures would have no equilibrium at
 * all: the joint stays closed without its shear and opens with it. So it goes to nothing together with the
 * compression, as friction that is steeper than any joint's (Coulomb's law without cohesion, tension and
 * dilatancy). */
#include "core/law/law-ops.h"

static void
resolve_no_tension (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  (void) law;
  (void) scale;
  spring->friction = spring->residual = QN_NO_TENSION_FRICTION;
}

const QnLawOps qn_law_ops_no_tension = { .resolve = resolve_no_tension,
                                         .evaluate = qn_law_coulomb_evaluate,
                                         .strength = qn_law_coulomb_strength,
                                         .plastic = true };
