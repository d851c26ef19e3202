/* Coulomb friction with dilation, a bond that breaks, and a limit of compression.
 *
 * FRICTION. With n the normal force (tension positive), t the shear force, s the slip from where the joint was
 * built and k >= 0 what it has been shortened by crushing:
 *
 *   yield      f = |t| + mu n <= 0,   n <= 0,   -n <= fc
 *   flow       ds = g sign(t), g >= 0,   opening = h(s) - k,   h(s) = psi min (|s|, s_end)
 *
 * so that a joint which slides back comes down again, as teeth do that fit (Patton 1966; Plesha
 * 1987), and one that has slid by s_end rises no further; mu is the same both ways (Coulomb slip
 * of UDEC). With psi = mu and no s_end the law is that of limit analysis, associative plasticity:
 * h adds up, psi |ds|, whichever way the joint slides. Return mapping (backward Euler, closed
 * form) from the trial forces n*, t* that the spring would carry without further slip:
 *
 *   stick      f(n*, t*) <= 0:             n = n*,             t = t*
 *   slip       through the parts of the way on which h' = +-psi or 0, until
 *              g = f(n*, t*) / (ks + mu h' kn) lies in the part:
 *                                          n = n* - kn h' g,  t = t* - ks g sign(t*)
 *   open       q_n > h(q_t) - k:           n = t = 0
 *   crush      g = max (0, (|t*| - mu fc) / ks),  h(s) - k > q_n + fc / kn:
 *                                          n = -fc,  |t| = min (|t*|, mu fc)
 *
 * An open joint forgets its slip: s = q_t; it closes again where it opened, at the height that
 * belongs to that, lowered by crushing. Outwards psi = mu makes the flow associative and the
 * tangent symmetric; psi = 0 is the law of the paper on HybriDFEM in two dimensions (equations 1
 * and 2). The shortening of a crushed joint stays, without hardening, softening or an end, as in
 * limit analysis with a rectangular block of stress at the toe (Orduña & Lourenço, J. Struct.
 * Eng. 129 (2003) 1367-1375). With an ultimate shortening eu and a crushing energy Gc, and without
 * dilation, fc falls in a straight line with k,
 *
 *   fc (k) = fc (kc - k) / (kc - ku),   ku = eu - fc / kn <= k <= kc = ku + 2 Gc / fc
 *
 * which dissipates Gc beyond the end of the bilinear diagram of EN 1992-1-1, 3.1.7 (2).
 *
 * BOND. Cohesion c and tension ft are those of a bond that is whole. It is elastic, of the same stiffness:
 *
 *   e = q_n + crushed,   s = q_t,   r = max (kn e / ft, (ks |s| + mu kn e) / c)
 *
 * and is damaged where r > 1. Of a damaged joint a part d carries nothing but friction, the rest is whole
 * (Alfano & Sacco, Int. J. Numer. Meth. Eng. 68 (2006) 542-582), and the joint carries together
 *
 *   F = (1 - d) F_bond + d F_friction,   F_bond = (kn e, ks s)
 *
 * so that unloading goes to the origin but for the slip of the friction. Along any direction of loading the
 * strength of the bond, (1 - d) r of it, falls in a straight line from 1 at r = 1 to nothing at r = R:
 *
 *   1 - d = (R - r) / (r (R - 1)),   never growing again
 *   R     = r^2 / (E1 / G1 + E2 / G2),   E1 = kn e^2 / 2,  E2 = ks s^2 / 2
 *
 * with E1 = 0 and E2 = (r c)^2 / 2 ks, what is beyond friction, in compression. R is where the work done
 * along that direction is all of the fracture energy, of both modes in the linear proportion of Lourenço &
 * Rots, J. Eng. Mech. 123 (1997) 660-668, and Reeder (energies share: W1/G1 + W2/G2 = 1). Where R <= 1 the
 * elastic energy alone breaks the bond: it is brittle, as it is where energies are not given. A broken bond
 * stays broken: the friction is all that is left, with the residual mu.
 *
 * Along an exponential curve, (1 - d) r = (exp (-(r - 1) / a) - TAIL) / (1 - TAIL), with a such
 * that the energy is the same.
 *
 * State: opening, slip (of the friction) and d as `extreme`. There qn_bond_held() is a bond that
 * holds where it would lose at once what is whole of it, while an equilibrium is sought
 * (qn_assembly_hold_bonds()); the answer then says that it is to break, and not yet what is left.
 */
