#include "core/contact/contact-pair.h"

#include "core/base/tolerance.h"
#include "core/contact/pair-series.h"

#include <math.h>
#include <string.h>

/* Most iterations of the internal Newton; a handful is usual, one per change of branch. */
#define INTERNAL_ITERATIONS 16

/* Most sweeps where that is not enough. */
#define INTERNAL_SWEEPS 60

/* Rounds of both: near where one spring slides back and the other opens sweeps take long. */
#define INTERNAL_ROUNDS 4

/* Whether all that a joint carries, its bond whole, damaged or broken, neither breaks the bond of the spring
 * on the other side nor cracks it: the corner of its strengths does not, and its friction is no higher. */
static bool
outlasts (const QnSpring *spring, const QnSpring *joint)
{
  double mu = spring->friction, most = joint->cap;
  double shear = fmax (joint->cohesion - joint->friction * most, 0);

  if (!qn_law_may_bond (joint->kind) || most >= spring->cap)
    return false;
  return spring->kind == QN_LAW_CONCRETE
         || (qn_spring_has_bond (spring) && shear + mu * most <= spring->cohesion
             && fmax (joint->friction, joint->residual) <= mu);
}

QnPairSprings
qn_pair_springs (QnSpring a, QnSpring b)
{
  QnPairSprings springs = { .a = a, .b = b, .equal = qn_spring_similar (&a, &b) };
  if (springs.equal) {
    springs.a = qn_spring_join (&a, &b);
    return springs;
  }
  springs.a.outlasts = outlasts (&a, &b);
  springs.b.outlasts = outlasts (&b, &a);
  return springs;
}

void
qn_pair_elastic_stiffness (const QnPairSprings *s, double k[2])
{
  double kn = s->equal ? s->a.kn : 1 / (1 / s->a.kn + 1 / s->b.kn);
  double ks = s->equal ? s->a.ks : 1 / (1 / s->a.ks + 1 / s->b.ks);
  double part = s->slant * s->slant;

  k[0] = (1 - part) * kn + part * ks;
  k[1] = (1 - part) * ks + part * kn;
}

/* Joints touch, slide and open; what else is elastic does not stand in the way of that. */
static bool
is_joint (const QnSpring *spring)
{
  return spring->kind == QN_LAW_NO_TENSION || qn_law_is_plastic (spring->kind);
}

void
qn_pair_vibration_tangent (const QnPairSprings *s, const QnPairResponse *r, double little,
                           bool sliding, double tangent[4])
{
  bool a = is_joint (&s->a), b = is_joint (&s->b);
  bool bond = qn_spring_has_bond (&s->a) || qn_spring_has_bond (&s->b);
  bool closed = r->force[0] < -little || little == 0;
  bool joint =
    (a || s->a.kind == QN_LAW_ELASTIC) && (b || s->b.kind == QN_LAW_ELASTIC) && (a || b);
  double k[2];

  memcpy (tangent, r->tangent, sizeof r->tangent);
  if (!joint || (closed && sliding))
    return;
  double share = closed ? 1 : bond ? 1 - qn_pair_damage (s, &r->memory) : 0;
  qn_pair_elastic_stiffness (s, k);
  tangent[0] = share * k[0];
  tangent[3] = share * k[1];
  tangent[1] = tangent[2] = 0;
}

/* The most that a spring carries, N, in tension and in compression. */
static void
find_strength (const QnSpring *s, double *tension, double *compression)
{
  bool concrete = s->kind == QN_LAW_CONCRETE;
  bool opens = concrete || s->kind == QN_LAW_NO_TENSION || qn_law_may_bond (s->kind);

  *tension = opens ? s->cap : INFINITY;
  *compression = concrete ? s->strength : s->compression > 0 ? s->compression : INFINITY;
}

