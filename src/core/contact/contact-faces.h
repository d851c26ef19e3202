/* Narrow phase of contact detection: the common stretches of the sides of two blocks. */
#pragma once

#include "core/contact/contact-search.h"

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
 * touches that lie on no common face of the two. False when memory runs out. */
bool qn_contact_match_pair (const QnContactSearch *search, QnId a, QnId b,
                            QnContactMatches *matches, QnContacts *contacts,
                            QnTouches *touches);
