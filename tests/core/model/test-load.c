#include "core/model/model.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>

static void
test_weights_and_forces (void)
{
  g_auto (QnModel) model;
  test_model_init_block_on_plane (&model, 2, 1);
  test_model_add_weight_loads (&model, 0.5);
  QnLoad *force = qn_model_add_live_load (&model);
  force->kind = QN_LOAD_FORCE;
  force->block = 1;
  force->vector = qn_vec2 (100, 20);
  force->moment = 7;
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);

  double forces[6] = { 9, 9, 9, 9, 9, 9 };
  qn_model_set_forces (&model, NULL, forces);
  const double dead[] = { 0, -80000, 0, 0, -20000, 0 };
  for (int i = 0; i < 6; i++)
    g_assert_cmpfloat (forces[i], ==, dead[i]);

  qn_model_live_forces (&model, forces);
  const double live[] = { 40000, 0, 0, 10100, 20, 7 };
  for (int i = 0; i < 6; i++)
    g_assert_cmpfloat (forces[i], ==, live[i]);

  /* At the upper right corner: arm (1, 0.5). */
  force->has_at = true;
  force->at = qn_vec2 (1, 1);
  qn_model_live_forces (&model, forces);
  g_assert_cmpfloat_with_epsilon (forces[5], 7 + 1 * 20 - 0.5 * 100, 1e-12);
}

QN_TESTS
{
  g_test_add_func ("/load/weights-and-forces", test_weights_and_forces);
}
