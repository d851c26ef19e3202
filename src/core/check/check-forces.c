/* Displacements, forces, strengths, states and balance at a step. */
#include "core/base/numbers.h"
#include "core/check/check-parts.h"

#include <math.h>
#include <string.h>

/* --- Forces ------------------------------------------------------------------------------- */

/* Whether nothing of both blocks of a pair is free to move: what lies between supports carries no
 * load, and its state is one of rounding. */
static bool
is_held (const QnAssembly *as, size_t p)
{
  const QnContactFace *face = &as->contacts->faces[as->contacts->pairs[p].face];
  const int32_t *a = as->unknown + QN_DOF_COUNT * face->a;
  const int32_t *b = as->unknown + QN_DOF_COUNT * face->b;
  bool held = true;

  for (int i = 0; i < QN_DOF_COUNT; i++)
    held = held && (a[i] == QN_NONE || as->settles[a[i]])
           && (b[i] == QN_NONE || as->settles[b[i]]);
  return held;
}

static bool
same_force (const double *a, const double *b, double tolerance)
{
  return qn_check_agrees (a[0], b[0], tolerance)
         && qn_check_agrees (a[1], b[1], tolerance);
}

/* Part of a force carried by friction at elongation q of a spring with damaged bond. Of a normal force
 *
 *   stated = (1 - d) kn (q - k) + d kn (q - k - h (s)),   s the slip that explains the shear force,
 *
 * the shortening by crushing, -k, is taken into `start` where it has grown on the way. */
static void
take_friction (const QnSpring *s, QnSpringMemory *start, double damage, const double q[2],
               const double stated[2], double friction[2])
{
  friction[1] = (stated[1] - (1 - damage) * s->ks * q[1]) / damage;
  double before = qn_spring_crushed (s, start);
  double risen = qn_spring_dilation (s, q[1] - friction[1] / s->ks);
  double crushed = q[0] - damage * risen - stated[0] / s->kn;
  if (s->compression > 0 && !s->associative && stated[0] < 0 && crushed < before) {
    start->opening += crushed - before;
    before = crushed;
  }
  friction[0] = (stated[0] - (1 - damage) * s->kn * (q[0] - before)) / damage;
}

/* The slip and opening of one spring of a pair, of `b` where `second`, that leave the pair, its bond damaged
 * as after the step, with this force at elongation q. The other spring is elastic meanwhile: of two that slide
 * all that is new counts as this one's, for which of them slid makes no difference to both together. False
 * for what is not elastic and perfectly plastic. */
static bool
take_flow (const QnCheck *check, const QnPairSprings *springs, const QnPairMemory *before,
           const QnPairMemory *after, const double q[2], const double stated[2],
           bool second, QnPairMemory *memory)
{
  const QnSpring *s = second ? &springs->b : &springs->a;
  const QnSpring *other = springs->equal ? NULL : second ? &springs->a : &springs->b;
  QnSpringMemory *own = second ? &memory->b : &memory->a;
  const QnSpringMemory *rest = second ? &memory->a : &memory->b;
  QnSpringMemory start = second ? before->b : before->a;
  double force[2] = { stated[0], stated[1] };
  double stuck[2] = { 0, 0 },
         strain[2]; /* elongations of the other spring and of this one */

  *memory = *before;
  qn_pair_keep_damage (springs, after, memory);
  double damage = qn_spring_damage (s, own);
  if (!qn_law_is_plastic (s->kind))
    return false;
  if (other != NULL) {
    double lost = qn_spring_damage (other, rest);
    if (!(qn_law_is_plastic (other->kind) || other->kind == QN_LAW_ELASTIC)
        || (lost > 0 && lost < 1))
      return false;
    stuck[0] = rest->opening + force[0] / other->kn;
    stuck[1] = rest->slip + force[1] / other->ks;
  }
  for (int i = 0; i < 2; i++) {
    strain[i] = q[i] - stuck[i];
    memory->qa[i] = second ? stuck[i] : strain[i];
    memory->qb[i] = second ? strain[i] : stuck[i];
  }
  if (qn_spring_has_bond (s) && damage <= 0) {
    own->opening = strain[0] - force[0] / s->kn; /* crushed, the bond whole */
    return s->kind == QN_LAW_MOHR_COULOMB && own->opening <= start.opening;
  }
  if (damage > 0 && damage < 1)
    take_friction (s, &start, damage, strain, stated, force);
  bool dilates = s->dilatancy > 0 || (other != NULL && other->dilatancy > 0);
  /* What slides back may lose more strength than shear force: not beyond its strength by rounding. */
  double within = dilates ? 1 - 0.1 * QN_CHECK_FORCES : 1;
  own->slip = strain[1] - within * force[1] / s->ks;
  bool crushes = s->kind == QN_LAW_MOHR_COULOMB
                 || (other != NULL && other->kind == QN_LAW_MOHR_COULOMB);
  double opening = strain[0] - force[0] / s->kn;
  /* An open joint remembers its dilation by slip alone, unless it was crushed on the way there. */
  double most = force[0] >= -QN_CHECK_FORCES * check->scale
                  ? qn_spring_risen (s, &start, own->slip)
                  : INFINITY;
  if (check->relaxed || dilates || crushes)
    own->opening = fmin (opening, most);
  return crushes || memory->a.opening + memory->b.opening >= -check->slack;
}

