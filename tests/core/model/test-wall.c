#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static QnWall *
add_wall (QnModel *model, const char *name)
{
  QnWall *wall = qn_model_add_wall (model, name);
  g_assert_nonnull (wall);
  wall->origin = qn_vec2 (10, 20);
  wall->unit = qn_vec2 (0.4, 0.175);
  wall->thickness = 0.5;
  wall->unit_weight = 18000;
  return wall;
}

static void
test_names_and_places (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  QnWall *wall = add_wall (&model, "south");
  wall->law = 0;
  const double first[] = { 0.5, 1, 1.5 }, second[] = { 1, -0.5, 1.5 };
  g_assert_true (qn_wall_add_course (wall, first, 3));
  g_assert_true (qn_wall_add_course (wall, second, 3));
  test_model_add_base (&model, 10, 19, 1.2, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);

  /* Blocks of the file come first; openings are not counted. */
  const char *const names[] = { "base",      "south.1.1", "south.1.2",
                                "south.1.3", "south.2.1", "south.2.2" };
  g_assert_cmpuint (model.block_count, ==, G_N_ELEMENTS (names));
  for (size_t i = 0; i < G_N_ELEMENTS (names); i++)
    g_assert_cmpstr (model.blocks[i].name, ==, names[i]);

  const QnBlock *last = &model.blocks[5];
  const QnVec2 *v = qn_model_block_vertices (&model, 5);
  g_assert_cmpfloat_with_epsilon (v[0].x, 10 + 1.5 * 0.4, 1e-14);
  g_assert_cmpfloat_with_epsilon (v[0].y, 20.175, 1e-14);
  g_assert_cmpfloat_with_epsilon (v[2].x, 10 + 3 * 0.4, 1e-14);
  g_assert_cmpfloat_with_epsilon (v[2].y, 20.35, 1e-14);
  g_assert_cmpint (last->wall, ==, 0);
  g_assert_cmpint (last->law, ==, 0);
  g_assert_false (last->support[0] || last->support[1] || last->support[2]);
  g_assert_cmpfloat_with_epsilon (last->weight, 18000 * 0.6 * 0.175 * 0.5, 1e-9);
}

/* Loads name blocks of walls: expanding first makes them known. */
static void
test_expand_first (void)
{
  g_auto (QnModel) model;
  test_model_init_wall (&model, 1, 0);
  g_assert_cmpint (qn_model_find_block (&model, "w.1.1"), ==, QN_NONE);
  g_assert_cmpint (qn_model_expand_walls (&model, NULL), ==, QN_OK);
  QnId block = qn_model_find_block (&model, "w.6.5");
  g_assert_cmpint (block, ==, 33);

  QnWall *wall = add_wall (&model, "v");
  const double course[] = { 1 };
  g_assert_true (qn_wall_add_course (wall, course, 1));
  g_assert_cmpint (qn_model_expand_walls (&model, NULL), ==, QN_OK);
  g_assert_cmpuint (model.block_count, ==, 35);
  g_assert_cmpint (qn_model_find_block (&model, "v.1.1"), ==, 34);
}

static void
test_large_numbers_in_names (void)
{
  g_auto (QnModel) model;
  test_model_init (&model);
  QnWall *wall = add_wall (&model, "");
  g_free (wall->name);
  wall->name = g_strdup ("ein sehr langer Name \xc3\xa4");
  const double one[] = { 1 };
  double many[1203];
  for (size_t i = 0; i < G_N_ELEMENTS (many); i++)
    many[i] = 1;
  for (int i = 0; i < 10; i++)
    g_assert_true (qn_wall_add_course (wall, one, 1));
  g_assert_true (qn_wall_add_course (wall, many, G_N_ELEMENTS (many)));
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_find_block (&model, "ein sehr langer Name \xc3\xa4.11.1203"),
                   ==, 1212);
}

typedef struct {
  const char *name;
  double lengths[4];
  size_t count;
  QnProblem problem;
  QnId position;
} Case;

static const Case cases[] = {
  { "zero", { 1, 0, 1 }, 3, QN_PROBLEM_COURSE_LENGTH_ZERO, 1 },
  { "nan", { 1, 1, NAN }, 3, QN_PROBLEM_NOT_FINITE, 2 },
  { "infinite", { -INFINITY }, 1, QN_PROBLEM_NOT_FINITE, 0 },
  { "absurd", { 1e9 }, 1, QN_PROBLEM_TOO_LARGE, 0 },
  { "absurd-opening", { 1, -1e9, 1 }, 3, QN_PROBLEM_TOO_LARGE, 1 },
  { "empty", { 0 }, 0, QN_PROBLEM_COURSE_EMPTY, QN_NONE },
};

