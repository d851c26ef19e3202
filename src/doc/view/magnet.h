/* The magnet: the exact place near the pointer.
 *
 * Order: nodes of beams, corners, middles of edges and edges, course lines, grid; within a kind the
 * nearest. The answer includes the kind, for the drawing.
 */
#pragma once

#include "core/model/model.h"

typedef enum {
  QN_MAGNET_NOTHING,
  QN_MAGNET_NODE, /* of beams */
  QN_MAGNET_CORNER,
  QN_MAGNET_MIDDLE, /* of an edge */
  QN_MAGNET_EDGE,
  QN_MAGNET_COURSE, /* height of a bed joint of a wall, beside it */
  QN_MAGNET_GRID
} QnMagnetKind;

typedef struct QnMagnetHit {
  QnMagnetKind kind;
  QnVec2 point; /* m; the given point where kind is NOTHING */
  QnVec2 a, b;  /* EDGE, MIDDLE, COURSE: the line */
} QnMagnetHit;

typedef struct QnMagnet {
  bool enabled;
  double reach; /* m: how far it pulls */
  double grid;  /* m: distance of grid lines; 0: no grid */
} QnMagnet;

/* `skip` (nullable, one flag per block) leaves out blocks that are being moved themselves. */
QnMagnetHit qn_magnet_find (const QnMagnet *magnet, const QnModel *model, QnVec2 point,
                            const int *skip);

/* A round distance (1, 2 or 5 times a power of ten, m) that is at least `least` m. */
double qn_magnet_round_distance (double least);
