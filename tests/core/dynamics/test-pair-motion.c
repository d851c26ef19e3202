/* The forces of a pair within a step: their energy and their tangent. */
#include "core/dynamics/pair-motion.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static const QnSpring springs[] = {
  { .kind = QN_LAW_COULOMB, .kn = 2e6, .ks = 1e6, .friction = 0.6, .residual = 0.6 },
  { .kind = QN_LAW_COULOMB, .kn = 2e6, .ks = 1e6, .friction = 0.4, .residual = 0.4 },
  { .kind = QN_LAW_COULOMB, .kn = 2e6, .ks = 1e6, .friction = 0.1, .residual = 0.1 },
  { .kind = QN_LAW_COULOMB,
    .kn = 2e6,
    .ks = 1e6,
    .friction = 0.6,
    .residual = 0.6,
    .dilatancy = 0.2 },
  { .kind = QN_LAW_COULOMB,
    .kn = 2e6,
    .ks = 1e6,
    .friction = 0.6,
    .residual = 0.6,
    .cap = 200,
    .cohesion = 150,
    .energy = { 0.1, 0.2 } },
};
enum { SOFTENS = 4 };

typedef struct Step {
  QnPairSprings springs;
  QnPairElasticity elasticity;
  QnPairStep step;
  QnPairMemory memory;
  QnPairResponse before, after;
  QnPairInstant start, end;
} Step;

static void
evaluate (Step *s, const double q[2])
{
  s->end = (QnPairInstant){ .response = &s->after };
  for (int i = 0; i < 2; i++) {
    s->end.q[i] = q[i];
    s->end.rate[i] = s->start.rate[i] + s->step.rate_gain * (q[i] - s->start.q[i]);
  }
  qn_pair_evaluate (&s->springs, &s->memory, q, &s->after);
}

static void
init (Step *s, const QnSpring *a, const QnSpring *b, double damping, const double q0[2])
{
  const double alpha_f = 0.4;
  *s = (Step){
    .springs = qn_pair_springs (*a, *b),
    .step = { .alpha_f = alpha_f, .rate_gain = 2000, .length = 1e-3, .damping = damping }
  };
  s->elasticity = qn_pair_elasticity (&s->springs);
  QnPairMemory none = { 0 };
  qn_pair_evaluate (&s->springs, &none, q0, &s->before);
  s->memory = s->before.memory;
  s->start = (QnPairInstant){ .q = { q0[0], q0[1] },
                              .rate = { 0.1, -0.05 },
                              .response = &s->before };
}

/* F / (1 - af) without what comes from the start alone. */
static void
force_at (Step *s, const double q[2], double out[2])
{
  QnPairResponse held;
  evaluate (s, q);
  s->step.held = qn_pair_holds_damage (&s->springs, &s->memory, &s->start, &s->end, &held)
                   ? &held
                   : NULL;
  QnPairForces forces = qn_pair_motion (&s->elasticity, &s->step, &s->start, &s->end);
  s->step.held = NULL;
  for (int i = 0; i < 2; i++)
    out[i] = s->after.force[i]
             + (forces.correction[i] + forces.dashpot[i]) / (1 - s->step.alpha_f);
}

static void
random_elongation (double q[2])
{
  q[0] = g_test_rand_double_range (-1e-3, 1e-3);
  q[1] = g_test_rand_double_range (-1e-3, 1e-3);
}

/* The mean of the law's forces along the straight way, in small parts. */
static void
mean_on_the_way (const Step *s, double mean[2])
{
  enum { PARTS = 4000 };
  mean[0] = mean[1] = 0;
  for (int i = 0; i < PARTS; i++) {
    double part = (i + 0.5) / PARTS, q[2];
    QnPairResponse response;
    for (int j = 0; j < 2; j++)
      q[j] = s->start.q[j] + part * (s->end.q[j] - s->start.q[j]);
    g_assert_true (qn_pair_evaluate (&s->springs, &s->memory, q, &response));
    for (int j = 0; j < 2; j++)
      mean[j] += response.force[j] / PARTS;
  }
}

