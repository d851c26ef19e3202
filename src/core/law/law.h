/* Constitutive laws of the springs: the force as a function of the elongation.
 *
 * A contact pair has two springs in series, one on each block's side, each with a law of its own. A
 * law belongs to one spring: from the elongation q = (normal, tangential) and the memory of the last
 * committed step it computes the force and the consistent tangent. Normal components are positive
 * in opening (tension).
 *
 * Four kinds are joints, whose two directions belong together; the others describe the fibres
 * of a continuous member: nonlinear in the normal direction, linear elastic in shear.
 */
#pragma once

#include "core/base/status.h"

/* Most points of a curve. */
#define QN_MAX_CURVE_POINTS 32

typedef enum {
  QN_LAW_ELASTIC,    /* linear in both directions, in tension too */
  QN_LAW_NO_TENSION, /* linear while closed, nothing while open; slides only as it opens */
  QN_LAW_COULOMB,    /* friction, cohesion, tension cut-off, dilatancy */
  QN_LAW_MOHR_COULOMB,    /* the same with a limit of compression */
  QN_LAW_BILINEAR,        /* linear kinematic hardening */
  QN_LAW_ELASTIC_PLASTIC, /* the same without hardening */
  QN_LAW_CONCRETE,        /* parabola and rectangle; tension with a fracture energy */
  QN_LAW_STEEL,           /* bilinear up to a strength, may break */
  QN_LAW_CURVE,           /* points joined by straight lines, elastic unloading */
  QN_LAW_KIND_COUNT
} QnLawKind;

typedef enum {
  QN_BASIS_CONTACT, /* N/m, N: per pair, whatever its size; elongations in m */
  QN_BASIS_SURFACE, /* Pa/m, Pa: times the pair's area; elongations in m */
  QN_BASIS_MATERIAL, /* Pa, Pa: times the area; strains, over the length of the block's side */
  QN_BASIS_COUNT
} QnBasis;

/* How the blocks of a continuous member lie, on which the shear stiffness of its joints depends. */
typedef enum {
  QN_ARRANGEMENT_CHAIN, /* one behind the other: G = E / (2 (1 + nu)) */
  QN_ARRANGEMENT_GRID, /* in rows and columns: 2 G, because blocks that turn freely share the shear strain
                           between both families of joints */
  QN_ARRANGEMENT_COUNT
} QnArrangement;

/* Strengths are forces per pair (contact) or stresses (surface, material); energies are J per
 * pair or J/m2. qn_law_parameters() lists the parameters of
 * a kind; it ignores all others. */
typedef struct QnLaw {
  char *name; /* owned */
  char *
    source; /* source of the numbers of the law, as text, or NULL; owned; not used by the core */
  QnLawKind kind;
  QnBasis basis;
  double kn;           /* > 0, stiffness of ONE spring in the normal direction */
  double ks;           /* > 0, the same, tangential */
  double shear_factor; /* > 0, multiplies ks: 5/6 for the section of a rectangular member;
                          0 stands for 1 */
  double elasticity;   /* E, Pa, of the basis material, which gives kn and ks;
                          0: kn and ks were given */
  double poisson;      /* 0 <= nu < 1/2, with an elasticity */
  QnArrangement arrangement; /* with an elasticity */
  double friction;           /* mu >= 0, tangent of the friction angle */
  double cohesion;           /* c >= 0, of a joint whose bond is whole */
  double
    tension; /* ft >= 0, of a joint whose bond is whole; at most the apex c/mu acts */
  double residual_friction; /* > 0, once the bond is broken; 0 stands for `friction` */
  double fracture_energy_tension; /* >= 0, to break a bond by opening; 0: brittle */
  double
    fracture_energy_shear; /* >= 0, to break a bond by slip, without friction; 0: as by opening */
  bool exponential;   /* whether a bond softens along an exponential curve, not a line */
  double compression; /* fc > 0, limit of compression, at which a joint is crushed */
  double dilatancy; /* psi, 0 <= psi <= mu: plastic opening per slip; mu = associative */
  double
    dilation_end; /* > 0, m whatever the basis: slip beyond which dilation ends; 0: never */
  double yield;   /* > 0, end of the first elastic range */
  double hardening; /* 0 <= r < 1, part of kn that remains beyond yield */
  double strength;  /* > 0, largest force or stress; of concrete in compression */
  double
    ultimate_strain; /* > 0 where it is used, positive in compression too: strain (m for
                             the contact and surface bases) at which the strength is spent */
  double fracture_energy; /* >= 0, to open a crack, or break a bar, for good */
  double
    crushing_energy; /* >= 0, to crush concrete for good beyond its ultimate strain */
  int32_t point_count;
  QnVec2 points[QN_MAX_CURVE_POINTS]; /* (elongation or strain, force or stress), from
                                         compression to tension */
  int32_t note;                       /* of the layers above; see QnBlock */
} QnLaw;

/* A number that a kind of law has besides kn, ks and shear_factor. */
typedef struct QnLawParameter {
  const char *key; /* as in project files */
  size_t offset;   /* of the double in QnLaw */
  bool required;
  bool positive; /* > 0 wherever it is given; >= 0 otherwise */
} QnLawParameter;

/* The parameters of a kind, in the order of project files; a static array. */
const QnLawParameter *qn_law_parameters (QnLawKind kind, size_t *count);

/* Value of a parameter; its address, to set it. */
double qn_law_get (const QnLaw *law, const QnLawParameter *parameter);
double *qn_law_at (QnLaw *law, const QnLawParameter *parameter);

/* The name used in project files: "elastic", "no-tension", "coulomb", "mohr-coulomb", "bilinear",
 * "elastic-plastic", "concrete", "steel", "curve". */
extern const char *const qn_law_kind_names[QN_LAW_KIND_COUNT];
extern const char *const qn_basis_names[QN_BASIS_COUNT];
extern const char *const qn_arrangement_names[QN_ARRANGEMENT_COUNT];

/* If the law has an elasticity: sets kn = E, and ks so that the member has the shear stiffness of the
 * continuum. In a grid of rigid blocks with ks = k the energy of the shear strain gamma is the least of
 * k [(u_y,x - phi)^2 + (u_x,y + phi)^2] / 2 over the rotation phi,
 * k gamma^2 / 4: half of that at phi = 0. */
void qn_law_derive (QnLaw *law);

/* How the bond of a joint softens in project files: "linear", "exponential". */
extern const char *const qn_law_softening_names[2];

/* Checks the parameters of one law; `index` is for the diagnostic. */
QnStatus qn_law_check (const QnLaw *law, QnId index, QnDiag *diag);

/* Whether joints of this kind have a friction cone, and may have a bond (cohesion, tension) that breaks. */
static inline bool
qn_law_may_bond (QnLawKind kind)
{
  return kind == QN_LAW_COULOMB || kind == QN_LAW_MOHR_COULOMB;
}

/* Whether joints of this law have a bond: cohesion, or tension below the apex of the cone. */
bool qn_law_has_bond (const QnLaw *law);

/* Sets the parameters to those of joints whose bond is broken. */
void qn_law_break_bond (QnLaw *law);

/* Copies all of a law but its name and note; false, with nothing
 * changed, when memory runs out. */
bool qn_law_assign (QnLaw *law, const QnLaw *from);

void qn_law_clear (QnLaw *law);
