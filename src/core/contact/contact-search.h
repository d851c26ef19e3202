/* What the steps of contact detection share: lengths that count, sides, broad phase. */
#ifndef QN_CORE_CONTACT_SEARCH_H
#define QN_CORE_CONTACT_SEARCH_H

#include "core/base/box-tree.h"
#include "core/contact/contact-side.h"
#include "core/contact/contacts.h"

typedef struct QnContactLengths {
  double tolerance;     /* m: what is closer touches */
  double gap_limit;     /* m: gaps up to here are reported */
  double overlap_limit; /* m: overlaps up to here are reported, deeper ones refused */
} QnContactLengths;

/* The lengths that follow from a prepared model's settings, block sizes and coordinates. */
QnContactLengths qn_contact_lengths (const QnModel *model);

/* Blocks with more sides than this are searched through a tree of their sides. */
#define QN_FEW_SIDES 32

typedef struct QnContactSearch {
  const QnModel *model; /* borrowed */
  QnContactLengths lengths;

  QnSides sides;
  QnBox *block_boxes;
  bool *convex; /* per block */
  QnBoxTree block_tree;

  /* Sides of blocks that have too many to be looked through; empty where there are none. */
  QnBoxTree side_tree;
  QnId *tree_sides; /* into sides.items, by item of the tree */
} QnContactSearch;

static inline QnBox
qn_side_box (const QnSide *side)
{
  return qn_box_of_segment (side->start, side->end);
}

/* `search` is overwritten without being cleared. */
QnStatus qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                                 QnContactLengths lengths, QnDiag *diag);

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

/* Room that a search of pairs of blocks needs again and again. */
typedef struct QnContactMatches {
  struct QnContactMatch *items;
  size_t count, capacity;
} QnContactMatches;

typedef struct QnContactCuts {
  double *items;
  size_t count, capacity;
} QnContactCuts;

/* Appends the faces (without pairs) of blocks a < b in their final order, their gaps, and the
 * touches that lie on no common face of the two. False when memory runs out. In
 * contact-faces.c. */
bool qn_contact_match_pair (const QnContactSearch *search, QnId a, QnId b,
                            QnContactMatches *matches, QnContacts *contacts,
                            QnTouches *touches);

/* Appends a finding if blocks a < b overlap; false when memory runs out. In
 * contact-overlaps.c. */
bool qn_contact_check_overlap (const QnContactSearch *search, QnId a, QnId b,
                               QnContactCuts *cuts, QnFindings *findings);

/* Appends findings for blocks that touch at a point only; overlaps must be found before. */
QnStatus qn_contact_search_points (const QnContactSearch *search, QnContacts *contacts,
                                   const QnTouches *touches, QnDiag *diag);

/* All that pairs of blocks have to do with each other. Findings come kind by kind
 * (gaps, overlaps, points), each kind sorted by blocks. */
QnStatus qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts,
                                QnDiag *diag);

/* Gives every face its laws and pairs, by the model's rules and exceptions. */
QnStatus qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts,
                                  QnDiag *diag);

/* Appends findings for blocks that touch nothing or hang on nothing. */
QnStatus qn_contacts_report_loose (const QnModel *model, QnContacts *contacts,
                                   QnDiag *diag);

/* These two, which the search of pairs leaves to be done; `contacts` is cleared on failure. */
QnStatus qn_contacts_complete (const QnModel *model, QnContacts *contacts, QnDiag *diag);

/* Adds the pairs of the bars that cross a face, behind the face's own, and marks the bars
 * (model->bar_count flags). In contact-bars.c. */
QnStatus qn_contacts_add_bars (const QnModel *model, QnContacts *contacts, QnId face,
                               bool *used, QnDiag *diag);

/* Refuses different bases on the two sides of a face, and springs that would snap back while
 * they soften. In pair-springs.c. */
QnStatus qn_contacts_check_springs (const QnModel *model, const QnContacts *contacts,
                                    QnId face, QnDiag *diag);

#endif
