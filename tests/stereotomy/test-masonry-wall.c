#include "stereotomy/masonry.h"
#include "stereotomy/polygon-ops.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <string.h>

static void
init_wall (QnMasonry *masonry, QnBond bond, QnCloser closer, double length, double height)
{
  qn_masonry_init (masonry, QN_MASONRY_WALL, "w");
  masonry->wall.height = height;
  QnLeaf *leaf = &masonry->wall.leaves[0];
  leaf->length = length;
  leaf->unit = qn_vec2 (0.4, 0.2);
  leaf->bond = bond;
  leaf->closer = closer;
}

static void
expand (const QnMasonry *masonry, QnModel *model)
{
  QnDiag diag = { 0 };
  qn_model_init (model);
  QnStatus status = qn_masonry_expand (masonry, 0, model, &diag);
  if (status != QN_OK)
    g_error ("%s: %s", qn_problem_text (diag.problem), diag.field);
}

static double
total_area (const QnModel *model)
{
  double area = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    QnRing ring = { model->vertices + block->first_vertex, (size_t) block->vertex_count };
    g_assert_cmpint (qn_ring_check (&ring, 0, NULL), ==, QN_OK);
    area += qn_ring_area (&ring);
  }
  return area;
}

/* The six walls: listed courses give what walls[] gives, block for block and bit for bit. */
static void
test_six_walls (void)
{
  for (int number = 1; number <= TEST_WALL_COUNT; number++) {
    g_auto (QnModel) expected, model;
    test_model_init_wall (&expected, number, 0);
    size_t first = expected.block_count;
    g_assert_cmpint (qn_model_expand_walls (&expected, NULL), ==, QN_OK);

    const QnWall *wall = &expected.walls[0];
    g_auto (QnMasonry) masonry;
    init_wall (&masonry, QN_BOND_CUSTOM, QN_CLOSER_NONE, 0, 0);
    masonry.origin = wall->origin;
    masonry.wall.leaves[0].unit = wall->unit;
    int32_t begin = 0;
    for (int32_t i = 0; i < wall->course_count; i++) {
      g_assert_true (qn_wall_add_course (&masonry.wall.courses, wall->lengths + begin,
                                         (size_t) (wall->course_ends[i] - begin)));
      begin = wall->course_ends[i];
    }
    expand (&masonry, &model);
    g_assert_cmpuint (model.block_count, ==, expected.block_count - first);
    for (size_t i = 0; i < model.block_count; i++) {
      const QnBlock *a = &model.blocks[i], *b = &expected.blocks[first + i];
      g_assert_cmpstr (a->name, ==, b->name);
      g_assert_cmpmem (
        model.vertices + a->first_vertex, (size_t) a->vertex_count * sizeof (QnVec2),
        expected.vertices + b->first_vertex, (size_t) b->vertex_count * sizeof (QnVec2));
    }
  }
}

/* Wall 1 without a list: running bond of the same size. */
static void
test_running_is_wall_1 (void)
{
  g_auto (QnModel) expected, model;
  test_model_init_wall (&expected, 1, 0);
  size_t first = expected.block_count;
  g_assert_cmpint (qn_model_expand_walls (&expected, NULL), ==, QN_OK);
  const QnWall *wall = &expected.walls[0];
  g_auto (QnMasonry) masonry;
  init_wall (&masonry, QN_BOND_RUNNING, QN_CLOSER_NONE, 5 * wall->unit.x,
             6 * wall->unit.y);
  masonry.wall.leaves[0].unit = wall->unit;
  /* Wall 1 starts with the course that begins with a half. */
  masonry.wall.leaves[0].lap = 0.5;
  masonry.origin = qn_vec2_add (wall->origin, qn_vec2 (0, -wall->unit.y));
  masonry.wall.height += wall->unit.y;
  expand (&masonry, &model);
  size_t skipped = 5;
  g_assert_cmpuint (model.block_count - skipped, ==, expected.block_count - first);
  for (size_t i = skipped; i < model.block_count; i++) {
    const QnVec2 *a = model.vertices + model.blocks[i].first_vertex;
    const QnVec2 *b =
      expected.vertices + expected.blocks[first + i - skipped].first_vertex;
    for (int k = 0; k < 4; k++) {
      g_assert_cmpfloat_with_epsilon (a[k].x, b[k].x, 1e-14);
      g_assert_cmpfloat_with_epsilon (a[k].y, b[k].y, 1e-14);
    }
  }
}

