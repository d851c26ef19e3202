/* One spring of a contact pair: a law resolved to forces and elongations.
 *
 * Elongation q and force f are (normal, tangential) pairs; normal components are positive in
 * opening and tension. What a spring remembers is advanced only when a step is committed:
 * evaluating it any number of times from the same memory gives the same answer, so the result
 * of a step does not depend on the iterations that led to it.
 */
#ifndef QN_CORE_SPRING_H
#define QN_CORE_SPRING_H

#include "core/law.h"

typedef struct QnSpring {
  QnLawKind kind;
  double kn;       /* N/m */
  double ks;       /* N/m */
  double friction; /* mu */
  double cohesion; /* N */
  double cap; /* largest normal force, N: the lower of cut-off and apex of the cone */
  double
    cap_strength;   /* shear strength left at the cap, N; 0 where the apex is the cap */
  double dilatancy; /* psi */
} QnSpring;

/* Plastic part of the elongation: what of q does not strain the spring. */
typedef struct QnSpringMemory {
  double opening; /* m, opened by dilatancy */
  double slip;    /* m, slid so far */
} QnSpringMemory;

/* What a spring, or a pair of springs, is doing. The tangent of a spring with one of the
 * laws of this header depends on its phase alone. */
typedef enum {
  QN_PHASE_STICK,
  QN_PHASE_SLIP_POSITIVE, /* slips, shear force >= 0 */
  QN_PHASE_SLIP_NEGATIVE,
  QN_PHASE_OPEN,       /* at the cap of the normal force, no shear strength left */
  QN_PHASE_OPEN_STICK, /* at the cap with shear strength left, not slipping */
  QN_PHASE_OPEN_SLIP_POSITIVE, /* at the cap, slipping */
  QN_PHASE_OPEN_SLIP_NEGATIVE,
  QN_PHASE_COUNT
} QnPhase;

typedef struct QnSpringResponse {
  double force[2];       /* N */
  double tangent[2][2];  /* d force[i] / d q[j], N/m */
  QnSpringMemory memory; /* to commit if the step is accepted */
  QnPhase phase;
} QnSpringResponse;

/* The spring that a law makes of a pair.
 *
 * area:   tributary length of the pair times thickness, m2 (surface and material basis)
 * length: extent of the block's side behind the spring, m (material basis) */
QnSpring qn_spring_from_law (const QnLaw *law, double area, double length);

/* Force and consistent tangent at elongation q, starting from what was last committed. */
void qn_spring_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                         const double q[2], QnSpringResponse *response);

/* Whether two springs have the same parameters. */
bool qn_spring_equal (const QnSpring *a, const QnSpring *b);

/* Row of one law in the table of qn_spring_evaluate(); one file per law. */
void qn_law_elastic_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                              const double q[2], QnSpringResponse *response);
void qn_law_no_tension_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                                 const double q[2], QnSpringResponse *response);
void qn_law_coulomb_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                              const double q[2], QnSpringResponse *response);

#endif