#include "core/law/law-ops.h"

#include "core/base/numbers.h"

#include <math.h>

/* --- Friction ---------------------------------------------------------------------------- */

/* Part of the compressive strength that is rounding. */
#define SLACK 1e-9

static bool
is_too_deep (const QnSpring *s, double n)
{
  return s->compression > 0 && n < -(1 + SLACK) * s->compression;
}

/* Slides to where friction alone holds, through the parts of the way between which dilation changes, and on
 * where it would be crushed: at the end of the way back it is not. */
static void
slide (const QnSpring *s, const double q[2], double sign, QnSpringResponse *r)
{
  double mu = s->residual, end = s->dilation_end, slip = r->memory.slip;
  bool passed = is_too_deep (s, s->kn * (q[0] - r->memory.opening));

  for (;;) {
    double along = sign * slip;
    double until = s->associative ? INFINITY
                   : along < -end ? -end
                   : along < 0    ? 0
                   : along < end  ? end
                                  : INFINITY;
    double psi = qn_spring_dilation_rate (s, slip, sign);
    double n = s->kn * (q[0] - qn_spring_risen (s, &r->memory, slip));
    double t = s->ks * (q[1] - slip);
    double stiffness = s->ks + mu * psi * s->kn;
    double g = (sign * t + mu * n) / stiffness;
    bool holds = stiffness > 0 && along + g <= until && (g >= 0 || !passed);
    bool deep = holds && is_too_deep (s, n - s->kn * psi * g);
    if (s->dilatancy > 0 && until < INFINITY && (!holds || deep)) {
      passed = passed || deep;
      slip = sign * until;
      continue;
    }
    double g_n = mu * s->kn / stiffness;   /* dg / d q[0] */
    double g_t = sign * s->ks / stiffness; /* dg / d q[1] */
    r->force[0] = n - s->kn * psi * g;
    /* From the yield function, so that the result lies on it to the last digit. */
    r->force[1] = -sign * mu * r->force[0];
    r->tangent[0][0] = s->kn - s->kn * psi * g_n;
    r->tangent[0][1] = -s->kn * psi * g_t;
    r->tangent[1][0] = -mu * sign * r->tangent[0][0];
    r->tangent[1][1] = -mu * sign * r->tangent[0][1];
    r->memory.opening = qn_spring_risen (s, &r->memory, slip + sign * g);
    r->memory.slip = slip + sign * g;
    r->state = QN_PAIR_SLIP;
    return;
  }
}

/* What is left of it where the joint has been shortened by e in all, and by which derivative. */
static double
compression_at (const QnSpring *s, double e, double *slope)
{
  double length = s->crushing - s->compression / s->kn; /* of the descent */

  *slope = 0;
  if (s->crushing == 0 || e <= s->ultimate)
    return s->compression;
  if (e >= s->ultimate + length)
    return 0;
  *slope = -s->compression / length;
  return -*slope * (s->ultimate + length - e);
}

/* False where the joint is not crushed. */
static bool
crush (const QnSpring *s, const double q[2], double t_trial, QnSpringResponse *r)
{
  double slope, force = compression_at (s, -q[0], &slope);
  double sign = t_trial < 0 ? -1 : 1, left = s->residual * force;
  double g = qn_max ((fabs (t_trial) - left) / s->ks, 0);
  double slip = r->memory.slip + sign * g;
  double crushed = q[0] + force / s->kn;

  if (s->compression <= 0 || crushed >= qn_spring_risen (s, &r->memory, slip))
    return false;
  r->force[0] = -force;
  r->force[1] = g > 0 ? sign * left : t_trial;
  r->tangent[0][0] = slope;
  r->tangent[1][0] = g > 0 ? -sign * s->residual * slope : 0;
  r->tangent[1][1] = g > 0 || force == 0 ? 0 : s->ks;
  r->varies = s->crushing > 0;
  r->memory.opening = crushed;
  r->memory.slip = slip;
  r->state = force == 0 ? QN_PAIR_OPEN : QN_PAIR_YIELD;
  return true;
}

