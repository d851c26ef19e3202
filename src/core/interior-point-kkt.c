#include "core/interior-point-kkt.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Entries of the lower half of a 6 x 6 matrix. */
#define GROUP_ENTRIES (QN_IP_GROUP_ROWS * (QN_IP_GROUP_ROWS + 1) / 2)

/* A direction need not be more exact than this: the next iteration sees what is left. */
#define REFINEMENT_TARGET 1e-10
#define MOST_REFINEMENTS  4

static void
ignore_message (int status, const char *file, int line, const char *message)
{
  (void) status;
  (void) file;
  (void) line;
  (void) message;
}

void
qn_ip_add_forces (const QnIpProblem *problem, const double *y, double scale, double *out)
{
  for (int32_t g = 0; g < problem->group_count; g++) {
    const QnIpGroup *group = &problem->groups[g];
    double sum[QN_IP_GROUP_ROWS] = { 0 };

    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const QnIpCell *cell = &problem->cells[c];
      for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
        sum[i] += cell->map[i][0] * y[2 * c] + cell->map[i][1] * y[2 * c + 1];
    }
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      if (group->rows[i] >= 0)
        out[group->rows[i]] += scale * sum[i];
  }
}

void
qn_ip_add_rates (const QnIpProblem *problem, const double *v, double scale, double *out)
{
  for (int32_t g = 0; g < problem->group_count; g++) {
    const QnIpGroup *group = &problem->groups[g];
    double local[QN_IP_GROUP_ROWS];

    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      local[i] = group->rows[i] >= 0 ? v[group->rows[i]] : 0.0;
    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const QnIpCell *cell = &problem->cells[c];
      double normal = 0.0, shear = 0.0;
      for (int i = 0; i < QN_IP_GROUP_ROWS; i++) {
        normal += cell->map[i][0] * local[i];
        shear += cell->map[i][1] * local[i];
      }
      out[2 * c] += scale * normal;
      if (!cell->no_shear)
        out[2 * c + 1] += scale * shear;
    }
  }
}

static int
compare_keys (const void *a, const void *b)
{
  int64_t x = *(const int64_t *) a, y = *(const int64_t *) b;
  return (x > y) - (x < y);
}

/* Key of the entry of M that rows r and s share, column by column, rows ascending. */
static int64_t
entry_key (int32_t r, int32_t s, int32_t row_count)
{
  return r > s ? (int64_t) s * row_count + r : (int64_t) r * row_count + s;
}

/* All entries of M in storage order, without duplicates. */
static int64_t *
list_entries (const QnIpProblem *p, size_t *count)
{
  size_t most = (size_t) p->group_count * GROUP_ENTRIES + (size_t) p->row_count;
  int64_t *keys = qn_alloc (most, sizeof *keys);
  size_t n = 0, unique = 0;

  if (!keys)
    return NULL;
  for (int32_t r = 0; r < p->row_count; r++)
    keys[n++] = entry_key (r, r, p->row_count);
  for (int32_t g = 0; g < p->group_count; g++) {
    const int32_t *rows = p->groups[g].rows;
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < i; j++)
        if (rows[i] >= 0 && rows[j] >= 0)
          keys[n++] = entry_key (rows[i], rows[j], p->row_count);
  }
  qsort (keys, n, sizeof *keys, compare_keys);
  for (size_t i = 0; i < n; i++)
    if (unique == 0 || keys[i] != keys[unique - 1])
      keys[unique++] = keys[i];
  *count = unique;
  return keys;
}

static int32_t
find_entry (const int64_t *keys, size_t count, int64_t key)
{
  const int64_t *found = bsearch (&key, keys, count, sizeof *keys, compare_keys);
  return (int32_t) (found - keys);
}

