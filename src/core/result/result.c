#include "core/result/result.h"

#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const qn_outcome_names[QN_OUTCOME_COUNT] = {
  [QN_OUTCOME_COLLAPSE] = "collapse",
  [QN_OUTCOME_TARGET_REACHED] = "target-reached",
  [QN_OUTCOME_SNAP] = "snap",
  [QN_OUTCOME_UNBOUNDED] = "unbounded",
  [QN_OUTCOME_DEAD_LOAD_UNSTABLE] = "dead-load-unstable",
  [QN_OUTCOME_CANCELLED] = "cancelled",
  [QN_OUTCOME_NOT_CONVERGED] = "not-converged",
  [QN_OUTCOME_REST] = "rest",
};

const char *const qn_pair_state_names[QN_PAIR_STATE_COUNT] = {
  [QN_PAIR_STICK] = "stick",
  [QN_PAIR_SLIP] = "slip",
  [QN_PAIR_OPEN] = "open",
  [QN_PAIR_YIELD] = "yield",
};

const char *const qn_event_kind_names[QN_EVENT_KIND_COUNT] = {
  [QN_EVENT_KIND_LOCAL] = "local",
  [QN_EVENT_KIND_SNAP] = "snap",
  [QN_EVENT_KIND_BUCKLING] = "buckling",
  [QN_EVENT_KIND_COLLAPSE] = "collapse",
};

const char *const qn_stability_names[QN_STABILITY_COUNT] = {
  [QN_STABILITY_UNKNOWN] = "unknown",
  [QN_STABILITY_KEPT] = "kept",
  [QN_STABILITY_LOST] = "lost",
};

void
qn_statistics_add (QnStatistics *total, const QnStatistics *part)
{
  total->seconds += part->seconds;
  total->factor_seconds += part->factor_seconds;
  total->assembly_seconds += part->assembly_seconds;
  total->law_seconds += part->law_seconds;
  total->iterations += part->iterations;
  total->factorizations += part->factorizations;
  total->factorization_work += part->factorization_work;
  if (part->peak_memory_bytes > total->peak_memory_bytes)
    total->peak_memory_bytes = part->peak_memory_bytes;
}

void
qn_statistics_clear_timings (QnStatistics *statistics)
{
  statistics->seconds = statistics->factor_seconds = 0;
  statistics->assembly_seconds = statistics->law_seconds = 0;
  statistics->peak_memory_bytes = 0;
}

QnStatus
qn_result_init (QnResult *result, size_t block_count, size_t pair_count, QnDiag *diag)
{
  *result = (QnResult){ .outcome = QN_OUTCOME_NOT_CONVERGED,
                        .block_count = block_count,
                        .pair_count = pair_count };
  result->pairs = qn_alloc (pair_count, sizeof *result->pairs);
  return result->pairs != NULL ? QN_OK : qn_diag_no_memory (diag);
}

void
qn_result_clear (QnResult *result)
{
  qn_result_clear_events (result);
  free (result->steps);
  free (result->displacements);
  free (result->beam_forces);
  free (result->ties);
  free (result->pairs);
  free (result->mechanism);
  free (result->unstable_blocks);
  free (result->supports);
  free (result->reactions);
  free (result->velocities);
  free (result->step_forces);
  free (result->step_states);
  free (result->step_damage);
  free (result->history.rows);
  free (result->history.peaks);
  free (result->found);
  free (result->found_forces);
  free (result->left);
  *result = (QnResult){ 0 };
}

/* Copies a row behind `count` others of the array at `items`. */
static bool
add_row (void *items, size_t *capacity, size_t count, const void *row, size_t length,
         size_t size)
{
  char *all;

  if (!qn_array_reserve (items, capacity, (count + 1) * length, size))
    return false;
  memcpy (&all, items, sizeof all);
  if (length > 0)
    memcpy (all + count * length * size, row, length * size);
  return true;
}

bool
qn_result_add_step (QnResult *result, QnStep step, const double *displacements)
{
  return add_row (&result->displacements, &result->displacement_capacity,
                  result->step_count, displacements,
                  qn_result_body_count (result) * QN_DOF_COUNT, sizeof (double))
         && QN_ARRAY_PUSH (result->steps, result->step_count, result->step_capacity,
                           step);
}

