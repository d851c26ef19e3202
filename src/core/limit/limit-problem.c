#include "core/limit/limit-problem.h"

#include <math.h>

/* Scaled mass of a block without weight. */
#define LEAST_MASS 1e-3

/* Two springs, on one block's side each, with rows that limit shear both ways; tension and compression. */
enum { MOST_BOUNDS = 4 * QN_STRENGTH_ROWS + 2 };

static void
write_bound (QnIpProblem *ip, double normal, double shear, double limit, double opening)
{
  ip->bounds[ip->bound_count++] = (QnIpBound){ normal, shear, limit, opening };
}

/* What the springs of a pair allow together. The apex of a cone bounds tension as a cut-off does; where it
 * implies the cut-off, this is a row all the same if it flows otherwise. */
static void
write_bounds (QnLimitProblem *limit, const QnPairSprings *springs, bool *no_shear)
{
  QnIpProblem *ip = &limit->ip;
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  int count = qn_pair_rigid_strength (springs, rows);
  double tension = INFINITY, compression = INFINITY;

  *no_shear = false;
  for (const QnStrengthRow *row = rows; row < rows + count; row++)
    if (row->shear > 0)
      *no_shear |= row->normal == 0.0 && row->limit == 0.0;
    else if (row->normal > 0)
      tension = fmin (tension, row->limit);
    else
      compression = fmin (compression, row->limit);
  bool cut_off = *no_shear || isfinite (tension);
  for (const QnStrengthRow *cone = rows; cone < rows + count && !*no_shear; cone++) {
    double norm = hypot (cone->normal, 1.0), cohesion = cone->limit / limit->force_unit;
    if (cone->shear <= 0)
      continue;
    if (!limit->own_flow && cone->normal > 0.0 && cone->limit <= cone->normal * tension)
      cut_off = false;
    for (int sign = -1; sign <= 1; sign += 2)
      write_bound (ip, cone->normal / norm, sign / norm, cohesion / norm,
                   (limit->own_flow ? cone->opening : cone->normal) / norm);
  }
  if (cut_off)
    write_bound (ip, 1.0, 0.0, tension / limit->force_unit, 1.0);
  if (isfinite (compression))
    write_bound (ip, -1.0, 0.0, compression / limit->force_unit, -1.0);
}

/* Root mean square of the entries that are not zero, 0 if all are. */
static double
typical_size (const double *values, const int32_t *rows, size_t count)
{
  double sum = 0.0;
  size_t n = 0;

  for (size_t i = 0; i < count; i++)
    if (rows[i] >= 0 && values[i] != 0.0) {
      sum += values[i] * values[i];
      n++;
    }
  return n > 0 ? sqrt (sum / (double) n) : 0.0;
}

/* dead, live: scratch, block_count x 3. */
static QnStatus
scale_loads (QnLimitProblem *limit, const QnModel *model, double *dead, double *live,
             QnDiag *diag)
{
  size_t count = model->block_count * QN_DOF_COUNT;

  qn_model_set_forces (model, NULL, dead);
  qn_model_live_forces (model, live);
  for (size_t i = QN_DOF_RZ; i < count; i += QN_DOF_COUNT) {
    dead[i] /= limit->length_unit;
    live[i] /= limit->length_unit;
  }
  limit->force_unit = typical_size (dead, limit->rows, count);
  limit->load_unit = typical_size (live, limit->rows, count);
  if (limit->force_unit == 0.0)
    limit->force_unit = limit->load_unit;
  for (size_t i = 0; i < count && limit->load_unit > 0.0; i++)
    if (limit->rows[i] >= 0) {
      limit->ip.constant[limit->rows[i]] = dead[i] / limit->force_unit;
      limit->ip.load[limit->rows[i]] = live[i] / limit->load_unit;
    }
  return limit->load_unit > 0.0
           ? QN_OK
           : qn_refuse (diag, QN_PROBLEM_NO_LIVE_LOAD, QN_ENTITY_MODEL, QN_NONE);
}

/* Resultant on block `id` (QN_NONE: the ground) of a unit force along `axis` at `point`, lengths scaled. */
static void
map_force (const QnLimitProblem *limit, const QnModel *model, QnId id, QnVec2 point,
           QnVec2 axis, double sign, int column, double (*map)[2])
{
  if (id == QN_NONE)
    return;
  QnVec2 arm = qn_vec2_sub (point, model->blocks[id].centroid);

  map[QN_DOF_UX][column] = sign * axis.x;
  map[QN_DOF_UY][column] = sign * axis.y;
  map[QN_DOF_RZ][column] = sign * qn_vec2_cross (arm, axis) / limit->length_unit;
}

