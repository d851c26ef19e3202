#include "core/limit/interior-point-kkt.h"

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "core/linalg/sparse.h"

#include <math.h>
#include <string.h>

/* Entries of a 6 x 6 matrix. */
#define GROUP_ENTRIES (QN_IP_GROUP_ROWS * QN_IP_GROUP_ROWS)

/* Builds and factorises M for the inverse of H; false where it is
 * singular to working precision. */
static bool
schur_factorize (QnIpKkt *kkt)
{
  const QnIpProblem *p = kkt->ip->problem;
  double start = qn_clock_seconds ();

  memset (kkt->values, 0, (size_t) kkt->columns[p->row_count] * sizeof *kkt->values);
  for (int32_t r = 0; r < p->row_count; r++)
    kkt->values[kkt->diagonal[r]] = kkt->ip->inverse.regularization;
  for (int32_t g = 0; g < p->group_count; g++) {
    const QnIpGroup *group = &p->groups[g];
    const int32_t *slots = kkt->slots + (size_t) g * GROUP_ENTRIES;
    double sum[QN_IP_GROUP_ROWS][QN_IP_GROUP_ROWS] = { { 0 } };

    for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
      const QnIpCell *cell = &p->cells[c];
      const double (*map)[2] = cell->map;
      const double *inverse = kkt->ip->inverse.cells + 4 * c;

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
          kkt->values[slots[QN_IP_GROUP_ROWS * i + j]] += sum[i][j];
  }
  bool ok = qn_block_lu_factor (kkt->lu, kkt->values) > 0;
  kkt->effort->factorizations++;
  kkt->effort->factor_seconds += qn_clock_seconds () - start;
  return ok;
}

/* Overwrites x (row_count) with M^-1 x. */
static void
schur_solve (QnIpKkt *kkt, double *x)
{
  double start = qn_clock_seconds ();

  qn_block_lu_solve (kkt->lu, x);
  kkt->effort->factor_seconds += qn_clock_seconds () - start;
}

/* A direction need not be more exact than this: the next iteration sees what is left. */
#define REFINEMENT_TARGET 1e-6
#define MOST_REFINEMENTS  4

bool
qn_ip_kkt_init (QnIpKkt *kkt, QnIpStep *ip, QnStatistics *effort)
{
  const QnIpProblem *p = ip->problem;
  size_t rows = (size_t) p->row_count;
  size_t entries = (size_t) p->group_count * GROUP_ENTRIES;
  QnPool *pool = &kkt->pool;
  QnSparsePattern pattern;

  *kkt = (QnIpKkt){ .ip = ip, .effort = effort, .error = INFINITY };
  kkt->rates = qn_pool_alloc (pool, 2 * (size_t) p->cell_count, sizeof (double));
  kkt->residual_v = qn_pool_alloc (pool, rows, sizeof (double));
  kkt->border = qn_pool_alloc (pool, rows, sizeof (double));
  kkt->step_v = qn_pool_alloc (pool, rows, sizeof (double));
  kkt->slots = qn_pool_alloc (pool, entries, sizeof *kkt->slots);
  kkt->diagonal = qn_pool_alloc (pool, rows, sizeof *kkt->diagonal);
  qn_sparse_pattern_init (&pattern, p->row_count, entries + rows, pool);
  for (int32_t r = 0; r < p->row_count; r++)
    qn_sparse_pattern_add_clique (&pattern, &r, 1);
  for (int32_t g = 0; g < p->group_count; g++)
    qn_sparse_pattern_add_clique (&pattern, p->groups[g].rows, QN_IP_GROUP_ROWS);
  qn_sparse_pattern_compress (&pattern, &kkt->columns, &kkt->rows);
  if (!pool->failed)
    kkt->values = qn_pool_alloc (pool, (size_t) kkt->columns[rows], sizeof (double));
  if (pool->failed)
    return false;
  for (int32_t r = 0; r < p->row_count; r++)
    kkt->diagonal[r] = qn_sparse_find (kkt->columns, kkt->rows, r, r);
  for (int32_t g = 0, e = 0; g < p->group_count; g++)
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < QN_IP_GROUP_ROWS; j++, e++)
        kkt->slots[e] = qn_sparse_find (kkt->columns, kkt->rows, p->groups[g].rows[i],
                                        p->groups[g].rows[j]);
  kkt->lu = qn_block_lu_new (p->row_count, kkt->columns, kkt->rows, p->workers);
  return kkt->lu != NULL;
}

void
qn_ip_kkt_clear (QnIpKkt *kkt)
{
  qn_block_lu_free (kkt->lu);
  qn_pool_clear (&kkt->pool);
  *kkt = (QnIpKkt){ 0 };
}

