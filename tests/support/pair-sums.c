#include "support/pair-sums.h"

#include <math.h>

double
test_add_pair_forces (const QnModel *model, const QnContacts *contacts,
                      const double *forces, double *sum)
{
  double largest = 0;

  for (size_t p = 0; p < contacts->pair_count; p++) {
    const QnContactPair *pair = &contacts->pairs[p];
    const QnContactFace *face = &contacts->faces[pair->face];
    QnVec2 force = qn_vec2_add (qn_vec2_scale (forces[2 * p], face->normal),
                                qn_vec2_scale (forces[2 * p + 1], face->tangent));
    const QnId blocks[2] = { face->a, face->b };
    largest = fmax (largest, qn_vec2_length (force));
    for (int side = 0; side < 2; side++) {
      double *on = sum + (size_t) blocks[side] * QN_DOF_COUNT, sign = side == 0 ? 1 : -1;
      QnVec2 arm = qn_vec2_sub (pair->point, model->blocks[blocks[side]].centroid);
      on[QN_DOF_UX] += sign * force.x;
      on[QN_DOF_UY] += sign * force.y;
      on[QN_DOF_RZ] += sign * qn_vec2_cross (arm, force); /* r x F */
    }
  }
  return largest;
}

QnVec2
test_pair_rate (const QnModel *model, const QnContacts *contacts, size_t pair,
                const double *velocities)
{
  const QnContactPair *p = &contacts->pairs[pair];
  const QnContactFace *face = &contacts->faces[p->face];
  const QnId blocks[2] = { face->a, face->b };
  QnVec2 rate = { 0, 0 };

  for (int side = 0; side < 2; side++) {
    const double *v = velocities + (size_t) blocks[side] * QN_DOF_COUNT;
    QnVec2 arm = qn_vec2_sub (p->point, model->blocks[blocks[side]].centroid);
    QnVec2 at = { v[QN_DOF_UX] - v[QN_DOF_RZ] * arm.y,
                  v[QN_DOF_UY] + v[QN_DOF_RZ] * arm.x };
    rate = qn_vec2_add_scaled (rate, side == 0 ? -1 : 1, at);
  }
  return qn_vec2 (qn_vec2_dot (rate, face->normal), qn_vec2_dot (rate, face->tangent));
}
