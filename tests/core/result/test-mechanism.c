#include "core/result/mechanism.h"

#include "core/limit/limit.h"
#include "support/models.h"
#include "support/room.h"
#include "support/walls.h"

#include <glib.h>
#include <math.h>

typedef struct Case {
  QnModel model;
  QnContacts contacts;
  QnMechanism mechanism;
} Case;

/* Of a field of velocities; of blocks that have moved by `base` already, or that dilate by their friction. */
static void
find_mechanism (Case *c, const double *velocities, const double *base)
{
  QnStep step = { 0 };
  QnResult result = { .block_count = c->model.block_count,
                      .mechanism = (double *) velocities,
                      .steps = &step,
                      .step_count = 1,
                      .displacements = (double *) base,
                      .limit = { .given = base == NULL, .flow = QN_FLOW_ASSOCIATIVE } };

  c->model.analysis.geometry =
    base != NULL ? QN_GEOMETRY_NONLINEAR : c->model.analysis.geometry;
  g_assert_cmpint (
    qn_mechanism_of_result (&c->mechanism, &c->model, &c->contacts, &result, NULL), ==,
    QN_OK);
}

static void
analyse (Case *c, const double *velocities)
{
  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
  find_mechanism (c, velocities, NULL);
}

/* The mechanism of limit analysis. */
static void
collapse (Case *c)
{
  g_auto (QnLimitSolution) solution;

  g_assert_cmpint (qn_model_prepare (&c->model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (&c->model, &c->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (
    qn_limit_associative (&c->model, &c->contacts, NULL, NULL, &solution, NULL), ==,
    QN_OK);
  g_assert_cmpint (solution.outcome, ==, QN_OUTCOME_COLLAPSE);
  find_mechanism (c, solution.velocities, NULL);
}

static void
case_clear (Case *c)
{
  qn_mechanism_clear (&c->mechanism);
  qn_contacts_clear (&c->contacts);
  qn_model_clear (&c->model);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Case, case_clear)

static void
test_rest (void)
{
  const double velocities[6] = { 0 };
  g_auto (Case) c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_NONE);
  g_assert_cmpuint (c.mechanism.body_count, ==, 0);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_CLOSED);
  g_assert_cmpint (c.mechanism.body_of_block[1], ==, QN_NONE);
}

static void
test_sliding (void)
{
  const double velocities[6] = { 0, 0, 0, 1, 0, 0 };
  g_auto (Case) c;

  test_model_init_block_on_plane (&c.model, 2, 1);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_SLIDING);
  g_assert_cmpint (c.mechanism.joints[0].kind, ==, QN_JOINT_SLIDING);
  g_assert_cmpfloat_with_epsilon (fabs (c.mechanism.joints[0].slip), 1, 1e-12);
  g_assert_false (c.mechanism.bodies[0].turns);
  g_assert_cmpint (c.mechanism.body_of_block[1], ==, 0);
}

/* A block that has turned about its corner and turns on about it: in large displacements joint, centre and
 * motion are those of where it is. */
static void
test_moved (void)
{
  const double theta = -0.3;
  double base[6] = { 0 }, velocities[6] = { 0 };
  g_auto (Case) c;

  test_model_init_block_on_plane (&c.model, 1, 2);
  analyse (&c, base);
  QnVec2 centroid = c.model.blocks[1].centroid, pivot = { NAN, NAN };
  for (int i = 0; i < 4; i++) { /* its lower right corner */
    QnVec2 v = qn_model_block_vertices (&c.model, 1)[i];
    if (v.x > centroid.x && v.y < centroid.y)
      pivot = v;
  }
  QnVec2 arm = qn_vec2_sub (centroid, pivot);
  QnVec2 moved = qn_vec2_rotate (arm, cos (theta), sin (theta));
  base[3] = moved.x - arm.x;
  base[4] = moved.y - arm.y;
  base[5] = theta;
  velocities[3] = moved.y; /* -1 rad about the pivot */
  velocities[4] = -moved.x;
  velocities[5] = -1;
  qn_mechanism_clear (&c.mechanism);
  find_mechanism (&c, velocities, base);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  g_assert_cmpint (c.mechanism.counts[QN_JOINT_HINGE_START]
                     + c.mechanism.counts[QN_JOINT_HINGE_END],
                   ==, 1);
  g_assert_cmpint (c.mechanism.sliding_count, ==, 0);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].centre.x, pivot.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].centre.y, pivot.y, 1e-12);
}

