/* Private to the assembly: functions shared by its files. */
#pragma once

#include "core/assembly/assembly.h"

/* Lists the forces whose moment changes when their block turns, and sums up all loads. */
void qn_assembly_gather_loads (QnAssembly *assembly);

/* Moments of forces on blocks that have turned: their arms turn with them. */
void qn_assembly_turn_loads (QnAssembly *assembly, const double *u);

/* Adds to ax the derivative of the load moments by rotation. */
void qn_assembly_add_load_stiffness (QnAssembly *assembly, double multiplier);

/* --- Inner loops over the faces (assembly-faces.c) -------------------------------------- */

/* v = u on the unknowns of a face, 0 on fixed degrees of freedom. */
void qn_assembly_gather (const QnAssembly *assembly, size_t face, const double *u,
                         double v[QN_FACE_UNKNOWNS]);

/* Brings the kinematics of all pairs to displacements u. */
void qn_assembly_move_faces (QnAssembly *assembly, const double *u);

/* residual -= G' force of all pairs; settling unknowns are left to the caller. The force of pair
 * p stands at forces[p x stride]. */
void qn_assembly_subtract_face_forces (const QnAssembly *assembly, const double *forces,
                                       size_t stride, double *residual);

/* ax += G' D G of all pairs, and their geometric stiffness. The tangent D (2 x 2, by rows) of
 * pair p stands at tangents[p x stride]. */
void qn_assembly_add_face_tangents (QnAssembly *assembly, const double *tangents,
                                    size_t stride);
