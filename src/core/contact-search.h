/* What the steps of contact detection share: lengths that count, sides, broad phase. */
#ifndef QN_CORE_CONTACT_SEARCH_H
#define QN_CORE_CONTACT_SEARCH_H

#include "core/box-tree.h"
#include "core/contact-side.h"
#include "core/contacts.h"

typedef struct QnContactSearch {
  const QnModel *model; /* borrowed */
  double tolerance;     /* m: what is closer touches */
  double gap_limit;     /* m: gaps up to here are worth a word */
  double
    overlap_limit; /* m: overlaps up to here are worth a word, deeper ones an error */

  QnSides sides;
  QnBox *side_boxes;
  QnBox *block_boxes;
  bool *convex; /* per block */
  QnBoxTree side_tree, block_tree;
} QnContactSearch;

/* `search` is overwritten without being cleared. */
QnStatus qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                                 QnDiag *diag);

void qn_contact_search_clear (QnContactSearch *search);

/* A place where a corner of one block lies on the boundary of another one. */
typedef struct QnTouch {
  QnId a, b; /* a < b */
  QnVec2 at;
} QnTouch;

typedef struct QnTouches {
  QnTouch *items; /* owned; sorted by (a, b) */
  size_t count, capacity;
} QnTouches;

/* Appends the faces (without pairs) in their final order, the gaps to contacts->findings, and
 * the touches that lie on no common face of the two blocks. */
QnStatus qn_contact_search_faces (const QnContactSearch *search, QnContacts *contacts,
                                  QnTouches *touches, QnDiag *diag);

/* Appends findings for blocks that overlap. */
QnStatus qn_contact_search_overlaps (const QnContactSearch *search, QnFindings *findings,
                                     QnDiag *diag);

/* Appends findings for blocks that touch at a point only, touch nothing, or hang on nothing. */
QnStatus qn_contact_search_loose (const QnContactSearch *search, QnContacts *contacts,
                                  const QnTouches *touches, QnDiag *diag);

/* Gives every face its laws and pairs, by the model's rules and exceptions. */
QnStatus qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts,
                                  QnDiag *diag);

#endif
