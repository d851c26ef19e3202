#include "io/project/project-members.h"

#include "core/base/integer.h"
#include "core/base/memory.h"
#include "core/model/model.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

/* Most members of one object. */
#define MOST_MEMBERS 32

/* ---- reading ---- */

/* "no law has this name: "joint"", so that a typing error is seen without opening the file. */
static gboolean
fail_unknown_name (const QnJsonValue *place, QnProblem problem, const char *name)
{
  g_autoptr (GString) quoted = g_string_new (NULL);
  qn_json_append_string (quoted, name);
  return qn_json_value_failf (place, "%s: %s", _ (qn_problem_text (problem)),
                              quoted->str);
}

static const struct {
  size_t
    items; /* place in QnModel; 0: of load sets and cases, which are numbered otherwise */
  QnProblem unknown;
} named_kinds[] = {
  [QN_NAMED_LAW] = { offsetof (QnModel, laws), QN_PROBLEM_LAW_UNKNOWN },
  [QN_NAMED_BLOCK] = { offsetof (QnModel, blocks), QN_PROBLEM_BLOCK_UNKNOWN },
  [QN_NAMED_NODE] = { offsetof (QnModel, nodes), QN_PROBLEM_NODE_UNKNOWN },
  [QN_NAMED_SECTION] = { offsetof (QnModel, sections), QN_PROBLEM_SECTION_UNKNOWN },
  [QN_NAMED_BEAM] = { offsetof (QnModel, beams), QN_PROBLEM_BEAM_UNKNOWN },
  [QN_NAMED_LOAD_SET] = { 0, QN_PROBLEM_LOAD_SET_UNKNOWN },
  [QN_NAMED_LOAD_CASE] = { 0, QN_PROBLEM_LOAD_CASE_UNKNOWN },
};

gboolean
qn_read_name_of (const QnJsonValue *place, const QnModel *model, QnNamed named, QnId *id)
{
  const char *name = place->json->valuestring;
  *id = named_kinds[named].items > 0
          ? qn_model_find_item (model, named_kinds[named].items, name)
        : named == QN_NAMED_LOAD_SET ? qn_model_find_load_set (model, name)
                                     : qn_model_find_load_case (model, name);
  return *id != QN_NONE || fail_unknown_name (place, named_kinds[named].unknown, name);
}

gboolean
qn_read_name (const QnJsonValue *object, const char *key, QnNeed need,
              const QnModel *model, QnNamed named, QnId *id)
{
  const char *name = NULL;
  if (!qn_member_string (object, key, need, &name))
    return FALSE;
  QnJsonValue member = qn_json_value_member (object, key);
  return name == NULL || qn_read_name_of (&member, model, named, id);
}

static gboolean
read_string (const QnJsonValue *object, const QnMember *member, QnNeed need, char **text)
{
  const char *read = NULL;
  if (!qn_member_string (object, member->key, need, &read))
    return FALSE;
  if (read == NULL)
    return TRUE;
  free (*text);
  *text = qn_strdup (read);
  return *text != NULL || qn_json_value_no_memory (object);
}

static gboolean
read_seed (const QnJsonValue *place, uint32_t *seed)
{
  double number = 0;
  if (!qn_json_value_number (place, QN_RANGE_NOT_NEGATIVE, &number))
    return FALSE;
  if (number > G_MAXUINT32 || number != floor (number))
    return qn_json_value_fail (place, _ ("expected a whole number below 4294967296"));
  *seed = (uint32_t) qn_to_integer (number, 0, G_MAXUINT32);
  return TRUE;
}

/* A whole number from `least` on. */
static gboolean
read_whole (const QnJsonValue *place, double least, double most, gint64 *whole)
{
  double number = 0;
  if (!qn_json_value_number (place, QN_RANGE_FINITE, &number))
    return FALSE;
  *whole = qn_to_integer (number, (gint64) least, (gint64) most);
  return (double) *whole == number
         || qn_json_value_fail (place,
                                _ ("expected a whole number that is not negative"));
}

gboolean
qn_read_index (const QnJsonValue *place, int32_t least, int32_t *index)
{
  gint64 whole;
  if (!read_whole (place, least, INT32_MAX, &whole))
    return FALSE;
  *index = (int32_t) whole;
  return TRUE;
}

