#include "io/json/json-value.h"

#include "core/base/integer.h"
#include "core/base/word.h"
#include "io/json/json-path.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <stdarg.h>
#include <string.h>

QnJsonValue
qn_json_value_root (QnReader *reader, const cJSON *value)
{
  return (QnJsonValue){ .reader = reader, .json = value };
}

QnJsonValue
qn_json_value_member (const QnJsonValue *object, const char *key)
{
  return (QnJsonValue){ .reader = object->reader,
                        .parent = object,
                        .key = key,
                        .json = cJSON_GetObjectItemCaseSensitive (object->json, key) };
}

QnJsonValue
qn_json_value_child (const QnJsonValue *object, const cJSON *member)
{
  return (QnJsonValue){
    .reader = object->reader, .parent = object, .key = member->string, .json = member
  };
}

QnJsonValue
qn_json_value_element (const QnJsonValue *array, gsize index, const cJSON *value)
{
  return (QnJsonValue){
    .reader = array->reader, .parent = array, .index = index, .json = value
  };
}

gboolean
qn_json_value_next (const QnJsonValue *array, QnJsonValue *element)
{
  const cJSON *json = array->json;
  if (element->parent == NULL)
    *element = qn_json_value_element (array, 0, json != NULL ? json->child : NULL);
  else
    *element = qn_json_value_element (array, element->index + 1, element->json->next);
  return element->json != NULL;
}

static void
append_place (const QnJsonValue *place, GString *path)
{
  if (place->parent == NULL)
    return;
  append_place (place->parent, path);
  qn_json_path_append (path, place->key, place->index);
}

char *
qn_json_value_dup_path (const QnJsonValue *place)
{
  GString *path = g_string_new (NULL);
  append_place (place, path);
  return g_string_free (path, FALSE);
}

/* The override that put the value at `path` there, the last of those that did; or NULL. One that
 * set something inside that value counts where `inside`. */
static const char *
find_override (const QnReader *reader, const char *path, gboolean inside)
{
  const char *found = NULL;
  for (gsize i = 0; reader->overrides != NULL && reader->overrides[i] != NULL; i++) {
    g_autofree char *set = qn_json_override_dup_path (reader->overrides[i]);
    if (set != NULL
        && (qn_json_path_is_within (path, set)
            || (inside && qn_json_path_is_within (set, path))))
      found = reader->overrides[i];
  }
  return found;
}

static void
append_origin (GString *line, const char *override)
{
  g_string_append (line, _ (" (set by "));
  qn_json_append_string (line, override);
  g_string_append_c (line, ')');
}

char *
qn_reader_dup_line (const QnReader *reader, const char *path, const QnJsonPlace *known,
                    const char *message)
{
  GString *line = g_string_new (reader->name);
  const char *override = find_override (reader, path, FALSE);
  if (override == NULL && reader->text != NULL) {
    QnJsonPlace place =
      known != NULL ? *known : qn_json_locate (reader->text, reader->length, path);
    g_string_append_printf (line, ":%zu:%zu", place.line, place.column);
  }
  if (path[0] != '\0')
    g_string_append_printf (line, ": %s", path);
  g_string_append (line, ": ");
  /* What a message quotes of the file may hold line breaks; it stays one line. */
  for (const char *at = message; *at != '\0'; at++)
    if (g_ascii_iscntrl (*at))
      g_string_append_printf (line, "\\u%04x", *at);
    else
      g_string_append_c (line, *at);
  if (override != NULL)
    append_origin (line, override);
  return g_string_free (line, FALSE);
}

/* A message about a value at a byte of the text; behind its end: where the path leads. */
static char *
dup_line_at (const QnJsonValue *place, gsize at, const char *message)
{
  const QnReader *reader = place->reader;
  const gboolean known = reader->text != NULL && at <= reader->length;
  g_autofree char *path = qn_json_value_dup_path (place);
  QnJsonPlace found = { 0 };
  if (known)
    found = qn_json_position (reader->text, at);
  return qn_reader_dup_line (reader, path, known ? &found : NULL, message);
}

