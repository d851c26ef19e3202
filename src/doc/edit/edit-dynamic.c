#include "doc/edit/edit-dynamic.h"

#include "io/exchange/record.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

gboolean
qn_edit_add_pulse (QnModel *model, GError **error)
{
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
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
  if (!(dynamic->time_step > 0)) {
    dynamic->duration = 10;
    dynamic->time_step = 0.005;
    model->analysis.geometry = QN_GEOMETRY_NONLINEAR;
  }
  return model->ground_count > 0 || model->initial_count > 0
         || qn_edit_add_pulse (model, error);
}

/* ---- initial motion ---- */

QnInitialMotion
qn_initial_motion_of (const QnModel *model, QnId block)
{
  for (gsize i = 0; i < model->initial_count; i++)
    if (model->initial[i].block == block)
      return model->initial[i];
  return (QnInitialMotion){ .block = block };
}

QnTransform
qn_initial_transform (const QnModel *model, const QnInitialMotion *motion)
{
  const double *u = motion->displacement;
  QnTransform turn =
    qn_transform_rotation (model->blocks[motion->block].centroid, u[QN_DOF_RZ]);
  return qn_transform_compose (turn,
                               qn_transform_translation (u[QN_DOF_UX], u[QN_DOF_UY]));
}

/* Fixed blocks that would move are named; the check of the model knows no more of the hand. */
gboolean
qn_edit_set_initial (QnModel *model, const QnInitialMotion *motion, GError **error)
{
  const QnBlock *block = &model->blocks[motion->block];
  gboolean moves = FALSE;
  gsize i = 0;
  for (int k = 0; k < QN_DOF_COUNT; k++) {
    gboolean goes = motion->displacement[k] != 0.0 || motion->velocity[k] != 0.0;
    if (goes && block->support[k])
      return qn_edit_refuse (
        error, _ ("Block %s is fixed: it cannot start from elsewhere"), block->name);
    moves = moves || goes;
  }
  while (i < model->initial_count && model->initial[i].block != motion->block)
    i++;
  const gboolean known = i < model->initial_count;
  if (!moves) {
    if (known)
      qn_edit_drop (model->initial, &model->initial_count, sizeof *model->initial, i);
    return TRUE;
  }
  QnInitialMotion *to = known ? &model->initial[i] : qn_model_add_initial_motion (model);
  if (to == NULL)
    return qn_edit_no_memory (error);
  *to = *motion;
  return qn_edit_choose_dynamic (model, error);
}

/* ---- records ---- */

gboolean
qn_edit_add_record (QnModel *model, const char *path, GError **error)
{
  QnRecord record;
  if (!qn_record_read (path, NULL, 0, FALSE, &record, error))
    return FALSE;
  QnGroundMotion *motion = qn_model_add_ground_motion (model);
  gboolean done = motion != NULL;
  if (done) {
    motion->kind = QN_SIGNAL_POINTS;
    motion->direction = qn_vec2 (1, 0);
  }
  for (gsize i = 0; done && i < record.count; i++)
    done = qn_ground_motion_add_point (motion, record.points[i].x, record.points[i].y);
  qn_record_clear (&record);
  if (done && qn_record_is_cut (model, motion))
    model->analysis.dynamic.duration = 0; /* to its end */
  return done || qn_edit_no_memory (error);
}

gboolean
qn_edit_remove_ground_motion (QnModel *model, gsize index, GError **error)
{
  QnGroundMotion *motion = &model->ground[index];
  free (motion->points);
  free (motion->record);
  free (motion->unit);
  qn_edit_drop (model->ground, &model->ground_count, sizeof *motion, index);
  return TRUE;
}

const char *
qn_pulse_kind_text (QnPulseKind kind)
{
  static const char *const texts[QN_PULSE_KIND_COUNT] = {
    [QN_PULSE_HALF_SINE] = N_ ("half sine"),
    [QN_PULSE_SINE] = N_ ("sine"),
    [QN_PULSE_RECTANGLE] = N_ ("rectangle"),
    [QN_PULSE_RICKER] = N_ ("Ricker wavelet"),
    [QN_PULSE_STEP_IMPULSE] = N_ ("step impulse"),
  };
  return _ (texts[kind]);
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
