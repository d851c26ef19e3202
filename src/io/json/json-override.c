#include "io/json/json-override.h"

#include "io/json/json-parse.h"
#include "io/json/json-path.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* The steps before the "=", or NULL. A quoted key may hold an "=" of its own. */
static GArray *
parse_path (const char *override, const char **value)
{
  for (const char *equals = strchr (override, '='); equals != NULL;
       equals = strchr (equals + 1, '=')) {
    char *text = g_strndup (override, (gsize) (equals - override));
    GArray *path = qn_json_path_parse (text);
    g_free (text);
    if (path != NULL && path->len > 0) {
      *value = equals + 1;
      return path;
    }
    g_clear_pointer (&path, g_array_unref);
  }
  return NULL;
}

/* Whether a step can lead into `container` at all. */
static gboolean
has_place (const cJSON *container, const QnJsonStep *step)
{
  if (step->key != NULL)
    return cJSON_IsObject (container);
  return cJSON_IsArray (container) && (int) step->index < cJSON_GetArraySize (container);
}

/* The value that a step leads to; an object that is missing is added. NULL when out of memory. */
static cJSON *
descend (cJSON *container, const QnJsonStep *step)
{
  if (step->key == NULL)
    return cJSON_GetArrayItem (container, (int) step->index);
  cJSON *member = cJSON_GetObjectItemCaseSensitive (container, step->key);
  return member != NULL ? member : cJSON_AddObjectToObject (container, step->key);
}

/* Puts `value` (owned) where the last step says; FALSE when out of memory. */
static gboolean
place (cJSON *container, const QnJsonStep *step, cJSON *value)
{
  gboolean placed;
  if (step->key == NULL)
    placed = cJSON_ReplaceItemInArray (container, (int) step->index, value);
  else if (cJSON_GetObjectItemCaseSensitive (container, step->key) != NULL)
    placed = cJSON_ReplaceItemInObjectCaseSensitive (container, step->key, value);
  else
    placed = cJSON_AddItemToObject (container, step->key, value);
  if (!placed)
    cJSON_Delete (value);
  return placed;
}

/* The value as JSON or else as a string; NULL when out of memory. */
static cJSON *
parse_value (const char *text)
{
  QnJsonProblem problem;
  cJSON *value = qn_json_parse (text, strlen (text), &problem);
  g_free (problem.path);
  return value != NULL || problem.no_memory ? value : cJSON_CreateString (text);
}

/* "laws[7].kn=1": the project has no such place */
static gboolean
fail (GError **error, int code, const char *override, const char *message)
{
  GString *quoted = g_string_new (NULL);
  char *valid = g_utf8_make_valid (override, -1);
  qn_json_append_string (quoted, valid);
  g_set_error (error, QN_IO_ERROR, code, "%s: %s", quoted->str, message);
  g_free (valid);
  g_string_free (quoted, TRUE);
  return FALSE;
}

/* Follows the path and sets the value; returns the code of what went wrong, or -1. */
static int
apply (cJSON *root, const GArray *path, const char *text)
{
  cJSON *container = root;
  for (guint i = 0; i < path->len; i++) {
    const QnJsonStep *step = &g_array_index (path, QnJsonStep, i);
    if (!has_place (container, step))
      return QN_IO_ERROR_INVALID;
    if (i + 1 < path->len) {
      container = descend (container, step);
    } else {
      cJSON *value = parse_value (text);
      return value != NULL && place (container, step, value) ? -1 : QN_IO_ERROR_NO_MEMORY;
    }
    if (container == NULL)
      return QN_IO_ERROR_NO_MEMORY;
  }
  g_assert_not_reached ();
}

gboolean
qn_json_override (cJSON *root, const char *override, GError **error)
{
  const char *text;
  GArray *path =
    g_utf8_validate (override, -1, NULL) ? parse_path (override, &text) : NULL;
  if (path == NULL)
    return fail (error, QN_IO_ERROR_OVERRIDE, override,
                 _ ("an override has the form path=value"));
  int code = apply (root, path, text);
  g_array_unref (path);

  if (code == QN_IO_ERROR_NO_MEMORY)
    return fail (error, code, override, _ ("not enough memory"));
  return code < 0 || fail (error, code, override, _ ("the project has no such place"));
}

char *
qn_json_override_dup_path (const char *override)
{
  const char *value;
  GArray *steps = parse_path (override, &value);
  if (steps == NULL)
    return NULL;

  char *path = qn_json_path_dup_text (steps);
  g_array_unref (steps);
  return path;
}
