/* analysis.dynamic: ground motions, initial motion, tracks and the time integration. */
#include "io/project/project-names.h"
#include "io/project/project-read-parts.h"

#include "core/base/memory.h"

#include <glib/gi18n-lib.h>

static gboolean
read_point (const QnJsonValue *place, QnGroundMotion *motion)
{
  QnVec2 point;
  if (!qn_json_value_vec2 (place, &point))
    return FALSE;
  return qn_ground_motion_add_point (motion, point.x, point.y)
         || qn_json_value_no_memory (place);
}

static gboolean
read_pulse (const QnJsonValue *place, QnPulse *pulse)
{
  static const char *const keys[] = { "kind", "amplitude", "duration", "start" };
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_pulse_kind_names,
                            QN_PULSE_KIND_COUNT, &pulse->kind)
      || !qn_member_number (place, "amplitude", QN_REQUIRED, QN_RANGE_FINITE,
                            &pulse->amplitude)
      || !qn_member_number (place, "duration", QN_REQUIRED, QN_RANGE_POSITIVE,
                            &pulse->duration)
      || !qn_member_number (place, "start", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &pulse->start))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return TRUE;
}

/* The signal: a record, points or a pulse, one of them. */
static gboolean
read_signal (const QnJsonValue *place, QnGroundMotion *motion)
{
  QnJsonValue points = qn_json_value_member (place, "points");
  QnJsonValue pulse = qn_json_value_member (place, "pulse");
  int given = (motion->record != NULL) + (points.json != NULL) + (pulse.json != NULL);
  if (given != 1)
    return qn_json_value_fail (place, _ ("expected one of record, points and pulse"));
  if (motion->record == NULL
      && (motion->unit != NULL || motion->time_step > 0 || motion->peak > 0
          || motion->rests))
    return qn_json_value_fail (place,
                               _ ("unit, time_step, peak and rest belong to a record"));
  if (points.json != NULL) {
    gsize index = 0;
    if (!qn_json_value_array (&points))
      return FALSE;
    for (const cJSON *item = points.json->child; item != NULL; item = item->next) {
      QnJsonValue point = qn_json_value_element (&points, index++, item);
      if (index > QN_MAX_SIGNAL_POINTS)
        return qn_json_value_fail (&points,
                                   _ (qn_problem_text (QN_PROBLEM_SIGNAL_TOO_LONG)));
      if (!read_point (&point, motion))
        return FALSE;
    }
    return TRUE;
  }
  if (pulse.json == NULL)
    return TRUE;
  motion->kind = QN_SIGNAL_PULSE;
  return read_pulse (&pulse, &motion->pulse);
}

static gboolean
read_ground (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "direction", "scale", "record",
                                      "points",    "pulse", "unit",
                                      "time_step", "peak",  "rest" };
  const char *record = NULL, *unit = NULL;
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "record", QN_OPTIONAL, &record)
      || !qn_member_string (place, "unit", QN_OPTIONAL, &unit))
    return FALSE;
  QnGroundMotion *motion = qn_model_add_ground_motion (model, record);
  if (motion == NULL)
    return qn_json_value_no_memory (place);
  motion->unit = qn_strdup (unit);
  if (motion->unit == NULL && unit != NULL)
    return qn_json_value_no_memory (place);
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_member_vec2 (place, "direction", QN_REQUIRED, &motion->direction)
         && qn_member_number (place, "scale", QN_OPTIONAL, QN_RANGE_FINITE,
                              &motion->scale)
         && qn_member_number (place, "time_step", QN_OPTIONAL, QN_RANGE_POSITIVE,
                              &motion->time_step)
         && qn_member_number (place, "peak", QN_OPTIONAL, QN_RANGE_POSITIVE,
                              &motion->peak)
         && qn_member_bool (place, "rest", QN_OPTIONAL, &motion->rests)
         && read_signal (place, motion);
}

/* [ux, uy, rz]; left as it is where there is none. */
static gboolean
read_triple (const QnJsonValue *owner, const char *key, double triple[QN_DOF_COUNT])
{
  QnJsonValue list = qn_json_value_member (owner, key);
  gsize index = 0;
  if (list.json == NULL)
    return TRUE;
  if (!qn_json_value_array (&list))
    return FALSE;
  for (const cJSON *item = list.json->child; item != NULL; item = item->next, index++) {
    QnJsonValue number = qn_json_value_element (&list, index, item);
    if (index < QN_DOF_COUNT
        && !qn_json_value_number (&number, QN_RANGE_FINITE, &triple[index]))
      return FALSE;
  }
  return index == QN_DOF_COUNT
         || qn_json_value_fail (&list, _ ("expected three numbers: ux, uy, rz"));
}