/* Where a value begins, or the one around it if it is missing; G_MAXSIZE: not known. */
static gsize
byte_of (const QnJsonValue *place)
{
  while (place->parent != NULL && (place->json == NULL || place->json->valueint <= 0))
    place = place->parent;
  return place->json != NULL && place->json->valueint > 0 ? (gsize) place->json->valueint
                                                          : G_MAXSIZE;
}

gboolean
qn_json_value_fail_at (const QnJsonValue *place, gsize at, const char *message)
{
  if (place->reader->error != NULL)
    return FALSE;
  g_autofree char *line = dup_line_at (place, at, message);
  place->reader->error = g_error_new_literal (QN_IO_ERROR, QN_IO_ERROR_INVALID, line);
  return FALSE;
}

gboolean
qn_json_value_fail (const QnJsonValue *place, const char *message)
{
  return qn_json_value_fail_at (place, byte_of (place), message);
}

gboolean
qn_json_value_failf (const QnJsonValue *place, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *message = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  return qn_json_value_fail (place, message);
}

gboolean
qn_json_value_no_memory (const QnJsonValue *place)
{
  QnReader *reader = place->reader;
  if (reader->error == NULL)
    reader->error = g_error_new (QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s",
                                 reader->name, _ ("not enough memory"));
  return FALSE;
}

static gboolean
takes_warnings (const QnReader *reader)
{
  return reader->warnings != NULL && reader->warnings->len < QN_READER_MAX_WARNINGS;
}

void
qn_json_value_warn (const QnJsonValue *place, const char *message)
{
  QnReader *reader = place->reader;
  if (!takes_warnings (reader)) {
    reader->dropped_warnings++;
    return;
  }
  g_ptr_array_add (reader->warnings, dup_line_at (place, byte_of (place), message));
}

/* Puts a copy of one member aside. */
static void
keep_unknown (const QnJsonValue *object, const cJSON *member)
{
  QnReader *reader = object->reader;
  if (!reader->keeps_unknown)
    return;
  if (reader->unknown == NULL) {
    reader->unknown = cJSON_CreateObject ();
    reader->owners = g_hash_table_new (NULL, NULL);
  }
  cJSON *owner = g_hash_table_lookup (reader->owners, object->json);
  if (owner == NULL) {
    g_autofree char *path = qn_json_value_dup_path (object);
    owner = cJSON_AddObjectToObject (reader->unknown, path);
    g_hash_table_insert (reader->owners, (gpointer) object->json, owner);
  }
  cJSON_AddItemToObject (owner, member->string, cJSON_Duplicate (member, 1));
}

gboolean
qn_json_value_idle (const QnJsonValue *place, const char *message)
{
  QnReader *reader = place->reader;
  g_autofree char *path =
    reader->overrides != NULL ? qn_json_value_dup_path (place) : NULL;
  const char *override = path != NULL ? find_override (reader, path, TRUE) : NULL;
  if (override == NULL) {
    qn_json_value_warn (place, message);
    return TRUE;
  }
  if (reader->error != NULL)
    return FALSE;
  g_autoptr (GString) line = g_string_new (message);
  if (find_override (reader, path, FALSE) == NULL)
    append_origin (line, override);
  qn_json_value_fail (place, line->str);
  reader->error->code = QN_IO_ERROR_OVERRIDE;
  return FALSE;
}

gboolean
qn_json_value_unknown (const QnJsonValue *member, const char *const *keys, gsize count)
{
  if (!takes_warnings (member->reader) && member->reader->overrides == NULL) {
    member->reader->dropped_warnings++;
    return TRUE;
  }
  const char *near = qn_nearest_word (member->key, keys, count);
  g_autoptr (GString) message = g_string_new (_ ("unknown key"));
  if (near != NULL)
    g_string_append_printf (message, _ ("; the nearest known one is \"%s\""), near);
  return member->reader->refuses_unknown ? qn_json_value_fail (member, message->str)
                                         : qn_json_value_idle (member, message->str);
}

