/* The ties: are their forces those of their ends, and within their strength? */
#include "core/check/check-parts.h"

#include <math.h>

/* Rounding of displacements as force in a tie, and what forces of joints may be off by. */
static double
tolerance_of (const QnCheck *check, const QnAssembledBeam *tie)
{
  return QN_CHECK_FORCES * check->scale
         + QN_CHECK_EXACT * check->largest * tie->properties.axial;
}

/* A tie has yielded between two steps: what is plastic then follows from its force. */
static bool
take_stretch (const QnAssembledBeam *tie, double force, double tolerance,
              QnBeamResponse *response)
{
  const QnBeamProperties *p = &tie->properties;
  double stretch = tie->kinematics.deformation[0] - p->rest - force / p->axial;

  if (force <= 0) /* hanging slack, it may have been longer still */
    stretch = fmax (stretch, response->memory.stretch);
  if (force < 0 || force > qn_tie_strength (p->tie) + tolerance
      || stretch < response->memory.stretch - tolerance / p->axial)
    return false;
  response->memory.stretch = stretch;
  response->force[0] = force;
  return true;
}

void
qn_check_ties (QnCheck *check, size_t step)
{
  const QnResult *result = check->result;
  const QnModel *model = check->model;
  QnBeamAssembly *members = &check->assembly.beams;
  bool rigid = result->limit.given, last = step + 1 == result->step_count;
  const QnTieResult *stated =
    result->tie_count == model->tie_count ? qn_result_step_ties (result, step) : NULL;

  if (model->tie_count == 0 || (rigid && !last))
    return;
  if (stated == NULL)
    qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, QN_NONE, NAN, NAN);
  for (size_t i = 0; stated != NULL && i < model->tie_count; i++) {
    const QnTie *tie = &model->ties[i];
    const size_t member = model->element_count + i;
    const QnAssembledBeam *at = &members->beams[member];
    QnBeamResponse *response = &members->responses[member];
    double tolerance = tolerance_of (check, at), force = stated[i].force;
    double elongation = at->kinematics.deformation[0];
    bool suits = true;

    if (rigid)
      suits = force >= -tolerance && force <= qn_tie_strength (tie) + tolerance;
    else if (!qn_check_agrees (force, response->force[0], tolerance))
      suits = (check->relaxed || result->history.width > 0)
              && take_stretch (at, force, tolerance, response);
    if (!suits)
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i, force,
                     response->force[0]);
    if (!qn_check_agrees (stated[i].elongation, rigid ? 0 : elongation,
                          4 * QN_CHECK_EXACT * (check->largest + fabs (elongation))))
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i,
                     stated[i].elongation, elongation);
    if (stated[i].state != qn_tie_state (tie, force, 0)
        && stated[i].state != qn_tie_state (tie, force, tolerance))
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i, force,
                     NAN);
    if (rigid) /* for the balance */
      response->force[0] = force;
  }
}

void
qn_check_tie_rates (QnCheck *check, double none, double little)
{
  const QnBeamAssembly *members = &check->assembly.beams;
  const size_t elements = check->model->element_count;

  for (size_t i = 0; i < check->model->tie_count; i++) {
    const QnBeamResponse *response = &members->responses[elements + i];
    const QnAssembledBeam *at = &members->beams[elements + i];
    double rate = qn_beam_assembly_tie_rate (members, i, check->velocity);
    double force = response->force[0];
    bool hangs =
      !check->result->limit.given
      && at->kinematics.deformation[0] < at->properties.rest + response->memory.stretch;
    bool flows = fabs (rate) <= none || hangs || (rate < 0 && force <= little)
                 || (rate > 0 && force >= qn_tie_strength (at->properties.tie) - little);
    if (!flows)
      qn_check_tell (check, QN_CLAIM_FLOW, (QnId) check->result->step_count - 1,
                     QN_ENTITY_TIE, (QnId) i, rate, 0);
  }
}

double
qn_check_tie_dissipation (const QnCheck *check)
{
  const QnBeamAssembly *members = &check->assembly.beams;
  const size_t elements = check->model->element_count;
  double sum = 0;

  for (size_t i = 0; i < check->model->tie_count; i++) {
    double rate = qn_beam_assembly_tie_rate (members, i, check->velocity);
    double strength = qn_tie_strength (&check->model->ties[i]);
    double force = members->responses[elements + i].force[0];
    /* What nothing limits does not give: what rounding leaves counts as in joints. */
    sum += fmax (rate, 0) * (isfinite (strength) ? strength : force);
  }
  return sum;
}
