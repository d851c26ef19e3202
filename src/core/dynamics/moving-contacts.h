/* Contacts that follow the blocks (core/contact/contact-follow.h), along a path of equilibria or through
 * time: between two steps joints are left, corners near sides listed anew, and the analysis goes over to
 * an assembly with these pairs.
 *
 * Energy. The change stores nothing: corners that become active within a block store together at most
 * what the pairs between the same two blocks stored that become inactive at that moment,
 *
 *   q_n = s apart,   s^2 = min (1, released / sum (k_n apart^2 + t^2 / k_t) / 2),   t = (T/N) k_n apart
 *
 * with the shear over the normal force T/N that the two blocks exchanged last. The rest of the depth
 * becomes the inset of the contact, (1 - s) |apart|. What is released and not stored again is lost. */
#pragma once

#include "core/contact/contact-follow.h"
#include "core/equilibrium/equilibrium.h"

typedef struct QnMovingContacts {
  QnContactFollow follow;
  QnContacts *contacts; /* as drawn and of the last list, which the assembly refers to;
                           NULL as long as there are those as drawn alone */
  QnId *noted; /* of listed contacts: their last place among the result's, or QN_NONE */
  double *displacements; /* scratch, a row for every body */
  double *slips;         /* scratch, of the pairs as drawn */
  QnPairResult *results; /* scratch, of all pairs */
  size_t result_capacity;
} QnMovingContacts;

/* From the state under the dead load. `moving` is overwritten without being cleared. */
QnStatus qn_moving_contacts_init (QnMovingContacts *moving, const QnAssembly *assembly,
                                  QnDiag *diag);

void qn_moving_contacts_clear (QnMovingContacts *moving);

/* Looks whether contacts change in the current state, which is committed, and changes them. Corners are
 * listed within twice the margin (m) at least, which is more than anything moves until the next call. Joints
 * that are left are noted in `result` with this time: seconds, or the number of the step where there is no
 * time. *changed: other pairs carry, perhaps of another assembly of eq, and are to be evaluated anew. */
QnStatus qn_moving_contacts_update (QnMovingContacts *moving, QnEquilibrium *eq,
                                    double margin, double time, QnResult *result,
                                    bool *changed, QnDiag *diag);

/* Adds the state of eq, evaluated and with its loads at this multiplier, to the result as a step. Contacts
 * follow the blocks unless `moving` is NULL. False when memory runs out. */
bool qn_record_step (QnEquilibrium *eq, QnMovingContacts *moving, double multiplier,
                     QnStep step, QnResult *result);

/* The current state: pairs as drawn into result->pairs, and, where `step_index` is not negative, forces of
 * found contacts for that step. Found contacts that carry something are noted. */
bool qn_moving_contacts_record (QnMovingContacts *moving, const QnEquilibrium *eq,
                                double time, int32_t step_index, QnResult *result);