gboolean
qn_json_value_check_keys (const QnJsonValue *object, const char *const *keys, gsize count)
{
  const cJSON *child = cJSON_IsObject (object->json) ? object->json->child : NULL;
  for (; child != NULL; child = child->next) {
    gsize i = 0;
    while (i < count && strcmp (child->string, keys[i]) != 0)
      i++;
    if (i < count)
      continue;
    QnJsonValue member = qn_json_value_child (object, child);
    if (!qn_json_value_unknown (&member, keys, count))
      return FALSE;
    keep_unknown (object, child);
  }
  return TRUE;
}

/* Type of a value for a message, translated. */
static const char *
describe_type (const cJSON *value)
{
  if (cJSON_IsObject (value))
    return _ ("an object");
  if (cJSON_IsArray (value))
    return _ ("an array");
  if (cJSON_IsString (value))
    return _ ("a string");
  if (cJSON_IsNumber (value))
    return _ ("a number");
  return cJSON_IsBool (value) ? _ ("true or false") : _ ("null");
}

/* Whether the value is there and of the type that `wanted` describes; translated only here, for
 * looking up a translation takes longer than reading a number. */
static gboolean
require_type (const QnJsonValue *place, gboolean matches, const char *wanted)
{
  if (place->json == NULL)
    return qn_json_value_fail (place, _ ("required key is missing"));
  if (!matches)
    /* Translators: "expected a number, found a string". */
    return qn_json_value_failf (place, _ ("expected %s, found %s"), _ (wanted),
                                describe_type (place->json));
  return TRUE;
}

gboolean
qn_json_value_object (const QnJsonValue *place)
{
  return require_type (place, cJSON_IsObject (place->json), N_ ("an object"));
}

gboolean
qn_json_value_array (const QnJsonValue *place)
{
  return require_type (place, cJSON_IsArray (place->json), N_ ("an array"));
}

gboolean
qn_json_value_number (const QnJsonValue *place, QnRange range, double *number)
{
  if (!require_type (place, cJSON_IsNumber (place->json), N_ ("a number")))
    return FALSE;

  double value = place->json->valuedouble;
  QnProblem problem = qn_number_problem (
    value, range, place->reader->any_size ? INFINITY : QN_LARGEST_NUMBER);
  if (problem != QN_PROBLEM_NONE)
    return qn_json_value_fail (place, _ (qn_problem_text (problem)));
  *number = value;
  return TRUE;
}

gboolean
qn_json_value_numbers (const QnJsonValue *list, QnRange range, gsize stride,
                       double *numbers)
{
  QnJsonValue item = { 0 };
  while (qn_json_value_next (list, &item))
    if (!qn_json_value_number (&item, range, &numbers[stride * item.index]))
      return FALSE;
  return TRUE;
}

gboolean
qn_json_value_vec2 (const QnJsonValue *place, QnVec2 *vector)
{
  if (!qn_json_value_array (place))
    return FALSE;
  if (cJSON_GetArraySize (place->json) != 2)
    return qn_json_value_fail (place, _ ("expected two numbers"));
  return qn_json_value_numbers (place, QN_RANGE_FINITE, 1, &vector->x);
}

/* Whether there is a member to be read: not one that may be missing and is. */
static gboolean
is_read (const QnJsonValue *object, const char *key, QnNeed need, QnJsonValue *member)
{
  *member = qn_json_value_member (object, key);
  return member->json != NULL || need == QN_REQUIRED;
}

gboolean
qn_member_number (const QnJsonValue *object, const char *key, QnNeed need, QnRange range,
                  double *number)
{
  QnJsonValue member;
  return !is_read (object, key, need, &member)
         || qn_json_value_number (&member, range, number);
}

gboolean
qn_member_count (const QnJsonValue *object, const char *key, QnNeed need, int32_t max,
                 int32_t *count)
{
  QnJsonValue member;
  double number = 1;
  if (!is_read (object, key, need, &member))
    return TRUE;
  if (!qn_json_value_number (&member, QN_RANGE_FINITE, &number))
    return FALSE;
  *count = (int32_t) qn_to_integer (number, 1, max);
  return *count == number
         || qn_json_value_failf (&member, _ ("expected a whole number from 1 to %d"),
                                 max);
}

