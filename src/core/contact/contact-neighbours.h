/* Broad phase of contact detection: the pairs of blocks whose boxes meet, and what is found
 * between them. */
#pragma once

#include "core/contact/contact-search.h"

/* Pairs of blocks that overlap more deeply than may pass unnoticed, and pairs whose boxes meet, up to
 * which a structure of so many blocks is searched. A structure laid over itself has fewer of the
 * first, a thousand parallel slabs at an angle fewer of the second. */
#define QN_MOST_OVERLAPS(blocks)   (10000 + 4 * (size_t) (blocks))
#define QN_MOST_NEIGHBOURS(blocks) (2000000 + 100 * (size_t) (blocks))

/* All that pairs of blocks have to do with each other. Findings come kind by kind
 * (gaps, overlaps, points), each kind sorted by blocks. Refuses TOO_MANY_NEIGHBOURS and
 * TOO_MANY_OVERLAPS. */
QnStatus qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts,
                                QnDiag *diag);
