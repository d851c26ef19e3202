/* Structures without collapse load: joints of unlimited strength in large displacements.
 *
 * The energy of such joints grows with the square of the distances between joined points at any rotation of
 * the blocks, the potential of forces only linearly. So the sum has a minimum, a stable equilibrium, at every
 * multiplier. Not so with moments, whose potential falls without limit while a block turns.
 */
#pragma once

#include "core/contact/contacts.h"

/* *unlimited: proved for a prepared model of blocks without beams, bars, settlements, moments and moving
 * contacts, all joints elastic or bilinear with hardening, every block connected by joints to one with fixed
 * translations. QN_ERROR_NO_MEMORY. */
QnStatus qn_check_unlimited (const QnModel *model, const QnContacts *contacts,
                             bool *unlimited, QnDiag *diag);
