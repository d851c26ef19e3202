#include "core/law/law.h"

#include "core/base/memory.h"
#include "core/base/require.h"
#include "core/base/tolerance.h"

#include "core/law/law-ops.h"

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

QnStatus
qn_law_check (const QnLaw *law, QnId index, QnDiag *diag)
{
  const QnSubject of = { QN_ENTITY_LAW, index, diag };
  const QnLawOps *ops = qn_law_ops (law->kind);
  bool holds =
    qn_require_name (of, law->name, QN_NONE, index)
    && qn_require_size (of, "kn", law->kn, QN_RANGE_POSITIVE, QN_LARGEST_STIFFNESS)
    && qn_require_size (of, "ks", law->ks, QN_RANGE_POSITIVE, QN_LARGEST_STIFFNESS)
    && qn_require_number (of, "shear_factor", law->shear_factor, QN_RANGE_NOT_NEGATIVE)
    && qn_require_size (of, "elasticity", law->elasticity, QN_RANGE_NOT_NEGATIVE,
                        QN_LARGEST_STIFFNESS)
    && qn_require (of, law->poisson >= 0 && law->poisson < 0.5, QN_PROBLEM_LAW_POISSON,
                   "poisson", law->poisson);

  for (size_t i = 0; i < ops->parameter_count && holds; i++) {
    const QnLawParameter *parameter = &ops->parameters[i];
    double value = qn_law_get (law, parameter);
    bool positive = parameter->positive && (parameter->required || value != 0);
    holds = qn_require_number (of, parameter->key, value,
                               positive ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE);
  }
  return qn_required (holds && (ops->check == NULL || ops->check (law, of)));
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
