/* What a contact pair does during one step of time.
 *
 * With q the elongation, f(q) the force of the pair by its law from the memory of the step's
 * start, the pair acts on its blocks with
 *
 *   F = (1 - af) f1 + af f0 + c + d
 *
 * c makes of the mean of both ends, (f0 + f1)/2, the mean along the way, so that the work of the pair
 * is the change of its elastic energy and what slip dissipates, whatever the step (Armero & Petocz 1998,
 * Computer Methods in Applied Mechanics and Engineering 158, 269-300, for frictionless contact). q goes
 * evenly from q0 to q1, and with it
 *
 *   x = q_n - opening                 how far the joint stands open; closed where x < 0
 *   n = k_n min (x, 0)
 *   e = t0 + k_t (q_t - q_t0)         the shear force, did nothing slip
 *   S = -mu n                         its strength
 *   t = max (-S, min (e, S))
 *
 * The means of n and t are closed forms, continuous in q1: without that a step, however short, may have
 * no solution. Joints of laws that soften, harden or are crushed go without any c.
 *
 * d is the dashpot that goes with stiffness, k the elastic one. For damping of the initial
 * stiffness d = a k q', always. For damping of the current stiffness it goes with the force of the
 * joint, d = a f', which over a step is
 *
 *   d = a (f1 - f0)/h + a k e (q' - (q1 - q0)/h)
 *
 * where e, 1 while nothing slips or opens within the step, falls to 0 as more does than the joint
 * deforms elastically: e = F/(F + k (|slipped| + |opened|)), F = |n0| + |n1|. In a joint that stays
 * closed and sticks this is a k q'. An open joint has no dashpot; one that slides has that of the
 * friction which its normal dashpot makes.
 *
 * Damping by impact is that of the current stiffness, with a of each pair and a normal dashpot that
 * never pulls: F_n <= 0. The two blocks meet on the spring of the pair with the mass
 *
 *   m = 1/(g' M^-1 g),  g the gradient of q_n,  M of both blocks
 *
 * and half of its critical damping, a = sqrt (m/k), leaves about as much energy as an impact without
 * rebound does: of a block that rocks on its two corners (1 - 1.5 sin^2 alpha)^2 (Housner 1963). More or
 * less of it changes little, but for a dashpot that pulled: it would take a W v more, W the load that
 * leaves one corner for the other with the speed v.
 */
#pragma once

#include "core/contact/contact-pair.h"
#include "core/model/ground-motion.h"

/* What does not change: of both springs of the pair together. */
typedef struct QnPairElasticity {
  double k[2];     /* elastic stiffness, normal and tangential, N/m */
  double friction; /* of the spring that slips first; INFINITY: neither does */
  bool opens;      /* where it is pulled */
  bool bond;       /* may break: then no dashpot goes with what it loses */
  bool conserves;  /* its laws are elastic but for opening and slip: c applies */
} QnPairElasticity;

QnPairElasticity qn_pair_elasticity (const QnPairSprings *springs);

/* Elongation, its rate and the response of a pair at one end of a step. */
typedef struct QnPairInstant {
  double q[2], rate[2]; /* m, m/s */
  const QnPairResponse *response;
} QnPairInstant;

/* The step as pairs see it. */
typedef struct QnPairStep {
  double alpha_f;   /* weight of the start */
  double rate_gain; /* d rate / dq at the end of the step, 1/s */
  double length;    /* of the step, s */
  double damping;   /* a of this pair, s */
  QnDampingStiffness of;
} QnPairStep;

/* What acts besides the law's own forces, N, and the tangent of the whole over (1 - af),
 * dF/dq1 / (1 - af), N/m. */
typedef struct QnPairForces {
  double correction[2]; /* c */
  double dashpot[2];    /* d */
  double tangent[2][2];
} QnPairForces;

QnPairForces qn_pair_motion (const QnPairElasticity *elasticity, const QnPairStep *step,
                             const QnPairInstant *start, const QnPairInstant *end);

/* Which of its branches the pair is on: whether it stands open at either end of the step, and which way
 * it has slipped in it. With the same branch, and the same tangent of its law, its whole tangent
 * changes little from one step to the next. */
int qn_pair_branch (const QnPairElasticity *elasticity, const QnPairInstant *start,
                    const QnPairInstant *end);

/* Whether a pair on that branch neither opens, closes nor slips. */
bool qn_pair_branch_is_still (int branch);

/* Energy that the pair stores, J. */
double qn_pair_elastic_energy (const QnPairElasticity *elasticity,
                               const QnPairInstant *instant);

/* Energy that slip, dilatancy and plastic deformation take from start to end of a step, J, with
 * the forces that the pair had in it. */
double qn_pair_friction (const QnPairElasticity *elasticity, const QnPairForces *forces,
                         const QnPairInstant *start, const QnPairInstant *end);
