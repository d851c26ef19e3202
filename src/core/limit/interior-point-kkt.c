#include "core/limit/interior-point-kkt.h"

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/linalg/sparse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Entries of a 6 x 6 matrix. */
#define GROUP_ENTRIES (QN_IP_GROUP_ROWS * QN_IP_GROUP_ROWS)

/* The pattern of M in storage order, without duplicates. */
static bool
find_pattern (QnIpSchur *schur, QnPool *pool)
{
  const QnIpProblem *p = schur->problem;
  QnSparsePattern pattern;
  bool ok = qn_sparse_pattern_init (&pattern, p->row_count,
                                    (size_t) p->group_count * GROUP_ENTRIES
                                      + (size_t) p->row_count);

  for (int32_t r = 0; ok && r < p->row_count; r++)
    ok = qn_sparse_pattern_add_clique (&pattern, &r, 1);
  for (int32_t g = 0; ok && g < p->group_count; g++)
    ok = qn_sparse_pattern_add_clique (&pattern, p->groups[g].rows, QN_IP_GROUP_ROWS);
  ok = ok && qn_sparse_pattern_compress (&pattern, &schur->columns, &schur->rows);
  qn_sparse_pattern_clear (&pattern);
  if (ok) {
    qn_pool_add (pool, schur->columns);
    qn_pool_add (pool, schur->rows);
  }
  return ok && !pool->failed;
}

static void
schur_init (QnIpSchur *schur, const QnIpProblem *p, QnPool *pool)
{
  *schur = (QnIpSchur){ .problem = p };
  schur->slots =
    qn_pool_alloc (pool, (size_t) p->group_count * GROUP_ENTRIES, sizeof *schur->slots);
  schur->diagonal = qn_pool_alloc (pool, (size_t) p->row_count, sizeof *schur->diagonal);
  if (!find_pattern (schur, pool))
    return;
  schur->values =
    qn_pool_alloc (pool, (size_t) schur->columns[p->row_count], sizeof *schur->values);
  if (schur->values == NULL)
    return;
  for (int32_t r = 0; r < p->row_count; r++)
    schur->diagonal[r] = qn_sparse_find (schur->columns, schur->rows, r, r);
  for (int32_t g = 0, e = 0; g < p->group_count; g++)
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < QN_IP_GROUP_ROWS; j++, e++)
        schur->slots[e] = qn_sparse_find (schur->columns, schur->rows,
                                          p->groups[g].rows[i], p->groups[g].rows[j]);
  schur->lu = qn_block_lu_new (p->row_count, schur->columns, schur->rows, p->workers);
}

/* Builds and factorises M for the compliances H^-1 (cell_count x 4, by rows) and r; false where it is
 * singular to working precision. */
static bool
schur_factorize (QnIpSchur *schur, const double *compliance, double regularization)
{
  double start = qn_clock_seconds ();

  memset (schur->values, 0,
          (size_t) schur->columns[schur->problem->row_count] * sizeof *schur->values);
  for (int32_t r = 0; r < schur->problem->row_count; r++)
    schur->values[schur->diagonal[r]] = regularization;
  for (int32_t g = 0; g < schur->problem->group_count; g++) {
    const QnIpGroup *group = &schur->problem->groups[g];
    const int32_t *slots = schur->slots + (size_t) g * GROUP_ENTRIES;
    double sum[QN_IP_GROUP_ROWS][QN_IP_GROUP_ROWS] = { { 0 } };

    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const double (*map)[2] = schur->problem->cells[c].map;
      const double *inverse = compliance + 4 * c;

      for (int i = 0; i < QN_IP_GROUP_ROWS; i++) {
        double n = map[i][0] * inverse[0] + map[i][1] * inverse[2];
        double t = map[i][0] * inverse[1] + map[i][1] * inverse[3];
        for (int j = 0; j < QN_IP_GROUP_ROWS; j++)
          sum[i][j] += n * map[j][0] + t * map[j][1];
      }
    }
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < QN_IP_GROUP_ROWS; j++)
        if (slots[QN_IP_GROUP_ROWS * i + j] >= 0)
          schur->values[slots[QN_IP_GROUP_ROWS * i + j]] += sum[i][j];
  }
  bool ok = qn_block_lu_factor (schur->lu, schur->values) > 0;
  schur->factorizations++;
  schur->seconds += qn_clock_seconds () - start;
  return ok;
}

