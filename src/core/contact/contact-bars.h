/* Reinforcing bars: where they cross contact faces, and the pairs that they make there.
 *
 * A bar may cross a face at any angle. Its pair carries force along the bar alone: there is no dowel
 * action. A bar that goes through an end of a face, as one between two rows of cells does, has half of
 * its section in the faces on either side of it, or all in those on one side where there are no others. */
#pragma once

#include "core/base/box-tree.h"
#include "core/contact/contacts.h"

/* Stiffness across a bar over that along it: next to nothing, but for arithmetic. */
#define QN_BAR_DOWEL 1e-6

/* The bars of a model, line by line: found by their boxes, since each crosses few of many faces. */
typedef struct QnBarSearch {
  QnBoxTree tree;
  QnId *near;     /* lines at one face, in their own order */
  QnId *bars;     /* of each line, */
  int32_t *lines; /* and which of its lines it is */
  bool *used;     /* bars */
} QnBarSearch;

/* Fails for lack of memory alone; to be cleared then too. */
QnStatus qn_bar_search_init (QnBarSearch *search, const QnModel *model, QnDiag *diag);
void qn_bar_search_clear (QnBarSearch *search);

/* Adds the pairs of the bars that cross a face; its other pairs are there already. */
QnStatus qn_bar_search_cross (QnBarSearch *search, const QnModel *model,
                              QnContacts *contacts, QnId face, QnDiag *diag);

/* Once all faces are done: shares bars that go through ends of faces, and refuses those that cross no
 * face, and those that end outside of all blocks. */
QnStatus qn_bar_search_finish (const QnBarSearch *search, const QnModel *model,
                               QnContacts *contacts, QnDiag *diag);

/* Where a bar crosses a face. */
typedef struct QnBarCrossing {
  QnId pair, bar;
  int32_t line;
  double along; /* m, from the start of the line */
  double reach; /* m: what is nearer is at the same place */
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