/* Whether a force is within `little` of one of the strengths of a pair. */
static bool
is_near_strength (const QnPairSprings *springs, const QnPairMemory *memory,
                  const double force[2], double little)
{
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  int count = qn_pair_strength (springs, memory, rows);

  for (int i = 0; i < count; i++)
    if (fabs (rows[i].normal * force[0] + rows[i].shear * fabs (force[1]) - rows[i].limit)
        <= little)
      return true;
  return false;
}

static double
force_tolerance (const QnCheck *check, const QnPairSprings *springs, const double *q)
{
  /* Elongations are differences of displacements, as exact as those. */
  double stiffness = fmax (springs->a.kn, springs->a.ks);
  double rounding = QN_CHECK_EXACT * stiffness * (check->largest + hypot (q[0], q[1]));

  return QN_CHECK_FORCES * check->scale + rounding;
}

static bool
is_plastic (const QnPairSprings *springs)
{
  return qn_law_is_plastic (springs->a.kind) && qn_law_is_plastic (springs->b.kind);
}

/* Evaluates a pair from the flow of a joint that explains its force; false where there is none. */
static bool
flow_to (const QnCheck *check, size_t p, const double force[2], QnPairResponse *response)
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  const QnPairMemory *before = &check->assembly.committed[p];
  const double *q = check->assembly.elongations + 2 * p;

  for (int side = 0; side < (springs->equal ? 1 : 2); side++) {
    QnPairMemory memory;
    QnPairResponse flown;
    if (take_flow (check, springs, before, &response->memory, q, force, side == 1,
                   &memory)
        && qn_pair_evaluate (springs, &memory, q, &flown)
        && same_force (flown.force, force, force_tolerance (check, springs, q))) {
      *response = flown;
      return true;
    }
  }
  return false;
}

/* The response of a pair whose elongation differs by what changes a force by `little`, in one of four ways. */
static bool
evaluate_near (const QnCheck *check, size_t p, int way, double little,
               QnPairResponse *response)
{
  const QnAssembly *as = &check->assembly;
  const QnPairSprings *springs = &as->springs[p];
  double q[2] = { as->elongations[2 * p], as->elongations[2 * p + 1] };

  q[way / 2] +=
    (way % 2 == 0 ? little : -little) / (way / 2 == 0 ? springs->a.kn : springs->a.ks);
  return qn_pair_evaluate (springs, &as->committed[p], q, response);
}

/* What a step states of the bond of a pair: as much damage as the laws answer. More there may be where the
 * structure has moved on the way, and stays from then on: of the bond that explains the force. */
