#include "core/limit/limit-problem.h"

#include <math.h>

/* Scaled mass of a block without weight. */
#define LEAST_MASS 1e-3

/* A pair has two springs, one on each block's side. */
enum { MOST_CONES = 2 * QN_STRENGTH_ROWS, MOST_BOUNDS = 2 * MOST_CONES + 2 };

/* What the springs of a pair allow together. */
typedef struct Strength {
  QnStrengthRow cones[MOST_CONES]; /* the rows that limit shear */
  int cone_count;
  double tension,
    compression; /* largest normal forces, INFINITY where there is no limit */
} Strength;

/* The apex of a cone bounds tension as a cut-off does. */
static void
restrict_by_spring (Strength *strength, const QnSpring *spring)
{
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  int count = qn_spring_rigid_strength (spring, rows);

  for (const QnStrengthRow *row = rows; row < rows + count; row++) {
    if (row->shear > 0) {
      strength->cones[strength->cone_count++] = *row;
    } else if (row->normal > 0) {
      strength->tension = fmin (strength->tension, row->limit);
    } else {
      strength->compression = fmin (strength->compression, row->limit);
    }
  }
}

/* All rows of both springs, but those of one law once. */
static Strength
pair_strength (const QnModel *model, const QnContacts *contacts, QnId pair)
{
  QnPairSprings springs = qn_contacts_pair_springs (model, contacts, (size_t) pair);
  Strength strength = { .tension = INFINITY, .compression = INFINITY };

  restrict_by_spring (&strength, &springs.a);
  if (!springs.equal)
    restrict_by_spring (&strength, &springs.b);
  return strength;
}

/* Writes the rows of a cell and returns their number. Where the apex of a cone implies the cut-off, this is
 * a row all the same if it flows otherwise. */
static int32_t
write_bounds (const QnLimitProblem *limit, const Strength *strength, QnIpCell *cell,
              QnIpBound *bounds)
{
  int32_t count = 0;
  bool cut_off = isfinite (strength->tension);

  cell->no_shear = false;
  for (int i = 0; i < strength->cone_count; i++) {
    const QnStrengthRow *cone = &strength->cones[i];
    double norm = hypot (cone->normal, 1.0);
    double cohesion = cone->limit / limit->force_unit;

    if (cone->normal == 0.0 && cone->limit == 0.0)
      cell->no_shear = true;
    if (!limit->own_flow && cone->normal > 0.0
        && cone->limit <= cone->normal * strength->tension)
      cut_off = false;
    for (int sign = -1; sign <= 1; sign += 2)
      bounds[count++] =
        (QnIpBound){ cone->normal / norm, sign / norm, cohesion / norm,
                     (limit->own_flow ? cone->opening : cone->normal) / norm };
  }
  if (cell->no_shear) {
    count = 0;
    cut_off = true;
  }
  if (cut_off)
    bounds[count++] = (QnIpBound){ 1.0, 0.0, strength->tension / limit->force_unit, 1.0 };
  if (isfinite (strength->compression))
    bounds[count++] =
      (QnIpBound){ -1.0, 0.0, strength->compression / limit->force_unit, -1.0 };
  return count;
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
      limit->constant[limit->rows[i]] = dead[i] / limit->force_unit;
      limit->load[limit->rows[i]] = live[i] / limit->load_unit;
    }
  return limit->load_unit > 0.0
           ? QN_OK
           : qn_refuse (diag, QN_PROBLEM_NO_LIVE_LOAD, QN_ENTITY_MODEL, QN_NONE);
}

/* Weights stand for masses; a weightless block has the little that keeps its motion finite. */
static void
fill_masses (QnLimitProblem *limit, const QnModel *model)
{
  for (size_t b = 0; b < model->block_count; b++) {
    const QnBlock *block = &model->blocks[b];
    double mass = fmax (block->weight / limit->force_unit, LEAST_MASS);
    double radius = sqrt (block->polar_moment / block->area) / limit->length_unit;
    double *out = limit->mass + b * QN_DOF_COUNT;
    out[QN_DOF_UX] = out[QN_DOF_UY] = mass;
    out[QN_DOF_RZ] = mass * radius * radius;
  }
}

/* Resultant on block `id` of a unit force along `axis` at `point`, lengths scaled. */
static void
map_force (const QnModel *model, QnId id, QnVec2 point, QnVec2 axis, double sign,
           double length_unit, int column, double (*map)[2])
{
  QnVec2 arm = qn_vec2_sub (point, model->blocks[id].centroid);

  map[QN_DOF_UX][column] = sign * axis.x;
  map[QN_DOF_UY][column] = sign * axis.y;
  map[QN_DOF_RZ][column] = sign * qn_vec2_cross (arm, axis) / length_unit;
}

