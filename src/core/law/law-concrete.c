/* Concrete: parabola and rectangle in compression, optional tension with a fracture energy.
 *
 * Compression, e = shortening, s = compressive force, positive:
 *
 *   s(e) = fc (2 x - x^2),  x = e / ep,  ep = 2 fc / kn      0 <= e <= ep
 *   s(e) = fc                                                ep <= e <= eu
 *   s(e) = fc (ec - e) / (ec - eu)                           eu <= e <= ec, then nothing
 *   ec   = eu - fc / kn + 2 Gc / fc                          so that crushing dissipates Gc
 *
 * The end of the rectangle and the crushing branch are optional. Unloading and reloading are
 * elastic, of stiffness kn, about the plastic shortening e - s / kn.
 *
 * Tension, d = elongation beyond that plastic shortening:
 *
 *   n(d) = kn d                                              d <= ft / kn
 *   n(d) = ft (w - d) / (w - ft / kn),  w = 2 Gf / ft        up to d = w, then nothing
 *
 * A crack closes completely: unloading goes straight to the origin and comes back the same way.
 * Both softening branches are cohesive: their lengths follow from energies per area and not from
 * strains, so that the response does not depend on the size of the blocks.
 *
 * Sources: EN 1992-1-1, 3.1.7 (parabola-rectangle, exponent 2); Hillerborg, Modeer & Petersson
 * 1976, Cem. Concr. Res. 6:773-782 (cohesive crack). Shear is elastic, cracked or not.
 *
 * State: minus the plastic shortening as `opening` and the widest d as `extreme`.
 */
#include "core/law/law-ops.h"

#include <math.h>

/* Shortening at which crushed concrete has lost all force. */
static double
crushed_at (const QnSpring *s)
{
  return s->ultimate - s->strength / s->kn + s->crushing;
}

/* s(e), its derivative, and the state there; only the parabola's derivative varies. */
static double
compressive_force (const QnSpring *s, double e, double *slope, QnPairState *state)
{
  double peak = 2 * s->strength / s->kn, x = e / peak;

  *slope = 0;
  *state = e < peak ? QN_PAIR_STICK : QN_PAIR_YIELD;
  if (e < peak) {
    *slope = s->kn * (1 - x);
    return s->strength * x * (2 - x);
  }
  if (e <= s->ultimate)
    return s->strength;
  double end = crushed_at (s);
  if (e >= end) {
    *state = QN_PAIR_OPEN;
    return 0;
  }
  *slope = -s->strength / (end - s->ultimate);
  return -*slope * (end - e);
}

static void
compress (const QnSpring *s, double e, double plastic, QnSpringResponse *r)
{
  QnPairState state;
  double slope, force = compressive_force (s, e, &slope, &state);
  double trial = s->kn * (e - plastic);

  if (trial <= force) {
    r->force[0] = -trial;
    r->tangent[0][0] = s->kn;
    return;
  }
  r->force[0] = -force;
  r->tangent[0][0] = slope;
  r->memory.opening = -(e - force / s->kn);
  r->state = state;
  r->varies = state == QN_PAIR_STICK;
}

static void
stretch (const QnSpring *s, double d, QnSpringResponse *r)
{
  double crack = s->cap / s->kn, open = s->fracture;
  double widest = fmax (d, r->memory.extreme);

  r->memory.extreme = widest;
  if (widest <= crack || s->outlasts) {
    r->force[0] = s->kn * d;
    r->tangent[0][0] = s->kn;
    return;
  }
  r->state = QN_PAIR_OPEN;
  if (widest < open) {
    double slope = -s->cap / (open - crack), force = slope * (widest - open);
    bool further = d == widest;
    r->force[0] = further ? force : force / widest * d;
    r->tangent[0][0] = further ? slope : force / widest;
    r->varies = !further;
  }
}

static void
evaluate_concrete (const QnSpring *s, const QnSpringMemory *committed, const double q[2],
                   QnSpringResponse *r)
{
  double plastic = -committed->opening;

  *r = (QnSpringResponse){ .force = { 0, s->ks * q[1] },
                           .tangent = { { 0, 0 }, { 0, s->ks } },
                           .memory = *committed,
                           .state = QN_PAIR_STICK };
  if (q[0] < -plastic)
    compress (s, -q[0], plastic, r);
  else
    stretch (s, q[0] + plastic, r);
}

static bool
check_concrete (const QnLaw *law, QnSubject of)
{
  const double ultimate = law->ultimate_strain, peak = 2 * law->strength / law->kn;

  return qn_require (of, !(law->tension > 0 && law->fracture_energy == 0),
                     QN_PROBLEM_FRACTURE_ENERGY_MISSING, "fracture_energy", 0)
         && qn_require (of, !(ultimate > 0 && ultimate < peak),
                        QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL, "ultimate_strain", 0)
         && qn_require (of, !(ultimate > 0 && law->crushing_energy == 0),
                        QN_PROBLEM_FRACTURE_ENERGY_MISSING, "crushing_energy", 0)
         && qn_require (of, !(ultimate == 0 && law->crushing_energy > 0),
                        QN_PROBLEM_NOT_POSITIVE, "ultimate_strain", 0);
}

static void
resolve_concrete (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  bool crushes = law->ultimate_strain > 0;

  spring->strength = law->strength * scale.force;
  spring->ultimate = crushes ? law->ultimate_strain * scale.strain : INFINITY;
  spring->crushing = crushes ? 2 * law->crushing_energy / law->strength : 0;
  spring->cap = law->tension * scale.force;
  spring->fracture = law->tension > 0 ? 2 * law->fracture_energy / law->tension : 0;
}

static double
softening_concrete (const QnSpring *s)
{
  double steepest = 0;

  if (s->cap > 0) {
    double length = s->fracture - s->cap / s->kn;
    steepest = length > 0 ? s->cap / length : INFINITY;
  }
  if (isfinite (s->ultimate)) {
    double length = crushed_at (s) - s->ultimate;
    steepest = fmax (steepest, length > 0 ? s->strength / length : INFINITY);
  }
  return steepest;
}

static const QnLawParameter concrete_parameters[] = {
  QN_LAW_PARAMETER ("strength", strength, true, true),
  QN_LAW_PARAMETER ("ultimate_strain", ultimate_strain, false, true),
  QN_LAW_PARAMETER ("crushing_energy", crushing_energy, false, true),
  QN_LAW_PARAMETER ("tension", tension, false, false),
  QN_LAW_PARAMETER ("fracture_energy", fracture_energy, false, true),
};

const QnLawOps qn_law_ops_concrete = { QN_LAW_PARAMETERS (concrete_parameters),
                                       .check = check_concrete,
                                       .resolve = resolve_concrete,
                                       .evaluate = evaluate_concrete,
                                       .softening = softening_concrete };
