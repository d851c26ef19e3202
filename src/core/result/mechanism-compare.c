#include "core/result/mechanism.h"

#include <math.h>

static double
product (const QnModel *model, const double *a, const double *b, bool by_weight)
{
  double sum = 0.0;

  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    const double *u = a + i * QN_DOF_COUNT, *v = b + i * QN_DOF_COUNT;
    double mass = by_weight ? block->weight : block->area;
    double inertia = mass * block->polar_moment / block->area;
    sum += mass * (u[QN_DOF_UX] * v[QN_DOF_UX] + u[QN_DOF_UY] * v[QN_DOF_UY])
           + inertia * u[QN_DOF_RZ] * v[QN_DOF_RZ];
  }
  return sum;
}

double
qn_mechanism_cosine (const QnModel *model, const double *a, const double *b)
{
  bool by_weight = false;
  double norm;

  for (size_t i = 0; i < model->block_count; i++)
    by_weight |= model->blocks[i].weight > 0.0;
  norm =
    sqrt (product (model, a, a, by_weight)) * sqrt (product (model, b, b, by_weight));
  return norm > 0.0 ? fmax (-1.0, fmin (1.0, product (model, a, b, by_weight) / norm))
                    : 0.0;
}

int32_t
qn_mechanism_cluster (const QnModel *model, const double *const *fields, int32_t count,
                      double threshold, int32_t *groups)
{
  int32_t clusters = 0;

  for (int32_t i = 0; i < count; i++) {
    groups[i] = -1;
    for (int32_t j = 0, first = 0; j < i && groups[i] < 0; j++) {
      if (groups[j] != first) /* not the first of its cluster */
        continue;
      first++;
      if (qn_mechanism_cosine (model, fields[i], fields[j]) >= threshold)
        groups[i] = groups[j];
    }
    if (groups[i] < 0)
      groups[i] = clusters++;
  }
  return clusters;
}
