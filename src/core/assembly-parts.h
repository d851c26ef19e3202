/* Private to the assembly: what its files share. */
#ifndef QN_CORE_ASSEMBLY_PARTS_H
#define QN_CORE_ASSEMBLY_PARTS_H

#include "core/assembly.h"

/* Lists the forces whose moment changes when their block turns, and sums up all loads. */
QnStatus qn_assembly_gather_loads (QnAssembly *assembly, QnDiag *diag);

/* Moments of forces on blocks that have turned: their arms turn with them. */
void qn_assembly_turn_loads (QnAssembly *assembly, const double *u);

/* Adds to ax what turning arms do to the tangent. */
void qn_assembly_add_load_stiffness (QnAssembly *assembly, double multiplier);

#endif
