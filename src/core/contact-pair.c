#include "core/contact-pair.h"

#include "core/tolerance.h"

/* Most iterations of the internal Newton; a handful is usual, one per change of phase. */
#define INTERNAL_ITERATIONS 60

QnPairSprings
qn_pair_springs (QnSpring a, QnSpring b)
{
  QnPairSprings springs = { .a = a, .b = b, .equal = qn_spring_equal (&a, &b) };
  if (springs.equal) {
    springs.a.kn *= 0.5;
    springs.a.ks *= 0.5;
  }
  return springs;
}

/* inverse * m = 1, with m regularised where both springs are without stiffness. */
static void
invert_sum (const QnPairSprings *s, double m[2][2], double inverse[2][2])
{
  double kn = s->a.kn + s->b.kn, ks = s->a.ks + s->b.ks;
  double a = m[0][0] + QN_TOLERANCE_SERIES * kn, d = m[1][1] + QN_TOLERANCE_SERIES * ks;
  double determinant = a * d - m[0][1] * m[1][0];

  if (fabs (determinant) < QN_TOLERANCE_SERIES * QN_TOLERANCE_SERIES * kn * ks) {
    inverse[0][0] = 1 / kn;
    inverse[1][1] = 1 / ks;
    inverse[0][1] = inverse[1][0] = 0;
    return;
  }
  inverse[0][0] = d / determinant;
  inverse[1][1] = a / determinant;
  inverse[0][1] = -m[0][1] / determinant;
  inverse[1][0] = -m[1][0] / determinant;
}

/* Evaluates both springs at the split qa and returns the size of the force gap between them,
 * relative to the forces themselves and to what rounding of q makes of them. */
static double
series_gap (const QnPairSprings *s, const QnPairMemory *committed, const double q[2],
            const double qa[2], QnSpringResponse *ra, QnSpringResponse *rb, double gap[2])
{
  double qb[2] = { q[0] - qa[0], q[1] - qa[1] };

  qn_spring_evaluate (&s->a, &committed->a, qa, ra);
  qn_spring_evaluate (&s->b, &committed->b, qb, rb);
  gap[0] = ra->force[0] - rb->force[0];
  gap[1] = ra->force[1] - rb->force[1];

  double scale =
    fabs (ra->force[0]) + fabs (ra->force[1]) + fabs (rb->force[0]) + fabs (rb->force[1]);
  scale += 1e-3 * (s->a.kn + s->b.kn) * (fabs (q[0]) + fabs (q[1]));
  return scale > 0 ? hypot (gap[0], gap[1]) / scale : 0;
}

/* response = series of the two springs; tangent Ta (Ta + Tb)^-1 Tb */
static void
series_response (const QnPairSprings *s, const double q[2], const double qa[2],
                 const QnSpringResponse *ra, const QnSpringResponse *rb,
                 QnPairResponse *r)
{
  double sum[2][2], inverse[2][2], share[2][2];

  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      sum[i][j] = ra->tangent[i][j] + rb->tangent[i][j];
  invert_sum (s, sum, inverse);
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      share[i][j] = inverse[i][0] * rb->tangent[0][j] + inverse[i][1] * rb->tangent[1][j];
  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 2; j++)
      r->tangent[i][j] =
        ra->tangent[i][0] * share[0][j] + ra->tangent[i][1] * share[1][j];
    r->force[i] = ra->force[i];
    r->memory.qa[i] = qa[i];
    r->memory.qb[i] = q[i] - qa[i];
  }
  r->memory.a = ra->memory;
  r->memory.b = rb->memory;
  r->phase = (int16_t) (ra->phase * QN_PHASE_COUNT + rb->phase);
}

static bool
series_evaluate (const QnPairSprings *s, const QnPairMemory *committed, const double q[2],
                 QnPairResponse *r)
{
  const double ka[2] = { s->a.kn, s->a.ks }, kb[2] = { s->b.kn, s->b.ks };
  double qa[2], gap[2];
  QnSpringResponse ra, rb;

  /* Elastic share of the increment as the first guess. */
  for (int i = 0; i < 2; i++)
    qa[i] = committed->qa[i]
            + kb[i] / (ka[i] + kb[i]) * (q[i] - committed->qa[i] - committed->qb[i]);

  double size = series_gap (s, committed, q, qa, &ra, &rb, gap);
  for (int iteration = 0; size > QN_TOLERANCE_SERIES && iteration < INTERNAL_ITERATIONS;
       iteration++) {
    double sum[2][2], inverse[2][2], step[2], tried[2], tried_size = 0, alpha = 1;
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 2; j++)
        sum[i][j] = ra.tangent[i][j] + rb.tangent[i][j];
    invert_sum (s, sum, inverse);
    for (int i = 0; i < 2; i++)
      step[i] = -(inverse[i][0] * gap[0] + inverse[i][1] * gap[1]);

    for (int halving = 0; halving < 8; halving++, alpha /= 2) {
      for (int i = 0; i < 2; i++)
        tried[i] = qa[i] + alpha * step[i];
      tried_size = series_gap (s, committed, q, tried, &ra, &rb, gap);
      if (tried_size < size)
        break;
    }
    qa[0] = tried[0];
    qa[1] = tried[1];
    size = tried_size;
  }

  series_response (s, q, qa, &ra, &rb, r);
  return size <= QN_TOLERANCE_SERIES;
}

bool
qn_pair_evaluate (const QnPairSprings *springs, const QnPairMemory *committed,
                  const double q[2], QnPairResponse *r)
{
  if (!springs->equal)
    return series_evaluate (springs, committed, q, r);

  QnSpringResponse whole;
  r->memory = *committed;
  qn_spring_evaluate (&springs->a, &committed->a, q, &whole);
  r->force[0] = whole.force[0];
  r->force[1] = whole.force[1];
  r->tangent[0][0] = whole.tangent[0][0];
  r->tangent[0][1] = whole.tangent[0][1];
  r->tangent[1][0] = whole.tangent[1][0];
  r->tangent[1][1] = whole.tangent[1][1];
  r->memory.a = whole.memory;
  r->phase = (int16_t) whole.phase;
  return true;
}

static QnPairState
phase_state (QnPhase phase)
{
  switch (phase) {
  case QN_PHASE_STICK:
    return QN_PAIR_STICK;
  case QN_PHASE_SLIP_POSITIVE:
  case QN_PHASE_SLIP_NEGATIVE:
    return QN_PAIR_SLIP;
  case QN_PHASE_OPEN:
  case QN_PHASE_OPEN_STICK:
  case QN_PHASE_OPEN_SLIP_POSITIVE:
  case QN_PHASE_OPEN_SLIP_NEGATIVE:
    return QN_PAIR_OPEN;
  case QN_PHASE_COUNT:
    break;
  }
  QN_ASSERT (false);
  return QN_PAIR_STICK;
}

QnPairState
qn_pair_state (const QnPairSprings *springs, int16_t phase)
{
  if (springs->equal)
    return phase_state ((QnPhase) phase);

  QnPairState a = phase_state ((QnPhase) (phase / QN_PHASE_COUNT));
  QnPairState b = phase_state ((QnPhase) (phase % QN_PHASE_COUNT));
  return a > b ? a : b;
}
