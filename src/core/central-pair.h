/* One contact pair on the central path: see central-path.h. */
#ifndef QN_CORE_CENTRAL_PAIR_H
#define QN_CORE_CENTRAL_PAIR_H

#include "core/contact-pair.h"

/* Strengths of a pair: cap of the normal force; friction against positive, negative shear. */
enum { QN_CENTRAL_ROWS = 3 };

/* In units of the path: forces F, the largest load of a block; elongations F over the mean
 * stiffness. */
typedef struct QnCentralPair {
  int
    rows; /* strengths that it has: all, the cap alone without any friction, or none: then
               only y and its tangent count */
  double friction, dilatancy;
  double limit[QN_CENTRAL_ROWS];
  double flexibility[2];
  double plastic[2]; /* q_p */

  double y[2], s[QN_CENTRAL_ROWS], z[QN_CENTRAL_ROWS];
  double inverse[2][2]; /* of H: the tangent */

  double inverse_s[QN_CENTRAL_ROWS], inverse_z[QN_CENTRAL_ROWS];

  double strain[2];                 /* residuals: q - q_p - flow z - y / k */
  double strength[QN_CENTRAL_ROWS]; /* h - G y - s */
  double product[QN_CENTRAL_ROWS];  /* what s z is to become */
  double free_strain[2];            /* what of the strain is left for the forces then */
} QnCentralPair;

/* A direction. */
typedef struct QnCentralStep {
  double dy[2], ds[QN_CENTRAL_ROWS], dz[QN_CENTRAL_ROWS];
} QnCentralStep;

/* A pair at its committed state (elongation q and force y, in units of the path), off the
 * boundary of its strength: s z = size everywhere, and s - z what strength is left, or how far
 * it has opened. Pairs of other laws get no rows. force, length: the units, N and m. */
void qn_central_pair_start (QnCentralPair *pair, const QnPairSprings *springs,
                            const QnPairMemory *memory, const double q[2],
                            const double y[2], double force, double length, double size);

/* Residuals and tangent at elongation q. */
void qn_central_pair_prepare (QnCentralPair *pair, const double q[2]);

/* out = flow z */
void qn_central_pair_flow (const QnCentralPair *pair, const double z[QN_CENTRAL_ROWS],
                           double out[2]);

/* Takes up `product`, and gives the change of the force if no block moved. */
void qn_central_pair_aim (QnCentralPair *pair, double dy[2]);

/* The whole direction under a rate of elongation, with
 *
 *   dy = H \ (rate + what of the strain is left for the forces)
 *
 * Returns how fast it leads to the boundary: s or z vanishes after one over so many steps. */
double qn_central_pair_complete (const QnCentralPair *pair, const double rate[2],
                                 QnCentralStep *step);

#endif
