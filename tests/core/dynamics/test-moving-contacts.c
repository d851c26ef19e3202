/* Contacts that follow the blocks: closed forms of blocks that slide off, fall and lie. */
#include "support/models.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>

#define G         9.81
#define STIFFNESS 1e8

static void
init_case (TestRun *c, double friction, double duration, double time_step)
{
  *c = (TestRun){ 0 };
  test_model_init (&c->model);
  QnLoad *load = qn_model_add_dead_load (&c->model);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = qn_vec2 (0, -1);
  c->model.laws[0].kn = c->model.laws[0].ks = STIFFNESS;
  c->model.laws[0].friction = friction;
  QnAnalysisSettings *analysis = &c->model.analysis;
  analysis->procedure = QN_PROCEDURE_DYNAMIC;
  analysis->geometry = QN_GEOMETRY_NONLINEAR;
  analysis->dynamic.duration = duration;
  analysis->dynamic.time_step = time_step;
  analysis->dynamic.joint_damping = 1e-3;
  analysis->dynamic.follow = analysis->dynamic.fall = true;
}

static void
push (TestRun *c, QnId block, double vx, double vy, double turning)
{
  QnInitialMotion *motion = qn_model_add_initial_motion (&c->model);
  motion->block = block;
  motion->velocity[QN_DOF_UX] = vx;
  motion->velocity[QN_DOF_UY] = vy;
  motion->velocity[QN_DOF_RZ] = turning;
}

/* Whether what friction has taken never comes back, but for a thousandth of the largest input. */
static gboolean
loses_only (const QnHistory *h)
{
  double most = 0, back = 0, input = 0;
  for (size_t i = 0; i < h->row_count; i++) {
    const double *energy = h->rows + i * h->width + QN_HISTORY_ENERGY;
    most = MAX (most, energy[QN_ENERGY_FRICTION]);
    back = MAX (back, most - energy[QN_ENERGY_FRICTION]);
    input = MAX (input, fabs (energy[QN_ENERGY_INPUT]));
  }
  g_test_message ("of %.4g J that friction takes %.2g J come back", most, back);
  return back <= 1e-3 * input;
}

/* Solves, and proves what came out; the balance of energy holds, and contacts that change add none. */
static void
solve (TestRun *c)
{
  test_run_solve (c);
  g_assert_cmpint (test_run_count_faults (c), ==, 0);
  g_assert_cmpfloat (c->result.history.energy_error, <, 1e-3);
  g_assert_true (loses_only (&c->result.history));
}

static double
last (const TestRun *c, QnId block, QnDof dof)
{
  const QnResult *r = &c->result;
  return qn_result_step_displacements (r, r->step_count - 1)[3 * block + (int) dof];
}

static double
energy (const TestRun *c, QnEnergyKind kind)
{
  const QnHistory *h = &c->result.history;
  return h->rows[(h->row_count - 1) * h->width + QN_HISTORY_ENERGY + (size_t) kind];
}

/* Normal force at the last step between a side of one block and a corner of another. */
static double
found_force (const TestRun *c, QnId block, QnId other)
{
  const QnResult *r = &c->result;
  double sum = 0;
  for (size_t i = 0; i < r->found_force_count; i++) {
    const QnFoundForce *force = &r->found_forces[i];
    const QnFoundContact *contact = &r->found[force->found].contact;
    if (force->step == (int32_t) r->step_count - 1 && contact->block == block
        && contact->other == other)
      sum += force->normal;
  }
  return sum;
}

/* A block that overturns comes to rest on its side: turned by a right angle, its centroid half of its
 * width above the ground less what half of its weight presses one spring in, and the energy lost is
 * that of its start and of the way its weight has gone. */
