/* What the forces of contact pairs do to the blocks, and the motion of blocks at the pairs, summed up
 * without the solver. */
#pragma once

#include "core/contact/contacts.h"

/* Adds the forces of all pairs (2 x pair_count: normal, shear, N) on their blocks to `sum`
 * (3 x block_count: fx, fy, moment about the centroid). Returns the largest of them. */
double test_add_pair_forces (const QnModel *model, const QnContacts *contacts,
                             const double *forces, double *sum);

/* Velocity of block b against block a at a pair: normal (opening) and tangential, from the
 * velocities of all blocks (3 x block_count). */
QnVec2 test_pair_rate (const QnModel *model, const QnContacts *contacts, size_t pair,
                       const double *velocities);
