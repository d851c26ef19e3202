#include "io/project/project-names.h"
#include "io/project/project-read-parts.h"

#include <glib/gi18n-lib.h>

typedef struct Control {
  QnId block, node;
  QnDof dof;
  double target;
} Control;

static gboolean
read_controlled (const QnJsonValue *control, const QnModel *model, Control *read)
{
  if (!cJSON_HasObjectItem (control->json, "node"))
    return qn_read_name (control, "block", QN_REQUIRED, model, QN_NAMED_BLOCK,
                         &read->block);
  if (cJSON_HasObjectItem (control->json, "block")) {
    QnJsonValue block = qn_json_value_member (control, "block");
    return qn_json_value_fail (&block, _ ("block and node exclude each other"));
  }
  return qn_read_name (control, "node", QN_REQUIRED, model, QN_NAMED_NODE, &read->node);
}

static gboolean
read_control (const QnJsonValue *owner, const QnModel *model, Control *read)
{
  static const char *const keys[] = { "block", "node", "component", "target" };
  QnJsonValue control = qn_json_value_member (owner, "control");
  if (control.json == NULL)
    return TRUE;
  if (!qn_json_value_object (&control) || !read_controlled (&control, model, read)
      || !qn_member_choice (&control, "component", QN_REQUIRED, qn_dof_names,
                            QN_DOF_COUNT, &read->dof)
      || !qn_member_number (&control, "target", QN_REQUIRED, QN_RANGE_FINITE,
                            &read->target))
    return FALSE;
  qn_json_value_warn_unknown (&control, keys, G_N_ELEMENTS (keys));
  return TRUE;
}

static gboolean
read_choices (const QnJsonValue *place, QnAnalysisSettings *settings)
{
  return qn_member_follows (place, &settings->follow)
         && qn_member_choice (place, "procedure", QN_OPTIONAL, qn_procedure_names,
                              QN_PROCEDURE_COUNT, &settings->procedure)
         && qn_member_choice (place, "geometry", QN_OPTIONAL, qn_geometry_names,
                              QN_GEOMETRY_COUNT, &settings->geometry)
         && qn_member_choice (place, "snap", QN_OPTIONAL, qn_snap_names,
                              QN_SNAP_THROUGH_COUNT, &settings->snap)
         && qn_member_choice (place, "flow", QN_OPTIONAL, qn_flow_names, QN_FLOW_COUNT,
                              &settings->flow)
         && qn_member_choice (place, "bound", QN_OPTIONAL, qn_bound_choice_names,
                              QN_BOUND_CHOICE_COUNT, &settings->bound);
}

static gboolean
add_set (const QnJsonValue *place, const QnModel *model, QnStage *stage)
{
  if (!cJSON_IsString (place->json))
    return qn_json_value_fail (place, _ ("expected the name of a load set"));
  int32_t set = qn_model_find_load_set (model, place->json->valuestring);
  if (set == QN_NONE)
    return qn_json_value_fail (place, _ (qn_problem_text (QN_PROBLEM_LOAD_SET_UNKNOWN)));
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

static gboolean
read_stage (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "name",   "loads",      "procedure",
                                      "target", "increments", "control" };
  const char *name = NULL;
  Control control = { .block = QN_NONE, .node = QN_NONE };
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "name", QN_OPTIONAL, &name))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));

  QnStage *stage = qn_model_add_stage (model, name);
  if (stage == NULL)
    return qn_json_value_no_memory (place);
  stage->has_target = cJSON_HasObjectItem (place->json, "target");
  if (!read_stage_sets (place, model, stage)
      || !qn_member_choice (place, "procedure", QN_OPTIONAL, qn_procedure_names,
                            QN_PROCEDURE_COUNT, &stage->procedure)
      || !qn_member_number (place, "target", QN_OPTIONAL, QN_RANGE_FINITE, &stage->target)
      || !qn_member_count (place, "increments", QN_OPTIONAL, G_MAXINT32,
                           &stage->increments)
      || !read_control (place, model, &control))
    return FALSE;
  stage->control_block = control.block;
  stage->control_node = control.node;
  stage->control_dof = control.dof;
  stage->control_target = control.target;
  return TRUE;
}

/* Warns of load sets that no stage drives. */
static void
warn_of_idle_sets (const QnJsonValue *root, const QnModel *model)
{
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
}

gboolean
qn_read_analysis (const QnJsonValue *root, QnModel *model)
{
  static const char *const keys[] = { "procedure",
                                      "geometry",
                                      "increments",
                                      "max_multiplier",
                                      "snap",
                                      "flow",
                                      "multiplier_tolerance",
                                      "residual_tolerance",
                                      "max_factorizations",
                                      "max_seconds",
                                      "bound",
                                      "contacts",
                                      "control",
                                      "stages",
                                      "dynamic" };
  const QnRange positive = QN_RANGE_POSITIVE;
  QnAnalysisSettings *settings = &model->analysis;
  QnJsonValue place = qn_json_value_member (root, "analysis");
  if (place.json == NULL) {
    warn_of_idle_sets (root, model);
    return TRUE;
  }
  if (!qn_json_value_object (&place))
    return FALSE;
  qn_json_value_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  Control control = { .block = QN_NONE, .node = QN_NONE };
  if (!read_choices (&place, settings)
      || !qn_member_count (&place, "increments", QN_OPTIONAL, G_MAXINT32,
                           &settings->increments)
      || !qn_member_number (&place, "max_multiplier", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &settings->max_multiplier)
      || !qn_member_number (&place, "multiplier_tolerance", QN_OPTIONAL, positive,
                            &settings->multiplier_tolerance)
      || !qn_member_number (&place, "residual_tolerance", QN_OPTIONAL, positive,
                            &settings->residual_tolerance)
      || !qn_member_count (&place, "max_factorizations", QN_OPTIONAL, G_MAXINT32,
                           &settings->max_factorizations)
      || !qn_member_number (&place, "max_seconds", QN_OPTIONAL, positive,
                            &settings->max_seconds)
      || !read_control (&place, model, &control)
      || !qn_read_each (&place, "stages", QN_OPTIONAL, read_stage, model)
      || !qn_read_dynamic (&place, model))
    return FALSE;
  settings->control_block = control.block;
  settings->control_node = control.node;
  settings->control_dof = control.dof;
  settings->control_target = control.target;
  warn_of_idle_sets (root, model);
  /* Settings that a stage has for itself say nothing beside stages. */
  QnJsonValue procedure = qn_json_value_member (&place, "procedure");
  if (model->stage_count > 0 && procedure.json != NULL
      && model->analysis.procedure != QN_PROCEDURE_LOAD
      && model->analysis.procedure != QN_PROCEDURE_LIMIT)
    qn_json_value_warn (&procedure,
                        _ ("has no effect beside stages, which have their own"));
  return TRUE;
}
