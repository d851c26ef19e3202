#include "core/modal/modal.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/check/mode-proof.h"
#include "core/linalg/lanczos.h"
#include "core/path/analysis.h"
#include "core/path/path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Shift of the inverse iteration, as a part of the largest stiffness over mass: small enough to
 * cost no digits, large enough to make K of a free structure regular. */
#define SHIFT 1e-7

/* A sum below this part of that of its absolute values is rounding. */
#define ROUNDING 1e-12

typedef struct {
  QnEquilibrium *equilibrium;
  QnAssembly *assembly;
  QnLinsys *linsys;
  int32_t n;
  QnModeProof proof; /* with K and M, rotations scaled by the characteristic length */
  double shift;      /* sigma < 0 */
  size_t found;
  double *values, *vectors; /* omega squared; columns of n */
} Pencil;

/* ax = K - sigma M, factorised; ax is K before. */
static QnStatus
factorize (Pencil *pencil, QnDiag *diag)
{
  QnAssembly *as = pencil->assembly;

  if (!qn_assembly_is_symmetric (as))
    return qn_refuse (diag, QN_PROBLEM_STATE_SLIPS, QN_ENTITY_MODEL, QN_NONE);
  pencil->shift = -SHIFT * pencil->proof.largest;
  for (int32_t k = 0; k < as->ap[pencil->n]; k++)
    as->ax[k] -= pencil->shift * pencil->proof.mass[k];

  QnSolveStatus solved = qn_linsys_factor (pencil->linsys, as->ax);
  if (solved == QN_SOLVE_FAILED)
    return qn_refuse (diag, QN_PROBLEM_STATE_SINGULAR, QN_ENTITY_MODEL, QN_NONE);
  return solved == QN_SOLVE_CONVERGED ? QN_OK : qn_diag_no_memory (diag);
}

/* y = M x */
static void
multiply (void *data, const double *x, double *y)
{
  const Pencil *pencil = data;
  qn_assembly_multiply (pencil->assembly, pencil->proof.mass, x, y);
}

static void
solve_shifted (void *data, double *b)
{
  const Pencil *pencil = data;
  qn_linsys_solve (pencil->linsys, b);
}

static bool
go_on_modes (void *data)
{
  const Pencil *pencil = data;
  return qn_equilibrium_go_on (pencil->equilibrium);
}

/* Modes scaled to a largest displacement of 1; the vectors have a modal mass of 1. */
static QnStatus
take_modes (const Pencil *pencil, const double *u, QnModes *modes, QnDiag *diag)
{
  const QnAssembly *as = pencil->assembly;
  size_t bodies = qn_model_body_count (as->model), row = bodies * QN_DOF_COUNT,
         n = (size_t) pencil->n;
  double *moved[] = { pencil->proof.product, pencil->proof.shifted }; /* M r in x and y */

  for (int i = 0; i < 2; i++) {
    memset (moved[i], 0, n * sizeof *moved[i]);
    qn_assembly_add_inertia (as, qn_vec2 (i == 0, i == 1), moved[i]);
  }
  modes->omega = qn_alloc (pencil->found, sizeof *modes->omega);
  modes->shapes = qn_alloc (pencil->found * row, sizeof *modes->shapes);
  modes->masses = qn_alloc (pencil->found, 3 * sizeof *modes->masses);
  if (modes->omega == NULL || modes->shapes == NULL || modes->masses == NULL)
    return qn_diag_no_memory (diag);
  modes->count = pencil->found;
  modes->block_count = as->model->block_count;
  modes->node_count = as->model->node_count;

  for (size_t mode = 0; mode < pencil->found; mode++) {
    double square = pencil->values[mode], largest = 0;
    double *shape = modes->shapes + mode * row;
    modes->omega[mode] =
      square > QN_MODE_ZERO * pencil->proof.largest ? sqrt (square) : 0;
    const double *vector = pencil->vectors + mode * n;
    qn_assembly_expand_rates (as, u, vector, shape);
    for (size_t b = 0; b < bodies; b++)
      largest = fmax (largest, hypot (shape[3 * b], shape[3 * b + 1]));
    for (size_t i = 0; largest > 0 && i < row; i++)
      shape[i] /= largest;
    modes->masses[3 * mode] = largest > 0 ? 1 / (largest * largest) : 0;
    for (int i = 0; i < 2; i++) {
      double share = 0, size = 0;
      for (size_t k = 0; k < n; k++) {
        share += vector[k] * moved[i][k];
        size += fabs (vector[k] * moved[i][k]);
      }
      modes->masses[3 * mode + 1 + i] =
        fabs (share) > ROUNDING * size ? share * share : 0;
    }
  }
  return QN_OK;
}

