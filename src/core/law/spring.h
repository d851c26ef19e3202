/* One spring of a contact pair: a law resolved to forces and elongations.
 *
 * Elongation q and force f are (normal, tangential) pairs; normal components are positive in
 * opening and tension. The state of a spring (QnSpringMemory) changes only when a step is
 * committed. So the result of a step does not depend on the iterations before it.
 */
#pragma once

#include "core/law/law.h"

#include <math.h>

typedef struct QnSpring {
  QnLawKind kind;
  double kn; /* N/m */
  double ks; /* N/m */

  double friction; /* mu */
  double residual; /* mu of a joint whose bond is broken */
  double cohesion; /* N */
  double
    cap; /* largest normal force, N: the lower of cut-off and apex of the cone; tensile
                      strength of concrete */
  bool exponential; /* how the bond softens */
  bool
    outlasts; /* the other spring of its pair is too weak to break its bond or crack it */
  double energy[2];    /* J, to break the bond by opening and by slip; 0: brittle */
  double compression;  /* N, largest compression of a joint that is crushed; else 0 */
  double dilatancy;    /* psi */
  double dilation_end; /* m, slip beyond which dilation ends; INFINITY: never */
  bool associative;    /* dilation adds up, whichever way the joint slides */

  double yield;     /* N, end of the first elastic range */
  double hardening; /* part of kn that remains beyond */
  double strength;  /* N, largest force; of concrete in compression */
  double ultimate;  /* m, elongation (of concrete shortening) at which softening begins */
  double fracture;  /* m, plastic elongation of the opening crack or breaking bar */
  double crushing;  /* m, plastic shortening of concrete while it is crushed */

  const QnVec2 *points; /* of the law, which must outlive the spring */
  int32_t point_count;
  double force_scale, strain_scale; /* N and m per unit of the points */
  double stretch[2]; /* of the descending branches in tension and compression */
} QnSpring;

/* Plastic part of the elongation. */
typedef struct QnSpringMemory {
  double opening; /* m, opened by dilatancy or plastically; negative: shortened */
  double slip;    /* m, slid so far */
  double extreme; /* other state of a law, described in its file */
} QnSpringMemory;

/* What a spring, or a pair of springs, does. Of two different springs: OPEN if either is open, else SLIP if
 * either slips, else YIELD if either does. */
typedef enum {
  QN_PAIR_STICK, /* elastic, or on the curve of concrete */
  QN_PAIR_SLIP,
  QN_PAIR_OPEN,  /* no force, or that of a bond, crack or bar that is damaged */
  QN_PAIR_YIELD, /* plastic, crushed, or on a segment of a curve */
  QN_PAIR_STATE_COUNT
} QnPairState;

typedef struct QnSpringResponse {
  double force[2];       /* N */
  double tangent[2][2];  /* d force[i] / d q[j], N/m */
  QnSpringMemory memory; /* to commit if the step is accepted */
  QnPairState state;
  bool varies; /* the tangent differs from elongation to elongation */
} QnSpringResponse;

/* A strength of a joint in terms of its normal force n (tension positive) and shear force t, and
 * the flow where it is reached:
 *
 *   normal n + shear |t| <= limit        (shear is 0 or 1)
 *   opening += z opening,  slip += z shear sign (t),  z >= 0
 *
 * Flow is associative where opening = normal. Used by limit analysis, the interior-point increment
 * and the states of pairs. */
typedef struct QnStrengthRow {
  double normal, shear;
  double limit; /* N */
  double opening;
} QnStrengthRow;

/* Most strengths of one spring. */
enum { QN_STRENGTH_ROWS = 3 };

/* A spring of a contact pair with this law.
 *
 * area:   tributary length of the pair times thickness, or a bar's section, m2 (surface and
 *         material basis)
 * length: extent of the block's side behind the spring, m (material basis) */
QnSpring qn_spring_from_law (const QnLaw *law, double area, double length);

/* Shear force per compression up to which a joint without tension does not slide: an angle of 89.94
 * degrees. */
#define QN_NO_TENSION_FRICTION 1e3

/* Whether a joint has a bond, which opening and slip may break. */
static inline bool
qn_spring_has_bond (const QnSpring *spring)
{
  return qn_law_may_bond (spring->kind) && (spring->cap > 0 || spring->cohesion > 0);
}

/* Dilation of a joint by a slip from its initial position, m; 0 if dilation accumulates (`associative`). */
static inline double
qn_spring_dilation (const QnSpring *spring, double slip)
{
  return spring->associative
           ? 0
           : spring->dilatancy * fmin (fabs (slip), spring->dilation_end);
}

/* Dilation per further slip in the sense of `sign`. */
static inline double
qn_spring_dilation_rate (const QnSpring *spring, double slip, double sign)
{
  if (spring->associative)
    return spring->dilatancy;
  double along = sign * slip, end = spring->dilation_end;
  double rate = along < -end || along >= end ? 0 : spring->dilatancy;

  return along < 0 ? -rate : rate;
}