/* --- Bond -------------------------------------------------------------------------------- */

/* Strength at which exponential softening ends, and the area below the rest of the curve, both of those of
 * exp (-x). */
#define TAIL      1e-3
#define TAIL_AREA (1 - TAIL * 6.907755278982137 / (1 - TAIL)) /* ln (1000) */

/* How far the bond is strained, r, and the part of it that is whole there; with their derivatives. */
typedef struct {
  double r, whole;
  bool brittle; /* loses all strength at once */
  double r_q[2], whole_q[2];
} Strain;

/* bond, stiffness: what a whole one carries, and by which derivative. */
static Strain
strain_bond (const QnSpring *s, const double bond[2], const double stiffness[2])
{
  double ft = fmax (s->cap, QN_BOND_ROUNDING * s->cohesion);
  double c = fmax (s->cohesion, QN_BOND_ROUNDING * s->cap);
  double n = bond[0], t = fabs (bond[1]), sign = bond[1] < 0 ? -1 : 1;
  bool slides = (t + s->friction * n) / c >= n / ft, apart = n > 0;
  Strain at = { .r = slides ? (t + s->friction * n) / c : n / ft,
                .whole = 1,
                .r_q = { stiffness[0] * (slides ? s->friction / c : 1 / ft),
                         slides ? sign * stiffness[1] / c : 0 } };

  if (at.r <= 1)
    return at;
  at.whole = 0;
  at.brittle = true;
  double shear = apart ? t : at.r * c; /* whose energy counts */
  if ((apart && s->energy[0] == 0) || (shear > 0 && s->energy[1] == 0))
    return at;
  double spent = 0, spent_q[2] = { 0, 0 }; /* E1 / G1 + E2 / G2 */
  if (apart) {
    spent = 0.5 * n * n / (s->kn * s->energy[0]);
    spent_q[0] = n / s->energy[0];
  }
  if (shear > 0) {
    spent += 0.5 * shear * shear / (s->ks * s->energy[1]);
    for (int i = 0; i < 2; i++) {
      double slope = !apart ? at.r_q[i] * c : i == 1 ? sign * stiffness[1] : 0;
      spent_q[i] += shear * slope / (s->ks * s->energy[1]);
    }
  }
  double end = at.r * at.r / spent;
  if (end <= 1)
    return at;
  at.brittle = false;
  double left, by_r, by_end; /* strength of the bond, 1 where r = 1; its derivatives */
  if (s->exponential) {
    double length = (end - 1) / (2 * TAIL_AREA), e = exp (-(at.r - 1) / length);
    left = (e - TAIL) / (1 - TAIL);
    by_r = -e / (length * (1 - TAIL));
  } else {
    left = (end - at.r) / (end - 1);
    by_r = -1 / (end - 1);
  }
  by_end = -by_r * (at.r - 1) / (end - 1);
  if (left <= 0)
    return at;
  at.whole = left / at.r;
  for (int i = 0; i < 2; i++) {
    double end_q = end * (2 * at.r_q[i] / at.r - spent_q[i] / spent);
    at.whole_q[i] = (by_r * at.r_q[i] + by_end * end_q - at.whole * at.r_q[i]) / at.r;
  }
  return at;
}

