/* The assembled structure: contact pairs between blocks, and beams, as one nonlinear system.
 *
 * Unknowns are the free degrees of freedom of the bodies: blocks, and nodes that stand free.
 * Rotations are multiplied by the model's characteristic length L, moments divided by it, so that
 * every unknown is in m, every force in N and every entry of the tangent stiffness in N/m.
 *
 *   residual   R(u, lambda) = F_dead + lambda F_live - P(u)
 *   tangent    K = dP / du   (unsymmetric where dilatancy differs from friction)
 *
 * Pairs have a committed memory, from which every evaluation starts, and a trial memory,
 * which the last evaluation left. qn_assembly_commit() makes the trial the committed one.
 */
#pragma once

#include "core/assembly/beam-element.h"
#include "core/base/memory.h"
#include "core/contact/contact-pair.h"
#include "core/contact/contacts.h"
#include "core/contact/pair-kinematics.h"
#include "core/model/model.h"
#include "core/result/result.h"

/* A force that acts away from the centroid of its block: in nonlinear geometry its arm turns. */
typedef struct QnEccentricLoad {
  int32_t unknown;   /* rotation of the block */
  int32_t set;       /* load set; QN_NONE: dead load */
  double dead, live; /* factors of the force in the dead and in the live loads */
  QnVec2 arm;        /* undeformed, m */
  QnVec2 turned;     /* the arm at the last evaluation */
  QnVec2 force;      /* N */
} QnEccentricLoad;

/* Beam elements, and ties: elements between two points of blocks, or of the ground, that have a normal
 * force alone.
 *
 * A node that rides on a block moves with it: its displacement is u + (R - 1) r, with r the arm from the
 * centroid, and its forces act on the block with that arm, which in nonlinear geometry turns.
 *
 * Distributed loads act on the nodes: in linear geometry as the forces and moments that make
 * displacements of nodes exact; in nonlinear geometry, and where an end yields, as forces half
 * and half. Moments at the ends are exact in statically determinate members either way; what is
 * reported as end forces is in equilibrium with the load itself. */
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

/* A supported degree of freedom with a settlement. Instead of equilibrium its unknown u satisfies
 *
 *   k (dead + lambda live - u) = 0
 *
 * k: stiffness of the order of the structure's. The load vectors hold k times the settlement, so
 * that a path drives a settlement like a load. */
typedef struct QnSettling {
  int32_t unknown;
  QnId block;
  double u; /* at the last evaluation, m */
} QnSettling;

/* Unknowns that a face couples: three of either block. */
#define QN_FACE_UNKNOWNS 6

/* Of the largest force: what does not count where a joint is said to be open, or to slide. */
#define QN_NO_FORCE 5e-5

typedef struct QnAssembly {
  QnPool pool; /* of all that follows */
  const QnModel *model;
  const QnContacts *contacts;
  double length;  /* L, m */
  bool nonlinear; /* equilibrium in the deformed configuration */

  int32_t unknown_count;
  int32_t *unknown; /* body_count x 3; QN_NONE: fixed, or a node on a block */
  QnSettling *settling;
  size_t settling_count;
  bool *settles; /* unknown_count: settlement of a support */

  size_t pair_count;
  QnPairKinematics *kinematics; /* last evaluation; linear geometry: undeformed */
  QnPairGradient *gradients;    /* last evaluation */
  double *elongations; /* last evaluation, m: pairs rounded up to a multiple of 8, x 2 */
  QnPairSprings *springs;
  QnPairMemory *committed;   /* from which every evaluation starts */
  QnPairResponse *responses; /* of the last evaluation, or of the state taken back */
  bool has_bonds;            /* some bond may break */
  double *breaks; /* by pair: damage before the bond broke in this step; NAN: unbroken */
  bool *inactive; /* by pair: no force and no stiffness at any elongation */

  QnBeamAssembly beams;
  int64_t commits; /* number of committed states */

  double *dead, *live; /* loads on the unknowns at the last evaluation, N */
  double *dead_at_rest, *live_at_rest;
  double held[QN_MAX_LOAD_SETS], driven[QN_MAX_LOAD_SETS]; /* factors of the sets */
  QnEccentricLoad *eccentric;
  size_t eccentric_count;
  double *damping;    /* diagonal of C, N/m: see qn_assembly_tangent() */
  double *forces;     /* scratch, body_count x 3 */
  double stiffness;   /* mean normal stiffness of a pair, N/m */
  double softness;    /* stiffness of the softest spring or tie / `stiffness`; <= 1 */
  double force_scale; /* largest dead load on a block; without any, live load, N */

  int32_t *ap, *ai; /* pattern of K in compressed columns, rows sorted */
  double *ax;
  bool *loose;            /* scratch, a body */
  int32_t *first_pairs;   /* face_count + 1: the first pair of each face */
  int32_t *face_unknowns; /* face_count x 6, QN_NONE where fixed */
  int32_t *scatter;  /* face_count x 36: indices in ax of a face's 6 x 6, or QN_NONE */
  int32_t *diagonal; /* unknown_count: indices in ax */
} QnAssembly;

