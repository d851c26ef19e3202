/* Nested dissection by place (George 1973; Heath & Raghavan 1995): a structure is cut in half, what
 * touches the cut is eliminated after both halves, and these are cut in turn. The factor of a wall of n
 * blocks has some n log n entries then, where minimum degree has more the larger n is. */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

/* A graph in the plane: the neighbours of node k are next[start[k]] up to next[start[k + 1]],
 * symmetric, the nodes themselves left out. */
typedef struct QnPlaneGraph {
  int32_t count;
  const int32_t *start, *next;
  const QnVec2 *points; /* of the nodes */
} QnPlaneGraph;

/* set[k]: nodes of a lower set are to be eliminated before those of a higher one; numbered from 0
 * without gaps. False when memory runs out. */
bool qn_dissect (const QnPlaneGraph *graph, int32_t *set);
