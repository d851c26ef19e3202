#include "core/base/integer.h"
#include "io/project/project-names.h"
#include "io/project/project-read-parts.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* Numbers of a member that is an array of at most QN_MAX_EXPLICIT_PAIRS. */
static gboolean
read_numbers (const QnJsonValue *object, const char *key, double *numbers, int32_t *count)
{
  QnJsonValue list, number = { 0 };
  if (!qn_member_array (object, key, QN_REQUIRED, &list))
    return FALSE;
  if (cJSON_GetArraySize (list.json) > QN_MAX_EXPLICIT_PAIRS)
    return qn_json_value_fail (&list, _ (qn_problem_text (QN_PROBLEM_TOO_LARGE)));
  *count = 0;
  while (qn_json_value_next (&list, &number)) {
    if (!qn_json_value_number (&number, QN_RANGE_NOT_NEGATIVE, &numbers[*count]))
      return FALSE;
    ++*count;
  }
  return TRUE;
}

/* Positions, and weights that are equal where none are given. */
static gboolean
read_explicit_pairs (const QnJsonValue *place, QnPairRule *rule)
{
  int32_t weights;
  if (!read_numbers (place, "positions", rule->positions, &rule->count))
    return FALSE;
  for (int32_t i = 0; i < rule->count; i++)
    rule->weights[i] = 1.0 / rule->count;
  if (!cJSON_HasObjectItem (place->json, "weights"))
    return TRUE;
  if (!read_numbers (place, "weights", rule->weights, &weights))
    return FALSE;
  QnJsonValue member = qn_json_value_member (place, "weights");
  return weights == rule->count
         || qn_json_value_fail (&member,
                                _ ("there must be as many weights as positions"));
}

static gboolean
read_pair_rule (const QnJsonValue *object, QnPairRule *rule)
{
  /* Which placements a key is for. */
  static const struct {
    const char *key;
    guint placements;
  } uses[] = {
    { "offset", 1 << QN_PLACEMENT_ENDS },
    { "count", 1 << QN_PLACEMENT_UNIFORM | 1 << QN_PLACEMENT_GAUSS },
    { "positions", 1 << QN_PLACEMENT_EXPLICIT },
    { "weights", 1 << QN_PLACEMENT_EXPLICIT },
  };
  static const char *const keys[] = { "placement", "offset", "count", "positions",
                                      "weights" };
  QnJsonValue place = qn_json_value_member (object, "pairs");
  if (!qn_json_value_object (&place)
      || !qn_member_choice (&place, "placement", QN_OPTIONAL, qn_placement_names,
                            QN_PLACEMENT_COUNT, &rule->placement))
    return FALSE;
  qn_json_value_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  for (gsize i = 0; i < G_N_ELEMENTS (uses); i++) {
    QnJsonValue idle = qn_json_value_member (&place, uses[i].key);
    if (idle.json != NULL && (uses[i].placements & 1u << rule->placement) == 0)
      qn_json_value_warn (&idle, _ ("has no effect with this placement"));
  }
  if (rule->placement == QN_PLACEMENT_EXPLICIT)
    return read_explicit_pairs (&place, rule);
  if (rule->placement != QN_PLACEMENT_ENDS)
    return qn_member_count (&place, "count", QN_REQUIRED, QN_MAX_PAIRS_PER_FACE,
                            &rule->count);
  return qn_member_number (&place, "offset", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                           &rule->offset);
}

static gboolean
read_face_blocks (const QnJsonValue *face, const QnModel *model, QnId blocks[2])
{
  QnJsonValue names, name = { 0 };
  if (!qn_member_array (face, "blocks", QN_REQUIRED, &names))
    return FALSE;
  if (cJSON_GetArraySize (names.json) != 2)
    return qn_json_value_fail (&names, _ ("expected the names of two blocks"));
  while (qn_json_value_next (&names, &name)) {
    if (!cJSON_IsString (name.json))
      return qn_json_value_fail (&name, _ ("expected the name of a block"));
    blocks[name.index] = qn_model_find_block (model, name.json->valuestring);
    if (blocks[name.index] == QN_NONE)
      return qn_json_value_fail (&name, _ (qn_problem_text (QN_PROBLEM_BLOCK_UNKNOWN)));
  }
  return TRUE;
}

static gboolean
read_face (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "blocks", "law", "pairs" };
  if (!qn_json_value_object (place))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));

  QnId blocks[2], law = QN_NONE;
  QnPairRule pairs = { .placement = QN_PLACEMENT_ENDS, .count = 2 };
  bool has_pairs = cJSON_HasObjectItem (place->json, "pairs");
  if (!read_face_blocks (place, model, blocks)
      || !qn_read_name (place, "law", QN_OPTIONAL, model, QN_NAMED_LAW, &law)
      || (has_pairs && !read_pair_rule (place, &pairs)))
    return FALSE;

  QnFaceOverride *override = qn_model_add_override (model);
  if (override == NULL)
    return qn_json_value_no_memory (place);
  *override = (QnFaceOverride){ .block_a = blocks[0],
                                .block_b = blocks[1],
                                .law = law,
                                .has_pairs = has_pairs,
                                .pairs = pairs };
  return TRUE;
}