/* Adds the remaining force of the bond to the friction `r`. */
static void
add_bond (const QnSpring *s, const QnSpringMemory *committed, const double q[2],
          QnSpringResponse *r)
{
  double n = s->kn * (q[0] - qn_spring_crushed (s, committed)), slope;
  double most = compression_at (s, -q[0], &slope);
  bool crushed = s->compression > 0 && n < -most;
  const double bond[2] = { crushed ? -most : n, s->ks * q[1] };
  const double stiffness[2] = { crushed ? slope : s->kn, s->ks };
  Strain at = s->outlasts ? (Strain){ .whole = 1 } : strain_bond (s, bond, stiffness);
  if (crushed && most < at.whole * s->compression) /* no bond outlasts what it joins */
    at =
      (Strain){ .whole = most / s->compression, .whole_q = { -slope / s->compression } };
  double before = qn_spring_damage (s, committed);
  bool holds = committed->extreme < 0 && at.whole <= 0 && (before == 0 || at.brittle);
  bool further = !holds && 1 - at.whole > before;
  double whole = further ? at.whole : 1 - before, lost = 1 - whole;

  r->memory.extreme = holds ? QN_BOND_BREAKS : lost;
  if (lost == 0) {
    *r = (QnSpringResponse){ .memory = *committed,
                             .state = crushed ? QN_PAIR_YIELD : QN_PAIR_STICK };
    if (crushed)
      r->memory.opening = q[0] + most / s->kn;
    r->memory.extreme = holds ? QN_BOND_BREAKS : 0;
  }
  if (lost == 1)
    return;
  for (int i = 0; i < 2; i++) {
    double beyond = bond[i] - r->force[i];
    for (int j = 0; j < 2; j++)
      r->tangent[i][j] = lost * r->tangent[i][j] + (i == j ? whole * stiffness[i] : 0)
                         + (further ? beyond * at.whole_q[j] : 0);
    r->force[i] = whole * bond[i] + lost * r->force[i];
  }
  r->varies = lost > 0 || (crushed && s->crushing > 0);
}

void
qn_law_coulomb_evaluate (const QnSpring *s, const QnSpringMemory *committed,
                         const double q[2], QnSpringResponse *r)
{
  /* With mu the residual friction. */
  double n_trial = s->kn * (q[0] - committed->opening);
  double t_trial = s->ks * (q[1] - committed->slip);
  double open = qn_spring_risen (s, committed, q[1]);
  bool slips = fabs (t_trial) + s->residual * n_trial > 0 || is_too_deep (s, n_trial);
  *r = (QnSpringResponse){ .memory = *committed, .state = QN_PAIR_STICK };
  if (!crush (s, q, t_trial, r)) {
    if (q[0] > open && (slips || n_trial > 0)) {
      r->memory.slip = q[1];
      r->memory.opening = open;
      r->state = QN_PAIR_OPEN;
    } else if (slips) {
      slide (s, q, t_trial < 0 ? -1 : 1, r);
    } else {
      r->force[0] = n_trial;
      r->force[1] = t_trial;
      r->tangent[0][0] = s->kn;
      r->tangent[1][1] = s->ks;
    }
  }
  if (committed->extreme < 1 && qn_spring_has_bond (s))
    add_bond (s, committed, q, r);
}

/* --- Laws -------------------------------------------------------------------------------- */

static bool
coulomb_check (const QnLaw *law, QnSubject of)
{
  bool residual = law->residual_friction > 0;

  return qn_require (of,
                     law->dilatancy <= law->friction
                       && !(residual && law->dilatancy > law->residual_friction),
                     QN_PROBLEM_DILATANCY_ABOVE_FRICTION, "dilatancy", law->dilatancy);
}

static void
coulomb_resolve (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  double apex = law->friction > 0 ? law->cohesion / law->friction : INFINITY;
  double tension = law->fracture_energy_tension, shear = law->fracture_energy_shear;

  spring->friction = law->friction;
  spring->residual = law->residual_friction > 0 ? law->residual_friction : law->friction;
  spring->dilatancy = law->dilatancy;
  spring->dilation_end = law->dilation_end > 0 ? law->dilation_end : INFINITY;
  spring->associative =
    law->dilatancy > 0 && law->dilatancy >= law->friction && !(law->dilation_end > 0);
  spring->cohesion = law->cohesion * scale.force;
  spring->cap = fmin (law->tension, apex) * scale.force;
  if (!qn_spring_has_bond (spring))
    spring->residual = law->friction;
  spring->exponential = law->exponential;
  spring->energy[0] = tension * scale.force;
  spring->energy[1] = (shear > 0 ? shear : tension) * scale.force;
}