/* Lengths of the units of one course, from left to right. */
static void
assert_course (const QnModel *model, int course, const double *lengths, size_t count)
{
  double x = 0;
  for (size_t i = 0; i < count; i++) {
    g_autofree char *name = g_strdup_printf ("w.%d.%zu", course, i + 1);
    QnId id = qn_model_find_block (model, name);
    g_assert_cmpint (id, !=, QN_NONE);
    const QnVec2 *corners = qn_model_block_vertices (model, id);
    g_assert_cmpfloat_with_epsilon (corners[0].x, x, 1e-12);
    g_assert_cmpfloat_with_epsilon (corners[1].x - corners[0].x, lengths[i], 1e-12);
    x = corners[1].x;
  }
  g_autofree char *beyond = g_strdup_printf ("w.%d.%zu", course, count + 1);
  g_assert_cmpint (qn_model_find_block (model, beyond), ==, QN_NONE);
}

static void
test_bonds (void)
{
  const struct {
    QnBond bond;
    QnCloser closer;
    double first[9], second[9];
  } cases[] = {
    { QN_BOND_RUNNING, QN_CLOSER_NONE, { .4, .4, .4, .4 }, { .2, .4, .4, .4, .2 } },
    { QN_BOND_STACK, QN_CLOSER_NONE, { .4, .4, .4, .4 }, { .4, .4, .4, .4 } },
    { QN_BOND_HEADER,
      QN_CLOSER_NONE,
      { .2, .2, .2, .2, .2, .2, .2, .2 },
      { .1, .2, .2, .2, .2, .2, .2, .2, .1 } },
    { QN_BOND_ENGLISH,
      QN_CLOSER_QUEEN,
      { .4, .4, .4, .4 },
      { .2, .1, .2, .2, .2, .2, .2, .1, .2 } },
    { QN_BOND_ENGLISH,
      QN_CLOSER_THREE_QUARTER,
      { .3, .4, .4, .2, .3 },
      { .2, .2, .2, .2, .2, .2, .2, .2 } },
    { QN_BOND_FLEMISH,
      QN_CLOSER_QUEEN,
      { .4, .2, .4, .2, .4 },
      { .2, .1, .4, .2, .4, .1, .2 } },
    { QN_BOND_FLEMISH,
      QN_CLOSER_THREE_QUARTER,
      { .4, .2, .4, .2, .4 },
      { .3, .4, .2, .4, .3 } },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_auto (QnMasonry) masonry;
    g_auto (QnModel) model;
    init_wall (&masonry, cases[i].bond, cases[i].closer, 1.6, 0.8);
    expand (&masonry, &model);
    g_assert_cmpfloat_with_epsilon (total_area (&model), 1.6 * 0.8, 1e-12);
    size_t first = 0, second = 0;
    while (first < 9 && cases[i].first[first] > 0)
      first++;
    while (second < 9 && cases[i].second[second] > 0)
      second++;
    assert_course (&model, 1, cases[i].first, first);
    assert_course (&model, 2, cases[i].second, second);
    assert_course (&model, 3, cases[i].first, first);
  }
}

static void
test_course_heights (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  init_wall (&masonry, QN_BOND_RUNNING, QN_CLOSER_NONE, 1.2, 1.0);
  masonry.wall.course_heights = g_new (double, 2);
  masonry.wall.course_heights[0] = 0.3;
  masonry.wall.course_heights[1] = 0.1;
  masonry.wall.course_height_count = 2;
  expand (&masonry, &model);
  const QnVec2 *third =
    qn_model_block_vertices (&model, qn_model_find_block (&model, "w.3.1"));
  g_assert_cmpfloat_with_epsilon (third[0].y, 0.4, 1e-15);
  g_assert_cmpfloat_with_epsilon (third[2].y, 0.7, 1e-15);
  /* 0.3 + 0.1 + 0.3 + 0.1 + 0.2: the fifth course is cut to two thirds, and stays. */
  const QnVec2 *fifth =
    qn_model_block_vertices (&model, qn_model_find_block (&model, "w.5.1"));
  g_assert_cmpfloat_with_epsilon (fifth[2].y, 1.0, 1e-15);
  g_assert_cmpint (qn_model_find_block (&model, "w.6.1"), ==, QN_NONE);
  g_assert_cmpfloat_with_epsilon (total_area (&model), 1.2, 1e-12);
}

/* 0.05 m are left of the last unit of a course: less than a fifth, so the one before it takes
 * them. The course keeps its other names. */
static void
test_minimum_piece (void)
{
  g_auto (QnMasonry) masonry;
  QnModel model;
  init_wall (&masonry, QN_BOND_STACK, QN_CLOSER_NONE, 1.25, 0.2);
  expand (&masonry, &model);
  assert_course (&model, 1, (const double[]){ 0.4, 0.4, 0.45 }, 3);
  qn_model_clear (&model);

  masonry.wall.minimum_piece = 0.1;
  expand (&masonry, &model);
  assert_course (&model, 1, (const double[]){ 0.4, 0.4, 0.4, 0.05 }, 4);
  qn_model_clear (&model);
}

