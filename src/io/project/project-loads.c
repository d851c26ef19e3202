/* The loads: constant, growing, and of sets with names. */
#include "core/base/integer.h"
#include "io/project/combinations.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/project/project-vehicle.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Every load has these, which are read and written first. */
#define COMMON QN_KNOWN ("kind"), QN_KNOWN ("case")

static const QnMember weight_members[] = {
  COMMON,
  QN_TWO ("direction", REQUIRED, QnLoad, vector),
  { 0 },
};

static const QnMember force_members[] = {
  COMMON,
  QN_ENTITY ("block", REQUIRED, BLOCK, QnLoad, block),
  QN_TWO ("value", REQUIRED, QnLoad, vector),
  QN_NUMBER ("moment", OPTIONAL, FINITE, QnLoad, moment),
  QN_GIVEN ("at", NUMBERS, 2, QnLoad, at, has_at),
  { 0 },
};

static const QnMember node_members[] = {
  COMMON,
  QN_ENTITY ("node", REQUIRED, NODE, QnLoad, node),
  QN_TWO ("value", REQUIRED, QnLoad, vector),
  QN_NUMBER ("moment", OPTIONAL, FINITE, QnLoad, moment),
  { 0 },
};

static const QnMember settlement_members[] = {
  COMMON,
  QN_ENTITY ("block", REQUIRED, BLOCK, QnLoad, block),
  QN_CHOICE ("component", REQUIRED, qn_dof_names, QnLoad, dof),
  QN_NUMBER ("value", REQUIRED, FINITE, QnLoad, value),
  { 0 },
};

static const QnMember line_members[] = {
  COMMON,
  QN_ENTITY ("beam", REQUIRED, BEAM, QnLoad, beam),
  QN_TWO ("value", REQUIRED, QnLoad, vector),
  { 0 },
};

static const QnMember edge_members[] = {
  COMMON,
  QN_ENTITY ("block", REQUIRED, BLOCK, QnLoad, block),
  QN_KNOWN ("side"),
  QN_KNOWN ("edge"),
  QN_KNOWN ("count"),
  QN_TWO ("part", READ, QnLoad, part),
  QN_KNOWN ("intensity"),
  QN_TWO ("direction", READ, QnLoad, vector),
  { 0 },
};

static const QnMember surcharge_members[] = {
  COMMON,
  QN_NUMBER ("pressure", WRITTEN, NOT_NEGATIVE, QnLoad, pressure),
  QN_NUMBER ("from", OPTIONAL, FINITE, QnLoad, span[0]),
  QN_NUMBER ("to", OPTIONAL, FINITE, QnLoad, span[1]),
  QN_NUMBER ("unit_weight", READ, NOT_NEGATIVE, QnLoad, unit_weight),
  QN_NUMBER ("level", READ, FINITE, QnLoad, level),
  { 0 },
};

static const QnMember backfill_members[] = {
  COMMON,
  QN_MEMBER ("side", CHOICE, REQUIRED, QnLoad, side, QN_BLOCK_SIDE_BOTTOM,
             qn_block_side_names), /* left or right */
  QN_NUMBER ("top", REQUIRED, FINITE, QnLoad, span[1]),
  QN_NUMBER ("bottom", OPTIONAL, FINITE, QnLoad, span[0]),
  QN_NUMBER ("unit_weight", REQUIRED, NOT_NEGATIVE, QnLoad, unit_weight),
  QN_KNOWN ("coefficient"),
  QN_KNOWN ("friction_angle"),
  QN_KNOWN ("earth"),
  QN_NUMBER ("surcharge", READ, NOT_NEGATIVE, QnLoad, pressure),
  { 0 },
};

static const QnMember fill_members[] = {
  COMMON,
  QN_ROWS ("surface", REQUIRED, QN_MAX_SURFACE_POINTS, 2, QnLoad, surface, surface_count),
  QN_NUMBER ("unit_weight", REQUIRED, NOT_NEGATIVE, QnLoad, unit_weight),
  QN_NUMBER ("friction_angle", OPTIONAL, NOT_NEGATIVE, QnLoad, friction_angle),
  QN_NUMBER ("mobilisation", OPTIONAL, NOT_NEGATIVE, QnLoad, mobilisation),
  QN_NUMBER ("stiffness", OPTIONAL, POSITIVE, QnLoad, stiffness),
  QN_NUMBER ("bottom", OPTIONAL, FINITE, QnLoad, span[0]),
  { 0 },
};

