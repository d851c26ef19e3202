/* Blocks that touch at a point only, touch nothing, or are not held by any support. */
#pragma once

#include "core/contact/contact-faces.h"

/* Appends findings for blocks that touch at a point only; overlaps must be found before. */
QnStatus qn_contact_search_points (const QnContactSearch *search, QnContacts *contacts,
                                   const QnTouches *touches, QnDiag *diag);

/* Appends findings for blocks without contact and for blocks not connected to a support. */
QnStatus qn_contacts_report_loose (const QnModel *model, QnContacts *contacts,
                                   QnDiag *diag);