gboolean
qn_read_contact (const QnJsonValue *root, QnModel *model)
{
  static const char *const keys[] = { "law", "tolerance", "pairs", "faces" };
  QnContactSettings *contact = &model->contact;
  QnJsonValue place = qn_json_value_member (root, "contact");
  const gboolean touching = model->block_count > 0; /* beams alone have no contacts */
  if (place.json == NULL && !touching)
    return TRUE;
  if (!qn_json_value_object (&place))
    return FALSE;
  qn_json_value_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  if (!qn_read_name (&place, "law", touching ? QN_REQUIRED : QN_OPTIONAL, model,
                     QN_NAMED_LAW, &contact->law)
      || !qn_member_number (&place, "tolerance", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &contact->tolerance)
      || (cJSON_HasObjectItem (place.json, "pairs")
          && !read_pair_rule (&place, &contact->pairs)))
    return FALSE;

  return qn_read_each (&place, "faces", QN_OPTIONAL, read_face, model);
}

static gboolean
read_node_force (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind", "case", "node", "value", "moment" };
  if (cJSON_HasObjectItem (place->json, "block")) {
    QnJsonValue block = qn_json_value_member (place, "block");
    return qn_json_value_fail (&block, _ ("block and node exclude each other"));
  }
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  load->kind = QN_LOAD_NODE;
  return qn_read_name (place, "node", QN_REQUIRED, model, QN_NAMED_NODE, &load->node)
         && qn_member_vec2 (place, "value", QN_REQUIRED, &load->vector)
         && qn_member_number (place, "moment", QN_OPTIONAL, QN_RANGE_FINITE,
                              &load->moment);
}

static gboolean
read_line_load (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind", "case", "beam", "value" };
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_read_name (place, "beam", QN_REQUIRED, model, QN_NAMED_BEAM, &load->beam)
         && qn_member_vec2 (place, "value", QN_REQUIRED, &load->vector);
}

static gboolean
read_force (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind", "case", "block", "value", "moment", "at" };
  if (cJSON_HasObjectItem (place->json, "node"))
    return read_node_force (place, model, load);
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  load->has_at = cJSON_HasObjectItem (place->json, "at");
  return qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK, &load->block)
         && qn_member_vec2 (place, "value", QN_REQUIRED, &load->vector)
         && qn_member_number (place, "moment", QN_OPTIONAL, QN_RANGE_FINITE,
                              &load->moment)
         && qn_member_vec2 (place, "at", QN_OPTIONAL, &load->at);
}

static gboolean
read_settlement (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind", "case", "block", "component", "value" };
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK, &load->block)
         && qn_member_choice (place, "component", QN_REQUIRED, qn_dof_names, QN_DOF_COUNT,
                              &load->dof)
         && qn_member_number (place, "value", QN_REQUIRED, QN_RANGE_FINITE, &load->value);
}

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

static gboolean
read_edge_load (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind",  "case", "block",     "side",     "edge",
                                      "count", "part", "intensity", "direction" };
  QnVec2 part = { 0, 1 };
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  load->normal = !cJSON_HasObjectItem (place->json, "direction");
  if (!qn_read_name (place, "block", QN_REQUIRED, model, QN_NAMED_BLOCK, &load->block)
      || !read_chain (place, model, load)
      || !qn_member_vec2 (place, "part", QN_OPTIONAL, &part)
      || !qn_member_vec2 (place, "direction", QN_OPTIONAL, &load->vector))
    return FALSE;
  load->part[0] = part.x;
  load->part[1] = part.y;
  return read_intensity (place, load->intensity);
}

static gboolean
read_surcharge (const QnJsonValue *place, QnLoad *load)
{
  static const char *const keys[] = { "kind", "case",        "pressure", "from",
                                      "to",   "unit_weight", "level" };
  const gboolean fill = cJSON_HasObjectItem (place->json, "unit_weight");
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_member_number (place, "pressure", fill ? QN_OPTIONAL : QN_REQUIRED,
                           QN_RANGE_NOT_NEGATIVE, &load->pressure)
         && qn_member_number (place, "from", QN_OPTIONAL, QN_RANGE_FINITE, &load->span[0])
         && qn_member_number (place, "to", QN_OPTIONAL, QN_RANGE_FINITE, &load->span[1])
         && qn_member_number (place, "unit_weight", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                              &load->unit_weight)
         && qn_member_number (place, "level", fill ? QN_REQUIRED : QN_OPTIONAL,
                              QN_RANGE_FINITE, &load->level);
}

