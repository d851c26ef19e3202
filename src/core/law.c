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
  const double positive[] = { law->kn, law->ks };
  const double not_negative[] = { law->friction, law->cohesion, law->tension,
                                  law->dilatancy };
  QnProblem problem = QN_PROBLEM_NONE;

  if (law->name == NULL || law->name[0] == '\0')
    problem = QN_PROBLEM_NAME_MISSING;
  for (size_t i = 0; i < QN_N_ELEMENTS (positive) && problem == QN_PROBLEM_NONE; i++) {
    if (!isfinite (positive[i]))
      problem = QN_PROBLEM_NOT_FINITE;
    else if (positive[i] <= 0)
      problem = QN_PROBLEM_NOT_POSITIVE;
  }
  for (size_t i = 0; i < QN_N_ELEMENTS (not_negative) && problem == QN_PROBLEM_NONE;
       i++) {
    if (!isfinite (not_negative[i]))
      problem = QN_PROBLEM_NOT_FINITE;
    else if (not_negative[i] < 0)
      problem = QN_PROBLEM_NEGATIVE;
  }
  if (problem == QN_PROBLEM_NONE && law->dilatancy > law->friction)
    problem = QN_PROBLEM_DILATANCY_ABOVE_FRICTION;

  if (problem != QN_PROBLEM_NONE)
    return qn_diag_set (diag, QN_ERROR_INVALID, problem, QN_ENTITY_LAW, index, QN_NONE);
  return QN_OK;
}

void
qn_law_clear (QnLaw *law)
{
  free (law->name);
  *law = (QnLaw){ 0 };
}
