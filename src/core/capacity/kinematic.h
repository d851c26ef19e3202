/* Mechanisms by code: the kinematic analysis of parts that turn about hinges, as a capacity curve.
 *
 * The bodies are those of a mechanism that was found (core/result/mechanism.h). They keep together at
 * its hinges, as they were built, and where blocks are held; no law of a joint is used. With the
 * velocities delta of this chain, the dead loads F, weights among them, the ties' strengths N, their
 * rates of elongation e > 0, and P = seismic weights, the horizontal live loads over the factor of the
 * weights, Circolare 7/2019 to NTC 2018 has
 *
 *   alpha0 = (- sum F delta + sum N e) / sum P delta_x                    [C8.7.1.1]
 *   e*, M*, d* of P and delta_x as in capacity.h                          [C8.7.1.4, C8.7.1.5]
 *   a*(d) = alpha(d) g / e*                                               [C8.7.1.3]
 *
 * The curve alpha(d) is that of the chain as it moves on, without ties: C8.7.1.2.1.6 counts what is
 * known to act until collapse, and a tie has no elongation here at which it breaks.
 * docs/method/capacity.md has examples by hand. */
#pragma once

#include "core/capacity/capacity.h"
#include "core/result/mechanism.h"

/* `control`: the block whose centroid is C; QN_NONE: the one that moves furthest along the load.
 * Refuses a result without a mechanism of collapse, joints that do more than turn, ties without
 * strength, mechanisms that no weight resists, and what qn_capacity_init() does. `capacity` is
 * overwritten without being cleared and empty on failure. */
QnStatus qn_capacity_init_kinematic (QnCapacity *capacity, const QnModel *model,
                                     const QnContacts *contacts, const QnResult *result,
                                     QnId control, QnDiag *diag);

/* Circolare 7/2019, for mechanisms at the level of the ground: a0* = alpha0 g/(e* FC) against the
 * largest acceleration of the ground, S_e(0).
 *
 *   SLD   a0* >= S_e(0)      C8.7.1.2.1.5, [C8.7.1.8]
 *   SLV   q a0* >= S_e(0)    C8.7.1.2.1.7, q = 2 */
#define QN_NTC_BEHAVIOUR_FACTOR 2.0

typedef struct QnLinearCheck {
  double capacity; /* a0*, m/s2 */
  double demand;   /* S_e(0), m/s2 */
  double sld, slv; /* ratios of capacity to demand */
} QnLinearCheck;

QnLinearCheck qn_capacity_check_linear (const QnCapacity *capacity,
                                        const QnSpectrum *spectrum, double confidence);
