#include "core/contact/pair-series.h"

#include "core/base/tolerance.h"

#include <math.h>

/* Most doublings of the interval in which a root is looked for, and most trials in it. */
#define WIDENINGS  60
#define NARROWINGS 60

void
qn_pair_series_flexibility (const QnPairSeries *series, double inverse[2][2])
{
  double sum[2][2];

  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      sum[i][j] = series->a.tangent[i][j] + series->b.tangent[i][j];
  /* inverse * sum = 1, with sum regularised where both springs are without stiffness. */
  double kn = series->springs->a.kn + series->springs->b.kn,
         ks = series->springs->a.ks + series->springs->b.ks;
  double a = sum[0][0] + QN_TOLERANCE_SERIES * kn,
         d = sum[1][1] + QN_TOLERANCE_SERIES * ks;
  double determinant = a * d - sum[0][1] * sum[1][0];
  if (fabs (determinant) < QN_TOLERANCE_SERIES * QN_TOLERANCE_SERIES * kn * ks) {
    inverse[0][0] = 1 / kn;
    inverse[1][1] = 1 / ks;
    inverse[0][1] = inverse[1][0] = 0;
    return;
  }
  inverse[0][0] = d / determinant;
  inverse[1][1] = a / determinant;
  inverse[0][1] = -sum[0][1] / determinant;
  inverse[1][0] = -sum[1][0] / determinant;
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
  /* Both may be far from where they were built, one as far back as the other. */
  const double *qa = series->qa;
  double far = fabs (qa[0]) + fabs (qa[1]) + fabs (qb[0]) + fabs (qb[1]);
  scale += 1e-3 * (s->a.kn + s->b.kn) * far;
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
  double inverse[2][2];

  /* Where neither spring has stiffness in a direction, both slip, yield or are open, and
   * no tangent shows how to share the elongation. But the stronger one cannot yield
   * further: it is set back to where it carries the force of the other elastically. */
  const QnPairSprings *s = series->springs;
  const QnSpringMemory *ma = &series->committed->a, *mb = &series->committed->b;
  const double origin_a[2] = { ma->opening, ma->slip }, ka[2] = { s->a.kn, s->a.ks };
  const double origin_b[2] = { mb->opening, mb->slip }, kb[2] = { s->b.kn, s->b.ks };
  bool set_back = false;
  for (int i = 0; i < 2; i++) {
    double stiffness = fabs (series->a.tangent[i][i]) + fabs (series->b.tangent[i][i]);
    double fa = series->a.force[i], fb = series->b.force[i];
    if (stiffness > QN_TOLERANCE_SERIES * (ka[i] + kb[i]) || fa == fb)
      continue;
    if (fabs (fa) > fabs (fb))
      series->qa[i] = origin_a[i] + fb / ka[i];
    else
      series->qa[i] = series->q[i] - (origin_b[i] + fa / kb[i]);
    set_back = true;
  }
  if (!set_back) {
    qn_pair_series_flexibility (series, inverse);
    for (int i = 0; i < 2; i++)
      series->qa[i] -= inverse[i][0] * series->gap[0] + inverse[i][1] * series->gap[1];
  }
  evaluate (series);
}

/* gap[i] at qa[i] = x. */
static double
gap_at (QnPairSeries *series, int i, double x)
{
  series->qa[i] = x;
  evaluate (series);
  return series->gap[i];
}

/* Closes gap[i] along qa[i] alone, along which it grows: an interval that holds the root, then
 * false position with halved weights (Illinois). */
static void
close_gap (QnPairSeries *series, int i)
{
  const QnPairSprings *s = series->springs;
  double stiffness = i == 0 ? s->a.kn + s->b.kn : s->a.ks + s->b.ks;
  double low = series->qa[i], high = low, g_low = series->gap[i], g_high = g_low;
  double reach = fabs (g_low) / stiffness;

  for (int k = 0; k < WIDENINGS && g_low > 0; k++, reach *= 2)
    g_low = gap_at (series, i, low -= reach);
  for (int k = 0; k < WIDENINGS && g_high < 0; k++, reach *= 2)
    g_high = gap_at (series, i, high += reach);
  for (int k = 0; k < NARROWINGS && g_low < 0 && g_high > 0; k++) {
    double x = (low * g_high - high * g_low) / (g_high - g_low);
    double g = gap_at (series, i, x);
    if (fabs (g) <= QN_TOLERANCE_SERIES * (fabs (series->a.force[i]) + stiffness * reach))
      return;
    if (g > 0) {
      high = x;
      g_high = g;
      g_low *= 0.5;
    } else {
      low = x;
      g_low = g;
      g_high *= 0.5;
    }
  }
}

void
qn_pair_series_sweep (QnPairSeries *series)
{
  for (int i = 0; i < 2; i++)
    if (series->gap[i] != 0)
      close_gap (series, i);
}