/* c makes of the mean of both ends that along the way; of two springs of different strength nearly. With
 * it the work is what is stored and what slip takes, which is not negative where a joint stays closed. */
static void
test_mean (void)
{
  for (int i = 0; i < 3000; i++) {
    const QnSpring *spring = &springs[i % 3], *other = i % 7 == 0 ? &springs[0] : spring;
    double q0[2], q1[2], mean[2];
    Step s;
    random_elongation (q0);
    random_elongation (q1);
    init (&s, spring, other, 0, q0);
    evaluate (&s, q1);
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    mean_on_the_way (&s, mean);
    for (int j = 0; j < 2 && s.springs.equal; j++) {
      double found = 0.5 * (s.before.force[j] + s.after.force[j]) + forces.correction[j];
      g_assert_cmpfloat (fabs (found - mean[j]), <, 1e-3 * 1e3);
    }
    if (q0[0] < 0 && q1[0] < 0 && s.springs.equal)
      g_assert_cmpfloat (qn_pair_friction (&s.elasticity, &forces, &s.start, &s.end), >,
                         -1e-9);
  }
}

/* The force of a step has no leap, wherever it begins and ends: else short steps have no solution. */
static void
test_no_leap (void)
{
  enum { PARTS = 2000 };
  for (int i = 0; i < 300; i++) {
    const QnSpring *spring = &springs[i % 5 == 0 ? SOFTENS : i % 3];
    const QnSpring *other = i % 7 == 0 && i % 5 > 0 ? &springs[0] : spring;
    double q0[2], from[2], to[2], before[2] = { 0 };
    Step s;
    random_elongation (q0);
    random_elongation (from);
    random_elongation (to);
    if (i % 2 == 0) /* close to where the joint opens */
      q0[0] = 1e-6 * q0[0] + spring->cap / 1e6;
    init (&s, spring, other, i % 4 < 2 ? 0 : 1e-4, q0);
    s.step.of = (QnDampingStiffness) (i / 4 % QN_DAMPING_STIFFNESS_COUNT);
    for (int k = 0; k <= PARTS; k++) {
      double part = (double) k / PARTS, q[2], now[2];
      for (int j = 0; j < 2; j++)
        q[j] = from[j] + part * (to[j] - from[j]);
      force_at (&s, q, now);
      for (int j = 0; j < 2 && k > 0; j++)
        g_assert_cmpfloat (fabs (now[j] - before[j]), <, 1e7 * 2e-3 / PARTS);
      memcpy (before, now, sizeof now);
    }
  }
}

/* A joint that closes from a gap and one that opens exchange exactly what the closed part of the
 * way holds, in one step. */
static void
test_impact (void)
{
  const double open[2] = { 3e-4, 0 }, closed[2] = { -1e-4, 0 };
  for (int closes = 0; closes < 2; closes++) {
    Step s;
    init (&s, &springs[0], &springs[0], 0, closes ? open : closed);
    evaluate (&s, closes ? closed : open);
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    double mean = 0.5 * (s.before.force[0] + s.after.force[0]) + forces.correction[0];
    /* 1/2 k x^2 over the way */
    g_assert_cmpfloat (fabs (mean * 4e-4 + 0.5 * 1e6 * 1e-8), <, 1e-12);
  }
}

/* Whether no corner of the law lies between two elongations that are hardly apart. */
static gboolean
is_near (const QnPairResponse *one, const QnPairResponse *other)
{
  gboolean near = one->state == other->state;
  for (int i = 0; i < 4; i++)
    near = near && fabs (one->tangent[i / 2][i % 2] - other->tangent[i / 2][i % 2]) < 1e3;
  return near;
}

