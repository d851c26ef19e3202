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

  double strain[2];                 /* residuals: q - q_p - flow z - y / k */
  double strength[QN_CENTRAL_ROWS]; /* h - G y - s */
  double product[QN_CENTRAL_ROWS];  /* what s z is to become */
  double dy[2], ds[QN_CENTRAL_ROWS], dz[QN_CENTRAL_ROWS];
} QnCentralPair;

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

/* The change of the force, dy = H \ (rate + what of the strain is left for the forces), under a
 * rate of elongation. */
void qn_central_pair_change_of_force (const QnCentralPair *pair, const double rate[2],
                                      double dy[2]);

/* The whole direction, dy, ds and dz. */
void qn_central_pair_complete (QnCentralPair *pair, const double rate[2]);

#endif