static void
test_lie (void)
{
  const double width = 0.2, height = 1, weight = 10e3 * width * height;
  double damped = 0;
  for (int i = 0; i < 3; i++) {
    g_auto (TestRun) c;
    init_case (&c, 0.65, 4, i == 0 ? 5e-3 : i == 1 ? 2e-3 : 1e-3);
    test_model_add_base (&c.model, -3, -0.2, 6, 0.2);
    test_model_add_rectangle (&c.model, "block", -0.5 * width, 0, width, height);
    push (&c, 1, -0.6, 0, 1.2);
    solve (&c);
    double down = -last (&c, 1, QN_DOF_UY);
    double pressed = 0.5 * weight / (0.5 * STIFFNESS);
    double speed =
      weight / G * (0.6 * 0.6 + 1.2 * 1.2 * (width * width + height * height) / 12) / 2;
    double gone = energy (&c, QN_ENERGY_FRICTION) + energy (&c, QN_ENERGY_DAMPING)
                  + energy (&c, QN_ENERGY_NUMERICAL)
                  - (speed + 0.5 * (height - width) * weight);
    g_test_message ("down by %.6f m, turned by %.6f, lost but for %.2g J, friction %.4g, "
                    "damping %.4g J",
                    down, last (&c, 1, QN_DOF_RZ), gone, energy (&c, QN_ENERGY_FRICTION),
                    energy (&c, QN_ENERGY_DAMPING));
    g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpfloat (c.result.history.collapse_time, <, 1.5);
    g_assert_cmpfloat_with_epsilon (last (&c, 1, QN_DOF_RZ), 0.5 * G_PI, 1e-6);
    g_assert_cmpfloat_with_epsilon (down, 0.5 * (height - width) + pressed, 1e-6);
    g_assert_cmpfloat_with_epsilon (found_force (&c, 0, 1), -weight, 1e-3 * weight);
    g_assert_cmpfloat (fabs (gone), <, 1e-3 * (speed + 0.4 * weight));
    g_assert_cmpfloat (energy (&c, QN_ENERGY_KINETIC), <, 1e-6);
    /* What the impacts take does not depend on the steps. */
    damped = i == 0 ? energy (&c, QN_ENERGY_DAMPING) : damped;
    g_assert_cmpfloat (fabs (energy (&c, QN_ENERGY_DAMPING) / damped - 1), <, 0.01);
  }
}

/* A block that begins lifted and turned: its joint is left where the motion begins, not under the dead load
 * before; so far from it or so much turned it has overturned after the first step. */
static void
test_lifted (void)
{
  static const double turned[] = { 0.1, 0.5, -2 };
  for (gsize i = 0; i < G_N_ELEMENTS (turned); i++) {
    g_auto (TestRun) c;
    init_case (&c, 0.65, 0.2, 2e-3);
    test_model_add_base (&c.model, -3, -0.2, 6, 0.2);
    test_model_add_rectangle (&c.model, "block", -0.2, 0, 0.4, 0.4);
    push (&c, 1, 0, 0, 0);
    c.model.initial[0].displacement[QN_DOF_UY] = 0.5;
    c.model.initial[0].displacement[QN_DOF_RZ] = turned[i];
    solve (&c);
    g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_COLLAPSE);
    g_assert_cmpuint (c.result.left_count, ==, 1);
    /* It falls freely, and nothing is lost. */
    g_assert_cmpfloat_with_epsilon (last (&c, 1, QN_DOF_UY), 0.5 - 0.5 * G * 0.2 * 0.2,
                                    1e-4);
    g_assert_cmpfloat (energy (&c, QN_ENERGY_FRICTION), ==, 0);
  }
}

/* A block slides to the edge of a table and stops there after v^2/(2 mu g). As long as its centroid is on
 * the table it stays; the edge and its rear corner share its weight by the lever. Beyond, it falls. */
static void
test_edge (void)
{
  const double length = 0.4, height = 0.2, friction = 0.3,
               weight = 10e3 * length * height;
  static const double centroids[] = { -0.05, -0.02, 0.02 }; /* from the edge */
  for (gsize i = 0; i < G_N_ELEMENTS (centroids); i++) {
    g_auto (TestRun) c;
    double way = centroids[i] + 0.8, rear = centroids[i] - 0.5 * length;
    init_case (&c, friction, 2, 2e-3);
    test_model_add_base (&c.model, -2, -1, 2, 1);
    QnBlock *floor = test_model_add_rectangle (&c.model, "floor", -3, -1.2, 8, 0.2);
    floor->support[0] = floor->support[1] = floor->support[2] = true;
    test_model_add_rectangle (&c.model, "block", -0.8 - 0.5 * length, 0, length, height);
    push (&c, 2, sqrt (2 * friction * G * way), 0, 0);
    solve (&c);
    g_test_message ("centroid at %g m: slid %.5f m, turned by %.4f", centroids[i],
                    last (&c, 2, QN_DOF_UX), last (&c, 2, QN_DOF_RZ));
    if (centroids[i] > 0) {
      g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_COLLAPSE);
      g_assert_cmpfloat (last (&c, 2, QN_DOF_UY), <, -0.9); /* it lies on the floor */
      g_assert_cmpfloat_with_epsilon (found_force (&c, 1, 2), -weight, 1e-2 * weight);
    } else {
      double slid = last (&c, 2, QN_DOF_UX), at = -0.8 - 0.5 * length + slid;
      double edge = weight * 0.5 * length / -at;
      g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_REST);
      g_assert_cmpfloat (fabs (slid / way - 1), <, 5e-3);
      g_assert_cmpfloat_with_epsilon (found_force (&c, 2, 0), -edge, 1e-3 * weight);
      g_assert_cmpfloat_with_epsilon (found_force (&c, 0, 2), edge - weight,
                                      1e-3 * weight);
      g_assert_cmpfloat (fabs (rear - at), <, 0.01);
    }
  }
}