/* Overwrites x (row_count) with M^-1 x. */
static void
schur_solve (QnIpSchur *schur, double *x)
{
  double start = qn_clock_seconds ();

  qn_block_lu_solve (schur->lu, x);
  schur->seconds += qn_clock_seconds () - start;
}

/* A direction need not be more exact than this: the next iteration sees what is left. */
#define REFINEMENT_TARGET 1e-6
#define MOST_REFINEMENTS  4

bool
qn_ip_kkt_init (QnIpKkt *kkt, const QnIpProblem *problem)
{
  size_t cells = (size_t) problem->cell_count, rows = (size_t) problem->row_count;
  QnPool *pool = &kkt->pool;

  *kkt = (QnIpKkt){ .problem = problem, .coupling = 1, .error = INFINITY };
  kkt->compliance = qn_pool_alloc (pool, 4 * cells, sizeof (double));
  kkt->axes = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  kkt->rates = qn_pool_alloc (pool, 2 * cells, sizeof (double));
  kkt->turns = qn_pool_alloc (pool, (size_t) problem->bound_count, sizeof (double));
  kkt->residual_v = qn_pool_alloc (pool, rows, sizeof (double));
  kkt->border = qn_pool_alloc (pool, rows, sizeof (double));
  kkt->step_v = qn_pool_alloc (pool, rows, sizeof (double));
  schur_init (&kkt->schur, problem, pool);
  return kkt->schur.lu != NULL;
}

void
qn_ip_kkt_clear (QnIpKkt *kkt)
{
  qn_block_lu_free (kkt->schur.lu);
  qn_pool_clear (&kkt->pool);
  *kkt = (QnIpKkt){ 0 };
}

/* What a row of G has of the normal force in the matrix. */
static double
row_normal (const QnIpKkt *kkt, const QnIpBound *bound)
{
  return bound->opening + kkt->coupling * (bound->normal - bound->opening);
}

/* The inverse of H of a cell, every term a sum without cancellation however different the weights:
 * the determinant by Cauchy and Binet, det = sum_{i<j} w_i w_j (f_i x f_j) (g_i x g_j), the
 * adjugate by turning rows and flows by a right angle, adj H = sum_j w_j g_j^ f_j^'. Q and the
 * regularisation count as rows along the axes. */
static void
invert_cell (QnIpKkt *kkt, int32_t c, const double *w)
{
  const QnIpCell *cell = &kkt->problem->cells[c];
  const QnIpBound *bounds = kkt->problem->bounds + cell->first_bound;
  double axis_n = cell->quadratic[0] + kkt->regularization;
  double axis_t = cell->quadratic[1] + kkt->regularization;
  double nn = axis_n, nt = 0.0, tn = 0.0, tt = axis_t, determinant = axis_n * axis_t;
  double *compliance = kkt->compliance + 4 * (size_t) c;
  double *turns = kkt->turns + cell->first_bound;

  w += cell->first_bound;
  for (int32_t i = 0; i < cell->bound_count; i++) {
    const QnIpBound *b = &bounds[i];
    double normal = row_normal (kkt, b);
    nn += w[i] * b->opening * normal;
    nt += w[i] * b->opening * b->shear;
    tn += w[i] * b->shear * normal;
    tt += w[i] * b->shear * b->shear;
    determinant += w[i] * (b->opening * normal * axis_t + b->shear * b->shear * axis_n);
    for (int32_t j = 0; j < i; j++)
      determinant +=
        w[i] * w[j] * (normal * bounds[j].shear - b->shear * row_normal (kkt, &bounds[j]))
        * (b->opening * bounds[j].shear - b->shear * bounds[j].opening);
  }
  compliance[0] = cell->no_shear ? 1.0 / nn : tt / determinant;
  compliance[1] = cell->no_shear ? 0.0 : -nt / determinant;
  compliance[2] = cell->no_shear ? 0.0 : -tn / determinant;
  compliance[3] = cell->no_shear ? 0.0 : nn / determinant;
  kkt->axes[2 * c] = cell->no_shear ? 1.0 / nn : axis_t / determinant;
  kkt->axes[2 * c + 1] = cell->no_shear ? 0.0 : axis_n / determinant;
  for (int32_t i = 0; i < cell->bound_count; i++)
    turns[i] = cell->no_shear ? 0.0 : w[i] / determinant;
}