static void
take_damage (QnCheck *check, size_t step, size_t p)
{
  QnAssembly *as = &check->assembly;
  const QnPairSprings *springs = &as->springs[p];
  QnPairResponse *response = &as->responses[p];
  QnPairMemory *before = &as->committed[p];
  double found = qn_pair_damage (springs, &response->memory);
  const QnPairResult at = check->stated[p];
  bool moved =
    check->result->steps[step].relaxed || check->lost || check->result->history.width > 0;
  bool bond = qn_spring_has_bond (&springs->a) || qn_spring_has_bond (&springs->b);
  if ((moved || check->unknown[p]) && !bond) /* of a member: any, as its forces are */
    return;
  const double force[2] = { at.normal_force, at.shear_force };
  bool other = !springs->equal && at.damage == found && found > 0
               && !same_force (response->force, force,
                               force_tolerance (check, springs, as->elongations + 2 * p));
  if ((at.damage > found || other) && at.damage <= 1 && moved) {
    const QnPairMemory start = *before;
    bool weaker = springs->b.cohesion > 0 && springs->b.cohesion < springs->a.cohesion;
    /* By itself, or by a flow. */
    for (int i = 0; i < 4; i++) {
      bool in_b = (weaker && !springs->equal) != (i % 2 == 1);
      if ((springs->equal && i % 2 == 1)
          || !qn_spring_has_bond (in_b ? &springs->b : &springs->a))
        continue;
      *before = start;
      *(in_b ? &before->b.extreme : &before->a.extreme) = at.damage;
      qn_pair_evaluate (springs, before, as->elongations + 2 * p, response);
      QnPairResponse flown = *response;
      if (i < 2 ? same_force (response->force, force,
                              force_tolerance (check, springs, as->elongations + 2 * p))
                : flow_to (check, p, force, &flown))
        break;
    }
    found = qn_pair_damage (springs, &response->memory);
  }
  /* At its strength a brittle bond is whole, or broken, by rounding. */
  for (int way = 0; way < 4 && !qn_check_agrees (at.damage, found, QN_CHECK_STATE);
       way++) {
    QnPairResponse near;
    if (evaluate_near (check, p, way, 0.1 * QN_CHECK_FORCES * check->scale, &near)
        && qn_check_agrees (at.damage, qn_pair_damage (springs, &near.memory),
                            QN_CHECK_STATE)) {
      *response = near;
      found = at.damage;
    }
  }
  if (!qn_check_agrees (at.damage, found, QN_CHECK_STATE))
    qn_check_tell_pair (check, QN_CLAIM_STATES, step, p, at.damage, found);
}

/* Whether some law of a pair takes other normal forces after another way. Across a pair without joints laws are
 * elastic whatever came before, and the force is that of the law's answer. */
static bool
may_differ (const QnCheck *check, size_t p, const double force[2], const double found[2])
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  QnLawKind a = springs->a.kind, b = springs->b.kind;
  double s = springs->slant, c = sqrt (1 - s * s);

  if (qn_law_is_plastic (a) || qn_law_is_plastic (b))
    return !is_plastic (springs);
  return (a != QN_LAW_ELASTIC || b != QN_LAW_ELASTIC)
         && qn_check_agrees (
           c * force[1] - s * force[0], c * found[1] - s * found[0],
           force_tolerance (check, springs, check->assembly.elongations + 2 * p));
}

/* Whether a pair may have another force than its law answers to the step before; *response then is one with
 * this force. Where the structure has moved on a way that no result tells, from a step at which it came to
 * rest on and in time, any flow of a joint that explains its force is accepted, and any normal force of a
 * member. */
static bool
explain (QnCheck *check, size_t p, const double force[2], QnPairResponse *response)
{
  bool in_time = check->result->history.width > 0;

  /* Where a pair that was found has slid before it carries is not known. */
  if (check->assembly.inactive[p] || !(check->relaxed || in_time || check->begins[p]))
    return false;
  if (flow_to (check, p, force, response))
    return true;
  check->unknown[p] = may_differ (check, p, force, response->force);
  return check->unknown[p];
}

