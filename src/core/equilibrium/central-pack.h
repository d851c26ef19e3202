/* The arithmetic of contact pairs on the central path, eight pairs at a time: see central-path.h.
 *
 * Every quantity of eight pairs stands side by side. The loops work on as many of them at a time as
 * the processor has room for, in the same order everywhere: results are equal to the bit.
 */
#pragma once

#include "core/base/base.h"

/* Strengths of a pair: limit of tension; friction against positive and negative shear; limit of
 * compression. */
enum { QN_CENTRAL_ROWS = 4, QN_CENTRAL_WIDTH = 8 };

typedef double QnPackVector[QN_CENTRAL_WIDTH];
typedef int64_t QnPackMask[QN_CENTRAL_WIDTH];

/* Forces, strengths left and flows; or a direction of all three. */
typedef struct QnCentralState {
  QnPackVector y[2], s[QN_CENTRAL_ROWS], z[QN_CENTRAL_ROWS];
} QnCentralState;

/* In units of the path: forces F, the largest load of a block; elongations F over the mean
 * stiffness. Strengths that a pair lacks have s = 1 and z = 0, and stay so. */
typedef struct QnCentralPack {
  /* All ones where the pair has that strength. Without a limit of tension it has none of them: only
   * y and its tangent count. */
  QnPackMask has_tension, has_shear, has_compression;
  QnPackVector friction,
    dilatancy[2]; /* of slip in the positive sense, in the negative */
  QnPackVector tension, cohesion, compression; /* h, by rows; cohesion twice */
  QnPackVector flexibility[2];
  QnPackVector plastic[2]; /* q_p */

  QnCentralState now;
  QnPackVector inverse[4]; /* of H, by rows: the tangent */

  QnPackVector inverse_s[QN_CENTRAL_ROWS], inverse_z[QN_CENTRAL_ROWS];

  QnPackVector strain[2];                 /* residuals: q - q_p - flow z - y / k */
  QnPackVector strength[QN_CENTRAL_ROWS]; /* h - G y - s */
  QnPackVector product[QN_CENTRAL_ROWS];  /* what s z is to become */
  QnPackVector gain[QN_CENTRAL_ROWS]; /* what of the strength the direction is to find */
  QnPackVector free_strain[2];        /* what of the strain is left for the forces then */
} QnCentralPack;

/* The largest of all pairs, in units of the path, and a sum. */
typedef struct QnCentralResiduals {
  double strain, strength; /* residuals */
  double elongation;       /* apart from the plastic one at the beginning */
  double force;
  double products; /* sum of s z */
} QnCentralResiduals;

/* What a direction leads to: s or z of some pair vanishes after one over `boundary` of it, and the
 * sum of s z after a part p of it is products + p first + p^2 second. */
typedef struct QnCentralForecast {
  double boundary, first, second;
} QnCentralForecast;

/* What products are asked for. */
typedef enum {
  QN_CENTRAL_NOTHING,      /* zero */
  QN_CENTRAL_SECOND_ORDER, /* the mean, less what the last direction misses it by */
  QN_CENTRAL_CENTRE /* that the next step's be within `spread` times the mean either way */
} QnCentralTarget;

typedef struct QnCentralAim {
  QnCentralTarget target;
  double part; /* of the residuals that is to vanish */
  double mean;
  double length, spread; /* of CENTRE */
} QnCentralAim;

/* The loops for one kind of processor, over `count` times eight pairs. Elongations and forces of
 * pairs are numbers (normal, tangential) one pair after the other, tangents 2 x 2 by rows. */
typedef struct QnCentralLoops {
  /* Residuals and tangent at elongations in m; `shrink`: the unit of the path over m. */
  QnCentralResiduals (*prepare) (QnCentralPack *packs, size_t count,
                                 const double *elongations, double shrink);

  /* Sets the products, from the last direction and the last products where need be, and gives the
   * forces that the pairs would exert if no block moved, times `force`. */
  void (*aim) (QnCentralPack *packs, const QnCentralState *steps, size_t count,
               const QnCentralAim *aim, double force, double *forces);

  /* The forces as they are, times `force`. */
  void (*forces) (const QnCentralPack *packs, size_t count, double force, double *forces);

  /* The tangents, times `stiffness`. */
  void (*tangents) (const QnCentralPack *packs, size_t count, double stiffness,
                    double *tangents);

  /* The whole direction under rates of elongation,
   *
   *   dy = H \ (rate + what of the strain is left for the forces)  */
  QnCentralForecast (*complete) (const QnCentralPack *packs, size_t count,
                                 const double *rates, double shrink,
                                 QnCentralState *steps);

  /* Goes a part of the direction. */
  void (*go) (QnCentralPack *packs, const QnCentralState *steps, size_t count,
              double part);
} QnCentralLoops;

/* The fastest loops for this processor that work on at most `width` numbers at a time. */
const QnCentralLoops *qn_central_loops (int width);
