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

#include "core/assembly/beam-assembly.h"
#include "core/base/memory.h"
#include "core/contact/contact-pair.h"
#include "core/contact/contacts.h"
#include "core/contact/pair-kinematics.h"
#include "core/model/model.h"
#include "core/result/result.h"

/* A force that acts away from the centroid of its block: in nonlinear geometry its arm turns. */
typedef struct QnEccentricLoad {
  int32_t unknown;   /* rotation of the block */
  int32_t set;       /* of the load; QN_NONE: dead */
  double dead, live; /* its parts in the dead and the live loads */
  QnVec2 arm;        /* undeformed, m */
  QnVec2 turned;     /* the arm at the last evaluation */
  QnVec2 force;      /* N */
} QnEccentricLoad;

/* A supported degree of freedom that settles. It is an unknown with an equation of its own in
 * place of equilibrium,
 *
 *   k (dead + lambda live - u) = 0
 *
 * where k is a stiffness of the structure's size and the entries of the load vectors hold k
 * times the settlement. So a path may drive it like a load. */
typedef struct QnSettling {
  int32_t unknown;
  QnId block;
  QnDof dof;
  double u;            /* at the last evaluation, m */
  int32_t first_entry; /* of its row in QnAssembly.settling_entries */
} QnSettling;

/* Unknowns that a face couples: three of either block. */
#define QN_FACE_UNKNOWNS 6

typedef struct QnAssembly {
  QnPool pool; /* of all that follows */
  const QnModel *model;
  const QnContacts *contacts;
  double length;  /* L, m */
  bool nonlinear; /* equilibrium in the deformed configuration */

  int32_t unknown_count;
  int32_t
    *unknown; /* body_count x 3: index of the unknown, or QN_NONE where fixed or moved
                       by another body */
  QnSettling *settling;
  size_t settling_count;
  bool *settles;             /* unknown_count: whether it is a support's */
  int32_t *settling_entries; /* where the rows of settling unknowns stand in ax, diagonals
                                left out */

  size_t pair_count;
  QnPairKinematics
    *kinematics; /* of the last evaluation in nonlinear geometry, or at rest */
  QnPairGradient *gradients; /* of the last evaluation */
  double
    *elongations; /* pair_count x 2, and what is missing to a multiple of eight pairs: the
                          same, m */
  QnPairSprings *springs;
  QnPairMemory *committed;   /* from which every evaluation starts */
  QnPairResponse *responses; /* of the last evaluation, or of the state taken back */
  bool has_bonds;            /* which may break */
  double *
    breaks; /* by pair: the damage before, where its bond breaks in the step that is sought; else NAN */
  bool *inactive; /* pairs that carry nothing, wherever they are */

  QnBeamAssembly beams;
  int64_t commits; /* how often a state has been accepted */

  double *dead,
    *live; /* loads on the unknowns, N; in nonlinear geometry of the last evaluation */
  double *dead_at_rest, *live_at_rest;
  double held[QN_MAX_LOAD_SETS], driven[QN_MAX_LOAD_SETS]; /* factors of the sets */
  QnEccentricLoad *eccentric;
  size_t eccentric_count;
  double *damping;  /* diagonal of C, N/m: see qn_assembly_tangent() */
  double *forces;   /* scratch, body_count x 3 */
  double stiffness; /* mean normal stiffness of a pair, N/m */
  double softness;  /* of the softest spring of a pair, over that; <= 1 */
  double
    force_scale; /* largest dead load on a block, or live load where there is none, N */

  int32_t *ap, *ai; /* pattern of K in compressed columns, rows sorted */
  double *ax;
  bool *loose;            /* scratch, a body */
  int32_t *first_pairs;   /* face_count + 1: the first pair of each face */
  int32_t *face_unknowns; /* face_count x 6, QN_NONE where fixed */
  int32_t *scatter;  /* face_count x 36: where a face's 6 x 6 goes in ax, or QN_NONE */
  int32_t *diagonal; /* unknown_count: where the diagonal stands in ax */
} QnAssembly;

/* Prepares everything that does not change during an analysis. `assembly` is overwritten
 * without being cleared; the model and the contacts must outlive it. */
QnStatus qn_assembly_setup (QnAssembly *assembly, const QnModel *model,
                            const QnContacts *contacts, QnDiag *diag);

void qn_assembly_clear (QnAssembly *assembly);

/* Reads the place of a contact pair on its blocks again, after it has changed. Its kinematics are
 * those of the undeformed state until the next evaluation. */
void qn_assembly_place_pair (QnAssembly *assembly, size_t pair);

/* Makes "dead" the dead loads and every set times its factor in `held`, "live" every set times
 * its factor in `driven`; QN_MAX_LOAD_SETS factors each. At first nothing is held, and the live
 * loads (set 0) are driven. */
void qn_assembly_set_loads (QnAssembly *assembly, const double *held,
                            const double *driven);

/* Evaluates every pair at the displacements u (unknown_count). Returns false where a pair's
 * internal iteration failed. */
bool qn_assembly_evaluate (QnAssembly *assembly, const double *u);

/* Brings the kinematics of pairs and loads to displacements u, without evaluating forces: for
 * taking up responses that were kept from an earlier evaluation at u. */
void qn_assembly_update_kinematics (QnAssembly *assembly, const double *u);

/* residual = F_dead + multiplier F_live - P of the last evaluation. Returns the largest load on
 * any body at this multiplier (at least force_scale), N, to measure the residual by. */
double qn_assembly_residual (const QnAssembly *assembly, double multiplier,
                             double *residual);

