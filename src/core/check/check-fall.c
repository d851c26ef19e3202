/* A result without any equilibrium: what falls under the dead load, and what carries any load. */
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/limit/limit.h"

#include <math.h>
#include <string.h>

/* Rounding of speeds. */
#define NEARLY 1e-9

/* How fast a block moves: as limit analysis measures it, which names all that move, and as a path does,
 * which names those that fall and not what they drag along. */
static double
speed_of (const QnCheck *check, size_t block, bool rigid)
{
  const double *v = check->result->mechanism + QN_DOF_COUNT * block;
  double shift = hypot (v[QN_DOF_UX], v[QN_DOF_UY]);
  double turn = fabs (v[QN_DOF_RZ]) * check->model->characteristic_length;

  return rigid ? hypot (shift, turn) : fmax (shift, turn);
}

/* The blocks named are those that move by this part of the fastest, the fastest first. */
static bool
names_movers (const QnCheck *check, bool rigid, double part)
{
  const QnResult *r = check->result;
  double last = INFINITY, fastest = 0;
  size_t fast = 0;

  for (size_t b = 0; b < r->block_count; b++)
    fastest = fmax (fastest, speed_of (check, b, rigid));
  for (size_t b = 0; b < r->block_count; b++)
    fast += speed_of (check, b, rigid) > part * fastest * (1 + NEARLY);
  for (size_t i = 0; i < r->unstable_count; i++) {
    double speed = speed_of (check, (size_t) r->unstable_blocks[i], rigid);
    if (speed > last * (1 + NEARLY) || speed < part * fastest * (1 - NEARLY))
      return false;
    for (size_t k = 0; k < i; k++)
      if (r->unstable_blocks[k] == r->unstable_blocks[i])
        return false;
    last = speed;
  }
  return r->unstable_count >= fast;
}

/* Power of the dead load on the mechanism. */
static double
falling_power (QnCheck *check)
{
  QnAssembly *as = &check->assembly;
  const double none[QN_MAX_LOAD_SETS] = { 0 };
  double power = 0;

  qn_assembly_set_loads (as, none, none);
  memset (check->u, 0, (size_t) as->unknown_count * sizeof *check->u);
  qn_check_gather (as, check->result->mechanism, check->velocity);
  qn_assembly_update_kinematics (as, check->u);
  for (int32_t i = 0; i < as->unknown_count; i++)
    power += as->dead[i] * check->velocity[i];
  return power;
}

static void
check_movers (QnCheck *check)
{
  const QnResult *r = check->result;

  if (r->mechanism == NULL)
    return;
  if (!names_movers (check, true, QN_UNSTABLE_RIGID)
      && !names_movers (check, false, QN_UNSTABLE_SHARE))
    qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
  double power = falling_power (check);
  qn_check_bodies (check);
  /* Relaxation has seen blocks fall at some time, whichever way they move at last. */
  if (check->model->analysis.procedure == QN_PROCEDURE_LIMIT && !(power > 0))
    qn_check_tell_model (check, QN_CLAIM_WORK, QN_NONE, power, 0);
}

/* Limit analysis again: with associative flow it is what the result says; joints with less dilatancy may
 * stand less. */
static QnStatus
check_rigid (QnCheck *check, QnDiag *diag)
{
  const QnModel *model = check->model;
  QnOutcome told = check->result->outcome;
  QnLimitSolution solution;
  QnStatus status =
    qn_limit_associative (model, check->contacts, NULL, NULL, &solution, NULL);

  if (status != QN_OK)
    return status == QN_ERROR_NO_MEMORY ? qn_diag_no_memory (diag) : QN_OK;
  bool may_fall = told == QN_OUTCOME_DEAD_LOAD_UNSTABLE
                  && model->analysis.flow == QN_FLOW_NON_ASSOCIATIVE;
  if (solution.outcome != told && !may_fall)
    qn_check_tell_model (check, QN_CLAIM_OUTCOME, QN_NONE, NAN, NAN);
  qn_limit_solution_clear (&solution);
  return QN_OK;
}

QnStatus
qn_check_fall (QnCheck *check, QnDiag *diag)
{
  const QnResult *r = check->result;
  bool falls = r->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;

  if (r->step_count > 0)
    return QN_OK;
  if (falls)
    check_movers (check);
  return (falls || r->outcome == QN_OUTCOME_UNBOUNDED)
             && check->model->analysis.procedure == QN_PROCEDURE_LIMIT
             && check->depth == QN_CHECK_RECOMPUTED
           ? check_rigid (check, diag)
           : QN_OK;
}