gboolean
qn_member_bool (const QnJsonValue *object, const char *key, QnNeed need, bool *flag)
{
  QnJsonValue member;
  if (!is_read (object, key, need, &member))
    return TRUE;
  *flag = cJSON_IsTrue (member.json);
  return require_type (&member, cJSON_IsBool (member.json), N_ ("true or false"));
}

gboolean
qn_member_vec2 (const QnJsonValue *object, const char *key, QnNeed need, QnVec2 *vector)
{
  QnJsonValue member;
  return !is_read (object, key, need, &member) || qn_json_value_vec2 (&member, vector);
}

gboolean
qn_member_array (const QnJsonValue *object, const char *key, QnNeed need,
                 QnJsonValue *array)
{
  return !is_read (object, key, need, array) || qn_json_value_array (array);
}

gboolean
qn_member_rows (const QnJsonValue *object, const char *key, QnNeed need, int width,
                int most, double *rows, int32_t *count)
{
  QnJsonValue list, row = { 0 };
  if (!qn_member_array (object, key, need, &list))
    return FALSE;
  for (*count = 0; qn_json_value_next (&list, &row); ++*count) {
    if (*count == most)
      return qn_json_value_failf (&list, _ ("expected up to %d rows of %d numbers"), most,
                                  width);
    if (!qn_json_value_array (&row))
      return FALSE;
    if (cJSON_GetArraySize (row.json) != width)
      return width == 2 ? qn_json_value_fail (&row, _ ("expected two numbers"))
                        : qn_json_value_failf (&row, _ ("expected %d numbers"), width);
    if (!qn_json_value_numbers (&row, QN_RANGE_FINITE, 1, rows + *count * width))
      return FALSE;
  }
  return TRUE;
}

gboolean
qn_member_string (const QnJsonValue *object, const char *key, QnNeed need,
                  const char **string)
{
  QnJsonValue member;
  if (!is_read (object, key, need, &member))
    return TRUE;
  if (cJSON_IsString (member.json))
    *string = member.json->valuestring;
  return require_type (&member, cJSON_IsString (member.json), N_ ("a string"));
}

gboolean
qn_member_choice (const QnJsonValue *object, const char *key, QnNeed need,
                  const char *const *names, int count, void *choice)
{
  const char *given = NULL;
  if (!qn_member_string (object, key, need, &given))
    return FALSE;
  if (given == NULL || qn_find_word (given, names, count, choice))
    return TRUE;
  QnJsonValue member = qn_json_value_member (object, key);
  g_autoptr (GString) message = g_string_new (NULL);
  qn_json_append_string (message, given);
  /* Translators: followed by a list of words. */
  g_string_append (message, _ (" is not one of "));
  for (int i = 0; i < count; i++)
    g_string_append_printf (message, "%s%s", i > 0 ? ", " : "",
                            names[i] != NULL ? names[i] : "null");
  return qn_json_value_fail (&member, message->str);
}

/* No key is as long; longer words are near none. */
#define MOST 64