/* The same with other forces of the pairs: that of pair p stands at forces[p x stride]. */
double qn_assembly_residual_of (const QnAssembly *assembly, double multiplier,
                                const double *forces, size_t stride, double *residual);

/* Assembles ax = K + viscosity C of the last evaluation, K = -dR/du at this multiplier (which
 * matters in nonlinear geometry only). C is a diagonal of stiffness size, distributed over the
 * blocks like their mass. */
void qn_assembly_tangent (QnAssembly *assembly, double multiplier, double viscosity);

/* The same with other tangents of the pairs: that of pair p, 2 x 2 by rows, stands at
 * tangents[p x stride]. */
void qn_assembly_tangent_of (QnAssembly *assembly, double multiplier, double viscosity,
                             const double *tangents, size_t stride);

/* That of small vibrations: closed joints are elastic, or as they slide, open ones carry nothing
 * (qn_pair_vibration_tangent); settling supports held, their rows and columns empty but for the diagonal,
 * so that K is symmetric where the pairs' tangents are. Fills tangents, pair_count x 4. */
void qn_assembly_tangent_of_vibration (QnAssembly *assembly, double multiplier,
                                       bool sliding, double *tangents);

/* That of the structure as it stays where it is, settling supports held likewise: joints without tension
 * that are letting go of their shear force, between closed and open, count as open. */
void qn_assembly_tangent_at_rest (QnAssembly *assembly, double multiplier);

/* Whether the tangent last assembled is symmetric. */
bool qn_assembly_is_symmetric (const QnAssembly *assembly);

/* Whether the structure may jump from one equilibrium to another while its load grows steadily: in
 * some pair a spring has dilatancy < friction, or no pair is elastic and perfectly plastic, so that
 * nothing is known. Where it may not, the path of equilibria does not turn back. */
bool qn_assembly_may_jump (const QnAssembly *assembly);

/* Whether some spring may lose strength: what the structure carries afterwards is less than it carried. */
bool qn_assembly_may_soften (const QnAssembly *assembly);

/* The mass matrix, written into `mass` with the pattern of K, in kg with rotations scaled like the
 * unknowns: masses of blocks, diagonal at the centroids; of beams consistent with the shape
 * functions, where they lie at the last evaluation. Settling supports have none. Refuses blocks
 * and beams without mass. */
QnStatus qn_assembly_mass (const QnAssembly *assembly, double *mass, QnDiag *diag);

/* forces (unknowns) += what blocks and beams would need to follow a uniform acceleration of all
 * bodies, supports included, m/s2. */
void qn_assembly_add_inertia (const QnAssembly *assembly, QnVec2 acceleration,
                              double *forces);

/* y = A x for a matrix with the values `ax` in the pattern of K. */
void qn_assembly_multiply (const QnAssembly *assembly, const double *ax, const double *x,
                           double *y);

/* What the supports do: the forces (body_count x 3: N, N, N m about the centroid or node where
 * the body has moved to) that the ground exerts on fixed degrees of freedom at the last evaluation
 * with its loads at this multiplier; 0 for free ones. */
void qn_assembly_reactions (QnAssembly *assembly, double multiplier, double *reactions);

/* Accepts the last evaluation as the state from which further ones start. */
void qn_assembly_commit (QnAssembly *assembly);

/* While an equilibrium is sought brittle bonds hold beyond their strength: no iteration that passes over it
 * breaks any, and forces are continuous. Then those that are strained most break, and it is sought again.
 * False where none breaks. To be ended by qn_assembly_let_bonds(), which takes back what broke unless the
 * equilibrium is `found`. These do nothing where there is no bond. */
void qn_assembly_hold_bonds (QnAssembly *assembly);
bool qn_assembly_break_bonds (QnAssembly *assembly);
void qn_assembly_let_bonds (QnAssembly *assembly, bool found);

/* Opening of a pair at the last evaluation, beyond what the committed memory holds of
 * dilatancy, m: positive where the joint is open. */
double qn_assembly_gap (const QnAssembly *assembly, size_t pair);

/* rates (pair_count x 2) = dq/du v of every pair at the last evaluation. */
void qn_assembly_elongation_rates (const QnAssembly *assembly, const double *v,
                                   double *rates);

/* Largest of v (unknowns), or of its difference from `base` unless that is NULL: of each body the length
 * of its translation, or its scaled rotation. A structure turned with its loads has the same. */
double qn_assembly_largest (const QnAssembly *assembly, const double *v,
                            const double *base);

/* The sum over all bodies of the same. */
double qn_assembly_total (const QnAssembly *assembly, const double *v);

/* Largest displacement of v (unknowns), or of its difference from `base` unless that is NULL,
 * in elastic displacements: load over the stiffness of the softest spring. */
double qn_assembly_elastic_displacements (const QnAssembly *assembly, const double *v,
                                          const double *base);

/* The same as qn_assembly_largest() of the bodies that nothing holds at the last evaluation: no chain of
 * members, or of joints, leads from them to a support; each joint with at least a hundredth of the dead load
 * on the next body. */
double qn_assembly_largest_loose (QnAssembly *assembly, const double *v,
                                  const double *base);

/* Displacements of bodies (body_count x 3: m, m, rad) from unknowns. */
void qn_assembly_expand (const QnAssembly *assembly, const double *u,
                         double *displacements);

/* The same for velocities or modes about the configuration u. */
void qn_assembly_expand_rates (const QnAssembly *assembly, const double *u,
                               const double *rates, double *velocities);

/* State, forces and springs of every pair at the last evaluation, which was at u. */
void qn_assembly_pair_results (const QnAssembly *assembly, const double *u,
                               QnPairResult *results);