bool
qn_ip_kkt_factorize (QnIpKkt *kkt)
{
  const QnIpProblem *p = kkt->ip->problem;

  for (int32_t c = 0; c < p->cell_count; c++)
    qn_ip_step_invert (kkt->ip, c);
  kkt->error = INFINITY;
  if (!schur_factorize (kkt))
    return false;
  kkt->error = 0.0;
  kkt->bordered = p->load != NULL;
  if (kkt->bordered) {
    memcpy (kkt->border, p->load, (size_t) p->row_count * sizeof *kkt->border);
    schur_solve (kkt, kkt->border);
    kkt->border_power = qn_dot (p->load, kkt->border, (size_t) p->row_count);
  }
  return true;
}

/* Lets the forces follow `sign` times the last correction of v (and ry, where given), and
 * measures the residuals of the second and third block row. */
static double
follow_rates (QnIpKkt *kkt, const QnIpVector *right, const double *ry, double sign,
              QnIpVector *out)
{
  const QnIpProblem *p = kkt->ip->problem;
  double *e = kkt->residual_v, *rates = kkt->rates;

  for (int32_t i = 0; i < 2 * p->cell_count; i++)
    rates[i] = ry != NULL && !(p->cells[i / 2].no_shear && i % 2 == 1) ? ry[i] : 0.0;
  qn_ip_add_rates (p, kkt->step_v, -sign, rates);
  for (int32_t c = 0; c < p->cell_count; c++)
    qn_ip_step_answer (kkt->ip, c, rates[2 * c], rates[2 * c + 1], out);
  for (int32_t r = 0; r < p->row_count; r++)
    e[r] = right->v[r] - (kkt->bordered ? p->load[r] * out->lambda : 0.0)
           + kkt->ip->inverse.regularization * out->v[r];
  qn_ip_add_forces (p, out->y, -1, e);
  /* The largest relative residual; residual_v holds what the forces have left. */
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

void
qn_ip_kkt_solve (QnIpKkt *kkt, const QnIpVector *right, QnIpVector *out)
{
  double last = INFINITY;

  memset (out->y, 0, 2 * (size_t) kkt->ip->problem->cell_count * sizeof (double));
  memset (out->s, 0, (size_t) kkt->ip->problem->bound_count * sizeof (double));
  memset (out->v, 0, (size_t) kkt->ip->problem->row_count * sizeof (double));
  out->lambda = 0.0;
  /* residual_v -= B (H+r)^-1 ry: what the forces along v have to balance. */
  const QnIpProblem *p = kkt->ip->problem;
  memcpy (kkt->residual_v, right->v, (size_t) p->row_count * sizeof (double));
  kkt->residual_lambda = right->lambda;
  for (int32_t c = 0; c < p->cell_count; c++) {
    const double *h = kkt->ip->inverse.cells + 4 * (size_t) c,
                 *ry = right->y + 2 * (size_t) c;
    double shear = p->cells[c].no_shear ? 0.0 : ry[1];
    kkt->rates[2 * c] = h[0] * ry[0] + h[1] * shear;
    kkt->rates[2 * c + 1] = h[2] * ry[0] + h[3] * shear;
  }
  qn_ip_add_forces (p, kkt->rates, -1, kkt->residual_v);
  for (int round = 0; round <= MOST_REFINEMENTS; round++) {
    /* The change of v and lambda that removes the residuals. */
    double *step = kkt->step_v;
    for (int32_t r = 0; r < p->row_count; r++)
      step[r] = -kkt->residual_v[r]; /* M dv - f dl = -e,  f'dv = e_l */
    schur_solve (kkt, step);
    kkt->step_lambda = 0.0;
    if (kkt->bordered && kkt->border_power != 0.0) {
      kkt->step_lambda =
        (kkt->residual_lambda - qn_dot (p->load, step, (size_t) p->row_count))
        / kkt->border_power;
      qn_ip_add_multiple (step, kkt->step_lambda, kkt->border, p->row_count);
    }
    qn_ip_add_multiple (out->v, 1, step, p->row_count);
    out->lambda += kkt->step_lambda;
    double now = follow_rates (kkt, right, round == 0 ? right->y : NULL, 1.0, out);
    /* The first pass is the solution; later ones refine it while they gain a digit. */
    if (round > 0 && now > last) { /* takes the last correction back */
      qn_ip_add_multiple (out->v, -1, kkt->step_v, kkt->ip->problem->row_count);
      out->lambda -= kkt->step_lambda;
      now = follow_rates (kkt, right, NULL, -1.0, out);
    }
    if (now <= REFINEMENT_TARGET || (round > 0 && now > 0.1 * last)) {
      last = now;
      break;
    }
    last = now;
  }
  if (!(last <= kkt->error)) /* NaN counts as the worst */
    kkt->error = isnan (last) ? INFINITY : last;
}
