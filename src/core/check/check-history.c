/* What an analysis in time keeps: energies, peaks, tracks. */
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/dynamics/dynamics.h"
#include "core/dynamics/ground.h"
#include "core/dynamics/pair-motion.h"

#include <math.h>
#include <string.h>

/* Steps and rows of the history that fall together, in lengths of a row. */
#define SAME_TIME 1e-6

/* INPUT = the sum of the others, to within the error that is told. */
static void
check_energy (QnCheck *check)
{
  const QnHistory *h = &check->result->history;
  double most = 0, worst = 0;
  size_t at = 0;

  for (size_t i = 0; i < h->row_count; i++) {
    const double *energy = h->rows + i * h->width + QN_HISTORY_ENERGY;
    double left = energy[QN_ENERGY_INPUT];
    for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
      left -= energy[kind];
    most = fmax (most, fabs (energy[QN_ENERGY_INPUT]));
    if (fabs (left) > worst) {
      worst = fabs (left);
      at = i;
    }
  }
  /* The largest input may lie between two rows. */
  if (!(worst <= 2 * h->energy_error * most + QN_CHECK_TOLERANCE * most))
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) at, QN_ENTITY_ANALYSIS, QN_NONE, worst,
                   h->energy_error * most);
}

/* How far the motion was followed, when it collapsed, and what its steps were like. */
static void
check_scalars (QnCheck *check)
{
  const QnResult *r = check->result;
  const QnHistory *h = &r->history;
  double last = r->steps[r->step_count - 1].time, residual = 0;
  double little = SAME_TIME * fmax (last, check->model->analysis.dynamic.time_step);
  bool is_true = qn_check_agrees (h->end, last, little) && h->steps >= 0
                 && h->rejected >= 0 && h->largest_slip >= 0
                 && (h->row_count == 0 || (double) h->steps >= (double) h->row_count - 1)
                 && h->steps * h->shortest_step <= last + little
                 && (h->steps == 0 || h->shortest_step > 0);

  for (size_t i = 1; i < r->step_count; i++)
    residual = qn_worse (residual, r->steps[i].residual);
  is_true = is_true && residual <= h->largest_residual * (1 + QN_CHECK_EXACT);
  if (!isnan (h->peak_time))
    is_true = is_true && h->peak_time >= 0 && h->peak_time <= last + little;
  if (r->outcome == QN_OUTCOME_COLLAPSE) /* what falls may be followed on */
    is_true = is_true && h->collapse_time <= last + little
              && h->collapse_time >= h->shortest_step * (1 - SAME_TIME)
              && (check->model->analysis.dynamic.fall
                  || qn_check_agrees (h->collapse_time, last, little));
  if (!is_true)
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_ANALYSIS, QN_NONE, h->end,
                   last);
}

/* Tracks are the displacements of the steps at the same times; the ground moves as the model says. */
static void
check_rows (QnCheck *check, const QnGround *ground)
{
  const QnResult *r = check->result;
  const QnHistory *h = &r->history;
  const QnModel *model = check->model;
  const QnDynamicSettings *settings = &model->analysis.dynamic;
  double duration = qn_model_duration (model);
  double apart = duration / fmax (ceil (duration / settings->time_step - 1e-9), 1);
  size_t step = 0;

  for (size_t i = 0; i < h->row_count; i++) {
    const double *row = h->rows + i * h->width;
    double time = row[QN_HISTORY_TIME];
    QnVec2 moved = qn_ground_acceleration (ground, time);
    double size = 1e-6 * (1 + hypot (moved.x, moved.y));
    /* A row for every multiple of the step, and one where the motion ends. */
    bool in_place = i + 1 == h->row_count
                      ? time <= h->end + SAME_TIME * apart
                      : qn_check_agrees (time, (double) i * apart, SAME_TIME * apart);
    if ((i > 0 && !(time > row[QN_HISTORY_TIME - (ptrdiff_t) h->width])) || !in_place
        || !qn_check_agrees (row[QN_HISTORY_GROUND_X], moved.x, size)
        || !qn_check_agrees (row[QN_HISTORY_GROUND_Y], moved.y, size))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_GROUND_MOTION, QN_NONE,
                     row[QN_HISTORY_GROUND_X], moved.x);
    while (step + 1 < r->step_count
           && (step == 0 || r->steps[step].time < time - SAME_TIME * apart))
      step++;
    if (i == 0 || fabs (r->steps[step].time - time) > SAME_TIME * apart)
      continue;
    const double *u = qn_result_step_displacements (r, step);
    for (size_t t = 0; t < model->track_count; t++) {
      const QnTrack *track = &model->tracks[t];
      double at = u[QN_DOF_COUNT * track->block + (int) track->dof];
      if (!qn_check_agrees (row[QN_HISTORY_TRACK + t], at,
                            QN_CHECK_EXACT * (1 + fabs (at))))
        qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_TRACK, (QnId) t,
                       row[QN_HISTORY_TRACK + t], at);
    }
  }
}

