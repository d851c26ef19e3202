#include "core/capacity/capacity.h"

#include "core/base/memory.h"

#include <math.h>
#include <stdlib.h>

/* Part of the largest motion from which on a block takes part; and with the load, where blocks that stand only
 * spring back as the multiplier falls. */
#define PART_OF_MOTION 0.1
#define PART_WITH_LOAD 1e-3

/* A period that half the stiffness changes by more than this part of it says nothing of the structure. */
#define PERIOD_CHANGE 0.2

/* Parts of d0* that are the capacities of NTC 2018. */
static const double ntc_parts[QN_NTC_STATE_COUNT] = { 0.4, 0.6 };

/* Part of the peak where a path has fallen so far that the structure counts as collapsed. */
#define FALLEN 0.8

/* ---- spectra ---- */

/* End of the long periods of annex A, s. */
#define TF 10.0

/* a and b of [C7.2.6]: where the largest accelerations of a floor are, over T1. */
#define PLATEAU_START 0.8
#define PLATEAU_END   1.1

typedef struct {
  double s, tb, tc, td, te;
} Soil;

/* Tables 3.2, 3.3 and A.1 of EN 1998-1:2004. */
static const Soil soils[2][QN_SOIL_COUNT] = {
  { [QN_SOIL_A] = { 1.0, 0.15, 0.4, 2.0, 4.5 },
    [QN_SOIL_B] = { 1.2, 0.15, 0.5, 2.0, 5.0 },
    [QN_SOIL_C] = { 1.15, 0.20, 0.6, 2.0, 6.0 },
    [QN_SOIL_D] = { 1.35, 0.20, 0.8, 2.0, 6.0 },
    [QN_SOIL_E] = { 1.4, 0.15, 0.5, 2.0, 6.0 } },
  { [QN_SOIL_A] = { 1.0, 0.05, 0.25, 1.2, INFINITY },
    [QN_SOIL_B] = { 1.35, 0.05, 0.25, 1.2, INFINITY },
    [QN_SOIL_C] = { 1.5, 0.10, 0.25, 1.2, INFINITY },
    [QN_SOIL_D] = { 1.8, 0.10, 0.30, 1.2, INFINITY },
    [QN_SOIL_E] = { 1.6, 0.05, 0.25, 1.2, INFINITY } },
};

static const Soil *
soil_of (const QnSpectrum *spectrum)
{
  return &soils[spectrum->kind == QN_SPECTRUM_EN_2][spectrum->soil];
}

static double
points_acceleration (const QnSpectrum *spectrum, double t)
{
  const QnVec2 *p = spectrum->points;
  size_t last = spectrum->point_count - 1, i = 0;

  if (t <= p[0].x)
    return p[0].y;
  if (t >= p[last].x)
    return p[last].y * (p[last].x / t) * (p[last].x / t);
  while (p[i + 1].x < t)
    i++;
  return p[i].y + (t - p[i].x) / (p[i + 1].x - p[i].x) * (p[i + 1].y - p[i].y);
}

static double
eta (double damping)
{
  return fmax (sqrt (10 / (5 + 100 * damping)), 0.55);
}

/* That of the ground, of another damping too. */
static double
ground_acceleration (const QnSpectrum *spectrum, double t, double damping)
{
  if (spectrum->kind == QN_SPECTRUM_POINTS)
    return points_acceleration (spectrum, t) * eta (damping) / eta (spectrum->damping);
  const Soil *soil = soil_of (spectrum);
  double ground = spectrum->ground_acceleration * soil->s, top = 2.5 * eta (damping);

  if (t <= soil->tb)
    return ground * (1 + t / soil->tb * (top - 1));
  if (t <= soil->tc)
    return ground * top;
  if (t <= soil->td)
    return ground * top * soil->tc / t;
  if (t <= soil->te)
    return ground * top * soil->tc * soil->td / (t * t);
  double part = fmin ((t - soil->te) / (TF - soil->te), 1); /* annex A */
  double displacement = 0.025 * ground * soil->tc * soil->td * (top + part * (1 - top));
  return displacement * 4 * QN_PI * QN_PI / (t * t);
}

