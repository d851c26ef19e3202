#include "core/result/result-contact.h"

#include <math.h>

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

bool
qn_result_found_exist (const QnResult *result, const QnModel *model)
{
  bool exist = true;

  for (size_t i = 0; exist && i < result->found_count; i++) {
    const QnFoundContact *c = &result->found[i].contact;
    exist = c->block >= 0 && (size_t) c->block < model->block_count && c->other >= 0
            && (size_t) c->other < model->block_count && c->side >= 0
            && c->side < model->blocks[c->block].vertex_count && c->corner >= 0
            && c->corner < model->blocks[c->other].vertex_count;
  }
  for (size_t i = 0; exist && i < result->found_force_count; i++)
    exist = result->found_forces[i].found >= 0
            && (size_t) result->found_forces[i].found < result->found_count
            && result->found_forces[i].step >= 0
            && (size_t) result->found_forces[i].step < result->step_count;
  return exist;
}

const QnFoundForce *
qn_step_found (const QnResult *result, size_t step, size_t *count)
{
  const QnFoundForce *forces = result->found_forces;
  size_t first = 0, end = result->found_force_count, after;
  while (first < end) {
    size_t middle = first + (end - first) / 2;
    if ((size_t) forces[middle].step < step)
      first = middle + 1;
    else
      end = middle;
  }
  for (after = first;
       after < result->found_force_count && (size_t) forces[after].step == step; after++)
    continue;
  *count = after - first;
  return forces + first;
}

QnVec2
qn_found_corner (const QnModel *model, const QnFoundContact *contact)
{
  return qn_model_block_vertices (model, contact->other)[contact->corner];
}

/* Vertices go round counter-clockwise: outwards is to the right of a side. */
QnVec2
qn_found_normal (const QnModel *model, const QnFoundContact *contact)
{
  const QnVec2 *v = qn_model_block_vertices (model, contact->block);
  QnId next = (contact->side + 1) % model->blocks[contact->block].vertex_count;
  QnVec2 side = qn_vec2_sub (v[next], v[contact->side]);
  return qn_vec2_scale (1 / qn_vec2_length (side), qn_vec2 (side.y, -side.x));
}

QnVec2
qn_found_force (const QnModel *model, const QnFoundContact *contact,
                const QnFoundForce *force, const double *displacements)
{
  QnVec2 normal = qn_found_normal (model, contact);
  QnVec2 sum = qn_vec2_add (qn_vec2_scale (force->normal, normal),
                            qn_vec2_scale (force->shear, qn_vec2_perp (normal)));
  if (displacements == NULL)
    return sum;
  double turn =
    displacements[(size_t) contact->block * QN_DOF_COUNT + (size_t) QN_DOF_RZ];
  return qn_vec2_rotate (sum, cos (turn), sin (turn));
}
