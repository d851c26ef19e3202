/* The two certificates of a limit analysis, summed up from the model alone. */
#pragma once

#include "core/limit/limit.h"

/* Aborts unless the forces of an associative COLLAPSE balance dead + lower bound x live load on
 * every free block (1e-8 of the loads) within the strength of every pair (1e-9), the velocities
 * keep to the flow rule (1e-6 of the fastest) and to the supports, their multiplier,
 * (dissipation - dead power) / live power, is the upper bound (1e-6), and the bounds are not
 * more than 1e-6 apart. Both sides of a joint must have the same law. */
void test_assert_certified (const QnModel *model, const QnContacts *contacts,
                            const QnLimitSolution *solution);