bool
qn_result_add_event (QnResult *result, QnPathEvent event)
{
  if (!QN_ARRAY_PUSH (result->events, result->event_count, result->event_capacity,
                      event)) {
    free (event.blocks);
    return false;
  }
  if (event.kind == QN_EVENT_KIND_SNAP && !result->has_first_limit_multiplier)
    qn_result_set_first_limit (result, event.multiplier);
  return true;
}

void
qn_result_set_first_limit (QnResult *result, double multiplier)
{
  result->has_first_limit_multiplier = true;
  result->first_limit_multiplier = multiplier;
}

void
qn_result_add_solution (QnResult *result, QnSolution solution)
{
  if (result->solution_count < QN_RESULT_SOLUTIONS)
    result->solutions[result->solution_count++] = solution;
}

void
qn_result_collapse_interval (const QnResult *result, double *least, QnProcedure *found_by,
                             double *bound)
{
  *least = NAN;
  for (int32_t i = 0; i < result->solution_count; i++)
    if (!(result->solutions[i].multiplier >= *least)) {
      *least = result->solutions[i].multiplier;
      *found_by = result->solutions[i].found_by;
    }
  *bound = result->has_associative_bound ? result->associative_bound : NAN;
}

void
qn_result_clear_collapse (QnResult *result)
{
  result->has_collapse_multiplier = result->has_first_limit_multiplier = false;
  result->mechanism_uncertain = result->mechanism_by_work = false;
  result->solution_count = 0;
  free (result->mechanism);
  result->mechanism = NULL;
}

void
qn_result_clear_events (QnResult *result)
{
  for (size_t i = 0; i < result->event_count; i++)
    free (result->events[i].blocks);
  free (result->events);
  result->events = NULL;
  result->event_count = result->event_capacity = 0;
  result->has_first_limit_multiplier = false;
}

bool
qn_result_set_supports (QnResult *result, const QnModel *model)
{
  size_t count = 0;

  for (size_t b = 0; b < model->block_count; b++)
    count += qn_support_is_any (model->blocks[b].support);
  result->supports = qn_alloc (count, sizeof *result->supports);
  if (result->supports == NULL)
    return false;
  for (size_t b = 0; b < model->block_count; b++)
    if (qn_support_is_any (model->blocks[b].support))
      result->supports[result->support_count++] = (QnId) b;
  return true;
}

bool
qn_result_add_reactions (QnResult *result, const double *reactions)
{
  size_t row = result->support_count * QN_DOF_COUNT;
  if (!qn_array_reserve (&result->reactions, &result->reaction_capacity,
                         result->step_count * row, sizeof *result->reactions))
    return false;

  double *last = result->reactions + (result->step_count - 1) * row;
  for (size_t s = 0; s < result->support_count; s++)
    memcpy (last + s * QN_DOF_COUNT, reactions + result->supports[s] * QN_DOF_COUNT,
            QN_DOF_COUNT * sizeof *last);
  return true;
}

bool
qn_result_add_velocities (QnResult *result, const double *velocities)
{
  return add_row (&result->velocities, &result->velocity_capacity, result->step_count - 1,
                  velocities, qn_result_body_count (result) * QN_DOF_COUNT,
                  sizeof (double));
}

/* The damage of all bonds at the last step; of those before there is none until there is some. */
static bool
add_damage (QnResult *result)
{
  size_t row = result->pair_count, last = (result->step_count - 1) * row;
  bool damaged = result->step_damage != NULL;

  for (size_t p = 0; p < row; p++)
    damaged |= result->pairs[p].damage > 0;
  if (!damaged)
    return true;
  bool first = result->step_damage == NULL;
  if (!qn_array_reserve (&result->step_damage, &result->step_damage_capacity, last + row,
                         sizeof *result->step_damage))
    return false;
  if (first)
    memset (result->step_damage, 0, last * sizeof *result->step_damage);
  for (size_t p = 0; p < row; p++)
    result->step_damage[last + p] = result->pairs[p].damage;
  return true;
}