/* Row of the history at the time of a step; NULL where none is. Of two steps at the start the second has
 * the initial motion. */
static const double *
find_row (const QnCheck *check, size_t step)
{
  const QnHistory *h = &check->result->history;
  double time = check->result->steps[step].time;
  double apart = h->row_count > 1 ? h->rows[h->width] - h->rows[0] : 1;
  double place = apart > 0 && h->row_count > 0 ? rint (time / apart) : -1;

  if ((step == 0 && check->model->initial_count > 0)
      || !(place >= 0 && place < (double) h->row_count))
    return NULL;
  const double *row = h->rows + (size_t) place * h->width;
  return fabs (row[QN_HISTORY_TIME] - time) <= SAME_TIME * apart ? row : NULL;
}

/* Unknowns from the velocities of bodies; supports have none, and nodes on blocks ride with them. */
static void
gather_velocity (QnCheck *check, size_t step)
{
  const QnAssembly *as = &check->assembly;
  const QnResult *r = check->result;
  size_t count = qn_result_body_count (r) * QN_DOF_COUNT;
  const double *stated = r->velocities + step * count;

  memset (check->velocity, 0, (size_t) as->unknown_count * sizeof *check->velocity);
  qn_check_gather (as, stated, check->velocity);
  qn_assembly_expand_rates (as, check->u, check->velocity, check->rows);
  double largest = qn_largest (check->rows, count);
  for (size_t i = 0; i < count; i++)
    if (!qn_check_agrees (stated[i], check->rows[i], QN_CHECK_EXACT * largest))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                     stated[i], check->rows[i]);
}

static double
kinetic_energy (QnCheck *check)
{
  const QnAssembly *as = &check->assembly;
  double sum = 0;

  qn_assembly_multiply (as, check->mass, check->velocity, check->residual);
  for (int32_t i = 0; i < as->unknown_count; i++)
    sum += 0.5 * check->velocity[i] * check->residual[i];
  return sum;
}

static double
elastic_energy (const QnCheck *check)
{
  const QnAssembly *as = &check->assembly;
  double sum = 0;

  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairElasticity pair = qn_pair_elasticity (&as->springs[p]);
    QnPairInstant at = { .q = { as->elongations[2 * p], as->elongations[2 * p + 1] },
                         .response = &as->responses[p] };
    sum += qn_pair_elastic_energy (&pair, &at);
  }
  for (size_t b = check->model->element_count; b < as->beams.count; b++) { /* ties */
    double force = as->beams.responses[b].force[0];
    sum += 0.5 * force * force / as->beams.beams[b].properties.axial;
  }
  return sum;
}

/* The ground stands still, and the dead loads are weights, which stay as they are. */
static bool
moves_freely (const QnModel *model)
{
  for (size_t i = 0; i < model->dead_load_count; i++)
    if (model->dead_loads[i].kind != QN_LOAD_WEIGHT)
      return false;
  return model->ground_count == 0;
}

/* From where the motion begins. */
static double
work_of_weights (const QnCheck *check)
{
  const QnAssembly *as = &check->assembly;
  double sum = 0;

  for (int32_t i = 0; i < as->unknown_count; i++)
    sum += as->settles[i] ? 0 : as->dead[i] * (check->u[i] - check->begun[i]);
  return sum;
}