/* K as a number, or from the friction angle of the soil. */
static gboolean
read_earth (const QnJsonValue *place, QnLoad *load)
{
  const gboolean angle = cJSON_HasObjectItem (place->json, "friction_angle");
  const QnJsonValue number = qn_json_value_member (place, "coefficient");
  if (!angle)
    return qn_member_number (place, "coefficient", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE,
                             &load->coefficient);
  if (number.json != NULL)
    return qn_json_value_fail (&number,
                               _ ("coefficient and friction_angle exclude each other"));
  load->earth = QN_EARTH_ACTIVE;
  if (!qn_member_choice (place, "earth", QN_OPTIONAL, qn_earth_names, QN_EARTH_COUNT,
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
read_backfill (const QnJsonValue *place, QnLoad *load)
{
  static const char *const keys[] = { "kind",        "case",           "side",
                                      "top",         "bottom",         "unit_weight",
                                      "coefficient", "friction_angle", "earth",
                                      "surcharge" };
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  return qn_member_choice (place, "side", QN_REQUIRED, qn_block_side_names,
                           QN_BLOCK_SIDE_BOTTOM, &load->side)
         && qn_member_number (place, "top", QN_REQUIRED, QN_RANGE_FINITE, &load->span[1])
         && qn_member_number (place, "bottom", QN_OPTIONAL, QN_RANGE_FINITE,
                              &load->span[0])
         && qn_member_number (place, "unit_weight", QN_REQUIRED, QN_RANGE_NOT_NEGATIVE,
                              &load->unit_weight)
         && qn_member_number (place, "surcharge", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                              &load->pressure)
         && read_earth (place, load);
}

static gboolean
read_case (const QnJsonValue *place, const QnModel *model, int32_t *load_case)
{
  const char *name = NULL;
  QnJsonValue member = qn_json_value_member (place, "case");
  if (!qn_member_string (place, "case", QN_OPTIONAL, &name))
    return FALSE;
  *load_case = name != NULL ? qn_model_find_load_case (model, name) : 0;
  return *load_case != QN_NONE
         || qn_json_value_fail (&member,
                                _ (qn_problem_text (QN_PROBLEM_LOAD_CASE_UNKNOWN)));
}

static gboolean
read_load (const QnJsonValue *place, const QnModel *model, QnLoad *load)
{
  static const char *const weight_keys[] = { "kind", "case", "direction" };
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_load_kind_names, QN_LOAD_NODE,
                            &load->kind)
      || !read_case (place, model, &load->load_case))
    return FALSE;
  if (load->kind == QN_LOAD_FORCE)
    return read_force (place, model, load);
  if (load->kind == QN_LOAD_SETTLEMENT)
    return read_settlement (place, model, load);
  if (load->kind == QN_LOAD_LINE)
    return read_line_load (place, model, load);
  if (load->kind == QN_LOAD_EDGE)
    return read_edge_load (place, model, load);
  if (load->kind == QN_LOAD_SURCHARGE)
    return read_surcharge (place, load);
  if (load->kind == QN_LOAD_BACKFILL)
    return read_backfill (place, load);
  qn_json_value_warn_unknown (place, weight_keys, G_N_ELEMENTS (weight_keys));
  return qn_member_vec2 (place, "direction", QN_REQUIRED, &load->vector);
}

static gboolean
read_load_list (const QnJsonValue *loads, const char *key, int32_t set, QnModel *model,
                QnLoad *(*add) (QnModel *model))
{
  QnJsonValue list, place = { 0 };
  if (!qn_member_array (loads, key, QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &place)) {
    QnLoad *load = add (model);
    if (load == NULL)
      return qn_json_value_no_memory (&place);
    load->set = set;
    if (!read_load (&place, model, load))
      return FALSE;
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
      return qn_json_value_failf (&list, _ ("there may be %d load sets with names"),
                                  QN_MAX_LOAD_SETS - 1);
    int32_t set = qn_model_add_load_set (model, item->string);
    if (set == QN_NONE)
      return qn_json_value_no_memory (&list);
    if (!read_load_list (&sets, item->string, set, model, qn_model_add_live_load))
      return FALSE;
  }
  return TRUE;
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
      return qn_json_value_failf (&place, _ ("there may be %d load cases"),
                                  QN_MAX_LOAD_CASES);
    int32_t added = qn_model_add_load_case (model, item->string);
    if (added == QN_NONE)
      return qn_json_value_no_memory (&place);
    if (!qn_json_value_number (&place, QN_RANGE_NOT_NEGATIVE,
                               &model->load_cases[added - 1].factor))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_read_loads (const QnJsonValue *root, QnModel *model)
{
  static const char *const keys[] = { "cases", "dead", "live", "sets" };
  QnJsonValue loads = qn_json_value_member (root, "loads");
  if (loads.json == NULL)
    return TRUE;
  if (!qn_json_value_object (&loads))
    return FALSE;
  qn_json_value_warn_unknown (&loads, keys, G_N_ELEMENTS (keys));
  return read_load_cases (&loads, model)
         && read_load_list (&loads, "dead", 0, model, qn_model_add_dead_load)
         && read_load_list (&loads, "live", 0, model, qn_model_add_live_load)
         && read_load_sets (&loads, model);
}
