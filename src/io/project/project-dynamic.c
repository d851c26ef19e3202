/* analysis.dynamic: ground motions, initial motion, tracks and the time integration. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"

#include <glib/gi18n-lib.h>

static const QnMember pulse_members[] = {
  QN_CHOICE ("kind", REQUIRED, qn_pulse_kind_names, QnPulse, kind),
  QN_NUMBER ("amplitude", REQUIRED, FINITE, QnPulse, amplitude),
  QN_NUMBER ("duration", REQUIRED, POSITIVE, QnPulse, duration),
  QN_NUMBER ("start", OPTIONAL, NOT_NEGATIVE, QnPulse, start),
  { 0 },
};

static const QnMember ground_members[] = {
  QN_TWO ("direction", REQUIRED, QnGroundMotion, direction),
  QN_NUMBER ("scale", OPTIONAL, FINITE, QnGroundMotion, scale),
  QN_STRING ("record", OPTIONAL, QnGroundMotion, record),
  QN_STRING ("unit", OPTIONAL, QnGroundMotion, unit),
  QN_NUMBER ("time_step", OPTIONAL, POSITIVE, QnGroundMotion, time_step),
  QN_BOOL ("rest", OPTIONAL, QnGroundMotion, rests),
  QN_KNOWN ("points"),
  QN_OBJECT ("pulse", READ, pulse_members, QnGroundMotion, pulse),
  QN_NUMBER ("peak", OPTIONAL, POSITIVE, QnGroundMotion, peak),
  { 0 },
};

static const QnMember initial_members[] = {
  QN_ENTITY ("block", REQUIRED, BLOCK, QnInitialMotion, block),
  QN_LIST_OF ("displacement", NUMBERS, OPTIONAL, QnInitialMotion, displacement,
              QN_DOF_COUNT, N_ ("expected three numbers: ux, uy, rz")),
  QN_LIST_OF ("velocity", NUMBERS, OPTIONAL, QnInitialMotion, velocity, QN_DOF_COUNT,
              N_ ("expected three numbers: ux, uy, rz")),
  { 0 },
};

static const QnMember track_members[] = {
  QN_ENTITY ("block", REQUIRED, BLOCK, QnTrack, block),
  QN_CHOICE ("component", REQUIRED, qn_dof_names, QnTrack, dof),
  { 0 },
};

static const QnMember damping_members[] = {
  QN_NUMBER ("mass", WRITTEN, NOT_NEGATIVE, QnDynamicSettings, mass_damping),
  QN_NUMBER ("stiffness", WRITTEN, NOT_NEGATIVE, QnDynamicSettings, joint_damping),
  QN_CHOICE ("of", WRITTEN, qn_damping_stiffness_names, QnDynamicSettings, of),
  { 0 },
};

static const QnMember dynamic_members[] = {
  QN_NUMBER ("duration", OPTIONAL, POSITIVE, QnDynamicSettings, duration),
  QN_NUMBER ("time_step", REQUIRED, POSITIVE, QnDynamicSettings, time_step),
  QN_NUMBER ("rho", WRITTEN, NOT_NEGATIVE, QnDynamicSettings, rho),
  QN_NUMBER ("tolerance", OPTIONAL, POSITIVE, QnDynamicSettings, tolerance),
  QN_BOOL ("adaptive", OPTIONAL, QnDynamicSettings, adaptive),
  QN_SWITCH ("contacts", OPTIONAL, qn_follow_names, QnDynamicSettings, follow),
  QN_BOOL ("fall", OPTIONAL, QnDynamicSettings, fall),
  QN_NUMBER ("output_interval", OPTIONAL, POSITIVE, QnDynamicSettings, output_interval),
  QN_KNOWN ("damping"),
  QN_KNOWN ("ground"),
  QN_KNOWN ("initial"),
  QN_KNOWN ("track"),
  { 0 },
};

/* ---- reading ---- */

