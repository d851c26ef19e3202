/* Functions of a constitutive law; private to laws and springs. One file and one row of each of the two
 * tables in law-ops.c per law. */
#pragma once

#include "core/base/require.h"
#include "core/law/spring.h"

/* How the units of a law become those of a spring. */
typedef struct QnLawScale {
  double force;  /* N per unit of strength */
  double strain; /* m per unit of elongation */
} QnLawScale;

typedef struct QnLawOps {
  const QnLawParameter *parameters;
  size_t parameter_count;

  /* Checks rules between parameters, after each number by itself; nullable. */
  bool (*check) (const QnLaw *law, QnSubject of);

  /* Sets the fields of the spring that this law needs; nullable. kind, kn and ks are set before. */
  void (*resolve) (const QnLaw *law, QnLawScale scale, QnSpring *spring);

  /* Force, N, and tangent, N/m, at the elongation q, m, from the committed memory. */
  void (*evaluate) (const QnSpring *spring, const QnSpringMemory *committed,
                    const double q[2], QnSpringResponse *response);

  /* The strengths of a joint, at most QN_STRENGTH_ROWS; returns their number. NULL: no limit analysis. */
  int (*strength) (const QnSpring *spring, QnStrengthRow rows[]);

  /* Whether the law is elastic and perfectly plastic with these strengths and their flow, one
   * of them a limit of tension, at most one of compression and one of shear. Then increments
   * can be solved by interior points (core/equilibrium/central-path.h). */
  bool plastic;

  /* Steepest descent of the normal force, N/m; nullable for laws that never soften. INFINITY
   * where a softening branch would snap back. */
  double (*softening) (const QnSpring *spring);
} QnLawOps;

#define QN_LAW_PARAMETERS(table)                                                         \
  .parameters = table, .parameter_count = QN_N_ELEMENTS (table)

/* A key of project files, where read_parameters() in io/project/project-law.c reads it, with the
 * member of QnLaw that takes it. */
#define QN_LAW_PARAMETER(name, member, is_required, is_positive)                         \
  {                                                                                      \
    .key = name, .offset = offsetof (QnLaw, member), .required = is_required,            \
    .positive = is_positive                                                              \
  }

/* The functions of a kind of law; static. */
const QnLawOps *qn_law_ops (QnLawKind kind);

extern const QnLawOps qn_law_ops_elastic;
extern const QnLawOps qn_law_ops_no_tension;
extern const QnLawOps qn_law_ops_coulomb;
extern const QnLawOps qn_law_ops_mohr_coulomb;
extern const QnLawOps qn_law_ops_bilinear;
extern const QnLawOps qn_law_ops_elastic_plastic;
extern const QnLawOps qn_law_ops_concrete;
extern const QnLawOps qn_law_ops_steel;
extern const QnLawOps qn_law_ops_curve;

/* Coulomb's law, part of others; see law-coulomb.c. */
void qn_law_coulomb_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                              const double q[2], QnSpringResponse *response);
int qn_law_coulomb_strength (const QnSpring *spring, QnStrengthRow rows[]);

/* Kinematic hardening in the normal direction, elastic shear; see law-bilinear.c. */
void qn_law_bilinear_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                               const double q[2], QnSpringResponse *response);