/* Begins a group between two blocks (QN_NONE: the ground), unless neither has a free degree of freedom. */
static bool
open_group (QnLimitProblem *limit, const QnId blocks[2], int32_t cell_count)
{
  QnIpProblem *ip = &limit->ip;
  QnIpGroup *group = &ip->groups[ip->group_count];
  bool free_row = false;

  *group = (QnIpGroup){ .first_cell = ip->cell_count, .cell_count = cell_count };
  for (int i = 0; i < QN_IP_GROUP_ROWS; i++) {
    QnId block = blocks[i / QN_DOF_COUNT];
    group->rows[i] =
      block == QN_NONE ? -1 : limit->rows[block * QN_DOF_COUNT + i % QN_DOF_COUNT];
    free_row |= group->rows[i] >= 0;
  }
  ip->group_count += free_row;
  return free_row;
}

/* Groups, cells and bounds of all faces that touch a free degree of freedom. */
static void
fill_faces (QnLimitProblem *limit, const QnModel *model, const QnContacts *contacts)
{
  QnIpProblem *ip = &limit->ip;

  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    const QnId blocks[2] = { face->a, face->b };

    if (!open_group (limit, blocks, face->pair_count))
      continue;
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
      QnIpCell *cell = &ip->cells[ip->cell_count];
      QnPairSprings springs = qn_contacts_pair_springs (model, contacts, (size_t) p);
      QnVec2 point = contacts->pairs[p].point;

      for (int side = 0; side < 2; side++) {
        double (*map)[2] = cell->map + QN_DOF_COUNT * side, sign = side == 0 ? 1.0 : -1.0;
        map_force (limit, model, blocks[side], point, face->normal, sign, 0, map);
        map_force (limit, model, blocks[side], point, face->tangent, sign, 1, map);
      }
      cell->first_bound = ip->bound_count;
      write_bounds (limit, &springs, &cell->no_shear);
      cell->bound_count = ip->bound_count - cell->first_bound;
      limit->cell_pairs[ip->cell_count++] = p;
    }
  }
}

/* A group, a cell and its bounds for each tie that pulls at a free degree of freedom. */
static void
fill_ties (QnLimitProblem *limit, const QnModel *model, const QnContacts *contacts)
{
  QnIpProblem *ip = &limit->ip;

  for (size_t i = 0; i < qn_model_tie_count (model); i++) {
    const QnTie *tie = qn_model_tie (model, i);
    const QnId blocks[2] = { tie->ends[0].block, tie->ends[1].block };
    QnIpCell *cell = &ip->cells[ip->cell_count];
    QnVec2 axis = qn_vec2_scale (1 / qn_tie_length (tie),
                                 qn_vec2_sub (tie->ends[1].at, tie->ends[0].at));
    double strength = qn_tie_strength (tie) / limit->force_unit;

    if (!open_group (limit, blocks, 1))
      continue;
    *cell = (QnIpCell){ .first_bound = ip->bound_count, .no_shear = true };
    for (int end = 0; end < 2; end++)
      map_force (limit, model, blocks[end], tie->ends[end].at, axis,
                 end == 0 ? 1.0 : -1.0, 0, cell->map + QN_DOF_COUNT * end);
    write_bound (ip, -1.0, 0.0, 0.0, -1.0);
    if (isfinite (strength))
      write_bound (ip, 1.0, 0.0, strength, 1.0);
    cell->bound_count = ip->bound_count - cell->first_bound;
    limit->cell_pairs[ip->cell_count++] = (QnId) (contacts->pair_count + i);
  }
}

/* The strengths of fibres have no place in the rows of a pair, beams have no pairs at all. */
static QnStatus
check_kinds (const QnModel *model, const QnContacts *contacts, QnDiag *diag)
{
  if (model->node_count > 0)
    return qn_diag_set_field (diag, QN_PROBLEM_BEAMS_WITHOUT_LIMIT, QN_ENTITY_ANALYSIS,
                              QN_NONE, "procedure", 0);
  for (size_t p = 0; p < contacts->pair_count; p++)
    for (int side = 0; side < 2; side++) {
      QnId law = qn_contacts_pair_law (model, contacts, p, side);
      if (!qn_law_has_strength (model->laws[law].kind))
        return qn_diag_set_field (diag, QN_PROBLEM_LAW_WITHOUT_LIMIT, QN_ENTITY_LAW, law,
                                  "kind", 0);
    }
  return QN_OK;
}

