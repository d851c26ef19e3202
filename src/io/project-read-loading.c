#include "io/project-names.h"
#include "io/project-read-parts.h"

#include <glib/gi18n-lib.h>

/* Numbers of a member that is an array of at most QN_MAX_EXPLICIT_PAIRS. */
static gboolean
read_numbers (const QnPlace *object, const char *key, double *numbers, int32_t *count)
{
  QnPlace list = qn_place_member (object, key);
  if (!qn_place_array (&list))
    return FALSE;
  if (cJSON_GetArraySize (list.value) > QN_MAX_EXPLICIT_PAIRS)
    return qn_place_fail (&list, _ (qn_problem_text (QN_PROBLEM_TOO_LARGE)));
  *count = 0;
  for (const cJSON *item = list.value->child; item != NULL; item = item->next) {
    QnPlace number = qn_place_element (&list, (gsize) *count, item);
    if (!qn_place_number (&number, QN_RANGE_NOT_NEGATIVE, &numbers[*count]))
      return FALSE;
    ++*count;
  }
  return TRUE;
}

/* Positions, and weights that are equal where none are given. */
static gboolean
read_explicit_pairs (const QnPlace *place, QnPairRule *rule)
{
  int32_t weights;
  if (!read_numbers (place, "positions", rule->positions, &rule->count))
    return FALSE;
  for (int32_t i = 0; i < rule->count; i++)
    rule->weights[i] = 1.0 / rule->count;
  if (!cJSON_HasObjectItem (place->value, "weights"))
    return TRUE;
  if (!read_numbers (place, "weights", rule->weights, &weights))
    return FALSE;
  QnPlace member = qn_place_member (place, "weights");
  return weights == rule->count
         || qn_place_fail (&member, _ ("there must be as many weights as positions"));
}

static gboolean
read_pair_rule (const QnPlace *object, QnPairRule *rule)
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
  QnPlace place = qn_place_member (object, "pairs");
  int placement = (int) rule->placement;
  if (!qn_place_object (&place)
      || !qn_member_choice (&place, "placement", QN_OPTIONAL, qn_name_of_placement,
                            QN_PLACEMENT_COUNT, &placement))
    return FALSE;
  qn_place_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  rule->placement = (QnPlacement) placement;
  for (gsize i = 0; i < G_N_ELEMENTS (uses); i++) {
    QnPlace idle = qn_place_member (&place, uses[i].key);
    if (idle.value != NULL && (uses[i].placements & 1u << placement) == 0)
      qn_place_warn (&idle, _ ("has no effect with this placement"));
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
read_face_blocks (const QnPlace *face, const QnModel *model, QnId blocks[2])
{
  QnPlace names = qn_place_member (face, "blocks");
  if (!qn_place_array (&names))
    return FALSE;
  if (cJSON_GetArraySize (names.value) != 2)
    return qn_place_fail (&names, _ ("expected the names of two blocks"));

  gsize i = 0;
  for (const cJSON *name = names.value->child; name != NULL; name = name->next, i++) {
    QnPlace element = qn_place_element (&names, i, name);
    if (!cJSON_IsString (name))
      return qn_place_fail (&element, _ ("expected the name of a block"));
    blocks[i] = qn_model_find_block (model, name->valuestring);
    if (blocks[i] == QN_NONE)
      return qn_place_fail (&element, _ (qn_problem_text (QN_PROBLEM_BLOCK_UNKNOWN)));
  }
  return TRUE;
}

static gboolean
read_face (const QnPlace *place, QnModel *model)
{
  static const char *const keys[] = { "blocks", "law", "pairs" };
  if (!qn_place_object (place))
    return FALSE;
  qn_place_warn_unknown (place, keys, G_N_ELEMENTS (keys));

  QnId blocks[2], law = QN_NONE;
  QnPairRule pairs = { .placement = QN_PLACEMENT_ENDS, .count = 2 };
  bool has_pairs = cJSON_HasObjectItem (place->value, "pairs");
  if (!read_face_blocks (place, model, blocks)
      || !qn_read_law_name (place, "law", QN_OPTIONAL, model, &law)
      || (has_pairs && !read_pair_rule (place, &pairs)))
    return FALSE;

  QnFaceOverride *override = qn_model_add_override (model);
  if (override == NULL)
    return qn_place_no_memory (place);
  *override = (QnFaceOverride){ .block_a = blocks[0],
                                .block_b = blocks[1],
                                .law = law,
                                .has_pairs = has_pairs,
                                .pairs = pairs };
  return TRUE;
}

gboolean
qn_read_contact (const QnPlace *root, QnModel *model)
{
  static const char *const keys[] = { "law", "tolerance", "pairs", "faces" };
  QnContactSettings *contact = &model->contact;
  QnPlace place = qn_place_member (root, "contact");
  if (!qn_place_object (&place))
    return FALSE;
  qn_place_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  if (!qn_read_law_name (&place, "law", QN_REQUIRED, model, &contact->law)
      || !qn_member_number (&place, "tolerance", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &contact->tolerance)
      || (cJSON_HasObjectItem (place.value, "pairs")
          && !read_pair_rule (&place, &contact->pairs)))
    return FALSE;

  QnPlace faces = qn_place_member (&place, "faces");
  if (faces.value == NULL)
    return TRUE;
  if (!qn_place_array (&faces))
    return FALSE;
  gsize index = 0;
  for (const cJSON *item = faces.value->child; item != NULL; item = item->next) {
    QnPlace face = qn_place_element (&faces, index++, item);
    if (!read_face (&face, model))
      return FALSE;
  }
  return TRUE;
}

static gboolean
read_force (const QnPlace *place, const QnModel *model, QnLoad *load)
{
  static const char *const keys[] = { "kind", "block", "value", "moment", "at" };
  qn_place_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  load->has_at = cJSON_HasObjectItem (place->value, "at");
  return qn_read_block_name (place, "block", QN_REQUIRED, model, &load->block)
         && qn_member_vec2 (place, "value", QN_REQUIRED, &load->vector)
         && qn_member_number (place, "moment", QN_OPTIONAL, QN_RANGE_FINITE,
                              &load->moment)
         && qn_member_vec2 (place, "at", QN_OPTIONAL, &load->at);
}

static gboolean
read_load (const QnPlace *place, const QnModel *model, QnLoad *load)
{
  static const char *const weight_keys[] = { "kind", "direction" };
  int kind;
  if (!qn_place_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_name_of_load_kind,
                            QN_LOAD_FORCE + 1, &kind))
    return FALSE;
  load->kind = (QnLoadKind) kind;
  if (load->kind == QN_LOAD_FORCE)
    return read_force (place, model, load);
  qn_place_warn_unknown (place, weight_keys, G_N_ELEMENTS (weight_keys));
  return qn_member_vec2 (place, "direction", QN_REQUIRED, &load->vector);
}

