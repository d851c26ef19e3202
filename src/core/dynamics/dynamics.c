#include "core/dynamics/dynamics.h"

#include "core/base/integer.h"
#include "core/base/memory.h"
#include "core/base/numbers.h"
#include "core/dynamics/time-step.h"

#include <string.h>

/* Tuning. The error of a step grows with the square of its length, or faster. */
#define CUTS        12   /* most, in two, of the longest step */
#define MAY_GROW    0.15 /* of the tolerance: the next step may be twice as long */
#define STEP_ENERGY 2e-5 /* of the largest input: error of a step that is too long */

/* The energy balance: sums since the start, J. Each term has its own formula (result.h), so that the residual of the
 * balance is the error: of the work of joints that turn within a step, and of Newton's iteration. */
typedef struct QnEnergy {
  double sums[QN_ENERGY_KIND_COUNT];
} QnEnergy;

typedef struct {
  QnPool pool; /* of arrays */
  QnEquilibrium *eq;
  QnTimeStep step;
  QnGround ground;
  const QnModel *model;
  const QnDynamicSettings *settings;
  QnResult *result;
  QnEnergy energy;
  QnMovingContacts *moving; /* where contacts follow the blocks, else NULL */
  bool overturned;          /* and is followed on; when */
  double overturned_at;
  size_t followed;  /* place of what progress tells among displacements; SIZE_MAX: none */
  double tick;      /* s: the longest step cut CUTS times; time is counted in these */
  int64_t now, end; /* ticks */
  int64_t length;   /* of the next step, in ticks: a power of two */
  int64_t output, kept;  /* ticks between steps that are kept, and of the last one kept */
  double *start;         /* displacements of bodies under dead load */
  double *displacements; /* scratch, a row for every body */
  double *distances;     /* scratch, of blocks, m */
  double *row;           /* scratch, of the history */
  double peak;           /* largest displacement so far, m */
  double largest_error, largest_input; /* of the energy balance, J */
  double rest_speed, rest_time;        /* m/s, s */
  double still_since;                  /* s; negative: it moves */
  int32_t iterations_at_step;
  double residual; /* of the last step that was accepted, relative */
} Run;

static const int64_t longest = (int64_t) 1 << CUTS;

static double
time_of (const Run *run, int64_t tick)
{
  return run->tick * (double) tick;
}

/* --- Energy ------------------------------------------------------------------------------ */

static double
elastic (const QnTimeStep *step, const QnInstant *instant)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  double sum = instant->beam_energy;

  for (size_t p = 0; p < as->pair_count; p++)
    if (!as->inactive[p])
      sum +=
        qn_pair_elastic_energy (&step->elasticity[p], instant->at.responses[p].force);
  return sum;
}

/* x' M y */
static double
product (const QnTimeStep *step, const double *ax, const double *x, const double *y)
{
  QnEquilibrium *eq = step->equation.eq;

  qn_assembly_multiply (&eq->assembly, ax, y, eq->trial);
  return qn_dot (x, eq->trial, (size_t) eq->assembly.unknown_count);
}

/* At the start of the analysis: INPUT = kinetic + elastic energy of step->start. */
static QnEnergy
energy_at_start (const QnTimeStep *step)
{
  const QnInstant *start = &step->start;
  QnEnergy energy = { { 0 } };

  energy.sums[QN_ENERGY_KINETIC] = 0.5 * product (step, step->mass, start->v, start->v);
  energy.sums[QN_ENERGY_ELASTIC] = elastic (step, start);
  energy.sums[QN_ENERGY_INPUT] =
    energy.sums[QN_ENERGY_KINETIC] + energy.sums[QN_ENERGY_ELASTIC];
  return energy;
}

/* After the step of h seconds just tried; the mean acceleration of the ground, and how much it changed. Kinetic
 * and elastic energy are those of step->end. */