static const QnMember vehicle_load_members[] = {
  COMMON,
  QN_KNOWN ("vehicle"),
  QN_NUMBER ("position", REQUIRED, FINITE, QnLoad, position),
  QN_BOOL ("reversed", OPTIONAL, QnLoad, reversed),
  QN_COUNT ("convoy", OPTIONAL, QN_MAX_CONVOY, QnLoad, convoy),
  QN_NUMBER ("headway", OPTIONAL, NOT_NEGATIVE, QnLoad, headway),
  QN_CHOICE ("dispersal", WRITTEN, qn_dispersal_names, QnLoad, dispersal),
  QN_NUMBER ("width", OPTIONAL, NOT_NEGATIVE, QnLoad, width),
  QN_NUMBER ("effective_width", OPTIONAL, NOT_NEGATIVE, QnLoad, effective),
  { 0 },
};

static const QnMember *const load_members[QN_LOAD_KIND_COUNT] = {
  [QN_LOAD_WEIGHT] = weight_members,
  [QN_LOAD_FORCE] = force_members,
  [QN_LOAD_SETTLEMENT] = settlement_members,
  [QN_LOAD_LINE] = line_members,
  [QN_LOAD_EDGE] = edge_members,
  [QN_LOAD_SURCHARGE] = surcharge_members,
  [QN_LOAD_BACKFILL] = backfill_members,
  [QN_LOAD_FILL] = fill_members,
  [QN_LOAD_VEHICLE] = vehicle_load_members,
  [QN_LOAD_NODE] = node_members,
};

/* ---- reading ---- */

/* One number for both ends, or a number for each. */
static gboolean
read_intensity (const QnJsonValue *place, double intensity[2])
{
  QnJsonValue value = qn_json_value_member (place, "intensity");
  QnVec2 ends;
  if (!cJSON_IsArray (value.json)) {
    gboolean read =
      qn_member_number (place, "intensity", QN_REQUIRED, QN_RANGE_FINITE, &intensity[0]);
    intensity[1] = intensity[0];
    return read;
  }
  if (!qn_json_value_vec2 (&value, &ends))
    return FALSE;
  intensity[0] = ends.x;
  intensity[1] = ends.y;
  return TRUE;
}

/* Which edges of the block: those of a side, or a number of them from one on, counted from 0. */
static gboolean
read_chain (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  const QnJsonValue edge = qn_json_value_member (place, "edge");
  const QnJsonValue count = qn_json_value_member (place, "count");
  const double edges = model->blocks[load->block].vertex_count;
  double number;
  load->has_side = cJSON_HasObjectItem (place->json, "side");
  if (load->has_side) {
    if (edge.json != NULL || count.json != NULL)
      return qn_json_value_fail (edge.json != NULL ? &edge : &count,
                                 _ ("side excludes edge and count"));
    return qn_member_choice (place, "side", QN_REQUIRED, qn_block_side_names,
                             QN_BLOCK_SIDE_COUNT, &load->side);
  }
  if (!qn_member_number (place, "edge", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE, &number)
      || !qn_member_count (place, "count", QN_OPTIONAL, INT32_MAX, &load->edge_count))
    return FALSE;
  if (number != floor (number) || number >= edges)
    return qn_json_value_failf (&edge, _ ("block “%s” has edges 0 to %.0f"),
                                model->blocks[load->block].name, edges - 1);
  if (load->edge_count > edges)
    return qn_json_value_failf (&count, _ ("block “%s” has %.0f edges"),
                                model->blocks[load->block].name, edges);
  load->edge = (QnId) qn_to_integer (number, 0, INT32_MAX);
  return TRUE;
}

/* With the weight of fill a surcharge needs a level, without it a pressure. */
static gboolean
read_surcharge (const QnJsonValue *place)
{
  double number;
  return qn_member_number (
    place, cJSON_HasObjectItem (place->json, "unit_weight") ? "level" : "pressure",
    QN_REQUIRED, QN_RANGE_FINITE, &number);
}

