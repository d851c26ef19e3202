/* Elastic, then linear kinematic hardening, the same in tension and compression.
 *
 *   force       n = kn (q - p)                  p: plastic elongation
 *   back force  x = kn r / (1 - r) p            r: hardening, 0 <= r < 1; of steel |x| <= nu - ny
 *   yield       |n - x| <= ny
 *   flow        dp in the direction of n - x
 *
 * In monotonic loading this is the line of stiffness kn up to ny and of stiffness r kn from there
 * on. Unloading is elastic; the elastic range stays 2 ny wide (Bauschinger effect), so that yield
 * in the other direction begins 2 ny below. Because the back force is proportional to p, the
 * plastic elongation is the whole state. Return mapping in closed form:
 *
 *   |kn (q - p) - x| > ny:   p = (1 - r) (q -+ ny / kn),   n = x +- ny,   dn/dq = r kn
 *   |x| = nu - ny:           p = q - n / kn,               n = x +- ny,   dn/dq = 0
 *
 * Without hardening it is the law elastic-plastic. Source: Simo & Hughes, Computational Inelasticity (1998),
 * section 1.4. Shear is elastic.
 */
#include "core/law/law-ops.h"

#include <math.h>

/* As if it had no end. */
static double
back_force (const QnSpring *s, double plastic)
{
  return s->kn * s->hardening / (1 - s->hardening) * plastic;
}

void
qn_law_bilinear_evaluate (const QnSpring *s, const QnSpringMemory *committed,
                          const double q[2], QnSpringResponse *r)
{
  double most = s->strength - s->yield;
  double back = fmax (-most, fmin (most, back_force (s, committed->opening)));
  double trial = s->kn * (q[0] - committed->opening);
  double relative = trial - back;

  *r = (QnSpringResponse){ .force = { trial, s->ks * q[1] },
                           .tangent = { { s->kn, 0 }, { 0, s->ks } },
                           .memory = *committed,
                           .state = QN_PAIR_STICK };
  if (fabs (relative) <= s->yield)
    return;

  double sign = relative < 0 ? -1 : 1;
  double plastic = (1 - s->hardening) * (q[0] - sign * s->yield / s->kn);
  /* On the yield line itself, so that rounding does not add up over many steps. */
  back = back_force (s, plastic);
  if (fabs (back) <= most) {
    r->force[0] = sign * s->yield + back;
    r->memory.opening = plastic;
    r->tangent[0][0] = s->hardening * s->kn;
  } else {
    r->force[0] = sign * s->yield + copysign (most, back);
    r->memory.opening = q[0] - r->force[0] / s->kn;
    r->tangent[0][0] = 0;
  }
  r->state = QN_PAIR_YIELD;
}

static bool
check_bilinear (const QnLaw *law, QnSubject of)
{
  return qn_require (of, law->hardening < 1, QN_PROBLEM_HARDENING_TOO_LARGE, "hardening",
                     law->hardening);
}

static void
resolve_bilinear (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  spring->yield = law->yield * scale.force;
  spring->hardening = law->kind == QN_LAW_BILINEAR ? law->hardening : 0;
  spring->strength = INFINITY;
}

static const QnLawParameter bilinear_parameters[] = {
  QN_LAW_PARAMETER ("yield", yield, true, true),
  QN_LAW_PARAMETER ("hardening", hardening, false, false),
};

const QnLawOps qn_law_ops_bilinear = { QN_LAW_PARAMETERS (bilinear_parameters),
                                       .check = check_bilinear,
                                       .resolve = resolve_bilinear,
                                       .evaluate = qn_law_bilinear_evaluate };

const QnLawOps qn_law_ops_elastic_plastic = { .parameters = bilinear_parameters,
                                              .parameter_count = 1, /* yield */
                                              .resolve = resolve_bilinear,
                                              .evaluate = qn_law_bilinear_evaluate };
