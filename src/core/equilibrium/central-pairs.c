#include "core/equilibrium/central-pairs.h"

#include "core/base/memory.h"

#include <math.h>
#include <string.h>

/* The strengths of a plastic pair by what they limit. */
typedef struct {
  bool shears, crushes; /* whether shear and compression have a limit of their own */
  double tension, compression;
  double friction, cohesion;
} Strengths;

/* Friction without strength at any compression leaves no shear force, and is no row. */
static Strengths
sort_strengths (const QnSpring *whole, const QnSpringMemory *memory)
{
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  QnSpring spring = qn_spring_now (whole, memory);
  int count = qn_spring_strength (&spring, rows);
  Strengths found = { 0 };

  for (const QnStrengthRow *row = rows; row < rows + count; row++) {
    if (row->shear > 0) {
      found.shears = row->normal > 0 || row->limit > 0;
      found.friction = row->normal;
      found.cohesion = row->limit;
    } else if (row->normal > 0) {
      found.tension = row->limit;
    } else {
      found.crushes = true;
      found.compression = row->limit;
    }
  }
  return found;
}

/* Whether a pair is one of strengths and flows: the others are as Newton's method would have them, or
 * carry nothing. */
static bool
takes_part (const QnAssembly *as, size_t p)
{
  return qn_pair_is_plastic (&as->springs[p], &as->committed[p]) && !as->inactive[p];
}

bool
qn_central_pairs_init (QnCentralPairs *pairs, QnAssembly *as)
{
  size_t count = (as->pair_count + QN_CENTRAL_WIDTH - 1) / QN_CENTRAL_WIDTH;
  size_t padded = count * QN_CENTRAL_WIDTH;
  QnPool *pool = &pairs->pool;

  *pairs = (QnCentralPairs){ .assembly = as,
                             .loops = qn_central_loops (QN_CENTRAL_WIDTH),
                             .count = count };
  pairs->force = as->force_scale > 0 ? as->force_scale : 1;
  pairs->length = pairs->force / as->stiffness;
  pairs->packs = qn_pool_lines (pool, count, sizeof *pairs->packs);
  pairs->steps = qn_pool_lines (pool, count, sizeof *pairs->steps);
  pairs->kept = qn_pool_lines (pool, count, sizeof *pairs->kept);
  pairs->near = qn_pool_lines (pool, count, sizeof *pairs->near);
  pairs->slips = qn_pool_alloc (pool, padded, sizeof *pairs->slips);
  pairs->rates = qn_pool_alloc (pool, 2 * padded, sizeof *pairs->rates);
  pairs->forces = qn_pool_lines (pool, 2 * padded, sizeof *pairs->forces);
  pairs->tangents = qn_pool_lines (pool, 4 * padded, sizeof *pairs->tangents);
  return !pool->failed;
}

void
qn_central_pairs_clear (QnCentralPairs *pairs)
{
  qn_pool_clear (&pairs->pool);
  *pairs = (QnCentralPairs){ 0 };
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

static void
start_pair (QnCentralPairs *pairs, size_t p, double size)
{
  const QnAssembly *as = pairs->assembly;
  const QnSpring *spring = &as->springs[p].a;
  const QnSpringMemory *memory = &as->committed[p].a;
  QnCentralPack *e = &pairs->packs[p / QN_CENTRAL_WIDTH];
  size_t i = p % QN_CENTRAL_WIDTH;
  double stiffness = pairs->force / pairs->length;
  double y[2] = { as->responses[p].force[0] / pairs->force,
                  as->responses[p].force[1] / pairs->force };
  Strengths strengths = sort_strengths (spring, memory);

  pairs->products += 1 + 2 * strengths.shears + strengths.crushes;

  e->has_tension[i] = -1;
  e->has_shear[i] = strengths.shears ? -1 : 0;
  e->has_compression[i] = strengths.crushes ? -1 : 0;
  e->friction[i] = strengths.friction;
  e->flexibility[0][i] = stiffness / spring->kn;
  e->flexibility[1][i] = stiffness / spring->ks;
  double dilation[2], beyond = take_dilation (pairs, p, dilation);
  for (int k = 0; k < 2; k++)
    e->dilatancy[k][i] = dilation[k];
  e->plastic[0][i] = (memory->opening + beyond) / pairs->length;
  e->plastic[1][i] = memory->slip / pairs->length;
  e->tension[i] = strengths.tension / pairs->force;
  e->cohesion[i] = strengths.cohesion / pairs->force;
  e->compression[i] = strengths.compression / pairs->force;
  for (int k = 0; k < 2; k++)
    e->now.y[k][i] = y[k];

  const double left[QN_CENTRAL_ROWS] = {
    e->tension[i] - y[0],
    e->cohesion[i] - (e->friction[i] * y[0] + y[1]),
    e->cohesion[i] - (e->friction[i] * y[0] - y[1]),
    e->compression[i] + y[0],
  };
  double opening = as->elongations[2 * p] / pairs->length - e->plastic[0][i]
                   - e->flexibility[0][i] * y[0];
  const double flows[QN_CENTRAL_ROWS] = { fmax (opening, 0), 0, 0, fmax (-opening, 0) };
  const bool has[QN_CENTRAL_ROWS] = { true, strengths.shears, strengths.shears,
                                      strengths.crushes };
  for (int row = 0; row < QN_CENTRAL_ROWS; row++) {
    if (!has[row])
      continue;
    double surplus = fmax (left[row], 0) - flows[row] / size;
    e->now.s[row][i] = positive_root (surplus, 1);
    e->now.z[row][i] = size / e->now.s[row][i];
  }
}

void
qn_central_pairs_start (QnCentralPairs *pairs, double size, bool again)
{
  for (size_t p = 0; p < pairs->assembly->pair_count && !again; p++)
    pairs->slips[p] = pairs->assembly->committed[p].a.slip;
  pairs->turned = false;
  memset (pairs->packs, 0, pairs->count * sizeof *pairs->packs);
  for (size_t k = 0; k < pairs->count; k++)
    for (int row = 0; row < QN_CENTRAL_ROWS; row++)
      for (int i = 0; i < QN_CENTRAL_WIDTH; i++)
        pairs->packs[k].now.s[row][i] = 1;
  pairs->products = 0;
  pairs->others = false;
  for (size_t p = 0; p < pairs->assembly->pair_count; p++)
    if (takes_part (pairs->assembly, p))
      start_pair (pairs, p, size);
    else
      pairs->others = true;
}

/* Forces and tangents of the pairs of other laws. */
static bool
evaluate_others (QnCentralPairs *pairs)
{
  QnAssembly *as = pairs->assembly;

  for (size_t p = 0; p < as->pair_count; p++) {
    QnCentralPack *e = &pairs->packs[p / QN_CENTRAL_WIDTH];
    QnPairResponse *response = &as->responses[p];
    size_t lane = p % QN_CENTRAL_WIDTH;
    if (takes_part (as, p) || as->inactive[p])
      continue;
    if (!qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                           response))
      return false;
    for (int i = 0; i < 2; i++) {
      e->now.y[i][lane] = response->force[i] / pairs->force;
      for (int j = 0; j < 2; j++)
        e->inverse[2 * i + j][lane] =
          response->tangent[i][j] * pairs->length / pairs->force;
    }
  }
  return true;
}