double
qn_spectrum_acceleration (const QnSpectrum *spectrum, double t)
{
  const QnFloor *f = &spectrum->floor;
  double ground = ground_acceleration (spectrum, t, spectrum->damping);

  if (!(f->height > 0))
    return ground;
  double participation = 3.0 * f->storeys / (2 * f->storeys + 1);
  double peak = ground_acceleration (spectrum, f->period, f->damping) * participation
                * f->height / f->building * sqrt (1 + 4 * f->damping * f->damping);
  double amplification = 1.1 / sqrt (f->damping) * eta (spectrum->damping), beside = 0;
  if (t < PLATEAU_START * f->period)
    beside = pow (1 - t / (PLATEAU_START * f->period), 1.6);
  else if (t > PLATEAU_END * f->period)
    beside = pow (t / (PLATEAU_END * f->period) - 1, 1.2);
  return fmax (amplification * peak / (1 + (amplification - 1) * beside), ground);
}

double
qn_spectrum_displacement (const QnSpectrum *spectrum, double t)
{
  double omega_inverse = t / (2 * QN_PI);

  return qn_spectrum_acceleration (spectrum, t) * omega_inverse * omega_inverse;
}

double
qn_spectrum_largest_displacement (const QnSpectrum *spectrum, double t)
{
  double largest = qn_spectrum_displacement (spectrum, t);

  if (spectrum->floor.height > 0 && t > PLATEAU_END * spectrum->floor.period)
    largest = fmax (
      largest, qn_spectrum_displacement (spectrum, PLATEAU_END * spectrum->floor.period));
  for (size_t i = 0; i < spectrum->point_count && spectrum->points[i].x < t; i++)
    largest = fmax (largest, qn_spectrum_displacement (spectrum, spectrum->points[i].x));
  return largest;
}

double
qn_spectrum_corner (const QnSpectrum *spectrum)
{
  double acceleration = 0, velocity = 0; /* of the latter 2 pi times */

  if (spectrum->kind != QN_SPECTRUM_POINTS)
    return soil_of (spectrum)->tc;
  for (size_t i = 0; i < spectrum->point_count; i++) {
    acceleration = fmax (acceleration, spectrum->points[i].y);
    velocity = fmax (velocity, spectrum->points[i].y * spectrum->points[i].x);
  }
  return acceleration > 0 ? velocity / acceleration : 0;
}

/* ---- curves ---- */

QnStatus
qn_capacity_check_model (const QnModel *model, QnDiag *diag)
{
  if (model->live_load_count == 0)
    return qn_refuse (diag, QN_PROBLEM_NO_LIVE_LOAD, QN_ENTITY_MODEL, QN_NONE);
  if (model->beam_count > 0)
    return qn_refuse (diag, QN_PROBLEM_CAPACITY_BEAMS, QN_ENTITY_BEAM, 0);
  return model->gravity > 0
           ? QN_OK
           : qn_diag_set_field (diag, QN_PROBLEM_NOT_POSITIVE, QN_ENTITY_MODEL, QN_NONE,
                                "gravity", model->gravity);
}

static QnStatus
check_loads (const QnModel *model, QnDiag *diag)
{
  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *load = &model->live_loads[i];
    if (load->set == 0 && (load->kind != QN_LOAD_WEIGHT || load->vector.y != 0))
      return qn_refuse (diag, QN_PROBLEM_CAPACITY_LOADS, QN_ENTITY_LIVE_LOAD, (QnId) i);
  }
  return qn_capacity_check_model (model, diag);
}

double
qn_capacity_direction (const QnModel *model)
{
  double direction = 0;

  for (size_t i = model->dead_load_count; i < qn_model_acting_count (model); i++) {
    const QnLoad load = qn_model_acting_load (model, i);
    if (load.set == 0 && load.kind == QN_LOAD_WEIGHT)
      direction += load.vector.x;
  }
  return direction;
}

QnCapacityPoint
qn_capacity_next_point (QnCapacity *c, double multiplier, double control, double scale)
{
  if (c->count > c->peak && multiplier <= 0) {
    const QnCapacityPoint *before = &c->points[c->count - 1];
    double part = before->multiplier / (before->multiplier - multiplier);
    control = before->control + part * (control - before->control);
    multiplier = 0;
    c->reaches_zero = true;
  }
  return (QnCapacityPoint){ .multiplier = multiplier,
                            .control = control,
                            .displacement = control * c->ratio,
                            .acceleration = multiplier * scale };
}