static QnEnergy
energy_after (const QnTimeStep *step, const QnEnergy *before, double h, QnVec2 mean,
              QnVec2 change)
{
  const QnAssembly *as = &step->equation.eq->assembly;
  const QnTimeScheme *s = &step->scheme;
  const QnInstant *start = &step->start, *end = &step->end;
  double *motion = step->equation.eq->live_step, *jump = step->equation.eq->step;
  double *drag = step->equation.eq->trial;
  double damping = 0, input = 0, numerical = 0;
  QnEnergy energy = *before;

  /* dashpots on masses and beams */
  for (int32_t i = 0; i < as->unknown_count; i++) {
    motion[i] = (1 - s->alpha_f) * end->v[i] + s->alpha_f * start->v[i];
    jump[i] = end->at.u[i] - start->at.u[i];
  }
  if (step->settings->mass_damping > 0)
    damping += step->settings->mass_damping * product (step, step->mass, jump, motion);
  if (step->settings->joint_damping > 0 && as->beams.count > 0)
    damping +=
      step->settings->joint_damping * product (step, step->beam_damping, jump, motion);
  energy.sums[QN_ENERGY_DAMPING] += damping;

  /* D, with [R] = -[residual] + M i [g] */
  for (int32_t i = 0; i < as->unknown_count; i++)
    motion[i] = end->a[i] - start->a[i];
  qn_assembly_multiply (as, step->mass, motion, drag);
  for (int32_t i = 0; i < as->unknown_count; i++) {
    double du = end->at.u[i] - start->at.u[i], dv = end->v[i] - start->v[i];
    double ground = step->inertia[0][i] * mean.x + step->inertia[1][i] * mean.y;
    double r = start->residual[i] - end->residual[i] + step->inertia[0][i] * change.x
               + step->inertia[1][i] * change.y;
    input += (0.5 * (start->dead[i] + end->dead[i]) - ground) * du;
    numerical += (0.5 - s->alpha_f) * du * (r + drag[i])
                 + h * (s->beta - 0.5 * s->gamma) * drag[i] * dv;
  }
  energy.sums[QN_ENERGY_INPUT] += input;
  energy.sums[QN_ENERGY_NUMERICAL] += numerical;

  /* Energy dissipated by slip, plastic hinges and dashpots of pairs. */
  double friction = 0;
  for (size_t p = 0; p < as->pair_count; p++) {
    QnPairInstant then = qn_instant_pair (start, start->at.responses, p),
                  now = qn_instant_pair (end, end->at.responses, p);
    if (as->inactive[p])
      continue;
    friction += qn_pair_friction (&step->elasticity[p], &step->forces[p], &then, &now);
    for (int i = 0; i < 2; i++)
      energy.sums[QN_ENERGY_DAMPING] +=
        step->forces[p].dashpot[i] * (now.q[i] - then.q[i]);
  }
  for (size_t b = 0; b < as->beams.count; b++) {
    const QnBeamResponse *then = &start->at.beams.responses[b],
                         *now = &end->at.beams.responses[b];
    for (int i = 0; i < 2; i++)
      friction += 0.5 * (then->force[1 + i] + now->force[1 + i])
                  * (now->memory.plastic[i] - then->memory.plastic[i]);
    friction += 0.5 * (then->force[0] + now->force[0])
                * (now->memory.stretch - then->memory.stretch);
  }
  energy.sums[QN_ENERGY_FRICTION] += friction;
  energy.sums[QN_ENERGY_ELASTIC] = elastic (step, end);
  energy.sums[QN_ENERGY_KINETIC] = 0.5 * product (step, step->mass, end->v, end->v);
  return energy;
}

/* INPUT less all other terms, J. */
static double
energy_error (const QnEnergy *energy)
{
  double rest = energy->sums[QN_ENERGY_INPUT];

  for (int kind = QN_ENERGY_INPUT + 1; kind < QN_ENERGY_KIND_COUNT; kind++)
    rest -= energy->sums[kind];
  return rest;
}

/* --- Recording --------------------------------------------------------------------------- */

