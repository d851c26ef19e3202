/* Sets of items that are joined one after the other: a forest in an array of parents. The root of
 * a set is its least item. Source: Tarjan and van Leeuwen, "Worst-case analysis of set union
 * algorithms" (1984), path halving. */
#pragma once

#include "core/base/base.h"

/* Every item alone. */
static inline void
qn_sets_init (QnId *parents, size_t count)
{
  for (size_t i = 0; i < count; i++)
    parents[i] = (QnId) i;
}

static inline QnId
qn_sets_root (QnId *parents, QnId item)
{
  while (parents[item] != item)
    item = parents[item] = parents[parents[item]];
  return item;
}

static inline void
qn_sets_join (QnId *parents, QnId a, QnId b)
{
  a = qn_sets_root (parents, a);
  b = qn_sets_root (parents, b);
  parents[a > b ? a : b] = a > b ? b : a;
}
