/* Test of instability in large displacements by the second-order work of a motion.
 *
 * The structure is displaced from an equilibrium along a straight line; joints respond by their laws. It moves
 * on if (1 + QN_PUSH) x the multiplier does more work than the joints resist all the way, until
 * (1 - QN_PUSH) x the multiplier does so too: negative second-order work (Hill 1958, A general theory of
 * uniqueness and stability in elastic-plastic solids, J. Mech. Phys. Solids 6). With a potential, no stable
 * state has such a motion unless a maximum higher by less than QN_PUSH is near; with non-associative
 * friction a state that has one may still stand. */
#pragma once

#include "core/assembly/assembly.h"

#define QN_PUSH 1e-3

/* u: equilibrium at `multiplier` with committed memory; driven: growth of the live loads up to it; velocity:
 * any length > 0; moved, residual: scratch. All vectors: unknowns. The assembly is left displaced. */
bool qn_moves_on (QnAssembly *assembly, const double *u, double multiplier, double driven,
                  const double *velocity, double *moved, double *residual);
