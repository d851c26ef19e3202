/* analysis, with its stages; analysis.dynamic: ground motions, initial motion, tracks and the time integration. */
#include "core/model/cycles.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

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

/* ---- in time: reading ---- */

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
  if (points.json != NULL) {
    QnJsonValue element = { 0 };
    if (!qn_json_value_array (&points))
      return FALSE;
    while (qn_json_value_next (&points, &element)) {
      QnVec2 point;
      if (element.index >= QN_MAX_SIGNAL_POINTS)
        return qn_json_value_fail (&points,
                                   _ (qn_problem_text (QN_PROBLEM_SIGNAL_TOO_LONG)));
      if (!qn_json_value_vec2 (&element, &point))
        return FALSE;
      if (!qn_ground_motion_add_point (motion, point.x, point.y))
        return qn_json_value_no_memory (&element);
    }
    return TRUE;
  }
  motion->kind = pulse.json != NULL ? QN_SIGNAL_PULSE : QN_SIGNAL_RECORD;
  return TRUE;
}

static gboolean
read_dynamic (const QnJsonValue *analysis, QnModel *model)
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

/* ---- in time: writing ---- */

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

/* Written where it is set; `usual` are its defaults. */
static void
append_dynamic (GString *json, const QnModel *model, const QnDynamicSettings *usual,
                GHashTable *inner)
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

static const QnMember control_members[] = {
  QN_ENTITY ("node", OPTIONAL, NODE, QnControl, node),
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnControl, block),
  QN_CHOICE ("component", REQUIRED, qn_dof_names, QnControl, dof),
  QN_NUMBER ("target", REQUIRED, FINITE, QnControl, target),
  { 0 },
};

static const QnMember cycle_control[] = {
  QN_ENTITY ("node", OPTIONAL, NODE, QnControl, node),
  QN_ENTITY ("block", OPTIONAL, BLOCK, QnControl, block),
  QN_CHOICE ("component", REQUIRED, qn_dof_names, QnControl, dof),
  { 0 },
};

static const QnMember stage_members[] = {
  QN_KNOWN ("name"),
  QN_KNOWN ("loads"),
  QN_CHOICE ("procedure", WRITTEN, qn_procedure_names, QnStage, procedure),
  QN_GIVEN ("target", NUMBER, QN_RANGE_FINITE, QnStage, target, has_target),
  QN_COUNT ("increments", OPTIONAL, G_MAXINT32, QnStage, increments),
  QN_KNOWN ("control"),
  QN_KNOWN ("amplitudes"),
  QN_KNOWN ("cycles"),
  { 0 },
};

static const QnMember analysis_members[] = {
  QN_CHOICE ("procedure", WRITTEN, qn_procedure_names, QnAnalysisSettings, procedure),
  QN_CHOICE ("geometry", WRITTEN, qn_geometry_names, QnAnalysisSettings, geometry),
  QN_COUNT ("increments", WRITTEN, G_MAXINT32, QnAnalysisSettings, increments),
  QN_NUMBER ("max_multiplier", OPTIONAL, NOT_NEGATIVE, QnAnalysisSettings,
             max_multiplier),
  QN_NUMBER ("multiplier_tolerance", OPTIONAL, POSITIVE, QnAnalysisSettings,
             multiplier_tolerance),
  QN_NUMBER ("residual_tolerance", OPTIONAL, POSITIVE, QnAnalysisSettings,
             residual_tolerance),
  QN_COUNT ("max_factorizations", OPTIONAL, G_MAXINT32, QnAnalysisSettings,
            max_factorizations),
  QN_NUMBER ("max_seconds", OPTIONAL, POSITIVE, QnAnalysisSettings, max_seconds),
  QN_CHOICE ("bound", OPTIONAL, qn_bound_choice_names, QnAnalysisSettings, bound),
  QN_CHOICE ("snap", OPTIONAL, qn_snap_names, QnAnalysisSettings, snap),
  QN_CHOICE ("flow", OPTIONAL, qn_flow_names, QnAnalysisSettings, flow),
  QN_SWITCH ("contacts", OPTIONAL, qn_follow_names, QnAnalysisSettings, follow),
  QN_KNOWN ("control"),
  QN_KNOWN ("stages"),
  QN_KNOWN ("dynamic"),
  { 0 },
};

