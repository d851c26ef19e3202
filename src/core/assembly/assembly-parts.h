/* Private to the assembly: functions shared by its files. */
#pragma once

#include "core/assembly/assembly.h"
#include "core/linalg/sparse.h"

/* Lists the forces whose moment changes when their block turns, and sums up all loads. */
void qn_assembly_gather_loads (QnAssembly *assembly);

/* Moments of forces on blocks that have turned: their arms turn with them. */
void qn_assembly_turn_loads (QnAssembly *assembly, const double *u);

/* Adds to ax the derivative of the load moments by rotation. */
void qn_assembly_add_load_stiffness (QnAssembly *assembly, double multiplier);

/* --- Inner loops over the faces (assembly-tangent.c) ------------------------------------ */

/* v = u on the unknowns of a face, 0 on fixed degrees of freedom. */
void qn_assembly_gather (const QnAssembly *assembly, size_t face, const double *u,
                         double v[QN_FACE_UNKNOWNS]);

/* Brings the kinematics of all pairs to displacements u. */
void qn_assembly_move_faces (QnAssembly *assembly, const double *u);

/* residual -= G' force of all pairs; settling unknowns are left to the caller. The force of pair
 * p stands at forces[p x stride]. */
void qn_assembly_subtract_face_forces (const QnAssembly *assembly, const double *forces,
                                       size_t stride, double *residual);

/* --- Beams and ties (beam-assembly.c) ----------------------------------------------------- */

/* After the unknowns have been numbered. */
void qn_beam_assembly_setup (QnAssembly *assembly);

/* Geometric mean of the sway stiffness 12 EI / D^3 of elements, D the extent of all nodes (independent of
 * the number of elements per member), and of EA / L of ties, N/m; 1 without elements. */
double qn_beam_assembly_stiffness (const QnAssembly *assembly);

/* Adds the entries of the elements to the pattern; finds their indices in the compressed pattern. */
void qn_beam_assembly_add_pattern (const QnAssembly *assembly, QnSparsePattern *pattern);
void qn_beam_assembly_find_places (QnAssembly *assembly);

/* loads[0] = dead loads + sum of held[set] x load set; loads[1] = sum of driven[set] x load set. */
void qn_beam_assembly_set_loads (QnAssembly *assembly, const double *held,
                                 const double *driven);

/* Loads q (N/m, by element): adds their forces on the unknowns, N, with undeformed arms. Adds the change of
 * the moments of `loads` by turned arms to dead and live; their tangent at a multiplier to ax. */
void qn_beam_assembly_add_loads (const QnAssembly *assembly, const QnVec2 *q,
                                 double *loads);
void qn_beam_assembly_turn_loads (QnAssembly *assembly);
void qn_beam_assembly_add_load_stiffness (QnAssembly *assembly, double multiplier);

/* Adds the forces of elements, less their loads at a multiplier, to the bodies' rows (N, N, N m about the
 * displaced centroid or node). */
void qn_beam_assembly_add_body_forces (const QnAssembly *assembly, double multiplier,
                                       double *forces);

/* Of the last evaluation: subtracts the forces from the residual; adds the tangent to ax; accepts it. */
void qn_beam_assembly_subtract_forces (const QnAssembly *assembly, double *residual);
void qn_beam_assembly_add_tangent (QnAssembly *assembly);
void qn_beam_assembly_commit (QnAssembly *assembly);

/* Adds the consistent mass of the elements (density is weight over gravity); and times a uniform
 * acceleration of both ends, m/s2. */
void qn_beam_assembly_add_mass (const QnAssembly *assembly, double *mass);
void qn_beam_assembly_add_inertia (const QnAssembly *assembly, QnVec2 acceleration,
                                   double *forces);
