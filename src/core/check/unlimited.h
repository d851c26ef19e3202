/* Structures that no load brings down.
 *
 * Blocks whose joints hold together at any force hang on their supports like a net. In large displacements
 * the energy that joints store or dissipate grows with the square of the distances between the points that
 * they join, whatever the blocks' rotations, while the potential of forces grows with the distances alone:
 * the sum of both has a least value under every multiple of the loads, and where it is least the structure
 * is in stable equilibrium. Moments are different, for a block that turns on and on lowers their potential
 * without end.
 */
#pragma once

#include "core/contact/contacts.h"

/* Whether this is proved of a prepared model: blocks alone, without beams, bars, settlements, moments and
 * contacts that follow the blocks, which leave their joints; all joints elastic or bilinear with hardening;
 * and every block connected by joints to one whose translations are fixed. QN_ERROR_NO_MEMORY. */
QnStatus qn_check_unlimited (const QnModel *model, const QnContacts *contacts,
                             bool *unlimited, QnDiag *diag);
