/* Overlapping blocks and the depth of the overlap. */
#pragma once

#include "core/contact/contact-search.h"

typedef struct QnContactCuts {
  double *items;
  size_t count, capacity;
} QnContactCuts;

/* Appends a finding if blocks a < b overlap; false when memory runs out. */
bool qn_contact_check_overlap (const QnContactSearch *search, QnId a, QnId b,
                               QnContactCuts *cuts, QnFindings *findings);
