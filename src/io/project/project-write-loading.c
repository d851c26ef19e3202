/* Loads, analysis and stages in the canonical layout. */
#include "io/project/project-inner.h"
#include "io/project/project-names.h"
#include "io/project/project-write-parts.h"
#include "io/text/json-text.h"

#include <math.h>

static void
put_edge_load (GString *json, const QnModel *model, const QnLoad *load)
{
  qn_json_put_string (json, "block", model->blocks[load->block].name);
  if (load->has_side)
    qn_json_put_string (json, "side", qn_block_side_names[load->side]);
  else
    qn_json_put_number (json, "edge", load->edge);
  if (!load->has_side)
    qn_json_put_unusual (json, "count", load->edge_count, 1);
  if (load->part[0] != 0 || load->part[1] != 1)
    qn_json_put_vec2 (json, "part", qn_vec2 (load->part[0], load->part[1]));
  if (load->intensity[0] == load->intensity[1])
    qn_json_put_number (json, "intensity", load->intensity[0]);
  else
    qn_json_put_vec2 (json, "intensity",
                      qn_vec2 (load->intensity[0], load->intensity[1]));
  if (!load->normal)
    qn_json_put_vec2 (json, "direction", load->vector);
}

static void
put_surcharge (GString *json, const QnLoad *load)
{
  qn_json_put_number (json, "pressure", load->pressure);
  if (isfinite (load->span[0]))
    qn_json_put_number (json, "from", load->span[0]);
  if (isfinite (load->span[1]))
    qn_json_put_number (json, "to", load->span[1]);
  if (load->unit_weight != 0 || load->level != 0) {
    qn_json_put_number (json, "unit_weight", load->unit_weight);
    qn_json_put_number (json, "level", load->level);
  }
}

static void
put_backfill (GString *json, const QnLoad *load)
{
  qn_json_put_string (json, "side", qn_block_side_names[load->side]);
  qn_json_put_number (json, "top", load->span[1]);
  if (isfinite (load->span[0]))
    qn_json_put_number (json, "bottom", load->span[0]);
  qn_json_put_number (json, "unit_weight", load->unit_weight);
  if (load->earth == QN_EARTH_GIVEN) {
    qn_json_put_number (json, "coefficient", load->coefficient);
  } else {
    qn_json_put_number (json, "friction_angle", load->friction_angle);
    qn_json_put_string (json, "earth", qn_earth_names[load->earth]);
  }
  qn_json_put_unusual (json, "surcharge", load->pressure, 0);
}

static void
append_load (GString *json, const QnModel *model, const QnLoad *load)
{
  g_string_append_c (json, '{');
  qn_json_put_string (json, "kind", qn_load_kind_names[load->kind]);
  if (load->load_case > 0)
    qn_json_put_string (json, "case", model->load_cases[load->load_case - 1].name);
  switch (load->kind) {
  case QN_LOAD_WEIGHT:
    qn_json_put_vec2 (json, "direction", load->vector);
    break;
  case QN_LOAD_FORCE:
    qn_json_put_string (json, "block", model->blocks[load->block].name);
    qn_json_put_vec2 (json, "value", load->vector);
    qn_json_put_unusual (json, "moment", load->moment, 0);
    if (load->has_at)
      qn_json_put_vec2 (json, "at", load->at);
    break;
  case QN_LOAD_SETTLEMENT:
    qn_json_put_string (json, "block", model->blocks[load->block].name);
    qn_json_put_string (json, "component", qn_dof_names[load->dof]);
    qn_json_put_number (json, "value", load->value);
    break;
  case QN_LOAD_LINE:
    qn_json_put_string (json, "beam", model->beams[load->beam].name);
    qn_json_put_vec2 (json, "value", load->vector);
    break;
  case QN_LOAD_NODE:
    qn_json_put_string (json, "node", model->nodes[load->node].name);
    qn_json_put_vec2 (json, "value", load->vector);
    qn_json_put_unusual (json, "moment", load->moment, 0);
    break;
  case QN_LOAD_EDGE:
    put_edge_load (json, model, load);
    break;
  case QN_LOAD_SURCHARGE:
    put_surcharge (json, load);
    break;
  case QN_LOAD_BACKFILL:
    put_backfill (json, load);
    break;
  case QN_LOAD_KIND_COUNT:
    g_assert_not_reached ();
  }
  g_string_append (json, " }");
}

/* The loads of one set; of dead loads that is 0. */
static void
append_load_list (GString *json, const QnModel *model, const char *key,
                  const QnLoad *loads, size_t count, int32_t set, const char *indent,
                  GHashTable *inner)
{
  gboolean any = FALSE;
  g_string_append (json, indent);
  qn_json_append_string (json, key);
  g_string_append (json, ": [");
  for (size_t i = 0; i < count; i++) {
    if (loads[i].set != set)
      continue;
    g_string_append_printf (json, "%s\n%s  ", any ? "," : "", indent);
    append_load (json, model, &loads[i]);
    qn_json_append_note (json, inner, loads[i].note);
    any = TRUE;
  }
  g_string_append (json, any ? " ]" : "]");
}

