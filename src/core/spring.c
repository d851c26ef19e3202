#include "core/spring.h"

typedef void (*QnSpringEvaluate) (const QnSpring *spring, const QnSpringMemory *committed,
                                  const double q[2], QnSpringResponse *response);

static const QnSpringEvaluate evaluators[QN_LAW_KIND_COUNT] = {
  [QN_LAW_ELASTIC] = qn_law_elastic_evaluate,
  [QN_LAW_NO_TENSION] = qn_law_no_tension_evaluate,
  [QN_LAW_COULOMB] = qn_law_coulomb_evaluate,
};

QnSpring
qn_spring_from_law (const QnLaw *law, double area, double length)
{
  double stiffness = 1, strength = 1;

  switch (law->basis) {
  case QN_BASIS_CONTACT:
    break;
  case QN_BASIS_SURFACE:
    stiffness = area;
    strength = area;
    break;
  case QN_BASIS_MATERIAL:
    stiffness = area / length;
    strength = area;
    break;
  case QN_BASIS_COUNT:
    QN_ASSERT (false);
  }

  double apex = law->friction > 0 ? law->cohesion / law->friction : INFINITY;
  return (QnSpring){
    .kind = law->kind,
    .kn = law->kn * stiffness,
    .ks = law->ks * stiffness,
    .friction = law->friction,
    .cohesion = law->cohesion * strength,
    .cap = fmin (law->tension, apex) * strength,
    .cap_strength =
      law->tension < apex ? (law->cohesion - law->friction * law->tension) * strength : 0,
    .dilatancy = law->dilatancy,
  };
}

bool
qn_spring_equal (const QnSpring *a, const QnSpring *b)
{
  return a->kind == b->kind && a->kn == b->kn && a->ks == b->ks
         && a->friction == b->friction && a->cohesion == b->cohesion && a->cap == b->cap
         && a->dilatancy == b->dilatancy;
}

void
qn_spring_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                    const double q[2], QnSpringResponse *response)
{
  evaluators[spring->kind](spring, committed, q, response);
}
