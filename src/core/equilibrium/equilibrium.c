#include "core/equilibrium/equilibrium.h"

#include "core/base/memory.h"

#include <string.h>

void
qn_equilibrium_state_init (QnEquilibriumState *state, const QnAssembly *as, QnPool *pool)
{
  state->u = qn_pool_alloc (pool, (size_t) as->unknown_count, sizeof *state->u);
  state->memory = qn_pool_alloc (pool, as->pair_count, sizeof *state->memory);
  state->responses = qn_pool_alloc (pool, as->pair_count, sizeof *state->responses);
  qn_beam_state_init (&state->beams, as, pool);
}

double
qn_equilibrium_live_work (const QnEquilibrium *eq, const double *from)
{
  double work = 0;

  for (int32_t i = 0; i < eq->assembly.unknown_count; i++)
    work += eq->assembly.live[i] * (eq->u[i] - from[i]);
  return work;
}

void
qn_equilibrium_save (const QnEquilibrium *eq, QnEquilibriumState *state)
{
  const QnAssembly *as = &eq->assembly;

  memcpy (state->u, eq->u, (size_t) as->unknown_count * sizeof *eq->u);
  state->multiplier = eq->multiplier;
  state->out_of_balance = eq->out_of_balance;
  memcpy (state->memory, as->committed, as->pair_count * sizeof *as->committed);
  memcpy (state->responses, as->responses, as->pair_count * sizeof *as->responses);
  qn_beam_state_save (&state->beams, as);
}

void
qn_equilibrium_set_state (QnEquilibrium *eq, const QnEquilibriumState *state)
{
  QnAssembly *as = &eq->assembly;

  memcpy (eq->u, state->u, (size_t) as->unknown_count * sizeof *eq->u);
  eq->multiplier = state->multiplier;
  eq->out_of_balance = state->out_of_balance;
  memcpy (as->committed, state->memory, as->pair_count * sizeof *as->committed);
  memcpy (as->responses, state->responses, as->pair_count * sizeof *as->responses);
  qn_beam_state_set (&state->beams, as);
  qn_assembly_update_kinematics (as, eq->u);
}

void
qn_equilibrium_commit (QnEquilibrium *eq)
{
  qn_assembly_commit (&eq->assembly);
  qn_equilibrium_save (eq, &eq->committed);
}

void
qn_equilibrium_record (QnEquilibrium *eq)
{
  qn_equilibrium_commit (eq);
  qn_equilibrium_save (eq, &eq->recorded);
}

void
qn_equilibrium_restore (QnEquilibrium *eq)
{
  qn_equilibrium_set_state (eq, &eq->committed);
}

/* The linear system, and all that has the size of the assembly's pairs. False when memory runs out. */
static bool
allocate_for_pairs (QnEquilibrium *eq)
{
  const QnAssembly *as = &eq->assembly;
  QnPool *pool = &eq->pair_pool;

  eq->linsys =
    qn_linsys_new (as->unknown_count, as->ap, as->ai, as->model->analysis.workers);
  eq->factored_pairs = qn_pool_alloc (pool, as->pair_count, sizeof *eq->factored_pairs);
  eq->gaps = qn_pool_alloc (pool, as->pair_count + as->beams.count, sizeof *eq->gaps);
  qn_equilibrium_state_init (&eq->committed, as, pool);
  qn_equilibrium_state_init (&eq->recorded, as, pool);
  qn_equilibrium_state_init (&eq->anchor, as, pool);
  return eq->linsys != NULL && !pool->failed;
}

static void
free_for_pairs (QnEquilibrium *eq)
{
  qn_linsys_free (eq->linsys);
  qn_pool_clear (&eq->pair_pool);
  qn_assembly_clear (&eq->assembly);
}

QnStatus
qn_equilibrium_setup (QnEquilibrium *eq, const QnModel *model, const QnContacts *contacts,
                      QnProgressFunc report, void *report_data, QnDiag *diag)
{
  *eq = (QnEquilibrium){ .report = report,
                         .report_data = report_data,
                         .runaway = QN_RUNAWAY,
                         .tolerance = model->analysis.residual_tolerance };

  QnStatus status = qn_assembly_setup (&eq->assembly, model, contacts, diag);
  if (status != QN_OK)
    return status;

  double **vectors[] = { &eq->u,     &eq->residual,  &eq->step,
                         &eq->trial, &eq->live_step, &eq->motion };
  for (size_t i = 0; i < QN_N_ELEMENTS (vectors); i++)
    *vectors[i] =
      qn_pool_alloc (&eq->pool, (size_t) eq->assembly.unknown_count, sizeof (double));
  if (!allocate_for_pairs (eq) || eq->pool.failed) {
    qn_equilibrium_clear (eq);
    return qn_diag_no_memory (diag);
  }
  qn_assembly_evaluate (&eq->assembly, eq->u);
  qn_equilibrium_save (eq, &eq->committed);
  qn_equilibrium_save (eq, &eq->recorded);
  return QN_OK;
}

void
qn_equilibrium_renew (QnEquilibrium *eq)
{
  QnAssembly *as = &eq->assembly;

  qn_assembly_update_kinematics (as, eq->u);
  qn_beam_assembly_evaluate (as);
  for (size_t p = 0; p < as->pair_count; p++)
    if (!as->inactive[p] && as->responses[p].state == QN_PAIR_OPEN)
      qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                        &as->responses[p]);
  qn_equilibrium_record (eq);
  eq->factored = false;
}

QnStatus
qn_equilibrium_exchange (QnEquilibrium *eq, QnAssembly *assembly, QnDiag *diag)
{
  QnEquilibrium next = *eq;

  next.assembly = *assembly;
  next.pair_pool = (QnPool){ 0 };
  if (!allocate_for_pairs (&next)) {
    free_for_pairs (&next);
    return qn_diag_no_memory (diag);
  }
  qn_beam_state_save (&next.committed.beams, &eq->assembly);
  qn_beam_state_set (&next.committed.beams, &next.assembly);
  free_for_pairs (eq);
  *eq = next;
  eq->factored = false;
  return QN_OK;
}

void
qn_equilibrium_clear (QnEquilibrium *eq)
{
  free_for_pairs (eq);
  qn_pool_clear (&eq->pool);
  *eq = (QnEquilibrium){ 0 };
}
