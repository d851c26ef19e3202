#include "long-analysis.h"
#include "support/edit-model.h"

/* Nobody waits for its end: a day of slow motion of the ground, in so many steps. */
static gboolean
shake (QnModel *model, gpointer data, GError **error)
{
  enum { DAY = 86400, STEPS = 400000 };
  (void) data;
  (void) error;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  g_assert_nonnull (motion);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse = (QnPulse){ .kind = QN_PULSE_SINE, .amplitude = 0.1, .duration = DAY };
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  model->analysis.max_factorizations = INT32_MAX;
  model->analysis.dynamic.duration = DAY;
  model->analysis.dynamic.time_step = (double) DAY / STEPS;
  model->analysis.dynamic.output_interval = 10.0 * DAY / STEPS;
  model->analysis.dynamic.adaptive = FALSE;
  return TRUE;
}

void
long_analysis_ask (QnDocument *document)
{
  g_autoptr (GError) error = NULL;

  edit_model (document, "Shake", NULL, shake, NULL, &error);
  g_assert_no_error (error);
}