/* A member of a result, which is there. */
static gboolean
read_of_result (const QnJsonValue *place, const QnMember *m, char *target)
{
  gpointer at = target + m->offset;
  QnId *index = at;
  switch ((int) m->kind) {
  case QN_MEMBER_MAYBE:
    if (!cJSON_IsNull (place->json))
      return qn_json_value_number (place, QN_RANGE_FINITE, at);
    if (m->given > 0)
      *(bool *) (target + m->given) = false;
    else
      *(double *) at = NAN;
    return TRUE;
  case QN_MEMBER_WHOLE:
    return qn_read_index (place, m->detail, index);
  case QN_MEMBER_BYTES:
    return read_whole (place, 0, 0x1p53, at);
  case QN_MEMBER_STAGE:
    if (!qn_read_index (place, 0, index))
      return FALSE;
    if (*index >= QN_MAX_STAGES)
      return qn_json_value_fail (place, _ ("there is no such stage"));
    ++*index;
    return TRUE;
  }
  g_return_val_if_reached (FALSE);
}

static gboolean
read_item (const QnJsonValue *item, const QnMember *m, const QnModel *model, gpointer to)
{
  if (m->kind == QN_MEMBER_NUMBERS)
    return qn_json_value_number (item, QN_RANGE_FINITE, (double *) to + item->index);
  if (m->kind == QN_MEMBER_IDS)
    return qn_read_index (item, 0, (QnId *) to + item->index);
  if (m->kind == QN_MEMBER_OBJECTS)
    return qn_members_read (item, m->members, model,
                            (char *) to + item->index * m->count);
  if (m->kind == QN_MEMBER_FLAGS) {
    ((bool *) to)[item->index] = cJSON_IsTrue (item->json);
    return cJSON_IsBool (item->json)
           || qn_json_value_fail (item, _ ("expected true or false"));
  }
  if (!cJSON_IsString (item->json))
    return qn_json_value_fail (item, m->detail == QN_NAMED_BLOCK
                                       ? _ ("expected the name of a block")
                                       : _ ("expected the name of a node"));
  return qn_read_name_of (item, model, (QnNamed) m->detail, (QnId *) to + item->index);
}

static gboolean
read_list_member (const QnJsonValue *list, const QnMember *m, const QnModel *model,
                  gpointer to)
{
  const int count = m->kind == QN_MEMBER_NAMES ? 2 : m->detail;
  QnJsonValue item = { 0 };
  if (!qn_json_value_array (list))
    return FALSE;
  if (cJSON_GetArraySize (list->json) != count)
    return qn_json_value_fail (list, m->refusal != NULL ? _ (m->refusal)
                                                        : _ ("expected two numbers"));
  while (qn_json_value_next (list, &item))
    if (!read_item (&item, m, model, to))
      return FALSE;
  return TRUE;
}

gboolean
qn_members_exclude (const QnJsonValue *object, const char *key, const char *other)
{
  QnJsonValue member = qn_json_value_member (object, key);
  return member.json == NULL || !cJSON_HasObjectItem (object->json, other)
         || qn_json_value_failf (&member, _ ("%s and %s exclude each other"), key, other);
}

/* Weight of the material as N/m3 or, times gravity, as kg/m3. */
static gboolean
read_weight (const QnJsonValue *object, QnNeed need, const QnModel *model,
             double weight[2])
{
  const QnRange range = QN_RANGE_NOT_NEGATIVE;
  QnJsonValue density = qn_json_value_member (object, "density");
  if (density.json == NULL)
    return qn_member_number (object, "unit_weight", need, range, &weight[0]);
  if (!qn_members_exclude (object, "density", "unit_weight")
      || !qn_json_value_number (&density, range, &weight[1]))
    return FALSE;
  weight[0] = weight[1] * model->gravity;
  return TRUE;
}

static gboolean
read_law_name (const QnJsonValue *object, const QnModel *model, QnId *law)
{
  QnJsonValue material = qn_json_value_member (object, "material");
  if (material.json != NULL && cJSON_HasObjectItem (object->json, "law"))
    return qn_json_value_fail (&material, _ ("law and material exclude each other"));
  return qn_read_name (object, material.json != NULL ? "material" : "law", QN_OPTIONAL,
                       model, QN_NAMED_LAW, law);
}

