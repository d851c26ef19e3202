/* Broad phase of contact detection: pairs of blocks whose boxes meet. */
#pragma once

#include "core/contact/contact-search.h"

/* Largest numbers of overlapping pairs of blocks, and of pairs with common boxes, that are searched. A
 * structure laid over itself has fewer overlaps, a thousand oblique parallel slabs fewer common boxes. */
#define QN_MOST_OVERLAPS(blocks)   (10000 + 4 * (size_t) (blocks))
#define QN_MOST_NEIGHBOURS(blocks) (2000000 + 100 * (size_t) (blocks))

/* Finds faces, then gaps, overlaps and point contacts, each kind of finding sorted by blocks. Refuses
 * TOO_MANY_NEIGHBOURS and TOO_MANY_OVERLAPS. */
QnStatus qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts,
                                QnDiag *diag);