/* These are modes, orthonormal, of a stable state, and there is none below the last that is not among
 * them. */
static QnStatus
prove_modes (Pencil *pencil, QnDiag *diag)
{
  QnModeProof *proof = &pencil->proof;
  int32_t negative = 0, below = 0, up_to;
  double worst = 0;
  QnStatus status = QN_OK;

  if (!qn_mode_proof_count (proof, 0, &negative, &up_to)
      || !qn_mode_proof_count (proof, pencil->values[pencil->found - 1], &below, &up_to))
    return qn_diag_no_memory (diag);
  if (negative > 0)
    status = qn_refuse (diag, QN_PROBLEM_STATE_UNSTABLE, QN_ENTITY_MODEL, QN_NONE);
  for (size_t i = 0; status == QN_OK && i < pencil->found; i++)
    worst =
      qn_worse (worst, qn_mode_proof_residual (proof, pencil->values[i],
                                               pencil->vectors + i * (size_t) pencil->n));
  if (status == QN_OK)
    worst =
      qn_worse (worst, qn_mode_proof_skewness (proof, pencil->found, pencil->vectors));
  if (status == QN_OK && !(below < (int32_t) pencil->found && worst <= QN_MODE_RESIDUAL))
    status = qn_diag_set (diag, QN_ERROR_INTERNAL, QN_PROBLEM_MODES_NOT_FOUND);
  return status;
}

/* The `wanted` lowest modes, or as many as there are; none where it was cancelled. */
static QnStatus
find_modes (QnEquilibrium *eq, size_t wanted, bool sliding, QnModes *modes, QnDiag *diag)
{
  Pencil pencil = { .equilibrium = eq,
                    .assembly = &eq->assembly,
                    .linsys = eq->linsys,
                    .n = eq->assembly.unknown_count };
  size_t n = (size_t) pencil.n, most = wanted < n ? wanted : n;
  QnStatus status = QN_OK;

  if (n == 0)
    return qn_refuse (diag, QN_PROBLEM_TOO_FEW_UNKNOWNS, QN_ENTITY_MODEL, QN_NONE);
  pencil.values = qn_alloc (most, sizeof *pencil.values);
  pencil.vectors = qn_alloc (n, most * sizeof *pencil.vectors);
  if (pencil.values == NULL || pencil.vectors == NULL)
    status = qn_diag_no_memory (diag);
  if (status == QN_OK)
    status =
      qn_mode_proof_init (&pencil.proof, pencil.assembly, eq->multiplier, sliding, diag);
  if (status == QN_OK)
    status = factorize (&pencil, diag);
  if (status == QN_OK) {
    const QnLanczosProblem problem = { .n = pencil.n,
                                       .shift = pencil.shift,
                                       .multiply = multiply,
                                       .solve = solve_shifted,
                                       .go_on = go_on_modes,
                                       .data = &pencil };
    QnSolveStatus solved =
      qn_lanczos_run (&problem, most, &pencil.found, pencil.values, pencil.vectors);
    if (solved == QN_SOLVE_FAILED)
      status = qn_diag_set (diag, QN_ERROR_INTERNAL, QN_PROBLEM_MODES_NOT_FOUND);
    else if (solved == QN_SOLVE_NO_MEMORY)
      status = qn_diag_no_memory (diag);
  }
  if (status == QN_OK && pencil.found > 0)
    status = prove_modes (&pencil, diag);
  if (status == QN_OK && pencil.found > 0)
    status = take_modes (&pencil, eq->u, modes, diag);
  if (status == QN_OK && !sliding) {
    /* What is left out, and what counts as stiffer than it is. */
    const QnAssembly *as = pencil.assembly;
    for (size_t p = 0; p < as->pair_count; p++) {
      const double *tangent = pencil.proof.tangents + 4 * p;
      bool open = tangent[0] == 0 && tangent[3] == 0;
      modes->open += open;
      modes->slides += !open && as->responses[p].state == QN_PAIR_SLIP;
    }
  }
  qn_mode_proof_clear (&pencil.proof);
  free (pencil.values);
  free (pencil.vectors);
  return status;
}

