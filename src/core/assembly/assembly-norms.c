/* How large vectors of unknowns are, whichever way the structure is turned. */
#include "core/assembly/assembly.h"

#include <math.h>

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

  return fmax (x * x + y * y, turn * turn);
}

static double
largest_of_bodies (const QnAssembly *as, const double *v, const double *base,
                   const double *weights)
{
  size_t bodies = qn_model_body_count (as->model);
  double largest = 0;

  for (size_t body = 0; body < bodies; body++)
    largest = fmax (largest, size_squared (as, body, v, base, weights));
  return sqrt (largest);
}

double
qn_assembly_largest (const QnAssembly *as, const double *v, const double *base)
{
  return largest_of_bodies (as, v, base, NULL);
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