static gboolean
read_initial (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "block", "displacement", "velocity" };
  QnInitialMotion *motion = qn_model_add_initial_motion (model);
  if (motion == NULL)
    return qn_json_value_no_memory (place);
  if (!qn_json_value_object (place))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK, &motion->block)
         && read_triple (place, "displacement", motion->displacement)
         && read_triple (place, "velocity", motion->velocity);
}

static gboolean
read_track (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "block", "component" };
  QnTrack *track = qn_model_add_track (model);
  if (track == NULL)
    return qn_json_value_no_memory (place);
  if (!qn_json_value_object (place)
      || !qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK, &track->block)
      || !qn_member_choice (place, "component", QN_REQUIRED, qn_dof_names, QN_DOF_COUNT,
                            &track->dof))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return TRUE;
}

static gboolean
read_damping (const QnJsonValue *owner, QnDynamicSettings *settings)
{
  static const char *const keys[] = { "mass", "stiffness", "of" };
  QnJsonValue place = qn_json_value_member (owner, "damping");
  if (place.json == NULL)
    return TRUE;
  if (!qn_json_value_object (&place)
      || !qn_member_number (&place, "mass", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &settings->mass_damping)
      || !qn_member_number (&place, "stiffness", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &settings->joint_damping)
      || !qn_member_choice (&place, "of", QN_OPTIONAL, qn_damping_stiffness_names,
                            QN_DAMPING_STIFFNESS_COUNT, &settings->of))
    return FALSE;
  qn_json_value_warn_unknown (&place, keys, G_N_ELEMENTS (keys));
  return TRUE;
}

gboolean
qn_member_follows (const QnJsonValue *object, bool *follows)
{
  static const char *const names[] = { "fixed", "follow" };
  int choice = *follows ? 1 : 0;
  if (!qn_member_choice (object, "contacts", QN_OPTIONAL, names, G_N_ELEMENTS (names),
                         &choice))
    return FALSE;
  *follows = choice == 1;
  return TRUE;
}

gboolean
qn_read_dynamic (const QnJsonValue *analysis, QnModel *model)
{
  static const char *const keys[] = { "duration", "time_step",       "rho",
                                      "damping",  "ground",          "initial",
                                      "track",    "output_interval", "tolerance",
                                      "adaptive", "contacts",        "fall" };
  QnDynamicSettings *settings = &model->analysis.dynamic;
  QnJsonValue place = qn_json_value_member (analysis, "dynamic");
  if (place.json == NULL) {
    if (model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
      return qn_json_value_fail (&place,
                                 _ ("an analysis in time needs duration and time_step"));
    return TRUE;
  }
  if (!qn_json_value_object (&place))
    return FALSE;
  qn_json_value_warn_unknown (&place, keys, G_N_ELEMENTS (keys));
  return qn_member_follows (&place, &settings->follow)
         && qn_member_number (&place, "duration", QN_REQUIRED, QN_RANGE_POSITIVE,
                              &settings->duration)
         && qn_member_number (&place, "time_step", QN_REQUIRED, QN_RANGE_POSITIVE,
                              &settings->time_step)
         && qn_member_number (&place, "rho", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                              &settings->rho)
         && qn_member_number (&place, "tolerance", QN_OPTIONAL, QN_RANGE_POSITIVE,
                              &settings->tolerance)
         && qn_member_number (&place, "output_interval", QN_OPTIONAL, QN_RANGE_POSITIVE,
                              &settings->output_interval)
         && qn_member_bool (&place, "adaptive", QN_OPTIONAL, &settings->adaptive)
         && qn_member_bool (&place, "fall", QN_OPTIONAL, &settings->fall)
         && read_damping (&place, settings)
         && qn_read_each (&place, "ground", QN_OPTIONAL, read_ground, model)
         && qn_read_each (&place, "initial", QN_OPTIONAL, read_initial, model)
         && qn_read_each (&place, "track", QN_OPTIONAL, read_track, model);
}