static void
test_toothed (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  init_wall (&masonry, QN_BOND_RUNNING, QN_CLOSER_NONE, 1.2, 0.4);
  masonry.wall.left = QN_EDGE_TOOTHED;
  masonry.wall.right = QN_EDGE_TOOTHED;
  masonry.foundation = 0.1;
  expand (&masonry, &model);
  for (int i = 1; i <= 4; i++) {
    g_autofree char *name = g_strdup_printf ("w.2.%d", i);
    const QnVec2 *unit =
      qn_model_block_vertices (&model, qn_model_find_block (&model, name));
    g_assert_cmpfloat_with_epsilon (unit[0].x, -0.2 + 0.4 * (i - 1), 1e-12);
    g_assert_cmpfloat_with_epsilon (unit[1].x, 0.2 + 0.4 * (i - 1), 1e-12);
  }
  QnId base = qn_model_find_block (&model, "w.base");
  g_assert_true (model.blocks[base].support[QN_DOF_RZ]);
}

static void
test_leaves (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  init_wall (&masonry, QN_BOND_STACK, QN_CLOSER_NONE, 0.4, 0.6);
  QnLeaf *core = qn_masonry_add_leaf (&masonry);
  core->length = 0.3;
  core->unit = qn_vec2 (0.1, 0.15);
  core->bond = QN_BOND_RUNNING;
  expand (&masonry, &model);
  g_assert_cmpfloat_with_epsilon (total_area (&model), 0.7 * 0.6, 1e-12);
  const QnVec2 *unit =
    qn_model_block_vertices (&model, qn_model_find_block (&model, "w.b.2.1"));
  g_assert_cmpfloat_with_epsilon (unit[0].x, 0.4, 1e-12);
  g_assert_cmpfloat_with_epsilon (unit[1].x, 0.45, 1e-12);
  g_assert_cmpint (qn_model_find_block (&model, "w.a.3.1"), !=, QN_NONE);
}

static void
test_rotation (void)
{
  g_auto (QnMasonry) masonry;
  g_auto (QnModel) model;
  init_wall (&masonry, QN_BOND_RUNNING, QN_CLOSER_NONE, 1.6, 0.4);
  masonry.rotation = M_PI_2;
  masonry.origin = qn_vec2 (10, 5);
  expand (&masonry, &model);
  const QnVec2 *unit =
    qn_model_block_vertices (&model, qn_model_find_block (&model, "w.1.1"));
  g_assert_cmpfloat_with_epsilon (unit[1].x, 10, 1e-14);
  g_assert_cmpfloat_with_epsilon (unit[1].y, 5.4, 1e-14);
  g_assert_cmpfloat_with_epsilon (unit[2].x, 9.8, 1e-14);
}

/* Names survive: what a longer, higher wall with one more opening shares with the old one. */
static void
test_names_survive (void)
{
  QnMasonry masonry;
  QnModel before, after;
  init_wall (&masonry, QN_BOND_RUNNING, QN_CLOSER_NONE, 4, 2);
  expand (&masonry, &before);
  masonry.wall.leaves[0].length = 5.2;
  masonry.wall.height = 3;
  QnOpening *opening = qn_masonry_add_opening (&masonry);
  opening->at = qn_vec2 (1.1, 0.5);
  opening->width = 0.9;
  opening->height = 0.9;
  expand (&masonry, &after);
  size_t same = 0;
  for (size_t i = 0; i < before.block_count; i++) {
    QnId id = qn_model_find_block (&after, before.blocks[i].name);
    if (id == QN_NONE)
      continue;
    const QnVec2 *a = qn_model_block_vertices (&before, (QnId) i);
    const QnVec2 *b = qn_model_block_vertices (&after, id);
    same += after.blocks[id].vertex_count == 4 && memcmp (a, b, 4 * sizeof *a) == 0;
  }
  g_assert_cmpuint (same, >, before.block_count / 2);
  qn_model_clear (&before);
  qn_model_clear (&after);
  qn_masonry_clear (&masonry);
}

QN_TESTS
{
  g_test_add_func ("/masonry-wall/six-walls", test_six_walls);
  g_test_add_func ("/masonry-wall/running-is-wall-1", test_running_is_wall_1);
  g_test_add_func ("/masonry-wall/bonds", test_bonds);
  g_test_add_func ("/masonry-wall/course-heights", test_course_heights);
  g_test_add_func ("/masonry-wall/minimum-piece", test_minimum_piece);
  g_test_add_func ("/masonry-wall/toothed", test_toothed);
  g_test_add_func ("/masonry-wall/leaves", test_leaves);
  g_test_add_func ("/masonry-wall/rotation", test_rotation);
  g_test_add_func ("/masonry-wall/names-survive", test_names_survive);
}
