#include "core/modal.h"

#include "core/clock.h"
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

#define MOST_RESTARTS 1000

typedef struct {
  QnAssembly *assembly;
  QnLinsys *linsys;
  int32_t n;
  double *mass; /* M in the pattern of K, rotations scaled by the characteristic length */
  double largest; /* of K_ii / M_ii */
  double shift;   /* sigma < 0 */
} Pencil;

/* M = masses of blocks, diagonal, and of beams, consistent. */
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
      pencil->mass[as->diagonal[unknown]] = i == QN_DOF_RZ ? mass * gyration : mass;
    }
  }
  for (size_t b = 0; b < model->beam_count; b++) {
    double mass =
      qn_section_weight (&model->sections[model->beams[b].section]) / model->gravity;
    if (!(mass > 0 && isfinite (mass)))
      return qn_diag_set_field (diag, QN_PROBLEM_BEAM_WITHOUT_MASS, QN_ENTITY_BEAM,
                                (QnId) b, NULL, mass);
  }
  qn_beam_assembly_add_mass (&as->beams, pencil->mass);
  for (int32_t j = 0; j < pencil->n; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++)
      if (as->settles[j] || as->settles[as->ai[k]])
        pencil->mass[k] = 0; /* supports that may settle do not move */
  return QN_OK;
}

/* ax = K - sigma M, factorised. */
static QnStatus
factorize (Pencil *pencil, double multiplier, QnDiag *diag)
{
  QnAssembly *as = pencil->assembly;

  qn_assembly_tangent_held (as, multiplier);
  if (!qn_assembly_is_symmetric (as))
    return qn_diag_set_field (diag, QN_PROBLEM_STATE_SLIPS, QN_ENTITY_MODEL, QN_NONE,
                              NULL, 0);

  for (int32_t i = 0; i < pencil->n; i++) {
    double mass = pencil->mass[as->diagonal[i]];
    if (mass > 0)
      pencil->largest = fmax (pencil->largest, as->ax[as->diagonal[i]] / mass);
  }
  pencil->shift = -SHIFT * pencil->largest;
  for (int32_t k = 0; k < as->ap[pencil->n]; k++)
    as->ax[k] -= pencil->shift * pencil->mass[k];

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

/* y = M x */
static void
multiply (const Pencil *pencil, const double *x, double *y)
{
  const QnAssembly *as = pencil->assembly;

  memset (y, 0, (size_t) pencil->n * sizeof *y);
  for (int32_t j = 0; j < pencil->n; j++)
    for (int32_t k = as->ap[j]; k < as->ap[j + 1]; k++)
      y[as->ai[k]] += pencil->mass[k] * x[j];
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

/* One product of ARPACK's: M x, or (K - sigma M) \\ (M x), where M x may be there already. */
static void
answer (const Pencil *pencil, Workspace *w, int ido, const int places[14])
{
  double *x = w->reverse + places[0] - 1, *y = w->reverse + places[1] - 1;

  if (ido == 1)
    memcpy (y, w->reverse + places[2] - 1, (size_t) pencil->n * sizeof *y);
  else
    multiply (pencil, x, y);
  if (ido != 2)
    qn_linsys_solve (pencil->linsys, y);
}

/* The frequencies' squares next above the shift, ascending, with their vectors, in the metric of
 * M of unit length, in w->vectors. */
static bool
iterate (const Pencil *pencil, Workspace *w)
{
  const int n = pencil->n, length = w->basis * (w->basis + 8);
  int parameters[11] = { 0 }, places[14] = { 0 }, ido = 0, info = 1;

  parameters[0] = 1;             /* exact shifts */
  parameters[2] = MOST_RESTARTS; /* iterations */
  parameters[6] = 3;             /* shift and invert, K phi = omega^2 M phi */
  /* A start of our own: equal input gives equal output. */
  for (int i = 0; i < n; i++)
    w->residual[i] = 1 + 0.5 * sin (1.7 * i);

  do {
    dsaupd_c (&ido, "G", n, "LM", w->wanted, 0, w->residual, w->basis, w->vectors, n,
              parameters, places, w->reverse, w->lanczos, length, &info);
    if (ido == 1 || ido == -1 || ido == 2)
      answer (pencil, w, ido, places);
  } while (ido == 1 || ido == -1 || ido == 2);
  if (info != 0)
    return false;
  dseupd_c (1, "A", w->chosen, w->values, w->vectors, n, pencil->shift, "G", n, "LM",
            w->wanted, 0, w->residual, w->basis, w->vectors, n, parameters, places,
            w->reverse, w->lanczos, length, &info);
  return info == 0;
}

/* Modes scaled to a largest displacement of 1. */
static QnStatus
take_modes (const Pencil *pencil, const Workspace *w, const double *u, QnModes *modes,
            QnDiag *diag)
{
  const QnAssembly *as = pencil->assembly;
  size_t bodies = qn_model_body_count (as->model), row = bodies * QN_DOF_COUNT;

  modes->omega = qn_alloc ((size_t) w->wanted, sizeof *modes->omega);
  modes->shapes = qn_alloc ((size_t) w->wanted * row, sizeof *modes->shapes);
  if (modes->omega == NULL || modes->shapes == NULL)
    return qn_diag_no_memory (diag);
  modes->count = (size_t) w->wanted;
  modes->block_count = as->model->block_count;
  modes->node_count = as->model->node_count;

  for (int mode = 0; mode < w->wanted; mode++) {
    double square = w->values[mode], largest = 0;
    double *shape = modes->shapes + (size_t) mode * row;
    modes->omega[mode] = square > ZERO * ZERO * pencil->largest ? sqrt (square) : 0;
    qn_assembly_expand_rates (as, u, w->vectors + (size_t) mode * (size_t) pencil->n,
                              shape);
    for (size_t b = 0; b < bodies; b++)
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
  pencil.mass = qn_alloc ((size_t) eq->assembly.ap[pencil.n], sizeof (double));
  if (pencil.mass == NULL
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
    status = take_modes (&pencil, &w, eq->u, modes, diag);
  workspace_clear (&w);
  free (pencil.mass);
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
  double start = qn_clock_seconds ();
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
    result->statistics.seconds = qn_clock_seconds () - start;
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