/* The accepted state as a step of the result. */
static bool
keep_step (Run *run, QnEvent event)
{
  const QnStatistics *spent = &run->eq->statistics;
  QnStep step = { .iterations = spent->iterations - run->iterations_at_step,
                  .residual = run->residual,
                  .event = event,
                  .time = time_of (run, run->now) };

  run->iterations_at_step = spent->iterations;
  run->kept = run->now;
  run->eq->progress.steps++;
  if (!qn_record_step (run->eq, run->moving, 0, step, run->result))
    return false;
  qn_assembly_expand_rates (&run->eq->assembly, run->eq->u, run->step.start.v,
                            run->displacements);
  return qn_result_add_velocities (run->result, run->displacements);
}

static bool
keep_row (Run *run)
{
  double time = time_of (run, run->now);
  QnVec2 ground = qn_ground_acceleration (&run->ground, time);

  qn_assembly_expand (&run->eq->assembly, run->eq->u, run->displacements);
  run->row[QN_HISTORY_TIME] = time;
  run->row[QN_HISTORY_GROUND_X] = ground.x;
  run->row[QN_HISTORY_GROUND_Y] = ground.y;
  memcpy (run->row + QN_HISTORY_ENERGY, run->energy.sums, sizeof run->energy.sums);
  for (size_t i = 0; i < run->model->track_count; i++) {
    const QnTrack *track = &run->model->tracks[i];
    run->row[QN_HISTORY_TRACK + i] =
      run->displacements[QN_DOF_COUNT * track->block + (int) track->dof];
  }
  return qn_result_add_history (run->result, run->row);
}

/* Peaks of displacements, slip, residual and energy error; what progress tells. */
static void
note_peaks (Run *run)
{
  const QnAssembly *as = &run->eq->assembly;
  QnHistory *history = &run->result->history;
  QnProgress *progress = &run->eq->progress;

  qn_assembly_expand (as, run->eq->u, run->displacements);
  progress->time = time_of (run, run->now);
  if (run->followed != SIZE_MAX)
    progress->displacement =
      run->displacements[run->followed] - run->start[run->followed];
  for (size_t b = 0; b < run->model->block_count; b++) {
    const double *d = run->displacements + QN_DOF_COUNT * b,
                 *d0 = run->start + QN_DOF_COUNT * b;
    double moved = hypot (d[0] - d0[0], d[1] - d0[1]);
    history->peaks[b] = fmax (history->peaks[b], moved);
    if (moved > run->peak) {
      run->peak = moved;
      history->peak_time = progress->time;
    }
  }
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairMemory *memory = &as->responses[p].memory;
    if (as->contacts->pairs[p].found)
      continue;
    double slip = fabs (memory->a.slip + memory->b.slip);
    double length = as->contacts->faces[as->contacts->pairs[p].face].length;
    if (as->responses[p].force[0] < 0)
      history->largest_slip = fmax (history->largest_slip, slip / length);
  }
  history->largest_residual =
    fmax (history->largest_residual, run->step.equation.relative);
  run->largest_error = fmax (run->largest_error, fabs (energy_error (&run->energy)));
  run->largest_input =
    fmax (run->largest_input, fabs (run->energy.sums[QN_ENERGY_INPUT]));
}

/* --- How it ends ------------------------------------------------------------------------- */

/* After note_peaks(), which leaves the displacements of bodies. */
static bool
has_overturned (const Run *run)
{
  /* How near every block still is to one of those it touched: the least elongation of its
   * pairs, m. Blocks without pairs, and those that beams hold, are as near as can be. */
  const QnAssembly *as = &run->eq->assembly;
  for (size_t b = 0; b < run->model->block_count; b++)
    run->distances[b] = INFINITY;
  for (size_t p = 0; p < as->pair_count; p++) {
    const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[p].face];
    const double *q = as->elongations + 2 * p;
    double apart = q[0] > 0 ? hypot (q[0], q[1]) : 0;
    run->distances[face->a] = fmin (run->distances[face->a], apart);
    run->distances[face->b] = fmin (run->distances[face->b], apart);
  }
  for (size_t i = 0; i < run->model->node_count; i++)
    if (run->model->nodes[i].block != QN_NONE)
      run->distances[run->model->nodes[i].block] = 0;
  for (size_t b = 0; b < run->model->block_count; b++) {
    double turned = run->displacements[3 * b + QN_DOF_RZ] - run->start[3 * b + QN_DOF_RZ];
    double distance = isfinite (run->distances[b]) ? run->distances[b] : 0;
    if (fabs (turned) > QN_OVERTURNED || distance > sqrt (run->model->blocks[b].area))
      return true;
  }
  return false;
}