static gboolean
read_points (const QnJsonValue *points, QnGroundMotion *motion)
{
  QnJsonValue element = { 0 };
  if (!qn_json_value_array (points))
    return FALSE;
  while (qn_json_value_next (points, &element)) {
    QnVec2 point;
    if (element.index >= QN_MAX_SIGNAL_POINTS)
      return qn_json_value_fail (points,
                                 _ (qn_problem_text (QN_PROBLEM_SIGNAL_TOO_LONG)));
    if (!qn_json_value_vec2 (&element, &point))
      return FALSE;
    if (!qn_ground_motion_add_point (motion, point.x, point.y))
      return qn_json_value_no_memory (&element);
  }
  return TRUE;
}

/* The signal: a record, points or a pulse, one of them. */
static gboolean
read_ground (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  (void) model;
  QnGroundMotion *motion = entity;
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
  if (points.json != NULL)
    return read_points (&points, motion);
  motion->kind = pulse.json != NULL ? QN_SIGNAL_PULSE : QN_SIGNAL_RECORD;
  return TRUE;
}

gboolean
qn_read_dynamic (const QnJsonValue *analysis, QnModel *model)
{
  QnDynamicSettings *settings = &model->analysis.dynamic;
  QnJsonValue place = qn_json_value_member (analysis, "dynamic");
  if (place.json == NULL && model->analysis.procedure == QN_PROCEDURE_DYNAMIC)
    return qn_json_value_fail (&place, _ ("an analysis in time needs a time_step"));
  if (place.json == NULL)
    return TRUE;
  QnJsonValue damping = qn_json_value_member (&place, "damping");
  QnJsonValue duration = qn_json_value_member (&place, "duration");
  return qn_members_read (&place, dynamic_members, NULL, settings)
         && (damping.json == NULL
             || qn_members_read (&damping, damping_members, NULL, settings))
         && qn_read_list (&place, &qn_ground_list, QN_OPTIONAL, model)
         && qn_read_list (&place, &qn_initial_list, QN_OPTIONAL, model)
         && qn_read_list (&place, &qn_track_list, QN_OPTIONAL, model)
         && (settings->duration > 0 || model->ground_count > 0
             || qn_json_value_fail (
               &duration, _ ("without ground motion the duration must be given")));
}

/* ---- writing ---- */

static void
append_ground (GString *json, const QnModel *model, size_t index)
{
  const QnGroundMotion *motion = &model->ground[index], usual = { .scale = 1 };
  qn_members_write (json, ground_members, NULL, motion, &usual);
  if (motion->kind == QN_SIGNAL_POINTS)
    qn_json_put_points (json, "points", motion->points, motion->point_count);
  if (motion->kind == QN_SIGNAL_PULSE)
    qn_members_put (json, "pulse", pulse_members, NULL, &motion->pulse, &usual.pulse);
}

const QnList qn_ground_list = {
  QN_LIST ("analysis.dynamic.ground", QnGroundMotion, ground, ground_count),
  .members = ground_members, .read = read_ground, .append = append_ground
};
const QnList qn_initial_list = {
  QN_LIST ("analysis.dynamic.initial", QnInitialMotion, initial, initial_count),
  .members = initial_members, .usual = &(const QnInitialMotion){ 0 }
};
const QnList qn_track_list = { QN_LIST ("analysis.dynamic.track", QnTrack, tracks,
                                        track_count),
                               .members = track_members };

void
qn_project_append_dynamic (GString *json, const QnModel *model,
                           const QnDynamicSettings *usual, GHashTable *inner)
{
  const QnDynamicSettings *s = &model->analysis.dynamic;
  if (s->time_step <= 0)
    return;
  g_string_append (json, ",\n    \"dynamic\": {");
  qn_members_write (json, dynamic_members, NULL, s, usual);
  if (s->mass_damping != 0 || s->joint_damping != 0 || s->of != QN_DAMPING_CURRENT) {
    qn_members_put (json, "damping", damping_members, NULL, s, usual);
    qn_json_append_inner (json, inner, "analysis.dynamic.damping");
  }
  qn_json_append_list (json, model, inner, &qn_ground_list);
  qn_json_append_list (json, model, inner, &qn_initial_list);
  qn_json_append_list (json, model, inner, &qn_track_list);
  g_string_append (json, " }");
  qn_json_append_inner (json, inner, "analysis.dynamic");
}
