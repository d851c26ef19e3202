#include "core/law/spring.h"

#include "core/base/tolerance.h"
#include "core/law/law-ops.h"

#include <math.h>

QnSpring
qn_spring_from_law (const QnLaw *law, double area, double length)
{
  QnLawScale scale = { .force = 1, .strain = 1 };

  switch (law->basis) {
  case QN_BASIS_CONTACT:
    break;
  case QN_BASIS_SURFACE:
    scale.force = area;
    break;
  case QN_BASIS_MATERIAL:
    scale.force = area;
    scale.strain = length;
    break;
  case QN_BASIS_COUNT:
    QN_ASSERT (false);
  }

  double stiffness = scale.force / scale.strain;
  double shear_factor = law->shear_factor > 0 ? law->shear_factor : 1;
  const QnLawOps *ops = qn_law_ops (law->kind);
  QnSpring spring = { .kind = law->kind,
                      .kn = law->kn * stiffness,
                      .ks = law->ks * shear_factor * stiffness };
  if (ops->resolve != NULL)
    ops->resolve (law, scale, &spring);
  return spring;
}

void
qn_spring_evaluate (const QnSpring *spring, const QnSpringMemory *committed,
                    const double q[2], QnSpringResponse *response)
{
  qn_law_ops (spring->kind)->evaluate (spring, committed, q, response);
}

int
qn_spring_strength (const QnSpring *spring, QnStrengthRow rows[QN_STRENGTH_ROWS])
{
  const QnLawOps *ops = qn_law_ops (spring->kind);
  return ops->strength != NULL ? ops->strength (spring, rows) : 0;
}

int
qn_spring_rigid_strength (const QnSpring *spring, QnStrengthRow rows[QN_STRENGTH_ROWS])
{
  int count = qn_spring_strength (spring, rows);

  if (spring->kind != QN_LAW_NO_TENSION)
    return count;
  int kept = 0;
  for (int i = 0; i < count; i++)
    if (rows[i].shear == 0)
      rows[kept++] = rows[i];
  return kept;
}

bool
qn_law_has_strength (QnLawKind kind)
{
  return qn_law_ops (kind)->strength != NULL;
}

bool
qn_law_is_plastic (QnLawKind kind)
{
  return qn_law_ops (kind)->plastic;
}

bool
qn_law_yields (QnLawKind kind)
{
  return kind != QN_LAW_ELASTIC && kind != QN_LAW_NO_TENSION && kind != QN_LAW_COULOMB;
}

bool
qn_law_softens (QnLawKind kind)
{
  return qn_law_ops (kind)->softening != NULL;
}

double
qn_spring_softening (const QnSpring *spring)
{
  const QnLawOps *ops = qn_law_ops (spring->kind);
  return ops->softening != NULL ? ops->softening (spring) : 0;
}

static bool
close_to (double x, double y)
{
  return x == y || fabs (x - y) <= QN_TOLERANCE_SIMILAR * (fabs (x) + fabs (y));
}

bool
qn_spring_similar (const QnSpring *a, const QnSpring *b)
{
  double ratio = a->kn / b->kn; /* of b's length to a's */

  return a->kind == b->kind && close_to (a->ks, ratio * b->ks)
         && a->friction == b->friction && close_to (a->cohesion, b->cohesion)
         && a->residual == b->residual && close_to (a->cap, b->cap)
         && close_to (a->energy[0], b->energy[0]) && close_to (a->energy[1], b->energy[1])
         && close_to (a->compression, b->compression) && a->dilatancy == b->dilatancy
         && a->dilation_end == b->dilation_end && a->exponential == b->exponential
         && close_to (a->yield, b->yield) && close_to (a->hardening, b->hardening)
         && close_to (a->strength, b->strength)
         && close_to (ratio * a->ultimate, b->ultimate)
         && close_to (a->fracture, b->fracture) && close_to (a->crushing, b->crushing)
         && a->points == b->points && close_to (a->force_scale, b->force_scale)
         && close_to (ratio * a->strain_scale, b->strain_scale)
         && close_to (a->stretch[0], ratio * b->stretch[0])
         && close_to (a->stretch[1], ratio * b->stretch[1]);
}

QnSpring
qn_spring_join (const QnSpring *a, const QnSpring *b)
{
  QnSpring joined = *a;
  double longer = 1 + a->kn / b->kn; /* joint length over that of a */

  joined.kn /= longer;
  joined.ks /= longer;
  joined.ultimate *= longer;
  joined.strain_scale *= longer;
  joined.stretch[0] /= longer;
  joined.stretch[1] /= longer;
  return joined;
}

QnSpring
qn_spring_broken (const QnSpring *spring)
{
  QnSpring broken = *spring;

  if (qn_spring_has_bond (spring)) {
    broken.friction = spring->residual;
    broken.cohesion = broken.cap = 0;
  }
  return broken;
}

void
qn_spring_lose_bond (QnSpring *spring)
{
  bool is_joint = qn_law_may_bond (spring->kind);

  double friction = is_joint ? spring->residual : QN_NO_TENSION_FRICTION;

  *spring = (QnSpring){ .kind = is_joint ? QN_LAW_COULOMB : QN_LAW_NO_TENSION,
                        .kn = spring->kn,
                        .ks = spring->ks,
                        .friction = friction,
                        .residual = friction };
}
