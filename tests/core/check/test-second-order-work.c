/* States that stand are not proved to collapse, whatever motion is claimed for it. */
#include "core/check/result-check.h"
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

typedef struct Case {
  QnModel model;
  QnContacts contacts;
  QnResult result;
} Case;

/* In large displacements, and prepared. */
static void
begin (Case *c)
{
  c->model.analysis.geometry = QN_GEOMETRY_NONLINEAR;
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
}

static void
solve (Case *c, double up_to)
{
  c->model.analysis.max_multiplier = up_to;
  g_assert_cmpint (
    qn_analysis_run (&c->model, &c->contacts, NULL, NULL, &c->result, NULL), ==, QN_OK);
}

static void
end (Case *c)
{
  qn_contacts_clear (&c->contacts);
  qn_model_clear (&c->model);
}

/* Whether the last state is proved to collapse along this motion. */
static gboolean
is_proved (const Case *c, const double *mechanism)
{
  QnResult claim = c->result; /* whose arrays stay the result's */
  QnResultFaults faults;
  g_autofree double *motion =
    g_memdup2 (mechanism, c->result.block_count * QN_DOF_COUNT * sizeof *motion);

  claim.mechanism = motion;
  claim.mechanism_by_work = true;
  claim.mechanism_uncertain = false;
  claim.outcome = QN_OUTCOME_COLLAPSE;
  claim.has_collapse_multiplier = true;
  claim.collapse_multiplier = claim.steps[claim.step_count - 1].multiplier;
  g_assert_cmpint (qn_result_find_faults (&c->model, &c->contacts, &claim,
                                          QN_CHECK_STATED, &faults, NULL),
                   ==, QN_OK);
  for (int i = 0; i < faults.count; i++)
    if (faults.items[i].claim == QN_CLAIM_WORK)
      return FALSE;
  return TRUE;
}

/* The motion of the last step, as a mechanism is told. */
static double *
last_motion (const Case *c)
{
  gsize n = c->result.block_count * QN_DOF_COUNT;
  size_t last = c->result.step_count - 1;
  const double *to = qn_result_step_displacements (&c->result, last);
  const double *from = qn_result_step_displacements (&c->result, last - 1);
  double *motion = g_new (double, n), largest = 0;

  for (gsize i = 0; i < n; i++) {
    motion[i] = to[i] - from[i];
    largest = MAX (largest, fabs (motion[i]));
  }
  g_assert_cmpfloat (largest, >, 0);
  for (gsize i = 0; i < n; i++)
    motion[i] /= largest;
  return motion;
}

/* Below its load a structure stands, and its mechanism, or any other motion, is refused. Nearer to it a
 * wall of friction may have motions of negative second-order work, and stand all the same: one of these has
 * them from 0.95 of its load on. */