static gboolean
read_load_list (const QnPlace *loads, const char *key, QnModel *model,
                QnLoad *(*add) (QnModel *model))
{
  QnPlace list = qn_place_member (loads, key);
  if (list.value == NULL)
    return TRUE;
  if (!qn_place_array (&list))
    return FALSE;
  gsize index = 0;
  for (const cJSON *item = list.value->child; item != NULL; item = item->next) {
    QnPlace place = qn_place_element (&list, index++, item);
    QnLoad *load = add (model);
    if (load == NULL)
      return qn_place_no_memory (&place);
    if (!read_load (&place, model, load))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_read_loads (const QnPlace *root, QnModel *model)
{
  static const char *const keys[] = { "dead", "live" };
  QnPlace loads = qn_place_member (root, "loads");
  if (loads.value == NULL)
    return TRUE;
  if (!qn_place_object (&loads))
    return FALSE;
  qn_place_warn_unknown (&loads, keys, G_N_ELEMENTS (keys));
  return read_load_list (&loads, "dead", model, qn_model_add_dead_load)
         && read_load_list (&loads, "live", model, qn_model_add_live_load);
}

static gboolean
read_control (const QnPlace *analysis, const QnModel *model, QnAnalysisSettings *settings)
{
  static const char *const keys[] = { "block", "component", "target" };
  QnPlace control = qn_place_member (analysis, "control");
  if (control.value == NULL)
    return TRUE;
  int component;
  if (!qn_place_object (&control)
      || !qn_read_block_name (&control, "block", QN_REQUIRED, model,
                              &settings->control_block)
      || !qn_member_choice (&control, "component", QN_REQUIRED, qn_name_of_dof,
                            QN_DOF_COUNT, &component)
      || !qn_member_number (&control, "target", QN_REQUIRED, QN_RANGE_FINITE,
                            &settings->control_target))
    return FALSE;
  qn_place_warn_unknown (&control, keys, G_N_ELEMENTS (keys));
  settings->control_dof = (QnDof) component;
  return TRUE;
}

static gboolean
read_choices (const QnPlace *place, QnAnalysisSettings *settings)
{
  int procedure = (int) settings->procedure, geometry = (int) settings->geometry;
  int snap = (int) settings->snap, flow = (int) settings->flow;
  if (!qn_member_choice (place, "procedure", QN_OPTIONAL, qn_name_of_procedure,
                         QN_PROCEDURE_COUNT, &procedure)
      || !qn_member_choice (place, "geometry", QN_OPTIONAL, qn_name_of_geometry,
                            QN_GEOMETRY_COUNT, &geometry)
      || !qn_member_choice (place, "snap", QN_OPTIONAL, qn_name_of_snap, QN_SNAP_COUNT,
                            &snap)
      || !qn_member_choice (place, "flow", QN_OPTIONAL, qn_name_of_flow, QN_FLOW_COUNT,
                            &flow))
    return FALSE;
  settings->procedure = (QnProcedure) procedure;
  settings->geometry = (QnGeometry) geometry;
  settings->snap = (QnSnap) snap;
  settings->flow = (QnFlow) flow;
  return TRUE;
}

gboolean
qn_read_analysis (const QnPlace *root, QnModel *model)
{
  static const char *const keys[] = {
    "procedure", "geometry", "increments",           "max_multiplier",
    "snap",      "flow",     "multiplier_tolerance", "residual_tolerance",
    "control"
  };
  const QnRange positive = QN_RANGE_POSITIVE;
  QnAnalysisSettings *settings = &model->analysis;
  QnPlace place = qn_place_member (root, "analysis");
  if (place.value == NULL)
    return TRUE;
  if (!qn_place_object (&place))
    return FALSE;
  qn_place_warn_unknown (&place, keys, G_N_ELEMENTS (keys));

  return read_choices (&place, settings)
         && qn_member_count (&place, "increments", QN_OPTIONAL, G_MAXINT32,
                             &settings->increments)
         && qn_member_number (&place, "max_multiplier", QN_OPTIONAL, positive,
                              &settings->max_multiplier)
         && qn_member_number (&place, "multiplier_tolerance", QN_OPTIONAL, positive,
                              &settings->multiplier_tolerance)
         && qn_member_number (&place, "residual_tolerance", QN_OPTIONAL, positive,
                              &settings->residual_tolerance)
         && read_control (&place, model, settings);
}
