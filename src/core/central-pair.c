#include "core/central-pair.h"

#include <math.h>
#include <string.h>

/* out = G y */
static void
apply_strength (const QnCentralPair *pair, const double y[2], double out[QN_CENTRAL_ROWS])
{
  out[0] = y[0];
  out[1] = pair->friction * y[0] + y[1];
  out[2] = pair->friction * y[0] - y[1];
}

void
qn_central_pair_flow (const QnCentralPair *pair, const double z[QN_CENTRAL_ROWS],
                      double out[2])
{
  out[0] = z[0] + pair->dilatancy * (z[1] + z[2]);
  out[1] = z[1] - z[2];
}

/* s > 0 with s - product / s = surplus, without cancellation. */
static double
positive_root (double surplus, double product)
{
  double root = sqrt (surplus * surplus + 4 * product);

  return surplus >= 0 ? 0.5 * (surplus + root) : 2 * product / (root - surplus);
}

void
qn_central_pair_start (QnCentralPair *pair, const QnPairSprings *springs,
                       const QnPairMemory *memory, const double q[2], const double y[2],
                       double force, double length, double size)
{
  const QnSpring *spring = &springs->a;
  double stiffness = force / length, used[QN_CENTRAL_ROWS];

  *pair = (QnCentralPair){ 0 };
  if (!springs->equal || spring->kind != QN_LAW_COULOMB)
    return;
  pair->rows = spring->friction > 0 || spring->cohesion > 0 ? QN_CENTRAL_ROWS : 1;
  pair->friction = spring->friction;
  pair->dilatancy = spring->dilatancy;
  pair->flexibility[0] = stiffness / spring->kn;
  pair->flexibility[1] = stiffness / spring->ks;
  pair->plastic[0] = memory->a.opening / length;
  pair->plastic[1] = memory->a.slip / length;
  pair->limit[0] = spring->cap / force;
  pair->limit[1] = pair->limit[2] = spring->cohesion / force;
  for (int i = 0; i < 2; i++)
    pair->y[i] = y[i];
  apply_strength (pair, pair->y, used);
  double opening = q[0] - pair->plastic[0] - pair->flexibility[0] * pair->y[0];
  for (int i = 0; i < pair->rows; i++) {
    double flow = i == 0 ? fmax (opening, 0) : 0;
    double surplus = fmax (pair->limit[i] - used[i], 0) - flow / size;
    pair->s[i] = positive_root (surplus, 1);
    pair->z[i] = size / pair->s[i];
  }
}

void
qn_central_pair_prepare (QnCentralPair *pair, const double q[2])
{
  double flow[2], used[QN_CENTRAL_ROWS], ratio[QN_CENTRAL_ROWS] = { 0 };

  qn_central_pair_flow (pair, pair->z, flow);
  apply_strength (pair, pair->y, used);
  for (int i = 0; i < pair->rows; i++) {
    pair->strength[i] = pair->limit[i] - used[i] - pair->s[i];
    pair->inverse_s[i] = 1 / pair->s[i];
    pair->inverse_z[i] = 1 / pair->z[i];
    ratio[i] = pair->z[i] * pair->inverse_s[i];
  }
  for (int i = 0; i < 2; i++)
    pair->strain[i] =
      q[i] - pair->plastic[i] - flow[i] - pair->flexibility[i] * pair->y[i];
  if (pair->rows < QN_CENTRAL_ROWS) { /* no shear at all */
    pair->strain[1] = 0;
    memset (pair->inverse, 0, sizeof pair->inverse);
    pair->inverse[0][0] = 1 / (pair->flexibility[0] + ratio[0]);
    return;
  }

  double sum = ratio[1] + ratio[2], difference = ratio[1] - ratio[2];
  double dilation = pair->dilatancy * pair->friction;
  double normal = pair->flexibility[0] + ratio[0];
  double nn = normal + dilation * sum, tt = pair->flexibility[1] + sum;
  double nt = pair->dilatancy * difference, tn = pair->friction * difference;
  /* nn tt - nt tn without the terms that cancel: sum^2 - difference^2 = 4 ratio ratio */
  double determinant =
    normal * tt + dilation * (sum * pair->flexibility[1] + 4 * ratio[1] * ratio[2]);
  double inverse = 1 / determinant;
  pair->inverse[0][0] = tt * inverse;
  pair->inverse[0][1] = -nt * inverse;
  pair->inverse[1][0] = -tn * inverse;
  pair->inverse[1][1] = nn * inverse;
}

/* dy = H \ (rate + free_strain) */
static void
change_of_force (const QnCentralPair *pair, const double rate[2], double dy[2])
{
  double strain[2] = { rate[0] + pair->free_strain[0], rate[1] + pair->free_strain[1] };

  for (int i = 0; i < 2; i++)
    dy[i] = pair->inverse[i][0] * strain[0] + pair->inverse[i][1] * strain[1];
}

/* dz = (product - s z - z ds) / s,  ds = strength - G dy: what of it does not depend on dy is
 * free. */
void
qn_central_pair_aim (QnCentralPair *pair, double dy[2])
{
  const double at_rest[2] = { 0 };
  double free_flow[QN_CENTRAL_ROWS] = { 0 }, flow[2];

  for (int i = 0; i < pair->rows; i++)
    free_flow[i] =
      (pair->product[i] - pair->z[i] * pair->strength[i]) * pair->inverse_s[i]
      - pair->z[i];
  qn_central_pair_flow (pair, free_flow, flow);
  for (int i = 0; i < 2; i++)
    pair->free_strain[i] = pair->strain[i] - flow[i];
  change_of_force (pair, at_rest, dy);
}

double
qn_central_pair_complete (const QnCentralPair *pair, const double rate[2],
                          QnCentralStep *step)
{
  double used[QN_CENTRAL_ROWS], fastest = 0;

  change_of_force (pair, rate, step->dy);
  apply_strength (pair, step->dy, used);
  for (int i = 0; i < pair->rows; i++) {
    step->ds[i] = pair->strength[i] - used[i];
    step->dz[i] =
      (pair->product[i] - pair->z[i] * step->ds[i]) * pair->inverse_s[i] - pair->z[i];
    fastest = qn_larger (-step->ds[i] * pair->inverse_s[i], fastest);
    fastest = qn_larger (-step->dz[i] * pair->inverse_z[i], fastest);
  }
  return fastest;
}