static QnStatus
keep_mechanism (Run *run, QnDiag *diag)
{
  qn_assembly_expand_rates (&run->eq->assembly, run->eq->u, run->step.start.v,
                            run->displacements);
  return qn_result_set_mechanism (run->result, run->displacements,
                                  run->model->characteristic_length, diag);
}

/* --- Through time ------------------------------------------------------------------------ */

/* One step that is accepted, after as many that are not as it takes. FAILED where none is short
 * enough. */
static QnSolveStatus
advance (Run *run)
{
  const double allowed = run->settings->tolerance * run->model->characteristic_length;
  QnHistory *history = &run->result->history;

  for (;;) {
    double from = time_of (run, run->now), h = time_of (run, run->length);
    QnVec2 mean = qn_ground_mean (&run->ground, from, from + h),
           change = qn_ground_change (&run->ground, from, from + h);
    QnSolveStatus status = qn_time_step_try (
      &run->step, h, qn_vec2_add_scaled (mean, 0.5 - run->step.scheme.alpha_f, change));
    if (status == QN_SOLVE_CANCELLED || status == QN_SOLVE_NO_MEMORY)
      return status;
    double error = status == QN_SOLVE_CONVERGED && run->settings->adaptive
                     ? qn_time_step_error (&run->step, h, change)
                     : 0;
    bool shortest = run->length == 1, balances = false;
    QnEnergy energy = run->energy;
    if (status == QN_SOLVE_CONVERGED && (error <= allowed || shortest)) {
      energy = energy_after (&run->step, &run->energy, h, mean, change);
      double wrong = energy_error (&energy);
      balances =
        shortest || !run->settings->adaptive
          ? isfinite (wrong) != 0
          : fabs (wrong - energy_error (&run->energy))
              <= STEP_ENERGY
                   * fmax (run->largest_input, fabs (energy.sums[QN_ENERGY_INPUT]));
    }
    if (balances) {
      run->energy = energy;
      qn_time_step_accept (&run->step);
      run->residual = run->step.equation.relative;
      run->now += run->length;
      history->steps++;
      history->shortest_step = history->steps == 1 ? h : fmin (history->shortest_step, h);
      if (error <= MAY_GROW * allowed && run->length < longest
          && run->now % (2 * run->length) == 0)
        run->length *= 2;
      return status;
    }
    if (shortest)
      return QN_SOLVE_FAILED;
    history->rejected++;
    run->length /= 2;
  }
}

static QnStatus
end_with (Run *run, QnOutcome outcome, QnDiag *diag)
{
  bool ended = outcome != QN_OUTCOME_CANCELLED && outcome != QN_OUTCOME_NOT_CONVERGED;
  outcome = run->overturned && ended ? QN_OUTCOME_COLLAPSE : outcome;
  QnEvent event = outcome == QN_OUTCOME_COLLAPSE ? QN_EVENT_COLLAPSE : QN_EVENT_NONE;

  run->result->outcome = outcome;
  if (run->kept != run->now && !keep_step (run, event))
    return qn_diag_no_memory (diag);
  if (outcome != QN_OUTCOME_COLLAPSE)
    return QN_OK;
  run->result->steps[run->result->step_count - 1].event = event;
  run->result->history.collapse_time =
    run->overturned ? run->overturned_at : time_of (run, run->now);
  return run->overturned ? QN_OK : keep_mechanism (run, diag);
}