/* Compares the forces of a step with those of the laws; leaves the laws' responses in the assembly. */
static void
check_forces (QnCheck *check, size_t step)
{
  QnAssembly *as = &check->assembly;
  const QnStep *told = &check->result->steps[step];

  check->relaxed = check->relaxed || told->relaxed;
  /* Elongations of a step along the central path are exact to a part of the largest
   * change of one, and what is replayed from then on no better. */
  double change = 0;
  for (size_t i = 0; i < 2 * as->pair_count; i++)
    change = fmax (change, fabs (as->elongations[i] - check->elongations[i]));
  memcpy (check->elongations, as->elongations, 2 * as->pair_count * sizeof (double));
  check->change = fmax (check->change, change);
  check->slack = QN_CHECK_EXACT * (1 + check->largest);
  if (check->relaxed)
    check->slack += QN_CHECK_STRAIN * check->change;

  for (size_t p = 0; p < as->pair_count; p++) {
    const double *q = as->elongations + 2 * p;
    const QnPairSprings *springs = &as->springs[p];
    double tolerance = force_tolerance (check, springs, q);
    const double force[2] = { check->stated[p].normal_force,
                              check->stated[p].shear_force };
    /* The force of a crack tells as little of its way where it is what would have been without. */
    if (told->relaxed && qn_law_softens (springs->a.kind) && !is_plastic (springs))
      check->unknown[p] = true;
    if (!check->known)
      continue;
    take_damage (check, step, p);
    QnPairResponse *response = &as->responses[p];
    if (!is_held (as, p) && !same_force (response->force, force, tolerance)) {
      QnPairResponse replayed = *response;
      int worse = !qn_check_agrees (replayed.force[0], force[0], tolerance) ? 0 : 1;
      if (!explain (check, p, force, response))
        qn_check_tell_pair (check, QN_CLAIM_FORCES, step, p, force[worse],
                            replayed.force[worse]);
    } else if (told->relaxed) {
      /* What a joint came to on a way that no result tells is taken up as exactly as its
       * force is stated, where that agrees as it is: later it may be crushed, or its bond
       * damaged, by as little as that. */
      QnPairResponse flown = *response;
      if (!check->assembly.inactive[p] && flow_to (check, p, force, &flown)
          && hypot (flown.force[0] - force[0], flown.force[1] - force[1])
               < hypot (response->force[0] - force[0], response->force[1] - force[1]))
        *response = flown;
    }
    /* What follows is checked with the forces as they are stated. */
    memcpy (response->force, force, sizeof force);
  }
  check->lost = !check->known && (check->lost || told->relaxed);
}

/* Largest force at a step, in the loads or in joints, beams and ties. */
static double
find_scale (QnCheck *check, size_t step)
{
  const QnAssembly *as = &check->assembly;
  const QnBeamForces *beams = qn_result_step_beam_forces (check->result, step);
  const QnTieResult *ties = qn_result_step_ties (check->result, step);
  double scale = as->force_scale;

  for (int32_t i = 0; i < as->unknown_count; i++)
    if (!as->settles[i])
      scale = fmax (scale, fabs (as->dead[i]));
  for (size_t p = check->known ? 0 : check->contacts->pair_count; p < as->pair_count; p++)
    if (!is_held (as, p))
      scale =
        fmax (scale, hypot (check->stated[p].normal_force, check->stated[p].shear_force));
  for (size_t e = 0; beams != NULL && e < check->model->element_count; e++)
    for (int end = 0; end < 2; end++)
      scale = fmax (scale, hypot (beams[e].normal[end], beams[e].shear[end]));
  for (size_t i = 0; ties != NULL && i < check->result->tie_count; i++)
    scale = fmax (scale, fabs (ties[i].force));
  return scale;
}

