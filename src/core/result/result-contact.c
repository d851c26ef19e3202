#include "core/result/result-contact.h"

const double *
qn_result_deformation (const QnModel *model, const QnResult *result)
{
  /* Limit analysis knows no displacements, whatever the settings of the path say. */
  if (model->analysis.geometry == QN_GEOMETRY_LINEAR || result->limit.given
      || result->step_count == 0)
    return NULL;
  return qn_result_step_displacements (result, result->step_count - 1);
}

void
qn_result_contact_place (const QnModel *model, const QnContacts *contacts, size_t pair,
                         const double *deformation, QnVec2 *point, QnVec2 *normal)
{
  const QnContactFace *face = &contacts->faces[contacts->pairs[pair].face];
  *point = contacts->pairs[pair].point;
  *normal = face->normal;
  if (deformation == NULL)
    return;

  QnVec2 a = qn_block_place (model, face->a, deformation, *point);
  QnVec2 b = qn_block_place (model, face->b, deformation, *point);
  double turn = 0.5
                * (deformation[(size_t) face->a * QN_DOF_COUNT + QN_DOF_RZ]
                   + deformation[(size_t) face->b * QN_DOF_COUNT + QN_DOF_RZ]);
  *point = qn_vec2_lerp (a, b, 0.5);
  *normal = qn_vec2_rotate (*normal, cos (turn), sin (turn));
}