bool
qn_central_pairs_prepare (QnCentralPairs *pairs, QnCentralResiduals *residuals)
{
  if (pairs->others && !evaluate_others (pairs))
    return false;
  *residuals = pairs->loops->prepare (pairs->packs, pairs->count,
                                      pairs->assembly->elongations, 1 / pairs->length);
  return true;
}

void
qn_central_pairs_exchange_steps (QnCentralPairs *pairs)
{
  QnCentralState *steps = pairs->steps;

  pairs->steps = pairs->kept;
  pairs->kept = steps;
}

void
qn_central_pairs_get_forces (QnCentralPairs *pairs)
{
  pairs->loops->forces (pairs->packs, pairs->count, pairs->force, pairs->forces);
}

void
qn_central_pairs_aim (QnCentralPairs *pairs, const QnCentralAim *aim)
{
  pairs->loops->aim (pairs->packs, pairs->steps, pairs->count, aim, pairs->force,
                     pairs->forces);
  if (aim->target == QN_CENTRAL_CENTRE)
    qn_central_pairs_exchange_steps (pairs);
}

void
qn_central_pairs_keep (QnCentralPairs *pairs)
{
  for (size_t k = 0; k < pairs->count; k++)
    pairs->near[k] = pairs->packs[k].now;
}

void
qn_central_pairs_come_back (QnCentralPairs *pairs)
{
  for (size_t k = 0; k < pairs->count; k++)
    pairs->packs[k].now = pairs->near[k];
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
  const QnCentralPack *e = &pairs->packs[p / QN_CENTRAL_WIDTH];
  QnPairResponse *response = &as->responses[p];
  size_t i = p % QN_CENTRAL_WIDTH;
  const QnPackVector *z = e->now.z;
  double dilation = e->dilatancy[0][i] * z[1][i] + e->dilatancy[1][i] * z[2][i];
  const double flow[2] = { z[0][i] - z[3][i] + dilation, z[1][i] - z[2][i] };
  double y[2], q[2];

  for (int k = 0; k < 2; k++) {
    y[k] = e->now.y[k][i];
    q[k] = pairs->length * (e->plastic[k][i] + flow[k] + e->flexibility[k][i] * y[k]);
  }
  bool ok = qn_pair_evaluate (&as->springs[p], &as->committed[p], q, response);
  for (int k = 0; k < 2; k++)
    response->force[k] = pairs->force * y[k];
  if (e->has_shear[i] && !as->springs[p].a.associative) {
    QnSpringMemory *memory = &response->memory.a;
    double slip =
      as->elongations[2 * p + 1] - pairs->length * e->flexibility[1][i] * y[1];
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
    if (takes_part (as, p))
      ok &= take_flow_of_pair (pairs, p);
    else if (!as->inactive[p])
      ok &= qn_pair_evaluate (&as->springs[p], &as->committed[p], as->elongations + 2 * p,
                              &as->responses[p]);
  return ok;
}