static gboolean
read_member (const QnJsonValue *object, const QnMember *m, const QnModel *model,
             char *target)
{
  const QnNeed need = m->use == QN_USE_REQUIRED ? QN_REQUIRED : QN_OPTIONAL;
  const QnJsonValue member = qn_json_value_member (object, m->key);
  const gboolean several = m->kind == QN_MEMBER_WEIGHT || m->kind == QN_MEMBER_LAW;
  gpointer at = target + m->offset;
  if (m->given > 0)
    *(bool *) (target + m->given) = member.json != NULL;
  if (member.json == NULL && need == QN_OPTIONAL && !several)
    return TRUE;
  switch ((int) m->kind) { /* code reads the others */
  case QN_MEMBER_NUMBER:
    return qn_json_value_number (&member, (QnRange) m->detail, at);
  case QN_MEMBER_COUNT:
    return qn_member_count (object, m->key, need, m->detail, at);
  case QN_MEMBER_BOOL:
    return qn_member_bool (object, m->key, need, at);
  case QN_MEMBER_CHOICE:
    if (m->names[0] == NULL && cJSON_IsNull (member.json)) {
      *(int *) at = 0;
      return TRUE;
    }
    return qn_member_choice (object, m->key, need, m->names, m->detail, at);
  case QN_MEMBER_SWITCH: {
    int choice = *(bool *) at;
    if (!qn_member_choice (object, m->key, need, m->names, m->detail, &choice))
      return FALSE;
    *(bool *) at = choice == 1;
    break;
  }
  case QN_MEMBER_STRING:
    return read_string (object, m, need, at);
  case QN_MEMBER_ENTITY:
    return qn_read_name (object, m->key, need, model, (QnNamed) m->detail, at);
  case QN_MEMBER_SEED:
    return read_seed (&member, at);
  case QN_MEMBER_ROWS:
    return qn_member_rows (object, m->key, need, (int) m->width, m->detail, at,
                           (int32_t *) (void *) (target + m->count));
  case QN_MEMBER_OBJECT:
    return qn_members_read (&member, m->members, model, at);
  case QN_MEMBER_FLAGS:
  case QN_MEMBER_NUMBERS:
  case QN_MEMBER_IDS:
  case QN_MEMBER_NAMES:
  case QN_MEMBER_OBJECTS:
    return read_list_member (&member, m, model, at);
  case QN_MEMBER_WEIGHT:
    return read_weight (object, need, model, at);
  case QN_MEMBER_LAW:
    return read_law_name (object, model, at);
  case QN_MEMBER_MAYBE:
  case QN_MEMBER_WHOLE:
  case QN_MEMBER_BYTES:
  case QN_MEMBER_STAGE:
    return read_of_result (&member, m, target);
  }
  return TRUE;
}

gboolean
qn_members_check (const QnJsonValue *object, const QnMember *first,
                  const QnMember *second, const QnMember *third)
{
  const QnMember *const tables[] = { first, second, third };
  const char *keys[MOST_MEMBERS];
  gsize count = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (tables); i++)
    for (const QnMember *m = tables[i]; m != NULL && m->key != NULL; m++) {
      g_assert (count < MOST_MEMBERS);
      keys[count++] = m->key;
    }
  return qn_json_value_object (object) && qn_json_value_check_keys (object, keys, count);
}

gboolean
qn_members_take (const QnJsonValue *object, const QnMember *members, const QnModel *model,
                 gpointer target)
{
  for (const QnMember *m = members; m->key != NULL; m++)
    if (!read_member (object, m, model, target))
      return FALSE;
  return TRUE;
}

gboolean
qn_members_read (const QnJsonValue *object, const QnMember *members, const QnModel *model,
                 gpointer target)
{
  return qn_members_check (object, members, NULL, NULL)
         && qn_members_take (object, members, model, target);
}