bool
qn_result_add_forces (QnResult *result, bool all)
{
  size_t row = result->pair_count, last = (result->step_count - 1) * row;

  if (!all && result->step_count * row > QN_RESULT_FORCE_BUDGET) {
    free (result->step_forces);
    free (result->step_states);
    free (result->step_damage);
    result->step_forces = result->step_damage = NULL;
    result->step_states = NULL;
    result->step_force_capacity = result->step_state_capacity = 0;
    result->step_damage_capacity = 0;
    result->forces_dropped = true;
  }
  if (result->forces_dropped)
    return true;
  if (!qn_array_reserve (&result->step_forces, &result->step_force_capacity,
                         2 * (last + row), sizeof *result->step_forces))
    return false;
  if (!qn_array_reserve (&result->step_states, &result->step_state_capacity, last + row,
                         sizeof *result->step_states))
    return false;

  for (size_t p = 0; p < row; p++) {
    result->step_forces[2 * (last + p)] = result->pairs[p].normal_force;
    result->step_forces[2 * (last + p) + 1] = result->pairs[p].shear_force;
    result->step_states[last + p] = (uint8_t) result->pairs[p].state;
  }
  return add_damage (result);
}

const char *const qn_energy_names[QN_ENERGY_KIND_COUNT] = {
  [QN_ENERGY_INPUT] = "input",     [QN_ENERGY_KINETIC] = "kinetic",
  [QN_ENERGY_ELASTIC] = "elastic", [QN_ENERGY_FRICTION] = "friction",
  [QN_ENERGY_DAMPING] = "damping", [QN_ENERGY_NUMERICAL] = "numerical",
};

bool
qn_result_add_found (QnResult *result, QnFound found)
{
  return QN_ARRAY_PUSH (result->found, result->found_count, result->found_capacity,
                        found);
}

bool
qn_result_add_found_force (QnResult *result, QnFoundForce force)
{
  return QN_ARRAY_PUSH (result->found_forces, result->found_force_count,
                        result->found_force_capacity, force);
}

bool
qn_result_add_left (QnResult *result, QnLeftFace left)
{
  return QN_ARRAY_PUSH (result->left, result->left_count, result->left_capacity, left);
}

bool
qn_result_add_history (QnResult *result, const double *row)
{
  QnHistory *history = &result->history;
  bool added = add_row (&history->rows, &history->capacity, history->row_count, row,
                        history->width, sizeof (double));

  history->row_count += added;
  return added;
}

bool
qn_result_has_forces (const QnResult *result, size_t step)
{
  return step < result->step_count && result->pairs != NULL
         && (step + 1 == result->step_count || result->step_forces != NULL);
}

QnPairResult
qn_result_pair_at (const QnResult *result, size_t step, size_t pair)
{
  QN_ASSERT (qn_result_has_forces (result, step) && pair < result->pair_count);
  if (step + 1 == result->step_count)
    return result->pairs[pair];
  size_t at = step * result->pair_count + pair;
  return (QnPairResult){ .state = (QnPairState) result->step_states[at],
                         .normal_force = result->step_forces[2 * at],
                         .shear_force = result->step_forces[2 * at + 1],
                         .damage =
                           result->step_damage != NULL ? result->step_damage[at] : 0 };
}

void
qn_result_keep_steps (QnResult *result, size_t count)
{
  result->step_count = count;
  while (result->found_force_count > 0
         && (size_t) result->found_forces[result->found_force_count - 1].step >= count)
    result->found_force_count--;
  while (result->found_count > 0
         && result->found[result->found_count - 1].time >= (double) count)
    result->found_count--;
  while (result->left_count > 0
         && result->left[result->left_count - 1].time >= (double) count)
    result->left_count--;
}

void
qn_result_load_factors (const QnModel *model, const QnResult *result, size_t step,
                        double *factors)
{
  memset (factors, 0, QN_MAX_LOAD_SETS * sizeof *factors);
  if (model->stage_count == 0) {
    factors[0] = result->steps[step].multiplier;
    return;
  }
  for (size_t s = 0; s <= step; s++) {
    int32_t stage = result->steps[s].stage;
    if (stage < 1 || (size_t) stage > model->stage_count)
      continue;
    for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
      if ((model->stages[stage - 1].sets >> set & 1) != 0)
        factors[set] = result->steps[s].multiplier;
  }
}

bool
qn_result_add_beam_forces (QnResult *result, const QnBeamForces *forces)
{
  return add_row (&result->beam_forces, &result->beam_force_capacity,
                  result->step_count - 1, forces, result->element_count, sizeof *forces);
}

bool
qn_result_add_ties (QnResult *result, const QnTieResult *ties)
{
  QN_ASSERT (result->step_count > 0);
  size_t count = result->tie_count, end = result->step_count * count;
  if (!qn_array_reserve (&result->ties, &result->tie_capacity, end, sizeof *result->ties))
    return false;
  for (size_t i = 0; i < count; i++)
    result->ties[end - count + i] =
      ties != NULL ? ties[i] : (QnTieResult){ .force = NAN, .elongation = NAN };
  return true;
}