/* Blocks that go aside while no joint moves: a frame that sways falls no more than a column that buckles. */
static void
test_swaying (void)
{
  double aside[6] = { 0, 0, 0, 1, 0.1, 0 }, down[6] = { 0, 0, 0, 0, -1, 0 };
  g_auto (Case) c = { 0 };

  test_model_init_block_on_plane (&c.model, 2, 1);
  g_assert_cmpint (qn_model_prepare (&c.model, NULL), ==, QN_OK);
  find_mechanism (&c, aside, NULL); /* no contacts: beams carry it */
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_SWAYING);
  qn_mechanism_clear (&c.mechanism);
  find_mechanism (&c, down, NULL);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_FALLING);
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
  g_auto (Case) c;
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
}

/* The three upper blocks of a stack turn together: one body, closed joints inside. */
static void
test_bodies (void)
{
  double velocities[5 * QN_DOF_COUNT] = { 0 };
  g_auto (Case) c;

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
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].box.min.y, 1, 1e-12);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].box.max.y, 4, 1e-12);
  g_assert_cmpint (c.mechanism.counts[QN_JOINT_CLOSED], ==, 3);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
}

/* The scale of the field changes nothing but the numbers. */
static void
test_scale (void)
{
  double velocities[6] = { 0, 0, 0, 2e-9, 0.5e-9, -1e-9 };
  g_auto (Case) c;

  test_model_init_block_on_plane (&c.model, 1, 4);
  analyse (&c, velocities);
  g_assert_cmpint (c.mechanism.kind, ==, QN_MECHANISM_KIND_OVERTURNING);
  g_assert_cmpfloat_with_epsilon (c.mechanism.bodies[0].centre.x, 0.5, 1e-9);
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

  test_arch_init (&c.model, 0.15, 27, 1);
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

/* ---- drawn cases ---- */

/* How the blocks of a letter move: turning about a point, or where it does not turn, straight on.
 * Lengths in columns and rows of the drawing, from its lower left corner above the ground. */
typedef struct Motion {
  char letter;
  double vx, vy, turn, x, y;
} Motion;

/* Rows from the top; |, \ and / stand between blocks, the last two for joints that lean, a letter fills a column of a block, '.' is a block at
 * rest, a blank no block. The ground lies beneath the lowest row. */
typedef struct Drawing {
  const char *rows[7];
  Motion motions[4];
  QnMechanismKind kind;
} Drawing;

#define CLOCKWISE(letter, x, y)                                                          \
  {                                                                                      \
    letter, 0, 0, -1, x, y                                                               \
  }
#define ANTICLOCKWISE(letter, x, y)                                                      \
  {                                                                                      \
    letter, 0, 0, 1, x, y                                                                \
  }
#define TO(letter, vx, vy)                                                               \
  {                                                                                      \
    letter, vx, vy, 0, 0, 0                                                              \
  }

static const Drawing drawings[] = {
  /* Single blocks and stacks. */
  { { "|A|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|A|" }, { TO ('A', -1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|A|" }, { CLOCKWISE ('A', 1, 0) }, QN_MECHANISM_KIND_OVERTURNING },
  { { "|A|" }, { ANTICLOCKWISE ('A', 0, 0) }, QN_MECHANISM_KIND_OVERTURNING },
  { { "|A|" }, { TO ('A', 0, 1) }, QN_MECHANISM_KIND_FALLING },
  { { "|A|", "|A|", "|A|" }, { CLOCKWISE ('A', 1, 0) }, QN_MECHANISM_KIND_OVERTURNING },
  { { "|A|", "|A|", "|.|" }, { CLOCKWISE ('A', 1, 1) }, QN_MECHANISM_KIND_OVERTURNING },
  { { "|A|", "|.|", "|.|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|A|", "|B|" }, { TO ('A', 2, 0), TO ('B', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  /* Two drums that turn over each other make no crack in steps. */
  { { "|A|", "|B|" },
    { { 'A', 0, 0, -3, 1, 0.5 }, CLOCKWISE ('B', 1, 0) },
    QN_MECHANISM_KIND_ROCKING },
  { { "|A|", "|B|", "|B|", "|B|" },
    { TO ('A', 1, 0), CLOCKWISE ('B', 1, 0) },
    QN_MECHANISM_KIND_MIXED },
  { { "|A|", "|A|", "|B|" },
    { CLOCKWISE ('A', 1, 1), TO ('B', 1, 0) },
    QN_MECHANISM_KIND_MIXED },
  /* Courses of a wall that slide. */
  { { "|AA|AA|AA|", "|.|..|..|.|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|AA|", "|A|AA|AA|A|", "|..|..|..|" },
    { TO ('A', 1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|AA|", "|B|BB|BB|B|", "|..|..|..|" },
    { TO ('A', 2, 0), TO ('B', 1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|AA|", "|B|BB|BB|B|", "|CC|CC|CC|", "|.|..|..|.|" },
    { TO ('A', 3, 0), TO ('B', 2, 0), TO ('C', 1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|AA|", "|.|..|..|.|", "|..|..|..|" },
    { TO ('A', -1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  /* A part of one course: a head joint opens behind it, but there are no steps. */
  { { "|..|AA|AA|", "|.|..|..|.|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|..|", "|.|..|..|.|" }, { TO ('A', -1, 0) }, QN_MECHANISM_KIND_SLIDING },
  /* A part that slides on the beds of a staircase: head joints part, the beds stay closed. */
  { { "|..|AA|AA|", "|.|..|AA|A|", "|..|..|..|" },
    { TO ('A', 1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|AA|AA|..|", "|A|AA|..|.|", "|..|..|..|" },
    { TO ('A', -1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|.|AA|AA|A|", "|..|AA|AA|", "|.|..|AA|A|" },
    { TO ('A', 1, 0) },
    QN_MECHANISM_KIND_SLIDING },
  { { "|.|AA|BB|B|", "|..|BB|BB|", "|.|..|BB|B|" },
    { TO ('A', 1, 0), TO ('B', 2, 0) },
    QN_MECHANISM_KIND_SLIDING },
  /* The same parts turn off the staircase: beds open too. */
  { { "|..|AA|AA|", "|.|..|AA|A|", "|..|..|..|" },
    { CLOCKWISE ('A', 6, 1) },
    QN_MECHANISM_KIND_STEPPED },
  { { "|.|AA|AA|A|", "|..|AA|AA|", "|.|..|AA|A|" },
    { CLOCKWISE ('A', 6, 0) },
    QN_MECHANISM_KIND_STEPPED },
  { { "|.|AA|AA|A|", "|..|AA|AA|", "|.|..|AA|A|", "|..|..|AA|", "|.|..|..|A|" },
    { CLOCKWISE ('A', 6, 0) },
    QN_MECHANISM_KIND_STEPPED },
  { { "|A|AA|AA|.|", "|AA|AA|..|", "|A|AA|..|.|", "|AA|..|..|", "|A|..|..|.|" },
    { ANTICLOCKWISE ('A', 0, 0) },
    QN_MECHANISM_KIND_STEPPED },
  /* A wall that turns as one, and a part of it above a bed. */
  { { "|AA|AA|AA|", "|A|AA|AA|A|", "|AA|AA|AA|" },
    { CLOCKWISE ('A', 6, 0) },
    QN_MECHANISM_KIND_OVERTURNING },
  { { "|AA|AA|AA|", "|A|AA|AA|A|", "|..|..|..|" },
    { CLOCKWISE ('A', 6, 1) },
    QN_MECHANISM_KIND_OVERTURNING },
  /* Two piers beside each other, with and without a beam on them. */
  { { "|A| |B|", "|A| |B|", "|A| |B|" },
    { CLOCKWISE ('A', 1, 0), CLOCKWISE ('B', 3, 0) },
    QN_MECHANISM_KIND_ROCKING },
  { { "|A|   |B|", "|A|   |B|" },
    { ANTICLOCKWISE ('A', 0, 0), ANTICLOCKWISE ('B', 4, 0) },
    QN_MECHANISM_KIND_ROCKING },
  { { "|CCC|", "|A| |B|", "|A| |B|", "|A| |B|" },
    { CLOCKWISE ('A', 1, 0), CLOCKWISE ('B', 3, 0), TO ('C', 3, 0) },
    QN_MECHANISM_KIND_ROCKING },
  /* A heavy block on two piers goes straight on, but nothing slides. */
  { { "|CCC|", "|CCC|", "|CCC|", "|CCC|", "|CCC|", "|A| |B|" },
    { CLOCKWISE ('A', 1, 0), CLOCKWISE ('B', 3, 0), TO ('C', 1, 0) },
    QN_MECHANISM_KIND_ROCKING },
  { { "|C|C|C|", "|C|C|C|", "|A| |B|" },
    { CLOCKWISE ('A', 1, 0), CLOCKWISE ('B', 3, 0), { 'C', 1, 0, 1e-9, 1.5, 2 } },
    QN_MECHANISM_KIND_ROCKING },
  /* A pier on its foot, which rocks on its own foot, both in one sense: they slip a little. */
  { { "|.|A|", "|.|A|", "|.|B|" },
    { { 'A', 0.3, 0, -2, 2, 1 }, CLOCKWISE ('B', 2, 0) },
    QN_MECHANISM_KIND_ROCKING },
  /* A part that stands on two levels has no crack in steps, nor has a straight one. */
  { { "|AAAA|..|", "|A|  |.|" },
    { ANTICLOCKWISE ('A', 0, 0) },
    QN_MECHANISM_KIND_OVERTURNING },
  { { "|AAAAAA|..|", "|AA|  |....|" },
    { ANTICLOCKWISE ('A', 0, 0) },
    QN_MECHANISM_KIND_OVERTURNING },
  { { "|..|AA|", "|..|AA|", "|..|AA|" },
    { CLOCKWISE ('A', 4, 0) },
    QN_MECHANISM_KIND_OVERTURNING },
  /* Steps two courses high. */
  { { "|..|AA|AA|", "|..|AA|AA|", "|....|AA|", "|....|AA|" },
    { CLOCKWISE ('A', 6, 0) },
    QN_MECHANISM_KIND_STEPPED },
  /* A stone that is lifted out of a wall slides along its neighbours. A wedge leaves its sides, however
   * far they slip past it; pushed along one of them it slides. */
  { { "|.|AA|.|", "|..|..|" }, { TO ('A', 0, 1) }, QN_MECHANISM_KIND_SLIDING },
  { { "|..\\AAAA/..|" }, { TO ('A', 0, 1) }, QN_MECHANISM_KIND_FALLING },
  { { "|..\\AAAA/..|", "|.|    |.|" }, { TO ('A', 0, 1) }, QN_MECHANISM_KIND_FALLING },
  { { "|../AAAA\\..|", "|.|    |.|" }, { TO ('A', 0, -1) }, QN_MECHANISM_KIND_FALLING },
  { { "|..\\AAAA|" }, { TO ('A', -0.5, 1) }, QN_MECHANISM_KIND_SLIDING },
  /* A stone that drops out of a wall, and nothing at all. */
  { { "|..|..|", "|..|AA|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_SLIDING },
  { { "|..|..|", "|.|..|.|" }, { TO ('A', 1, 0) }, QN_MECHANISM_KIND_NONE },
};

G_STATIC_ASSERT (G_N_ELEMENTS (drawings) >= 30);

/* How far a joint leans at its foot, to the right, and as far to the left at its head. */
static double
leaning (char joint)
{
  return joint == '\\' ? 0.25 : joint == '/' ? -0.25 : 0;
}

static gboolean
is_joint (char c)
{
  return c == '|' || c == '\\' || c == '/';
}

/* Adds the blocks of a row, and notes their letters. A blank is as wide as a block's column. */
static void
draw_row (QnModel *model, const char *row, double y, GString *letters)
{
  double x = 0, left = 0;
  const char *c = row;
  while (*c != '\0') {
    const char *first = c;
    if (is_joint (*c)) {
      left = leaning (*c++);
      continue;
    }
    while (*c == *first)
      c++;
    double right = leaning (*c), end = x + (double) (c - first);
    if (*first != ' ') {
      const QnVec2 corners[] = {
        { x + left, y }, { end + right, y }, { end - right, y + 1 }, { x - left, y + 1 }
      };
      g_autofree char *name = g_strdup_printf ("b%u", (guint) letters->len);
      QnBlock *block = qn_model_add_block (model, name, corners, 4);
      block->thickness = 1;
      block->unit_weight = 10000;
      g_string_append_c (letters, *first);
    }
    x = end;
  }
}

static void
test_drawn (void)
{
  for (gsize i = 0; i < G_N_ELEMENTS (drawings); i++) {
    const Drawing *drawing = &drawings[i];
    GString *letters = g_string_new ("#");
    int rows = 0;
    Case c;

    while (drawing->rows[rows] != NULL)
      rows++;
    test_model_init (&c.model);
    test_model_add_base (&c.model, -1, -1, 9, 1);
    for (int r = 0; r < rows; r++)
      draw_row (&c.model, drawing->rows[r], rows - 1 - r, letters);
    g_assert_cmpint (qn_model_prepare (&c.model, NULL), ==, QN_OK);
    double *velocities = g_new0 (double, QN_DOF_COUNT *c.model.block_count);
    for (size_t b = 0; b < c.model.block_count; b++)
      for (gsize k = 0; k < G_N_ELEMENTS (drawing->motions); k++) {
        const Motion *m = &drawing->motions[k];
        QnVec2 arm = qn_vec2_sub (c.model.blocks[b].centroid, qn_vec2 (m->x, m->y));
        if (m->letter != letters->str[b])
          continue;
        velocities[3 * b] = m->vx - m->turn * arm.y;
        velocities[3 * b + 1] = m->vy + m->turn * arm.x;
        velocities[3 * b + 2] = m->turn;
      }
    g_assert_cmpint (qn_contacts_detect (&c.model, &c.contacts, NULL), ==, QN_OK);
    find_mechanism (&c, velocities, NULL);
    if (c.mechanism.kind != drawing->kind)
      g_test_message ("drawing %u, %s", (guint) i, drawing->rows[0]);
    g_assert_cmpstr (qn_mechanism_kind_names[c.mechanism.kind], ==,
                     qn_mechanism_kind_names[drawing->kind]);
    g_free (velocities);
    g_string_free (letters, TRUE);
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

QN_TESTS
{
  g_test_add_func ("/mechanism/rest", test_rest);
  g_test_add_func ("/mechanism/sliding", test_sliding);
  g_test_add_func ("/mechanism/moved", test_moved);
  g_test_add_func ("/mechanism/swaying", test_swaying);
  g_test_add_func ("/mechanism/dilating", test_dilating);
  g_test_add_func ("/mechanism/overturning", test_overturning);
  g_test_add_func ("/mechanism/bodies", test_bodies);
  g_test_add_func ("/mechanism/scale", test_scale);
  g_test_add_func ("/mechanism/names", test_names);
  g_test_add_func ("/mechanism/drawn", test_drawn);
  g_test_add_func ("/mechanism/spelling", test_spelling);
}
