#include "core/pair-series.h"

#include "core/tolerance.h"

#include <math.h>

/* Shortest step of the line search: 2^-7. */
#define HALVINGS 8

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

void
qn_pair_series_flexibility (const QnPairSeries *series, double inverse[2][2])
{
  double sum[2][2];

  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      sum[i][j] = series->a.tangent[i][j] + series->b.tangent[i][j];
  invert_sum (series->springs, sum, inverse);
}

/* Evaluates both springs at the present share. */
static void
evaluate (QnPairSeries *series)
{
  const QnPairSprings *s = series->springs;
  const double *q = series->q;
  double qb[2] = { q[0] - series->qa[0], q[1] - series->qa[1] };

  qn_spring_evaluate (&s->a, &series->committed->a, series->qa, &series->a);
  qn_spring_evaluate (&s->b, &series->committed->b, qb, &series->b);

  const double *fa = series->a.force, *fb = series->b.force;
  double scale = fabs (fa[0]) + fabs (fa[1]) + fabs (fb[0]) + fabs (fb[1]);
  scale += 1e-3 * (s->a.kn + s->b.kn) * (fabs (q[0]) + fabs (q[1]));
  series->gap[0] = fa[0] - fb[0];
  series->gap[1] = fa[1] - fb[1];
  series->size = scale > 0 ? hypot (series->gap[0], series->gap[1]) / scale : 0;
}

void
qn_pair_series_start (QnPairSeries *series, const QnPairSprings *springs,
                      const QnPairMemory *committed, const double q[2])
{
  const double ka[2] = { springs->a.kn, springs->a.ks };
  const double kb[2] = { springs->b.kn, springs->b.ks };

  series->springs = springs;
  series->committed = committed;
  for (int i = 0; i < 2; i++) {
    series->q[i] = q[i];
    series->qa[i] =
      committed->qa[i]
      + kb[i] / (ka[i] + kb[i]) * (q[i] - committed->qa[i] - committed->qb[i]);
  }
  evaluate (series);
}

void
qn_pair_series_step (QnPairSeries *series)
{
  double inverse[2][2], from[2], step[2], size = series->size, alpha = 1;

  qn_pair_series_flexibility (series, inverse);
  for (int i = 0; i < 2; i++) {
    from[i] = series->qa[i];
    step[i] = -(inverse[i][0] * series->gap[0] + inverse[i][1] * series->gap[1]);
  }
  for (int halving = 0; halving < HALVINGS; halving++, alpha /= 2) {
    for (int i = 0; i < 2; i++)
      series->qa[i] = from[i] + alpha * step[i];
    evaluate (series);
    if (series->size < size)
      return;
  }
}
