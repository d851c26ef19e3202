#include "core/modal.h"

#include "core/memory.h"
#include "core/path.h"

#include <arpack/arpack.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Shift of the inverse iteration, as a part of the largest stiffness over mass: small enough to
 * cost no digits, large enough to make K of a free structure regular. */
#define SHIFT 1e-7

/* Frequencies below this part of the highest that the diagonals allow are rounding. */
#define ZERO 1e-6

/* Entries of K that differ by more than this part of its largest make it unsymmetric. */
#define UNSYMMETRIC 1e-9

#define MOST_RESTARTS 1000

typedef struct {
  QnAssembly *assembly;
  QnLinsys *linsys;
  int32_t n;
  double *root_mass; /* sqrt (M), rotations scaled by the characteristic length; 0 for
                        supports that may settle, which do not move */
  double largest;    /* of K_ii / M_ii */
  double shift;      /* sigma < 0 */
} Pencil;

static QnStatus
fill_masses (Pencil *pencil, QnDiag *diag)
{
  const QnAssembly *as = pencil->assembly;
  const QnModel *model = as->model;

  for (size_t b = 0; b < model->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    double mass = block->weight / model->gravity;
    double gyration = block->polar_moment / block->area / (as->length * as->length);
    for (int i = 0; i < QN_DOF_COUNT; i++) {
      int32_t unknown = as->unknown[QN_DOF_COUNT * b + i];
      if (unknown == QN_NONE || as->settles[unknown])
        continue;
      if (!(mass > 0 && isfinite (mass)))
        return qn_diag_set_field (diag, QN_PROBLEM_BLOCK_WITHOUT_MASS, QN_ENTITY_BLOCK,
                                  (QnId) b, NULL, mass);
      pencil->root_mass[unknown] = sqrt (i == QN_DOF_RZ ? mass * gyration : mass);
    }
  }
  return QN_OK;
}

/* ax = K - sigma M, factorised. */
static QnStatus
factorize (Pencil *pencil, double multiplier, QnDiag *diag)
{
  QnAssembly *as = pencil->assembly;
  double largest = 0, skew = 0;

  qn_assembly_tangent_held (as, multiplier);
  for (int32_t j = 0; j < pencil->n; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++) {
      int32_t i = as->ai[k], low = as->ap[i];
      while (as->ai[low] != j)
        low++;
      largest = fmax (largest, fabs (as->ax[k]));
      skew = fmax (skew, fabs (as->ax[k] - as->ax[low]));
    }
  if (skew > UNSYMMETRIC * largest)
    return qn_diag_set_field (diag, QN_PROBLEM_STATE_SLIPS, QN_ENTITY_MODEL, QN_NONE,
                              NULL, 0);

  for (int32_t i = 0; i < pencil->n; i++) {
    double mass = pencil->root_mass[i] * pencil->root_mass[i];
    if (mass > 0)
      pencil->largest = fmax (pencil->largest, as->ax[as->diagonal[i]] / mass);
  }
  pencil->shift = -SHIFT * pencil->largest;
  for (int32_t i = 0; i < pencil->n; i++)
    as->ax[as->diagonal[i]] -=
      pencil->shift * pencil->root_mass[i] * pencil->root_mass[i];

  switch (qn_linsys_factor (pencil->linsys, as->ax)) {
  case QN_FACTOR_OK:
    return QN_OK;
  case QN_FACTOR_SINGULAR:
    return qn_diag_set_field (diag, QN_PROBLEM_STATE_SINGULAR, QN_ENTITY_MODEL, QN_NONE,
                              NULL, 0);
  case QN_FACTOR_NO_MEMORY:
    break;
  }
  return qn_diag_no_memory (diag);
}

/* y = sqrt(M) (K - sigma M) \ (sqrt(M) x) */
static void
apply (const Pencil *pencil, const double *x, double *y)
{
  for (int32_t i = 0; i < pencil->n; i++)
    y[i] = pencil->root_mass[i] * x[i];
  qn_linsys_solve (pencil->linsys, y);
  for (int32_t i = 0; i < pencil->n; i++)
    y[i] *= pencil->root_mass[i];
}

