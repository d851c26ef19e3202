/* Contacts that follow the blocks (core/contact/contact-follow.h), on a path or in time: between two steps
 * joints are released, corners near sides are listed anew, and the assembly is replaced.
 *
 * Energy. The change adds no energy: corners that become active within a block store at most the energy of
 * the pairs between the same two blocks that become inactive at that moment,
 *
 *   q_n = s apart,   s^2 = min (1, released / sum (k_n apart^2 + t^2 / k_t) / 2),   t = (T/N) k_n apart
 *
 * T/N: last shear over normal force between the two blocks. The inset of the contact is the rest of the depth,
 * (1 - s) |apart|. Released energy that is not stored again is lost. */
#pragma once

#include "core/contact/contact-follow.h"
#include "core/equilibrium/equilibrium.h"

typedef struct QnMovingContacts {
  QnContactFollow follow;
  QnContacts *contacts; /* drawn and last listed contacts; NULL: drawn ones alone */
  QnContacts lists[2];  /* of which it is one */
  QnId *noted; /* by listed contact: last index in the result's `found`, or QN_NONE */
  double *displacements; /* scratch, a row for every body */
} QnMovingContacts;

/* From the state under the dead load. `moving` is overwritten without being cleared. */
QnStatus qn_moving_contacts_init (QnMovingContacts *moving, const QnAssembly *assembly,
                                  QnDiag *diag);

void qn_moving_contacts_clear (QnMovingContacts *moving);

/* Updates the contacts in the committed state. Corners are listed within at least twice the margin (m), which
 * must exceed any motion until the next call. Released joints are recorded in `result` with `time`: s, or the
 * number of the step. *changed: evaluate again; eq may have another assembly. */
QnStatus qn_moving_contacts_update (QnMovingContacts *moving, QnEquilibrium *eq,
                                    double margin, double time, QnResult *result,
                                    bool *changed, QnDiag *diag);

/* Adds the state of eq, evaluated and with its loads at this multiplier, to the result as a step. Contacts
 * follow the blocks unless `moving` is NULL. False when memory runs out. */
bool qn_record_step (QnEquilibrium *eq, QnMovingContacts *moving, double multiplier,
                     QnStep step, QnResult *result);

/* Adds found contacts with a force to the result and, unless `pairs` (results of all pairs) is NULL, what they
 * carry at its last step. */
bool qn_moving_contacts_record (QnMovingContacts *moving, const QnAssembly *assembly,
                                double time, const QnPairResult *pairs, QnResult *result);