static void
refuse_below (Case *c)
{
  static const double parts[] = { 0.5, 0.8, 0.9, 0.94 };
  g_autoptr (GRand) random = g_rand_new_with_seed (5);
  gsize n;

  begin (c);
  solve (c, INFINITY);
  g_assert_cmpint (c->result.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_false (c->result.mechanism_uncertain);
  double collapse = c->result.collapse_multiplier;
  n = c->result.block_count * QN_DOF_COUNT;
  g_autofree double *mechanism = g_memdup2 (c->result.mechanism, n * sizeof *mechanism);
  g_autofree double *any = g_new (double, n);
  g_assert_true (is_proved (c, mechanism));
  qn_result_clear (&c->result);
  for (gsize k = 0; k < G_N_ELEMENTS (parts); k++) {
    solve (c, parts[k] * collapse);
    g_assert_cmpint (c->result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_test_message ("part %g of %g, %zu blocks, %zu steps", parts[k], collapse,
                    c->result.block_count, c->result.step_count);
    g_assert_false (is_proved (c, mechanism));
    g_autofree double *last = last_motion (c);
    g_assert_false (is_proved (c, last));
    for (int i = 0; i < 20; i++) {
      double share = g_rand_double (random); /* from the mechanism to any motion */
      for (gsize j = 0; j < n; j++)
        any[j] = j < QN_DOF_COUNT ? 0
                                  : (1 - share) * mechanism[j]
                                      + share * g_rand_double_range (random, -1, 1);
      g_assert_false (is_proved (c, any));
    }
    qn_result_clear (&c->result);
  }
  end (c);
}

static void
test_rocking_block (void)
{
  for (int soft = 0; soft < 3; soft++) {
    Case c;
    test_model_init_block_on_plane (&c.model, 0.4, 1);
    test_model_add_weight_loads (&c.model, 1);
    c.model.laws[0].kn = c.model.laws[0].ks = pow (10, 9 - soft);
    refuse_below (&c);
  }
}

static void
test_leaning_walls (void)
{
  for (int number = 1; number <= 4; number++) {
    Case c;
    test_model_init_wall (&c.model, number, 0);
    c.model.laws[0].kn = c.model.laws[0].ks = number == 2 ? 1e6 : 1e8;
    refuse_below (&c);
  }
}

/* Follows a structure that never collapses, and refuses its last motion everywhere. Returns how far its
 * last block has turned. */
static double
refuse_on_the_way (Case *c, double up_to)
{
  double turned = 0;

  begin (c);
  for (int k = 1; k <= 10; k++) {
    solve (c, up_to * k / 10);
    g_assert_cmpint (c->result.outcome, ==, QN_OUTCOME_TARGET_REACHED);
    g_autofree double *last = last_motion (c);
    g_assert_false (is_proved (c, last));
    const double *u = qn_result_step_displacements (&c->result, c->result.step_count - 1);
    turned = fabs (u[QN_DOF_COUNT * (c->result.block_count - 1) + QN_DOF_RZ]);
    qn_result_clear (&c->result);
  }
  end (c);
  return turned;
}

/* A column on an elastic joint, below its critical load and above: it bends far, and carries more. */
static void
test_column (void)
{
  Case c;
  test_model_init_block_on_plane (&c.model, 0.5, 3);
  test_model_add_weight_loads (&c.model, 1);
  c.model.live_loads[0].vector = qn_vec2 (0.02, -1);
  c.model.laws[0].kind = QN_LAW_ELASTIC;
  c.model.laws[0].friction = 0;
  c.model.laws[0].kn = c.model.laws[0].ks = 1e6;
  double turned = refuse_on_the_way (&c, 16);
  g_assert_cmpfloat (turned, >, 0.1);
}

/* Joints that yield and harden. */
static void
test_hardening (void)
{
  Case c;
  test_model_init_stack (&c.model, 3, 0.5, 0.3);
  test_model_add_weight_loads (&c.model, 1);
  c.model.laws[0].kind = QN_LAW_BILINEAR;
  c.model.laws[0].friction = 0;
  c.model.laws[0].yield = 3e3;
  c.model.laws[0].hardening = 0.05;
  refuse_on_the_way (&c, 2);
}

/* Where a structure rests after a jump it stands, and what it jumped along is no mechanism there. */
static void
test_after_jump (void)
{
  int jumps = 0;

  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    Case c;
    test_model_init_wall (&c.model, number, 0);
    c.model.laws[0].kn = c.model.laws[0].ks = 1e9;
    begin (&c);
    solve (&c, INFINITY);
    size_t count = c.result.step_count;
    for (size_t s = 1; s + 1 < count; s++) {
      if (!c.result.steps[s].relaxed || !qn_result_has_forces (&c.result, s))
        continue;
      QnPairResult *pairs = c.result.pairs;
      c.result.pairs = g_new (QnPairResult, c.result.pair_count);
      for (size_t p = 0; p < c.result.pair_count; p++)
        c.result.pairs[p] = qn_result_pair_at (&c.result, s, p);
      c.result.step_count = s + 1;
      g_autofree double *last = last_motion (&c);
      g_assert_false (is_proved (&c, last));
      g_free (c.result.pairs);
      c.result.pairs = pairs;
      c.result.step_count = count;
      jumps++;
    }
    qn_result_clear (&c.result);
    end (&c);
  }
  g_assert_cmpint (jumps, >, 0);
}

QN_TESTS
{
  g_test_add_func ("/second-order-work/rocking-block", test_rocking_block);
  g_test_add_func ("/second-order-work/walls", test_leaning_walls);
  g_test_add_func ("/second-order-work/column", test_column);
  g_test_add_func ("/second-order-work/hardening", test_hardening);
  g_test_add_func ("/second-order-work/after-jump", test_after_jump);
}