static void
check_strength (QnCheck *check, size_t step)
{
  const QnAssembly *as = &check->assembly;
  QnLastForces *last = &check->faults->last;
  double worst = 0, largest = 0;
  QnId worst_pair = QN_NONE;

  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairSprings *springs = &as->springs[p];
    QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
    const QnPairResult at = check->stated[p];
    largest = fmax (largest, hypot (at.normal_force, at.shear_force));
    int count = check->result->limit.given
                  ? qn_pair_rigid_strength (springs, rows)
                  : qn_pair_strength (springs, &as->responses[p].memory, rows);
    double excess = 0;
    for (int i = 0; i < count; i++)
      excess =
        qn_worse (excess, rows[i].normal * at.normal_force
                            + rows[i].shear * fabs (at.shear_force) - rows[i].limit);
    excess -= QN_BOND_ROUNDING * springs->a.cohesion;
    if (p < check->contacts->pair_count)
      excess = qn_worse (excess, qn_check_excess (check, p));
    if (is_held (as, p))
      continue;
    if (!(excess <= worst)) {
      worst = excess;
      worst_pair = (QnId) p;
    }
    if (!(excess <= check->tolerance * check->scale))
      qn_check_tell_pair (check, QN_CLAIM_STRENGTH, step, p, excess, 0);
  }
  last->pair = worst_pair;
  last->contact_scale = largest;
  last->yield_violation = largest > 0 ? worst / largest : 0;
}

/* Whether a joint stands open by more than what little force would close; rigid blocks do not
 * tell, nor do joints that have dilated on a way that no result tells. */
static bool
is_apart (const QnCheck *check, size_t p)
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  const QnPairMemory *memory = &check->assembly.responses[p].memory;
  bool dilates = springs->a.dilatancy > 0 || springs->b.dilatancy > 0;
  double gap = check->assembly.elongations[2 * p] - memory->a.opening - memory->b.opening;

  return !check->result->limit.given
         && !(dilates && (check->relaxed || check->result->history.width > 0))
         && gap > check->slack + QN_CHECK_STATE * check->scale / springs->a.kn;
}

/* Whether a state is that of the forces alone, where displacements or what came before do not tell it. A
 * very little force may be what an iteration has left. */
static bool
state_suits_force (const QnCheck *check, size_t p, const double force[2],
                   QnPairState state)
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  const QnPairMemory *memory = &check->assembly.responses[p].memory;
  double little = QN_CHECK_STATE * check->scale;
  double damage = qn_pair_damage (springs, memory);
  bool second = !springs->equal && qn_spring_damage (&springs->a, &memory->a) < damage;
  const QnSpring *s = second ? &springs->b : &springs->a; /* the damaged one */

  if (state == QN_PAIR_YIELD && !qn_law_yields (springs->a.kind)
      && !qn_law_yields (springs->b.kind))
    return false;
  if (state == QN_PAIR_STICK
      || hypot (force[0], force[1]) <= QN_CHECK_FORCES * check->scale)
    return state == QN_PAIR_STICK ? hypot (force[0], force[1]) > 0
                                  : state == QN_PAIR_OPEN || !is_apart (check, p);
  if (state == QN_PAIR_YIELD)
    return is_near_strength (springs, memory, force, little);
  if (damage > 0 && damage < 1 && qn_law_may_bond (s->kind)) { /* the rest is elastic */
    const QnPairSprings dry = { .a = qn_spring_broken (s), .equal = true };
    const QnPairMemory own = { .a = second ? memory->b : memory->a };
    const QnPairMemory *before = &check->assembly.committed[p];
    QnSpringMemory start = second ? before->b : before->a;
    const double *strain = springs->equal ? check->assembly.elongations + 2 * p
                           : second       ? memory->qb
                                          : memory->qa;
    double friction[2];
    take_friction (s, &start, damage, strain, force, friction);
    return qn_pair_state_of_force (&dry, &own, state, friction, little / damage) == state;
  }
  return qn_pair_state_of_force (springs, memory, state, force, little) == state;
}

