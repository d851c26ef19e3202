/* Beam elements and ties within the assembled structure: a tie is an element between two points of
 * blocks, or of the ground, that has a normal force alone.
 *
 * The unknowns are those of the bodies: blocks, and nodes that stand free. A node that rides on
 * a block moves with it: its displacement is u + (R - 1) r, with r the arm from the centroid,
 * and its forces act on the block with that arm, which in nonlinear geometry turns.
 *
 * Distributed loads act on the nodes: in linear geometry as the forces and moments that make
 * displacements of nodes exact; in nonlinear geometry, and where an end yields, as forces half
 * and half. Moments at the ends are exact in statically determinate members either way; what is
 * reported as end forces is in equilibrium with the load itself.
 */
#pragma once

#include "core/assembly/beam-element.h"
#include "core/base/memory.h"
#include "core/linalg/sparse.h"
#include "core/model/model.h"

#define QN_GROUND SIZE_MAX

/* One element in its place. Unknowns: ux, uy, L rz of the bodies at both ends. */
typedef struct QnAssembledBeam {
  QnBeamProperties properties;
  size_t bodies[2];    /* at both ends; QN_GROUND: none */
  int32_t unknowns[6]; /* QN_NONE where fixed */
  QnVec2 arms[2];      /* from the bodies' centroids to the nodes, undeformed, m */
  int32_t scatter[36];

  /* Of the last update. */
  QnVec2 turned[2];
  QnBeamKinematics kinematics;
} QnAssembledBeam;

/* Share of a node in its elements, half of each. */
typedef struct QnBeamShare {
  double weight;  /* N */
  double volume;  /* m3 */
  double longest; /* length of an element, m */
} QnBeamShare;

typedef struct QnBeamAssembly {
  const QnModel *model;
  double length; /* by which rotations are scaled, m */
  bool nonlinear;
  size_t count; /* of the elements of beams, then the ties */
  QnAssembledBeam *beams;
  QnBeamMemory *committed;   /* from which every evaluation starts */
  QnBeamResponse *responses; /* of the last evaluation, or of a state taken back */
  QnVec2 *loads[2];          /* what is held and what is driven, N/m, by element */
  QnVec2 *scratch;           /* by element */
  QnBeamShare *shares;       /* of the nodes */
  int8_t *assembled_phases;  /* of the tangent that was assembled last */
} QnBeamAssembly;

/* Part of a state that is independent of the displacements; one item per element. */
typedef struct QnBeamState {
  QnBeamMemory *memory;
  QnBeamResponse *responses;
} QnBeamState;

/* Stiffness, limits and mass of an element of a prepared model. */
QnBeamProperties qn_beam_properties (const QnModel *model, QnId element);

/* unknowns: (block_count + node_count) x 3, those of riding nodes unused. `beams` is overwritten
 * without being cleared, in memory of the pool; the model must outlive it. */
void qn_beam_assembly_setup (QnBeamAssembly *beams, const QnModel *model,
                             const int32_t *unknowns, QnPool *pool);

/* Geometric mean of the sway stiffness 12 EI / D^3 of elements, D the extent of all nodes (independent of
 * the number of elements per member), and of EA / L of ties, N/m; 1 without elements. */
double qn_beam_assembly_stiffness (const QnBeamAssembly *beams);

/* Adds the entries of the elements to the pattern; finds their indices in the compressed pattern. */
void qn_beam_assembly_add_pattern (const QnBeamAssembly *beams, QnSparsePattern *pattern);
void qn_beam_assembly_find_places (QnBeamAssembly *beams, const int32_t *ap,
                                   const int32_t *ai);

/* loads[0] = dead loads + sum of held[set] x load set; loads[1] = sum of driven[set] x load set. */
void qn_beam_assembly_set_loads (QnBeamAssembly *beams, const double *held,
                                 const double *driven);

/* Loads q (N/m, by element): adds their forces on the unknowns, N, with undeformed arms; adds the change of
 * their moments by turned arms; adds the tangent of these moments at a multiplier. */
void qn_beam_assembly_add_loads (const QnBeamAssembly *beams, const QnVec2 *q,
                                 double *loads);
void qn_beam_assembly_turn_loads (const QnBeamAssembly *beams, const QnVec2 *q,
                                  double *loads);
void qn_beam_assembly_add_load_stiffness (const QnBeamAssembly *beams, double multiplier,
                                          double *ax);

/* Adds the forces of elements, less their loads at a multiplier, to the bodies' rows (N, N, N m about the
 * displaced centroid or node). */
void qn_beam_assembly_add_body_forces (const QnBeamAssembly *beams, double multiplier,
                                       double *forces);

/* Takes over displacements of the unknowns (m, rotations times the characteristic length). */
void qn_beam_assembly_update_kinematics (QnBeamAssembly *beams, const double *u);

/* After qn_beam_assembly_update_kinematics(). */
void qn_beam_assembly_evaluate (QnBeamAssembly *beams);

/* Subtracts the forces of the last evaluation from the residual, N. */
void qn_beam_assembly_subtract_forces (const QnBeamAssembly *beams, double *residual);

/* Adds the tangent of the last evaluation, N/m. */
void qn_beam_assembly_add_tangent (QnBeamAssembly *beams, double *ax);

/* Whether the tangent is another than the one assembled last. */
bool qn_beam_assembly_has_changed (const QnBeamAssembly *beams);

/* Accepts the state of the last evaluation: plastic hinges keep it. */
void qn_beam_assembly_commit (QnBeamAssembly *beams);

/* States, for going back; from a pool. */
void qn_beam_state_init (QnBeamState *state, const QnBeamAssembly *beams, QnPool *pool);
void qn_beam_state_save (QnBeamState *state, const QnBeamAssembly *beams);
void qn_beam_state_set (const QnBeamState *state, QnBeamAssembly *beams);

/* Adds the consistent mass of the elements (density is weight over gravity) to ax. */
void qn_beam_assembly_add_mass (const QnBeamAssembly *beams, double *ax);

/* Adds consistent mass x uniform acceleration of both ends, m/s2. */
void qn_beam_assembly_add_inertia (const QnBeamAssembly *beams, QnVec2 acceleration,
                                   double *forces);

/* Adds the tangent without its geometric part to ax: positive semidefinite, for damping. */
void qn_beam_assembly_add_material_tangent (const QnBeamAssembly *beams, double *ax);

/* Every tie at the last evaluation. */
void qn_beam_assembly_ties (const QnBeamAssembly *beams, QnTieResult *ties);

/* Slack of a tie at the last evaluation, m; <= 0: the tie pulls. */
double qn_beam_assembly_tie_gap (const QnBeamAssembly *beams, size_t tie);

/* Rate of elongation of a tie at the last evaluation under velocities v of the unknowns. */
double qn_beam_assembly_tie_rate (const QnBeamAssembly *beams, size_t tie,
                                  const double *v);

/* Ends the tensioning of prestressed ties: from the last evaluation on they are elastic about their present
 * force. Call commit next. */
void qn_beam_assembly_tension (QnBeamAssembly *beams);

/* Section forces of every element of beams at the last evaluation under dead + multiplier live load. */
void qn_beam_assembly_forces (const QnBeamAssembly *beams, double multiplier,
                              QnBeamForces *forces);