bool
qn_capacity_set_masses (QnCapacity *c, QnMassSums sums, double control, double gravity)
{
  if (!(sums.first > 0) || !(control > 0))
    return false;
  c->moving_mass = sums.weight / gravity;
  c->mass = sums.first * sums.first / (gravity * sums.second);
  c->share = c->mass / c->moving_mass;
  c->ratio = sums.second / (control * sums.first);
  return true;
}

static double
motion (const QnResult *result, size_t from, size_t to, size_t block)
{
  size_t at = QN_DOF_COUNT * block + QN_DOF_UX;

  return qn_result_step_displacements (result, to)[at]
         - qn_result_step_displacements (result, from)[at];
}

/* M*, e* and the ratio of displacements. False where nothing moves along the load. */
static bool
find_masses (QnCapacity *c, const QnModel *model, const QnResult *result, size_t from,
             size_t to, double direction)
{
  double largest = 0, sign = copysign (1, direction);
  QnMassSums sums = { 0 };

  for (size_t b = 0; b < model->block_count; b++)
    largest = fmax (largest, fabs (motion (result, from, to, b)));
  for (size_t b = 0; b < model->block_count; b++) {
    double delta = sign * motion (result, from, to, b);
    double weight = model->blocks[b].weight;
    if (largest == 0
        || (fabs (delta) < PART_OF_MOTION * largest
            && !(direction != 0 && delta > PART_WITH_LOAD * largest))) {
      bool fixed = qn_support_is_full (model->blocks[b].support);
      c->left_out += fixed ? 0 : weight / model->gravity;
      continue;
    }
    c->participating++;
    qn_mass_sums_add (&sums, weight, delta);
  }
  return direction != 0
         && qn_capacity_set_masses (
           c, sums, sign * motion (result, from, to, (size_t) c->block), model->gravity);
}

QnStatus
qn_capacity_init (QnCapacity *c, const QnModel *model, const QnResult *result,
                  QnId control, QnDiag *diag)
{
  double direction = qn_capacity_direction (model);
  size_t peak = 0, last = result->step_count - 1;

  *c = (QnCapacity){ .block = control };
  QnStatus status = check_loads (model, diag);
  if (status != QN_OK)
    return status;
  for (size_t i = 0; i < result->step_count; i++)
    if (result->steps[i].multiplier > result->steps[peak].multiplier)
      peak = i;
  /* The mechanism is the motion from the peak, or from the start, to where the path has fallen. */
  size_t from = peak == last ? 0 : peak, to = from;
  while (peak > 0 && to < last
         && (to == from
             || result->steps[to].multiplier > FALLEN * result->steps[peak].multiplier))
    to++;
  if (peak == 0 || !find_masses (c, model, result, from, to, direction))
    return qn_refuse (diag, QN_PROBLEM_CAPACITY_MOTION, QN_ENTITY_BLOCK, control);
  c->points = qn_alloc (result->step_count, sizeof *c->points);
  if (c->points == NULL)
    return qn_diag_no_memory (diag);
  c->peak = peak;
  double acceleration = fabs (direction) * model->gravity / c->share;
  for (size_t i = 0; i < result->step_count && !c->reaches_zero; i++) {
    double moved = copysign (1, direction) * motion (result, 0, i, (size_t) c->block);
    c->points[i] =
      qn_capacity_next_point (c, result->steps[i].multiplier, moved, acceleration);
    c->count++;
  }
  c->end = c->points[c->count - 1].displacement;
  return QN_OK;
}

void
qn_capacity_clear (QnCapacity *c)
{
  if (c->softer != NULL)
    qn_capacity_clear (c->softer);
  free (c->softer);
  free (c->points);
  *c = (QnCapacity){ 0 };
}

double
qn_capacity_acceleration (const QnCapacity *c, double displacement)
{
  size_t i = 1;

  while (i + 1 < c->count && c->points[i].displacement < displacement)
    i++;
  const QnCapacityPoint *a = &c->points[i - 1], *b = &c->points[i];
  double length = b->displacement - a->displacement;
  double part = length > 0 ? (displacement - a->displacement) / length : 1;
  return a->acceleration + part * (b->acceleration - a->acceleration);
}

