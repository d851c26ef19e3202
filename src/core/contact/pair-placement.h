/* Laws and contact pairs of the faces, by the model's rules and its exceptions, and the pairs
 * of reinforcing bars. */
#pragma once

#include "core/contact/contacts.h"

/* Sets laws and pairs of every face; pairs of bars follow those of the joint. Refuses bars that cross no
 * face, joints by material between two rigid sides, and springs that snap back while they soften. */
QnStatus qn_contacts_place_pairs (const QnModel *model, QnContacts *contacts,
                                  QnDiag *diag);