/* Work space of ARPACK for `wanted` of n eigenvalues with a basis of `basis` vectors. */
typedef struct {
  int wanted, basis;
  double *residual, *vectors, *reverse, *lanczos, *values;
  int *chosen;
} Workspace;

static bool
workspace_init (Workspace *w, int n, int wanted)
{
  int basis = 2 * wanted + 20 < n ? 2 * wanted + 20 : n;
  size_t size = (size_t) n, m = (size_t) basis;

  *w = (Workspace){ .wanted = wanted, .basis = basis };
  w->residual = qn_alloc (size, sizeof (double));
  w->vectors = qn_alloc (size * m, sizeof (double));
  w->reverse = qn_alloc (3 * size, sizeof (double));
  w->lanczos = qn_alloc (m * (m + 8), sizeof (double));
  w->values = qn_alloc (m, sizeof (double));
  w->chosen = qn_alloc (m, sizeof (int));
  return w->residual && w->vectors && w->reverse && w->lanczos && w->values && w->chosen;
}

static void
workspace_clear (Workspace *w)
{
  free (w->residual);
  free (w->vectors);
  free (w->reverse);
  free (w->lanczos);
  free (w->values);
  free (w->chosen);
}

/* The largest eigenvalues of the operator, ascending, with their vectors in w->vectors. */
static bool
iterate (const Pencil *pencil, Workspace *w)
{
  const int n = pencil->n, length = w->basis * (w->basis + 8);
  int parameters[11] = { 0 }, places[14] = { 0 }, ido = 0, info = 1;

  parameters[0] = 1;             /* exact shifts */
  parameters[2] = MOST_RESTARTS; /* iterations */
  parameters[6] = 1;             /* y = OP x */
  /* A start of our own: equal input gives equal output. */
  for (int i = 0; i < n; i++)
    w->residual[i] = 1 + 0.5 * sin (1.7 * i);

  do {
    dsaupd_c (&ido, "I", n, "LM", w->wanted, 0, w->residual, w->basis, w->vectors, n,
              parameters, places, w->reverse, w->lanczos, length, &info);
    if (ido == 1 || ido == -1)
      apply (pencil, w->reverse + places[0] - 1, w->reverse + places[1] - 1);
  } while (ido == 1 || ido == -1);
  if (info != 0)
    return false;
  dseupd_c (1, "A", w->chosen, w->values, w->vectors, n, 0, "I", n, "LM", w->wanted, 0,
            w->residual, w->basis, w->vectors, n, parameters, places, w->reverse,
            w->lanczos, length, &info);
  return info == 0;
}

/* phi = M^-1/2 x, scaled to a largest displacement of 1. */
static QnStatus
take_modes (const Pencil *pencil, const Workspace *w, double *scratch, QnModes *modes,
            QnDiag *diag)
{
  const QnAssembly *as = pencil->assembly;
  size_t row = as->model->block_count * QN_DOF_COUNT;

  modes->omega = qn_alloc ((size_t) w->wanted, sizeof *modes->omega);
  modes->shapes = qn_alloc ((size_t) w->wanted * row, sizeof *modes->shapes);
  if (modes->omega == NULL || modes->shapes == NULL)
    return qn_diag_no_memory (diag);
  modes->count = (size_t) w->wanted;
  modes->block_count = as->model->block_count;

  for (int mode = 0; mode < w->wanted; mode++) {
    int from = w->wanted - 1 - mode; /* the largest first: the lowest frequency */
    double square = 1 / w->values[from] + pencil->shift, largest = 0;
    double *shape = modes->shapes + (size_t) mode * row;
    modes->omega[mode] = square > ZERO * ZERO * pencil->largest ? sqrt (square) : 0;
    for (int32_t i = 0; i < pencil->n; i++)
      scratch[i] = pencil->root_mass[i] > 0
                     ? w->vectors[(size_t) from * (size_t) pencil->n + (size_t) i]
                         / pencil->root_mass[i]
                     : 0;
    qn_assembly_expand (as, scratch, shape);
    for (size_t b = 0; b < modes->block_count; b++)
      largest = fmax (largest, hypot (shape[3 * b], shape[3 * b + 1]));
    for (size_t i = 0; largest > 0 && i < row; i++)
      shape[i] /= largest;
  }
  return QN_OK;
}

