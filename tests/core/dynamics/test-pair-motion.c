/* The forces of a pair within a step: their energy and their tangent. */
#include "core/dynamics/pair-motion.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static const QnSpring spring = {
  .kind = QN_LAW_COULOMB, .kn = 2e6, .ks = 1e6, .friction = 0.6
};

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
init (Step *s, double alpha_f, double damping, const double q0[2])
{
  *s = (Step){
    .springs = qn_pair_springs (spring, spring),
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
  evaluate (s, q);
  QnPairForces forces = qn_pair_motion (&s->elasticity, &s->step, &s->start, &s->end);
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

/* Work of the mean force and of c = change of elastic energy + friction, which is not negative. */
static void
test_energy (void)
{
  for (int i = 0; i < 10000; i++) {
    double q0[2], q1[2];
    Step s;
    random_elongation (q0);
    random_elongation (q1);
    init (&s, 0.4, 0, q0);
    evaluate (&s, q1);
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    double work = 0;
    for (int j = 0; j < 2; j++)
      work += (0.5 * (s.before.force[j] + s.after.force[j]) + forces.correction[j])
              * (q1[j] - q0[j]);
    double stored = qn_pair_elastic_energy (&s.elasticity, &s.end)
                    - qn_pair_elastic_energy (&s.elasticity, &s.start);
    double friction = qn_pair_friction (&s.elasticity, &forces, &s.start, &s.end);
    g_assert_cmpfloat (fabs (work - stored - friction), <, 1e-9);
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
    init (&s, 0.5, 0, closes ? open : closed);
    evaluate (&s, closes ? closed : open);
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    double mean = 0.5 * (s.before.force[0] + s.after.force[0]) + forces.correction[0];
    /* 1/2 k x^2 over the way */
    g_assert_cmpfloat (fabs (mean * 4e-4 + 0.5 * 1e6 * 1e-8), <, 1e-12);
  }
}

static void
test_tangent (void)
{
  for (int i = 0; i < 4000; i++) {
    double q0[2], q1[2], low[2], high[2];
    Step s;
    random_elongation (q0);
    random_elongation (q1);
    init (&s, 0.4, i % 2 == 0 ? 0 : 1e-3, q0);
    s.step.of = i % 4 < 2 ? QN_DAMPING_INITIAL : QN_DAMPING_CURRENT;
    evaluate (&s, q1);
    int16_t phase = s.after.phase;
    QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
    const double h = 1e-9;
    for (int j = 0; j < 2; j++) {
      double left[2] = { q1[0], q1[1] }, right[2] = { q1[0], q1[1] };
      left[j] -= h;
      right[j] += h;
      force_at (&s, left, low);
      gboolean same = s.after.phase == phase;
      force_at (&s, right, high);
      same = same && s.after.phase == phase;
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
  init (&s, 0.4, 1e-3, open);
  evaluate (&s, wider);
  QnPairForces forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  g_assert_cmpfloat (forces.dashpot[0], ==, 0);
  g_assert_cmpfloat (forces.dashpot[1], ==, 0);
  s.step.of = QN_DAMPING_INITIAL;
  forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  g_assert_cmpfloat (forces.dashpot[0], >, 0);

  const double pressed[2] = { -1e-4, 5e-4 }, slides[2] = { -1e-4, 6e-4 };
  init (&s, 0.4, 1e-3, pressed);
  evaluate (&s, slides);
  forces = qn_pair_motion (&s.elasticity, &s.step, &s.start, &s.end);
  double sticks = 1e-3 * 1e6 * 0.05; /* what it would be */
  g_assert_cmpfloat (fabs (forces.dashpot[1]), <, 0.7 * sticks);
}

QN_TESTS
{
  g_test_add_func ("/pair-motion/energy", test_energy);
  g_test_add_func ("/pair-motion/impact", test_impact);
  g_test_add_func ("/pair-motion/tangent", test_tangent);
  g_test_add_func ("/pair-motion/dashpot", test_dashpot);
}