/* The steepest descent of a spring that the other one is strong enough to bring about. */
static double
reached_softening (const QnSpring *spring, const QnSpring *other)
{
  double own[2], most[2];
  QnSpring reached = *spring;

  find_strength (spring, &own[0], &own[1]);
  find_strength (other, &most[0], &most[1]);
  if (most[0] < own[0])
    reached.cap = 0;
  if (most[1] < own[1]) {
    reached.ultimate = INFINITY;
    reached.crushing = 0;
  }
  return qn_spring_softening (&reached);
}

bool
qn_pair_springs_snap_back (const QnPairSprings *springs)
{
  const QnSpring *a = &springs->a, *b = &springs->b;

  if (springs->equal)
    return !isfinite (qn_spring_softening (a));
  return reached_softening (a, b) >= b->kn || reached_softening (b, a) >= a->kn;
}

static void
evaluate_joined (const QnPairSprings *springs, const QnPairMemory *committed,
                 const double q[2], QnPairResponse *r)
{
  QnSpringResponse whole;
  double share = springs->a.kn / springs->b.kn; /* b's length over the joint one */

  qn_spring_evaluate (&springs->a, &committed->a, q, &whole);
  r->memory = (QnPairMemory){ .a = whole.memory };
  for (int i = 0; i < 2; i++) {
    r->force[i] = whole.force[i];
    r->tangent[i][0] = whole.tangent[i][0];
    r->tangent[i][1] = whole.tangent[i][1];
    r->memory.qb[i] = share * q[i];
    r->memory.qa[i] = q[i] - r->memory.qb[i];
  }
  r->state = whole.state;
  r->varies = whole.varies;
}

static bool
solve_series (const QnPairSprings *springs, const QnPairMemory *committed,
              const double q[2], QnPairResponse *r)
{
  QnPairSeries series;
  qn_pair_series_start (&series, springs, committed, q);
  for (int round = 0; round < INTERNAL_ROUNDS; round++) {
    for (int i = 0; i < INTERNAL_ITERATIONS && !(series.size <= QN_TOLERANCE_SERIES); i++)
      qn_pair_series_step (&series);
    for (int i = 0; i < INTERNAL_SWEEPS && !(series.size <= QN_TOLERANCE_SERIES); i++)
      qn_pair_series_sweep (&series);
  }
  /* The pair's response from the state that the iteration ended in. */
  static const int ranks[QN_PAIR_STATE_COUNT] = {
    [QN_PAIR_STICK] = 0, [QN_PAIR_YIELD] = 1, [QN_PAIR_SLIP] = 2, [QN_PAIR_OPEN] = 3
  };
  const QnSpringResponse *a = &series.a, *b = &series.b;
  double inverse[2][2], share[2][2];

  qn_pair_series_flexibility (&series, inverse);
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      share[i][j] = inverse[i][0] * b->tangent[0][j] + inverse[i][1] * b->tangent[1][j];
  for (int i = 0; i < 2; i++) {
    for (int j = 0; j < 2; j++)
      r->tangent[i][j] = a->tangent[i][0] * share[0][j] + a->tangent[i][1] * share[1][j];
    r->force[i] = a->force[i];
    r->memory.qa[i] = series.qa[i];
    r->memory.qb[i] = series.q[i] - series.qa[i];
  }
  r->memory.a = a->memory;
  r->memory.b = b->memory;
  r->state = ranks[a->state] > ranks[b->state] ? a->state : b->state;
  r->varies = a->varies || b->varies;
  return series.size <= QN_TOLERANCE_SERIES;
}

/* In the frame of the springs. A whole bond and a broken one may both be in balance with the other spring;
 * it breaks where it does not hold, and of two the more strained one first, which may relieve the other. */