QnStatus
qn_result_set_mechanism (QnResult *result, const double *velocities,
                         double characteristic_length, QnDiag *diag)
{
  size_t count = qn_result_body_count (result) * QN_DOF_COUNT;
  double *mechanism = qn_alloc (count, sizeof *mechanism), translation = 0, rotation = 0;

  if (mechanism == NULL)
    return qn_diag_no_memory (diag);
  for (size_t b = 0; b < qn_result_body_count (result); b++) {
    const double *v = velocities + QN_DOF_COUNT * b;
    translation = fmax (translation, hypot (v[QN_DOF_UX], v[QN_DOF_UY]));
    rotation = fmax (rotation, fabs (v[QN_DOF_RZ]) * characteristic_length);
  }
  /* Blocks that only turn about their centroids have no displacement to scale by. */
  double largest = translation > 1e-6 * rotation ? translation : rotation;
  for (size_t i = 0; i < count; i++)
    mechanism[i] = largest > 0 ? velocities[i] / largest : 0;

  free (result->mechanism);
  result->mechanism = mechanism;
  return QN_OK;
}

/* A block and how fast it moves, for a stable order by index among equals. */
typedef struct {
  double speed;
  QnId block;
} Mover;

static int
compare_movers (const void *a, const void *b)
{
  const Mover *one = a, *other = b;

  if (one->speed != other->speed)
    return one->speed > other->speed ? -1 : 1;
  return one->block - other->block;
}

QnStatus
qn_result_name_unstable (QnResult *result, double length, bool rigid, QnDiag *diag)
{
  size_t count = result->block_count;
  Mover *movers = qn_alloc (count, sizeof *movers);

  result->unstable_blocks = qn_alloc (count, sizeof *result->unstable_blocks);
  if (movers == NULL || result->unstable_blocks == NULL) {
    free (movers);
    return qn_diag_no_memory (diag);
  }
  for (size_t b = 0; b < count; b++) {
    const double *v = result->mechanism + QN_DOF_COUNT * b;
    double shift = hypot (v[QN_DOF_UX], v[QN_DOF_UY]),
           turn = fabs (v[QN_DOF_RZ]) * length;
    movers[b] = (Mover){ rigid ? hypot (shift, turn) : fmax (shift, turn), (QnId) b };
  }
  qsort (movers, count, sizeof *movers, compare_movers);
  for (size_t b = 0; b < count && movers[0].speed > 0; b++)
    if (rigid ? movers[b].speed > QN_UNSTABLE_RIGID * movers[0].speed
              : movers[b].speed >= QN_UNSTABLE_SHARE * movers[0].speed)
      result->unstable_blocks[result->unstable_count++] = movers[b].block;
  free (movers);
  return QN_OK;
}

/* --- Losses of stability that reports mention ------------------------------------------------ */

#define FELT 1e-3 /* of the collapse multiplier */
#define SAME 1e-9 /* numbers that stand in a result twice */

static bool
is_felt_at (const QnResult *result, double multiplier)
{
  return !(result->has_collapse_multiplier
           && fabs (multiplier) < FELT * fabs (result->collapse_multiplier));
}

bool
qn_result_has_felt_limit (const QnResult *result)
{
  return result->has_first_limit_multiplier
         && is_felt_at (result, result->first_limit_multiplier);
}

bool
qn_result_is_felt (const QnResult *result, const QnPathEvent *event)
{
  return event->kind != QN_EVENT_KIND_LOCAL && is_felt_at (result, event->multiplier);
}

const QnPathEvent *
qn_result_find_buckling (const QnResult *result)
{
  for (size_t i = 0; i < result->event_count; i++)
    if (result->events[i].kind == QN_EVENT_KIND_BUCKLING)
      return &result->events[i];
  return NULL;
}

ptrdiff_t
qn_result_buckling_step (const QnResult *result, const QnPathEvent *event)
{
  double at = event->multiplier;

  for (size_t s = 0; s < result->step_count; s++)
    if (result->steps[s].stage == event->stage
        && fabs (result->steps[s].multiplier - at) <= SAME * fabs (at))
      return (ptrdiff_t) s;
  return -1;
}