static void
fill_pattern (QnIpKkt *kkt, const int64_t *keys, size_t count)
{
  const QnIpProblem *p = kkt->problem;
  int *columns = kkt->matrix->p, *rows = kkt->matrix->i;

  for (size_t e = 0; e < count; e++) {
    rows[e] = (int) (keys[e] % p->row_count);
    columns[keys[e] / p->row_count + 1] = (int) e + 1;
  }
  columns[0] = 0;
  for (int32_t r = 0; r < p->row_count; r++)
    kkt->diagonal[r] = columns[r];
  for (int32_t g = 0; g < p->group_count; g++) {
    const int32_t *at = p->groups[g].rows;
    int32_t *slots = kkt->slots + (size_t) g * GROUP_ENTRIES;
    for (int i = 0, e = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j <= i; j++, e++)
        slots[e] = at[i] < 0 || at[j] < 0
                     ? -1
                     : find_entry (keys, count, entry_key (at[i], at[j], p->row_count));
  }
}

static QnStatus
analyze (QnIpKkt *kkt, QnDiag *diag)
{
  const QnIpProblem *p = kkt->problem;
  cholmod_common *c = &kkt->common;
  size_t count;
  int64_t *keys = list_entries (p, &count);

  if (!keys)
    return qn_diag_no_memory (diag);
  kkt->matrix = cholmod_allocate_sparse ((size_t) p->row_count, (size_t) p->row_count,
                                         count, 1, 1, -1, CHOLMOD_REAL, c);
  kkt->right = cholmod_zeros ((size_t) p->row_count, 1, CHOLMOD_REAL, c);
  if (kkt->matrix && kkt->right) {
    fill_pattern (kkt, keys, count);
    kkt->factor = cholmod_analyze (kkt->matrix, c);
  }
  free (keys);
  return kkt->factor ? QN_OK : qn_diag_no_memory (diag);
}

QnStatus
qn_ip_kkt_init (QnIpKkt *kkt, const QnIpProblem *problem, QnDiag *diag)
{
  size_t cells = (size_t) problem->cell_count, rows = (size_t) problem->row_count;

  *kkt = (QnIpKkt){ .problem = problem };
  cholmod_start (&kkt->common);
  kkt->started = true;
  kkt->common.print = 0;
  kkt->common.error_handler = ignore_message;
  /* Measured on a wall of 1,800 blocks with the reference BLAS: AMD's ordering wins over
   * nested dissection, and the simplicial factorisation over the supernodal one. */
  kkt->common.nmethods = 1;
  kkt->common.method[0].ordering = CHOLMOD_AMD;
  kkt->common.supernodal = CHOLMOD_SIMPLICIAL;
  kkt->common.quick_return_if_not_posdef = 1;

  kkt->slots = qn_alloc ((size_t) problem->group_count * GROUP_ENTRIES, sizeof (int32_t));
  kkt->diagonal = qn_alloc (rows, sizeof (int32_t));
  kkt->stiffness = qn_alloc (3 * cells, sizeof (double));
  kkt->compliance = qn_alloc (3 * cells, sizeof (double));
  kkt->residual_y = qn_alloc (2 * cells, sizeof (double));
  kkt->step_y = qn_alloc (2 * cells, sizeof (double));
  kkt->residual_v = qn_alloc (rows, sizeof (double));
  kkt->rates = qn_alloc (2 * cells, sizeof (double));
  kkt->local = qn_alloc (rows, sizeof (double));
  kkt->border = qn_alloc (rows, sizeof (double));
  kkt->step_v = qn_alloc (rows, sizeof (double));
  if (!kkt->slots || !kkt->diagonal || !kkt->stiffness || !kkt->compliance
      || !kkt->residual_y || !kkt->step_y || !kkt->residual_v || !kkt->rates
      || !kkt->local || !kkt->border || !kkt->step_v)
    return qn_diag_no_memory (diag);
  return analyze (kkt, diag);
}

/* H of a cell and its inverse, both sums of terms of one sign on their diagonals: the
 * determinant by Cauchy and Binet, det = sum_{i<j} w_i w_j (g_i x g_j)^2, and the adjugate by
 * turning each row, adj H = sum_i w_i g_i^ g_i^'. Nothing cancels, however different the
 * weights; Q and the regularisation count as rows along the axes. */
