/* Contacts that follow the blocks through time (core/contact/contact-follow.h): between two steps joints
 * are left, corners near sides listed anew, and the step goes over to an assembly with these pairs.
 *
 * Energy. The change stores nothing: corners that become active within a block store together at most
 * what the pairs between the same two blocks stored that become inactive at that moment,
 *
 *   q_n = s apart,   s^2 = min (1, released / sum (k_n apart^2 + t^2 / k_t) / 2),   t = (T/N) k_n apart
 *
 * with the shear over the normal force T/N that the two blocks exchanged last. The rest of the depth
 * becomes the inset of the contact, (1 - s) |apart|. What is released and not stored again is lost. */
#ifndef QN_CORE_MOVING_CONTACTS_H
#define QN_CORE_MOVING_CONTACTS_H

#include "core/contact/contact-follow.h"
#include "core/dynamics/energy.h"

typedef struct QnMovingContacts {
  QnContactFollow follow;
  QnContacts contacts; /* as drawn, and those found; with the assembly of the step */
  QnAssembly assembly;
  QnLinsys *linsys;
  QnId *
    noted; /* of listed contacts: place among the result's where they were last, or QN_NONE */
  bool moved;            /* whether the step has gone over to these */
  double *displacements; /* scratch, a row for every body */
  double *slips;         /* scratch, of the pairs as drawn */
  QnPairResult *results; /* scratch, of all pairs */
  size_t result_capacity;
  int32_t rebuilds; /* how often the list changed */
} QnMovingContacts;

/* From the state under the dead load. `moving` is overwritten without being cleared. */
QnStatus qn_moving_contacts_init (QnMovingContacts *moving, const QnAssembly *assembly,
                                  QnDiag *diag);

void qn_moving_contacts_clear (QnMovingContacts *moving);

/* After a step of at most `longest` seconds was accepted: looks whether contacts change, changes them
 * with the state at the start of `step`, and keeps the energy's account. Joints that are left are noted
 * in `result` at this time. */
QnStatus qn_moving_contacts_update (QnMovingContacts *moving, QnTimeStep *step,
                                    double longest, double time, QnEnergy *energy,
                                    QnResult *result, QnDiag *diag);

/* The state at the start of `step`: pairs as drawn into result->pairs, and, where `step_index` is not
 * negative, forces of found contacts for that step. Found contacts that carry something are noted. */
bool qn_moving_contacts_record (QnMovingContacts *moving, const QnTimeStep *step,
                                double time, int32_t step_index, QnResult *result);

#endif
