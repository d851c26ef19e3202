#include "core/check/result-check.h"

#include "core/assembly/assembly.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/check/check-parts.h"

#include <math.h>

void
qn_check_tell (QnCheck *check, QnClaim claim, QnId step, QnEntity entity, QnId index,
               double stated, double found)
{
  QnResultFaults *faults = check->faults;

  for (int i = 0; i < faults->count; i++)
    if (faults->items[i].claim == claim)
      return;
  faults->items[faults->count++] = (QnFault){ claim, step, entity, index, stated, found };
}

void
qn_check_tell_model (QnCheck *check, QnClaim claim, QnId step, double stated,
                     double found)
{
  qn_check_tell (check, claim, step, QN_ENTITY_MODEL, QN_NONE, stated, found);
}

void
qn_check_rows (QnCheck *check, QnClaim claim, QnId step, const double *stated,
               size_t bodies, double tolerance)
{
  for (size_t i = 0; i < bodies * QN_DOF_COUNT; i++) {
    size_t body = i / QN_DOF_COUNT, blocks = check->model->block_count;
    bool is_block = body < blocks;
    if (!qn_check_agrees (stated[i], check->rows[i], tolerance))
      qn_check_tell (check, claim, step, is_block ? QN_ENTITY_BLOCK : QN_ENTITY_NODE,
                     (QnId) (is_block ? body : body - blocks), stated[i], check->rows[i]);
  }
}

void
qn_check_tell_pair (QnCheck *check, QnClaim claim, size_t step, size_t pair,
                    double stated, double found)
{
  size_t drawn = check->contacts->pair_count;
  bool is_drawn = pair < drawn;

  qn_check_tell (
    check, claim, (QnId) step, is_drawn ? QN_ENTITY_CONTACT : QN_ENTITY_BLOCK,
    is_drawn ? (QnId) pair : check->result->found[pair - drawn].contact.other, stated,
    found);
}

/* The comparison is false for NaN. */
bool
qn_check_agrees (double stated, double found, double tolerance)
{
  return fabs (stated - found) <= tolerance;
}

static QnStatus
check_step (QnCheck *check, size_t step, QnDiag *diag)
{
  QnAssembly *as = &check->assembly;
  const QnResult *result = check->result;
  const double nothing[QN_MAX_LOAD_SETS] = { 0 };
  bool in_time = result->history.width > 0;
  double factors[QN_MAX_LOAD_SETS];

  qn_result_load_factors (check->model, result, step, factors);
  qn_assembly_set_loads (as, factors, nothing);
  qn_assembly_collect (as, qn_result_step_displacements (result, step), check->u);
  qn_check_found_take (check, step);
  check->largest = qn_largest (check->u, (size_t) check->assembly.unknown_count);
  if (!qn_assembly_evaluate (as, check->u))
    qn_check_tell_model (check, QN_CLAIM_FORCES, (QnId) step, NAN, NAN);
  qn_check_forces (check, step);
  QnStatus status = qn_check_modes (check, step, diag);
  if (status == QN_OK && in_time)
    status = qn_check_motion (check, step, diag);
  if (status == QN_OK && check->follows)
    status = qn_check_found_missing (check, step, diag);
  if (step == 0)
    qn_beam_assembly_tension (as);
  qn_assembly_commit (as);
  return status;
}

static bool
init (QnCheck *check, QnDiag *diag)
{
  const QnModel *model = check->model;
  size_t bodies = qn_model_body_count (model);
  QnPool *pool = &check->pool;

  if (!qn_check_found_init (check, diag)
      || qn_assembly_setup (&check->assembly, model,
                            check->all.pairs != NULL ? &check->all : check->contacts,
                            diag)
           != QN_OK)
    return false;
  size_t pairs = check->assembly.pair_count;
  size_t unknowns = (size_t) check->assembly.unknown_count;
  check->u = qn_pool_alloc (pool, unknowns, sizeof *check->u);
  check->residual = qn_pool_alloc (pool, unknowns, sizeof *check->residual);
  check->rows = qn_pool_alloc (pool, bodies * QN_DOF_COUNT, sizeof *check->rows);
  check->live = qn_pool_alloc (pool, bodies * QN_DOF_COUNT, sizeof *check->live);
  check->rates = qn_pool_alloc (pool, 2 * pairs, sizeof *check->rates);
  check->stated = qn_pool_alloc (pool, pairs, sizeof *check->stated);
  check->begins = qn_pool_alloc (pool, pairs, sizeof *check->begins);
  check->beam_forces =
    qn_pool_alloc (pool, model->element_count, sizeof *check->beam_forces);
  check->elongations = qn_pool_alloc (pool, 2 * pairs, sizeof *check->elongations);
  check->velocity = qn_pool_alloc (pool, unknowns, sizeof *check->velocity);
  check->unknown = qn_pool_alloc (pool, pairs, sizeof *check->unknown);
  return !pool->failed;
}

QnStatus
qn_result_find_faults (const QnModel *model, const QnContacts *contacts,
                       const QnResult *result, QnCheckDepth depth, QnResultFaults *faults,
                       QnDiag *diag)
{
  QnCheck check = { .model = model,
                    .contacts = contacts,
                    .result = result,
                    .depth = depth,
                    .faults = faults,
                    .tolerance = fmax (QN_CHECK_TOLERANCE,
                                       10 * model->analysis.residual_tolerance) };
  QnStatus status = QN_OK;

  *faults =
    (QnResultFaults){ .in_time = result->history.width > 0,
                      .forces_unknown = result->step_count > 1 && result->pair_count > 0
                                        && !qn_result_has_forces (result, 0),
                      .last = { .multiplier = NAN, .pair = QN_NONE, .index = QN_NONE } };
  if (!init (&check, diag))
    status = qn_diag_no_memory (diag);
  for (size_t i = 0; status == QN_OK && i < result->step_count; i++)
    status = check_step (&check, i, diag);
  if (status == QN_OK) {
    status = qn_check_course (&check, diag);
    qn_check_mechanism (&check);
    qn_check_history (&check);
    if (status == QN_OK)
      status = qn_check_bounds (&check, diag);
  }
  if (faults->in_time)
    faults->last.multiplier = NAN;
  qn_inertia_free (check.inertia);
  qn_assembly_clear (&check.assembly);
  qn_check_found_clear (&check);
  qn_pool_clear (&check.pool);
  return status;
}
