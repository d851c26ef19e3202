/* The assembled structure: contact pairs between blocks as one nonlinear system.
 *
 * Unknowns are the free degrees of freedom of the blocks. Rotations are multiplied by the
 * model's characteristic length L, moments divided by it, so that every unknown is in m,
 * every force in N and every entry of the tangent stiffness in N/m.
 *
 *   residual   R(u, lambda) = F_dead + lambda F_live - P(u)
 *   tangent    K = dP / du   (unsymmetric where dilatancy differs from friction)
 *
 * Pairs have a committed memory, from which every evaluation starts, and a trial memory,
 * which the last evaluation left. qn_assembly_commit() makes the trial the committed one.
 */
#ifndef QN_CORE_ASSEMBLY_H
#define QN_CORE_ASSEMBLY_H

#include "core/contact-pair.h"
#include "core/contacts.h"
#include "core/model.h"
#include "core/pair-kinematics.h"
#include "core/result.h"

/* A force that acts away from the centroid of its block: in nonlinear geometry its arm turns. */
typedef struct QnEccentricLoad {
  int32_t unknown; /* rotation of the block */
  bool live;
  QnVec2 arm;    /* undeformed, m */
  QnVec2 turned; /* the arm at the last evaluation */
  QnVec2 force;  /* N */
} QnEccentricLoad;

typedef struct QnAssembly {
  const QnModel *model;
  const QnContacts *contacts;
  double length;  /* L, m */
  bool nonlinear; /* equilibrium in the deformed configuration */

  int32_t unknown_count;
  int32_t *unknown; /* block_count x 3: index of the unknown, or QN_NONE where fixed */

  size_t pair_count;
  QnPairKinematics *kinematics; /* of the last evaluation */
  QnPairSprings *springs;
  QnPairMemory *committed;   /* from which every evaluation starts */
  QnPairResponse *responses; /* of the last evaluation, or of the state taken back */

  double *dead,
    *live; /* loads on the unknowns, N; in nonlinear geometry of the last evaluation */
  double *dead_at_rest, *live_at_rest;
  QnEccentricLoad *eccentric;
  size_t eccentric_count;
  double *damping; /* diagonal of C, N/m: see qn_assembly_tangent() */
  double
    force_scale; /* largest dead load on a block, or live load where there is none, N */

  int32_t *ap, *ai; /* pattern of K in compressed columns, rows sorted */
  double *ax;
  int32_t *scatter;  /* face_count x 36: where a face's 6 x 6 goes in ax, or QN_NONE */
  int32_t *diagonal; /* unknown_count: where the diagonal stands in ax */
} QnAssembly;

/* Prepares everything that does not change during an analysis. `assembly` is overwritten
 * without being cleared; the model and the contacts must outlive it. */
QnStatus qn_assembly_setup (QnAssembly *assembly, const QnModel *model,
                            const QnContacts *contacts, QnDiag *diag);

void qn_assembly_clear (QnAssembly *assembly);

/* Evaluates every pair at the displacements u (unknown_count). Returns false where a pair's
 * internal iteration failed. */
bool qn_assembly_evaluate (QnAssembly *assembly, const double *u);

/* Brings the kinematics of pairs and loads to displacements u, without evaluating forces: for
 * taking up responses that were kept from an earlier evaluation at u. */
void qn_assembly_update_kinematics (QnAssembly *assembly, const double *u);

/* residual = F_dead + multiplier F_live - P of the last evaluation. Returns the largest load on
 * any unknown at this multiplier (at least force_scale), N, to measure the residual by. */
double qn_assembly_residual (const QnAssembly *assembly, double multiplier,
                             double *residual);

/* Assembles ax = K + viscosity C of the last evaluation, K = -dR/du at this multiplier (which
 * matters in nonlinear geometry only). C is a diagonal of stiffness size, distributed over the
 * blocks like their mass. */
void qn_assembly_tangent (QnAssembly *assembly, double multiplier, double viscosity);

/* Accepts the last evaluation as the state from which further ones start. */
void qn_assembly_commit (QnAssembly *assembly);

/* Opening of a pair at the last evaluation, beyond what the committed memory holds of
 * dilatancy, m: positive where the joint is open. */
double qn_assembly_gap (const QnAssembly *assembly, size_t pair);

/* Displacements of blocks (block_count x 3: m, m, rad) from unknowns. */
void qn_assembly_expand (const QnAssembly *assembly, const double *u,
                         double *displacements);

/* State, forces and springs of every pair at the last evaluation, which was at u. */
void qn_assembly_pair_results (const QnAssembly *assembly, const double *u,
                               QnPairResult *results);

#endif
