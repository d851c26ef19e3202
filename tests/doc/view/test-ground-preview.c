#include "doc/view/ground-preview.h"
#include "support/auto-clear.h"
#include "support/room.h"

static void
init_pulse (QnModel *model)
{
  qn_model_init (model);
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (0, 2);
  motion->scale = 0.5;
  motion->pulse =
    (QnPulse){ .kind = QN_PULSE_RECTANGLE, .amplitude = 3, .duration = 2, .start = 1 };
}

static double
value_at (const QnGroundPreview *preview, double x)
{
  gsize i = 0;
  while (i + 1 < preview->count && preview->x[i + 1] <= x)
    i++;
  return preview->y[i];
}

/* A rectangle of 3 m/s2 from 1 s to 3 s: 6 m/s in the end. */
static void
test_rectangle (void)
{
  g_auto (QnModel) model;
  QnGroundPreview preview;
  init_pulse (&model);
  qn_ground_preview_init (&preview, &model, 0, QN_GROUND_ACCELERATION);
  g_assert_cmpfloat (value_at (&preview, 0.5), ==, 0);
  g_assert_cmpfloat_with_epsilon (value_at (&preview, 2), 3, 1e-9);
  g_assert_cmpfloat (preview.x[preview.count - 1], >, 3);
  qn_ground_preview_clear (&preview);
  qn_ground_preview_init (&preview, &model, 0, QN_GROUND_VELOCITY);
  g_assert_cmpfloat_with_epsilon (preview.y[preview.count - 1], 6, 1e-9);
  g_assert_cmpfloat_with_epsilon (value_at (&preview, 2), 3, 0.02);
  qn_ground_preview_clear (&preview);
  qn_ground_preview_init (&preview, &model, 0, QN_GROUND_DISPLACEMENT);
  double after = preview.x[preview.count - 1] - 3;
  g_assert_cmpfloat_with_epsilon (preview.y[preview.count - 1], 6 + 6 * after, 0.05);
  qn_ground_preview_clear (&preview);

  /* Short periods double a sudden acceleration. */
  qn_ground_preview_init (&preview, &model, 0, QN_GROUND_SPECTRUM);
  g_assert_cmpfloat (value_at (&preview, 0.3), >, 3 * 1.8);
  g_assert_cmpfloat (value_at (&preview, 0.3), <, 3 * 2);
  qn_ground_preview_clear (&preview);

  qn_ground_preview_init (&preview, &model, 1, QN_GROUND_SPECTRUM);
  g_assert_cmpuint (preview.count, ==, 0);
}

QN_TESTS
{
  g_test_add_func ("/doc/ground-preview/rectangle", test_rectangle);
}