/* K as a number, or from the friction angle of the soil. */
static gboolean
read_earth (const QnJsonValue *place, QnLoad *load)
{
  const gboolean angle = cJSON_HasObjectItem (place->json, "friction_angle");
  if (!angle)
    return qn_member_number (place, "coefficient", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE,
                             &load->coefficient);
  load->earth = QN_EARTH_ACTIVE;
  if (!qn_members_exclude (place, "coefficient", "friction_angle")
      || !qn_member_choice (place, "earth", QN_OPTIONAL, qn_earth_names, QN_EARTH_COUNT,
                            &load->earth))
    return FALSE;
  if (load->earth == QN_EARTH_GIVEN) {
    QnJsonValue member = qn_json_value_member (place, "earth");
    return qn_json_value_fail (&member, _ ("a given coefficient has no friction angle"));
  }
  return qn_member_number (place, "friction_angle", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE,
                           &load->friction_angle);
}

static gboolean
read_vehicle_name (const QnJsonValue *place, QnModel *model, QnLoad *load)
{
  const char *name;
  QnJsonValue member = qn_json_value_member (place, "vehicle");
  if (!qn_member_string (place, "vehicle", QN_REQUIRED, &name))
    return FALSE;
  load->vehicle = qn_model_take_vehicle (model, name);
  return load->vehicle != QN_NONE
         || qn_json_value_failf (&member, "%s: \"%s\"",
                                 _ (qn_problem_text (QN_PROBLEM_VEHICLE_UNKNOWN)), name);
}

static gboolean
read_load (const QnJsonValue *place, QnModel *model, QnLoad *load)
{
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_load_kind_names, QN_LOAD_NODE,
                            &load->kind)
      || !qn_read_name (place, "case", QN_OPTIONAL, model, QN_NAMED_LOAD_CASE,
                        &load->load_case))
    return FALSE;
  if (load->kind == QN_LOAD_FORCE && cJSON_HasObjectItem (place->json, "node")) {
    if (!qn_members_exclude (place, "block", "node"))
      return FALSE;
    load->kind = QN_LOAD_NODE;
  }
  load->normal =
    load->kind == QN_LOAD_EDGE && !cJSON_HasObjectItem (place->json, "direction");
  return qn_members_read (place, load_members[load->kind], model, load)
         && (load->kind != QN_LOAD_EDGE
             || (read_chain (place, model, load)
                 && read_intensity (place, load->intensity)))
         && (load->kind != QN_LOAD_SURCHARGE || read_surcharge (place))
         && (load->kind != QN_LOAD_BACKFILL || read_earth (place, load))
         && (load->kind != QN_LOAD_VEHICLE || read_vehicle_name (place, model, load));
}

static gboolean
read_load_list (const QnJsonValue *loads, const char *key, int32_t set, bool live,
                QnModel *model)
{
  QnJsonValue list, place = { 0 };
  if (!qn_member_array (loads, key, QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &place)) {
    QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
    if (load == NULL)
      return qn_json_value_no_memory (&place);
    load->set = set;
    if (!read_load (&place, model, load))
      return FALSE;
    load->note = qn_read_note (&place);
    /* In every combination of the code as it is, which the own weight by EN 1990 is not. */
    if (*model->combinations.code != '\0' && load->kind != QN_LOAD_SETTLEMENT
        && (load->load_case == 0
            || *model->load_cases[load->load_case - 1].action == '\0'))
      qn_json_value_warn (&place, _ ("has no case with an action: no combination of the "
                                     "code changes its factor"));
  }
  return TRUE;
}

