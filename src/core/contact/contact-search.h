/* The steps of contact detection, and what they share: tolerances, sides. */
#pragma once

#include "core/base/box-tree.h"
#include "core/contact/contact-side.h"
#include "core/contact/contacts.h"

typedef struct QnContactLengths {
  double tolerance; /* m: sides within this distance touch */
  double gap_limit; /* m: gaps up to this width are reported */
  double
    overlap_limit; /* m: overlaps up to this depth are reported, deeper ones refused */
} QnContactLengths;

/* The lengths that follow from a prepared model's settings, block sizes and coordinates. */
QnContactLengths qn_contact_lengths (const QnModel *model);

/* Blocks with more sides than this are searched through a tree of their sides. */
#define QN_FEW_SIDES 32

typedef struct QnContactSearch {
  const QnModel *model; /* borrowed */
  QnContactLengths lengths;
  QnPool *room; /* of all below; whether memory ran out */

  QnSides sides;
  QnBox *block_boxes;
  bool *convex; /* per block */
  QnBoxTree block_tree;

  /* Tree of the sides of each block, empty up to QN_FEW_SIDES; NULL if all are empty. */
  QnBoxTree *side_trees;
} QnContactSearch;

static inline QnBox
qn_side_box (const QnSide *side)
{
  return qn_box_of_segment (side->start, side->end);
}

/* `search` is overwritten. Lack of memory anywhere below is told by the pool alone: what is found then is
 * not all. */
void qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                             QnContactLengths lengths, QnPool *room);

/* Iterator over the sides of one block that meet a box: compares all sides up to QN_FEW_SIDES, uses the
 * tree above. */
typedef struct QnSideWalk {
  const QnContactSearch *search;
  QnBox box;
  size_t next, end; /* remaining sides */
  bool by_tree;
  QnBoxQuery query;
} QnSideWalk;

static inline size_t
qn_side_count (const QnContactSearch *search, QnId block)
{
  return search->sides.first[block + 1] - search->sides.first[block];
}

static inline void
qn_side_walk_start (QnSideWalk *walk, const QnContactSearch *search, QnId block,
                    QnBox box)
{
  walk->search = search;
  walk->box = box;
  walk->next = search->sides.first[block];
  walk->end = search->sides.first[block + 1];
  walk->by_tree = walk->end - walk->next > QN_FEW_SIDES;
  if (walk->by_tree)
    walk->query = qn_box_tree_query (&search->side_trees[block], box);
}

/* The next side, or NULL. */
static inline const QnSide *
qn_side_walk_next (QnSideWalk *walk)
{
  const QnSide *sides = walk->search->sides.items;
  QnId item;
  if (walk->by_tree && (item = qn_box_query_next (&walk->query)) != QN_NONE)
    return &sides[walk->next + (size_t) item];
  while (!walk->by_tree && walk->next < walk->end) {
    const QnSide *side = &sides[walk->next++];
    if (qn_box_meets (qn_side_box (side), walk->box))
      return side;
  }
  return NULL;
}

/* ---- broad phase: pairs of blocks whose boxes meet ---- */

/* Largest numbers of overlapping pairs of blocks, and of pairs with common boxes, that are searched. A
 * structure laid over itself has fewer overlaps, a thousand oblique parallel slabs fewer common boxes. */
#define QN_MOST_OVERLAPS(blocks)   (10000 + 4 * (size_t) (blocks))
#define QN_MOST_NEIGHBOURS(blocks) (2000000 + 100 * (size_t) (blocks))

/* Finds faces, then gaps, overlaps and point contacts, each kind of finding sorted by blocks. Refuses
 * TOO_MANY_NEIGHBOURS and TOO_MANY_OVERLAPS. */
QnStatus qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts,
                                QnDiag *diag);

/* ---- narrow phase: common stretches of the sides of two blocks; overlaps ---- */

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

/* Appends the faces (without pairs) of blocks a < b in their final order, their gaps, and the
 * touches that lie on no common face of the two. */
void qn_contact_match_pair (const QnContactSearch *search, QnId a, QnId b,
                            QnContactMatches *matches, QnContacts *contacts,
                            QnTouches *touches);

typedef struct QnContactCuts {
  double *items;
  size_t count, capacity;
} QnContactCuts;

/* Appends a finding if blocks a < b overlap. */
void qn_contact_check_overlap (const QnContactSearch *search, QnId a, QnId b,
                               QnContactCuts *cuts, QnFindings *findings);

/* ---- laws and pairs of the faces; blocks that nothing holds ---- */

/* Sets laws and pairs of every face; pairs of bars follow those of the joint. Refuses bars that cross no
 * face, joints by material between two rigid sides, and springs that snap back while they soften. */
QnStatus qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts,
                                  QnDiag *diag);

/* Appends findings for blocks that touch at a point only; overlaps must be found before. */
void qn_contact_search_points (const QnContactSearch *search, QnContacts *contacts,
                               const QnTouches *touches);

/* Appends findings for blocks without contact and for blocks not connected to a support. */
void qn_contacts_report_loose (const QnModel *model, QnContacts *contacts);

void qn_contacts_report (QnContacts *contacts, QnFinding finding);

/* The same, by its members. */
static inline void
qn_contacts_tell (QnContacts *contacts, QnProblem problem, QnId a, QnId b, QnId subject,
                  QnVec2 at, double value)
{
  qn_contacts_report (contacts, (QnFinding){ problem, a, b, at, value, subject, NULL });
}

/* Room for so many pairs more; false where there is none. */
bool qn_contacts_reserve_pairs (QnContacts *contacts, size_t count);