/* Whether a pair comes to a state at the elongation of a step, or as near to it as forces agree. */
static bool
comes_to_state (const QnCheck *check, size_t p, QnPairState state)
{
  QnPairResponse response = check->assembly.responses[p];
  bool comes = response.state == state;

  for (int way = 0; way < 4 && !comes; way++)
    comes = evaluate_near (check, p, way, QN_CHECK_STATE * check->scale, &response)
            && response.state == state;
  return comes;
}

/* Whether the force of a joint whose bond is damaged tells the state, since the structure has moved on a way
 * that no result tells. Where little of the bond is damaged little of the force is friction, so that one that
 * agrees with the law's hardly tells how far the joint slid there. */
static bool
flows_to_state (const QnCheck *check, size_t p, const double force[2], QnPairState state)
{
  const QnPairSprings *springs = &check->assembly.springs[p];
  QnPairResponse response = check->assembly.responses[p];

  return check->relaxed && qn_pair_damage (springs, &response.memory) > 0
         && flow_to (check, p, force, &response) && response.state == state;
}

/* Whether a pair has hardly flown since the step before, as its forces and displacements tell; without friction the
 * force does not. */
static bool
stays (const QnCheck *check, size_t p)
{
  const QnPairMemory *before = &check->assembly.committed[p];
  const QnPairMemory *after = &check->assembly.responses[p].memory;

  return fabs (after->a.slip - before->a.slip) <= check->slack
         && fabs (after->a.opening - before->a.opening) <= check->slack;
}

static void
check_states (QnCheck *check, size_t step)
{
  const QnAssembly *as = &check->assembly;
  const QnResult *result = check->result;
  bool by_force =
    result->limit.given || result->history.width > 0 || result->steps[step].relaxed;
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];

  for (size_t p = 0; p < as->pair_count; p++) {
    const QnPairSprings *springs = &as->springs[p];
    QnPairState state = check->stated[p].state;
    const double force[2] = { check->stated[p].normal_force,
                              check->stated[p].shear_force };
    double size = hypot (force[0], force[1]);
    bool by_little = size <= QN_CHECK_FORCES * check->scale;
    bool told = by_force || check->begins[p] || stays (check, p)
                || ((by_little || state != QN_PAIR_STICK)
                    && qn_pair_strength (springs, &as->responses[p].memory, rows) > 0);
    bool suits = is_held (as, p) || check->unknown[p] ? true
                 : as->inactive[p]
                   ? state == QN_PAIR_OPEN
                   : comes_to_state (check, p, state)
                       || flows_to_state (check, p, force, state)
                       || (told && state_suits_force (check, p, force, state));
    if (!suits)
      qn_check_tell_pair (check, QN_CLAIM_STATES, step, p, state, as->responses[p].state);
  }
}

/* --- Balance ------------------------------------------------------------------------------ */

static void
check_reactions (QnCheck *check, size_t step)
{
  QnAssembly *as = &check->assembly;
  const QnResult *result = check->result;
  const double *stated = qn_result_step_reactions (result, step);

  if (result->reactions == NULL || result->limit.given)
    return;
  qn_assembly_reactions (as, 0, check->rows);
  double tolerance = QN_CHECK_FORCES * check->scale;
  for (size_t s = 0; s < result->support_count; s++)
    for (size_t dof = 0; dof < QN_DOF_COUNT; dof++) {
      double found = check->rows[(size_t) result->supports[s] * QN_DOF_COUNT + dof];
      double unit = dof == QN_DOF_RZ ? as->length : 1;
      if (!qn_check_agrees (stated[s * QN_DOF_COUNT + dof], found,
                            unit * tolerance + check->tolerance * fabs (found)))
        qn_check_tell (check, QN_CLAIM_REACTIONS, (QnId) step, QN_ENTITY_BLOCK,
                       result->supports[s], stated[s * QN_DOF_COUNT + dof], found);
    }
}

