#include "core/equilibrium/central-pairs.h"

#include "core/base/memory.h"
#include "core/base/numbers.h"

#include <math.h>
#include <string.h>

enum { MOST_ROWS = 4 };

void
qn_central_pairs_init (QnCentralPairs *pairs, QnAssembly *as, const QnIpTuning *tuning)
{
  size_t count = as->pair_count;
  QnPool *pool = &pairs->pool;

  *pairs = (QnCentralPairs){ .assembly = as };
  pairs->force = as->force_scale > 0 ? as->force_scale : 1;
  pairs->length = pairs->force / as->stiffness;
  pairs->problem = (QnIpProblem){
    .row_count = as->unknown_count,
    .cell_count = (int32_t) count,
    .bound_count = (int32_t) (MOST_ROWS * count),
    .cells = qn_pool_alloc (pool, count, sizeof (QnIpCell)),
    .bounds = qn_pool_alloc (pool, MOST_ROWS * count, sizeof (QnIpBound)),
  };
  qn_ip_step_init (&pairs->ip, &pairs->problem, tuning, pool);
  pairs->slips = qn_pool_alloc (pool, count, sizeof *pairs->slips);
  pairs->plastic = qn_pool_alloc (pool, 2 * count, sizeof *pairs->plastic);
  pairs->rates = qn_pool_alloc (pool, 2 * count, sizeof *pairs->rates);
  pairs->forces = qn_pool_alloc (pool, 2 * count, sizeof *pairs->forces);
  pairs->tangents = qn_pool_alloc (pool, 4 * count, sizeof *pairs->tangents);
}

/* Rates of dilation by slip in the positive sense and in the negative. At first a slip dilates
 * whichever way it goes, which a central path finds its way with; one that was led elsewhere does
 * so along a line. Returns what the line on which they lie has at the committed slip beyond the
 * dilation there, m. */
static double
take_dilation (const QnCentralPairs *pairs, size_t p, double rates[2])
{
  const QnSpring *spring = &pairs->assembly->springs[p].a;
  double from = pairs->assembly->committed[p].a.slip, about = pairs->slips[p];

  if (about == from) {
    rates[0] = rates[1] = qn_spring_dilation_rate (spring, from, from < 0 ? -1 : 1);
    return 0;
  }
  rates[0] = qn_spring_dilation_rate (spring, about, 1);
  rates[1] = -rates[0];
  return qn_spring_dilation (spring, about) + rates[0] * (from - about)
         - qn_spring_dilation (spring, from);
}

/* s > 0 with s - product / s = surplus, without cancellation. */
static double
positive_root (double surplus, double product)
{
  double root = sqrt (surplus * surplus + 4 * product);

  return surplus >= 0 ? 0.5 * (surplus + root) : 2 * product / (root - surplus);
}

/* Friction without strength at any compression leaves no shear force, and is no row. */
static void
start_pair (QnCentralPairs *pairs, size_t p, double size)
{
  const QnAssembly *as = pairs->assembly;
  const QnSpring *whole = &as->springs[p].a;
  const QnSpringMemory *memory = &as->committed[p].a;
  const QnSpring now = qn_spring_now (whole, memory);
  QnIpCell *cell = &pairs->problem.cells[p];
  double unit = pairs->length / pairs->force, *y = pairs->ip.at.y + 2 * p;
  double *plastic = pairs->plastic + 2 * p, dilation[2];
  double beyond = take_dilation (pairs, p, dilation);
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  int count = qn_spring_strength (&now, rows);

  cell->quadratic[0] = 1 / (whole->kn * unit);
  cell->quadratic[1] = 1 / (whole->ks * unit);
  cell->no_shear = true;
  plastic[0] = (memory->opening + beyond) / pairs->length;
  plastic[1] = memory->slip / pairs->length;
  for (int k = 0; k < 2; k++)
    y[k] = as->responses[p].force[k] / pairs->force;
  double opening =
    as->elongations[2 * p] / pairs->length - plastic[0] - cell->quadratic[0] * y[0];
  for (const QnStrengthRow *row = rows; row < rows + count; row++) {
    double limit = row->limit / pairs->force;
    if (row->shear > 0 && row->normal <= 0 && row->limit <= 0)
      continue;
    cell->no_shear &= row->shear == 0;
    for (int way = 0; way < (row->shear > 0 ? 2 : 1); way++) {
      double flow = row->shear > 0 ? 0 : fmax (row->normal * opening, 0);
      int32_t i = cell->first_bound + cell->bound_count++;
      pairs->problem.bounds[i] =
        (QnIpBound){ .normal = row->normal,
                     .shear = way == 0 ? row->shear : -row->shear,
                     .limit = limit,
                     .opening = row->shear > 0 ? dilation[way] : row->normal };
      double left = limit - (row->normal * y[0] + pairs->problem.bounds[i].shear * y[1]);
      pairs->ip.at.s[i] = positive_root (fmax (left, 0) - flow / size, 1);
      pairs->ip.at.z[i] = size / pairs->ip.at.s[i];
    }
  }
  pairs->problem.bound_count += cell->bound_count;
}