/* Groups, cells and bounds of all faces that touch a free degree of freedom. */
static void
fill_faces (QnLimitProblem *limit, const QnModel *model, const QnContacts *contacts)
{
  QnIpProblem *ip = &limit->ip;

  for (size_t f = 0; f < contacts->face_count; f++) {
    const QnContactFace *face = &contacts->faces[f];
    QnIpGroup group = { .first_cell = ip->cell_count, .cell_count = face->pair_count };
    bool free_row = false;

    for (int d = 0; d < QN_DOF_COUNT; d++) {
      group.rows[d] = limit->rows[face->a * QN_DOF_COUNT + d];
      group.rows[QN_DOF_COUNT + d] = limit->rows[face->b * QN_DOF_COUNT + d];
      free_row |= group.rows[d] >= 0 || group.rows[QN_DOF_COUNT + d] >= 0;
    }
    if (!free_row)
      continue;
    limit->groups[ip->group_count++] = group;
    for (QnId p = face->first_pair; p < face->first_pair + face->pair_count; p++) {
      QnIpCell *cell = &limit->cells[ip->cell_count];
      Strength strength = pair_strength (model, contacts, p);

      QnVec2 point = contacts->pairs[p].point;
      double (*on_b)[2] = cell->map + QN_DOF_COUNT;

      map_force (model, face->a, point, face->normal, 1.0, limit->length_unit, 0,
                 cell->map);
      map_force (model, face->a, point, face->tangent, 1.0, limit->length_unit, 1,
                 cell->map);
      map_force (model, face->b, point, face->normal, -1.0, limit->length_unit, 0, on_b);
      map_force (model, face->b, point, face->tangent, -1.0, limit->length_unit, 1, on_b);
      cell->first_bound = ip->bound_count;
      cell->bound_count =
        write_bounds (limit, &strength, cell, limit->bounds + ip->bound_count);
      ip->bound_count += cell->bound_count;
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
    QnIpGroup group = { .first_cell = ip->cell_count, .cell_count = 1 };
    QnIpCell cell = { .first_bound = ip->bound_count, .no_shear = true };
    QnVec2 axis = qn_vec2_scale (1 / qn_tie_length (tie),
                                 qn_vec2_sub (tie->ends[1].at, tie->ends[0].at));
    double strength = qn_tie_strength (tie) / limit->force_unit;
    bool free_row = false;

    for (int end = 0; end < 2; end++) {
      QnId block = tie->ends[end].block;
      int32_t *rows = group.rows + QN_DOF_COUNT * end;
      for (int d = 0; d < QN_DOF_COUNT; d++) {
        rows[d] = block == QN_NONE ? -1 : limit->rows[block * QN_DOF_COUNT + d];
        free_row |= rows[d] >= 0;
      }
      if (block != QN_NONE)
        map_force (model, block, tie->ends[end].at, axis, end == 0 ? 1.0 : -1.0,
                   limit->length_unit, 0, cell.map + QN_DOF_COUNT * end);
    }
    if (!free_row)
      continue;
    limit->bounds[ip->bound_count++] = (QnIpBound){ -1.0, 0.0, 0.0, -1.0 };
    if (isfinite (strength))
      limit->bounds[ip->bound_count++] = (QnIpBound){ 1.0, 0.0, strength, 1.0 };
    cell.bound_count = ip->bound_count - cell.first_bound;
    limit->groups[ip->group_count++] = group;
    limit->cell_pairs[ip->cell_count] = (QnId) (contacts->pair_count + i);
    limit->cells[ip->cell_count++] = cell;
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
  QnPool *pool = &limit->pool;
  size_t dofs = model->block_count * QN_DOF_COUNT;
  limit->rows = qn_pool_alloc (pool, dofs, sizeof *limit->rows);
  limit->mass = qn_pool_alloc (pool, dofs, sizeof *limit->mass);
  limit->constant = qn_pool_alloc (pool, dofs, sizeof *limit->constant);
  limit->load = qn_pool_alloc (pool, dofs, sizeof *limit->load);
  limit->groups = qn_pool_alloc (pool, contacts->face_count + qn_model_tie_count (model),
                                 sizeof *limit->groups);
  limit->cells = qn_pool_alloc (pool, limit->pair_count, sizeof *limit->cells);
  limit->cell_pairs = qn_pool_alloc (pool, limit->pair_count, sizeof *limit->cell_pairs);
  limit->bounds =
    qn_pool_alloc (pool, limit->pair_count * MOST_BOUNDS, sizeof *limit->bounds);
  double *dead = qn_pool_alloc (pool, dofs, sizeof *dead),
         *live = qn_pool_alloc (pool, dofs, sizeof *live);
  for (size_t i = 0; !pool->failed && i < dofs; i++)
    limit->rows[i] = model->blocks[i / QN_DOF_COUNT].support[i % QN_DOF_COUNT]
                       ? -1
                       : limit->ip.row_count++;
  limit->ip.workers = model->analysis.workers;
  status = pool->failed ? qn_diag_no_memory (diag)
                        : scale_loads (limit, model, dead, live, diag);
  if (status) {
    qn_limit_problem_clear (limit);
    return status;
  }
  fill_masses (limit, model);
  fill_faces (limit, model, contacts);
  fill_ties (limit, model, contacts);
  limit->ip.groups = limit->groups;
  limit->ip.cells = limit->cells;
  limit->ip.bounds = limit->bounds;
  limit->ip.constant = limit->constant;
  limit->ip.load = limit->load;
  for (int32_t r = 0; r < limit->ip.row_count; r++)
    limit->ip.load_gain += fabs (limit->load[r]);
  return QN_OK;
}

void
qn_limit_problem_clear (QnLimitProblem *limit)
{
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
