/* A contact pair: two springs in series between points A and B, with the hinge C condensed.
 *
 * The elongation of the pair, q = (normal, tangential) position of B relative to A, is shared
 * by the two springs, q = qa + qb, so that both carry the same force: fa(qa) = fb(q - qa).
 * Springs of one law, of whatever two lengths, make one spring of their joint length (closed
 * form); others are solved by an internal Newton iteration (HybriDFEM, section 2.2; see
 * pair-series.h).
 */
#pragma once

#include "core/law/spring.h"

typedef struct QnPairSprings {
  QnSpring a, b; /* side of block a, side of block b */
  bool equal;    /* `a` then stands for the whole pair; `b` is as it was given */
  double
    slant; /* sine of the angle by which the springs are turned from the pair's frame, from
                    its normal towards its tangent: of bars; their elongations are along them */
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
  int16_t phase; /* the tangent depends on this number alone, */
  bool varies;   /* unless it varies */
} QnPairResponse;

/* The springs on the two sides of a pair in series; equal ones are joined into one. */
QnPairSprings qn_pair_springs (QnSpring a, QnSpring b);

/* Elastic stiffness of both springs together, normal and tangential, N/m. */
void qn_pair_elastic_stiffness (const QnPairSprings *springs, double k[2]);

/* The tangent for small vibrations. Of a joint that is pressed together by more than `little`: elastic, or
 * as it slides. Of any other: what is whole of its bond, elastic. What is no joint keeps its own. */
void qn_pair_vibration_tangent (const QnPairSprings *springs,
                                const QnPairResponse *response, double little,
                                bool sliding, double tangent[4]);

/* How much of the bond of a joint is lost: 0 whole, 1 broken; 0 of joints without a bond. */
static inline double
qn_pair_damage (const QnPairSprings *springs, const QnPairMemory *memory)
{
  double a = qn_spring_damage (&springs->a, &memory->a);
  double b = springs->equal ? 0 : qn_spring_damage (&springs->b, &memory->b);

  return a > b ? a : b;
}

/* Those of a pair whose bonds are broken. */
QnPairSprings qn_pair_springs_broken (const QnPairSprings *springs);

/* How near a force is to breaking a whole bond, which it does at 1; NAN where there is none. */
double qn_spring_bond_strain (const QnSpring *spring, const double force[2]);

/* The same of a pair; NAN once it is damaged. */
double qn_pair_bond_strain (const QnPairSprings *springs, const QnPairResponse *response);

/* Takes over the damage of another state. */
static inline void
qn_pair_keep_damage (const QnPairSprings *springs, const QnPairMemory *from,
                     QnPairMemory *memory)
{
  if (qn_spring_has_bond (&springs->a))
    memory->a.extreme = from->a.extreme;
  if (qn_spring_has_bond (&springs->b))
    memory->b.extreme = from->b.extreme;
}

/* Whether one law, elastic and perfectly plastic, rules the whole pair: the interior-point
 * increment solves those. A bond is none as long as it may break. */
static inline bool
qn_pair_is_plastic (const QnPairSprings *springs, const QnPairMemory *memory)
{
  return springs->equal && qn_spring_is_plastic (&springs->a)
         && (!qn_spring_has_bond (&springs->a) || memory->a.extreme >= 1);
}

/* Whether the pair would snap back while one of its springs softens: growing elongation of the
 * pair then has no answer. The remedy is a larger fracture energy or smaller blocks. */
bool qn_pair_springs_snap_back (const QnPairSprings *springs);

/* The strengths of both springs, whose bonds are broken or not: fills `rows`, returns how many they are. */
static inline int
qn_pair_strength (const QnPairSprings *springs, const QnPairMemory *memory,
                  QnStrengthRow rows[2 * QN_STRENGTH_ROWS])
{
  QnSpring a = qn_spring_now (&springs->a, &memory->a);
  QnSpring b = qn_spring_now (&springs->b, &memory->b);
  int count = qn_spring_strength (&a, rows);

  return springs->equal ? count : count + qn_spring_strength (&b, rows + count);
}

/* Those of rigid blocks, bonds whole. */
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

/* What is reported of a phase. Of unequal springs one that is open makes the pair open, else one
 * that slips makes it slip, else one that yields makes it yield: on the plastic branch of a member's
 * law, or being crushed. */
typedef enum {
  QN_PAIR_STICK,
  QN_PAIR_SLIP,
  QN_PAIR_OPEN,
  QN_PAIR_YIELD,
  QN_PAIR_STATE_COUNT
} QnPairState;

/* What a phase of these springs is called. */
QnPairState qn_pair_state (const QnPairSprings *springs, int16_t phase);

/* The state that a joint, elastic and perfectly plastic, is in with this force, where its phase says
 * `state`: an increment along the central path knows forces better than whether a joint flows. Open, or
 * sliding, is one within `little` of that strength. */
QnPairState qn_pair_state_of_force (const QnPairSprings *springs,
                                    const QnPairMemory *memory, QnPairState state,
                                    const double force[2], double little);
