/* Capacity curves: a path in large displacements as the curve of a single mass, and the checks of
 * earthquake codes with it.
 *
 * The live load is weight times a horizontal direction, so that multiplier and acceleration go
 * together. delta_i is the horizontal motion of block i in the mechanism: from the peak of the path
 * to where the multiplier has fallen to four fifths of it, or to the end of the path; since the
 * dead load where the path ends at its peak. Blocks take part that move by a tenth of the one
 * that moves most, or by a thousandth with the load: those near the foot of the overturning part. The
 * others only move back elastically. With P_i the weights of those that take part, V the horizontal live
 * load on them at multiplier 1, d_k the displacement of the control block since the dead load:
 *
 *   M* = (sum P_i delta_i)^2 / (g sum P_i delta_i^2)        e* = g M* / sum P_i
 *   d* = d_k sum P_i delta_i^2 / (delta_k sum P_i delta_i)
 *   a* = multiplier V / M*
 *
 * the same transformation in Circolare 7/2019, C8.7.1.2, and in annex B of EN 1998-1, where
 * Gamma = delta_k sum P_i delta_i / sum P_i delta_i^2 and M* = m* Gamma.
 * Explanation and an example by hand: docs/method/capacity.md.
 */
#pragma once

#include "core/capacity/spectrum.h"
#include "core/result/result.h"

typedef struct QnCapacityPoint {
  double multiplier;
  double control;      /* d_k, m, positive along the motion */
  double displacement; /* d*, m */
  double acceleration; /* a*, m/s2 */
} QnCapacityPoint;

/* Virtual work per displacement of the control block, N m per m: of dead loads and ties, which resist, and
 * of the live load at multiplier 1. */
typedef enum { QN_WORK_DEAD, QN_WORK_TIES, QN_WORK_LIVE, QN_WORK_COUNT } QnWork;

typedef struct QnCapacity {
  QnId block; /* of control */
  size_t participating;
  double moving_mass;      /* of the blocks that take part, kg */
  double left_out;         /* of those that do not, but for fixed ones, kg */
  double mass;             /* M*, kg */
  double share;            /* e* */
  double ratio;            /* d* over d_k */
  QnCapacityPoint *points; /* owned; from the dead load to multiplier 0 or the end of the
                              path */
  size_t count, peak;      /* peak: the point of the largest multiplier */
  bool reaches_zero;       /* whether the multiplier comes back to 0 */
  double end;              /* d* of the last point, m: d0* where it does */

  bool kinematic;    /* of a mechanism (core/capacity/kinematic.h), not of a path: */
  double activation; /* alpha0, ties included, */
  double unit;       /* and the acceleration of multiplier 1, m/s2 */
  double works[QN_WORK_COUNT];
  double
    broken; /* d* where ties break and more than half of the largest a* so far is lost, m; 0:
                    nowhere */
  double
    found; /* multiplier of the collapse that the mechanism comes from; NAN: not known */
  struct QnCapacity *
    softer; /* owned: with half the stiffness of all joints, to test periods; NULL: not known */
  double
    elastic_period, /* of small vibrations about the dead load, s, of the mode with the
                             most mass along x, */
    elastic_mass;   /* so much, kg; 0: not known */
} QnCapacity;

/* From a result of displacement control. Refuses live loads that are no horizontal weights, beams,
 * and a control block that does not move. `capacity` is overwritten without being cleared and
 * empty on failure. */
QnStatus qn_capacity_init (QnCapacity *capacity, const QnModel *model,
                           const QnResult *result, QnId control, QnDiag *diag);

void qn_capacity_clear (QnCapacity *capacity);

/* ---- of both sources ---- */

/* Sums of P, P delta and P delta^2, delta along the live load. */
typedef struct QnMassSums {
  double weight, first, second;
} QnMassSums;