/* ---- reading ---- */

/* Of a block or of a node. */
static gboolean
read_control (const QnJsonValue *owner, const QnMember *members, const QnModel *model,
              QnControl *target)
{
  QnJsonValue control = qn_json_value_member (owner, "control");
  if (control.json == NULL)
    return TRUE;
  gboolean node = cJSON_HasObjectItem (control.json, "node");
  const char *name;
  return qn_members_exclude (&control, "block", "node")
         && qn_members_check (&control, members, NULL, NULL)
         && (node || qn_member_string (&control, "block", QN_REQUIRED, &name))
         && qn_members_take (&control, members, model, target);
}

static gboolean
add_set (const QnJsonValue *place, const QnModel *model, QnStage *stage)
{
  if (!cJSON_IsString (place->json))
    return qn_json_value_fail (place, _ ("expected the name of a load set"));
  QnId set;
  if (!qn_read_name_of (place, model, QN_NAMED_LOAD_SET, &set))
    return FALSE;
  if ((stage->sets >> set & 1) != 0)
    return qn_json_value_fail (place, _ ("load set is named twice"));
  stage->sets |= (uint32_t) 1 << set;
  return TRUE;
}

/* The name of a load set, or a list of names. */
static gboolean
read_stage_sets (const QnJsonValue *place, const QnModel *model, QnStage *stage)
{
  QnJsonValue sets = qn_json_value_member (place, "loads");
  if (cJSON_IsString (sets.json))
    return add_set (&sets, model, stage);
  if (!qn_json_value_array (&sets))
    return FALSE;
  QnJsonValue name = { 0 };
  while (qn_json_value_next (&sets, &name)) {
    if (!add_set (&name, model, stage))
      return FALSE;
  }
  return TRUE;
}

/* Makes the last stage, read but for its end, a cyclic protocol. */
static gboolean
read_cycles (const QnJsonValue *place, const QnJsonValue *amplitudes, QnModel *model)
{
  QnJsonValue item = { 0 }, cycles_place = qn_json_value_member (place, "cycles");
  g_autoptr (GArray) values = g_array_new (FALSE, FALSE, sizeof (double));
  int32_t cycles = 1;
  if (!qn_members_exclude (place, "target", "amplitudes")
      || !qn_json_value_array (amplitudes)
      || !qn_member_count (place, "cycles", QN_OPTIONAL, QN_MAX_STAGES, &cycles))
    return FALSE;
  while (qn_json_value_next (amplitudes, &item)) {
    double amplitude;
    if (!qn_json_value_number (&item, QN_RANGE_FINITE, &amplitude))
      return FALSE;
    if (amplitude == 0)
      return qn_json_value_fail (&item, _ ("an amplitude is not 0"));
    g_array_append_val (values, amplitude);
    if ((gint64) values->len * cycles * QN_CYCLE_LEGS > QN_MAX_STAGES)
      return qn_json_value_failf (&cycles_place, _ ("more than %d stages"),
                                  QN_MAX_STAGES);
  }
  if (values->len == 0)
    return qn_json_value_fail (amplitudes, _ ("expected at least one amplitude"));
  return qn_model_set_cycles (model, model->stage_count - 1, (double *) values->data,
                              values->len, (size_t) cycles)
         || qn_json_value_no_memory (place);
}

static gboolean
read_stage (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  QnStage *stage = entity;
  QnJsonValue amplitudes = qn_json_value_member (place, "amplitudes");
  QnJsonValue cycles = qn_json_value_member (place, "cycles");
  gboolean cyclic = amplitudes.json != NULL;
  if (!cyclic && cycles.json != NULL)
    return qn_json_value_fail (&cycles, _ ("needs amplitudes"));
  return read_stage_sets (place, model, stage)
         && read_control (place, cyclic ? cycle_control : control_members, model,
                          &stage->control)
         && (!cyclic || read_cycles (place, &amplitudes, model));
}

