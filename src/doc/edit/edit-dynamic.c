#include "doc/edit/edit-dynamic.h"

#include "io/exchange/record.h"

#include <glib/gi18n.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

gboolean
qn_edit_add_pulse (QnModel *model, GError **error)
{
  QnGroundMotion *motion = qn_model_add_ground_motion (model, NULL);
  if (motion == NULL)
    return qn_edit_no_memory (error);
  motion->kind = QN_SIGNAL_PULSE;
  motion->direction = qn_vec2 (1, 0);
  motion->pulse =
    (QnPulse){ .kind = QN_PULSE_HALF_SINE, .amplitude = 2, .duration = 0.5, .start = 0 };
  return TRUE;
}

gboolean
qn_edit_choose_dynamic (QnModel *model, GError **error)
{
  QnDynamicSettings *dynamic = &model->analysis.dynamic;
  model->analysis.procedure = QN_PROCEDURE_DYNAMIC;
  if (!(dynamic->duration > 0)) {
    dynamic->duration = 10;
    model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  }
  if (!(dynamic->time_step > 0))
    dynamic->time_step = 0.005;
  return model->ground_count > 0 || model->initial_count > 0
         || qn_edit_add_pulse (model, error);
}

gboolean
qn_edit_add_record (QnModel *model, const char *path, GError **error)
{
  QnRecord record;
  if (!qn_record_read (path, NULL, 0, &record, error))
    return FALSE;
  QnGroundMotion *motion = qn_model_add_ground_motion (model, NULL);
  gboolean done = motion != NULL;
  if (done) {
    motion->kind = QN_SIGNAL_POINTS;
    motion->direction = qn_vec2 (1, 0);
  }
  for (gsize i = 0; done && i < record.count; i++)
    done = qn_ground_motion_add_point (motion, record.points[i].x, record.points[i].y);
  qn_record_clear (&record);
  return done || qn_edit_no_memory (error);
}

gboolean
qn_edit_remove_ground_motion (QnModel *model, gsize index, GError **error)
{
  QnGroundMotion *motion = &model->ground[index];
  (void) error;
  free (motion->points);
  free (motion->record);
  free (motion->unit);
  memmove (motion, motion + 1, (--model->ground_count - index) * sizeof *motion);
  return TRUE;
}

const char *
qn_pulse_kind_text (QnPulseKind kind)
{
  switch (kind) {
  case QN_PULSE_HALF_SINE:
    return _ ("half sine");
  case QN_PULSE_SINE:
    return _ ("sine");
  case QN_PULSE_RECTANGLE:
    return _ ("rectangle");
  case QN_PULSE_RICKER:
    return _ ("Ricker wavelet");
  case QN_PULSE_STEP_IMPULSE:
    return _ ("step impulse");
  case QN_PULSE_KIND_COUNT:
    break;
  }
  g_assert_not_reached ();
}

char *
qn_ground_motion_dup_text (const QnGroundMotion *motion)
{
  double peak = 0;
  switch (motion->kind) {
  case QN_SIGNAL_PULSE:
    return g_strdup_printf (
      _ ("%s, %.3g m/s², %.3g s"), qn_pulse_kind_text (motion->pulse.kind),
      motion->scale * motion->pulse.amplitude, motion->pulse.duration);
  case QN_SIGNAL_RECORD:
    return g_strdup (motion->record);
  case QN_SIGNAL_POINTS:
    for (gsize i = 0; i < motion->point_count; i++)
      peak = MAX (peak, fabs (motion->points[i].y));
    return g_strdup_printf (_ ("%zu points, %.3g m/s², %.3g s"), motion->point_count,
                            fabs (motion->scale) * peak, qn_ground_motion_end (motion));
  }
  g_assert_not_reached ();
}