static void
test_tangent (void)
{
  for (int i = 0; i < 4000; i++) {
    double q0[2], q1[2], low[2], high[2];
    const QnSpring *spring = &springs[i / 4 % SOFTENS];
    Step s;
    random_elongation (q0);
    random_elongation (q1);
    if (spring->dilatancy > 0) /* an open joint does not go on to dilate in its tangent */
      q0[0] = -fabs (q0[0]), q1[0] = -fabs (q1[0]) - 1e-3;
    init (&s, spring, spring, i % 2 == 0 ? 0 : 1e-3, q0);
    s.step.of = (QnDampingStiffness) (i / 2 % QN_DAMPING_STIFFNESS_COUNT);
    evaluate (&s, q1);
    QnPairResponse at = s.after;
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    const double h = 1e-9;
    for (int j = 0; j < 2; j++) {
      double left[2] = { q1[0], q1[1] }, right[2] = { q1[0], q1[1] };
      left[j] -= h;
      right[j] += h;
      force_at (&s, left, low);
      gboolean same = is_near (&s.after, &at);
      force_at (&s, right, high);
      same = same && is_near (&s.after, &at);
      for (int k = 0; k < 2 && same; k++) {
        double slope = (high[k] - low[k]) / (2 * h);
        g_assert_cmpfloat (fabs (forces.tangent[k][j] - slope), <,
                           2e-3 * (1e6 + fabs (slope)));
      }
    }
  }
}

/* An open joint has no dashpot of the current stiffness, a sliding one under a constant normal force
 * none either. */
static void
test_dashpot (void)
{
  const double open[2] = { 3e-4, 1e-4 }, wider[2] = { 4e-4, -1e-4 };
  Step s;
  init (&s, &springs[0], &springs[0], 1e-3, open);
  evaluate (&s, wider);
  QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  g_assert_cmpfloat (forces.dashpot[0], ==, 0);
  g_assert_cmpfloat (forces.dashpot[1], ==, 0);
  s.step.of = QN_DAMPING_INITIAL;
  forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  g_assert_cmpfloat (forces.dashpot[0], >, 0);

  const double pressed[2] = { -1e-4, 5e-4 }, slides[2] = { -1e-4, 6e-4 };
  init (&s, &springs[0], &springs[0], 1e-3, pressed);
  evaluate (&s, slides);
  forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  double sticks = 1e-3 * 1e6 * 0.05; /* what it would be */
  g_assert_cmpfloat (fabs (forces.dashpot[1]), <, 0.7 * sticks);
}

/* Damping by impact never pulls, however fast a joint opens, and is that of the current stiffness where it
 * presses. */
static void
test_pressed (void)
{
  gboolean pulled = FALSE;
  for (int i = 0; i < 1000; i++) {
    double q0[2], q1[2];
    Step s;
    random_elongation (q0);
    random_elongation (q1);
    init (&s, &springs[0], &springs[0], 1e-2, q0);
    evaluate (&s, q1);
    QnPairForces usual = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    s.step.of = QN_DAMPING_IMPACT;
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    double own = (1 - s.step.alpha_f) * s.after.force[0]
                 + s.step.alpha_f * s.before.force[0] + usual.correction[0];
    g_assert_cmpfloat (own + forces.dashpot[0], <=, 1e-9);
    if (own + usual.dashpot[0] <= 0)
      g_assert_cmpfloat (forces.dashpot[0], ==, usual.dashpot[0]);
    else
      pulled = TRUE;
  }
  g_assert_true (pulled);
}

QN_TESTS
{
  g_test_add_func ("/pair-motion/pressed", test_pressed);
  g_test_add_func ("/pair-motion/mean", test_mean);
  g_test_add_func ("/pair-motion/no-leap", test_no_leap);
  g_test_add_func ("/pair-motion/impact", test_impact);
  g_test_add_func ("/pair-motion/tangent", test_tangent);
  g_test_add_func ("/pair-motion/dashpot", test_dashpot);
}
