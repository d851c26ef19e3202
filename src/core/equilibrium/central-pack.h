/* The arithmetic of contact pairs on the central path, eight pairs at a time: see central-path.h.
 *
 * Each quantity of eight pairs is contiguous. The loops process as many at a time as the SIMD registers
 * hold; the order of operations, and so every bit of the results, is the same on all processors.
 */
#pragma once

#include "core/base/base.h"

/* Strengths of a pair: limit of tension; friction against positive and negative shear; limit of
 * compression. */
enum { QN_CENTRAL_ROWS = 4, QN_CENTRAL_WIDTH = 8 };

typedef double QnPackVector[QN_CENTRAL_WIDTH];
typedef int64_t QnPackMask[QN_CENTRAL_WIDTH];

/* Forces y, remaining strengths s and flows z; or a direction of all three. */
typedef struct QnCentralState {
  QnPackVector y[2], s[QN_CENTRAL_ROWS], z[QN_CENTRAL_ROWS];
} QnCentralState;

/* Units: force F, the largest load of a block; length F over the mean stiffness. Rows of strengths that a
 * pair does not have keep s = 1 and z = 0. */
typedef struct QnCentralPack {
  /* All bits set: the pair has this strength. A pair without limit of tension has no other limit and uses
   * only y and its tangent. */
  QnPackMask has_tension, has_shear, has_compression;
  QnPackVector friction, dilatancy[2]; /* dilatancy for positive and negative slip */
  QnPackVector tension, cohesion, compression; /* h, by rows; cohesion twice */
  QnPackVector flexibility[2];
  QnPackVector plastic[2]; /* q_p */

  QnCentralState now;
  QnPackVector inverse[4]; /* of H, by rows: the tangent */

  QnPackVector inverse_s[QN_CENTRAL_ROWS], inverse_z[QN_CENTRAL_ROWS];

  QnPackVector strain[2];                 /* residuals: q - q_p - flow z - y / k */
  QnPackVector strength[QN_CENTRAL_ROWS]; /* h - G y - s */
  QnPackVector product[QN_CENTRAL_ROWS];  /* target of s z */
  QnPackVector gain[QN_CENTRAL_ROWS]; /* part of `strength` to be removed by the step */
  QnPackVector free_strain[2];        /* strain to be removed less flow at free forces */
} QnCentralPack;

/* Maxima over all pairs in units of the path, and one sum. */
typedef struct QnCentralResiduals {
  double strain, strength; /* residuals */
  double elongation;       /* q - q_p */
  double force;
  double products; /* sum of s z */
} QnCentralResiduals;

/* Forecast of a direction: the first s or z vanishes at the part 1 / `boundary` of it; the sum of s z at
 * the part p is products + p first + p^2 second. */
typedef struct QnCentralForecast {
  double boundary, first, second;
} QnCentralForecast;

/* Targets of the products s z. */
typedef enum {
  QN_CENTRAL_NOTHING,      /* zero */
  QN_CENTRAL_SECOND_ORDER, /* `mean` less the second-order term of the last direction */
  QN_CENTRAL_CENTRE /* products after the step within [mean / spread, mean x spread] */
} QnCentralTarget;

typedef struct QnCentralAim {
  QnCentralTarget target;
  double part; /* of the residuals to be removed */
  double mean;
  double length, spread; /* of CENTRE */
} QnCentralAim;

/* The loops for one kind of processor, over `count` times eight pairs. Elongations and forces of
 * pairs are numbers (normal, tangential) one pair after the other, tangents 2 x 2 by rows. */
typedef struct QnCentralLoops {
  /* Residuals and tangent at elongations in m; `shrink`: the unit of the path over m. */
  QnCentralResiduals (*prepare) (QnCentralPack *packs, size_t count,
                                 const double *elongations, double shrink);

  /* Sets the targets, from the last direction and targets where the aim needs them; `forces`: forces of
   * the pairs if no block moved, times `force`. */
  void (*aim) (QnCentralPack *packs, const QnCentralState *steps, size_t count,
               const QnCentralAim *aim, double force, double *forces);

  /* The present forces, times `force`. */
  void (*forces) (const QnCentralPack *packs, size_t count, double force, double *forces);

  /* The tangents, times `stiffness`. */
  void (*tangents) (const QnCentralPack *packs, size_t count, double stiffness,
                    double *tangents);

  /* The direction under rates of elongation: dy = H \ (rate + free_strain), then ds and dz. */
  QnCentralForecast (*complete) (const QnCentralPack *packs, size_t count,
                                 const double *rates, double shrink,
                                 QnCentralState *steps);

  /* now += part x direction. */
  void (*go) (QnCentralPack *packs, const QnCentralState *steps, size_t count,
              double part);
} QnCentralLoops;

/* The fastest loops of this processor with at most `width` doubles per vector. */
const QnCentralLoops *qn_central_loops (int width);
