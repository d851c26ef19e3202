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
 * The curve alpha(d) is that of the chain as it moves on. C8.7.1.2.1.6 counts actions known to last until
 * collapse: so the curve has ties only if their breaking strain is given. Up to that strain they pull along
 * the line between their moved ends, with the force of core/model/tie.h.
 * docs/method/capacity.md has examples by hand. */
#pragma once

#include "core/capacity/capacity.h"
#include "core/result/mechanism.h"

/* `control`: the block whose centroid is C; QN_NONE: the one that moves furthest along the load.
 * `tie_strain`: elongation over length at which ties break; 0: not known, the curve is without them.
 * Refuses a result without a mechanism of collapse, joints that do more than turn, ties without
 * strength, mechanisms that no weight resists, and what qn_capacity_init() does. `capacity` is
 * overwritten without being cleared and empty on failure. */
QnStatus qn_capacity_init_kinematic (QnCapacity *capacity, const QnModel *model,
                                     const QnContacts *contacts, const QnResult *result,
                                     QnId control, double tie_strain, QnDiag *diag);

/* Circolare 7/2019: a0* = alpha0 g/(e* FC) against the acceleration of the ground or of the floor at the
 * period T0 of the part; 0: it is rigid until it moves.
 *
 *   SLD   a0* >= S_eZ(T0)      C8.7.1.2.1.5, [C8.7.1.8], [C8.7.1.9]
 *   SLV   q a0* >= S_eZ(T0)    C8.7.1.2.1.7, q = 2
 *
 * EN 1998-1:2004, 4.3.5.2, for parts of a building that is z above ground, (4.25), with Ta = T0:
 *
 *   Sa g = S_e(0) (3 (1 + z/H)/(1 + (1 - Ta/T1)^2) - 0.5) >= S_e(0)
 *
 * against alpha0 g/FC; qa of table 4.4 multiplies the ratio. */
#define QN_NTC_BEHAVIOUR_FACTOR 2.0

typedef struct QnLinearCheck {
  double capacity; /* a0*, m/s2 */
  double demand;   /* S_eZ(T0), m/s2 */
  double sld, slv; /* ratios of capacity to demand */
  double
    en_demand; /* Sa g, m/s2, and the ratio with qa = 1; NAN at the level of the ground */
  double en_ratio;
} QnLinearCheck;

QnLinearCheck qn_capacity_check_linear (const QnCapacity *capacity,
                                        const QnSpectrum *spectrum, double confidence,
                                        double period);