gboolean
qn_read_format (const QnJsonValue *root, const char *format, const char *refusal)
{
  const char *given;
  double version;
  if (!qn_json_value_object (root)
      || !qn_member_string (root, "format", QN_REQUIRED, &given))
    return FALSE;
  QnJsonValue place = qn_json_value_member (root, "format");
  if (strcmp (given, format) != 0)
    return qn_json_value_fail (&place, refusal);
  place = qn_json_value_member (root, "version");
  return qn_json_value_number (&place, QN_RANGE_FINITE, &version)
         && (version == QN_FORMAT_VERSION
             || qn_json_value_failf (
               &place, _ ("this program reads version %d of the format only"),
               QN_FORMAT_VERSION));
}

/* ---- writing ---- */

void
qn_json_append_numbers (GString *json, const double *numbers, gsize count)
{
  g_string_append_c (json, '[');
  for (gsize i = 0; i < count; i++) {
    g_string_append (json, i > 0 ? ", " : "");
    qn_json_append_number (json, numbers[i]);
  }
  g_string_append_c (json, ']');
}

void
qn_json_put_numbers (GString *json, const char *key, const double *numbers, gsize count)
{
  qn_json_begin_member (json, key);
  qn_json_append_numbers (json, numbers, count);
}

void
qn_json_put_vec2 (GString *json, const char *key, QnVec2 vector)
{
  qn_json_put_numbers (json, key, &vector.x, 2);
}

static void
put_rows (GString *json, const char *key, const double *rows, gsize width, gsize count)
{
  qn_json_begin_member (json, key);
  for (gsize i = 0; i < count; i++) {
    g_string_append (json, i > 0 ? ", " : "[");
    qn_json_append_numbers (json, rows + i * width, width);
  }
  g_string_append (json, count > 0 ? "]" : "[]");
}

void
qn_json_put_points (GString *json, const char *key, const QnVec2 *points, gsize count)
{
  put_rows (json, key, (const double *) points, 2, count);
}

void
qn_json_put_unusual (GString *json, const char *key, double number, double usual)
{
  if (number != usual)
    qn_json_put_number (json, key, number);
}

/* No string and no entity is the usual one; of the rest what `other` has, or none where that is NULL. */
static gboolean
is_usual (const QnMember *m, const char *from, const char *other)
{
  gconstpointer value = from + m->offset,
                usual = other != NULL ? other + m->offset : NULL;
  const double *number = value, *usual_number = usual;
  bool same = true;
  switch (m->kind) {
  case QN_MEMBER_KNOWN:
    return TRUE;
  case QN_MEMBER_MAYBE:
  case QN_MEMBER_BYTES:
  case QN_MEMBER_IDS:
  case QN_MEMBER_NAMES:
  case QN_MEMBER_OBJECTS:
    return FALSE;
  case QN_MEMBER_NUMBER:
    return usual != NULL
           && (number[0] == usual_number[0]
               || (isnan (number[0]) && isnan (usual_number[0])));
  case QN_MEMBER_COUNT:
  case QN_MEMBER_CHOICE:
  case QN_MEMBER_WHOLE:
  case QN_MEMBER_STAGE:
  case QN_MEMBER_SEED:
    return usual != NULL && *(const int *) value == *(const int *) usual;
  case QN_MEMBER_BOOL:
  case QN_MEMBER_SWITCH:
    return usual != NULL && *(const bool *) value == *(const bool *) usual;
  case QN_MEMBER_STRING:
    return *(char *const *) value == NULL;
  case QN_MEMBER_ENTITY:
  case QN_MEMBER_LAW:
    return *(const QnId *) value == QN_NONE;
  case QN_MEMBER_ROWS:
    return *(const int32_t *) (const void *) (from + m->count) == 0;
  case QN_MEMBER_OBJECT:
    for (const QnMember *inner = m->members; inner->key != NULL; inner++)
      same = same && is_usual (inner, value, usual);
    return same;
  case QN_MEMBER_FLAGS:
    for (int i = 0; i < m->detail; i++)
      same = same && !((const bool *) value)[i];
    return same;
  case QN_MEMBER_NUMBERS:
    for (int i = 0; i < m->detail; i++)
      same = same && usual != NULL && number[i] == usual_number[i];
    return same;
  case QN_MEMBER_WEIGHT:
    return number[0] == 0 && number[1] < 0;
  }
  g_return_val_if_reached (TRUE);
}

