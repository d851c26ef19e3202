/* Reinforcing bars: their crossings with contact faces, and the pairs there.
 *
 * A bar may cross a face at any angle. Its pair carries force along the bar alone (no dowel action). A bar
 * through the common end of two faces gives half of its section to each; through the end of one face
 * alone, its whole section. */
#pragma once

#include "core/base/box-tree.h"
#include "core/base/memory.h"
#include "core/contact/contacts.h"

/* Stiffness across a bar / stiffness along it: keeps the pair's tangent regular. */
#define QN_BAR_DOWEL 1e-6

/* The bars of a model, line by line: found by their boxes, since each crosses few of many faces. */
typedef struct QnBarSearch {
  QnBoxTree tree;
  QnId *near;     /* lines at one face, in their own order */
  QnId *bars;     /* bar of each line */
  int32_t *lines; /* number of each line within its bar */
  bool *used;     /* bars */
} QnBarSearch;

/* In memory of the pool. */
void qn_bar_search_init (QnBarSearch *search, const QnModel *model, QnPool *room);

/* Appends the pairs of the bars that cross a face behind its other pairs. */
void qn_bar_search_cross (QnBarSearch *search, const QnModel *model, QnContacts *contacts,
                          QnId face);

/* After all faces: divides bars through ends of faces; refuses bars that cross no face or end outside of
 * all blocks. */
QnStatus qn_bar_search_finish (const QnBarSearch *search, const QnModel *model,
                               QnContacts *contacts, QnDiag *diag);

/* Where a bar crosses a face. */
typedef struct QnBarCrossing {
  QnId pair, bar;
  int32_t line;
  double along; /* m, from the start of the line */
  double reach; /* m: crossings within this distance are one place */
} QnBarCrossing;

/* All crossings, bar by bar, line by line, from start to end: *count of them, to be freed with free().
 * NULL when memory runs out. */
QnBarCrossing *qn_bar_crossings (const QnModel *model, const QnContacts *contacts,
                                 size_t *count);

/* Whether a line meets two faces at one place, and the second one not before the first. */
static inline bool
qn_bar_crossings_meet (const QnBarCrossing *first, const QnBarCrossing *second)
{
  return first->bar == second->bar && first->line == second->line
         && second->along <= first->along + first->reach;
}

/* The force along a bar, N, from that of its pair. */
double qn_bar_axial (const QnContactPair *pair, double normal, double shear);
