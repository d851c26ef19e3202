#include "doc/view/magnet.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <glib.h>

static void
make_model (QnModel *model)
{
  const QnVec2 v[] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  qn_model_init (model);
  g_assert_nonnull (qn_model_add_block (model, "b", v, 4));
  QnWall *wall = qn_model_add_wall (model, "w");
  wall->origin = qn_vec2 (2.0, 0.0);
  wall->unit = qn_vec2 (0.4, 0.2);
  double lengths[] = { 1.0, 1.0 };
  g_assert_true (qn_wall_add_course (wall, lengths, 2));
}

static void
check (const QnModel *model, QnMagnet magnet, QnVec2 p, QnMagnetKind kind, QnVec2 at)
{
  QnMagnetHit hit = qn_magnet_find (&magnet, model, p, NULL);
  g_assert_cmpint (hit.kind, ==, kind);
  g_assert_cmpfloat_with_epsilon (hit.point.x, at.x, 1e-12);
  g_assert_cmpfloat_with_epsilon (hit.point.y, at.y, 1e-12);
}

static void
test_order (void)
{
  g_auto (QnModel) model;
  make_model (&model);
  QnMagnet magnet = { true, 0.05, 0.1 };
  check (&model, magnet, qn_vec2 (1.01, 1.02), QN_MAGNET_CORNER, qn_vec2 (1.0, 1.0));
  check (&model, magnet, qn_vec2 (1.01, 0.52), QN_MAGNET_MIDDLE, qn_vec2 (1.0, 0.5));
  check (&model, magnet, qn_vec2 (1.01, 0.73), QN_MAGNET_EDGE, qn_vec2 (1.0, 0.73));
  check (&model, magnet, qn_vec2 (4.33, 0.21), QN_MAGNET_COURSE, qn_vec2 (4.33, 0.2));
  check (&model, magnet, qn_vec2 (5.02, 3.01), QN_MAGNET_GRID, qn_vec2 (5.0, 3.0));
  check (&model, magnet, qn_vec2 (5.05, 3.05), QN_MAGNET_NOTHING, qn_vec2 (5.05, 3.05));
  magnet.enabled = false;
  check (&model, magnet, qn_vec2 (1.01, 1.02), QN_MAGNET_NOTHING, qn_vec2 (1.01, 1.02));
}

static void
test_skip (void)
{
  g_auto (QnModel) model;
  make_model (&model);
  QnMagnet magnet = { true, 0.05, 0.0 };
  int skip[] = { 1 };
  g_assert_cmpint (qn_magnet_find (&magnet, &model, qn_vec2 (1.01, 1.02), skip).kind, ==,
                   QN_MAGNET_NOTHING);
}

static void
test_round_distance (void)
{
  static const double cases[][2] = { { 0.011, 0.02 }, { 0.2, 0.2 }, { 0.21, 0.5 },
                                     { 0.6, 1.0 },    { 3.0, 5.0 }, { 70.0, 100.0 },
                                     { 1e-7, 1e-7 },  { 0.0, 1.0 }, { -3.0, 1.0 } };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++)
    g_assert_cmpfloat_with_epsilon (qn_magnet_round_distance (cases[i][0]), cases[i][1],
                                    1e-9 * cases[i][1]);
}

QN_TESTS
{
  g_test_add_func ("/doc/magnet/order", test_order);
  g_test_add_func ("/doc/magnet/skip", test_skip);
  g_test_add_func ("/doc/magnet/round-distance", test_round_distance);
}
