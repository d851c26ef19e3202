#include "core/law/law.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/base/tolerance.h"

#include "core/law/law-ops.h"

#include <math.h>
#include <stdlib.h>

const char *const qn_basis_names[QN_BASIS_COUNT] = {
  [QN_BASIS_CONTACT] = "contact",
  [QN_BASIS_SURFACE] = "surface",
  [QN_BASIS_MATERIAL] = "material",
};

const char *const qn_law_softening_names[2] = { "linear", "exponential" };

const char *const qn_arrangement_names[QN_ARRANGEMENT_COUNT] = {
  [QN_ARRANGEMENT_CHAIN] = "chain",
  [QN_ARRANGEMENT_GRID] = "grid",
};

void
qn_law_derive (QnLaw *law)
{
  if (!(law->elasticity > 0))
    return;
  law->kn = law->elasticity;
  law->ks = law->elasticity / (1 + law->poisson);
  if (law->arrangement == QN_ARRANGEMENT_CHAIN)
    law->ks *= 0.5;
}

const QnLawParameter *
qn_law_parameters (QnLawKind kind, size_t *count)
{
  const QnLawOps *ops = qn_law_ops (kind);
  *count = ops->parameter_count;
  return ops->parameters;
}

double
qn_law_get (const QnLaw *law, const QnLawParameter *parameter)
{
  return *(const double *) ((const char *) law + parameter->offset);
}

double *
qn_law_at (QnLaw *law, const QnLawParameter *parameter)
{
  return (double *) ((char *) law + parameter->offset);
}

static QnStatus
check_number (double value, QnRange range, double largest, const char *field, QnId index,
              QnDiag *diag)
{
  QnProblem problem = qn_number_problem (value, range, largest);
  if (problem == QN_PROBLEM_NONE)
    return QN_OK;
  return qn_diag_set_field (diag, problem, QN_ENTITY_LAW, index, field, value);
}

QnStatus
qn_law_check (const QnLaw *law, QnId index, QnDiag *diag)
{
  if (law->name == NULL || law->name[0] == '\0')
    return qn_diag_set_field (diag, QN_PROBLEM_NAME_MISSING, QN_ENTITY_LAW, index, "name",
                              0);

  const QnLawOps *ops = qn_law_ops (law->kind);
  QnStatus status =
    check_number (law->kn, QN_RANGE_POSITIVE, QN_LARGEST_STIFFNESS, "kn", index, diag);
  if (status == QN_OK)
    status =
      check_number (law->ks, QN_RANGE_POSITIVE, QN_LARGEST_STIFFNESS, "ks", index, diag);
  if (status == QN_OK)
    status = check_number (law->shear_factor, QN_RANGE_NOT_NEGATIVE, QN_LARGEST_NUMBER,
                           "shear_factor", index, diag);
  if (status == QN_OK)
    status = check_number (law->elasticity, QN_RANGE_NOT_NEGATIVE, QN_LARGEST_STIFFNESS,
                           "elasticity", index, diag);
  if (status == QN_OK && !(law->poisson >= 0 && law->poisson < 0.5))
    status = qn_diag_set_field (diag, QN_PROBLEM_LAW_POISSON, QN_ENTITY_LAW, index,
                                "poisson", law->poisson);
  for (size_t i = 0; i < ops->parameter_count && status == QN_OK; i++) {
    const QnLawParameter *parameter = &ops->parameters[i];
    double value = qn_law_get (law, parameter);
    bool positive = parameter->positive && (parameter->required || value != 0);
    status = check_number (value, positive ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE,
                           QN_LARGEST_NUMBER, parameter->key, index, diag);
  }
  return status == QN_OK && ops->check != NULL ? ops->check (law, index, diag) : status;
}

bool
qn_law_has_bond (const QnLaw *law)
{
  return qn_law_may_bond (law->kind)
         && (law->cohesion > 0 || (law->tension > 0 && law->friction == 0));
}

void
qn_law_break_bond (QnLaw *law)
{
  if (!qn_law_has_bond (law))
    return;
  law->friction = law->residual_friction > 0 ? law->residual_friction : law->friction;
  law->cohesion = law->tension = 0;
}

bool
qn_law_assign (QnLaw *law, const QnLaw *from)
{
  char *name = law->name, *source = qn_strdup (from->source);
  if (source == NULL && from->source != NULL)
    return false;
  free (law->source);
  *law = *from;
  law->name = name;
  law->source = source;
  law->note = 0;
  return true;
}

void
qn_law_clear (QnLaw *law)
{
  free (law->name);
  free (law->source);
  *law = (QnLaw){ 0 };
}
