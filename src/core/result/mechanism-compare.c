#include "core/result/mechanism.h"

#include <math.h>

/* Bodies are the same where so much of their union belongs to both. */
#define SAME_BODY 0.9

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

/* Blocks that belong to body i of `a` and body j of `b`. */
static int32_t
shared_blocks (const QnMechanism *a, const QnMechanism *b, QnId i, QnId j)
{
  int32_t count = 0;

  for (size_t k = 0; k < a->block_count; k++)
    count += a->body_of_block[k] == i && b->body_of_block[k] == j;
  return count;
}

/* The body of `b` that most of the blocks of body i of `a` belong to is that of its first block
 * if the two are the same at all, up to a tenth: every block of the body is asked. */
static bool
has_counterpart (const QnMechanism *a, const QnMechanism *b, QnId i)
{
  QnId asked = QN_NONE;

  for (size_t k = 0; k < a->block_count; k++) {
    QnId j = b->body_of_block[k];
    int32_t shared;
    if (a->body_of_block[k] != i || j == QN_NONE || j == asked)
      continue;
    asked = j;
    shared = shared_blocks (a, b, i, j);
    if (shared
        >= SAME_BODY * (a->bodies[i].block_count + b->bodies[j].block_count - shared))
      return true;
  }
  return false;
}

double
qn_mechanism_common_bodies (const QnMechanism *a, const QnMechanism *b)
{
  size_t most = a->body_count > b->body_count ? a->body_count : b->body_count;
  int32_t common = 0;

  for (size_t i = 0; i < a->body_count; i++)
    common += has_counterpart (a, b, (QnId) i);
  return most > 0 ? (double) common / (double) most : 1.0;
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
