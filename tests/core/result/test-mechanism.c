#include "core/result/mechanism.h"

#include "core/limit/limit.h"
#include "support/generate.h"
#include "support/models.h"

#include <glib.h>
#include <math.h>

typedef struct Case {
  QnModel model;
  QnContacts contacts;
  QnMechanism mechanism;
} Case;

static void
analyse (Case *c, const double *velocities)
{
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_mechanism_init (&c->mechanism, &c->model, &c->contacts, velocities, NULL), ==,
    QN_OK);
}

/* The mechanism of limit analysis. */
static void
collapse (Case *c)
{
  QnLimitSolution solution;

  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_associative (&c->model, &c->contacts, NULL, NULL, &solution, NULL), ==,
    QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  g_assert_cmpint (
    qn_mechanism_init (&c->mechanism, &c->model, &c->contacts, solution.velocities, NULL),
    ==, QN_OK);
  qn_limit_solution_clear (&solution);
}

static void
case_clear (Case *c)
{
  qn_mechanism_clear (&c->mechanism);
  qn_contacts_clear (&c->contacts);
  qn_model_clear (&c->model);
}

static void
test_rest (void)
{
  const double velocities[6] = { 0 };
  Case c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_NONE);
  g_assert_cmpuint (c.mechanism.body_count, ==, 0);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_CLOSED);
  g_assert_cmpint (c.mechanism.body_of_block[1], ==, QN_NONE);
  case_clear (&c);
}

static void
test_sliding (void)
{
  const double velocities[6] = { 0, 0, 0, 1, 0, 0 };
  Case c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_SLIDING);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_SLIDING);
  g_assert_cmpfloat_with_epsilon (fabs (c.mechanism.joints[0].slip), 1, 1e-12);
  g_assert_false (c.mechanism.bodies[0].turns);
  g_assert_cmpint (c.mechanism.body_of_block[1], ==, 0);
  case_clear (&c);
}

/* Associative sliding opens the joint by friction x slip: still sliding, not opening. */
static void
test_dilating (void)
{
  const double sliding[6] = { 0, 0, 0, 1, 0.65, 0 }, opening[6] = { 0, 0, 0, 1, 0.8, 0 };
  Case c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, sliding);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_SLIDING);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_SLIDING);
  case_clear (&c);
  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, opening);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_OPENING);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_FALLING);
  case_clear (&c);
}

/* Clockwise about the right corner (0.5, 0) of a block 1 x 4: the hinge is there. */
static void
test_overturning (void)
{
  const double velocities[6] = { 0, 0, 0, 2, 0.5, -1 };
  Case c;
  QnVec2 start, end, hinge;

  test_model_init_block_on_plane (&c.model, 1, 4);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  const QnJointMotion *joint = &c.mechanism.joints[0];
  g_assert_true (joint->kind == QN_JOINT_HINGE_START
                 || joint->kind == QN_JOINT_HINGE_END);
  g_assert_false (joint->slides);
  qn_joint_corners (&c.contacts, 0, &start, &end);
  hinge = joint->kind == QN_JOINT_HINGE_START ? start : end;
  g_assert_cmpfloat_with_epsilon (hinge.x, 0.5, 1e-12);
  g_assert_cmpfloat_with_epsilon (hinge.y, 0, 1e-12);
  g_assert_cmpfloat_with_epsilon (fmax (joint->opening_start, joint->opening_end), 1,
                                  1e-12);
  const QnMechanismBody *body = &c.mechanism.bodies[0];
  g_assert_true (body->turns);
  g_assert_cmpfloat (body->rotation, ==, -1);
  g_assert_cmpfloat_with_epsilon (body->centre.x, 0.5, 1e-12);
  g_assert_cmpfloat_with_epsilon (body->centre.y, 0, 1e-12);
  case_clear (&c);
}

