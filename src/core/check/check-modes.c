/* Modes of vibration, and where stability is lost. */
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/check/mode-proof.h"

#include <math.h>

static QnStatus
check_vibration (QnCheck *check, size_t step, QnDiag *diag)
{
  const QnVibration *stated = &check->result->vibration;
  double square = stated->omega * stated->omega;
  QnModeProof proof;
  int32_t below = 0, up_to = 0;
  QnStatus status =
    qn_mode_proof_init (&proof, &check->assembly, 0, stated->sliding, NULL);

  if (status == QN_ERROR_NO_MEMORY
      || (status == QN_OK && !qn_mode_proof_count (&proof, square, &below, &up_to)))
    status = qn_diag_no_memory (diag);
  else if (status != QN_OK) { /* without mass nothing vibrates */
    qn_check_tell_model (check, QN_CLAIM_MODE, (QnId) step, stated->omega, NAN);
    status = QN_OK;
  } else if (!(stated->omega >= 0) || stated->mode <= below || stated->mode > up_to)
    qn_check_tell_model (check, QN_CLAIM_MODE, (QnId) step, stated->mode, below + 1);
  else if (!(qn_mode_proof_residual (&proof, square, check->velocity)
             <= QN_MODE_RESIDUAL))
    qn_check_tell_model (check, QN_CLAIM_MODE, (QnId) step, stated->omega, NAN);
  qn_mode_proof_clear (&proof);
  return status;
}

/* x'Kx of the mechanism. */
static double
find_stiffness (const QnCheck *check)
{
  const QnAssembly *as = &check->assembly;

  qn_assembly_multiply (as, as->ax, check->velocity, check->residual);
  return qn_dot (check->residual, check->velocity, (size_t) as->unknown_count);
}

/* Every step is stable; where stability is lost, beyond the last one there is next to no stiffness left
 * against the mode. */
static QnStatus
check_stability (QnCheck *check, size_t step, QnDiag *diag)
{
  QnAssembly *as = &check->assembly;
  const QnResult *result = check->result;
  double at = result->steps[step].multiplier, lost = result->first_limit_multiplier;
  QnInertiaCount count = { 0 };

  qn_assembly_tangent_at_rest (as, 0);
  if (check->inertia == NULL)
    check->inertia = qn_inertia_new (as->unknown_count, as->ap, as->ai);
  if (check->inertia == NULL || !qn_inertia_count (check->inertia, as->ax, &count))
    return qn_diag_no_memory (diag);
  bool is_last = step + 1 == result->step_count;
  bool ends = is_last && result->stability == QN_STABILITY_LOST;
  if (count.negative + count.zero > 0 && !(ends && step == 0))
    qn_check_tell_model (check, QN_CLAIM_STABILITY, (QnId) step, NAN, NAN);
  if (step == 0 && result->mechanism != NULL)
    check->stiffness_at_rest = find_stiffness (check);
  if (!ends)
    return QN_OK;
  double tolerance =
    QN_CHECK_STRAIN * check->model->analysis.multiplier_tolerance * fabs (lost);
  if (!(lost >= at && lost - at <= tolerance))
    qn_check_tell_model (check, QN_CLAIM_FIRST_LIMIT, (QnId) step, lost, at);
  if (result->mechanism == NULL)
    qn_check_tell_model (check, QN_CLAIM_MODE, (QnId) step, NAN, NAN);
  else if (step > 0 && !result->mechanism_uncertain) {
    double stiffness = find_stiffness (check);
    if (!(stiffness <= QN_CHECK_LITTLE * check->stiffness_at_rest))
      qn_check_tell_model (check, QN_CLAIM_MODE, (QnId) step,
                           stiffness / check->stiffness_at_rest, 0);
  }
  return QN_OK;
}

QnStatus
qn_check_modes (QnCheck *check, size_t step, QnDiag *diag)
{
  const QnResult *result = check->result;
  QnStatus status = QN_OK;

  if (result->stability == QN_STABILITY_UNKNOWN && result->vibration.mode == 0)
    return QN_OK;
  if (result->mechanism != NULL)
    qn_assembly_collect (&check->assembly, result->mechanism, check->velocity);
  if (result->stability != QN_STABILITY_UNKNOWN)
    status = check_stability (check, step, diag);
  if (status == QN_OK && result->vibration.mode > 0 && result->mechanism != NULL
      && step + 1 == result->step_count)
    status = check_vibration (check, step, diag);
  return status;
}