static gsize
count_slips (const char *a, gsize a_length, const char *b, gsize b_length)
{
  gsize slips[MOST + 1][MOST + 1];
  for (gsize i = 0; i <= a_length; i++)
    for (gsize j = 0; j <= b_length; j++) {
      if (i == 0 || j == 0) {
        slips[i][j] = i + j;
        continue;
      }
      slips[i][j] = MIN (slips[i - 1][j - 1] + (a[i - 1] != b[j - 1]),
                         MIN (slips[i - 1][j], slips[i][j - 1]) + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        slips[i][j] = MIN (slips[i][j], slips[i - 2][j - 2] + 1);
    }
  return slips[a_length][b_length];
}

const char *
qn_nearest_word (const char *word, const char *const *words, gsize count)
{
  const char *nearest = NULL;
  gsize least = MOST, length = strlen (word);
  for (gsize i = 0; i < count && length <= MOST; i++) {
    gsize other = strlen (words[i]);
    gsize slips = other <= MOST ? count_slips (word, length, words[i], other) : MOST;
    gsize longer = MAX (length, other);
    if (slips < least && slips < longer && (slips == 1 || 3 * slips <= longer)) {
      least = slips;
      nearest = words[i];
    }
  }
  return nearest;
}

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
  /* The key of `parent` that is nearest to one that has just been added. */
  g_autoptr (GPtrArray) keys = g_ptr_array_new ();
  const cJSON *member;
  cJSON_ArrayForEach (member, parent)
  {
    if (member->string != container->string)
      g_ptr_array_add (keys, member->string);
  }
  const char *near =
    qn_nearest_word (container->string, (const char *const *) keys->pdata, keys->len);
  return near != NULL ? g_strdup_printf (
           _ ("there is no list %s; the nearest known key is \"%s\""), before, near)
                      : g_strdup_printf (_ ("there is no list %s"), before);
}

/* The value that a step leads to; an object that is missing is added. */
static cJSON *
descend (cJSON *container, const QnJsonStep *step)
{
  if (step->key == NULL)
    return cJSON_GetArrayItem (container, (int) step->index);
  cJSON *member = cJSON_GetObjectItemCaseSensitive (container, step->key);
  return member != NULL ? member : cJSON_AddObjectToObject (container, step->key);
}

/* Puts a value, as JSON or else as a string, where the last step says. */
static void
place (cJSON *container, const QnJsonStep *step, const char *text)
{
  cJSON *value = qn_json_parse (text, strlen (text), "", NULL);
  if (value == NULL)
    value = cJSON_CreateString (text);
  if (step->key == NULL)
    cJSON_ReplaceItemInArray (container, (int) step->index, value);
  else if (!cJSON_ReplaceItemInObjectCaseSensitive (container, step->key, value))
    cJSON_AddItemToObject (container, step->key, value);
}

/* "laws[7].kn=1": the project has no such place */
static gboolean
fail_override (GError **error, const char *override, const char *message)
{
  g_autoptr (GString) quoted = g_string_new (NULL);
  g_autofree char *valid = g_utf8_make_valid (override, -1);
  qn_json_append_string (quoted, valid);
  return qn_io_fail (error, QN_IO_ERROR_OVERRIDE, "%s: %s", quoted->str, message);
}

/* Follows the path and sets the value. */
static gboolean
apply (cJSON *root, const GArray *path, const char *override, const char *text,
       GError **error)
{
  cJSON *container = root, *parent = NULL;
  g_autoptr (GString) before = g_string_new (NULL);
  for (guint i = 0; i < path->len; i++) {
    const QnJsonStep *step = &g_array_index (path, QnJsonStep, i);
    g_autofree char *obstacle = dup_obstacle (parent, container, step, before->str);
    if (obstacle != NULL) {
      g_autofree char *message =
        g_strconcat (_ ("the project has no such place"), ": ", obstacle, NULL);
      return fail_override (error, override, message);
    }
    if (i + 1 == path->len) {
      place (container, step, text);
      break;
    }
    parent = container;
    container = descend (parent, step);
    qn_json_path_append (before, step->key, step->index);
  }
  return TRUE;
}

gboolean
qn_json_override (cJSON *root, const char *override, GError **error)
{
  const char *text;
  g_autoptr (GArray) path =
    g_utf8_validate (override, -1, NULL) ? parse_path (override, &text) : NULL;
  if (path == NULL)
    return fail_override (
      error, override,
      strchr (override, '=') == NULL
        ? _ ("an override has the form path=value")
        : _ ("the path has keys parted by points, and numbers of elements in "
             "brackets, as laws[0].friction"));
  return apply (root, path, override, text, error);
}

char *
qn_json_override_dup_path (const char *override)
{
  const char *value;
  g_autoptr (GArray) steps = parse_path (override, &value);
  return steps != NULL ? qn_json_path_dup_text (steps) : NULL;
}
