#include "core/dynamics/pair-motion.h"

#include <math.h>

/* The part of an elongation that is left by rounding where a joint is closed. */
#define NOTHING 1e-12

/* Takes up a spring. Returns whether it is elastic but for opening and slip. */
static bool
take_spring (QnPairElasticity *pair, const QnSpring *spring)
{
  bool opens = spring->kind == QN_LAW_NO_TENSION || spring->kind == QN_LAW_COULOMB;
  bool bond = qn_spring_has_bond (spring);

  pair->bond |= bond;
  pair->opens |= opens;
  if (opens)
    pair->friction = fmin (pair->friction, spring->friction);
  return spring->kind == QN_LAW_ELASTIC || (opens && !bond);
}

QnPairElasticity
qn_pair_elasticity (const QnPairSprings *s)
{
  QnPairElasticity pair = { .friction = INFINITY };

  qn_pair_elastic_stiffness (s, pair.k);
  pair.conserves = take_spring (&pair, &s->a);
  if (!s->equal)
    pair.conserves &= take_spring (&pair, &s->b);
  return pair;
}

/* Plastic elongations of both springs together. */
static void
plastic_elongation (const QnPairInstant *at, double plastic[2])
{
  const QnPairMemory *memory = &at->response->memory;

  plastic[0] = memory->a.opening + memory->b.opening;
  plastic[1] = memory->a.slip + memory->b.slip;
}

/* How far the pair stands open: elongation that neither strains it nor is plastic. */
static double
gap (const QnPairElasticity *pair, const QnPairInstant *at)
{
  double plastic[2];

  if (!pair->opens)
    return 0;
  plastic_elongation (at, plastic);
  double rest = at->q[0] - plastic[0] - at->response->force[0] / pair->k[0];
  return rest > NOTHING * (fabs (at->q[0]) + fabs (plastic[0])) ? rest : 0;
}

/* How far the pair is from where it opens: the gap, negative while it is closed, m. */
static double
distance (const QnPairElasticity *pair, const QnPairInstant *at)
{
  double open = gap (pair, at);

  return open > 0 ? open : at->response->force[0] / pair->k[0];
}

/* Mean of what is positive of a number that goes evenly from a to b, and its derivatives. */
static double
mean_positive (double a, double b, double slopes[2])
{
  slopes[0] = a > 0 ? 0.5 : 0;
  slopes[1] = b > 0 ? 0.5 : 0;
  if ((a > 0) == (b > 0))
    return a > 0 ? 0.5 * (a + b) : 0;
  double high = fmax (a, b), share = high / fabs (a - b);
  slopes[a > 0 ? 0 : 1] = 0.5 * share * (2 - share);
  slopes[a > 0 ? 1 : 0] = 0.5 * share * share;
  return 0.5 * high * share;
}

/* Strength in shear at a normal force, and its derivative. */
static double
shear_strength (const QnPairElasticity *pair, double n, double *slope)
{
  double left = -pair->friction * n;

  *slope = left > 0 ? -pair->friction : 0;
  return fmax (left, 0);
}

/* Mean of what the shear force, were it elastic, is beyond its strength on one part of the way:
 * from e[0], S[0] to e[1], S[1]. Derivatives by e and S at both ends. */
static double
mean_beyond (const double e[2], const double strength[2], double by_e[2], double by_s[2])
{
  double up[2], down[2];
  double beyond = mean_positive (e[0] - strength[0], e[1] - strength[1], up)
                  - mean_positive (-e[0] - strength[0], -e[1] - strength[1], down);

  for (int i = 0; i < 2; i++) {
    by_e[i] = up[i] + down[i];
    by_s[i] = down[i] - up[i];
  }
  return beyond;
}

