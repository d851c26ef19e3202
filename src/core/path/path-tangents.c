#include "core/path/path-tangents.h"

#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>

bool
qn_path_tangents_init (QnPathTangents *tangents, QnEquilibrium *eq)
{
  size_t n = (size_t) eq->assembly.unknown_count;

  *tangents = (QnPathTangents){ .eq = eq,
                                .start = qn_alloc (n, sizeof *tangents->start),
                                .end = qn_alloc (n, sizeof *tangents->end) };
  return tangents->start != NULL && tangents->end != NULL;
}

void
qn_path_tangents_clear (QnPathTangents *tangents)
{
  free (tangents->start);
  free (tangents->end);
  *tangents = (QnPathTangents){ 0 };
}

static bool
take (QnPathTangents *tangents, double *rate, bool *known)
{
  QnSolveStatus status = qn_equilibrium_rate (tangents->eq, rate);

  *known = status == QN_SOLVE_CONVERGED;
  return status != QN_SOLVE_NO_MEMORY;
}

bool
qn_path_tangents_take_start (QnPathTangents *tangents)
{
  return take (tangents, tangents->start, &tangents->start_known);
}

bool
qn_path_tangents_take_end (QnPathTangents *tangents)
{
  return take (tangents, tangents->end, &tangents->end_known);
}

double
qn_path_tangents_unexplained (const QnPathTangents *tangents, double increment)
{
  const QnEquilibrium *eq = tangents->eq;
  double error = 0, size = 0;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++) {
    double explained = 0.5 * increment * (tangents->start[i] + tangents->end[i]);
    error = fmax (error, fabs (eq->u[i] - eq->committed.u[i] - explained));
    size = fmax (size, fabs (eq->u[i]));
  }
  return error > 0 ? error / size : 0;
}

void
qn_path_tangents_accept (QnPathTangents *tangents)
{
  double *end = tangents->end;

  tangents->end = tangents->start;
  tangents->start = end;
  tangents->start_known = tangents->end_known;
}
