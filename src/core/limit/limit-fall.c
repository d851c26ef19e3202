#include "core/limit/limit-fall.h"

#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

/* A measure of the quadratic program above this is no answer. */
#define ACCEPTED_MEASURE 1e-5

QnStatus
qn_limit_fall (const QnLimitProblem *limit, bool (*go_on) (void *user_data),
               void *user_data, double *v, bool *found, QnDiag *diag)
{
  QnIpSettings settings = qn_interior_point_defaults ();
  QnInteriorPoint ip = { 0 };
  QnIpProblem fall = limit->ip;
  size_t blocks = limit->block_count, group_count = (size_t) fall.group_count,
         cell_count = (size_t) fall.cell_count;
  /* Copies with room for two more cells per block: the imbalance, as an unlimited force and moment on the
   * block with a quadratic price. */
  QnIpGroup *groups = qn_alloc (group_count + blocks, sizeof *groups);
  QnIpCell *cells = qn_alloc (cell_count + 2 * blocks, sizeof *cells);
  bool going_on = true;

  *found = false;
  if (!groups || !cells) {
    free (groups);
    free (cells);
    return qn_diag_no_memory (diag);
  }
  memcpy (groups, fall.groups, group_count * sizeof *groups);
  memcpy (cells, fall.cells, cell_count * sizeof *cells);
  for (size_t b = 0; b < blocks; b++) {
    const double *mass = limit->mass + b * QN_DOF_COUNT;
    QnIpGroup *group = &groups[group_count + b];
    QnIpCell *pair = &cells[cell_count + 2 * b];
    *group = (QnIpGroup){ .first_cell = (int32_t) (cell_count + 2 * b), .cell_count = 2 };
    for (size_t i = 0; i < QN_IP_GROUP_ROWS; i++)
      group->rows[i] = i < QN_DOF_COUNT ? limit->rows[b * QN_DOF_COUNT + i] : -1;
    pair[0] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_UX], 1.0 / mass[QN_DOF_UY] },
                          .first_bound = fall.bound_count };
    pair[0].map[QN_DOF_UX][0] = 1.0;
    pair[0].map[QN_DOF_UY][1] = 1.0;
    pair[1] = (QnIpCell){ .quadratic = { 1.0 / mass[QN_DOF_RZ], 0.0 },
                          .first_bound = fall.bound_count,
                          .no_shear = true };
    pair[1].map[QN_DOF_RZ][0] = 1.0;
  }
  fall.groups = groups;
  fall.cells = cells;
  fall.group_count += (int32_t) blocks;
  fall.cell_count += 2 * (int32_t) blocks;
  fall.load = NULL;
  fall.load_gain = 0.0;
  QnStatus status = qn_interior_point_init (&ip, &fall, &settings, diag);
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
      v[r] = ip.at.v[r] / ip.at.tau;
  }
  qn_interior_point_clear (&ip);
  free (groups);
  free (cells);
  return status;
}