static QnStatus
solve_pencil (QnEquilibrium *eq, size_t wanted, QnModes *modes, QnDiag *diag)
{
  Pencil pencil = { .assembly = &eq->assembly,
                    .linsys = eq->linsys,
                    .n = eq->assembly.unknown_count };
  Workspace w = { 0 };
  size_t most = pencil.n > 1 ? (size_t) pencil.n - 1 : 0;
  QnStatus status = QN_OK;

  if (most == 0)
    return qn_diag_set_field (diag, QN_PROBLEM_TOO_FEW_UNKNOWNS, QN_ENTITY_MODEL, QN_NONE,
                              NULL, 0);
  pencil.root_mass = qn_alloc ((size_t) pencil.n, sizeof (double));
  if (pencil.root_mass == NULL
      || !workspace_init (&w, pencil.n, (int) (wanted < most ? wanted : most)))
    status = qn_diag_no_memory (diag);
  if (status == QN_OK)
    status = fill_masses (&pencil, diag);
  if (status == QN_OK)
    status = factorize (&pencil, eq->multiplier, diag);
  if (status == QN_OK && !iterate (&pencil, &w))
    status = qn_diag_set (diag, QN_ERROR_INTERNAL, QN_PROBLEM_MODES_NOT_FOUND,
                          QN_ENTITY_MODEL, QN_NONE, QN_NONE);
  if (status == QN_OK)
    status = take_modes (&pencil, &w, eq->step, modes, diag);
  workspace_clear (&w);
  free (pencil.root_mass);
  return status;
}

/* Brings the solver to the state; *reached is false where there is no equilibrium. */
static QnStatus
reach_state (QnPath *path, QnModalState state, bool *reached, QnDiag *diag)
{
  if (state == QN_MODAL_LOADED) {
    QnStatus status = qn_path_run (path, reached, diag);
    qn_equilibrium_restore (&path->equilibrium);
    return status;
  }
  path->result->outcome = QN_OUTCOME_TARGET_REACHED;
  return qn_path_apply_dead_load (path, reached, diag);
}

QnStatus
qn_modal_run (const QnModel *model, const QnContacts *contacts, QnModalState state,
              size_t wanted, QnProgressFunc progress, void *user_data, QnModes *modes,
              QnResult *result, QnDiag *diag)
{
  QnPath path;
  bool reached = false;

  *modes = (QnModes){ 0 };
  *result = (QnResult){ 0 };
  if (state == QN_MODAL_LOADED && model->analysis.procedure == QN_PROCEDURE_LIMIT)
    return qn_diag_set_field (diag, QN_PROBLEM_LIMIT_WITHOUT_STATE, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  QnStatus status =
    qn_path_setup (&path, model, contacts, progress, user_data, result, diag);
  if (status == QN_OK)
    status = reach_state (&path, state, &reached, diag);
  if (status == QN_OK && reached)
    status = solve_pencil (&path.equilibrium, wanted, modes, diag);
  if (status == QN_OK) {
    qn_assembly_pair_results (&path.equilibrium.assembly, path.equilibrium.u,
                              result->pairs);
    result->statistics = path.equilibrium.statistics;
  } else {
    qn_modes_clear (modes);
    qn_result_clear (result);
  }
  qn_path_clear (&path);
  return status;
}

void
qn_modes_clear (QnModes *modes)
{
  free (modes->omega);
  free (modes->shapes);
  *modes = (QnModes){ 0 };
}