QnStatus
qn_limit_problem_init (QnLimitProblem *limit, const QnModel *model,
                       const QnContacts *contacts, bool own_flow, QnDiag *diag)
{
  QnStatus status = check_kinds (model, contacts, diag);

  *limit = (QnLimitProblem){ 0 };
  if (status != QN_OK)
    return status;
  *limit = (QnLimitProblem){
    .block_count = model->block_count,
    .pair_count = contacts->pair_count + qn_model_tie_count (model),
    .length_unit = model->characteristic_length,
    .own_flow = own_flow,
  };
  QnIpProblem *ip = &limit->ip;
  QnPool *pool = &limit->pool;
  size_t dofs = model->block_count * QN_DOF_COUNT;
  limit->rows = qn_pool_alloc (pool, dofs, sizeof *limit->rows);
  limit->mass = qn_pool_alloc (pool, dofs, sizeof *limit->mass);
  limit->cell_pairs = qn_pool_alloc (pool, limit->pair_count, sizeof *limit->cell_pairs);
  ip->constant = qn_pool_alloc (pool, dofs, sizeof *ip->constant);
  ip->load = qn_pool_alloc (pool, dofs, sizeof *ip->load);
  ip->groups = qn_pool_alloc (pool, contacts->face_count + qn_model_tie_count (model),
                              sizeof *ip->groups);
  ip->cells = qn_pool_alloc (pool, limit->pair_count, sizeof *ip->cells);
  ip->bounds = qn_pool_alloc (pool, limit->pair_count * MOST_BOUNDS, sizeof *ip->bounds);
  double *dead = qn_pool_alloc (pool, dofs, sizeof *dead),
         *live = qn_pool_alloc (pool, dofs, sizeof *live);
  for (size_t i = 0; !pool->failed && i < dofs; i++)
    limit->rows[i] =
      model->blocks[i / QN_DOF_COUNT].support[i % QN_DOF_COUNT] ? -1 : ip->row_count++;
  ip->workers = model->analysis.workers;
  status = pool->failed ? qn_diag_no_memory (diag)
                        : scale_loads (limit, model, dead, live, diag);
  if (status) {
    qn_limit_problem_clear (limit);
    return status;
  }
  /* Weights stand for masses; a weightless block has the little that keeps its motion finite. */
  for (size_t b = 0; b < model->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    double mass = fmax (block->weight / limit->force_unit, LEAST_MASS);
    double radius = sqrt (block->polar_moment / block->area) / limit->length_unit;
    double *out = limit->mass + b * QN_DOF_COUNT;
    out[QN_DOF_UX] = out[QN_DOF_UY] = mass;
    out[QN_DOF_RZ] = mass * radius * radius;
  }
  fill_faces (limit, model, contacts);
  fill_ties (limit, model, contacts);
  for (int32_t r = 0; r < ip->row_count; r++)
    ip->load_gain += fabs (ip->load[r]);
  status = qn_collapse_init (&limit->engine, ip, diag);
  if (status)
    qn_limit_problem_clear (limit);
  return status;
}

void
qn_limit_problem_clear (QnLimitProblem *limit)
{
  qn_collapse_clear (&limit->engine);
  qn_pool_clear (&limit->pool);
  *limit = (QnLimitProblem){ 0 };
}

double
qn_limit_problem_multiplier (const QnLimitProblem *limit, double lambda)
{
  return lambda * limit->force_unit / limit->load_unit;
}

void
qn_limit_problem_forces (const QnLimitProblem *limit, const double *y, double per,
                         double *forces)
{
  for (size_t i = 0; i < 2 * limit->pair_count; i++)
    forces[i] = 0.0;
  for (int32_t c = 0; c < limit->ip.cell_count; c++)
    for (int k = 0; k < 2; k++)
      forces[2 * limit->cell_pairs[c] + k] = y[2 * c + k] / per * limit->force_unit;
}

void
qn_limit_problem_velocities (const QnLimitProblem *limit, const double *v,
                             double *velocities)
{
  for (size_t i = 0; i < limit->block_count * QN_DOF_COUNT; i++) {
    double value = limit->rows[i] >= 0 ? v[limit->rows[i]] : 0.0;
    velocities[i] = i % QN_DOF_COUNT == QN_DOF_RZ ? value / limit->length_unit : value;
  }
}
