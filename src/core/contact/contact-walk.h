/* Walking along the sides of one block that meet a box. Blocks of few sides are looked through;
 * the others, a ground of thousands of vertices, are asked through the tree. */
#ifndef QN_CORE_CONTACT_WALK_H
#define QN_CORE_CONTACT_WALK_H

#include "core/contact/contact-search.h"

typedef struct QnSideWalk {
  const QnContactSearch *search;
  QnBox box;
  size_t next, end; /* sides still to be looked at */
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
    walk->query = qn_box_tree_query (&search->side_tree, box);
}

/* The next side, or NULL. */
static inline const QnSide *
qn_side_walk_next (QnSideWalk *walk)
{
  const QnSide *sides = walk->search->sides.items;
  QnId item;
  while (walk->by_tree && (item = qn_box_query_next (&walk->query)) != QN_NONE) {
    size_t i = (size_t) walk->search->tree_sides[item];
    if (i >= walk->next && i < walk->end)
      return &sides[i];
  }
  while (!walk->by_tree && walk->next < walk->end) {
    const QnSide *side = &sides[walk->next++];
    if (qn_box_meets (qn_side_box (side), walk->box))
      return side;
  }
  return NULL;
}

#endif