/* Whether a check says something: not where its period is that of stiffness which was assumed. */
static void
judge (QnCapacityState *state, const QnCapacity *c)
{
  state->refused =
    c->softer != NULL
    && !(fabs (state->softer - state->period) <= PERIOD_CHANGE * state->period);
  state->ratio = state->refused ? NAN : state->capacity / state->demand;
}

static double
ntc_capacity (const QnCapacity *c, QnNtcState which)
{
  double capacity = ntc_parts[which] * c->end;

  return which == QN_NTC_SLV && c->broken > 0 ? fmin (capacity, c->broken) : capacity;
}

static double
ntc_period (const QnCapacity *c, double confidence, QnNtcState which)
{
  static const double factors[QN_NTC_STATE_COUNT] = { 1.68, 1.56 };
  double capacity = ntc_capacity (c, which);

  return factors[which] * QN_PI
         * sqrt (capacity * confidence / qn_capacity_acceleration (c, capacity));
}

QnCapacityState
qn_capacity_check_ntc (const QnCapacity *c, const QnSpectrum *spectrum, double confidence,
                       QnNtcState which)
{
  QnCapacityState state = { .capacity = ntc_capacity (c, which), .softer = NAN };

  state.acceleration = qn_capacity_acceleration (c, state.capacity) / confidence;
  state.period = ntc_period (c, confidence, which);
  if (c->softer != NULL)
    state.softer = ntc_period (c->softer, confidence, which);
  state.demand = spectrum->kind == QN_SPECTRUM_POINTS || spectrum->floor.height > 0
                   ? qn_spectrum_largest_displacement (spectrum, state.period)
                   : qn_spectrum_displacement (spectrum, state.period);
  judge (&state, c);
  return state;
}

/* Up to the peak as elastic and perfectly plastic: annex B. */
static QnEnDemand
en_yield (const QnCapacity *c)
{
  const QnCapacityPoint *peak = &c->points[c->peak];
  QnEnDemand d = { .yield_acceleration = peak->acceleration,
                   .mechanism = peak->displacement,
                   .softer = NAN };

  for (size_t i = 1; i <= c->peak; i++)
    d.energy += 0.5 * (c->points[i].acceleration + c->points[i - 1].acceleration)
                * (c->points[i].displacement - c->points[i - 1].displacement);
  d.yield = fmax (2 * (d.mechanism - d.energy / d.yield_acceleration), 0);
  d.period = 2 * QN_PI * sqrt (d.yield / d.yield_acceleration);
  return d;
}

QnEnDemand
qn_capacity_en_demand (const QnCapacity *c, const QnSpectrum *spectrum)
{
  QnEnDemand d = en_yield (c);

  if (c->softer != NULL)
    d.softer = en_yield (c->softer).period;
  double acceleration = qn_spectrum_acceleration (spectrum, d.period);
  double corner = qn_spectrum_corner (spectrum);
  d.elastic = qn_spectrum_displacement (spectrum, d.period);
  d.q = acceleration / d.yield_acceleration;
  d.target = d.elastic;
  if (d.period < corner && d.q > 1 && d.period > 0)
    d.target = fmax (d.elastic / d.q * (1 + (d.q - 1) * corner / d.period), d.elastic);
  return d;
}

QnCapacityState
qn_capacity_check_en (const QnCapacity *c, const QnEnDemand *demand, QnEnState which)
{
  double part = which == QN_EN_SD ? 0.75 : 1, near_collapse = c->end;
  double level = FALLEN * c->points[c->peak].acceleration;

  for (size_t i = c->peak + 1; i < c->count; i++) {
    const QnCapacityPoint *a = &c->points[i - 1], *b = &c->points[i];
    if (b->acceleration > level)
      continue;
    near_collapse = a->displacement
                    + (a->acceleration - level) / (a->acceleration - b->acceleration)
                        * (b->displacement - a->displacement);
    break;
  }
  QnCapacityState state = { .capacity = part * near_collapse,
                            .period = demand->period,
                            .softer = demand->softer,
                            .demand = demand->target };

  state.acceleration = qn_capacity_acceleration (c, state.capacity);
  judge (&state, c);
  return state;
}