static void
check_beam_forces (QnCheck *check, size_t step)
{
  const QnBeamForces *stated = qn_result_step_beam_forces (check->result, step);
  double tolerance = QN_CHECK_FORCES * check->scale;

  qn_beam_assembly_forces (&check->assembly, 0, check->beam_forces);
  if (stated == NULL && check->model->element_count > 0 && !check->faults->in_time)
    qn_check_tell_model (check, QN_CLAIM_BEAM_FORCES, (QnId) step, NAN, NAN);
  if (stated == NULL)
    return;
  for (size_t e = 0; e < check->model->element_count; e++)
    for (int end = 0; end < 2; end++) {
      const QnBeamForces *found = &check->beam_forces[e];
      const double pairs[3][2] = { { stated[e].normal[end], found->normal[end] },
                                   { stated[e].shear[end], found->shear[end] },
                                   { stated[e].moment[end], found->moment[end] } };
      for (int i = 0; i < 3; i++)
        if (!qn_check_agrees (pairs[i][0], pairs[i][1],
                              tolerance * (i == 2 ? check->assembly.length : 1)
                                + check->tolerance * fabs (pairs[i][1])))
          qn_check_tell (check, QN_CLAIM_BEAM_FORCES, (QnId) step, QN_ENTITY_BEAM,
                         check->model->elements[e].beam, pairs[i][0], pairs[i][1]);
    }
}

/* A tie has yielded between two steps: what is plastic then follows from its force. */
static bool
take_stretch (const QnAssembledBeam *tie, double force, double tolerance,
              QnBeamResponse *response)
{
  const QnBeamProperties *p = &tie->properties;
  double stretch = tie->kinematics.deformation[0] - p->rest - force / p->axial;

  if (force <= 0) /* hanging slack, it may have been longer still */
    stretch = fmax (stretch, response->memory.stretch);
  if (force < 0 || force > qn_tie_strength (p->tie) + tolerance
      || stretch < response->memory.stretch - tolerance / p->axial)
    return false;
  response->memory.stretch = stretch;
  response->force[0] = force;
  return true;
}

static void
check_ties (QnCheck *check, size_t step)
{
  const QnResult *result = check->result;
  const QnModel *model = check->model;
  QnBeamAssembly *members = &check->assembly.beams;
  bool rigid = result->limit.given, last = step + 1 == result->step_count;
  const QnTieResult *stated = result->tie_count == qn_model_tie_count (model)
                                ? qn_result_step_ties (result, step)
                                : NULL;

  if (qn_model_tie_count (model) == 0 || (rigid && !last))
    return;
  if (stated == NULL)
    qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, QN_NONE, NAN, NAN);
  for (size_t i = 0; stated != NULL && i < qn_model_tie_count (model); i++) {
    const QnTie *tie = qn_model_tie (model, i);
    const size_t member = model->element_count + i;
    const QnAssembledBeam *at = &members->beams[member];
    QnBeamResponse *response = &members->responses[member];
    /* Tolerance of a tie's force: rounding of displacements, plus the tolerance of forces
     * of joints. */
    double tolerance = QN_CHECK_FORCES * check->scale
                       + QN_CHECK_EXACT * check->largest * at->properties.axial;
    double force = stated[i].force, elongation = at->kinematics.deformation[0];
    bool suits = true;

    if (rigid)
      suits = force >= -tolerance && force <= qn_tie_strength (tie) + tolerance;
    else if (!qn_check_agrees (force, response->force[0], tolerance))
      suits = (check->relaxed || result->history.width > 0)
              && take_stretch (at, force, tolerance, response);
    if (!suits)
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i, force,
                     response->force[0]);
    if (!qn_check_agrees (stated[i].elongation, rigid ? 0 : elongation,
                          4 * QN_CHECK_EXACT * (check->largest + fabs (elongation))))
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i,
                     stated[i].elongation, elongation);
    if (stated[i].state != qn_tie_state (tie, force, 0)
        && stated[i].state != qn_tie_state (tie, force, tolerance))
      qn_check_tell (check, QN_CLAIM_TIES, (QnId) step, QN_ENTITY_TIE, (QnId) i, force,
                     NAN);
    response->force[0] = force; /* for the balance */
  }
}