int
qn_law_coulomb_strength (const QnSpring *s, QnStrengthRow rows[])
{
  rows[0] = (QnStrengthRow){ .normal = 1, .limit = s->cap, .opening = 1 };
  rows[1] = (QnStrengthRow){
    .normal = s->friction, .shear = 1, .limit = s->cohesion, .opening = s->dilatancy
  };
  if (s->compression <= 0)
    return 2;
  rows[2] = (QnStrengthRow){ .normal = -1, .limit = s->compression, .opening = -1 };
  return 3;
}

/* The steepest of a brittle bond is as steep as one likes: it breaks at once, and needs no refusal. */
static double
softening_coulomb (const QnSpring *s)
{
  return qn_spring_has_bond (s) ? s->kn * QN_BOND_ROUNDING : 0;
}

#define JOINT_PARAMETERS                                                                 \
  QN_LAW_PARAMETER ("cohesion", cohesion, false, false),                                 \
    QN_LAW_PARAMETER ("tension", tension, false, false),                                 \
    QN_LAW_PARAMETER ("residual_friction", residual_friction, false, true),              \
    QN_LAW_PARAMETER ("fracture_energy_tension", fracture_energy_tension, false, true),  \
    QN_LAW_PARAMETER ("fracture_energy_shear", fracture_energy_shear, false, true),      \
    QN_LAW_PARAMETER ("dilatancy", dilatancy, false, false),                             \
    QN_LAW_PARAMETER ("dilation_end", dilation_end, false, true)

static const QnLawParameter coulomb[] = {
  QN_LAW_PARAMETER ("friction", friction, true, false), JOINT_PARAMETERS
};

const QnLawOps qn_law_ops_coulomb = { QN_LAW_PARAMETERS (coulomb),
                                      .check = coulomb_check,
                                      .resolve = coulomb_resolve,
                                      .evaluate = qn_law_coulomb_evaluate,
                                      .strength = qn_law_coulomb_strength,
                                      .softening = softening_coulomb,
                                      .plastic = true };

static bool
check_crushing (const QnLaw *law, QnSubject of)
{
  bool ends = law->ultimate_strain > 0;

  return coulomb_check (law, of)
         && qn_require (of, !(ends && law->kn * law->ultimate_strain < law->compression),
                        QN_PROBLEM_ULTIMATE_STRAIN_TOO_SMALL, "ultimate_strain",
                        law->ultimate_strain)
         && qn_require (of, !(ends && law->crushing_energy == 0),
                        QN_PROBLEM_FRACTURE_ENERGY_MISSING, "crushing_energy", 0)
         && qn_require (of, !(!ends && law->crushing_energy > 0), QN_PROBLEM_NOT_POSITIVE,
                        "ultimate_strain", 0)
         && qn_require (of, !(ends && law->dilatancy > 0), QN_PROBLEM_CRUSHING_DILATES,
                        "dilatancy", law->dilatancy);
}

static void
resolve_crushing (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  coulomb_resolve (law, scale, spring);
  spring->compression = law->compression * scale.force;
  spring->ultimate = law->ultimate_strain * scale.strain;
  if (law->ultimate_strain > 0)
    spring->crushing = 2 * law->crushing_energy / law->compression;
}

static double
softening_crushing (const QnSpring *s)
{
  double length = s->crushing - s->compression / s->kn;

  if (s->crushing == 0)
    return softening_coulomb (s);
  return length > 0 ? s->compression / length : INFINITY;
}

static const QnLawParameter mohr_coulomb[] = {
  QN_LAW_PARAMETER ("friction", friction, true, false),
  QN_LAW_PARAMETER ("compression", compression, true, true), JOINT_PARAMETERS,
  QN_LAW_PARAMETER ("ultimate_strain", ultimate_strain, false, true),
  QN_LAW_PARAMETER ("crushing_energy", crushing_energy, false, true)
};

const QnLawOps qn_law_ops_mohr_coulomb = { QN_LAW_PARAMETERS (mohr_coulomb),
                                           .check = check_crushing,
                                           .resolve = resolve_crushing,
                                           .evaluate = qn_law_coulomb_evaluate,
                                           .strength = qn_law_coulomb_strength,
                                           .softening = softening_crushing,
                                           .plastic = true };