static void
invert_cell (const QnIpProblem *p, const QnIpCell *cell, const double *w,
             double regularization, double *stiffness, double *compliance)
{
  double axis_n = cell->quadratic[0] + regularization;
  double axis_t = cell->quadratic[1] + regularization;
  double nn = axis_n, nt = 0.0, tt = axis_t, determinant = axis_n * axis_t;
  const QnIpBound *bounds = p->bounds + cell->first_bound;

  w += cell->first_bound;
  for (int32_t i = 0; i < cell->bound_count; i++) {
    const QnIpBound *b = &bounds[i];
    nn += w[i] * b->normal * b->normal;
    nt += w[i] * b->normal * b->shear;
    tt += w[i] * b->shear * b->shear;
    determinant += w[i] * (b->normal * b->normal * axis_t + b->shear * b->shear * axis_n);
    for (int32_t j = 0; j < i; j++) {
      double cross = b->normal * bounds[j].shear - b->shear * bounds[j].normal;
      determinant += w[i] * w[j] * cross * cross;
    }
  }
  stiffness[0] = nn;
  stiffness[1] = cell->no_shear ? 0.0 : nt;
  stiffness[2] = cell->no_shear ? 0.0 : tt;
  compliance[0] = cell->no_shear ? 1.0 / nn : tt / determinant;
  compliance[1] = cell->no_shear ? 0.0 : -nt / determinant;
  compliance[2] = cell->no_shear ? 0.0 : nn / determinant;
}

static void
scatter_group (QnIpKkt *kkt, int32_t g)
{
  const QnIpGroup *group = &kkt->problem->groups[g];
  const int32_t *slots = kkt->slots + (size_t) g * GROUP_ENTRIES;
  double sum[GROUP_ENTRIES] = { 0 };
  double *values = kkt->matrix->x;

  for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
    const double (*map)[2] = kkt->problem->cells[c].map;
    const double *inverse = kkt->compliance + 3 * c;

    for (int i = 0, e = 0; i < QN_IP_GROUP_ROWS; i++) {
      double n = map[i][0] * inverse[0] + map[i][1] * inverse[1];
      double t = map[i][0] * inverse[1] + map[i][1] * inverse[2];
      for (int j = 0; j <= i; j++, e++)
        sum[e] += n * map[j][0] + t * map[j][1];
    }
  }
  for (int e = 0; e < GROUP_ENTRIES; e++)
    if (slots[e] >= 0)
      values[slots[e]] += sum[e];
}

/* out = H^-1 ry per cell */
static void
apply_compliance (const QnIpKkt *kkt, const double *ry, double *out)
{
  for (int32_t c = 0; c < kkt->problem->cell_count; c++) {
    const double *h = kkt->compliance + 3 * c;
    double n = ry[2 * c], t = ry[2 * c + 1];
    out[2 * c] = h[0] * n + h[1] * t;
    out[2 * c + 1] = h[1] * n + h[2] * t;
  }
}

/* kkt->solution = M^-1 kkt->right */
static QnStatus
solve_factor (QnIpKkt *kkt, QnDiag *diag)
{
  if (!cholmod_solve2 (CHOLMOD_A, kkt->factor, kkt->right, NULL, &kkt->solution, NULL,
                       &kkt->work_y, &kkt->work_e, &kkt->common))
    return qn_diag_no_memory (diag);
  return QN_OK;
}

static double
dot (const double *a, const double *b, int32_t count)
{
  double sum = 0.0;
  for (int32_t i = 0; i < count; i++)
    sum += a[i] * b[i];
  return sum;
}

static QnStatus
solve_border (QnIpKkt *kkt, QnDiag *diag)
{
  const QnIpProblem *p = kkt->problem;
  size_t size = (size_t) p->row_count * sizeof (double);
  QnStatus status;

  kkt->bordered = p->load != NULL;
  if (!kkt->bordered)
    return QN_OK;
  memcpy (kkt->right->x, p->load, size);
  status = solve_factor (kkt, diag);
  if (status)
    return status;
  memcpy (kkt->border, kkt->solution->x, size);
  kkt->border_power = dot (p->load, kkt->border, p->row_count);
  return QN_OK;
}