QnStatus
qn_modal_run (const QnModel *model, const QnContacts *contacts, QnModalState state,
              size_t wanted, QnProgressFunc progress, void *user_data, QnModes *modes,
              QnResult *result, QnDiag *diag)
{
  QnBudget budget = qn_budget_start (model, progress, user_data);
  bool loaded = (state & QN_MODAL_LOADED) != 0, sliding = (state & QN_MODAL_SLIDING) != 0;
  QnPath path;
  bool reached = false;

  *modes = (QnModes){ 0 };
  *result = (QnResult){ 0 };
  if (loaded && model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_diag_set_field (diag, QN_PROBLEM_LIMIT_WITHOUT_STATE, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  if (loaded && model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return qn_diag_set_field (diag, QN_PROBLEM_TIME_WITHOUT_STATE, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  QnStatus status =
    qn_path_setup (&path, model, contacts, qn_budget_go_on, &budget, result, diag);
  result->vibration.dead_load = !loaded;
  result->vibration.sliding = sliding;
  if (status == QN_OK && loaded) {
    status = qn_path_run (&path, &reached, diag);
    qn_equilibrium_restore (&path.equilibrium);
  } else if (status == QN_OK) {
    result->outcome = QN_OUTCOME_TARGET_REACHED;
    status = qn_path_apply_dead_load (&path, &reached, diag);
  }
  if (status == QN_OK && reached && !path.equilibrium.cancelled)
    status = find_modes (&path.equilibrium, wanted, sliding, modes, diag);
  if (path.equilibrium.cancelled)
    result->outcome = QN_OUTCOME_CANCELLED;
  status = qn_path_finish (&path, status, budget.start);
  status = qn_budget_conclude (&budget, status, contacts, result, diag);
  if (status != QN_OK || result->stop == QN_STOP_CHECK)
    qn_modes_clear (modes);
  return status;
}

QnModesDamping
qn_modes_damping (const QnModes *modes, double ratio)
{
  QnModesDamping damping = { .last = modes->count - 1 };
  while (damping.first < damping.last && modes->omega[damping.first] == 0)
    damping.first++;
  double low = modes->omega[damping.first], high = modes->omega[damping.last];
  damping.stiffness = low + high > 0 ? 2 * ratio / (low + high) : 0;
  damping.mass = damping.stiffness * low * high;
  return damping;
}

size_t
qn_modes_main (const QnModes *modes)
{
  size_t main = modes->count;
  double most = 0;
  for (size_t i = 0; i < modes->count; i++)
    if (modes->omega[i] > 0 && modes->masses[3 * i + 1] > most) {
      main = i;
      most = modes->masses[3 * i + 1];
    }
  return main;
}

QnStatus
qn_modes_show (const QnModes *modes, size_t mode, const QnModel *model, QnResult *result,
               QnDiag *diag)
{
  size_t row = (modes->block_count + modes->node_count) * QN_DOF_COUNT;

  result->vibration.mode = (int32_t) mode + 1;
  result->vibration.omega = modes->omega[mode];
  return qn_result_set_mechanism (result, modes->shapes + mode * row,
                                  model->characteristic_length, diag);
}

void
qn_modes_clear (QnModes *modes)
{
  free (modes->omega);
  free (modes->shapes);
  free (modes->masses);
  *modes = (QnModes){ 0 };
}
