/* Norms of vectors of unknowns that do not depend on the orientation of the axes. */
#include "core/assembly/assembly.h"

#include "core/base/numbers.h"

#include <math.h>

/* A joint or tie holds a body if its force exceeds this part of the body's dead load. */
#define HOLDS 0.01

/* v of one degree of freedom of a body, less `base` and times `weights` unless these are NULL; 0 where
 * it is fixed. */
static double
entry (const QnAssembly *as, size_t body, QnDof dof, const double *v, const double *base,
       const double *weights)
{
  int32_t i = as->unknown[QN_DOF_COUNT * body + (size_t) dof];

  if (i == QN_NONE)
    return 0;
  return (weights != NULL ? weights[i] : 1) * (base != NULL ? v[i] - base[i] : v[i]);
}

/* The square of a body's translation, or of its rotation where that is larger. */
static double
size_squared (const QnAssembly *as, size_t body, const double *v, const double *base,
              const double *weights)
{
  double x = entry (as, body, QN_DOF_UX, v, base, weights);
  double y = entry (as, body, QN_DOF_UY, v, base, weights);
  double turn = entry (as, body, QN_DOF_RZ, v, base, weights);

  return qn_worse (x * x + y * y, turn * turn);
}

static double
largest_of_bodies (const QnAssembly *as, const double *v, const double *base,
                   const double *weights)
{
  size_t bodies = qn_model_body_count (as->model);
  double largest = 0;

  for (size_t body = 0; body < bodies; body++)
    largest = qn_worse (largest, size_squared (as, body, v, base, weights));
  return sqrt (largest);
}

double
qn_assembly_largest (const QnAssembly *as, const double *v, const double *base)
{
  return largest_of_bodies (as, v, base, NULL);
}

double
qn_assembly_largest_loose (QnAssembly *as, const double *v, const double *base)
{
  const QnBeamAssembly *members = &as->beams;
  bool *loose = as->loose;
  bool found = true;
  double largest = 0;

  /* Bodies with a support, and those at the ends of beams, are held; `loose` is every other one. */
  const QnModel *model = as->model;
  for (size_t body = 0; body < qn_model_body_count (model); body++) {
    const int32_t *unknowns = as->unknown + QN_DOF_COUNT * body;
    loose[body] = true;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      if (unknowns[dof] == QN_NONE || as->settles[unknowns[dof]])
        loose[body] = false;
  }
  for (size_t e = 0; e < model->element_count; e++)
    for (int end = 0; end < 2; end++)
      loose[qn_model_node_body (model, model->elements[e].nodes[end])] = false;
  while (found) {
    found = false;
    for (size_t p = 0; p < as->pair_count; p++) {
      const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[p].face];
      const double *force = as->responses[p].force;
      size_t next = (size_t) (loose[face->a] ? face->a : face->b);
      double load = sqrt (size_squared (as, next, as->dead, NULL, NULL));
      if (loose[face->a] == loose[face->b] || hypot (force[0], force[1]) <= HOLDS * load)
        continue;
      loose[face->a] = loose[face->b] = false;
      found = true;
    }
    for (size_t m = as->model->element_count; m < members->count; m++) { /* ties */
      const size_t *ends = members->beams[m].bodies;
      bool first = ends[0] != QN_GROUND && loose[ends[0]];
      bool second = ends[1] != QN_GROUND && loose[ends[1]];
      if (first == second)
        continue;
      size_t next = first ? ends[0] : ends[1];
      double load = sqrt (size_squared (as, next, as->dead, NULL, NULL));
      if (members->responses[m].force[0] <= HOLDS * load)
        continue;
      loose[next] = false;
      found = true;
    }
  }
  for (size_t body = 0; body < qn_model_body_count (as->model); body++)
    if (loose[body])
      largest = fmax (largest, size_squared (as, body, v, base, NULL));
  return sqrt (largest);
}

double
qn_assembly_total (const QnAssembly *as, const double *v)
{
  size_t bodies = qn_model_body_count (as->model);
  double sum = 0;

  for (size_t body = 0; body < bodies; body++)
    sum += sqrt (size_squared (as, body, v, NULL, NULL));
  return sum;
}

double
qn_assembly_elastic_displacements (const QnAssembly *as, const double *v,
                                   const double *base)
{
  double largest = largest_of_bodies (as, v, base, as->damping);

  return as->force_scale > 0 ? as->softness * largest / as->force_scale : 0;
}