QnStatus
qn_ip_kkt_factorize (QnIpKkt *kkt, const double *w, bool *ok, QnDiag *diag)
{
  const QnIpProblem *p = kkt->problem;
  double *values = kkt->matrix->x;

  memset (values, 0, kkt->matrix->nzmax * sizeof (double));
  for (int32_t r = 0; r < p->row_count; r++)
    values[kkt->diagonal[r]] = kkt->regularization;
  for (int32_t c = 0; c < p->cell_count; c++)
    invert_cell (p, &p->cells[c], w, kkt->regularization, kkt->stiffness + 3 * c,
                 kkt->compliance + 3 * c);
  for (int32_t g = 0; g < p->group_count; g++)
    scatter_group (kkt, g);
  kkt->error = 0.0;
  cholmod_factorize (kkt->matrix, kkt->factor, &kkt->common);
  kkt->factorizations++;
  if (kkt->common.status == CHOLMOD_OUT_OF_MEMORY)
    return qn_diag_no_memory (diag);
  *ok = kkt->common.status == CHOLMOD_OK && kkt->factor->minor == kkt->factor->n;
  return *ok ? solve_border (kkt, diag) : QN_OK;
}

/* Solves the regularised system once for the residuals in the workspace and adds the
 * correction to `out`. */
static QnStatus
correct (QnIpKkt *kkt, QnIpKktVector *out, QnDiag *diag)
{
  const QnIpProblem *p = kkt->problem;
  double *right = kkt->right->x, *step_v = kkt->step_v;
  QnStatus status;

  apply_compliance (kkt, kkt->residual_y, kkt->step_y);
  for (int32_t r = 0; r < p->row_count; r++)
    right[r] = -kkt->residual_v[r];
  qn_ip_add_forces (p, kkt->step_y, 1.0, right); /* M dv = B H^-1 ry - rv + f dl */
  status = solve_factor (kkt, diag);
  if (status)
    return status;
  memcpy (step_v, kkt->solution->x, (size_t) p->row_count * sizeof (double));
  kkt->step_lambda = 0.0;
  if (kkt->bordered && kkt->border_power > 0.0) {
    kkt->step_lambda =
      (kkt->residual_lambda - dot (p->load, step_v, p->row_count)) / kkt->border_power;
    for (int32_t r = 0; r < p->row_count; r++)
      step_v[r] += kkt->step_lambda * kkt->border[r];
  }
  qn_ip_add_rates (p, step_v, -1.0, kkt->residual_y);
  apply_compliance (kkt, kkt->residual_y, kkt->step_y); /* dy = H^-1 (ry - B' dv) */
  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    out->y[i] += kkt->step_y[i];
  for (int32_t r = 0; r < p->row_count; r++)
    out->v[r] += step_v[r];
  out->lambda += kkt->step_lambda;
  return QN_OK;
}

/* Takes the last correction back. */
static void
undo (const QnIpKkt *kkt, QnIpKktVector *out)
{
  for (int32_t i = 0; i < 2 * kkt->problem->cell_count; i++)
    out->y[i] -= kkt->step_y[i];
  for (int32_t r = 0; r < kkt->problem->row_count; r++)
    out->v[r] -= kkt->step_v[r];
  out->lambda -= kkt->step_lambda;
}

static double
largest (const double *values, int32_t count)
{
  double most = 0.0;
  for (int32_t i = 0; i < count; i++)
    if (!(fabs (values[i]) <= most)) /* a NaN stays */
      most = fabs (values[i]);
  return most;
}

/* Residual of the first block row, relative to its largest term. */
static double
measure_cells (QnIpKkt *kkt, const double *ry, const QnIpKktVector *out)
{
  const QnIpProblem *p = kkt->problem;
  double *e = kkt->residual_y, *rates = kkt->rates, scale;

  memset (rates, 0, 2 * (size_t) p->cell_count * sizeof (double));
  qn_ip_add_rates (p, out->v, 1.0, rates);
  for (int32_t c = 0; c < p->cell_count; c++) {
    const double *h = kkt->stiffness + 3 * c;
    double n = out->y[2 * c], t = out->y[2 * c + 1];
    double rn = ry[2 * c], rt = p->cells[c].no_shear ? 0.0 : ry[2 * c + 1];
    e[2 * c] = rn - (h[0] * n + h[1] * t) - rates[2 * c];
    e[2 * c + 1] = rt - (h[1] * n + h[2] * t) - rates[2 * c + 1];
  }
  scale = fmax (largest (ry, 2 * p->cell_count), largest (rates, 2 * p->cell_count));
  return scale > 0.0 ? largest (e, 2 * p->cell_count) / scale : 0.0;
}

