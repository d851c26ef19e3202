/* Broad phase of contact detection: the pairs of blocks whose boxes meet, and what is found
 * between them. */
#ifndef QN_CORE_CONTACT_NEIGHBOURS_H
#define QN_CORE_CONTACT_NEIGHBOURS_H

#include "core/contact/contact-search.h"

/* All that pairs of blocks have to do with each other. Findings come kind by kind
 * (gaps, overlaps, points), each kind sorted by blocks. */
QnStatus qn_contact_search_all (const QnContactSearch *search, QnContacts *contacts,
                                QnDiag *diag);

#endif