static bool
evaluate_straight (const QnPairSprings *springs, const QnPairMemory *committed,
                   const double q[2], QnPairResponse *r)
{
  if (springs->equal) {
    evaluate_joined (springs, committed, q, r);
    return true;
  }

  QnPairMemory memory = *committed;
  bool a = qn_bond_hold (&springs->a, &memory.a);
  bool b = qn_bond_hold (&springs->b, &memory.b);
  for (;;) {
    bool solved = solve_series (springs, &memory, q, r);
    bool breaks_a = a && r->memory.a.extreme == QN_BOND_BREAKS;
    bool breaks_b = b && r->memory.b.extreme == QN_BOND_BREAKS;
    if (!breaks_a && !breaks_b)
      return solved || ((a || b) && solve_series (springs, committed, q, r));
    if (breaks_a
        && !(breaks_b
             && qn_spring_bond_strain (&springs->b, r->force)
                  > qn_spring_bond_strain (&springs->a, r->force))) {
      memory.a = committed->a;
      a = false;
    } else {
      memory.b = committed->b;
      b = false;
    }
  }
}

bool
qn_pair_evaluate (const QnPairSprings *springs, const QnPairMemory *committed,
                  const double q[2], QnPairResponse *r)
{
  if (springs->slant == 0)
    return evaluate_straight (springs, committed, q, r);

  double s = springs->slant, c = sqrt (1 - s * s);
  const double own[2] = { c * q[0] + s * q[1], c * q[1] - s * q[0] };
  bool solved = evaluate_straight (springs, committed, own, r);
  double n = r->force[0], t = r->force[1];
  double (*k)[2] = r->tangent, rows[2][2];

  r->force[0] = c * n - s * t;
  r->force[1] = s * n + c * t;
  for (int j = 0; j < 2; j++) {
    rows[0][j] = c * k[0][j] - s * k[1][j];
    rows[1][j] = s * k[0][j] + c * k[1][j];
  }
  for (int i = 0; i < 2; i++) {
    k[i][0] = c * rows[i][0] - s * rows[i][1];
    k[i][1] = s * rows[i][0] + c * rows[i][1];
  }
  return solved;
}

QnPairSprings
qn_pair_springs_broken (const QnPairSprings *springs)
{
  return (QnPairSprings){ .a = qn_spring_broken (&springs->a),
                          .b = qn_spring_broken (&springs->b),
                          .equal = springs->equal };
}

double
qn_spring_bond_strain (const QnSpring *spring, const double force[2])
{
  QnStrengthRow rows[QN_STRENGTH_ROWS];
  int count = qn_spring_has_bond (spring) ? qn_spring_strength (spring, rows) : 0;
  double strain = NAN;

  if (spring->kind == QN_LAW_CONCRETE && spring->cap > 0)
    return force[0] / spring->cap;
  for (int i = 0; i < count; i++) {
    double limit = fmax (rows[i].limit, QN_BOND_ROUNDING * spring->cohesion);
    if (rows[i].normal >= 0 && limit > 0)
      strain = fmax (strain, (rows[i].normal * force[0] + rows[i].shear * fabs (force[1]))
                               / limit);
  }
  return strain;
}

double
qn_pair_bond_strain (const QnPairSprings *springs, const QnPairResponse *response)
{
  if (qn_pair_damage (springs, &response->memory) > 0)
    return NAN;
  double a = qn_spring_bond_strain (&springs->a, response->force);

  return springs->equal ? a
                        : fmax (a, qn_spring_bond_strain (&springs->b, response->force));
}

QnPairState
qn_pair_state_of_force (const QnPairSprings *springs, const QnPairMemory *memory,
                        QnPairState state, const double force[2], double little)
{
  QnStrengthRow rows[2 * QN_STRENGTH_ROWS];
  int count = qn_pair_strength (springs, memory, rows);
  bool opens = false, slides = false;

  if (count == 0 || (state != QN_PAIR_OPEN && state != QN_PAIR_SLIP))
    return state;
  for (int i = 0; i < count; i++) {
    bool reached =
      rows[i].limit - rows[i].normal * force[0] - rows[i].shear * fabs (force[1])
      <= little;
    opens = opens || (reached && rows[i].shear == 0 && rows[i].normal > 0);
    slides = slides || (reached && rows[i].shear > 0);
  }
  if (state == QN_PAIR_OPEN && opens)
    return QN_PAIR_OPEN;
  return slides ? QN_PAIR_SLIP : QN_PAIR_STICK;
}