/* Residual of the unregularised system; returns the largest of its relative sizes. */
static double
measure (QnIpKkt *kkt, const QnIpKktVector *right, const QnIpKktVector *out)
{
  const QnIpProblem *p = kkt->problem;
  double *e = kkt->residual_v;
  double error = measure_cells (kkt, right->y, out), scale;

  for (int32_t r = 0; r < p->row_count; r++)
    e[r] = right->v[r] - (kkt->bordered ? p->load[r] * out->lambda : 0.0)
           + kkt->regularization * out->v[r];
  scale = fmax (largest (right->v, p->row_count), fabs (out->lambda));
  scale = fmax (scale, 1e-3 * largest (out->y, 2 * p->cell_count));
  qn_ip_add_forces (p, out->y, -1.0, e);
  if (scale > 0.0)
    error = fmax (error, largest (e, p->row_count) / scale);
  if (kkt->bordered) {
    double power = dot (p->load, out->v, p->row_count);
    kkt->residual_lambda = right->lambda - power;
    scale = fmax (fabs (right->lambda), largest (out->v, p->row_count));
    if (scale > 0.0)
      error = fmax (error, fabs (kkt->residual_lambda) / scale);
  }
  return error;
}

/* Residual of the zero solution. */
static void
set_residual (QnIpKkt *kkt, const QnIpKktVector *right)
{
  const QnIpProblem *p = kkt->problem;

  memcpy (kkt->residual_y, right->y, 2 * (size_t) p->cell_count * sizeof (double));
  memcpy (kkt->residual_v, right->v, (size_t) p->row_count * sizeof (double));
  kkt->residual_lambda = right->lambda;
  for (int32_t c = 0; c < p->cell_count; c++)
    if (p->cells[c].no_shear)
      kkt->residual_y[2 * c + 1] = 0.0;
}

QnStatus
qn_ip_kkt_solve (QnIpKkt *kkt, const QnIpKktVector *right, QnIpKktVector *out,
                 QnDiag *diag)
{
  const QnIpProblem *p = kkt->problem;
  double last = 1.0;

  memset (out->y, 0, 2 * (size_t) p->cell_count * sizeof (double));
  memset (out->v, 0, (size_t) p->row_count * sizeof (double));
  out->lambda = 0.0;
  set_residual (kkt, right);
  for (int round = 0; round <= MOST_REFINEMENTS && last > REFINEMENT_TARGET; round++) {
    QnStatus status = correct (kkt, out, diag);
    double now;
    if (status)
      return status;
    now = measure (kkt, right, out);
    /* The first pass is the solution; later ones go on while they gain a digit. */
    if (round > 0 && now > last)
      undo (kkt, out);
    if (round > 0 && now > 0.1 * last) {
      last = fmin (last, now);
      break;
    }
    last = now;
  }
  if (!(last <= kkt->error)) /* NaN counts as the worst */
    kkt->error = isnan (last) ? INFINITY : last;
  return QN_OK;
}

void
qn_ip_kkt_clear (QnIpKkt *kkt)
{
  if (kkt->started) {
    cholmod_free_dense (&kkt->work_e, &kkt->common);
    cholmod_free_dense (&kkt->work_y, &kkt->common);
    cholmod_free_dense (&kkt->solution, &kkt->common);
    cholmod_free_dense (&kkt->right, &kkt->common);
    cholmod_free_factor (&kkt->factor, &kkt->common);
    cholmod_free_sparse (&kkt->matrix, &kkt->common);
    cholmod_finish (&kkt->common);
  }
  free (kkt->slots);
  free (kkt->diagonal);
  free (kkt->stiffness);
  free (kkt->compliance);
  free (kkt->residual_y);
  free (kkt->residual_v);
  free (kkt->step_y);
  free (kkt->rates);
  free (kkt->local);
  free (kkt->border);
  free (kkt->step_v);
  *kkt = (QnIpKkt){ 0 };
}