/* Plastic normal elongation less dilation, m: < 0 if the joint is crushed, else 0. */
static inline double
qn_spring_crushed (const QnSpring *spring, const QnSpringMemory *memory)
{
  return spring->associative
           ? fmin (memory->opening, 0)
           : memory->opening - qn_spring_dilation (spring, memory->slip);
}

/* Plastic normal elongation after further slip to `slip`, m. */
static inline double
qn_spring_risen (const QnSpring *spring, const QnSpringMemory *memory, double slip)
{
  return spring->associative
           ? memory->opening + spring->dilatancy * fabs (slip - memory->slip)
           : qn_spring_crushed (spring, memory) + qn_spring_dilation (spring, slip);
}

/* Encodes the damage of a bond that is held (qn_assembly_hold_bonds()), and decodes it. */
static inline double
qn_bond_held (double damage)
{
  return -1 - damage;
}

/* Response of a held bond above its strength. */
#define QN_BOND_BREAKS 2.0

/* Holds a bond that may break; false where there is none, or it is held as it is. */
static inline bool
qn_bond_hold (const QnSpring *spring, QnSpringMemory *memory)
{
  bool may_break =
    qn_spring_has_bond (spring) && memory->extreme >= 0 && memory->extreme < 1;

  if (may_break)
    memory->extreme = qn_bond_held (memory->extreme);
  return may_break;
}

/* Damage of the tensile stiffness of concrete by a crack with the largest opening `extreme`, m. */
static inline double
qn_spring_crack_damage (const QnSpring *spring, double extreme)
{
  double crack = spring->cap / spring->kn, open = spring->fracture;

  return extreme <= crack ? 0
         : extreme < open ? 1 - crack / extreme * (open - extreme) / (open - crack)
                          : 1;
}

/* Damage of the bond, or of concrete in tension: 0 whole, 1 broken; 0 for other springs. */
static inline double
qn_spring_damage (const QnSpring *spring, const QnSpringMemory *memory)
{
  if (spring->kind == QN_LAW_CONCRETE && spring->cap > 0)
    return qn_spring_crack_damage (spring, memory->extreme);
  double damage = qn_spring_has_bond (spring) ? memory->extreme : 0;

  return damage < 0 ? qn_bond_held (damage) : fmin (damage, 1);
}

/* The spring after its bond has broken; the spring in the present state. */
QnSpring qn_spring_broken (const QnSpring *spring);

static inline QnSpring
qn_spring_now (const QnSpring *spring, const QnSpringMemory *memory)
{
  return qn_spring_damage (spring, memory) < 1 ? *spring : qn_spring_broken (spring);
}

/* Least tensile strength over cohesion, and cohesion over tensile strength, of a bond: rounding does not
 * break it. */
#define QN_BOND_ROUNDING 1e-6

/* Removes tension, cohesion and dilatancy; stiffness and friction stay. Springs of members become no-tension
 * springs of the same stiffness. */
void qn_spring_lose_bond (QnSpring *spring);

/* Force and consistent tangent at elongation q, m, from the committed memory. */
void qn_spring_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                         const double q[2], QnSpringResponse *response);

/* Strengths of a spring with whole bond; returns their number, 0 if the law has none. */
int qn_spring_strength (const QnSpring *spring, QnStrengthRow rows[QN_STRENGTH_ROWS]);

/* Strengths for limit analysis: as qn_spring_strength(), but no-tension joints, which do not slide, have the
 * limit of tension alone. */
int qn_spring_rigid_strength (const QnSpring *spring,
                              QnStrengthRow rows[QN_STRENGTH_ROWS]);

/* Whether the rows of qn_spring_strength() are all limits of the law, as limit analysis needs. */
bool qn_law_has_strength (QnLawKind kind);

/* Whether the law is elastic and perfectly plastic within its strengths. */
bool qn_law_is_plastic (QnLawKind kind);

/* Whether a spring has such a law, and crushing does not reduce its strength. */
static inline bool
qn_spring_is_plastic (const QnSpring *spring)
{
  return qn_law_is_plastic (spring->kind) && spring->crushing == 0;
}

/* Whether a kind of law limits the compressive force. */
bool qn_law_yields (QnLawKind kind);

/* Whether springs of a kind of law may soften. */
bool qn_law_softens (QnLawKind kind);

/* Steepest descent of the normal force with growing elongation, N/m; 0 where there is none,
 * INFINITY where the law has too little fracture energy for the spring's length: it would snap
 * back. */
double qn_spring_softening (const QnSpring *spring);

/* Whether two springs differ only by their length: then equal forces have proportional elongations, and one
 * spring of their total length replaces both. */
bool qn_spring_similar (const QnSpring *a, const QnSpring *b);

/* The spring that replaces both. It softens as one of them does: a crack opens in one place. */
QnSpring qn_spring_join (const QnSpring *a, const QnSpring *b);