/* c_t; x and dx: distances from where the pair opens, and the derivatives of the last. */
static void
add_shear_correction (const QnPairElasticity *pair, const QnPairInstant *start,
                      const QnPairInstant *end, const double x[2], const double dx[2],
                      QnPairForces *out)
{
  const double *f0 = start->response->force, *f1 = end->response->force;
  const QnPairResponse *now = end->response;
  bool crosses = (x[0] > 0) != (x[1] > 0);
  double part = crosses ? x[0] / (x[0] - x[1]) : 1, rise = end->q[1] - start->q[1];
  double slope, unused, by_e[2][2], by_s[2][2];
  double last = f0[1] + pair->k[1] * rise;
  const double first_e[2] = { f0[1], f0[1] + pair->k[1] * rise * part };
  const double then_e[2] = { first_e[1], last };
  double at_end = shear_strength (pair, f1[0], &slope);
  double between = crosses ? 0 : at_end;
  const double first_s[2] = { shear_strength (pair, f0[0], &unused), between };
  const double then_s[2] = { between, at_end };

  double first = mean_beyond (first_e, first_s, by_e[0], by_s[0]);
  double then = mean_beyond (then_e, then_s, by_e[1], by_s[1]);
  double at_knot = part * by_e[0][1] + (1 - part) * by_e[1][0];
  double by_part = first - then + at_knot * pair->k[1] * rise;

  out->correction[1] =
    0.5 * (f0[1] + last) - part * first - (1 - part) * then - 0.5 * (f0[1] + f1[1]);
  for (int j = 0; j < 2; j++) {
    double d_part = crosses ? part / (x[0] - x[1]) * dx[j] : 0;
    double d_e = j == 1 ? pair->k[1] : 0, d_s = slope * now->tangent[0][j];
    double d_mean =
      by_part * d_part + at_knot * part * d_e
      + (crosses ? (1 - part) * (by_e[1][1] * d_e + by_s[1][1] * d_s) : by_s[0][1] * d_s);
    out->tangent[1][j] += 0.5 * d_e - d_mean - 0.5 * now->tangent[1][j];
  }
}

/* The share of a step's own rate in the dashpot of the current stiffness, and its derivatives. */
static double
elastic_share (const QnPairElasticity *pair, const QnPairInstant *start,
               const QnPairInstant *end, double slopes[2])
{
  const QnPairResponse *now = end->response;
  double n0 = start->response->force[0], n1 = now->force[0], before[2], after[2];
  double open = gap (pair, end), opened = open - gap (pair, start);

  plastic_elongation (start, before);
  plastic_elongation (end, after);
  double slipped = after[1] - before[1], spread = after[0] - before[0];
  double force = fabs (n0) + fabs (n1);
  double inelastic = pair->k[0] * (fabs (slipped) + fabs (spread) + fabs (opened));
  double sum = force + inelastic;

  slopes[0] = slopes[1] = 0;
  if (inelastic == 0 || sum == 0)
    return force > 0 ? 1 : 0;
  for (int j = 0; j < 2; j++) {
    double own = j == 1 ? 1 : 0;
    double slip = own - now->tangent[1][j] / pair->k[1];
    slip = slipped > 0 ? slip : slipped < 0 ? -slip : 0;
    double apart = open > 0 && j == 0 ? 1 : 0;
    double gap_slope = opened < 0 ? -apart : apart;
    double spread_slope = 1 - own - apart - now->tangent[0][j] / pair->k[0];
    gap_slope += spread > 0 ? spread_slope : spread < 0 ? -spread_slope : 0;
    double force_slope = n1 < 0 ? -now->tangent[0][j] : now->tangent[0][j];
    slopes[j] =
      (force_slope * inelastic - force * pair->k[0] * (slip + gap_slope)) / (sum * sum);
  }
  return force / sum;
}

/* The normal dashpot does not pull a joint that opens: where it would, no force is left. That of a bond it
 * leaves as it is, with the tangent `own_tangent`. */
static void
keep_pressed (const QnPairElasticity *pair, const QnPairStep *step,
              const QnPairInstant *start, const QnPairInstant *end,
              const double own_tangent[2], QnPairForces *out)
{
  double weight = 1 - step->alpha_f;
  double own = weight * end->response->force[0]
               + step->alpha_f * start->response->force[0] + out->correction[0];
  bool bonded = pair->bond && own > 0;

  if (!pair->opens || own + out->dashpot[0] <= (bonded ? own : 0))
    return;
  out->dashpot[0] = bonded ? 0 : -own;
  for (int j = 0; j < 2; j++)
    out->tangent[0][j] = bonded ? own_tangent[j] : -weight * end->response->tangent[0][j];
}

static void
add_dashpot (const QnPairElasticity *pair, const QnPairStep *step,
             const QnPairInstant *start, const QnPairInstant *end, QnPairForces *out)
{
  const QnPairResponse *now = step->held != NULL ? step->held : end->response;
  const QnPairInstant held = { .q = { end->q[0], end->q[1] }, .response = now };
  double gain = (1 - step->alpha_f) * step->rate_gain, slopes[2] = { 0 }, share = 1;
  bool follows = step->of != QN_DAMPING_INITIAL;
  const double undamped[2] = { out->tangent[0][0], out->tangent[0][1] };

  if (follows)
    share = elastic_share (pair, start, &held, slopes);
  for (int i = 0; i < 2; i++) {
    double rate = (1 - step->alpha_f) * end->rate[i] + step->alpha_f * start->rate[i];
    double mean = follows ? (end->q[i] - start->q[i]) / step->length : 0;
    double ak = step->damping * pair->k[i];
    out->dashpot[i] = ak * share * (rate - mean);
    out->tangent[i][i] += ak * share * (gain - (follows ? 1 / step->length : 0));
    if (!follows)
      continue;
    double change = now->force[i] - start->response->force[i];
    out->dashpot[i] += step->damping * change / step->length;
    for (int j = 0; j < 2; j++)
      out->tangent[i][j] += step->damping * now->tangent[i][j] / step->length
                            + ak * slopes[j] * (rate - mean);
  }
  if (step->of == QN_DAMPING_IMPACT)
    keep_pressed (pair, step, start, end, undamped, out);
}

