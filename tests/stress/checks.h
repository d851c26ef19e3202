/* Independent sums over a result: nothing here is taken from the solver but what it reports.
 * Joints of the Coulomb kind on the contact basis, linear geometry, weights and forces only. */
#pragma once

#include "stress/stress.h"

#include "core/limit/limit.h"

/* What equilibrium and strength may be off by, and how much of the fastest rate at which joints
 * move counts as none: joints are elastic, and the last equilibrium is found a little before
 * collapse. */
#define STRESS_BALANCE_TOLERANCE  1e-6
#define STRESS_STRENGTH_TOLERANCE 1e-6
#define STRESS_MOTION_TOLERANCE   5e-2

/* Equilibrium and strength at every step whose forces are known, and the mechanism against the
 * forces at the last one. */
StressCheck stress_check_result (const QnModel *model, const QnContacts *contacts,
                                 const QnResult *result);

/* The faults that these figures are. */
guint stress_check_faults (const StressCheck *check);

/* Whether steps, events and multipliers say the same as the outcome: multipliers finite and
 * rising, the first limit point not above collapse, the mechanism there where blocks move. */
bool stress_path_is_consistent (const QnResult *result);

/* Whether limit analysis proves what it says: forces and velocities of a collapse, the growth of
 * forces of an unbounded multiplier, the fall of a structure that does not stand. */
bool stress_limit_is_proved (const QnModel *model, const QnContacts *contacts,
                             const QnLimitSolution *solution);
