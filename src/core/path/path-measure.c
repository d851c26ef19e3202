#include "core/path/path-measure.h"

#include "core/base/numbers.h"
#include "core/base/tolerance.h"

#include <string.h>

/* Work or arc length, with a first step that moves the structure as far as an increment of the
 * multiplier would. */
static bool
take_motion (QnPathMeasure *measure, double increment)
{
  QnEquilibrium *eq = &measure->path->equilibrium;
  int32_t n = eq->assembly.unknown_count;
  const double *motion = eq->trial;
  QnSolveStatus status = qn_equilibrium_rate (eq, eq->trial);

  if (status == QN_SOLVE_NO_MEMORY)
    return false;
  double length =
    status == QN_SOLVE_CONVERGED ? sqrt (qn_dot (motion, motion, (size_t) n)) : 0;
  double rate_length = length;
  /* Blocks that nothing holds before there is a live load: as if equally stiff everywhere. */
  if (length == 0) {
    motion = eq->assembly.live;
    length = sqrt (qn_dot (motion, motion, (size_t) n));
    rate_length = length / eq->assembly.stiffness;
  }
  for (int32_t i = 0; i < n && length > 0; i++)
    measure->direction[i] = motion[i] / length;
  /* Joints that soften give way against a load that goes back; they close instead. */
  if (measure->procedure == QN_PROCEDURE_ARC_LENGTH && measure->unknown == QN_NONE
      && qn_dot (measure->direction, eq->assembly.live, (size_t) n) < 0)
    for (int32_t i = 0; i < n; i++)
      measure->direction[i] *= -1;
  double far =
    increment * rate_length
    * qn_assembly_elastic_displacements (&eq->assembly, measure->direction, NULL);
  if (far > QN_PATH_FARTHEST_FIRST)
    increment *= QN_PATH_FARTHEST_FIRST / far;
  double advance = rate_length; /* of the measure, per multiplier */
  if (measure->procedure == QN_PROCEDURE_WORK) {
    advance *= qn_dot (measure->direction, eq->assembly.live_at_rest, (size_t) n);
    memcpy (measure->direction, eq->assembly.live_at_rest, (size_t) n * sizeof (double));
  }
  measure->first = fabs (advance) * increment;
  measure->slope = advance != 0 ? 1 / advance : 0;
  return true;
}

bool
qn_path_measure_take_work (QnPathMeasure *measure, double increment)
{
  measure->procedure = QN_PROCEDURE_WORK;
  return take_motion (measure, increment);
}

bool
qn_path_measure_setup (QnPathMeasure *measure, QnPath *path)
{
  const QnAssembly *as = &path->equilibrium.assembly;
  const QnAnalysisSettings *settings = path->settings;
  size_t n = (size_t) as->unknown_count;
  QnPool *pool = &path->trace_pool;
  size_t body = qn_model_controlled_body (path->model, &settings->control);

  *measure = (QnPathMeasure){ .path = path,
                              .procedure = settings->procedure,
                              .unknown = QN_NONE,
                              .end = NAN,
                              .direction = qn_pool_alloc (pool, n, sizeof (double)),
                              .unit = qn_pool_alloc (pool, n, sizeof (double)),
                              .last_u = qn_pool_alloc (pool, n, sizeof (double)) };
  if (pool->failed)
    return false;
  qn_path_measure_keep_last (measure);
  if (body != SIZE_MAX && settings->procedure != QN_PROCEDURE_LOAD) {
    bool turns = settings->control.dof == QN_DOF_RZ;
    measure->unknown = as->unknown[QN_DOF_COUNT * body + (size_t) settings->control.dof];
    measure->end = settings->control.target * (turns ? as->length : 1);
    measure->unit[measure->unknown] = 1;
    if (path->stage > 0)
      measure->start = path->equilibrium.committed.u[measure->unknown];
  }
  double increment = 1.0 / settings->increments;
  if (measure->procedure == QN_PROCEDURE_LOAD)
    measure->first = increment;
  else if (measure->procedure == QN_PROCEDURE_DISPLACEMENT) {
    measure->direction[measure->unknown] = 1;
    measure->first = (measure->end - measure->start) * increment;
  } else
    return take_motion (measure, increment);
  return true;
}

void
qn_path_measure_keep_last (QnPathMeasure *measure)
{
  const QnEquilibrium *eq = &measure->path->equilibrium;

  memcpy (measure->last_u, eq->committed.u,
          (size_t) eq->assembly.unknown_count * sizeof *measure->last_u);
}

void
qn_path_measure_follow (QnPathMeasure *measure)
{
  const QnEquilibrium *eq = &measure->path->equilibrium;
  int32_t n = eq->assembly.unknown_count;
  double length = 0;

  if (measure->procedure != QN_PROCEDURE_ARC_LENGTH)
    return;
  for (int32_t i = 0; i < n; i++)
    length = hypot (length, eq->u[i] - measure->last_u[i]);
  for (int32_t i = 0; i < n && length > 0; i++)
    measure->direction[i] = (eq->u[i] - measure->last_u[i]) / length;
}

double
qn_path_measure_share_to_end (const QnPathMeasure *measure, double step)
{
  const QnEquilibrium *eq = &measure->path->equilibrium;

  if (measure->procedure != QN_PROCEDURE_DISPLACEMENT)
    return INFINITY;
  return (measure->end - eq->committed.u[measure->unknown]) / step;
}

bool
qn_path_measure_is_at_end (const QnPathMeasure *measure)
{
  const QnEquilibrium *eq = &measure->path->equilibrium;

  if (measure->unknown == QN_NONE)
    return false;
  return (eq->u[measure->unknown] - measure->start) / (measure->end - measure->start)
         >= 1 - QN_TOLERANCE_TARGET;
}
