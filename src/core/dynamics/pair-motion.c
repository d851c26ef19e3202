#include "core/dynamics/pair-motion.h"

#include <math.h>

/* Elongations, m, that are rounding. */
#define ROUNDING 1e-15

/* The part of an elongation that is left by rounding where a joint is closed. */
#define NOTHING 1e-12

/* Of springs that are elastic but for opening and slip, the normal force at which they open. */
static bool
opens (const QnSpring *spring, double *cap)
{
  switch (spring->kind) {
  case QN_LAW_ELASTIC:
    *cap = INFINITY;
    return true;
  case QN_LAW_NO_TENSION:
  case QN_LAW_COULOMB:
    *cap = spring->cap;
    return true;
  case QN_LAW_MOHR_COULOMB:
  case QN_LAW_BILINEAR:
  case QN_LAW_ELASTIC_PLASTIC:
  case QN_LAW_CONCRETE:
  case QN_LAW_STEEL:
  case QN_LAW_CURVE:
  case QN_LAW_KIND_COUNT:
    break;
  }
  *cap = INFINITY;
  return false;
}

QnPairElasticity
qn_pair_elasticity (const QnPairSprings *s)
{
  QnPairElasticity pair;
  double cap_a, cap_b;

  pair.conserves = opens (&s->a, &cap_a);
  pair.cap = cap_a;
  pair.friction = s->a.friction;
  bool slides = s->a.kind == QN_LAW_COULOMB || s->a.kind == QN_LAW_NO_TENSION;
  pair.cohesion = s->equal && slides ? s->a.cohesion : INFINITY;
  pair.k[0] = s->a.kn;
  pair.k[1] = s->a.ks;
  if (s->equal)
    return pair;
  pair.conserves &= opens (&s->b, &cap_b);
  pair.cap = fmin (cap_a, cap_b);
  pair.k[0] = 1 / (1 / s->a.kn + 1 / s->b.kn);
  pair.k[1] = 1 / (1 / s->a.ks + 1 / s->b.ks);
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

  if (!isfinite (pair->cap))
    return 0;
  plastic_elongation (at, plastic);
  double rest = at->q[0] - plastic[0] - at->response->force[0] / pair->k[0];
  return rest > NOTHING * (fabs (at->q[0]) + fabs (plastic[0])) ? rest : 0;
}

/* c where the pair opens or closes, `opened` by how much. */
static void
add_opening (const QnPairElasticity *pair, const QnPairInstant *start,
             const QnPairInstant *end, double opened, bool open, QnPairForces *out)
{
  const double *f0 = start->response->force, *f1 = end->response->force;
  const QnPairResponse *now = end->response;
  double dq = end->q[0] - start->q[0];
  const double mean[2] = { 0.5 * (f0[0] + f1[0]) - pair->cap, 0.5 * (f0[1] + f1[1]) };
  double share = opened / dq;

  for (int i = 0; i < 2; i++) {
    out->correction[i] = -mean[i] * share;
    out->tangent[i][0] -=
      0.5 * now->tangent[i][0] * share + mean[i] * ((open ? 1 : 0) - share) / dq;
    out->tangent[i][1] -= 0.5 * now->tangent[i][1] * share;
  }
}

/* c where the pair begins to slip, or slips the other way. */
static void
add_slip (const QnPairElasticity *pair, const QnPairInstant *start,
          const QnPairInstant *end, double slipped, QnPairForces *out)
{
  const double *f0 = start->response->force, *f1 = end->response->force;
  const QnPairResponse *now = end->response;
  double dq = end->q[1] - start->q[1], share = slipped / dq, dn = f1[0] - f0[0];
  double sign = slipped < 0 ? -1 : 1;

  if (!(share > 0 && share <= 1))
    return;
  double strength = sign * (pair->cohesion - pair->friction * (f0[0] + (1 - share) * dn));
  double missing = 0.5 * (strength - f0[1]);
  out->correction[1] = share * missing;
  for (int j = 0; j < 2; j++) {
    double slope = ((j == 1 ? 1 - share : 0) - now->tangent[1][j] / pair->k[1]) / dq;
    double normal = (1 - share) * now->tangent[0][j] - dn * slope;
    out->tangent[1][j] += slope * missing - 0.5 * share * sign * pair->friction * normal;
  }
}

/* c and its derivatives. */
static void
add_correction (const QnPairElasticity *pair, const QnPairInstant *start,
                const QnPairInstant *end, QnPairForces *out)
{
  double open = gap (pair, end), opened = open - gap (pair, start);
  double before[2], after[2];

  if (!pair->conserves)
    return;
  if (opened != 0 && fabs (end->q[0] - start->q[0]) > ROUNDING) {
    add_opening (pair, start, end, opened, open > 0, out);
    return;
  }
  plastic_elongation (start, before);
  plastic_elongation (end, after);
  if (open == 0 && after[1] != before[1] && isfinite (pair->cohesion)
      && fabs (end->q[1] - start->q[1]) > ROUNDING)
    add_slip (pair, start, end, after[1] - before[1], out);
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
    double gap_slope = open > 0 && j == 0 ? (opened < 0 ? -1 : 1) : 0;
    double force_slope = n1 < 0 ? -now->tangent[0][j] : now->tangent[0][j];
    slopes[j] =
      (force_slope * inelastic - force * pair->k[0] * (slip + gap_slope)) / (sum * sum);
  }
  return force / sum;
}

static void
add_dashpot (const QnPairElasticity *pair, const QnPairStep *step,
             const QnPairInstant *start, const QnPairInstant *end, QnPairForces *out)
{
  const QnPairResponse *now = end->response;
  double gain = (1 - step->alpha_f) * step->rate_gain, slopes[2] = { 0 }, share = 1;
  bool follows = step->of == QN_DAMPING_CURRENT;

  if (follows)
    share = elastic_share (pair, start, end, slopes);
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
}

QnPairForces
qn_pair_motion (const QnPairElasticity *pair, const QnPairStep *step,
                const QnPairInstant *start, const QnPairInstant *end)
{
  QnPairForces out = { 0 };
  double weight = 1 - step->alpha_f;

  add_correction (pair, start, end, &out);
  if (step->damping > 0)
    add_dashpot (pair, step, start, end, &out);
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      out.tangent[i][j] = end->response->tangent[i][j] + out.tangent[i][j] / weight;
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
qn_pair_elastic_energy (const QnPairElasticity *pair, const QnPairInstant *at)
{
  const double *f = at->response->force;
  double held = isfinite (pair->cap) ? pair->cap * gap (pair, at) : 0;

  return 0.5 * (f[0] * f[0] / pair->k[0] + f[1] * f[1] / pair->k[1]) + held;
}

double
qn_pair_friction (const QnPairElasticity *pair, const QnPairForces *forces,
                  const QnPairInstant *start, const QnPairInstant *end)
{
  const double *f0 = start->response->force, *f1 = end->response->force;
  double before[2], after[2], work = 0;

  plastic_elongation (start, before);
  plastic_elongation (end, after);
  for (int i = 0; i < 2; i++) {
    double moved = pair->conserves ? after[i] - before[i] : end->q[i] - start->q[i];
    work += 0.5 * (f0[i] + f1[i]) * moved;
  }
  if (!pair->conserves) /* all that its elasticity does not hold */
    work -= qn_pair_elastic_energy (pair, end) - qn_pair_elastic_energy (pair, start);
  return work + forces->correction[1] * (end->q[1] - start->q[1]);
}