static inline void
qn_mass_sums_add (QnMassSums *sums, double weight, double delta)
{
  sums->weight += weight;
  sums->first += weight * delta;
  sums->second += weight * delta * delta;
}

/* Sets M*, e* and the ratio of displacements; `control`: motion of the control block in the same mechanism.
 * False where nothing moves along the load. */
bool qn_capacity_set_masses (QnCapacity *capacity, QnMassSums sums, double control,
                             double gravity);

/* The next point of the curve. Where the multiplier is 0 again after the peak, the curve ends between
 * this point and the one before. `scale`: of the multiplier to a*, m/s2. */
QnCapacityPoint qn_capacity_next_point (QnCapacity *capacity, double multiplier,
                                        double control, double scale);

/* Factor of the weights in the live load, along x. */
double qn_capacity_direction (const QnModel *model);

/* Refuses models without live load or gravity, and beams. */
QnStatus qn_capacity_check_model (const QnModel *model, QnDiag *diag);

/* a* on the curve at a displacement, m/s2. */
double qn_capacity_acceleration (const QnCapacity *capacity, double displacement);

/* Capacity, demand and their ratio at one limit state; displacements are those of the single
 * mass. */
typedef struct QnCapacityState {
  double capacity;     /* m */
  double acceleration; /* a* there, m/s2 */
  double period;       /* of the demand, s, */
  double softer;       /* and with half the stiffness; NaN: not known */
  double demand;       /* m */
  bool refused; /* half the stiffness changes the period by more than a fifth of it */
  double ratio; /* capacity over demand; NaN where refused */
} QnCapacityState;

/* Circolare 7/2019 to NTC 2018, C8.7.1.2, mechanisms at the level of the ground:
 *
 *   SLV   d = 0.4 d0*   T = 1.68 pi sqrt(d/a)
 *   SLC   d = 0.6 d0*   T = 1.56 pi sqrt(d/a)        a = a*(d)/FC
 *
 * FC >= 1: confidence factor; demand S_De(T), of POINTS and of floors the largest of those up to T.
 * Where the path ends before multiplier 0 its end stands for d0*. SLV is at most where ties break and
 * take more than half of the largest a* with them (C8.7.1.2.1.6). */
typedef enum { QN_NTC_SLV, QN_NTC_SLC, QN_NTC_STATE_COUNT } QnNtcState;

QnCapacityState qn_capacity_check_ntc (const QnCapacity *capacity,
                                       const QnSpectrum *spectrum, double confidence,
                                       QnNtcState state);

/* EN 1998-3:2005, C.3, with the demand of EN 1998-1, annex B:
 *
 *   NC   d where the multiplier has fallen to four fifths of its peak, or at the end of the path
 *   SD   three quarters of that
 *
 *   a_y = a* at the peak, d_m = d* there, E the area under the curve up to it
 *   d_y = 2 (d_m - E/a_y)     T = 2 pi sqrt(d_y/a_y)     d_et = S_e(T) (T/2 pi)^2
 *   d_t = d_et                                           T >= TC or a_y >= S_e(T)
 *         d_et/q (1 + (q - 1) TC/T) >= d_et, q = S_e/a_y  otherwise */
typedef enum { QN_EN_SD, QN_EN_NC, QN_EN_STATE_COUNT } QnEnState;

typedef struct QnEnDemand {
  double yield_acceleration; /* a_y, m/s2 */
  double mechanism;          /* d_m, m */
  double energy;             /* E, m2/s2 */
  double yield;              /* d_y, m */
  double period;             /* T, s, */
  double softer;             /* and with half the stiffness; NaN: not known */
  double elastic;            /* d_et, m */
  double q;
  double target; /* d_t, m */
} QnEnDemand;

QnEnDemand qn_capacity_en_demand (const QnCapacity *capacity, const QnSpectrum *spectrum);

QnCapacityState qn_capacity_check_en (const QnCapacity *capacity,
                                      const QnEnDemand *demand, QnEnState state);