void
qn_central_pairs_start (QnCentralPairs *pairs, double size, bool again)
{
  const QnAssembly *as = pairs->assembly;
  size_t count = as->pair_count;

  for (size_t p = 0; p < count && !again; p++)
    pairs->slips[p] = as->committed[p].a.slip;
  pairs->turned = false;
  pairs->others = false;
  memset (pairs->ip.at.y, 0, 2 * count * sizeof (double));
  memset (pairs->ip.inverse.cells, 0, 4 * count * sizeof (double));
  pairs->problem.bound_count = 0;
  for (size_t p = 0; p < count; p++) {
    pairs->problem.cells[p] = (QnIpCell){ .first_bound = pairs->problem.bound_count };
    if (qn_pair_is_plastic (&as->springs[p], &as->committed[p]) && !as->inactive[p])
      start_pair (pairs, p, size);
    else /* as Newton's method would have it, or without force */
      pairs->others = true;
  }
}

/* Forces and tangents of the pairs of other laws. */
static bool
evaluate_others (QnCentralPairs *pairs)
{
  QnAssembly *as = pairs->assembly;

  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairResponse *response = &as->responses[p];
    if (pairs->problem.cells[p].bound_count > 0 || as->inactive[p])
      continue;
    if (!qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                           response))
      return false;
    for (int i = 0; i < 2; i++) {
      pairs->ip.at.y[2 * p + i] = response->force[i] / pairs->force;
      for (int j = 0; j < 2; j++)
        pairs->ip.inverse.cells[4 * p + 2 * i + j] =
          response->tangent[i][j] * pairs->length / pairs->force;
    }
  }
  return true;
}

bool
qn_central_pairs_prepare (QnCentralPairs *pairs)
{
  QnIpStep *ip = &pairs->ip;
  double shrink = 1 / pairs->length;

  pairs->elongation = pairs->largest_force = 0;
  if (pairs->others && !evaluate_others (pairs))
    return false;
  qn_ip_step_measure (ip);
  pairs->strength = qn_largest (ip->rz, (size_t) pairs->problem.bound_count);
  qn_ip_step_weights (ip);
  for (size_t p = 0; p < pairs->assembly->pair_count; p++) {
    const QnIpCell *cell = &pairs->problem.cells[p];
    for (size_t i = 0; i < 2; i++) {
      size_t at = 2 * p + i;
      double beyond = pairs->assembly->elongations[at] * shrink - pairs->plastic[at];
      bool counts = cell->bound_count > 0;
      ip->ry[at] = counts && !(cell->no_shear && i == 1)
                     ? beyond - cell->quadratic[i] * ip->at.y[at]
                     : 0;
      if (counts) {
        pairs->elongation = qn_max (fabs (beyond), pairs->elongation);
        pairs->largest_force = qn_max (fabs (ip->at.y[at]), pairs->largest_force);
      }
    }
    if (cell->bound_count > 0)
      qn_ip_step_invert (ip, (int32_t) p);
  }
  qn_ip_add_flows (&pairs->problem, ip->at.z, -1, ip->ry);
  pairs->strain = qn_largest (ip->ry, 2 * pairs->assembly->pair_count);
  return true;
}

