/* Shapes of mechanisms: alike whatever the blocks are called and however many there are. */
#include "study/cases/case.h"

#include "core/model/model.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include <string.h>

/* A stack of `count` blocks, 1 m wide and 2 m high. */
static void
init_stack (QnModel *model, int count)
{
  qn_model_init (model);
  for (int i = 0; i < count; i++) {
    double y = 2.0 * i / count, top = 2.0 * (i + 1) / count;
    const QnVec2 corners[] = { { 0, y }, { 1, y }, { 1, top }, { 0, top } };
    QnBlock *block = qn_model_add_block (model, "b", corners, 4);
    block->centroid = qn_vec2 (0.5, 0.5 * (y + top));
  }
}

/* The field of a rigid turn about a point, of the blocks from `first` on. */
static char *
dup_turned (int count, int first, QnVec2 centre, double speed)
{
  g_auto (QnModel) model;
  init_stack (&model, count);
  g_autofree double *v = g_new0 (double, 3 * count);
  for (int i = first; i < count; i++) {
    QnVec2 arm = qn_vec2_sub (model.blocks[i].centroid, centre);
    v[3 * i] = -speed * arm.y;
    v[3 * i + 1] = speed * arm.x;
    v[3 * i + 2] = speed;
  }
  char *shape = qn_shape_dup (&model, v);
  return shape;
}

static void
test_alike (void)
{
  g_autofree char *coarse = dup_turned (4, 0, qn_vec2 (1, 0), -1);
  g_autofree char *fine = dup_turned (20, 0, qn_vec2 (1, 0), -7);
  g_autofree char *upper = dup_turned (20, 10, qn_vec2 (1, 1), -1);
  g_autofree char *back = dup_turned (20, 0, qn_vec2 (1, 0), 1);
  g_assert_cmpuint (strlen (coarse), ==, QN_SHAPE_LENGTH);
  g_assert_cmpfloat (qn_shape_cosine (coarse, fine), >, 0.999);
  g_assert_cmpfloat (qn_shape_cosine (fine, upper), <, QN_SHAPE_ALIKE);
  g_assert_cmpfloat (qn_shape_cosine (fine, back), <, -0.99);
}

static void
test_none (void)
{
  g_autofree char *some = dup_turned (4, 0, qn_vec2 (1, 0), 1);
  g_autofree char *none = dup_turned (4, 0, qn_vec2 (1, 0), 0);
  g_assert_null (none);
  g_assert_cmpfloat (qn_shape_cosine (some, NULL), ==, 0);
  g_assert_cmpfloat (qn_shape_cosine (some, "AB"), ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/study/shape/alike", test_alike);
  g_test_add_func ("/study/shape/none", test_none);
}