/* Sets of loads with names of their own, for stages. */
static gboolean
read_load_sets (const QnJsonValue *loads, QnModel *model)
{
  QnJsonValue sets = qn_json_value_member (loads, "sets");
  if (sets.json == NULL)
    return TRUE;
  if (!qn_json_value_object (&sets))
    return FALSE;
  for (const cJSON *item = sets.json->child; item != NULL; item = item->next) {
    QnJsonValue list = qn_json_value_member (&sets, item->string);
    if (strcmp (item->string, "live") == 0 || strcmp (item->string, "dead") == 0)
      return qn_json_value_fail (&list, _ (qn_problem_text (QN_PROBLEM_NAME_TAKEN)));
    if (model->load_set_count + 1 >= QN_MAX_LOAD_SETS)
      return qn_json_value_failf (
        &list, _ ("there may be at most %d load sets with names"), QN_MAX_LOAD_SETS - 1);
    int32_t set = qn_model_add_load_set (model, item->string);
    if (set == QN_NONE)
      return qn_json_value_no_memory (&list);
    if (!read_load_list (&sets, item->string, set, true, model))
      return FALSE;
  }
  return TRUE;
}

/* One of some names, into an array of QN_ACTION_SIZE. */
static gboolean
read_choice (const QnJsonValue *object, const char *key, char **names, char *target)
{
  const char *name = NULL;
  QnJsonValue place = qn_json_value_member (object, key);
  g_auto (GStrv) known = names;
  if (!qn_member_string (object, key, QN_OPTIONAL, &name))
    return FALSE;
  if (name != NULL && !g_strv_contains ((const char *const *) known, name)) {
    g_autofree char *all = g_strjoinv (", ", known);
    return qn_json_value_failf (&place, _ ("is none of %s"), all);
  }
  g_strlcpy (target, name != NULL ? name : "", QN_ACTION_SIZE);
  return TRUE;
}

/* A factor, or an object with a factor and an action. */
static gboolean
read_load_case (const QnJsonValue *place, QnLoadCase *target)
{
  static const QnMember members[] = {
    QN_NUMBER ("factor", OPTIONAL, NOT_NEGATIVE, QnLoadCase, factor),
    QN_KNOWN ("action"),
    { 0 },
  };
  if (!cJSON_IsObject (place->json))
    return qn_json_value_number (place, QN_RANGE_NOT_NEGATIVE, &target->factor);
  return qn_members_read (place, members, NULL, target)
         && read_choice (place, "action", qn_combinations_dup_actions (), target->action);
}

static const QnMember combination_members[] = {
  QN_KNOWN ("code"),
  QN_NUMBER ("friction", OPTIONAL, POSITIVE, QnCombinationRules, friction),
  QN_NUMBER ("strength", OPTIONAL, POSITIVE, QnCombinationRules, strength),
  QN_NUMBER ("seismic_friction", OPTIONAL, POSITIVE, QnCombinationRules,
             seismic_friction),
  QN_NUMBER ("seismic_strength", OPTIONAL, POSITIVE, QnCombinationRules,
             seismic_strength),
  { 0 },
};

static gboolean
read_combinations (const QnJsonValue *loads, QnCombinationRules *rules)
{
  QnJsonValue place = qn_json_value_member (loads, "combinations");
  return place.json == NULL
         || (qn_members_read (&place, combination_members, NULL, rules)
             && read_choice (&place, "code", qn_combinations_dup_codes (), rules->code));
}

