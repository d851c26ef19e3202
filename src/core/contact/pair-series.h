/* Two unequal springs in series: the internal Newton iteration for the hinge C between them.
 *
 * The elongation q of the pair is given; the unknown is the part qa of it that spring a takes.
 * Both springs must carry the same force:
 *
 *   gap(qa) = fa(qa) - fb(q - qa) = 0,   (Ta + Tb) dqa = -gap
 *
 * With consistent tangents the iteration converges quadratically near the solution; springs of
 * straight branches are solved exactly once the branches are found. Where it does not converge
 * between branches, sweeps take over: the normal gap is closed along the normal elongation alone,
 * then the tangential one, in turns, each within an interval that holds its root. (HybriDFEM,
 * section 2.2; the tangent of the pair is Ta (Ta + Tb)^-1 Tb.)
 */
#pragma once

#include "core/contact/contact-pair.h"

/* One stage of the iteration. */
typedef struct QnPairSeries {
  const QnPairSprings *springs;
  const QnPairMemory *committed;
  double q[2];  /* elongation of the pair, m */
  double qa[2]; /* of it, spring a takes this; spring b the rest */
  QnSpringResponse a, b;
  double gap[2]; /* N */
  double
    size; /* of the gap, relative to the forces and to what rounding of q makes of them */
} QnPairSeries;

/* The first guess: the increment since the last commit, shared elastically. */
void qn_pair_series_start (QnPairSeries *series, const QnPairSprings *springs,
                           const QnPairMemory *committed, const double q[2]);

/* One iteration. */
void qn_pair_series_step (QnPairSeries *series);

/* One sweep. */
void qn_pair_series_sweep (QnPairSeries *series);

/* (Ta + Tb)^-1, regularised where both springs are without stiffness. */
void qn_pair_series_flexibility (const QnPairSeries *series, double inverse[2][2]);
