/* Unit weights of typical stone and masonry, with where they come from. */
#pragma once

typedef struct QnTypicalStone {
  const char *name;   /* to be translated */
  double unit_weight; /* N/m3: the middle of the range that the source gives */
  const char *source; /* with that range; to be translated */
} QnTypicalStone;

enum { QN_STONE_COUNT = 8 };

extern const QnTypicalStone qn_typical_stones[QN_STONE_COUNT];

/* The first that weighs as much, or -1. */
int qn_typical_stone_find (double unit_weight);
