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
  double dilation_end; /* m, slip beyond which nothing dilates; INFINITY: none */
  bool associative;    /* dilation adds up, whichever way the joint slides */

  double yield;     /* N, where the elastic range first ends */
  double hardening; /* part of kn that remains beyond */
  double strength;  /* N, the most that is carried; of concrete in compression */
  double ultimate;  /* m, elongation (of concrete shortening) at which softening begins */
  double fracture;  /* m, plastic elongation of the opening crack or breaking bar */
  double crushing;  /* m, plastic shortening of concrete while it is crushed */

  const QnVec2 *points; /* of the law, which must outlive the spring */
  int32_t point_count;
  double force_scale, strain_scale; /* N and m per unit of the points */
  double stretch[2]; /* of the descending branches in tension and compression */
} QnSpring;

/* Plastic part of the elongation: what of q does not strain the spring. */
typedef struct QnSpringMemory {
  double opening; /* m, opened by dilatancy or plastically; negative: shortened */
  double slip;    /* m, slid so far */
  double extreme; /* other state of a law, described in its file */
} QnSpringMemory;

/* What a spring, or a pair of springs, is doing. The tangent of a spring depends on its law and
 * its phase alone, unless its response says that it varies. */
typedef enum {
  QN_PHASE_STICK,         /* elastic */
  QN_PHASE_SLIP_POSITIVE, /* slips, shear force >= 0 */
  QN_PHASE_SLIP_NEGATIVE,
  QN_PHASE_OPEN,           /* carries nothing, or what is left of its bond */
  QN_PHASE_YIELD_POSITIVE, /* plastic in tension */
  QN_PHASE_YIELD_NEGATIVE, /* plastic in compression */
  QN_PHASE_YIELD_FULLY,    /* plastic without hardening any more, either way */
  QN_PHASE_CURVED,         /* on a branch that is no straight line */
  QN_PHASE_SOFTEN,         /* a crack opens, a bar breaks */
  QN_PHASE_CRACKED,        /* a crack closes or reopens, still carrying tension */
  QN_PHASE_CRUSH,          /* is being crushed; a joint's shear is elastic meanwhile, */
  QN_PHASE_CRUSH_SLIP_POSITIVE, /* or slips */
  QN_PHASE_CRUSH_SLIP_NEGATIVE,
  QN_PHASE_BROKEN,  /* carries nothing any more */
  QN_PHASE_SEGMENT, /* on a segment of a curve: number added, tension before compression */
  QN_PHASE_COUNT = QN_PHASE_SEGMENT + 2 * (QN_MAX_CURVE_POINTS + 1)
} QnPhase;

typedef struct QnSpringResponse {
  double force[2];       /* N */
  double tangent[2][2];  /* d force[i] / d q[j], N/m */
  QnSpringMemory memory; /* to commit if the step is accepted */
  QnPhase phase;
  bool varies; /* the tangent does not follow from the phase */
} QnSpringResponse;

/* A strength of a joint in terms of its normal force n (tension positive) and shear force t, and
 * the flow where it is reached:
 *
 *   normal n + shear |t| <= limit        (shear is 0 or 1)
 *   opening += z opening,  slip += z shear sign (t),  z >= 0
 *
 * Flow is associative where opening = normal. What consumes these rows: limit analysis, the
 * interior-point increment, the states of pairs. */
typedef struct QnStrengthRow {
  double normal, shear;
  double limit; /* N */
  double opening;
} QnStrengthRow;

/* Most strengths of one spring. */
enum { QN_STRENGTH_ROWS = 3 };

/* The spring that a law makes of a pair.
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

/* How far a joint has risen by a slip from where it was built, m; 0 where the way there counts. */
static inline double
qn_spring_dilation (const QnSpring *spring, double slip)
{
  return spring->associative
           ? 0
           : spring->dilatancy * fmin (fabs (slip), spring->dilation_end);
}

/* The same per slip that goes on from there in the sense of `sign`. */
static inline double
qn_spring_dilation_rate (const QnSpring *spring, double slip, double sign)
{
  if (spring->associative)
    return spring->dilatancy;
  double along = sign * slip, end = spring->dilation_end;
  double rate = along < -end || along >= end ? 0 : spring->dilatancy;

  return along < 0 ? -rate : rate;
}

