/* analysis.dynamic in the canonical layout. */
#include "io/project/project-inner.h"
#include "io/project/project-names.h"
#include "io/project/project-write-parts.h"
#include "io/text/json-text.h"

static void
put_triple (GString *json, const char *key, const double triple[QN_DOF_COUNT])
{
  if (triple[0] == 0 && triple[1] == 0 && triple[2] == 0)
    return;
  qn_json_put_numbers (json, key, triple, QN_DOF_COUNT);
}

static int32_t
append_ground (GString *json, const QnModel *model, size_t index)
{
  const QnGroundMotion *motion = &model->ground[index];
  qn_json_put_vec2 (json, "direction", motion->direction);
  qn_json_put_unusual (json, "scale", motion->scale, 1);
  switch (motion->kind) {
  case QN_SIGNAL_RECORD:
    qn_json_put_string (json, "record", motion->record);
    if (motion->unit != NULL)
      qn_json_put_string (json, "unit", motion->unit);
    qn_json_put_unusual (json, "time_step", motion->time_step, 0);
    if (motion->rests)
      qn_json_put_bool (json, "rest", true);
    break;
  case QN_SIGNAL_POINTS:
    qn_json_put_points (json, "points", motion->points, motion->point_count);
    break;
  case QN_SIGNAL_PULSE:
    qn_json_begin_member (json, "pulse");
    g_string_append_c (json, '{');
    qn_json_put_string (json, "kind", qn_pulse_kind_names[motion->pulse.kind]);
    qn_json_put_number (json, "amplitude", motion->pulse.amplitude);
    qn_json_put_number (json, "duration", motion->pulse.duration);
    qn_json_put_unusual (json, "start", motion->pulse.start, 0);
    g_string_append (json, " }");
    break;
  }
  qn_json_put_unusual (json, "peak", motion->peak, 0);
  return motion->note;
}

static void
put_damping (GString *json, const QnDynamicSettings *s, GHashTable *inner)
{
  if (s->mass_damping == 0 && s->joint_damping == 0 && s->of == QN_DAMPING_CURRENT)
    return;
  qn_json_begin_member (json, "damping");
  g_string_append_c (json, '{');
  qn_json_put_number (json, "mass", s->mass_damping);
  qn_json_put_number (json, "stiffness", s->joint_damping);
  qn_json_put_string (json, "of", qn_damping_stiffness_names[s->of]);
  g_string_append (json, " }");
  qn_json_append_inner (json, inner, "analysis.dynamic.damping");
}

static int32_t
append_initial (GString *json, const QnModel *model, size_t index)
{
  const QnInitialMotion *motion = &model->initial[index];
  qn_json_put_string (json, "block", model->blocks[motion->block].name);
  put_triple (json, "displacement", motion->displacement);
  put_triple (json, "velocity", motion->velocity);
  return motion->note;
}

static int32_t
append_track (GString *json, const QnModel *model, size_t index)
{
  const QnTrack *track = &model->tracks[index];
  qn_json_put_string (json, "block", model->blocks[track->block].name);
  qn_json_put_string (json, "component", qn_dof_names[track->dof]);
  return track->note;
}

void
qn_project_append_dynamic (GString *json, const QnModel *model,
                           const QnDynamicSettings *usual, GHashTable *inner)
{
  const QnDynamicSettings *s = &model->analysis.dynamic;
  if (s->duration <= 0)
    return;
  g_string_append (json, ",\n    \"dynamic\": {");
  qn_json_put_number (json, "duration", s->duration);
  qn_json_put_number (json, "time_step", s->time_step);
  qn_json_put_number (json, "rho", s->rho);
  qn_json_put_unusual (json, "tolerance", s->tolerance, usual->tolerance);
  if (!s->adaptive)
    qn_json_put_bool (json, "adaptive", false);
  if (s->follow != usual->follow)
    qn_json_put_string (json, "contacts", s->follow ? "follow" : "fixed");
  if (s->fall)
    qn_json_put_bool (json, "fall", true);
  qn_json_put_unusual (json, "output_interval", s->output_interval, 0);
  put_damping (json, s, inner);
  qn_json_append_list (json, model, inner, ",\n      \"ground\": [", 8,
                       model->ground_count, append_ground, "]");
  qn_json_append_list (json, model, inner, ",\n      \"initial\": [", 8,
                       model->initial_count, append_initial, "]");
  qn_json_append_list (json, model, inner, ",\n      \"track\": [", 8, model->track_count,
                       append_track, "]");
  g_string_append (json, " }");
  qn_json_append_inner (json, inner, "analysis.dynamic");
}
