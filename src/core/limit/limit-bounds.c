#include "core/limit/limit-bounds.h"

#include <math.h>
#include <string.h>

/* Least dissipation sum h z over z >= 0 with G'z = rate, at a vertex of that little program,
 * that is with two rows at most. Where the rate cannot be had, the nearest vertex counts and
 * *missing is how far it is. */
static double
dissipation (const QnIpProblem *p, const QnIpCell *cell, const double *rate,
             double *missing_rate)
{
  const QnIpBound *b = p->bounds + cell->first_bound;
  double least_missing = hypot (rate[0], cell->no_shear ? 0.0 : rate[1]);
  double best = least_missing > 0.0 ? INFINITY : 0.0;

  for (int32_t i = 0; i < cell->bound_count; i++) {
    double along = b[i].normal * rate[0] + (cell->no_shear ? 0.0 : b[i].shear * rate[1]);
    double square = b[i].normal * b[i].normal + b[i].shear * b[i].shear;
    double z = fmax (0.0, along / square);
    double missing =
      hypot (rate[0] - z * b[i].normal, cell->no_shear ? 0.0 : rate[1] - z * b[i].shear);
    if (missing < least_missing || (missing == least_missing && z * b[i].limit < best)) {
      least_missing = missing;
      best = z * b[i].limit;
    }
    for (int32_t j = 0; j < i && !cell->no_shear; j++) {
      double cross = b[i].normal * b[j].shear - b[i].shear * b[j].normal;
      double zi, zj;
      if (cross == 0.0)
        continue;
      zi = (rate[0] * b[j].shear - rate[1] * b[j].normal) / cross;
      zj = (b[i].normal * rate[1] - b[i].shear * rate[0]) / cross;
      if (zi < 0.0 || zj < 0.0)
        continue;
      if (least_missing > 0.0 || zi * b[i].limit + zj * b[j].limit < best)
        best = zi * b[i].limit + zj * b[j].limit;
      least_missing = 0.0;
    }
  }
  *missing_rate = least_missing;
  return isfinite (best) ? best : 0.0;
}

double
qn_limit_upper_bound (const QnLimitProblem *limit, double *v, const double *y,
                      double *rates, QnLimitCheck *check)
{
  const QnIpProblem *p = &limit->ip;
  double power = 0.0, largest = 0.0, bound = 0.0, violation = 0.0;

  for (int32_t r = 0; r < p->row_count; r++)
    power += p->load[r] * v[r];
  for (int32_t r = 0; r < p->row_count; r++) {
    v[r] /= power;
    largest = fmax (largest, fabs (v[r]));
    bound -= p->constant[r] * v[r];
  }
  memset (rates, 0, 2 * (size_t) p->cell_count * sizeof *rates);
  qn_ip_add_rates (p, v, -1, rates);
  for (int32_t c = 0; c < p->cell_count; c++) {
    double missing;
    bound += dissipation (p, &p->cells[c], rates + 2 * c, &missing);
    bound += missing * hypot (y[2 * c], y[2 * c + 1]);
    violation = fmax (violation, missing);
  }
  check->kinematic_violation = violation / largest;
  return bound;
}
