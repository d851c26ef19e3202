#include "io/json/json-override.h"

#include "io/json/json-path.h"
#include "io/json/json-value.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"
#include "io/text/nearest-word.h"

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

/* The key of `parent` that is nearest to one that has just been added. */
static char *
dup_nearest (const cJSON *parent, const char *added)
{
  g_autoptr (GPtrArray) keys = g_ptr_array_new ();
  const cJSON *member;
  cJSON_ArrayForEach (member, parent)
  {
    if (member->string != added)
      g_ptr_array_add (keys, member->string);
  }
  return g_strdup (qn_nearest_word (added, (const char *const *) keys->pdata, keys->len));
}

/* What keeps a step from leading into `container`, an element of `parent`; NULL where nothing does.
 * `before` leads there. */
static char *
dup_obstacle (const cJSON *parent, const cJSON *container, const QnJsonStep *step,
              const char *before)
{
  const int count = cJSON_GetArraySize (container);
  if (step->key != NULL ? cJSON_IsObject (container)
                        : cJSON_IsArray (container) && (int) step->index < count)
    return NULL;
  if (cJSON_IsArray (container) && step->key != NULL)
    return g_strdup_printf (_ ("%s is a list, whose elements are %s[0], …"), before,
                            before);
  if (cJSON_IsArray (container))
    return g_strdup_printf (ngettext ("%s has %d element, counted from 0",
                                      "%s has %d elements, counted from 0", count),
                            before, count);
  if (!cJSON_IsObject (container))
    return g_strdup_printf (_ ("%s has no members"), before);
  if (count > 0)
    return g_strdup_printf (_ ("%s is not a list"), before);
  g_autofree char *near = dup_nearest (parent, container->string);
  return near != NULL ? g_strdup_printf (
           _ ("there is no list %s; the nearest known key is \"%s\""), before, near)
                      : g_strdup_printf (_ ("there is no list %s"), before);
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
  g_autoptr (GError) error = NULL;
  cJSON *value = qn_json_parse (text, strlen (text), "", &error);
  return value != NULL || g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY)
           ? value
           : cJSON_CreateString (text);
}

/* "laws[7].kn=1": the project has no such place */
static gboolean
fail_override (GError **error, int code, const char *override, const char *message)
{
  GString *quoted = g_string_new (NULL);
  char *valid = g_utf8_make_valid (override, -1);
  qn_json_append_string (quoted, valid);
  g_set_error (error, QN_IO_ERROR, code, "%s: %s", quoted->str, message);
  g_free (valid);
  g_string_free (quoted, TRUE);
  return FALSE;
}

/* Follows the path and sets the value. */
static gboolean
apply (cJSON *root, const GArray *path, const char *override, const char *text,
       GError **error)
{
  cJSON *container = root, *parent = NULL;
  g_autoptr (GString) before = g_string_new (NULL);
  for (guint i = 0; container != NULL && i < path->len; i++) {
    const QnJsonStep *step = &g_array_index (path, QnJsonStep, i);
    g_autofree char *obstacle = dup_obstacle (parent, container, step, before->str);
    if (obstacle != NULL) {
      g_autofree char *message =
        g_strconcat (_ ("the project has no such place"), ": ", obstacle, NULL);
      return fail_override (error, QN_IO_ERROR_OVERRIDE, override, message);
    }
    if (i + 1 < path->len) {
      parent = container;
      container = descend (parent, step);
      if (step->key != NULL)
        qn_json_path_append_key (before, step->key);
      else
        qn_json_path_append_index (before, step->index);
      continue;
    }
    cJSON *value = parse_value (text);
    if (value != NULL && place (container, step, value))
      return TRUE;
    container = NULL;
  }
  return fail_override (error, QN_IO_ERROR_NO_MEMORY, override, _ ("not enough memory"));
}

gboolean
qn_json_override (cJSON *root, const char *override, GError **error)
{
  const char *text;
  GArray *path =
    g_utf8_validate (override, -1, NULL) ? parse_path (override, &text) : NULL;
  if (path == NULL)
    return fail_override (
      error, QN_IO_ERROR_OVERRIDE, override,
      strchr (override, '=') == NULL
        ? _ ("an override has the form path=value")
        : _ ("the path has keys parted by points, and numbers of elements in "
             "brackets, as laws[0].friction"));
  gboolean done = apply (root, path, override, text, error);
  g_array_unref (path);
  return done;
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