static void
write_member (GString *json, const QnMember *m, const QnModel *model, const char *from,
              const char *other)
{
  gconstpointer value = from + m->offset;
  const QnId *id = value;
  const double *number = value;
  switch (m->kind) {
  case QN_MEMBER_KNOWN:
    break;
  case QN_MEMBER_NUMBER:
  case QN_MEMBER_MAYBE:
    qn_json_put_number (json, m->key, *(const double *) value);
    break;
  case QN_MEMBER_BYTES:
    qn_json_put_number (json, m->key, (double) *(const int64_t *) value);
    break;
  case QN_MEMBER_IDS:
    qn_json_put_numbers (json, m->key, (const double[]){ id[0], id[1] }, 2);
    break;
  case QN_MEMBER_STAGE:
    qn_json_put_number (json, m->key, *id - 1);
    break;
  case QN_MEMBER_COUNT:
  case QN_MEMBER_WHOLE:
    qn_json_put_number (json, m->key, *(const int32_t *) value);
    break;
  case QN_MEMBER_BOOL:
    qn_json_begin_member (json, m->key);
    g_string_append (json, *(const bool *) value ? "true" : "false");
    break;
  case QN_MEMBER_CHOICE:
    if (m->names[*id] != NULL)
      qn_json_put_string (json, m->key, m->names[*id]);
    else
      qn_json_put_number (json, m->key, NAN);
    break;
  case QN_MEMBER_SWITCH:
    qn_json_put_string (json, m->key, m->names[*(const bool *) value ? 1 : 0]);
    break;
  case QN_MEMBER_STRING:
    qn_json_put_string (json, m->key, *(char *const *) value);
    break;
  case QN_MEMBER_ENTITY:
    qn_json_put_string (json, m->key,
                        qn_model_item_name (model, named_kinds[m->detail].items, *id));
    break;
  case QN_MEMBER_LAW:
    qn_json_put_string (json, m->key, model->laws[*id].name);
    break;
  case QN_MEMBER_SEED:
    qn_json_put_number (json, m->key, *(const uint32_t *) value);
    break;
  case QN_MEMBER_ROWS:
    put_rows (json, m->key, number, m->width,
              (gsize) * (const int32_t *) (const void *) (from + m->count));
    break;
  case QN_MEMBER_OBJECT:
    qn_members_put (json, m->key, m->members, model, value,
                    other != NULL ? other + m->offset : NULL);
    break;
  case QN_MEMBER_NUMBERS:
    qn_json_put_numbers (json, m->key, number, (gsize) m->detail);
    break;
  case QN_MEMBER_FLAGS:
    qn_json_begin_member (json, m->key);
    for (int i = 0; i < m->detail; i++)
      g_string_append_printf (json, "%s%s", i > 0 ? ", " : "[",
                              ((const bool *) value)[i] ? "true" : "false");
    g_string_append_c (json, ']');
    break;
  case QN_MEMBER_NAMES:
    qn_json_begin_member (json, m->key);
    for (int i = 0; i < 2; i++) {
      g_string_append (json, i > 0 ? ", " : "[");
      qn_json_append_string (
        json, qn_model_item_name (model, named_kinds[m->detail].items, id[i]));
    }
    g_string_append_c (json, ']');
    break;
  case QN_MEMBER_OBJECTS:
    qn_json_begin_member (json, m->key);
    for (int i = 0; i < m->detail; i++) {
      g_string_append (json, i > 0 ? " }, {" : "[{");
      qn_members_write (json, m->members, model,
                        (const char *) value + (gsize) i * m->count, NULL);
    }
    g_string_append (json, " }]");
    break;
  case QN_MEMBER_WEIGHT:
    if (number[1] >= 0)
      qn_json_put_number (json, "density", number[1]);
    else
      qn_json_put_number (json, m->key, number[0]);
    break;
  }
}

