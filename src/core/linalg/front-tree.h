/* The plan of a multifrontal factorisation: which unknowns are eliminated together, in which order,
 * and to which later front each adds its rest.
 *
 * Unknowns are eliminated in dense fronts. Of each front a rest stays behind, over the unknowns
 * that its pivots are connected with; it is added to the front's parent, where the first of
 * these is eliminated. So the fronts form a tree, and what a front leaves depends on the
 * subtree below it and on nothing else (Duff & Reid 1983).
 */
#pragma once

#include "core/base/base.h"
#include "core/base/memory.h"

/* Positions: unknowns in the order of elimination. */
typedef struct QnFront {
  int32_t first, pivots; /* positions that it eliminates */
  int32_t rest;          /* number of positions that wait */
  int32_t first_row;     /* its rest in QnFrontTree.rows and .places */
  int32_t parent;        /* QN_NONE: a root */
  int32_t child,
    sibling; /* the first of its children, the next of its parent's; or QN_NONE */
} QnFront;

typedef struct QnFrontTree {
  QnPool pool; /* of all that follows */
  int32_t n;
  QnFront *fronts; /* in postorder: each comes right after the subtrees of its children */
  int32_t front_count;
  int32_t *position; /* n: of each unknown */
  int32_t *rows;     /* positions of the rests, ascending */
  int32_t *places;   /* of the same in the parent: pivots first, then its rest */
} QnFrontTree;

/* Orders and analyses an n x n pattern in compressed columns (ap, n + 1; ai sorted), which must be
 * symmetric. False when memory runs out; _clear is legal then. */
bool qn_front_tree_init (QnFrontTree *tree, int32_t n, const int32_t *ap,
                         const int32_t *ai);

void qn_front_tree_clear (QnFrontTree *tree);
