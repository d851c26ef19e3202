#include "core/result/mechanism.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

static void
test_cosine (void)
{
  const double slide[6] = { 0, 0, 0, 1, 0, 0 }, fast[6] = { 0, 0, 0, 5, 0, 0 };
  const double back[6] = { 0, 0, 0, -1, 0, 0 }, lift[6] = { 0, 0, 0, 0, 1, 0 };
  const double rest[6] = { 0 }, turn[6] = { 0, 0, 0, 1, 0, -1 };
  g_auto (QnModel) model;

  test_model_init_block_on_plane (&model, 2, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpfloat_with_epsilon (qn_mechanism_cosine (&model, slide, fast), 1, 1e-15);
  g_assert_cmpfloat_with_epsilon (qn_mechanism_cosine (&model, slide, back), -1, 1e-15);
  g_assert_cmpfloat (qn_mechanism_cosine (&model, slide, lift), ==, 0);
  g_assert_cmpfloat (qn_mechanism_cosine (&model, slide, rest), ==, 0);
  /* Inertia of 2 x 1: (2^2 + 1^2)/12 per mass. */
  g_assert_cmpfloat_with_epsilon (qn_mechanism_cosine (&model, slide, turn),
                                  1 / sqrt (1 + 5.0 / 12), 1e-12);
}

static void
test_cluster (void)
{
  const double slide[6] = { 0, 0, 0, 1, 0, 0 }, almost[6] = { 0, 0, 0, 1, 0.01, 0 };
  const double lift[6] = { 0, 0, 0, 0, 1, 0 }, lifted[6] = { 0, 0, 0, 0, 3, 0 };
  const double *fields[5] = { slide, lift, almost, lifted, slide };
  int32_t groups[5];
  g_auto (QnModel) model;

  test_model_init_block_on_plane (&model, 2, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_mechanism_cluster (&model, fields, 5, 0.95, groups), ==, 2);
  const int32_t expected[5] = { 0, 1, 0, 1, 0 };
  for (int i = 0; i < 5; i++)
    g_assert_cmpint (groups[i], ==, expected[i]);
  g_assert_cmpint (qn_mechanism_cluster (&model, fields, 5, 0.999999, groups), ==, 3);
  g_assert_cmpint (groups[2], ==, 2);
  g_assert_cmpint (qn_mechanism_cluster (&model, fields, 0, 0.9, groups), ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/mechanism-compare/cosine", test_cosine);
  g_test_add_func ("/mechanism-compare/cluster", test_cluster);
}
