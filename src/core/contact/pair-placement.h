/* Laws and contact pairs of the faces, by the model's rules and its exceptions, and the pairs
 * of reinforcing bars. */
#pragma once

#include "core/contact/contacts.h"

/* Gives every face its laws and pairs, by the model's rules and exceptions, and adds pairs where
 * bars cross it, behind its own. Refuses bars that cross nothing, joints by material without a side that
 * deforms, and springs that would snap back while they soften. */
QnStatus qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts,
                                  QnDiag *diag);
