#include "core/law.h"

#include <math.h>
#include <stdlib.h>

const char *
qn_law_kind_name (QnLawKind kind)
{
  static const char *const names[QN_LAW_KIND_COUNT] = {
    [QN_LAW_ELASTIC] = "elastic",
    [QN_LAW_NO_TENSION] = "no-tension",
    [QN_LAW_COULOMB] = "coulomb",
  };
  return names[kind];
}

const char *
qn_basis_name (QnBasis basis)
{
  static const char *const names[QN_BASIS_COUNT] = {
    [QN_BASIS_CONTACT] = "contact",
    [QN_BASIS_SURFACE] = "surface",
    [QN_BASIS_MATERIAL] = "material",
  };
  return names[basis];
}

QnStatus
qn_law_check (const QnLaw *law, QnId index, QnDiag *diag)
{
  const struct {
    const char *field;
    double value;
    bool positive;
  } numbers[] = {
    { "kn", law->kn, true },
    { "ks", law->ks, true },
    { "friction", law->friction, false },
    { "cohesion", law->cohesion, false },
    { "tension", law->tension, false },
    { "dilatancy", law->dilatancy, false },
  };

  if (law->name == NULL || law->name[0] == '\0')
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_MISSING, QN_ENTITY_LAW, index, "name",
                              0);
  for (size_t i = 0; i < QN_N_ELEMENTS (numbers); i++) {
    double value = numbers[i].value;
    QnProblem problem = QN_PROBLEM_NONE;
    if (!isfinite (value))
      problem = QN_PROBLEM_NOT_FINITE;
    else if (numbers[i].positive && value <= 0)
      problem = QN_PROBLEM_NOT_POSITIVE;
    else if (value < 0)
      problem = QN_PROBLEM_NEGATIVE;
    if (problem != QN_PROBLEM_NONE)
      return qn_diag_set_field (diag, problem, QN_ENTITY_LAW, index, numbers[i].field,
                                value);
  }
  if (law->dilatancy > law->friction)
    return qn_diag_set_field (diag, QN_PROBLEM_DILATANCY_ABOVE_FRICTION, QN_ENTITY_LAW,
                              index, "dilatancy", law->dilatancy);
  return QN_OK;
}

void
qn_law_clear (QnLaw *law)
{
  free (law->name);
  *law = (QnLaw){ 0 };
}