/* The three upper blocks of a stack turn together: one body, closed joints inside. */
static void
test_bodies (void)
{
  double velocities[5 * QN_DOF_COUNT] = { 0 };
  Case c;

  test_model_init_stack (&c.model, 4, 1, 1);
  for (int i = 2; i <= 4; i++) {
    velocities[3 * i] = i - 0.5 - 1; /* about the corner (0.5, 1) */
    velocities[3 * i + 1] = 0.5;
    velocities[3 * i + 2] = -1;
  }
  analyse (&c, velocities);
  g_assert_cmpuint (c.mechanism.body_count, ==, 1);
  g_assert_cmpint (c.mechanism.bodies[0].block_count, ==, 3);
  g_assert_cmpint (c.mechanism.body_of_block[1], ==, QN_NONE);
  g_assert_cmpint (c.mechanism.body_of_block[4], ==, 0);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].centre.y, 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].lowest.y, 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].highest.y, 4, 1e-12);
  g_assert_cmpint (c.mechanism.counts[QN_JOINT_CLOSED], ==, 3);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  case_clear (&c);
}

/* The scale of the field changes nothing but the numbers. */
static void
test_scale (void)
{
  double velocities[6] = { 0, 0, 0, 2e-9, 0.5e-9, -1e-9 };
  Case c;

  test_model_init_block_on_plane (&c.model, 1, 4);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].centre.x, 0.5, 1e-9);
  case_clear (&c);
}

/* What limit analysis finds for single blocks, an arch and the walls, in a word: solid walls
 * crack in steps, walls with openings rock on their piers. */
static void
test_names (void)
{
  static const QnMechanismKind walls[TEST_WALL_COUNT] = {
    QN_MECHANISM_KIND_STEPPED, QN_MECHANISM_KIND_STEPPED, QN_MECHANISM_KIND_ROCKING,
    QN_MECHANISM_KIND_ROCKING, QN_MECHANISM_KIND_ROCKING, QN_MECHANISM_KIND_ROCKING,
  };
  Case c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  test_model_add_weight_loads (&c.model, 1);
  collapse (&c);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_SLIDING);
  case_clear (&c);

  test_model_init_stack (&c.model, 3, 1, 1);
  test_model_add_weight_loads (&c.model, -1);
  collapse (&c);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  g_assert_cmpint (c.mechanism.bodies[0].block_count, ==, 3);
  case_clear (&c);

  QnArchRecipe arch = qn_arch_recipe_default ();
  qn_model_init (&c.model);
  g_assert_cmpint (qn_generate_arch (&c.model, &arch, NULL), ==, QN_OK);
  collapse (&c);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_ARCH);
  g_assert_cmpuint (c.mechanism.body_count, ==, 3);
  case_clear (&c);

  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    test_model_init_wall (&c.model, number, 0);
    collapse (&c);
    g_assert_cmpint (c.mechanism.kind, ==, walls[number - 1]);
    /* The bodies cover what moves, each block once. */
    int32_t blocks = 0, moving = 0;
    for (size_t i = 0; i < c.mechanism.body_count; i++)
      blocks += c.mechanism.bodies[i].block_count;
    for (size_t i = 0; i < c.mechanism.block_count; i++)
      moving += c.mechanism.body_of_block[i] != QN_NONE;
    g_assert_cmpint (blocks, ==, moving);
    g_assert_cmpint (c.mechanism.body_of_block[0], ==, QN_NONE);
    case_clear (&c);
  }
}

static void
test_spelling (void)
{
  for (int i = 0; i < QN_JOINT_KIND_COUNT; i++)
    g_assert_nonnull (qn_joint_kind_names[i]);
  for (int i = 0; i < QN_MECHANISM_KIND_COUNT; i++)
    g_assert_nonnull (qn_mechanism_kind_names[i]);
  g_assert_cmpstr (qn_joint_kind_names[QN_JOINT_HINGE_END], ==, "hinge-end");
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_func ("/mechanism/rest", test_rest);
  g_test_add_func ("/mechanism/sliding", test_sliding);
  g_test_add_func ("/mechanism/dilating", test_dilating);
  g_test_add_func ("/mechanism/overturning", test_overturning);
  g_test_add_func ("/mechanism/bodies", test_bodies);
  g_test_add_func ("/mechanism/scale", test_scale);
  g_test_add_func ("/mechanism/names", test_names);
  g_test_add_func ("/mechanism/spelling", test_spelling);
  return g_test_run ();
}