/* Slower than what is called rest, where the outcome says so. */
static void
check_rest (QnCheck *check, size_t step)
{
  const QnModel *model = check->model;
  const QnResult *r = check->result;
  double most = QN_REST_SPEED * sqrt (model->gravity * model->characteristic_length);
  double fastest = qn_largest (check->velocity, (size_t) check->assembly.unknown_count);

  if (r->outcome == QN_OUTCOME_REST && step + 1 == r->step_count
      && !(fastest <= most * (1 + QN_CHECK_EXACT)))
    qn_check_tell (check, QN_CLAIM_OUTCOME, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                   fastest, most);
}

static QnStatus
prepare_motion (QnCheck *check, QnDiag *diag)
{
  const QnAssembly *as = &check->assembly;
  size_t n = (size_t) as->unknown_count;

  check->mass = qn_alloc ((size_t) as->ap[n], sizeof *check->mass);
  check->begun = qn_alloc (n, sizeof *check->begun);
  if (check->mass == NULL || check->begun == NULL)
    return qn_diag_no_memory (diag);
  memcpy (check->begun, check->u, n * sizeof *check->begun);
  return qn_assembly_mass (as, check->mass, diag);
}

/* No joint as drawn that is pressed together has slid further, over its length, than the largest slip. */
static void
check_slip (QnCheck *check, size_t step)
{
  const QnAssembly *as = &check->assembly;
  double stated = check->result->history.largest_slip;

  for (size_t p = 0; p < check->contacts->pair_count; p++) {
    const QnPairMemory *memory = &as->responses[p].memory;
    double length = check->contacts->faces[check->contacts->pairs[p].face].length;
    double slip = fabs (memory->a.slip + memory->b.slip) / length;
    double rounding =
      (QN_CHECK_FORCES * check->scale / as->springs[p].a.ks + check->slack) / length;
    if (as->responses[p].force[0] < 0 && !(slip <= stated + rounding))
      qn_check_tell_pair (check, QN_CLAIM_HISTORY, step, p, stated, slip);
  }
}

/* Kinetic energy by the velocities and masses, elastic energy by the forces, and where the ground stands
 * still the input by the work of the loads. Beams, and contacts found on the way, store energy that is not
 * counted here. */
QnStatus
qn_check_motion (QnCheck *check, size_t step, QnDiag *diag)
{
  const QnResult *r = check->result;
  const double *row = find_row (check, step);
  double largest = 0;

  if (step > 0)
    check_slip (check, step);

  if (r->velocities != NULL) {
    gather_velocity (check, step);
    check_rest (check, step);
  }
  /* The last step may lie between two rows, and the dead load has none. */
  if (row == NULL && step > 0 && step + 1 < r->step_count)
    qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                   r->steps[step].time, NAN);
  if (row == NULL || r->history.width != QN_HISTORY_TRACK + check->model->track_count)
    return QN_OK;
  if (check->mass == NULL) {
    QnStatus status = prepare_motion (check, diag);
    if (status != QN_OK)
      return status;
  }
  const double *energy = row + QN_HISTORY_ENERGY,
               *first = r->history.rows + QN_HISTORY_ENERGY;
  for (size_t i = 0; i < r->history.row_count; i++)
    for (int kind = 0; kind < QN_ENERGY_KIND_COUNT; kind++)
      largest = fmax (largest, fabs (first[i * r->history.width + (size_t) kind]));
  const struct {
    QnEnergyKind kind;
    bool known;
    double found, tolerance;
  } energies[] = {
    { QN_ENERGY_KINETIC, r->velocities != NULL,
      r->velocities != NULL ? kinetic_energy (check) : 0, QN_CHECK_EXACT },
    { QN_ENERGY_ELASTIC,
      check->model->element_count == 0 && r->found_count == 0 && r->left_count == 0,
      elastic_energy (check), QN_CHECK_FORCES },
    { QN_ENERGY_INPUT, moves_freely (check->model),
      first[QN_ENERGY_INPUT] + work_of_weights (check), QN_CHECK_EXACT },
  };
  for (size_t i = 0; i < QN_N_ELEMENTS (energies); i++) {
    double stated = energy[energies[i].kind];
    if (energies[i].known
        && !qn_check_agrees (stated, energies[i].found, energies[i].tolerance * largest))
      qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) step, QN_ENTITY_ANALYSIS, QN_NONE,
                     stated, energies[i].found);
  }
  return QN_OK;
}