bool
qn_ip_kkt_factorize (QnIpKkt *kkt, const double *w)
{
  const QnIpProblem *p = kkt->problem;

  for (int32_t c = 0; c < p->cell_count; c++)
    invert_cell (kkt, c, w);
  kkt->error = INFINITY;
  if (!schur_factorize (&kkt->schur, kkt->compliance, kkt->regularization))
    return false;
  kkt->error = 0.0;
  kkt->bordered = p->load != NULL;
  if (kkt->bordered) {
    memcpy (kkt->border, p->load, (size_t) p->row_count * sizeof *kkt->border);
    schur_solve (&kkt->schur, kkt->border);
    kkt->border_power = qn_dot (p->load, kkt->border, (size_t) p->row_count);
  }
  return true;
}

/* y += dy = (H+r)^-1 (normal, shear), g += G dy for one cell. A row's own part of dy is at right
 * angles to it and left out of its g. */
static void
answer_cell (const QnIpKkt *kkt, int32_t c, double normal, double shear,
             QnIpKktVector *out)
{
  const QnIpCell *cell = &kkt->problem->cells[c];
  const QnIpBound *bounds = kkt->problem->bounds + cell->first_bound;
  const double *turns = kkt->turns + cell->first_bound;
  double *g = out->g + cell->first_bound;
  double axis_n = kkt->axes[2 * c] * normal, axis_t = kkt->axes[2 * c + 1] * shear;
  double yn = axis_n, yt = axis_t;

  for (int32_t i = 0; i < cell->bound_count; i++) {
    const QnIpBound *b = &bounds[i];
    double row = row_normal (kkt, b);
    double turn = turns[i] * (b->opening * shear - b->shear * normal);
    yn -= turn * b->shear;
    yt += turn * row;
    g[i] += row * axis_n + b->shear * axis_t;
    for (int32_t j = 0; j < cell->bound_count; j++)
      if (j != i)
        g[j] += turn * (row * bounds[j].shear - b->shear * row_normal (kkt, &bounds[j]));
  }
  out->y[2 * c] += yn;
  out->y[2 * c + 1] += yt;
}

/* Largest relative residual of the second and third block row; residual_v holds what
 * subtract_forces() has left. */
static double
relative_error (QnIpKkt *kkt, const QnIpKktRight *right, const QnIpKktVector *out)
{
  const QnIpProblem *p = kkt->problem;
  double error = 0.0;
  double scale = fmax (qn_ip_largest (right->v, p->row_count), fabs (out->lambda));

  scale = fmax (scale, 1e-3 * qn_ip_largest (out->y, 2 * p->cell_count));
  if (scale > 0.0)
    error = qn_ip_largest (kkt->residual_v, p->row_count) / scale;
  if (kkt->bordered) {
    kkt->residual_lambda =
      right->lambda - qn_dot (p->load, out->v, (size_t) p->row_count);
    scale = fmax (fabs (right->lambda), qn_ip_largest (out->v, p->row_count));
    if (scale > 0.0)
      error = qn_worse (error, fabs (kkt->residual_lambda) / scale);
  }
  return error;
}

/* Lets the forces follow `sign` times the last correction of v (and ry, where given), and
 * measures the residuals of the second and third block row. */
