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

#include "core/result/mechanism.h"
#include "core/result/result.h"

/* ---- spectra ---- */

/* Elastic response spectra of the horizontal acceleration of the ground.
 *
 * EN_1 and EN_2 are the recommended ones of type 1 and 2 of EN 1998-1:2004, 3.2.2.2 and tables 3.2
 * and 3.3: with the ground acceleration ag, the soil's S, TB, TC, TD and
 * eta = sqrt(10/(5 + 100 damping)) >= 0.55
 *
 *   Se = ag S (1 + T/TB (2.5 eta - 1))    T <= TB
 *        ag S 2.5 eta                     TB <= T <= TC
 *        ag S 2.5 eta TC/T                TC <= T <= TD
 *        ag S 2.5 eta TC TD/T^2           TD <= T
 *
 * Type 1 beyond TE by annex A: the displacement falls linearly from 2.5 eta dg at TE to
 * dg = 0.025 ag S TC TD at TF = 10 s. Type 2 has no such branch.
 *
 * POINTS are joined by straight lines; before the first period the acceleration is that of the
 * first point, after the last one the displacement that of the last.
 *
 * Above ground, Circolare 7/2019 to NTC 2018, C7.2.3, for the first mode of the building, which is
 * linear over its height and normalised at its top:
 *
 *   gamma = 3n/(2n + 1)   psi = z/H                                                    [C7.2.10]
 *   aZ    = Se(T1, xi1) gamma psi sqrt(1 + 4 xi1^2)                           [C7.2.7], [C7.2.8]
 *   A     = 1.1 xi1^-0.5 eta(xi)                                              [C7.2.6], [C7.2.9]
 *   SeZ   = A aZ / (1 + (A - 1) (1 - T/(a T1))^1.6)    T <= a T1, a = 0.8
 *           A aZ                                       a T1 <= T <= b T1, b = 1.1
 *           A aZ / (1 + (A - 1) (T/(b T1) - 1)^1.2)    b T1 <= T
 *
 * xi1 is a ratio here. The code calls it a percentage: 0.0004 xi1^2 of [C7.2.7] is 4 xi1^2, but
 * 5^-0.5 in [C7.2.6] would make the peak of [C7.2.9] lower than SeZ(0) = aZ. SeZ is at least Se(T);
 * the code asks for that beyond T1, but one mode alone says too little near the ground.
 */
typedef enum {
  QN_SPECTRUM_EN_1,
  QN_SPECTRUM_EN_2,
  QN_SPECTRUM_POINTS,
  QN_SPECTRUM_KIND_COUNT
} QnSpectrumKind;

typedef enum {
  QN_SOIL_A,
  QN_SOIL_B,
  QN_SOIL_C,
  QN_SOIL_D,
  QN_SOIL_E,
  QN_SOIL_COUNT
} QnSoil;

/* Where the part stands in a building; all 0: at the level of the ground. */
typedef struct QnFloor {
  double height;   /* z, above the foundation, m */
  double building; /* H, of the building, m, >= z */
  int storeys;     /* n, >= 1 */
  double period;   /* T1, of the building, s, > 0 */
  double damping;  /* xi1, of the building, ratio, > 0 */
} QnFloor;

typedef struct QnSpectrum {
  QnSpectrumKind kind;
  double ground_acceleration; /* ag, m/s2, > 0; the importance factor included */
  QnSoil soil;
  double damping; /* ratio, 0.05 as a rule; of POINTS what they were made for */
  const QnVec2
    *points;          /* of POINTS, borrowed: period, s; acceleration, m/s2; ascending */
  size_t point_count; /* >= 1 */
  QnFloor floor;
} QnSpectrum;

/* Spectral acceleration, m/s2, of the floor where there is one, and displacement Se (T/2 pi)^2, m, at a
 * period >= 0 s. */
double qn_spectrum_acceleration (const QnSpectrum *spectrum, double period);
double qn_spectrum_displacement (const QnSpectrum *spectrum, double period);

/* The largest displacement at this period, at those of the points before it, for straight lines between
 * points that lie far apart would have larger ones, and at b T1 of the building, [C8.7.1.12]. */
double qn_spectrum_largest_displacement (const QnSpectrum *spectrum, double period);

/* TC, where the range of constant acceleration ends, s. Of POINTS 2 pi times the largest
 * pseudo-velocity over the largest acceleration, which is TC where they are those of EN 1998-1. */
double qn_spectrum_corner (const QnSpectrum *spectrum);

/* ---- curves ---- */

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

  bool kinematic;    /* of a mechanism (kinematic.c), not of a path: */
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

/* ---- mechanisms by code (kinematic.c) ---- */

/* Mechanisms by code: the kinematic analysis of parts that turn about hinges, as a capacity curve.
 *
 * The bodies are those of a mechanism that was found (core/result/mechanism.h). They keep together at
 * its hinges, as they were built, and where blocks are held; no law of a joint is used. With the
 * velocities delta of this chain, the dead loads F, weights among them, the ties' strengths N, their
 * rates of elongation e > 0, and P = seismic weights, the horizontal live loads over the factor of the
 * weights, Circolare 7/2019 to NTC 2018 has
 *
 *   alpha0 = (- sum F delta + sum N e) / sum P delta_x                    [C8.7.1.1]
 *   e*, M*, d* of P and delta_x as above                                 [C8.7.1.4, C8.7.1.5]
 *   a*(d) = alpha(d) g / e*                                               [C8.7.1.3]
 *
 * The curve alpha(d) is that of the chain as it moves on. C8.7.1.2.1.6 counts actions known to last until
 * collapse: so the curve has ties only if their breaking strain is given. Up to that strain they pull along
 * the line between their moved ends, with the force of core/model/tie.h.
 * docs/method/capacity.md has examples by hand. */
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