/* A block that has turned by a right angle has overturned by then; one that begins like that has once it
 * moves. */
static void
check_overturning (QnCheck *check)
{
  const QnResult *r = check->result;
  const double *start = qn_result_step_displacements (r, 0);
  size_t first = check->model->initial_count > 0 ? 2 : 1;

  for (size_t i = first; r->outcome == QN_OUTCOME_COLLAPSE && i < r->step_count; i++)
    for (size_t b = 0; b < r->block_count; b++) {
      size_t rz = QN_DOF_COUNT * b + QN_DOF_RZ;
      double turned = qn_result_step_displacements (r, i)[rz] - start[rz];
      if (fabs (turned) > QN_OVERTURNED * (1 + QN_CHECK_EXACT)
          && !(r->history.collapse_time <= r->steps[i].time))
        qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_BLOCK, (QnId) b,
                       r->history.collapse_time, r->steps[i].time);
    }
}

/* Where the motion ends with collapse, its mechanism is its last motion. */
static void
check_last_motion (QnCheck *check)
{
  const QnResult *r = check->result;
  size_t count = qn_result_body_count (r) * QN_DOF_COUNT, last = r->step_count - 1;
  double product = 0, square = 0;

  if (r->outcome != QN_OUTCOME_COLLAPSE || r->velocities == NULL || r->mechanism == NULL
      || r->history.collapse_time < r->steps[last].time)
    return;
  const double *v = r->velocities + last * count;
  for (size_t i = 0; i < count; i++) {
    product += v[i] * r->mechanism[i];
    square += r->mechanism[i] * r->mechanism[i];
  }
  double speed = product / square, none = QN_CHECK_TOLERANCE * qn_largest (v, count);
  for (size_t i = 0; i < count; i++)
    if (!(speed > 0 && qn_check_agrees (speed * r->mechanism[i], v[i], none)))
      qn_check_tell_body (check, QN_CLAIM_FLOW, (QnId) last, i / QN_DOF_COUNT,
                          r->mechanism[i], v[i] / speed);
}

static bool
has_all_records (const QnModel *model)
{
  for (size_t i = 0; i < model->ground_count; i++)
    if (model->ground[i].kind == QN_SIGNAL_RECORD && model->ground[i].point_count < 2)
      return false;
  return true;
}

void
qn_check_history (QnCheck *check)
{
  const QnHistory *h = &check->result->history;
  QnGround ground;

  if (h->width == 0 || check->result->step_count == 0)
    return;
  if (h->width != QN_HISTORY_TRACK + check->model->track_count) {
    qn_check_tell (check, QN_CLAIM_HISTORY, QN_NONE, QN_ENTITY_TRACK, QN_NONE, NAN, NAN);
    return;
  }
  check_scalars (check);
  check_energy (check);
  check_overturning (check);
  check_last_motion (check);
  /* No step has moved further than the peaks say. */
  const QnResult *r = check->result;
  const double *start = qn_result_step_displacements (r, 0);

  for (size_t i = 1; i < r->step_count; i++)
    for (size_t b = 0; b < r->block_count; b++) {
      const double *u = qn_result_step_displacements (r, i) + QN_DOF_COUNT * b;
      const double *u0 = start + QN_DOF_COUNT * b;
      double moved = hypot (u[0] - u0[0], u[1] - u0[1]);
      if (!(moved <= r->history.peaks[b] * (1 + QN_CHECK_EXACT) + QN_CHECK_EXACT))
        qn_check_tell (check, QN_CLAIM_HISTORY, (QnId) i, QN_ENTITY_BLOCK, (QnId) b,
                       r->history.peaks[b], moved);
    }
  if (has_all_records (check->model) && qn_ground_init (&ground, check->model)) {
    check_rows (check, &ground);
    qn_ground_clear (&ground);
  }
}
