/* Coulomb friction with cohesion, tension cut-off and dilatancy.
 *
 * With n the normal force (tension positive), t the shear force, g >= 0 the slip of the step:
 *
 *   yield      f = |t| + mu n - c <= 0,   n <= cap = min(ft, c / mu)
 *   flow       slip += g sign(t),   opening += psi g
 *
 * Return mapping (backward Euler, closed form) from the trial forces n*, t* that the spring
 * would carry without further slip:
 *
 *   stick      f(n*, t*) <= 0:             n = n*,             t = t*
 *   slip       g = f(n*, t*) / (ks + mu psi kn):
 *                                          n = n* - kn psi g,  t = t* - ks g sign(t*)
 *   cap        n* - kn psi g >= cap for the g that brings |t| down to c - mu cap:
 *                                          n = cap,            |t| <= c - mu cap
 *
 * The cap is reversible: a joint that opens carries its cap (nothing, for a dry joint), whatever
 * the opening, and closes again where it opened, raised by dilatancy only. An open dry joint loses
 * its slip because g brings t to zero. With psi = 0 this is the law of the paper on HybriDFEM in
 * two dimensions (equations 1 and 2); psi = mu makes the flow associative and the tangent
 * symmetric.
 */
#include "core/law/law-ops.h"

#include <math.h>

static void
coulomb_slip (const QnSpring *s, double n_trial, double t_trial, QnSpringResponse *r)
{
  double sign = t_trial < 0 ? -1 : 1;
  double stiffness = s->ks + s->friction * s->dilatancy * s->kn;
  double g = (fabs (t_trial) + s->friction * n_trial - s->cohesion) / stiffness;
  double g_n = s->friction * s->kn / stiffness; /* dg / d q[0] */
  double g_t = sign * s->ks / stiffness;        /* dg / d q[1] */

  r->force[0] = n_trial - s->kn * s->dilatancy * g;
  /* From the yield function, so that the result lies on it to the last digit. */
  r->force[1] = sign * (s->cohesion - s->friction * r->force[0]);
  r->tangent[0][0] = s->kn - s->kn * s->dilatancy * g_n;
  r->tangent[0][1] = -s->kn * s->dilatancy * g_t;
  r->tangent[1][0] = -s->friction * sign * r->tangent[0][0];
  r->tangent[1][1] = -s->friction * sign * r->tangent[0][1];
  r->memory.opening += s->dilatancy * g;
  r->memory.slip += sign * g;
  r->phase = sign > 0 ? QN_PHASE_SLIP_POSITIVE : QN_PHASE_SLIP_NEGATIVE;
}

/* At the cap: constant normal force; `g` is the slip that brings the shear force down to the
 * strength that is left there. */
static void
coulomb_cap (const QnSpring *s, double t_trial, double g, QnSpringResponse *r)
{
  double sign = t_trial < 0 ? -1 : 1;

  r->force[0] = s->cap;
  if (g > 0) {
    r->force[1] = sign * s->cap_strength;
    r->memory.slip += sign * g;
    r->memory.opening += s->dilatancy * g;
    r->phase = sign > 0 ? QN_PHASE_OPEN_SLIP_POSITIVE : QN_PHASE_OPEN_SLIP_NEGATIVE;
  } else {
    r->force[1] = t_trial;
    r->tangent[1][1] = s->ks;
    r->phase = QN_PHASE_OPEN_STICK;
  }
  if (s->cap_strength <= 0) {
    r->tangent[1][1] = 0;
    r->phase = QN_PHASE_OPEN;
  }
}

void
qn_law_coulomb_evaluate (const QnSpring *s, const QnSpringMemory *committed,
                         const double q[2], QnSpringResponse *r)
{
  double n_trial = s->kn * (q[0] - committed->opening);
  double t_trial = s->ks * (q[1] - committed->slip);
  double g_at_cap = 0;

  *r = (QnSpringResponse){ .memory = *committed, .phase = QN_PHASE_STICK };
  if (n_trial > s->cap)
    g_at_cap = qn_larger ((fabs (t_trial) - s->cap_strength) / s->ks, 0);
  if (n_trial - s->kn * s->dilatancy * g_at_cap > s->cap) {
    coulomb_cap (s, t_trial, g_at_cap, r);
  } else if (fabs (t_trial) + s->friction * n_trial - s->cohesion > 0) {
    coulomb_slip (s, n_trial, t_trial, r);
  } else {
    r->force[0] = n_trial;
    r->force[1] = t_trial;
    r->tangent[0][0] = s->kn;
    r->tangent[1][1] = s->ks;
  }
}

QnStatus
qn_law_coulomb_check (const QnLaw *law, QnId index, QnDiag *diag)
{
  if (law->dilatancy <= law->friction)
    return QN_OK;
  return qn_diag_set_field (diag, QN_PROBLEM_DILATANCY_ABOVE_FRICTION, QN_ENTITY_LAW,
                            index, "dilatancy", law->dilatancy);
}

void
qn_law_coulomb_resolve (const QnLaw *law, QnLawScale scale, QnSpring *spring)
{
  double apex = law->friction > 0 ? law->cohesion / law->friction : INFINITY;
  double left = law->cohesion - law->friction * law->tension;

  spring->friction = law->friction;
  spring->dilatancy = law->dilatancy;
  spring->cohesion = law->cohesion * scale.force;
  spring->cap = fmin (law->tension, apex) * scale.force;
  spring->cap_strength = law->tension < apex ? left * scale.force : 0;
}

int
qn_law_coulomb_strength (const QnSpring *s, QnStrengthRow rows[])
{
  rows[0] = (QnStrengthRow){ .normal = 1, .limit = s->cap, .opening = 1 };
  rows[1] = (QnStrengthRow){
    .normal = s->friction, .shear = 1, .limit = s->cohesion, .opening = s->dilatancy
  };
  return 2;
}

static const QnLawParameter parameters[] = {
  QN_LAW_PARAMETER ("friction", friction, true, false),
  QN_LAW_PARAMETER ("cohesion", cohesion, false, false),
  QN_LAW_PARAMETER ("tension", tension, false, false),
  QN_LAW_PARAMETER ("dilatancy", dilatancy, false, false),
};

const QnLawOps qn_law_ops_coulomb = {
  QN_LAW_PARAMETERS (parameters),      .check = qn_law_coulomb_check,
  .resolve = qn_law_coulomb_resolve,   .evaluate = qn_law_coulomb_evaluate,
  .strength = qn_law_coulomb_strength, .plastic = true
};
