/* Constitutive laws of the springs: what relates elongation and force.
 *
 * A contact pair has two springs in series, one on each block's side, each with a law of its
 * own. A law answers for one spring: given the elongation q = (normal, tangential) and what
 * the spring remembers from the last committed step, it returns the force and the consistent
 * tangent. Normal components are positive in opening (tension).
 */
#ifndef QN_CORE_LAW_H
#define QN_CORE_LAW_H

#include "core/status.h"

typedef enum {
  QN_LAW_ELASTIC,    /* linear in both directions, in tension too */
  QN_LAW_NO_TENSION, /* linear while closed, nothing while open; no slip limit */
  QN_LAW_COULOMB,    /* friction, cohesion, tension cut-off, dilatancy */
  QN_LAW_KIND_COUNT
} QnLawKind;

typedef enum {
  QN_BASIS_CONTACT, /* kn, ks in N/m; cohesion, tension in N; per pair, whatever its size */
  QN_BASIS_SURFACE, /* kn, ks in Pa/m; cohesion, tension in Pa; times the pair's area */
  QN_BASIS_MATERIAL, /* kn, ks moduli in Pa; times area over the length of the block's side */
  QN_BASIS_COUNT
} QnBasis;

typedef struct QnLaw {
  char *name; /* owned */
  QnLawKind kind;
  QnBasis basis;
  double kn;        /* > 0, stiffness of ONE spring in the normal direction */
  double ks;        /* > 0, the same, tangential */
  double friction;  /* mu >= 0, tangent of the friction angle */
  double cohesion;  /* c >= 0 */
  double tension;   /* ft >= 0, tension cut-off; the cone's apex c/mu bounds it as well */
  double dilatancy; /* psi, 0 <= psi <= mu: plastic opening per slip; mu = associative */
} QnLaw;

/* The name used in project files: "elastic", "no-tension", "coulomb". */
const char *qn_law_kind_name (QnLawKind kind);
const char *qn_basis_name (QnBasis basis);

/* Checks the parameters of one law; `index` is for the diagnostic. */
QnStatus qn_law_check (const QnLaw *law, QnId index, QnDiag *diag);

void qn_law_clear (QnLaw *law);

#endif