gboolean
qn_read_analysis (const QnJsonValue *root, QnModel *model)
{
  QnAnalysisSettings *settings = &model->analysis;
  QnJsonValue place = qn_json_value_member (root, "analysis");
  if (place.json != NULL
      && !(qn_members_read (&place, analysis_members, model, settings)
           && read_control (&place, control_members, model, &settings->control)
           && qn_read_list (&place, &qn_stage_list, QN_OPTIONAL, model)
           && read_dynamic (&place, model)))
    return FALSE;
  /* Load sets that no stage drives. */
  QnJsonValue loads = qn_json_value_member (root, "loads");
  QnJsonValue sets = qn_json_value_member (&loads, "sets");
  uint32_t driven = model->stage_count > 0 ? 0 : 1;
  for (size_t i = 0; i < model->stage_count; i++)
    driven |= model->stages[i].sets;
  for (size_t i = 0; i <= model->load_set_count; i++) {
    const char *name = qn_model_load_set_name (model, (int32_t) i);
    QnJsonValue set = qn_json_value_member (i == 0 ? &loads : &sets, name);
    if ((driven >> i & 1) == 0 && set.json != NULL && set.json->child != NULL)
      qn_json_value_warn (&set, _ (qn_problem_text (QN_PROBLEM_LOAD_SET_UNUSED)));
  }
  /* Settings that a stage has for itself say nothing beside stages. */
  QnJsonValue procedure = qn_json_value_member (&place, "procedure");
  if (model->stage_count > 0 && procedure.json != NULL
      && settings->procedure != QN_PROCEDURE_LOAD
      && settings->procedure != QN_PROCEDURE_LIMIT)
    qn_json_value_warn (&procedure,
                        _ ("has no effect beside stages, which have their own"));
  return TRUE;
}

/* ---- writing ---- */

gsize
qn_project_stage_entry (const QnModel *model, gsize index)
{
  gsize entry = 0;
  for (gsize i = 1; i <= index && i < model->stage_count; i++)
    entry += model->stages[i].leg <= 1;
  return entry;
}

static void
append_stage (GString *json, const QnModel *model, size_t index)
{
  QnStage usual = { 0 };
  gboolean any = FALSE;
  const QnStage *stage = &model->stages[index];
  QnStage shown = *stage;
  shown.has_target = stage->has_target && stage->leg == 0;
  qn_json_begin_member (json, "loads");
  for (size_t set = 0; set <= model->load_set_count; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    g_string_append (json, any ? ", " : "[");
    qn_json_append_string (json, qn_model_load_set_name (model, (int32_t) set));
    any = TRUE;
  }
  g_string_append (json, any ? "]" : "[]");
  qn_members_write (json, stage_members, model, &shown, &usual);
  if (qn_control_is_given (&stage->control))
    qn_members_put (json, "control", stage->leg > 0 ? cycle_control : control_members,
                    model, &stage->control, NULL);
  gsize cycles;
  g_autofree double *amplitudes = g_new (double, qn_stage_span (model, index));
  const gsize count = qn_stage_amplitudes (model, index, amplitudes, &cycles);
  if (count > 0)
    qn_json_put_numbers (json, "amplitudes", amplitudes, count);
  if (cycles > 1) {
    qn_json_begin_member (json, "cycles");
    g_string_append_printf (json, "%zu", cycles);
  }
}

/* The first leg stands for the others of its protocol. */
static bool
is_further_leg (const QnModel *model, size_t index)
{
  return index > 0 && model->stages[index].leg > 1;
}

const QnList qn_stage_list = { QN_LIST ("analysis.stages", QnStage, stages, stage_count),
                               .naming = QN_NAMING_OPTIONAL,
                               .members = stage_members,
                               .read = read_stage,
                               .append = append_stage,
                               .is_left_out = is_further_leg };

/* Values other than the defaults, after three settings that are always written. */
void
qn_project_append_analysis (GString *json, const QnModel *model, GHashTable *inner)
{
  QnModel defaults;
  qn_model_init (&defaults);
  const QnAnalysisSettings *usual = &defaults.analysis, *analysis = &model->analysis;

  g_string_append (json, "  \"analysis\": {");
  qn_members_write (json, analysis_members, model, analysis, usual);
  if (qn_control_is_given (&analysis->control)) {
    qn_members_put (json, "control", control_members, model, &analysis->control, NULL);
    qn_json_append_inner (json, inner, "analysis.control");
  }
  qn_json_append_list (json, model, inner, &qn_stage_list);
  append_dynamic (json, model, &usual->dynamic, inner);
  g_string_append (json, " }");
  qn_model_clear (&defaults);
}