static void
test_bad_course (const void *data)
{
  const Case *c = data;
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init (&model);
  QnWall *wall = add_wall (&model, "w");
  const double sound[] = { 1, 1 };
  g_assert_true (qn_wall_add_course (wall, sound, 2));
  g_assert_true (qn_wall_add_course (wall, c->lengths, c->count));
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, c->problem);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_WALL);
  g_assert_cmpint (diag.index, ==, 0);
  g_assert_cmpint (diag.sub, ==, 1);
  g_assert_cmpint (diag.other, ==, c->position);
  g_assert_cmpuint (model.block_count, ==, 0); /* nothing was built */
}

/* A thousand million blocks are refused by counting, not by trying: the course ends say so, the
 * lengths behind them are never read beyond the first course that is too long. */
static void
test_too_many_blocks (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init (&model);
  size_t count = 1000;
  g_autofree double *course = g_new (double, count);
  for (size_t i = 0; i < count; i++)
    course[i] = 1;
  QnWall *wall = add_wall (&model, "w");
  for (size_t i = 0; i < QN_MAX_BLOCKS / count; i++)
    g_assert_true (qn_wall_add_course (wall, course, count));
  g_assert_true (qn_wall_add_course (wall, course, 1));
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_TOO_MANY_BLOCKS);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_WALL);
  g_assert_cmpuint (model.block_capacity, ==, 0);
}

static void
test_bad_wall (void)
{
  struct {
    QnVec2 origin, unit;
    QnProblem problem;
    const char *field;
  } bad[] = {
    { { NAN, 0 }, { 1, 1 }, QN_PROBLEM_NOT_FINITE, "origin" },
    { { 0, 1e200 }, { 1, 1 }, QN_PROBLEM_TOO_LARGE, "origin" },
    { { 0, 0 }, { 0, 1 }, QN_PROBLEM_NOT_POSITIVE, "unit" },
    { { 0, 0 }, { 1, -1 }, QN_PROBLEM_NOT_POSITIVE, "unit" },
    { { 0, 0 }, { 1, INFINITY }, QN_PROBLEM_NOT_FINITE, "unit" },
  };
  for (size_t i = 0; i < G_N_ELEMENTS (bad); i++) {
    g_auto (QnModel) model;
    QnDiag diag;
    test_model_init (&model);
    QnWall *wall = add_wall (&model, "w");
    const double course[] = { 1 };
    g_assert_true (qn_wall_add_course (wall, course, 1));
    wall->origin = bad[i].origin;
    wall->unit = bad[i].unit;
    g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
    g_assert_cmpint (diag.problem, ==, bad[i].problem);
    g_assert_cmpstr (diag.field, ==, bad[i].field);
  }
}

static void
test_same_name_twice (void)
{
  g_auto (QnModel) model;
  QnDiag diag;
  test_model_init (&model);
  const double course[] = { 1 };
  g_assert_true (qn_wall_add_course (add_wall (&model, "w"), course, 1));
  g_assert_true (qn_wall_add_course (add_wall (&model, "w"), course, 1));
  g_assert_cmpint (qn_model_prepare (&model, &diag), ==, QN_ERROR_INVALID);
  g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NAME_TAKEN);
  g_assert_cmpint (diag.entity, ==, QN_ENTITY_WALL);
  g_assert_cmpint (diag.index, ==, 1);
}

QN_TESTS
{
  g_test_add_func ("/wall/names-and-places", test_names_and_places);
  g_test_add_func ("/wall/expand-first", test_expand_first);
  g_test_add_func ("/wall/large-numbers-in-names", test_large_numbers_in_names);
  for (size_t i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *path = g_strconcat ("/wall/bad-course/", cases[i].name, NULL);
    g_test_add_data_func (path, &cases[i], test_bad_course);
  }
  g_test_add_func ("/wall/too-many-blocks", test_too_many_blocks);
  g_test_add_func ("/wall/bad-wall", test_bad_wall);
  g_test_add_func ("/wall/same-name-twice", test_same_name_twice);
}
