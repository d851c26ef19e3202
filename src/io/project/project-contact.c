/* contact, with its faces, and bars. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>

static const QnMember pairs_members[] = {
  QN_CHOICE ("placement", READ, qn_placement_names, QnPairRule, placement),
  QN_KNOWN ("offset"),
  QN_KNOWN ("count"),
  QN_KNOWN ("positions"),
  QN_KNOWN ("weights"),
  { 0 },
};

static const QnMember face_members[] = {
  QN_LIST_OF ("blocks", NAMES, REQUIRED, QnFaceOverride, block_a, QN_NAMED_BLOCK,
              N_ ("expected the names of two blocks")),
  QN_ENTITY ("law", OPTIONAL, LAW, QnFaceOverride, law),
  QN_KNOWN ("pairs"),
  { 0 },
};

static const QnMember contact_members[] = {
  QN_ENTITY ("law", OPTIONAL, LAW, QnContactSettings, law),
  QN_NUMBER ("tolerance", WRITTEN, NOT_NEGATIVE, QnContactSettings, tolerance),
  QN_KNOWN ("pairs"),
  QN_KNOWN ("faces"),
  { 0 },
};

static const QnMember bar_members[] = {
  QN_ENTITY ("law", REQUIRED, LAW, QnBar, law),
  QN_NUMBER ("area", REQUIRED, POSITIVE, QnBar, area),
  QN_TWO ("start", REQUIRED, QnBar, start),
  QN_TWO ("end", REQUIRED, QnBar, end),
  QN_TWO ("spacing", OPTIONAL, QnBar, spacing),
  QN_ROWS ("via", OPTIONAL, QN_MAX_BAR_CORNERS, 2, QnBar, via, via_count),
  { 0 },
};

/* ---- reading ---- */

/* Numbers of a member that is an array of at most QN_MAX_EXPLICIT_PAIRS. */
static gboolean
read_numbers (const QnJsonValue *object, const char *key, double *numbers, int32_t *count)
{
  QnJsonValue list;
  if (!qn_member_array (object, key, QN_REQUIRED, &list))
    return FALSE;
  if (cJSON_GetArraySize (list.json) > QN_MAX_EXPLICIT_PAIRS)
    return qn_json_value_fail (&list, _ (qn_problem_text (QN_PROBLEM_TOO_LARGE)));
  *count = cJSON_GetArraySize (list.json);
  return qn_json_value_numbers (&list, QN_RANGE_NOT_NEGATIVE, 1, numbers);
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

/* Left as it is where there is none. */
static gboolean
read_pair_rule (const QnJsonValue *object, QnPairRule *rule)
{
  /* Which placements a key is for. */
  static const struct {
    const char *key;
    guint placements;
  } uses[] = {
    { "offset",
      1 << QN_PLACEMENT_DEFAULT | 1 << QN_PLACEMENT_ENDS | 1 << QN_PLACEMENT_LOBATTO },
    { "count",
      1 << QN_PLACEMENT_LOBATTO | 1 << QN_PLACEMENT_UNIFORM | 1 << QN_PLACEMENT_GAUSS },
    { "positions", 1 << QN_PLACEMENT_EXPLICIT },
    { "weights", 1 << QN_PLACEMENT_EXPLICIT },
  };
  QnJsonValue place = qn_json_value_member (object, "pairs");
  if (place.json == NULL)
    return TRUE;
  if (!qn_members_read (&place, pairs_members, NULL, rule))
    return FALSE;
  for (gsize i = 0; i < G_N_ELEMENTS (uses); i++) {
    QnJsonValue idle = qn_json_value_member (&place, uses[i].key);
    if (idle.json != NULL && (uses[i].placements & 1u << rule->placement) == 0
        && !qn_json_value_idle (&idle, _ ("has no effect with this placement")))
      return FALSE;
  }
  if (rule->placement == QN_PLACEMENT_EXPLICIT)
    return read_explicit_pairs (&place, rule);
  QnNeed need = rule->placement == QN_PLACEMENT_LOBATTO ? QN_OPTIONAL : QN_REQUIRED;
  if (rule->placement >= QN_PLACEMENT_LOBATTO
      && !qn_member_count (&place, "count", need, QN_MAX_PAIRS_PER_FACE, &rule->count))
    return FALSE;
  if (rule->placement > QN_PLACEMENT_LOBATTO)
    return TRUE;
  return qn_member_number (&place, "offset", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                           &rule->offset);
}

static gboolean
read_face (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  (void) model;
  QnFaceOverride *override = entity;
  override->has_pairs = cJSON_HasObjectItem (place->json, "pairs");
  return read_pair_rule (place, &override->pairs);
}

gboolean
qn_read_contact (const QnJsonValue *root, QnModel *model)
{
  QnContactSettings *contact = &model->contact;
  QnJsonValue place = qn_json_value_member (root, "contact");
  const gboolean touching = model->block_count > 0; /* beams alone have no contacts */
  if (place.json == NULL && !touching)
    return TRUE;
  return qn_members_read (&place, contact_members, model, contact)
         && (!touching
             || qn_read_name (&place, "law", QN_REQUIRED, model, QN_NAMED_LAW,
                              &contact->law))
         && read_pair_rule (&place, &contact->pairs)
         && qn_read_list (&place, &qn_face_list, QN_OPTIONAL, model);
}

/* ---- writing ---- */

static void
put_pair_rule (GString *json, const QnPairRule *rule)
{
  gboolean by_law = rule->placement == QN_PLACEMENT_LOBATTO && rule->count == 0;
  qn_json_begin_member (json, "pairs");
  g_string_append_c (json, '{');
  qn_json_put_string (json, "placement", qn_placement_names[rule->placement]);
  if (rule->placement <= QN_PLACEMENT_LOBATTO)
    qn_json_put_number (json, "offset", rule->offset);
  if (rule->placement == QN_PLACEMENT_EXPLICIT) {
    qn_json_put_numbers (json, "positions", rule->positions, (gsize) rule->count);
    qn_json_put_numbers (json, "weights", rule->weights, (gsize) rule->count);
  } else if (rule->placement >= QN_PLACEMENT_LOBATTO && !by_law)
    qn_json_put_number (json, "count", rule->count);
  g_string_append (json, " }");
}

static void
append_face (GString *json, const QnModel *model, size_t index)
{
  const QnFaceOverride *face = &model->overrides[index];
  qn_members_write (json, face_members, model, face, NULL);
  if (face->has_pairs)
    put_pair_rule (json, &face->pairs);
}

const QnList qn_face_list = {
  QN_LIST ("contact.faces", QnFaceOverride, overrides, override_count),
  .members = face_members, .read = read_face, .append = append_face
};

void
qn_project_append_contact (GString *json, const QnModel *model, GHashTable *inner)
{
  g_string_append (json, "  \"contact\": {");
  qn_members_write (json, contact_members, model, &model->contact, NULL);
  const QnPairRule *pairs = &model->contact.pairs;
  if (pairs->placement != QN_PLACEMENT_DEFAULT || pairs->offset != 0
      || (inner != NULL && g_hash_table_contains (inner, "contact.pairs")))
    put_pair_rule (json, pairs);
  qn_json_append_inner (json, inner, "contact.pairs");
  qn_json_append_list (json, model, inner, &qn_face_list);
  g_string_append (json, " }");
}

const QnList qn_bar_list = { QN_LIST ("bars", QnBar, bars, bar_count),
                             .members = bar_members, .usual = &(const QnBar){ 0 } };