void
qn_check_forces (QnCheck *check, size_t step)
{
  const QnResult *result = check->result;
  bool in_time = result->history.width > 0, last = step + 1 == result->step_count;

  /* What the result states of drawn pairs at a step, at the last one in all digits. */
  size_t drawn = check->contacts->pair_count;
  check->known = drawn == 0 || qn_result_has_forces (check->result, step);
  for (size_t p = 0; p < drawn; p++) {
    const double *answer = check->assembly.responses[p].force;
    check->stated[p] = check->known ? qn_result_pair_at (check->result, step, p)
                                    : (QnPairResult){ .normal_force = answer[0],
                                                      .shear_force = answer[1] };
  }
  check->scale = find_scale (check, step);
  /* Displacements without unknowns: supports, nodes on blocks; rigid blocks at collapse
   * have not moved. */
  const QnAssembly *as = &check->assembly;
  const double *rows = qn_result_step_displacements (check->result, step);
  size_t bodies = qn_model_body_count (check->model);
  qn_assembly_expand (as, check->u, check->rows);
  if (check->result->limit.given)
    memset (check->rows, 0, bodies * QN_DOF_COUNT * sizeof *check->rows);
  qn_check_rows (check, QN_CLAIM_DISPLACEMENTS, (QnId) step, rows, bodies,
                 QN_CHECK_EXACT * qn_largest (check->rows, bodies * QN_DOF_COUNT));
  if (!result->limit.given) {
    double largest = 0; /* of the settlements in whole: one may have been taken back */
    for (size_t i = 0; i < check->model->live_load_count; i++) {
      const QnLoad *load = &check->model->live_loads[i];
      double unit = load->dof == QN_DOF_RZ ? as->length : 1;
      if (load->kind == QN_LOAD_SETTLEMENT)
        largest = fmax (largest, fabs (load->value) * unit);
    }
    for (size_t s = 0; s < as->settling_count; s++) {
      double told = as->dead[as->settling[s].unknown] / as->stiffness;
      if (!qn_check_agrees (as->settling[s].u, told, check->tolerance * largest))
        qn_check_tell (check, QN_CLAIM_DISPLACEMENTS, (QnId) step, QN_ENTITY_BLOCK,
                       as->settling[s].block, as->settling[s].u, told);
    }
    check_forces (check, step);
    check_beam_forces (check, step);
  }
  check_ties (check, step);
  if (check->known) {
    check_strength (check, step);
    check_states (check, step);
  }
  if (!check->lost) {
    /* Rigid blocks have no forces but at collapse. */
    if (!(in_time && step > 0) && !(result->limit.given && !last))
      qn_check_balance (check, step);
    check_reactions (check, step);
  }
  if (last) {
    /* The last step's forces, states and bonds stand in a result twice. */
    size_t first = (result->step_count - 1) * result->pair_count;
    for (size_t p = 0; p < result->pair_count && result->step_forces != NULL; p++) {
      const double *stated = result->step_forces + 2 * (first + p);
      const double force[2] = { result->pairs[p].normal_force,
                                result->pairs[p].shear_force };
      if (!same_force (stated, force, check->tolerance * check->scale)
          || result->step_states[first + p] != result->pairs[p].state
          || !qn_check_agrees (
            result->step_damage != NULL ? result->step_damage[first + p] : 0,
            result->pairs[p].damage, QN_CHECK_STATE))
        qn_check_tell (check, QN_CLAIM_FORCES, (QnId) result->step_count - 1,
                       QN_ENTITY_CONTACT, (QnId) p, stated[0], force[0]);
    }
  }
}