/* Contacts follow the blocks after a step that was accepted. */
static QnStatus
renew_contacts (Run *run, QnDiag *diag)
{
  double time = time_of (run, run->now);
  bool changed;

  if (run->moving == NULL)
    return QN_OK;
  /* How fast a corner moves at most, m/s. */
  const QnAssembly *as = &run->eq->assembly;
  double speed = 0;
  for (size_t b = 0; b < as->model->block_count; b++) {
    double v[QN_DOF_COUNT] = { 0 };
    for (size_t i = 0; i < QN_DOF_COUNT; i++)
      if (as->unknown[QN_DOF_COUNT * b + i] != QN_NONE)
        v[i] = run->step.start.v[as->unknown[QN_DOF_COUNT * b + i]];
    speed =
      fmax (speed, hypot (v[0], v[1])
                     + run->moving->follow.reach[b] * fabs (v[QN_DOF_RZ]) / as->length);
  }
  QnStatus status =
    qn_moving_contacts_update (run->moving, run->eq, 2 * time_of (run, longest) * speed,
                               time, run->result, &changed, diag);
  if (status == QN_OK && changed)
    status = qn_time_step_renew (&run->step, diag);
  if (status != QN_OK)
    return status;
  if (changed) {
    /* What elastic energy is lost by it goes to FRICTION. */
    double now = elastic (&run->step, &run->step.start);
    run->energy.sums[QN_ENERGY_FRICTION] += run->energy.sums[QN_ENERGY_ELASTIC] - now;
    run->energy.sums[QN_ENERGY_ELASTIC] = now;
  }
  return qn_moving_contacts_record (run->moving, &run->eq->assembly, time, NULL,
                                    run->result)
           ? QN_OK
           : qn_diag_no_memory (diag);
}

static QnStatus
follow (Run *run, QnDiag *diag)
{
  /* Joints that the initial motion has left do not drive it. */
  QnStatus status = renew_contacts (run, diag);
  if (status != QN_OK)
    return status;
  QnSolveStatus step =
    qn_time_step_start (&run->step, qn_ground_acceleration (&run->ground, 0));
  if (step == QN_SOLVE_NO_MEMORY)
    return qn_diag_no_memory (diag);

  run->energy = energy_at_start (&run->step);
  run->result->steps[0].time = 0;
  note_peaks (run);
  memset (run->displacements, 0,
          qn_model_body_count (run->model) * QN_DOF_COUNT * sizeof *run->displacements);
  if (!qn_result_add_velocities (run->result, run->displacements) || !keep_row (run)
      || (run->model->initial_count > 0 && !keep_step (run, QN_EVENT_NONE)))
    return qn_diag_no_memory (diag);
  while (run->now < run->end) {
    step = advance (run);
    if (step != QN_SOLVE_CONVERGED) {
      qn_equilibrium_set_state (run->eq, &run->step.start.at);
      if (step == QN_SOLVE_NO_MEMORY)
        return qn_diag_no_memory (diag);
      return end_with (
        run, step == QN_SOLVE_CANCELLED ? QN_OUTCOME_CANCELLED : QN_OUTCOME_NOT_CONVERGED,
        diag);
    }
    note_peaks (run);
    status = renew_contacts (run, diag);
    if (status != QN_OK)
      return status;
    if (!run->overturned && has_overturned (run)) {
      run->overturned = run->settings->fall;
      run->overturned_at = time_of (run, run->now);
      if (!run->overturned)
        return keep_row (run) ? end_with (run, QN_OUTCOME_COLLAPSE, diag)
                              : qn_diag_no_memory (diag);
      status =
        keep_mechanism (run, diag); /* how it overturned, not how it came to rest */
      if (status != QN_OK)
        return status;
    }
    if (run->now % longest == 0 && !keep_row (run))
      return qn_diag_no_memory (diag);
    double time = time_of (run, run->now);
    if (qn_largest (run->step.start.v, (size_t) run->eq->assembly.unknown_count)
          > run->rest_speed
        || time < run->ground.end)
      run->still_since = -1;
    else if (run->still_since < 0)
      run->still_since = time;
    if (run->still_since >= 0 && time - run->still_since >= run->rest_time)
      return end_with (run, QN_OUTCOME_REST, diag);
    if (run->now - run->kept >= run->output && !keep_step (run, QN_EVENT_NONE))
      return qn_diag_no_memory (diag);
  }
  return end_with (run, QN_OUTCOME_TARGET_REACHED, diag);
}