/* Its plastic elongation without what it has risen, m: negative where it is crushed, else 0. */
static inline double
qn_spring_crushed (const QnSpring *spring, const QnSpringMemory *memory)
{
  return spring->associative
           ? fmin (memory->opening, 0)
           : memory->opening - qn_spring_dilation (spring, memory->slip);
}

/* What its plastic elongation is once it has slid from there to `slip`, m. */
static inline double
qn_spring_risen (const QnSpring *spring, const QnSpringMemory *memory, double slip)
{
  return spring->associative
           ? memory->opening + spring->dilatancy * fabs (slip - memory->slip)
           : qn_spring_crushed (spring, memory) + qn_spring_dilation (spring, slip);
}

/* In place of the damage of a bond that is not to break at once for now, and the other way round. */
static inline double
qn_bond_held (double damage)
{
  return -1 - damage;
}

/* What such a bond answers where it is to break. */
#define QN_BOND_BREAKS 2.0

/* How much of the stiffness of concrete in tension a crack has taken, whose widest opening was `extreme`. */
static inline double
qn_spring_crack_damage (const QnSpring *spring, double extreme)
{
  double crack = spring->cap / spring->kn, open = spring->fracture;

  return extreme <= crack ? 0
         : extreme < open ? 1 - crack / extreme * (open - extreme) / (open - crack)
                          : 1;
}

/* How much of the bond, or of concrete in tension, is lost: 0 whole, 1 broken; 0 of springs without. */
static inline double
qn_spring_damage (const QnSpring *spring, const QnSpringMemory *memory)
{
  if (spring->kind == QN_LAW_CONCRETE && spring->cap > 0)
    return qn_spring_crack_damage (spring, memory->extreme);
  double damage = qn_spring_has_bond (spring) ? memory->extreme : 0;

  return damage < 0 ? qn_bond_held (damage) : fmin (damage, 1);
}

/* The spring of a joint whose bond is broken, and that which it is in this state. */
QnSpring qn_spring_broken (const QnSpring *spring);

static inline QnSpring
qn_spring_now (const QnSpring *spring, const QnSpringMemory *memory)
{
  return qn_spring_damage (spring, memory) < 1 ? *spring : qn_spring_broken (spring);
}

/* A bond of cohesion alone does not break by tension that is rounding, nor one of tension by such shear:
 * below this part of the other strength. */
#define QN_BOND_ROUNDING 1e-6

/* Leaves what two bodies offer each other that were never joined: stiffness and friction, no tension, no
 * cohesion, no dilatancy. Of a law that is not a joint's the stiffness alone is left. */
void qn_spring_lose_bond (QnSpring *spring);

/* Force and consistent tangent at elongation q, starting from what was last committed. */
void qn_spring_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                         const double q[2], QnSpringResponse *response);

/* The strengths of a spring whose bond is whole; returns their number, 0 for a law that has none. */
int qn_spring_strength (const QnSpring *spring, QnStrengthRow rows[QN_STRENGTH_ROWS]);

/* Those that limit analysis takes: the same, but of a joint without tension that of opening alone, for
 * rigid blocks that do not slide have no other. */
int qn_spring_rigid_strength (const QnSpring *spring,
                              QnStrengthRow rows[QN_STRENGTH_ROWS]);

/* Whether the rows of qn_spring_strength() are all limits of the law, as limit analysis needs. */
bool qn_law_has_strength (QnLawKind kind);

/* Whether the law is elastic and perfectly plastic within its strengths. */
bool qn_law_is_plastic (QnLawKind kind);

/* The same of a spring: not one that crushing takes its strength. */
static inline bool
qn_spring_is_plastic (const QnSpring *spring)
{
  return qn_law_is_plastic (spring->kind) && spring->crushing == 0;
}

/* Whether a kind of law limits compression otherwise than by its stiffness. */
bool qn_law_yields (QnLawKind kind);

/* Whether springs of a kind of law may soften. */
bool qn_law_softens (QnLawKind kind);

/* Steepest descent of the normal force with growing elongation, N/m; 0 where there is none,
 * INFINITY where the law has too little fracture energy for the spring's length: it would snap
 * back. */
double qn_spring_softening (const QnSpring *spring);

/* Whether two springs differ by their length only: then they carry equal forces at elongations
 * in one proportion, and one spring of their joint length stands for both. */
bool qn_spring_similar (const QnSpring *a, const QnSpring *b);

/* That spring. What softens, softens once: a crack opens in one place. */
QnSpring qn_spring_join (const QnSpring *a, const QnSpring *b);