/* Prepares everything that does not change during an analysis. `assembly` is overwritten
 * without being cleared; the model and the contacts must outlive it. */
QnStatus qn_assembly_setup (QnAssembly *assembly, const QnModel *model,
                            const QnContacts *contacts, QnDiag *diag);

void qn_assembly_clear (QnAssembly *assembly);

/* Updates a contact pair whose position on its blocks has changed. Until the next evaluation its
 * kinematics are undeformed. */
void qn_assembly_place_pair (QnAssembly *assembly, size_t pair);

/* dead = dead loads + sum of held[set] x load set; live = sum of driven[set] x load set. Both arrays
 * have QN_MAX_LOAD_SETS factors. Default: held = 0, driven = 1 for the live loads (set 0) alone. */
void qn_assembly_set_loads (QnAssembly *assembly, const double *held,
                            const double *driven);

/* Evaluates every pair at the displacements u (unknown_count). Returns false where a pair's
 * internal iteration failed. */
bool qn_assembly_evaluate (QnAssembly *assembly, const double *u);

/* Kinematics of pairs and loads at displacements u, without forces: before the responses of an earlier
 * evaluation at u are restored. */
void qn_assembly_update_kinematics (QnAssembly *assembly, const double *u);

/* residual = F_dead + multiplier F_live - P of the last evaluation. Returns the scale of the residual:
 * the largest load on a body at this multiplier, N, at least force_scale. */
double qn_assembly_residual (const QnAssembly *assembly, double multiplier,
                             double *residual);

/* As qn_assembly_residual(), with the force of pair p taken from forces[p x stride]. */
double qn_assembly_residual_of (const QnAssembly *assembly, double multiplier,
                                const double *forces, size_t stride, double *residual);

/* ax = K + viscosity C of the last evaluation. K = -dR/du; the multiplier enters in nonlinear geometry
 * only. C: diagonal, N/m, the mean stiffness of a pair distributed over the blocks like mass. */
void qn_assembly_tangent (QnAssembly *assembly, double multiplier, double viscosity);

/* As qn_assembly_tangent(), with the tangent of pair p (2 x 2, by rows) from tangents[p x stride]. */
void qn_assembly_tangent_of (QnAssembly *assembly, double multiplier, double viscosity,
                             const double *tangents, size_t stride);

/* Tangent for small vibrations: see qn_pair_vibration_tangent(); `sliding`: closed joints keep the tangent
 * of slip. Settling supports are fixed: their rows and columns are 0 but for the diagonal. Writes the
 * pairs' tangents, pair_count x 4. */
void qn_assembly_tangent_of_vibration (QnAssembly *assembly, double multiplier,
                                       bool sliding, double *tangents);

/* Tangent for stability, settling supports fixed: pairs of the law no-tension that lose their shear force
 * between closed and open (state SLIP) count as open. */
void qn_assembly_tangent_at_rest (QnAssembly *assembly, double multiplier);

/* Whether the tangent last assembled is symmetric. */
bool qn_assembly_is_symmetric (const QnAssembly *assembly);

/* Whether a growing load may make the structure jump to another equilibrium: some spring has
 * dilatancy < friction or a bond, or no pair is elastic and perfectly plastic. If false, the path of
 * equilibria does not turn back. */
bool qn_assembly_may_jump (const QnAssembly *assembly);

/* Whether the normal force of some spring may fall while its elongation grows. */
bool qn_assembly_may_soften (const QnAssembly *assembly);

/* Mass matrix in the pattern of K, kg, rotations scaled like the unknowns. Blocks: diagonal. Beams:
 * consistent with the shape functions, in their position at the last evaluation. Settling supports: 0.
 * Refuses blocks and beams without mass. */
QnStatus qn_assembly_mass (const QnAssembly *assembly, double *mass, QnDiag *diag);

/* forces (unknowns) += mass of blocks and beams x uniform acceleration of all bodies and supports, m/s2. */
void qn_assembly_add_inertia (const QnAssembly *assembly, QnVec2 acceleration,
                              double *forces);

/* y = A x for a matrix with the values `ax` in the pattern of K. */
void qn_assembly_multiply (const QnAssembly *assembly, const double *ax, const double *x,
                           double *y);

/* Forces of the ground on the bodies (body_count x 3: N, N, N m about the displaced centroid or node) at
 * the last evaluation and this multiplier; 0 for free degrees of freedom. */