/* --- Setting up -------------------------------------------------------------------------- */

static QnStatus
set_up (Run *run, QnDiag *diag)
{
  const QnModel *model = run->model;
  QnHistory *history = &run->result->history;
  size_t bodies = qn_model_body_count (model) * QN_DOF_COUNT;

  *history = (QnHistory){ .width = QN_HISTORY_TRACK + model->track_count };
  history->peaks = qn_alloc (model->block_count, sizeof *history->peaks);
  run->start = qn_pool_alloc (&run->pool, bodies, sizeof *run->start);
  run->displacements = qn_pool_alloc (&run->pool, bodies, sizeof *run->displacements);
  run->distances = qn_pool_alloc (&run->pool, model->block_count, sizeof *run->distances);
  run->row = qn_pool_alloc (&run->pool, history->width, sizeof *run->row);
  if (history->peaks == NULL || run->pool.failed || !qn_ground_init (&run->ground, model))
    return qn_diag_no_memory (diag);
  qn_assembly_expand (&run->eq->assembly, run->eq->u, run->start);
  const QnDynamicSettings *s = run->settings;
  double duration = qn_model_duration (model);
  double steps = fmax (ceil (duration / s->time_step - 1e-9), 1);
  double step = duration / steps;
  double output = s->output_interval > 0 ? s->output_interval : duration / 500;

  run->tick = step / (double) longest;
  run->end = qn_to_integer (steps, 1, QN_MAX_TIME_STEPS) * longest;
  run->output = qn_to_integer (rint (output / step), 1, QN_MAX_TIME_STEPS) * longest;
  run->length = longest;
  run->rest_speed =
    QN_REST_SPEED * sqrt (run->model->gravity * run->model->characteristic_length);
  /* Height of the structure, m. */
  QnBox box = qn_box_of_points (run->model->vertices, run->model->vertex_count);
  for (size_t i = 0; i < run->model->node_count; i++)
    qn_box_add_point (&box, run->model->nodes[i].at);
  run->rest_time = sqrt (fmax (box.max.y - box.min.y, run->model->characteristic_length)
                         / run->model->gravity);
  run->still_since = -1;
  size_t body;
  QnDof dof;
  qn_model_followed (model, &body, &dof);
  run->followed = body == SIZE_MAX ? SIZE_MAX : QN_DOF_COUNT * body + (size_t) dof;
  run->eq->progress.end = duration;
  return QN_OK;
}

QnStatus
qn_dynamics_run (QnEquilibrium *eq, QnMovingContacts *moving, QnResult *result,
                 QnDiag *diag)
{
  const QnModel *model = eq->assembly.model;
  Run run = { .eq = eq,
              .moving = moving,
              .model = model,
              .settings = &model->analysis.dynamic,
              .iterations_at_step = eq->statistics.iterations,
              .result = result };
  QnStatus status = QN_OK;

  for (size_t i = 0; i < model->ground_count && status == QN_OK; i++)
    if (model->ground[i].kind == QN_SIGNAL_RECORD)
      status = qn_model_check_signal (model, (QnId) i, diag);
  if (status == QN_OK)
    status = qn_model_check_steps (model, diag);
  if (status == QN_OK)
    status = set_up (&run, diag);
  if (status == QN_OK)
    status = qn_time_step_setup (&run.step, eq, diag);
  if (status == QN_OK)
    status = follow (&run, diag);

  result->history.end = time_of (&run, run.now);
  result->history.energy_error =
    run.largest_input > 0 ? run.largest_error / run.largest_input : 0;
  qn_ground_clear (&run.ground);
  qn_pool_clear (&run.pool);
  qn_time_step_clear (&run.step);
  return status;
}