/* Whether the bond of a spring is damaged further, but not held. */
static bool
softens (const QnSpring *spring, const QnSpringMemory *before,
         const QnSpringMemory *after)
{
  return qn_spring_has_bond (spring) && after->extreme > before->extreme
         && after->extreme < QN_BOND_BREAKS;
}

bool
qn_pair_holds_damage (const QnPairSprings *springs, const QnPairMemory *committed,
                      const QnPairInstant *start, const QnPairInstant *end,
                      QnPairResponse *held)
{
  const QnPairMemory *before = &start->response->memory, *after = &end->response->memory;

  if (!softens (&springs->a, &before->a, &after->a)
      && !softens (&springs->b, &before->b, &after->b))
    return false;
  QnPairSprings lasting = *springs;
  lasting.a.outlasts = lasting.b.outlasts = true;
  return qn_pair_evaluate (&lasting, committed, end->q, held);
}

QnPairForces
qn_pair_motion (const QnPairElasticity *pair, const QnPairStep *step,
                const QnPairInstant *start, const QnPairInstant *end)
{
  QnPairForces out = { 0 };
  double weight = 1 - step->alpha_f;

  if (pair->conserves) { /* c and its derivatives */
    const QnPairResponse *now = end->response;
    double x[2] = { -1, -1 }, dx[2] = { 0 }, slopes[2];
    if (pair->opens) {
      x[0] = distance (pair, start);
      x[1] = distance (pair, end);
      for (int j = 0; j < 2; j++)
        dx[j] = x[1] > 0 ? (j == 0 ? 1 : 0) : now->tangent[0][j] / pair->k[0];
      double mean = -pair->k[0] * mean_positive (-x[0], -x[1], slopes);
      out.correction[0] = mean - 0.5 * (start->response->force[0] + now->force[0]);
      for (int j = 0; j < 2; j++)
        out.tangent[0][j] += pair->k[0] * slopes[1] * dx[j] - 0.5 * now->tangent[0][j];
    }
    if (isfinite (pair->friction))
      add_shear_correction (pair, start, end, x, dx, &out);
  }
  if (step->damping > 0)
    add_dashpot (pair, step, start, end, &out);
  for (int i = 0; i < 2; i++) {
    out.total[i] =
      end->response->force[i] + (out.correction[i] + out.dashpot[i]) / weight;
    for (int j = 0; j < 2; j++)
      out.tangent[i][j] = end->response->tangent[i][j] + out.tangent[i][j] / weight;
  }
  return out;
}

/* Bits of a branch. */
enum { OPEN_BEFORE = 1, OPEN_AFTER = 2, SLIPS_ON = 4, SLIPS_BACK = 8 };

int
qn_pair_branch (const QnPairElasticity *pair, const QnPairInstant *start,
                const QnPairInstant *end)
{
  double before[2], after[2];

  plastic_elongation (start, before);
  plastic_elongation (end, after);
  return (gap (pair, start) > 0 ? OPEN_BEFORE : 0)
         | (gap (pair, end) > 0 ? OPEN_AFTER : 0) | (after[1] > before[1] ? SLIPS_ON : 0)
         | (after[1] < before[1] ? SLIPS_BACK : 0);
}

bool
qn_pair_branch_is_still (int branch)
{
  return branch == 0 || branch == (OPEN_BEFORE | OPEN_AFTER);
}

double
qn_pair_elastic_energy (const QnPairElasticity *pair, const double f[2])
{
  return 0.5 * (f[0] * f[0] / pair->k[0] + f[1] * f[1] / pair->k[1]);
}

double
qn_pair_friction (const QnPairElasticity *pair, const QnPairForces *forces,
                  const QnPairInstant *start, const QnPairInstant *end)
{
  const double *f0 = start->response->force, *f1 = end->response->force;
  double work = qn_pair_elastic_energy (pair, f0) - qn_pair_elastic_energy (pair, f1);

  for (int i = 0; i < 2; i++)
    work += (0.5 * (f0[i] + f1[i]) + forces->correction[i]) * (end->q[i] - start->q[i]);
  return work;
}