void
qn_project_append_loads (GString *json, const QnModel *model, GHashTable *inner)
{
  g_string_append (json, "  \"loads\": {\n");
  for (size_t i = 0; i < model->load_case_count; i++) {
    if (i == 0)
      g_string_append (json, "    \"cases\": {");
    qn_json_put_number (json, model->load_cases[i].name, model->load_cases[i].factor);
    if (i + 1 == model->load_case_count)
      g_string_append (json, " },\n");
  }
  append_load_list (json, model, "dead", model->dead_loads, model->dead_load_count, 0,
                    "    ", inner);
  g_string_append (json, ",\n");
  append_load_list (json, model, "live", model->live_loads, model->live_load_count, 0,
                    "    ", inner);
  for (size_t i = 0; i < model->load_set_count; i++) {
    g_string_append (json, i > 0 ? ",\n" : ",\n    \"sets\": {\n");
    append_load_list (json, model, model->load_sets[i], model->live_loads,
                      model->live_load_count, (int32_t) i + 1, "      ", inner);
  }
  g_string_append (json, model->load_set_count > 0 ? " } }" : " }");
}

static void
put_control (GString *json, const QnModel *model, QnId block, QnId node, QnDof dof,
             double target)
{
  if (block == QN_NONE && node == QN_NONE)
    return;
  qn_json_begin_member (json, "control");
  g_string_append_c (json, '{');
  if (node != QN_NONE)
    qn_json_put_string (json, "node", model->nodes[node].name);
  else
    qn_json_put_string (json, "block", model->blocks[block].name);
  qn_json_put_string (json, "component", qn_dof_names[dof]);
  qn_json_put_number (json, "target", target);
  g_string_append (json, " }");
}

static int32_t
append_stage (GString *json, const QnModel *model, size_t index)
{
  const QnStage *stage = &model->stages[index];
  gboolean any = FALSE;
  if (stage->name != NULL)
    qn_json_put_string (json, "name", stage->name);
  qn_json_begin_member (json, "loads");
  for (size_t set = 0; set <= model->load_set_count; set++) {
    if ((stage->sets >> set & 1) == 0)
      continue;
    g_string_append (json, any ? ", " : "[");
    qn_json_append_string (json, qn_model_load_set_name (model, (int32_t) set));
    any = TRUE;
  }
  g_string_append (json, any ? "]" : "[]");
  qn_json_put_string (json, "procedure", qn_procedure_names[stage->procedure]);
  if (stage->has_target)
    qn_json_put_number (json, "target", stage->target);
  qn_json_put_unusual (json, "increments", stage->increments, 0);
  put_control (json, model, stage->control_block, stage->control_node, stage->control_dof,
               stage->control_target);
  return stage->note;
}

/* Values other than the defaults, after three settings that are always written. */
void
qn_project_append_analysis (GString *json, const QnModel *model, GHashTable *inner)
{
  QnModel defaults;
  qn_model_init (&defaults);
  const QnAnalysisSettings *usual = &defaults.analysis, *analysis = &model->analysis;

  g_string_append (json, "  \"analysis\": {");
  qn_json_put_string (json, "procedure", qn_procedure_names[analysis->procedure]);
  qn_json_put_string (json, "geometry", qn_geometry_names[analysis->geometry]);
  qn_json_put_number (json, "increments", analysis->increments);
  if (isfinite (analysis->max_multiplier))
    qn_json_put_number (json, "max_multiplier", analysis->max_multiplier);
  qn_json_put_unusual (json, "multiplier_tolerance", analysis->multiplier_tolerance,
                       usual->multiplier_tolerance);
  qn_json_put_unusual (json, "residual_tolerance", analysis->residual_tolerance,
                       usual->residual_tolerance);
  qn_json_put_unusual (json, "max_factorizations", analysis->max_factorizations,
                       usual->max_factorizations);
  qn_json_put_unusual (json, "max_seconds", analysis->max_seconds, usual->max_seconds);
  if (analysis->bound != usual->bound)
    qn_json_put_string (json, "bound", qn_bound_choice_names[analysis->bound]);
  if (analysis->snap != usual->snap)
    qn_json_put_string (json, "snap", qn_snap_names[analysis->snap]);
  if (analysis->flow != usual->flow)
    qn_json_put_string (json, "flow", qn_flow_names[analysis->flow]);
  if (analysis->follow != usual->follow)
    qn_json_put_string (json, "contacts", analysis->follow ? "follow" : "fixed");
  put_control (json, model, analysis->control_block, analysis->control_node,
               analysis->control_dof, analysis->control_target);
  if (analysis->control_block != QN_NONE || analysis->control_node != QN_NONE)
    qn_json_append_inner (json, inner, "analysis.control");
  qn_json_append_list (json, model, inner, ",\n    \"stages\": [", 6, model->stage_count,
                       append_stage, "]");
  qn_project_append_dynamic (json, model, &usual->dynamic, inner);
  g_string_append (json, " }");
  qn_model_clear (&defaults);
}
