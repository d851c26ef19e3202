/* Shared by the steps of contact detection: tolerances, sides, broad phase. */
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

/* `search` is overwritten without being cleared. */
QnStatus qn_contact_search_init (QnContactSearch *search, const QnModel *model,
                                 QnContactLengths lengths, QnDiag *diag);

void qn_contact_search_clear (QnContactSearch *search);

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
