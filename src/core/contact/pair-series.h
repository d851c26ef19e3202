/* Two unequal springs in series: the internal Newton iteration for the hinge C between them.
 *
 * The elongation q of the pair is given; the unknown is the part qa of it that spring a takes.
 * Both springs must carry the same force:
 *
 *   gap(qa) = fa(qa) - fb(q - qa) = 0,   (Ta + Tb) dqa = -gap
 *
 * With consistent tangents the iteration converges quadratically; piecewise linear springs are solved
 * exactly once their branches are found. If it does not converge, sweeps close the normal gap along the
 * normal elongation and the tangential gap along the tangential one in turns, each within a bracket of its
 * root. Tangent of the pair: Ta (Ta + Tb)^-1 Tb (HybriDFEM, section 2.2).
 */
#pragma once

#include "core/contact/contact-pair.h"

typedef struct QnPairSeries {
  const QnPairSprings *springs;
  const QnPairMemory *committed;
  double q[2];  /* elongation of the pair, m */
  double qa[2]; /* part of q in spring a, m */
  QnSpringResponse a, b;
  double gap[2]; /* N */
  double size;   /* of the gap, relative to the forces and their rounding by q */
} QnPairSeries;

/* The first guess: the increment since the last commit, shared elastically. */
void qn_pair_series_start (QnPairSeries *series, const QnPairSprings *springs,
                           const QnPairMemory *committed, const double q[2]);

void qn_pair_series_step (QnPairSeries *series);

void qn_pair_series_sweep (QnPairSeries *series);

/* (Ta + Tb)^-1, regularised where both springs are without stiffness. */
void qn_pair_series_flexibility (const QnPairSeries *series, double inverse[2][2]);