static double
follow_rates (QnIpKkt *kkt, const QnIpKktRight *right, const double *ry, double sign,
              QnIpKktVector *out)
{
  const QnIpProblem *p = kkt->problem;
  double *e = kkt->residual_v, *rates = kkt->rates;

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    rates[i] = ry != NULL && !(p->cells[i / 2].no_shear && i % 2 == 1) ? ry[i] : 0.0;
  qn_ip_add_rates (p, kkt->step_v, -sign, rates);
  for (int32_t c = 0; c < p->cell_count; c++)
    answer_cell (kkt, c, rates[2 * c], rates[2 * c + 1], out);
  for (int32_t r = 0; r < p->row_count; r++)
    e[r] = right->v[r] - (kkt->bordered ? p->load[r] * out->lambda : 0.0)
           + kkt->regularization * out->v[r];
  qn_ip_add_forces (p, out->y, -1, e);
  return relative_error (kkt, right, out);
}

/* residual_v -= B (H+r)^-1 ry: what the forces along v have to balance. */
static void
condense (QnIpKkt *kkt, const QnIpKktRight *right)
{
  const QnIpProblem *p = kkt->problem;

  memcpy (kkt->residual_v, right->v, (size_t) p->row_count * sizeof (double));
  kkt->residual_lambda = right->lambda;
  for (int32_t c = 0; c < p->cell_count; c++) {
    const double *h = kkt->compliance + 4 * (size_t) c, *ry = right->y + 2 * (size_t) c;
    double shear = p->cells[c].no_shear ? 0.0 : ry[1];
    kkt->rates[2 * c] = h[0] * ry[0] + h[1] * shear;
    kkt->rates[2 * c + 1] = h[2] * ry[0] + h[3] * shear;
  }
  qn_ip_add_forces (p, kkt->rates, -1, kkt->residual_v);
}

/* The change of v and lambda that removes the residuals. */
static void
correct (QnIpKkt *kkt, QnIpKktVector *out)
{
  const QnIpProblem *p = kkt->problem;
  double *step = kkt->step_v;

  for (int32_t r = 0; r < p->row_count; r++)
    step[r] = -kkt->residual_v[r]; /* M dv - f dl = -e,  f'dv = e_l */
  schur_solve (&kkt->schur, step);
  kkt->step_lambda = 0.0;
  if (kkt->bordered && kkt->border_power != 0.0) {
    kkt->step_lambda =
      (kkt->residual_lambda - qn_dot (p->load, step, (size_t) p->row_count))
      / kkt->border_power;
    qn_ip_add_multiple (step, kkt->step_lambda, kkt->border, p->row_count);
  }
  qn_ip_add_multiple (out->v, 1, step, p->row_count);
  out->lambda += kkt->step_lambda;
}

/* Takes the last correction back. */
static double
undo (QnIpKkt *kkt, const QnIpKktRight *right, QnIpKktVector *out)
{
  qn_ip_add_multiple (out->v, -1, kkt->step_v, kkt->problem->row_count);
  out->lambda -= kkt->step_lambda;
  return follow_rates (kkt, right, NULL, -1.0, out);
}

void
qn_ip_kkt_solve (QnIpKkt *kkt, const QnIpKktRight *right, QnIpKktVector *out)
{
  double last = INFINITY;

  memset (out->y, 0, 2 * (size_t) kkt->problem->cell_count * sizeof (double));
  memset (out->g, 0, (size_t) kkt->problem->bound_count * sizeof (double));
  memset (out->v, 0, (size_t) kkt->problem->row_count * sizeof (double));
  out->lambda = 0.0;
  condense (kkt, right);
  for (int round = 0; round <= MOST_REFINEMENTS; round++) {
    correct (kkt, out);
    double now = follow_rates (kkt, right, round == 0 ? right->y : NULL, 1.0, out);
    /* The first pass is the solution; later ones refine it while they gain a digit. */
    if (round > 0 && now > last)
      now = undo (kkt, right, out);
    if (now <= REFINEMENT_TARGET || (round > 0 && now > 0.1 * last)) {
      last = now;
      break;
    }
    last = now;
  }
  if (!(last <= kkt->error)) /* NaN counts as the worst */
    kkt->error = isnan (last) ? INFINITY : last;
}