/* Dominoes: each knocks over the next, none goes through another, and the row comes to rest. */
static void
test_dominoes (void)
{
  const int count = 6;
  g_auto (TestRun) c;
  init_case (&c, 0.4, 6, 2e-3);
  test_model_add_base (&c.model, -2, -0.2, 8, 0.2);
  for (int i = 0; i < count; i++) {
    g_autofree char *name = g_strdup_printf ("domino %d", i);
    test_model_add_rectangle (&c.model, name, 0.5 * i, 0, 0.1, 1);
  }
  push (&c, 1, 0.5, 0, -1);
  solve (&c);
  const QnResult *r = &c.result;
  double before = -1;
  for (QnId b = 1; b <= count; b++) {
    double when = INFINITY;
    for (size_t s = 0; s < r->step_count && !isfinite (when); s++)
      if (qn_result_step_displacements (r, s)[3 * b + QN_DOF_RZ] < -0.5)
        when = r->steps[s].time;
    g_assert_true (isfinite (when) && when > before);
    before = when;
  }
  g_assert_cmpfloat_with_epsilon (last (&c, count, QN_DOF_RZ), -0.5 * G_PI, 1e-3);
  g_assert_cmpfloat (energy (&c, QN_ENERGY_KINETIC), <, 1e-3);
}

/* An arch that a pulse shakes down: joints are left where their blocks have turned, and corners that
 * were held by them, or by another corner, become active millimetres deep within stiff blocks. */
static void
test_arch (void)
{
  const int count = 17;
  const double inner = 3.75, outer = 4.25;
  gboolean any_inset = FALSE;
  g_auto (TestRun) c;
  init_case (&c, 0.7, 2.5, 2e-3);
  test_model_add_base (&c.model, -6, -0.5, 12, 0.5);
  for (int i = 0; i < count; i++) {
    double a = G_PI * (1 - i / (double) count), b = G_PI * (1 - (i + 1) / (double) count);
    const QnVec2 corners[] = { { inner * cos (a), inner * sin (a) },
                               { inner * cos (b), inner * sin (b) },
                               { outer * cos (b), outer * sin (b) },
                               { outer * cos (a), outer * sin (a) } };
    g_autofree char *name = g_strdup_printf ("voussoir %d", i + 1);
    QnBlock *block = qn_model_add_block (&c.model, name, corners, 4);
    block->thickness = 1;
    block->unit_weight = 27e3;
  }
  c.model.laws[0].basis = QN_BASIS_SURFACE;
  c.model.laws[0].kn = c.model.laws[0].ks = 2e10;
  c.model.contact.pairs = (QnPairRule){ .placement = QN_PLACEMENT_EXPLICIT,
                                        .count = 3,
                                        .positions = { 0, 0.5, 1 },
                                        .weights = { 0.25, 0.5, 0.25 } };
  QnGroundMotion *motion = qn_model_add_ground_motion (&c.model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ QN_PULSE_HALF_SINE, 6, 0.25, 0 };
  solve (&c);
  g_assert_cmpint (c.result.outcome, ==, QN_OUTCOME_COLLAPSE);
  for (size_t i = 0; i < c.result.found_count; i++)
    any_inset = any_inset || c.result.found[i].contact.inset > 1e-3;
  g_assert_true (any_inset);
}

/* A result whose found contacts are changed does not pass; nor one without them. */
static void
test_tampered (void)
{
  g_auto (TestRun) c;
  init_case (&c, 0.65, 2, 2e-3);
  test_model_add_base (&c.model, -3, -0.2, 6, 0.2);
  test_model_add_rectangle (&c.model, "block", -0.1, 0, 0.2, 1);
  push (&c, 1, -0.6, 0, 1.2);
  solve (&c);
  QnResult *r = &c.result;
  g_assert_cmpuint (r->found_force_count, >, 0);
  for (int i = 0; i < 5; i++) {
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
    else if (i == 3)
      r->found[force->found].contact.inset += 1e-4;
    else
      r->found_force_count--; /* the corner lies within the ground, and nothing holds it */
    g_assert_cmpint (test_run_count_faults (&c), >, 0);
    *force = kept;
    r->found[0] = first;
    r->found[kept.found] = other;
    r->found_force_count = count;
  }
}

QN_TESTS
{
  g_test_add_func ("/moving-contacts/lie", test_lie);
  g_test_add_func ("/moving-contacts/lifted", test_lifted);
  g_test_add_func ("/moving-contacts/edge", test_edge);
  g_test_add_func ("/moving-contacts/dominoes", test_dominoes);
  g_test_add_func ("/moving-contacts/arch", test_arch);
  g_test_add_func ("/moving-contacts/tampered", test_tampered);
}
