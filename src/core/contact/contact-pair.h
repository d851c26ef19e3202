/* A contact pair: two springs in series between points A and B, with the hinge C condensed.
 *
 * The elongation of the pair, q = (normal, tangential) position of B relative to A, is shared
 * by the two springs, q = qa + qb, so that both carry the same force: fa(qa) = fb(q - qa).
 * Two springs of one law are replaced by one spring of their total length (closed form). Two laws:
 * internal Newton iteration (HybriDFEM, section 2.2; see pair-series.h).
 */
#pragma once

#include "core/law/spring.h"

typedef struct QnPairSprings {
  QnSpring a, b; /* side of block a, side of block b */
  bool equal;    /* `a` is the whole pair; `b` is unchanged */
  double slant;  /* bars: sine of the angle from the pair's normal towards its tangent */
} QnPairSprings;

/* State of a pair between steps. */
typedef struct QnPairMemory {
  QnSpringMemory a, b; /* of equal springs only `a` is used, for the pair as a whole */
  double qa[2], qb[2]; /* elongations of the two springs at the last commit, m */
} QnPairMemory;

typedef struct QnPairResponse {
  double force[2];
  double tangent[2][2];
  QnPairMemory memory;
  QnPairState state;
  bool varies; /* as of a spring */
} QnPairResponse;

/* The springs on the two sides of a pair in series; equal ones are joined into one. */
QnPairSprings qn_pair_springs (QnSpring a, QnSpring b);

/* Elastic stiffness of both springs together, normal and tangential, N/m. */
void qn_pair_elastic_stiffness (const QnPairSprings *springs, double k[2]);

/* Tangent for small vibrations. A joint compressed by more than `little` (N): elastic, or with `sliding`
 * its own tangent. Any other joint: elastic x the undamaged share of its bond, 0 without bond. Pairs that
 * are no joints: their own tangent. */
void qn_pair_vibration_tangent (const QnPairSprings *springs,
                                const QnPairResponse *response, double little,
                                bool sliding, double tangent[4]);

/* Damage of the bond of a joint: 0 whole, 1 broken; 0 without a bond. */
static inline double
qn_pair_damage (const QnPairSprings *springs, const QnPairMemory *memory)
{
  double a = qn_spring_damage (&springs->a, &memory->a);
  double b = springs->equal ? 0 : qn_spring_damage (&springs->b, &memory->b);

  return a > b ? a : b;
}

/* The springs after their bonds have broken. */
QnPairSprings qn_pair_springs_broken (const QnPairSprings *springs);

/* Force over the strength of a whole bond, which breaks at 1; NAN without a bond. */
double qn_spring_bond_strain (const QnSpring *spring, const double force[2]);

/* The same ratio for a pair; NAN once the bond is damaged. */
double qn_pair_bond_strain (const QnPairSprings *springs, const QnPairResponse *response);

/* Copies the damage of another state. */
static inline void
qn_pair_keep_damage (const QnPairSprings *springs, const QnPairMemory *from,
                     QnPairMemory *memory)
{
  if (qn_spring_has_bond (&springs->a))
    memory->a.extreme = from->a.extreme;
  if (qn_spring_has_bond (&springs->b))
    memory->b.extreme = from->b.extreme;
}

/* Whether the whole pair has one elastic, perfectly plastic law, as the interior-point increment requires;
 * false while a bond may still break. */
static inline bool
qn_pair_is_plastic (const QnPairSprings *springs, const QnPairMemory *memory)
{
  return springs->equal && qn_spring_is_plastic (&springs->a)
         && (!qn_spring_has_bond (&springs->a) || memory->a.extreme >= 1);
}

/* Whether the pair would snap back while one of its springs softens: no force then belongs to a growing
 * elongation. Remedy: larger fracture energy or smaller blocks. */
bool qn_pair_springs_snap_back (const QnPairSprings *springs);

/* Strengths of both springs with the present damage of their bonds: fills `rows`, returns their number. */
static inline int
qn_pair_strength (const QnPairSprings *springs, const QnPairMemory *memory,
                  QnStrengthRow rows[2 * QN_STRENGTH_ROWS])
{
  QnSpring a = qn_spring_now (&springs->a, &memory->a);
  QnSpring b = qn_spring_now (&springs->b, &memory->b);
  int count = qn_spring_strength (&a, rows);

  return springs->equal ? count : count + qn_spring_strength (&b, rows + count);
}

/* Strengths for limit analysis of rigid blocks, bonds whole. */
static inline int
qn_pair_rigid_strength (const QnPairSprings *springs,
                        QnStrengthRow rows[2 * QN_STRENGTH_ROWS])
{
  int count = qn_spring_rigid_strength (&springs->a, rows);

  return springs->equal ? count
                        : count + qn_spring_rigid_strength (&springs->b, rows + count);
}

/* Force and consistent tangent of the pair at elongation q. Returns false where the internal
 * iteration did not converge; the response is then not to be used. */
bool qn_pair_evaluate (const QnPairSprings *springs, const QnPairMemory *committed,
                       const double q[2], QnPairResponse *response);

/* Corrects the state OPEN or SLIP of an elastic, perfectly plastic joint by its force, which the central
 * path finds more accurately than the flow: OPEN or SLIP remains if the force is within `little` (N) of
 * that strength. */
QnPairState qn_pair_state_of_force (const QnPairSprings *springs,
                                    const QnPairMemory *memory, QnPairState state,
                                    const double force[2], double little);