/* Factors by the names of the cases. */
static gboolean
read_load_cases (const QnJsonValue *loads, QnModel *model)
{
  QnJsonValue cases = qn_json_value_member (loads, "cases");
  if (cases.json == NULL)
    return TRUE;
  if (!qn_json_value_object (&cases))
    return FALSE;
  for (const cJSON *item = cases.json->child; item != NULL; item = item->next) {
    QnJsonValue place = qn_json_value_child (&cases, item);
    if (model->load_case_count >= QN_MAX_LOAD_CASES)
      return qn_json_value_failf (&place, _ ("there may be at most %d load cases"),
                                  QN_MAX_LOAD_CASES);
    int32_t added = qn_model_add_load_case (model, item->string);
    if (added == QN_NONE)
      return qn_json_value_no_memory (&place);
    if (!read_load_case (&place, &model->load_cases[added - 1]))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_read_loads (const QnJsonValue *root, QnModel *model)
{
  static const char *const keys[] = { "cases", "combinations", "dead", "live", "sets" };
  QnJsonValue loads = qn_json_value_member (root, "loads");
  if (loads.json == NULL)
    return TRUE;
  return qn_json_value_object (&loads)
         && qn_json_value_check_keys (&loads, keys, G_N_ELEMENTS (keys))
         && read_load_cases (&loads, model)
         && read_combinations (&loads, &model->combinations)
         && read_load_list (&loads, "dead", 0, false, model)
         && read_load_list (&loads, "live", 0, true, model)
         && read_load_sets (&loads, model);
}

/* ---- writing ---- */

static void
append_load (GString *json, const QnModel *model, const QnLoad *load)
{
  const QnLoad usual = { .span = { -INFINITY, INFINITY },
                         .stiffness = QN_USUAL_SOIL_STIFFNESS,
                         .convoy = 1 };
  g_string_append_c (json, '{');
  qn_json_put_string (json, "kind", qn_load_kind_names[load->kind]);
  if (load->load_case > 0)
    qn_json_put_string (json, "case", model->load_cases[load->load_case - 1].name);
  if (load->kind == QN_LOAD_VEHICLE)
    qn_json_put_string (json, "vehicle", model->vehicles[load->vehicle].name);
  qn_members_write (json, load_members[load->kind], model, load, &usual);
  if (load->kind == QN_LOAD_EDGE) {
    if (load->has_side) {
      qn_json_put_string (json, "side", qn_block_side_names[load->side]);
    } else {
      qn_json_put_number (json, "edge", load->edge);
      qn_json_put_unusual (json, "count", load->edge_count, 1);
    }
    if (load->part[0] != 0 || load->part[1] != 1)
      qn_json_put_numbers (json, "part", load->part, 2);
    if (load->intensity[0] == load->intensity[1])
      qn_json_put_number (json, "intensity", load->intensity[0]);
    else
      qn_json_put_numbers (json, "intensity", load->intensity, 2);
    if (!load->normal)
      qn_json_put_vec2 (json, "direction", load->vector);
  }
  if (load->kind == QN_LOAD_SURCHARGE && (load->unit_weight != 0 || load->level != 0)) {
    qn_json_put_number (json, "unit_weight", load->unit_weight);
    qn_json_put_number (json, "level", load->level);
  }
  if (load->kind == QN_LOAD_BACKFILL && load->earth == QN_EARTH_GIVEN)
    qn_json_put_number (json, "coefficient", load->coefficient);
  if (load->kind == QN_LOAD_BACKFILL && load->earth != QN_EARTH_GIVEN) {
    qn_json_put_number (json, "friction_angle", load->friction_angle);
    qn_json_put_string (json, "earth", qn_earth_names[load->earth]);
  }
  if (load->kind == QN_LOAD_BACKFILL)
    qn_json_put_unusual (json, "surcharge", load->pressure, 0);
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

static void
append_load_case (GString *json, const QnLoadCase *load_case)
{
  if (*load_case->action == '\0') {
    qn_json_put_number (json, load_case->name, load_case->factor);
    return;
  }
  qn_json_begin_member (json, load_case->name);
  g_string_append_c (json, '{');
  qn_json_put_unusual (json, "factor", load_case->factor, 1);
  qn_json_put_string (json, "action", load_case->action);
  g_string_append (json, " }");
}

static void
append_combinations (GString *json, const QnCombinationRules *rules)
{
  const QnCombinationRules usual = { "", 1, 1, 1, 1 };
  if (memcmp (rules, &usual, sizeof usual) == 0)
    return;
  g_string_append (json, "    \"combinations\": {");
  if (*rules->code != '\0')
    qn_json_put_string (json, "code", rules->code);
  qn_members_write (json, combination_members, NULL, rules, &usual);
  g_string_append (json, " },\n");
}

void
qn_project_append_loads (GString *json, const QnModel *model, GHashTable *inner)
{
  g_string_append (json, "  \"loads\": {\n");
  for (size_t i = 0; i < model->load_case_count; i++) {
    if (i == 0)
      g_string_append (json, "    \"cases\": {");
    append_load_case (json, &model->load_cases[i]);
    if (i + 1 == model->load_case_count)
      g_string_append (json, " },\n");
  }
  append_combinations (json, &model->combinations);
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
