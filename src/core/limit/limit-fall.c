#include "core/limit/limit-fall.h"

#include "core/base/memory.h"
#include "core/limit/collapse.h"

#include <string.h>

/* Accuracy of the quadratic program. */
#define FALL_TOLERANCE 1e-9

QnStatus
qn_limit_fall (const QnLimitProblem *limit, bool (*go_on) (void *user_data),
               void *user_data, double *v, bool *proved, QnDiag *diag)
{
  QnCollapse engine = { 0 };
  QnIpProblem fall = limit->ip;
  size_t blocks = limit->block_count, group_count = (size_t) fall.group_count,
         cell_count = (size_t) fall.cell_count;
  /* Copies with room for two more cells per block: the imbalance, as an unlimited force and moment on the
   * block with a quadratic price. */
  QnPool pool = { 0 };
  QnIpGroup *groups = qn_pool_alloc (&pool, group_count + blocks, sizeof *groups);
  QnIpCell *cells = qn_pool_alloc (&pool, cell_count + 2 * blocks, sizeof *cells);

  *proved = false;
  if (pool.failed) {
    qn_pool_clear (&pool);
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
  QnStatus status = qn_collapse_init (&engine, &fall, diag);
  if (!status) {
    qn_collapse_start_elastic (&engine);
    if (qn_collapse_follow (&engine, FALL_TOLERANCE, QN_COLLAPSE_BUDGET, go_on, user_data)
        == QN_COLLAPSE_FOUND) {
      memcpy (v, engine.at.v, (size_t) limit->ip.row_count * sizeof *v);
      *proved = qn_collapse_proves_infeasible (&engine, &limit->ip);
    }
  }
  qn_collapse_clear (&engine);
  qn_pool_clear (&pool);
  return status;
}
