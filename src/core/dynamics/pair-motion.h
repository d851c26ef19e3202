/* Forces and energies of a contact pair during one step of time.
 *
 * With q the elongation, f(q) the force of the pair by its law from the memory of the step's
 * start, the pair acts on its blocks with
 *
 *   F = (1 - af) f1 + af f0 + c + d
 *
 * c replaces the mean of both ends, (f0 + f1)/2, by the mean along the way, so that for any step the work of
 * the pair equals the change of its elastic energy plus the dissipation of slip (Armero & Petocz 1998,
 * Computer Methods in Applied Mechanics and Engineering 158, 269-300, for frictionless contact). With q
 * linear from q0 to q1,
 *
 *   x = q_n - opening                 how far the joint stands open; closed where x < 0
 *   n = k_n min (x, 0)
 *   e = t0 + k_t (q_t - q_t0)         the shear force without slip
 *   S = -mu n                         its strength
 *   t = max (-S, min (e, S))
 *
 * The means of n and t are closed forms, continuous in q1, without which even a short step may have no
 * solution. c = 0 for joints that soften, harden or are crushed.
 *
 * d is the dashpot, proportional to stiffness; k: elastic stiffness. Damping by the initial stiffness:
 * d = a k q'. Damping by the current stiffness: d = a f', over a step
 *
 *   d = a (f1 - f0)/h + a k e (q' - (q1 - q0)/h)
 *
 * e = F/(F + k (|slipped| + |opened|)), F = |n0| + |n1|: 1 without slip and opening in the step, 0 if they are
 * large against the elastic deformation. A closed joint without slip has d = a k q', an open joint d = 0, a
 * sliding one the friction of its normal dashpot.
 *
 * Damping by impact is that of the current stiffness, with a of each pair and a normal dashpot that
 * never pulls: F_n <= 0. With g the gradient of q_n and M of both blocks
 *
 *   g' M^-1 g = 1/m + 1/j,  of translation and of rotation;  r = m/j, 0.03 <= r <= 3
 *   a = sqrt (2 r/(k (1/m + 1/j)))
 *
 * that is sqrt (r/2) of critical damping of the masses that meet on the spring. At the corner of a rectangle r is
 * 3 sin^2 alpha: slender blocks lose little in an impact, so that rebound matters little, and much to a dashpot
 * while their weight passes from corner to corner; wide ones the other way round. So a block that rocks on its
 * corners keeps (1 - 1.5 sin^2 alpha)^2 of its energy (Housner 1963): docs/method/dynamics.md.
 */
#pragma once

#include "core/contact/contact-pair.h"
#include "core/model/ground-motion.h"

/* Constants of both springs of the pair in series. */
typedef struct QnPairElasticity {
  double k[2];     /* elastic stiffness, normal and tangential, N/m */
  double friction; /* of the spring that slips first; INFINITY: no slip */
  bool opens;      /* under tension */
  bool bond;       /* may break */
  bool conserves;  /* elastic laws with opening and slip alone: c applies */
} QnPairElasticity;

QnPairElasticity qn_pair_elasticity (const QnPairSprings *springs);

/* Elongation, its rate and the response of a pair at one end of a step. */
typedef struct QnPairInstant {
  double q[2], rate[2]; /* m, m/s */
  const QnPairResponse *response;
} QnPairInstant;

typedef struct QnPairStep {
  double alpha_f;   /* weight of the start */
  double rate_gain; /* d rate / dq at the end of the step, 1/s */
  double length;    /* of the step, s */
  double damping;   /* a of this pair, s */
  QnDampingStiffness of;
  const QnPairResponse
    *held; /* where a bond softens: qn_pair_holds_damage(); else NULL */
} QnPairStep;

/* Forces besides those of the law, N; the total at the end of the step, f1 + (c + d) / (1 - af), and the tangent of
 * F / (1 - af), N/m. */
typedef struct QnPairForces {
  double correction[2]; /* c */
  double dashpot[2];    /* d */
  double total[2];
  double tangent[2][2];
} QnPairForces;

/* Whether a bond is damaged further in a step; *held then is the response at its end were it damaged no further,
 * on which dashpots act: a lost force is not one that moves, and no dashpot has a leap where softening begins. */
bool qn_pair_holds_damage (const QnPairSprings *springs, const QnPairMemory *committed,
                           const QnPairInstant *start, const QnPairInstant *end,
                           QnPairResponse *held);

QnPairForces qn_pair_motion (const QnPairElasticity *elasticity, const QnPairStep *step,
                             const QnPairInstant *start, const QnPairInstant *end);

/* Branch of the pair: open or closed at each end of the step, and the sense of slip in it. With equal branch
 * and equal tangent of the law the total tangent changes little from step to step. */
int qn_pair_branch (const QnPairElasticity *elasticity, const QnPairInstant *start,
                    const QnPairInstant *end);

/* Whether a pair on that branch neither opens, closes nor slips. */
bool qn_pair_branch_is_still (int branch);

/* Energy that the pair stores with a force, J. */
double qn_pair_elastic_energy (const QnPairElasticity *elasticity, const double force[2]);

/* Energy dissipated by slip, dilatancy and plastic deformation in a step, J, with the forces of the step. */
double qn_pair_friction (const QnPairElasticity *elasticity, const QnPairForces *forces,
                         const QnPairInstant *start, const QnPairInstant *end);