void qn_assembly_reactions (QnAssembly *assembly, double multiplier, double *reactions);

/* Accepts the last evaluation as the state from which further ones start. */
void qn_assembly_commit (QnAssembly *assembly);

/* Brittle bonds during an equilibrium iteration. After hold, bonds carry forces above their strength, so
 * that forces are continuous. After convergence, break breaks the bonds whose excess over the strength is
 * at least half of the largest; false: no bond is above its strength, else iterate again. let ends this;
 * unless `found` it restores the bonds broken since hold. */
void qn_assembly_hold_bonds (QnAssembly *assembly);
bool qn_assembly_break_bonds (QnAssembly *assembly);
void qn_assembly_let_bonds (QnAssembly *assembly, bool found);

/* Normal elongation of a pair at the last evaluation less its committed dilation, m; > 0: open. */
double qn_assembly_gap (const QnAssembly *assembly, size_t pair);

/* rates (pair_count x 2) = dq/du v of every pair at the last evaluation. */
void qn_assembly_elongation_rates (const QnAssembly *assembly, const double *v,
                                   double *rates);

/* Largest translation or rotation x L of a body, m, in v (unknowns), or in v - base (`base` nullable). The
 * value does not depend on the orientation of the axes. */
double qn_assembly_largest (const QnAssembly *assembly, const double *v,
                            const double *base);

/* The sum of these values over all bodies, m. */
double qn_assembly_total (const QnAssembly *assembly, const double *v);

/* Largest displacement in v, or v - base (`base` nullable), as a multiple of an elastic displacement:
 * force_scale over the stiffness of the softest spring. */
double qn_assembly_elastic_displacements (const QnAssembly *assembly, const double *v,
                                          const double *base);

/* qn_assembly_largest() of the bodies that are not connected to a support at the last evaluation. A joint or
 * tie connects two bodies if its force exceeds 1 % of the dead load on the second one; bodies at the ends
 * of beams count as supported. */
double qn_assembly_largest_loose (QnAssembly *assembly, const double *v,
                                  const double *base);

/* Displacements of bodies (body_count x 3: m, m, rad) from unknowns. */
void qn_assembly_expand (const QnAssembly *assembly, const double *u,
                         double *displacements);

/* Unknowns of displacements or velocities of bodies (body_count x 3). */
void qn_assembly_collect (const QnAssembly *assembly, const double *rows, double *u);

/* Velocities or modes of bodies about the configuration u. */
void qn_assembly_expand_rates (const QnAssembly *assembly, const double *u,
                               const double *rates, double *velocities);

/* State, forces and springs of every pair at the last evaluation, which was at u. */
void qn_assembly_pair_results (const QnAssembly *assembly, const double *u,
                               QnPairResult *results);

/* --- Beams and ties (beam-assembly.c) ----------------------------------------------------- */

/* Stiffness, limits and mass of an element of a prepared model. */
QnBeamProperties qn_beam_properties (const QnModel *model, QnId element);

/* Takes over displacements of the unknowns; evaluates the elements there. */
void qn_beam_assembly_update_kinematics (QnAssembly *assembly, const double *u);
void qn_beam_assembly_evaluate (QnAssembly *assembly);

/* Whether the tangent of the elements is another than the one assembled last. */
bool qn_beam_assembly_has_changed (const QnAssembly *assembly);

/* States, for going back; from a pool. */
void qn_beam_state_init (QnBeamState *state, const QnAssembly *assembly, QnPool *pool);
void qn_beam_state_save (QnBeamState *state, const QnAssembly *assembly);
void qn_beam_state_set (const QnBeamState *state, QnAssembly *assembly);

/* Adds the tangent without its geometric part to ax: positive semidefinite, for damping. */
void qn_beam_assembly_add_material_tangent (const QnAssembly *assembly, double *ax);

/* Every tie at the last evaluation. */
void qn_beam_assembly_ties (const QnAssembly *assembly, QnTieResult *ties);

/* Slack of a tie at the last evaluation, m; <= 0: the tie pulls. */
double qn_beam_assembly_tie_gap (const QnAssembly *assembly, size_t tie);

/* Rate of elongation of a tie at the last evaluation under velocities v of the unknowns. */
double qn_beam_assembly_tie_rate (const QnAssembly *assembly, size_t tie,
                                  const double *v);

/* Ends the tensioning of prestressed ties: from the last evaluation on they are elastic about their present
 * force. Call commit next. */
void qn_beam_assembly_tension (QnAssembly *assembly);

/* Section forces of every element of beams at the last evaluation under dead + multiplier live load. */
void qn_beam_assembly_forces (const QnAssembly *assembly, double multiplier,
                              QnBeamForces *forces);
