/* The mechanism at the last step: do joints move as their strengths and their flow let them? */
#include "core/base/numbers.h"
#include "core/check/check-parts.h"
#include "core/check/second-order-work.h"

#include <math.h>

/* A rate is none within this part of the largest velocity: elastic joints give a little while a
 * structure begins to move. */
#define RATE 0.02

/* Rates at which a pair may part and slide when it has this force. */
typedef struct {
  bool opens, closes,
    slides;         /* a strength of this kind is reached, or there is no force */
  double dilatancy; /* least opening per slip outwards */
} Freedom;

static Freedom
find_freedom (const QnPairSprings *springs, const QnPairMemory *memory,
              const double force[2], bool associative, double little)
{
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  Freedom freedom = { .dilatancy = INFINITY };
  int count = associative ? qn_pair_rigid_strength (springs, rows)
                          : qn_pair_strength (springs, memory, rows);

  for (int i = 0; i < count; i++) {
    double slack =
      rows[i].limit - rows[i].normal * force[0] - rows[i].shear * fabs (force[1]);
    if (slack > little)
      continue;
    if (rows[i].shear > 0) {
      freedom.slides = true;
      freedom.dilatancy =
        fmin (freedom.dilatancy, associative ? rows[i].normal : rows[i].opening);
    } else if (rows[i].opening > 0) {
      freedom.opens = true;
    } else {
      freedom.closes = true;
    }
  }
  return freedom;
}

/* Opening per slip in the sense of the shear force, from `least` to `most`, of the spring that has `outwards` until
 * it slides back or its dilation ends. */
static void
find_dilation (const QnCheck *check, size_t p, double shear, double outwards,
               double *least, double *most)
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  const QnPairMemory *memory = &check->assembly.responses[p].memory;
  bool second = !springs->equal && springs->a.dilatancy != outwards;
  const QnSpring *s = second ? &springs->b : &springs->a;
  double slip = second ? memory->b.slip : memory->a.slip, sign = shear < 0 ? -1 : 1;

  *least = *most = outwards;
  if (check->result->limit.given)
    return;
  for (int way = -1; way <= 1; way += 2) {
    double rate = qn_spring_dilation_rate (s, slip + way * check->slack, sign);
    *least = fmin (*least, rate);
    *most = way < 0 ? rate : fmax (*most, rate);
  }
}

static void
check_joint (QnCheck *check, size_t p, const double rate[2], double none)
{
  const QnAssembly *as = &check->assembly;
  const double force[2] = { check->stated[p].normal_force, check->stated[p].shear_force };
  const QnPairSprings *springs = &as->springs[p];
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  double little = QN_CHECK_LITTLE * check->scale;

  /* Laws without strength rows are not checked. */
  if (qn_spring_strength (&springs->a, rows) == 0
      || qn_spring_strength (&springs->b, rows) == 0)
    return;
  Freedom freedom = find_freedom (springs, &as->responses[p].memory, force,
                                  check->result->limit.given
                                    && check->result->limit.flow == QN_FLOW_ASSOCIATIVE,
                                  little);
  bool breaks = qn_spring_has_bond (&springs->a) && (freedom.opens || freedom.slides)
                && qn_pair_damage (springs, &as->responses[p].memory) < 1;
  bool loose = breaks || hypot (force[0], force[1]) <= little;
  size_t step = check->result->step_count - 1;
  double least = 0, most = 0;

  if (freedom.slides && !freedom.opens) {
    find_dilation (check, p, force[1], freedom.dilatancy, &least, &most);
    least *= fabs (rate[1]);
    most *= fabs (rate[1]);
  }
  if (!(rate[0] >= least - none) && !freedom.closes) {
    bool parts = qn_assembly_gap (as, p) > 0; /* it may close again */
    if (!parts)
      qn_check_tell_pair (check, QN_CLAIM_OVERLAP, step, p, rate[0], least);
  }
  bool opens = rate[0] > most + none, slides = fabs (rate[1]) > none;
  if ((opens && !freedom.opens && !loose) || (slides && !freedom.slides && !loose)
      || (slides && freedom.slides && !loose && rate[1] * force[1] < 0))
    qn_check_tell_pair (check, QN_CLAIM_FLOW, step, p, opens ? rate[0] : rate[1], 0);
}

