#include "core/limit/limit-fall.h"

#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A measure of the quadratic program above this is no answer. */
#define ACCEPTED_MEASURE 1e-5

/* Copies of the program's arrays with room for two more cells per block: the imbalance, as an
 * unlimited force and moment on the block with a quadratic price. */
typedef struct Fall {
  QnIpGroup *groups;
  QnIpCell *cells;
  QnIpProblem ip;
} Fall;

static void
add_imbalance (Fall *fall, const QnLimitProblem *limit, size_t block)
{
  const int32_t *rows = limit->rows + block * QN_DOF_COUNT;
  const double *mass = limit->mass + block * QN_DOF_COUNT;
  QnIpGroup *group = &fall->groups[fall->ip.group_count++];
  QnIpCell *cells = &fall->cells[fall->ip.cell_count];

  *group = (QnIpGroup){ .first_cell = fall->ip.cell_count, .cell_count = 2 };
  for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
    group->rows[i] = i < QN_DOF_COUNT ? rows[i] : -1;
  cells[0] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_UX], 1.0 / mass[QN_DOF_UY] },
                         .first_bound = limit->ip.bound_count };
  cells[0].map[QN_DOF_UX][0] = 1.0;
  cells[0].map[QN_DOF_UY][1] = 1.0;
  cells[1] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_RZ], 0.0 },
                         .first_bound = limit->ip.bound_count,
                         .no_shear = true };
  cells[1].map[QN_DOF_RZ][0] = 1.0;
  fall->ip.cell_count += 2;
}

static bool
fall_init (Fall *fall, const QnLimitProblem *limit)
{
  const QnIpProblem *ip = &limit->ip;
  size_t groups = (size_t) ip->group_count, cells = (size_t) ip->cell_count;

  fall->groups = qn_alloc (groups + limit->block_count, sizeof *fall->groups);
  fall->cells = qn_alloc (cells + 2 * limit->block_count, sizeof *fall->cells);
  if (!fall->groups || !fall->cells)
    return false;
  memcpy (fall->groups, ip->groups, groups * sizeof *fall->groups);
  memcpy (fall->cells, ip->cells, cells * sizeof *fall->cells);
  fall->ip = *ip;
  fall->ip.groups = fall->groups;
  fall->ip.cells = fall->cells;
  fall->ip.load = NULL;
  fall->ip.load_gain = 0.0;
  for (size_t b = 0; b < limit->block_count; b++)
    add_imbalance (fall, limit, b);
  return true;
}

QnStatus
qn_limit_fall (const QnLimitProblem *limit, bool (*go_on) (void *user_data),
               void *user_data, double *v, bool *found, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();
  QnInteriorPoint ip = { 0 };
  Fall fall = { 0 };
  QnStatus status;
  bool going_on = true;

  *found = false;
  if (fall_init (&fall, limit))
    status = qn_interior_point_init (&ip, &fall.ip, &settings, diag);
  else
    status = qn_diag_no_memory (diag);
  if (!status)
    status = qn_interior_point_start (&ip, diag);
  while (!status && ip.state == QN_IP_RUNNING && going_on) {
    status = qn_interior_point_iterate (&ip, diag);
    going_on = go_on (user_data);
  }
  if (!status && going_on) {
    const QnIpMeasures *m = &ip.measures;
    *found = ip.state == QN_IP_OPTIMAL
             || (ip.state == QN_IP_STALLED && m->primal_residual < ACCEPTED_MEASURE
                 && m->dual_residual < ACCEPTED_MEASURE && m->gap < ACCEPTED_MEASURE);
    for (int32_t r = 0; r < limit->ip.row_count && *found; r++)
      v[r] = ip.v[r] / ip.tau;
  }
  qn_interior_point_clear (&ip);
  free (fall.groups);
  free (fall.cells);
  return status;
}