void
qn_central_pairs_get_forces (QnCentralPairs *pairs)
{
  for (size_t i = 0; i < 2 * pairs->assembly->pair_count; i++)
    pairs->forces[i] = pairs->force * pairs->ip.at.y[i];
}

void
qn_central_pairs_aim (QnCentralPairs *pairs)
{
  for (size_t i = 0; i < 2 * pairs->assembly->pair_count; i++) {
    const double *row = pairs->ip.inverse.cells + 2 * i,
                 *right = pairs->ip.right + (i & ~1UL);
    pairs->forces[i] =
      pairs->force * (pairs->ip.at.y[i] + (row[0] * right[0] + row[1] * right[1]));
  }
}

void
qn_central_pairs_complete (const QnCentralPairs *pairs, QnIpVector *step)
{
  double shrink = 1 / pairs->length;

  memset (step->y, 0, 2 * pairs->assembly->pair_count * sizeof (double));
  memset (step->s, 0, (size_t) pairs->problem.bound_count * sizeof (double));
  for (size_t p = 0; p < pairs->assembly->pair_count; p++)
    if (pairs->problem.cells[p].bound_count > 0)
      qn_ip_step_answer (
        &pairs->ip, (int32_t) p, pairs->rates[2 * p] * shrink + pairs->ip.right[2 * p],
        pairs->rates[2 * p + 1] * shrink + pairs->ip.right[2 * p + 1], step);
}

/* Part of the largest force that dilation beyond a corner may cause. */
#define TURN 1e-6

/* Whether a slip has gone so far beyond a corner of its dilation, that the pair has another force. */
static bool
turns (QnCentralPairs *pairs, size_t p, double flow)
{
  const QnSpring *spring = &pairs->assembly->springs[p].a;
  if (spring->associative)
    return false;
  double slip = pairs->assembly->committed[p].a.slip, rates[2];
  double line = qn_spring_dilation (spring, slip) + take_dilation (pairs, p, rates)
                + rates[flow < 0] * fabs (flow);

  if (fabs (line - qn_spring_dilation (spring, slip + flow)) * spring->kn
      <= TURN * pairs->force)
    return false;
  pairs->slips[p] = slip + flow;
  pairs->turned = true;
  return true;
}

static bool
take_flow_of_pair (QnCentralPairs *pairs, size_t p)
{
  QnAssembly *as = pairs->assembly;
  const QnIpCell *cell = &pairs->problem.cells[p];
  QnPairResponse *response = &as->responses[p];
  const double *y = pairs->ip.at.y + 2 * p;
  double flow[2] = { 0 }, q[2];

  for (int32_t i = cell->first_bound; i < cell->first_bound + cell->bound_count; i++) {
    flow[0] += pairs->problem.bounds[i].opening * pairs->ip.at.z[i];
    flow[1] += pairs->problem.bounds[i].shear * pairs->ip.at.z[i];
  }
  for (int k = 0; k < 2; k++)
    q[k] =
      pairs->length * (pairs->plastic[2 * p + k] + flow[k] + cell->quadratic[k] * y[k]);
  bool ok = qn_pair_evaluate (&as->springs[p], &as->committed[p], q, response);
  for (int k = 0; k < 2; k++)
    response->force[k] = pairs->force * y[k];
  if (!cell->no_shear && !as->springs[p].a.associative) {
    QnSpringMemory *memory = &response->memory.a;
    double slip = as->elongations[2 * p + 1] - pairs->length * cell->quadratic[1] * y[1];
    memory->opening = qn_spring_risen (&as->springs[p].a, memory, slip);
    memory->slip = slip;
  }
  return ok && !turns (pairs, p, flow[1] * pairs->length);
}

bool
qn_central_pairs_take_flow (QnCentralPairs *pairs)
{
  QnAssembly *as = pairs->assembly;
  bool ok = true;

  for (size_t p = 0; p < as->pair_count; p++)
    if (pairs->problem.cells[p].bound_count > 0)
      ok &= take_flow_of_pair (pairs, p);
    else if (!as->inactive[p])
      ok &= qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                              &as->responses[p]);
  return ok;
}