void
qn_members_write (GString *json, const QnMember *members, const QnModel *model,
                  gconstpointer source, gconstpointer usual)
{
  const char *from = source;
  for (const QnMember *m = members; m->key != NULL; m++) {
    if (m->kind == QN_MEMBER_KNOWN || m->use == QN_USE_READ)
      continue;
    if (m->kind == QN_MEMBER_MAYBE && m->given > 0 && !*(const bool *) (from + m->given))
      qn_json_put_number (json, m->key, NAN);
    else if (m->given > 0 ? *(const bool *) (from + m->given)
                          : m->use != QN_USE_OPTIONAL || !is_usual (m, from, usual))
      write_member (json, m, model, from, usual);
  }
}

void
qn_members_put (GString *json, const char *key, const QnMember *members,
                const QnModel *model, gconstpointer source, gconstpointer usual)
{
  qn_json_begin_member (json, key);
  g_string_append_c (json, '{');
  qn_members_write (json, members, model, source, usual);
  g_string_append (json, " }");
}

const char *const qn_placement_names[QN_PLACEMENT_COUNT] = {
  [QN_PLACEMENT_DEFAULT] = "default",       [QN_PLACEMENT_ENDS] = "ends",
  [QN_PLACEMENT_LOBATTO] = "gauss-lobatto", [QN_PLACEMENT_UNIFORM] = "uniform",
  [QN_PLACEMENT_GAUSS] = "gauss",           [QN_PLACEMENT_EXPLICIT] = "explicit",
};

const char *const qn_load_kind_names[QN_LOAD_KIND_COUNT] = {
  [QN_LOAD_WEIGHT] = "weight",
  [QN_LOAD_FORCE] = "force",
  [QN_LOAD_SETTLEMENT] = "settlement",
  [QN_LOAD_LINE] = "line",
  [QN_LOAD_NODE] = "force",
  [QN_LOAD_EDGE] = "edge",
  [QN_LOAD_SURCHARGE] = "surcharge",
  [QN_LOAD_BACKFILL] = "backfill",
  [QN_LOAD_FILL] = "fill",
  [QN_LOAD_VEHICLE] = "vehicle",
};

const char *const qn_dispersal_names[QN_DISPERSAL_COUNT] = {
  [QN_DISPERSAL_HALF] = "1:2",
  [QN_DISPERSAL_CS_454] = "cs-454",
  [QN_DISPERSAL_NR_025] = "nr-gn-civ-025",
  [QN_DISPERSAL_EN_1991] = "en-1991-2",
  [QN_DISPERSAL_BOUSSINESQ] = "boussinesq",
};

const char *const qn_earth_names[QN_EARTH_COUNT] = {
  [QN_EARTH_GIVEN] = "given",
  [QN_EARTH_AT_REST] = "at-rest",
  [QN_EARTH_ACTIVE] = "active",
};

const char *const qn_procedure_names[QN_PROCEDURE_COUNT] = {
  [QN_PROCEDURE_LOAD] = "load",   [QN_PROCEDURE_DISPLACEMENT] = "displacement",
  [QN_PROCEDURE_WORK] = "work",   [QN_PROCEDURE_ARC_LENGTH] = "arc-length",
  [QN_PROCEDURE_LIMIT] = "limit", [QN_PROCEDURE_DYNAMIC] = "dynamic",
};

const char *const qn_bound_choice_names[QN_BOUND_CHOICE_COUNT] = {
  [QN_BOUND_AUTO] = "auto",
  [QN_BOUND_ALWAYS] = "always",
  [QN_BOUND_NEVER] = "never",
};

const char *const qn_geometry_names[QN_GEOMETRY_COUNT] = {
  [QN_GEOMETRY_LINEAR] = "linear",
  [QN_GEOMETRY_NONLINEAR] = "nonlinear",
};

const char *const qn_snap_names[QN_SNAP_THROUGH_COUNT] = {
  [QN_SNAP_THROUGH_JUMP] = "jump",
  [QN_SNAP_THROUGH_STOP] = "stop",
};

const char *const qn_flow_names[QN_FLOW_COUNT] = {
  [QN_FLOW_ASSOCIATIVE] = "associative",
  [QN_FLOW_NON_ASSOCIATIVE] = "non-associative",
};

const char *const qn_follow_names[2] = { "fixed", "follow" };
