/* Steel: bilinear from yield to strength, with kinematic hardening; a bar may break.
 *
 *   monotonic   kn q up to ny, then straight to the strength nu at the ultimate elongation qu, and
 *               nu from there on
 *   cyclic      as law-bilinear.c: elastic range 2 ny wide, about a back force that grows with the
 *               plastic elongation up to nu - ny
 *   breaking    beyond qu, where a fracture energy G is given: straight down to nothing at
 *               qr = qu - nu / kn + 2 G / nu, so that the plastic work after qu is G
 *
 * The damage of a breaking bar is told by the largest elongation e that it has seen: the force is
 * multiplied by
 *
 *   phi(e) = (qr - e) / (qr - qu),   qu <= e <= qr
 *
 * which gives the straight descent in monotonic loading, and nothing for e >= qr. Bars do not
 * break in compression. The diagram is that of EN 1992-1-1, 3.2.7, figure 3.8; the breaking
 * branch is cohesive (Hillerborg, Modeer & Petersson 1976, Cem. Concr. Res. 6:773-782): G
 * belongs to the one section that breaks, so that the response does not depend on how many
 * blocks a bar is cut into.
 *
 * State: the plastic elongation and, as `extreme`, the largest elongation. Shear is elastic.
 */
#include "core/law/law-ops.h"

#include <math.h>

/* Elongation at which a breaking bar has lost all force. */
static double
broken_at (const QnSpring *s)
{
  return s->ultimate - s->strength / s->kn + s->fracture;
}

/* phi(e) and its derivative. */
static double
damage_factor (const QnSpring *s, double e, double *slope)
{
  double end = broken_at (s);

  *slope = 0;
  if (e <= s->ultimate)
    return 1;
  if (e >= end)
    return 0;
  *slope = -1 / (end - s->ultimate);
  return *slope * (e - end);
}

static void
evaluate_steel (const QnSpring *s, const QnSpringMemory *committed, const double q[2],
                QnSpringResponse *r)
{
  qn_law_bilinear_evaluate (s, committed, q, r);
  if (s->fracture == 0)
    return;

  bool further = q[0] > committed->extreme;
  double slope, phi = damage_factor (s, further ? q[0] : committed->extreme, &slope);

  r->memory.extreme = further ? q[0] : committed->extreme;
  if (phi == 1)
    return;
  r->tangent[0][0] = phi * r->tangent[0][0] + (further ? slope * r->force[0] : 0);
  r->force[0] *= phi;
  r->state = QN_PAIR_OPEN;
  r->varies = phi > 0;
}

static bool
check_steel (const QnLaw *law, QnSubject of)
{
  return qn_require (of, law->strength >= law->yield, QN_PROBLEM_STRENGTH_BELOW_YIELD,
                     "strength", law->strength)
         && qn_require (of, law->kn * law->ultimate_strain > law->strength,
                        QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL, "ultimate_strain",
                        law->ultimate_strain);
}

static void
resolve_steel (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  double plastic_range = law->ultimate_strain - law->yield / law->kn;

  spring->yield = law->yield * scale.force;
  spring->strength = law->strength * scale.force;
  spring->hardening = (law->strength - law->yield) / (law->kn * plastic_range);
  spring->ultimate = law->ultimate_strain * scale.strain;
  spring->fracture = 2 * law->fracture_energy / law->strength;
}

static double
softening_steel (const QnSpring *s)
{
  double length = broken_at (s) - s->ultimate;

  if (s->fracture == 0)
    return 0;
  return length > 0 ? s->strength / length : INFINITY;
}

static const QnLawParameter steel_parameters[] = {
  QN_LAW_PARAMETER ("yield", yield, true, true),
  QN_LAW_PARAMETER ("strength", strength, true, true),
  QN_LAW_PARAMETER ("ultimate_strain", ultimate_strain, true, true),
  QN_LAW_PARAMETER ("fracture_energy", fracture_energy, false, false),
};

const QnLawOps qn_law_ops_steel = { QN_LAW_PARAMETERS (steel_parameters),
                                    .check = check_steel, .resolve = resolve_steel,
                                    .evaluate = evaluate_steel,
                                    .softening = softening_steel };