/* Beams at collapse turn at ends that yield, in the sense of their moments, and at hinges; elsewhere they
 * move as they are. In linear geometry, in which deformations of rates are rates of deformations. */
static void
check_beams (QnCheck *check, double none)
{
  const QnBeamAssembly *beams = &check->assembly.beams;

  qn_beam_assembly_update_kinematics (&check->assembly, check->velocity);
  for (size_t e = 0; e < check->model->element_count; e++) {
    const QnBeamProperties *p = &beams->beams[e].properties;
    const double *rate = beams->beams[e].kinematics.deformation;
    bool flows = fabs (rate[0]) <= none;
    for (int end = 0; end < 2; end++) {
      double moment = beams->responses[e].force[1 + end], turn = rate[1 + end];
      bool yields = fabs (moment) >= (1 - QN_CHECK_LITTLE) * p->moments[end];
      flows = flows
              && (p->moments[end] == 0 || fabs (turn) * p->length <= none
                  || (yields && turn * moment > 0));
    }
    if (!flows)
      qn_check_tell (check, QN_CLAIM_FLOW, (QnId) check->result->step_count - 1,
                     QN_ENTITY_BEAM, check->model->elements[e].beam, rate[0], 0);
  }
  qn_beam_assembly_update_kinematics (&check->assembly, check->u);
}

/* Power of the loads that the last stage drives, in the sense in which they grow. A path that was followed
 * until its load had fallen ends in a motion that other loads may drive. */
static void
check_work (QnCheck *check)
{
  const QnAssembly *as = &check->assembly;
  const QnResult *result = check->result;
  double factors[QN_MAX_LOAD_SETS] = { 0 }, none[QN_MAX_LOAD_SETS] = { 0 };
  double power = 0, largest = 0;
  QnCheckStage stage =
    qn_check_stage (check, result->steps[result->step_count - 1].stage);

  if (!qn_model_sets_have_force (check->model, stage.sets)
      || fabs (result->steps[result->step_count - 1].multiplier
               - result->collapse_multiplier)
           > 0.5 * fabs (result->collapse_multiplier))
    return;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    if ((stage.sets >> set & 1) != 0)
      factors[set] = result->collapse_multiplier >= stage.before[set] ? 1 : -1;
  qn_assembly_set_loads (&check->assembly, none, factors);
  qn_assembly_update_kinematics (&check->assembly, check->u);
  for (int32_t i = 0; i < as->unknown_count; i++)
    if (!as->settles[i]) {
      power += as->live[i] * check->velocity[i];
      largest += fabs (as->live[i] * check->velocity[i]);
    }
  if (!(power >= -QN_CHECK_STATE * largest))
    qn_check_tell_model (check, QN_CLAIM_WORK, (QnId) result->step_count - 1, power, 0);
}

void
qn_check_bodies (QnCheck *check)
{
  const QnAssembly *as = &check->assembly;
  const QnResult *r = check->result;
  size_t blocks = check->model->block_count;
  /* What fell on has turned since: nodes that ride on blocks do so elsewhere. */
  bool fell = r->history.width > 0 && r->outcome == QN_OUTCOME_COLLAPSE
              && r->history.collapse_time < r->steps[r->step_count - 1].time;
  size_t bodies = fell ? blocks : qn_model_body_count (check->model);

  qn_assembly_expand_rates (as, check->u, check->velocity, check->rows);
  qn_check_rows (check, QN_CLAIM_FLOW, QN_NONE, r->mechanism, bodies, 1e-6);
}

/* Where motion is prescribed and the structure does not fall, the mechanism is its last motion; where it has
 * collapsed in time, that in which it does. */
