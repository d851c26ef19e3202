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

/* What a node carries of the elements that end at it, half of each. */
typedef struct QnBeamShare {
  double weight;  /* N */
  double volume;  /* m3 */
  double longest; /* length of an element, m */
} QnBeamShare;

typedef struct QnBeamAssembly {
  QnPool pool; /* of all that follows */
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

/* All of a state that does not follow from displacements: arrays, one item an element. */
typedef struct QnBeamState {
  QnBeamMemory *memory;
  QnBeamResponse *responses;
} QnBeamState;

/* Stiffness, limits and mass of an element of a prepared model. */
QnBeamProperties qn_beam_properties (const QnModel *model, QnId element);

/* unknowns: (block_count + node_count) x 3, those of riding nodes unused. `beams` is overwritten
 * without being cleared; the model must outlive it. False when memory runs out. */
bool qn_beam_assembly_setup (QnBeamAssembly *beams, const QnModel *model,
                             const int32_t *unknowns);

void qn_beam_assembly_clear (QnBeamAssembly *beams);

/* Geometric mean of 12 EI / D^3, D the extent of all nodes: what the elements offer against
 * sway, however finely members are cut; and of EA / L of ties. 1 without elements. */
double qn_beam_assembly_stiffness (const QnBeamAssembly *beams);

/* Adds what the elements couple; and, once it is compressed, looks up where they go. */
bool qn_beam_assembly_add_pattern (const QnBeamAssembly *beams, QnSparsePattern *pattern);
void qn_beam_assembly_find_places (QnBeamAssembly *beams, const int32_t *ap,
                                   const int32_t *ai);

/* Makes loads[0] the dead loads and every set times its factor in `held`, loads[1] every set
 * times its factor in `driven`. */
void qn_beam_assembly_set_loads (QnBeamAssembly *beams, const double *held,
                                 const double *driven);

/* Adds what loads q (N/m, by element) put on the unknowns, N, with arms at rest; what they add
 * where arms have turned; and, of both together at a multiplier, what that does to the tangent. */
void qn_beam_assembly_add_loads (const QnBeamAssembly *beams, const QnVec2 *q,
                                 double *loads);
void qn_beam_assembly_turn_loads (const QnBeamAssembly *beams, const QnVec2 *q,
                                  double *loads);
void qn_beam_assembly_add_load_stiffness (const QnBeamAssembly *beams, double multiplier,
                                          double *ax);

/* Adds to rows of bodies (N, N, N m about centroid or node as it has moved) what elements and
 * their loads at a multiplier ask of what holds them. */
void qn_beam_assembly_add_body_forces (const QnBeamAssembly *beams, double multiplier,
                                       double *forces);

/* Takes over displacements of the unknowns (m, rotations times the characteristic length). */
void qn_beam_assembly_update_kinematics (QnBeamAssembly *beams, const double *u);

/* After qn_beam_assembly_update_kinematics(). */
void qn_beam_assembly_evaluate (QnBeamAssembly *beams);

/* Subtracts the forces of the last evaluation from the residual, N. */
void qn_beam_assembly_subtract_forces (const QnBeamAssembly *beams, double *residual);

/* Adds the tangent of the last evaluation, N/m, at the places found for it. */
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

/* Adds what the elements need to follow a uniform acceleration of both ends, by the same mass. */
void qn_beam_assembly_add_inertia (const QnBeamAssembly *beams, QnVec2 acceleration,
                                   double *forces);

/* Adds to ax the part of the tangent that does not come from forces in turned elements: never
 * negative, as damping needs it. */
void qn_beam_assembly_add_material_tangent (const QnBeamAssembly *beams, double *ax);

/* Every tie at the last evaluation. */
void qn_beam_assembly_ties (const QnBeamAssembly *beams, QnTieResult *ties);

/* By how much the ends of a tie may still move apart before it pulls, m, at the last evaluation;
 * not above 0 where it does. */
double qn_beam_assembly_tie_gap (const QnBeamAssembly *beams, size_t tie);

/* How fast the ends of a tie move apart at the last evaluation with velocities v of the unknowns. */
double qn_beam_assembly_tie_rate (const QnBeamAssembly *beams, size_t tie,
                                  const double *v);

/* Ties are tensioned: from the last evaluation on they are elastic with the forces that they have there.
 * To be followed by a commit. */
void qn_beam_assembly_tension (QnBeamAssembly *beams);

/* Section forces of every element of beams at the last evaluation under dead + multiplier live load. */
void qn_beam_assembly_forces (const QnBeamAssembly *beams, double multiplier,
                              QnBeamForces *forces);
