#include "io/json/json-parse.h"

#include "io/json/json-tokens.h"

#include <glib/gi18n-lib.h>

/* Objects with more members than this find duplicate keys by a table. */
#define MANY_MEMBERS 32

/* The value at a token; NULL with the error set. */
static cJSON *
build (QnJson *json, gsize at)
{
  const QnJsonToken *token = &json->tokens[at];
  const gboolean object = token->type == QN_JSON_OBJECT;
  cJSON *value = NULL;
  g_autofree char *text =
    token->type == QN_JSON_STRING ? qn_json_dup_string (json, at) : NULL;
  switch (token->type) {
  case QN_JSON_OBJECT:
    value = cJSON_CreateObject ();
    break;
  case QN_JSON_ARRAY:
    value = cJSON_CreateArray ();
    break;
  case QN_JSON_STRING:
    value = cJSON_CreateString (text);
    break;
  case QN_JSON_NUMBER:
    value = cJSON_CreateNumber (qn_json_number (json, at));
    break;
  case QN_JSON_TRUE:
  case QN_JSON_FALSE:
    value = cJSON_CreateBool (token->type == QN_JSON_TRUE);
    break;
  case QN_JSON_NULL:
    value = cJSON_CreateNull ();
    break;
  case QN_JSON_KEY:
    g_return_val_if_reached (NULL);
  }
  if (value == NULL)
    qn_json_no_memory (json);
  if (value == NULL || token->next == at + 1)
    return value;

  g_autoptr (GHashTable) keys = object && qn_json_count (json, at) > MANY_MEMBERS
                                  ? g_hash_table_new (g_str_hash, g_str_equal)
                                  : NULL;
  for (gsize i = at + 1; i < token->next; i = json->tokens[i].next) {
    cJSON *item = build (json, i + object);
    g_autofree char *key = object ? qn_json_dup_string (json, i) : NULL;
    gboolean twice =
      object && item != NULL
      && (keys != NULL ? g_hash_table_contains (keys, key)
                       : cJSON_GetObjectItemCaseSensitive (value, key) != NULL);
    if (item == NULL || twice
        || !(object ? cJSON_AddItemToObject (value, key, item)
                    : cJSON_AddItemToArray (value, item))) {
      if (twice)
        qn_json_fail (json, i, _ ("key is given twice"));
      else
        qn_json_no_memory (json);
      cJSON_Delete (item);
      cJSON_Delete (value);
      return NULL;
    }
    if (keys != NULL)
      g_hash_table_add (keys, item->string);
  }
  return value;
}

cJSON *
qn_json_parse (const char *text, gsize length, const char *name, GError **error)
{
  QnJson json;
  cJSON *value = qn_json_scan (&json, text, length, name) ? build (&json, 0) : NULL;
  if (value == NULL)
    g_propagate_error (error, g_steal_pointer (&json.error));
  qn_json_clear (&json);
  return value;
}