static void
check_last_motion (QnCheck *check)
{
  const QnResult *r = check->result;
  size_t n = (size_t) check->assembly.unknown_count, last = r->step_count - 1;
  bool in_time = r->history.width > 0;
  double *motion = check->residual, product = 0, square = 0;

  if (in_time
        ? r->outcome != QN_OUTCOME_COLLAPSE || r->velocities == NULL
            || r->history.collapse_time < r->steps[last].time
        : qn_check_stage (check, r->steps[last].stage).procedure == QN_PROCEDURE_LOAD
            || r->limit.given || r->vibration.mode > 0
            || r->stability != QN_STABILITY_UNKNOWN || last == 0)
    return;
  qn_assembly_collect (&check->assembly,
                       in_time
                         ? r->velocities + last * qn_result_body_count (r) * QN_DOF_COUNT
                         : qn_result_step_displacements (r, last - 1),
                       motion);
  for (size_t i = 0; i < n; i++) {
    motion[i] = in_time ? motion[i] : check->u[i] - motion[i];
    product += check->velocity[i] * motion[i];
    square += check->velocity[i] * check->velocity[i];
  }
  double speed = product / square;
  double none = QN_CHECK_TOLERANCE * qn_largest (motion, n);
  if (!in_time)
    none += QN_CHECK_EXACT * check->largest;
  for (size_t i = 0; i < n; i++)
    if (!(speed > 0 && qn_check_agrees (speed * check->velocity[i], motion[i], none)))
      qn_check_tell_model (check, QN_CLAIM_FLOW, (QnId) last, check->velocity[i],
                           motion[i] / speed);
}

void
qn_check_mechanism (QnCheck *check)
{
  const QnResult *result = check->result;
  const QnAssembly *as = &check->assembly;

  if (result->mechanism == NULL || result->step_count == 0)
    return;
  qn_assembly_collect (as, result->mechanism, check->velocity);
  qn_check_bodies (check);
  if (result->history.width > 0 || result->outcome != QN_OUTCOME_COLLAPSE) {
    check_last_motion (check);
    return;
  }
  check_work (check);
  if (result->mechanism_uncertain)
    return;
  if (result->mechanism_by_work) {
    /* In large displacements elastic joints give as the structure moves on, by more than
     * RATE. What proves the motion then is its second-order work; that the structure
     * falls along it is the path's to see, for without associative friction it may stand
     * although some motion has negative second-order work. */
    double factors[QN_MAX_LOAD_SETS] = { 0 }, driven[QN_MAX_LOAD_SETS] = { 0 };
    size_t last = result->step_count - 1;
    QnCheckStage stage = qn_check_stage (check, result->steps[last].stage);
    qn_result_load_factors (check->model, result, last, factors);
    for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
      if ((stage.sets >> set & 1) != 0)
        driven[set] = result->collapse_multiplier - stage.before[set];
    qn_assembly_set_loads (&check->assembly, factors, driven);
    if (!qn_moves_on (&check->assembly, check->u, 0, 1, check->velocity, check->rows,
                      check->residual))
      qn_check_tell_model (check, QN_CLAIM_WORK, (QnId) last, NAN, NAN);
    return;
  }
  double *rates = check->rates;
  double none = RATE * qn_largest (check->velocity, (size_t) as->unknown_count);
  qn_assembly_elongation_rates (as, check->velocity, rates);
  for (size_t p = 0; p < as->pair_count; p++)
    if (!as->inactive[p])
      check_joint (check, p, rates + 2 * p, none);
  /* Ties give where they hang slack or have their strength; forces are none or reach the
   * strength within `little`, N. */
  const size_t elements = check->model->element_count;
  const double little = QN_CHECK_LITTLE * check->scale;
  for (size_t i = 0; i < qn_model_tie_count (check->model); i++) {
    const QnBeamResponse *response = &as->beams.responses[elements + i];
    const QnAssembledBeam *at = &as->beams.beams[elements + i];
    double rate = qn_beam_assembly_tie_rate (as, i, check->velocity);
    double force = response->force[0];
    bool hangs =
      !check->result->limit.given
      && at->kinematics.deformation[0] < at->properties.rest + response->memory.stretch;
    bool flows = fabs (rate) <= none || hangs || (rate < 0 && force <= little)
                 || (rate > 0 && force >= qn_tie_strength (at->properties.tie) - little);
    if (!flows)
      qn_check_tell (check, QN_CLAIM_FLOW, (QnId) check->result->step_count - 1,
                     QN_ENTITY_TIE, (QnId) i, rate, 0);
  }
  if (!as->nonlinear)
    check_beams (check, none);
}
