/* Is a structure in large displacements pushed on along a motion?
 *
 * It is displaced from an equilibrium along a straight way, with the laws' answer. Elastic joints, and an
 * equilibrium that was not met exactly at the peak, may resist a little at first: a load higher by
 * QN_PUSH of the multiplier must push the structure on all the way, until a load lower by as much does
 * so too. The second-order work of such a motion is negative (Hill 1958, A general theory of uniqueness
 * and stability in elastic-plastic solids, J. Mech. Phys. Solids 6). Where the forces have a potential
 * no stable state offers such a way, but where a maximum higher by less than QN_PUSH is near. Where
 * friction is not associative a state may offer one and stand all the same. */
#pragma once

#include "core/assembly/assembly.h"

#define QN_PUSH 1e-3

/* `u`: the equilibrium at `multiplier`, in the assembly's loads, with its memory committed; `driven`: the
 * part of the multiplier by which the live loads have grown to it. `velocity`: of any length other than
 * 0. All of unknowns, as is the scratch. The assembly is left displaced. */
bool qn_moves_on (QnAssembly *assembly, const double *u, double multiplier, double driven,
                  const double *velocity, double *moved, double *residual);
