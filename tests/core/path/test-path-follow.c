/* Contacts that follow the blocks along a path of equilibria: closed forms of blocks that slide far. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

#define STIFFNESS 1e9
#define FRICTION  0.3

/* A block, and where two of them stand. */
#define LENGTH 0.4
#define HEIGHT 0.2
#define WEIGHT (10e3 * LENGTH * HEIGHT)

static void
init_case (TestRun *c, QnProcedure procedure, double target)
{
  *c = (TestRun){ 0 };
  test_model_init (&c->model);
  QnLoad *load = qn_model_add_dead_load (&c->model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (0, -1);
  c->model.laws[0].kn = c->model.laws[0].ks = STIFFNESS;
  c->model.laws[0].friction = FRICTION;
  QnAnalysisSettings *analysis = &c->model.analysis;
  analysis->procedure = procedure;
  analysis->geometry = QN_GEOMETRY_NONLINEAR;
  analysis->increments = 50;
  analysis->follow = true;
  if (procedure != QN_PROCEDURE_DISPLACEMENT)
    return;
  analysis->control.block = 1;
  analysis->control.dof = QN_DOF_UX;
  analysis->control.target = target;
}

/* A force of 1 N to the right at the centroid of a block. */
static void
push (TestRun *c, QnId block)
{
  QnLoad *load = qn_model_add_live_load (&c->model);
  load->kind = QN_LOAD_FORCE;
  load->block = block;
  load->vector = qn_vec2 (1, 0);
}

/* Solves, and proves what came out. */
static void
solve (TestRun *c)
{
  test_run_solve (c);
  g_assert_cmpint (test_run_count_faults (c), ==, 0);
}

static double
displacement (const TestRun *c, size_t step, QnId block, QnDof dof)
{
  return qn_result_step_displacements (&c->result, step)[3 * block + (int) dof];
}

/* A block that slides over the ground is left by its joint and stands on its corners: the force is that of
 * friction all the way, and its weight is shared as moments have it. */
static void
test_slide (void)
{
  g_auto (TestRun) c;
  init_case (&c, QN_PROCEDURE_DISPLACEMENT, 1.5);
  test_model_add_base (&c.model, -2, -0.2, 6, 0.2);
  test_model_add_rectangle (&c.model, "block", 0, 0, LENGTH, HEIGHT);
  push (&c, 1);
  solve (&c);
  const QnResult *r = &c.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  g_assert_cmpuint (r->left_count, ==, 1);
  g_assert_cmpuint (r->found_count, ==, 2);
  for (size_t s = 2; s < r->step_count; s++)
    g_assert_cmpfloat_with_epsilon (r->steps[s].multiplier, FRICTION * WEIGHT,
                                    1e-6 * WEIGHT);
  double shift = FRICTION * 0.5 * HEIGHT / LENGTH, front = 0, rear = 0;
  for (size_t i = 0; i < r->found_force_count; i++)
    if (r->found_forces[i].step == (int32_t) r->step_count - 1) {
      double force = r->found_forces[i].normal;
      front = fmin (front, force);
      rear = rear == 0 ? force : fmax (rear, force);
    }
  g_assert_cmpfloat_with_epsilon (front, -(0.5 + shift) * WEIGHT, 1e-5 * WEIGHT);
  g_assert_cmpfloat_with_epsilon (rear, -(0.5 - shift) * WEIGHT, 1e-5 * WEIGHT);
}

/* At the edge of a table it tips where the resultant passes the edge, and turns about it: -x / y of its
 * centroid from the edge is the multiplier then. */
static void
test_edge (void)
{
  const double tips = FRICTION * 0.5 * HEIGHT, radius = hypot (tips, 0.5 * HEIGHT);
  const double start = -0.5, at_end = -0.01;
  gboolean tipped = FALSE;
  g_auto (TestRun) c;
  init_case (&c, QN_PROCEDURE_DISPLACEMENT, at_end - start);
  test_model_add_base (&c.model, -2, -1, 2, 1);
  test_model_add_rectangle (&c.model, "block", start - 0.5 * LENGTH, 0, LENGTH, HEIGHT);
  push (&c, 1);
  solve (&c);
  const QnResult *r = &c.result;
  g_assert_cmpint (r->outcome, ==, QN_OUTCOME_TARGET_REACHED);
  for (size_t s = 2; s < r->step_count; s++) {
    double x = start + displacement (&c, s, 1, QN_DOF_UX),
           y = sqrt (radius * radius - x * x);
    double expected = x < -tips ? FRICTION : -x / y;
    g_test_message ("centroid at %.5f m: %.6f of %.6f", x,
                    r->steps[s].multiplier / WEIGHT, expected);
    g_assert_cmpfloat_with_epsilon (r->steps[s].multiplier, expected * WEIGHT,
                                    2e-3 * WEIGHT);
    tipped = tipped || (x > -tips && displacement (&c, s, 1, QN_DOF_RZ) < -0.01);
  }
  g_assert_true (tipped);
}

/* Two blocks with a gap between them: the first one slides until it meets the second, which resists as
 * much. The force is prescribed, or the motion. */
static void
test_meet (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_DISPLACEMENT,
                                            QN_PROCEDURE_LOAD };
  const double gap = 0.01;
  for (gsize i = 0; i < G_N_ELEMENTS (procedures); i++) {
    g_auto (TestRun) c;
    init_case (&c, procedures[i], 0.1);
    test_model_add_base (&c.model, -2, -0.2, 6, 0.2);
    test_model_add_rectangle (&c.model, "first", 0, 0, LENGTH, HEIGHT);
    test_model_add_rectangle (&c.model, "second", LENGTH + gap, 0, LENGTH, HEIGHT);
    push (&c, 1);
    solve (&c);
    const QnResult *r = &c.result;
    size_t last = r->step_count - 1;
    g_test_message ("%s: %g of the weight, events %zu", qn_outcome_names[r->outcome],
                    r->steps[last].multiplier / WEIGHT, r->event_count);
    g_assert_cmpfloat_with_epsilon (r->steps[last].multiplier, 2 * FRICTION * WEIGHT,
                                    1e-3 * WEIGHT);
    g_assert_cmpuint (r->found_count, >=, 2);
    if (procedures[i] == QN_PROCEDURE_LOAD) {
      g_assert_cmpint (r->outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_false (r->mechanism_uncertain);
    } else {
      g_assert_cmpfloat_with_epsilon (displacement (&c, last, 2, QN_DOF_UX), 0.1 - gap,
                                      1e-5);
    }
  }
}

/* What a result says of found contacts is compared with the displacements. */
static void
test_tampered (void)
{
  g_auto (TestRun) c;
  init_case (&c, QN_PROCEDURE_DISPLACEMENT, 0.5);
  test_model_add_base (&c.model, -2, -0.2, 6, 0.2);
  test_model_add_rectangle (&c.model, "block", 0, 0, LENGTH, HEIGHT);
  push (&c, 1);
  solve (&c);
  QnResult *r = &c.result;
  for (int i = 0; i < 4; i++) {
    QnFoundForce *force = &r->found_forces[r->found_force_count - 1];
    QnFoundForce kept = *force;
    QnFound first = r->found[0], other = r->found[kept.found];
    size_t count = r->found_force_count;
    if (i == 0)
      force->normal *= 1.01;
    else if (i == 1)
      force->found = (QnId) r->found_count;
    else if (i == 2)
      r->found[0].contact.corner = 17;
    else
      r->found_force_count--;
    g_assert_cmpint (test_run_count_faults (&c), >, 0);
    *force = kept;
    r->found[0] = first;
    r->found[kept.found] = other;
    r->found_force_count = count;
  }
}

QN_TESTS
{
  g_test_add_func ("/path-follow/slide", test_slide);
  g_test_add_func ("/path-follow/edge", test_edge);
  g_test_add_func ("/path-follow/meet", test_meet);
  g_test_add_func ("/path-follow/tampered", test_tampered);
}
