#include "io/json/json-path.h"

#include "io/json/json-value.h"
#include "io/text/json-text.h"

#include <stdlib.h>
#include <string.h>

/* Characters that separate the steps of a path. */
#define SEPARATORS ".[]\""

/* Whether a key can stand in a path as it is: messages have one line. */
static gboolean
is_plain (const char *key)
{
  if (*key == '\0')
    return FALSE;
  for (; *key != '\0'; key++)
    if ((guchar) *key < 0x20 || strchr (SEPARATORS, *key) != NULL)
      return FALSE;
  return TRUE;
}

static void
clear_step (gpointer data)
{
  g_free (((QnJsonStep *) data)->key);
}

/* Reads one step; returns what follows, or NULL. */
static const char *
parse_step (const char *text, gboolean first, QnJsonStep *step)
{
  if (*text == '[') {
    /* Reads [3] or ["key"]; returns what follows, or NULL. */
    text++;
    if (*text == '"') {
      const gsize length = qn_json_string_length (text);
      if (length == 0 || text[length] != ']')
        return NULL;
      step->key = qn_json_unescape (text);
      return text + length + 1;
    }

    char *end;
    guint64 index = g_ascii_strtoull (text, &end, 10);
    if (!g_ascii_isdigit (*text) || *end != ']' || index > G_MAXINT32)
      return NULL;
    step->index = (gsize) index;
    return end + 1;
  }
  if (!first && *text++ != '.')
    return NULL;

  gsize length = strcspn (text, SEPARATORS);
  if (length == 0)
    return NULL;
  step->key = g_strndup (text, length);
  return text + length;
}

GArray *
qn_json_path_parse (const char *text)
{
  g_autoptr (GArray) path = g_array_new (FALSE, FALSE, sizeof (QnJsonStep));
  g_array_set_clear_func (path, clear_step);
  while (text != NULL && *text != '\0') {
    QnJsonStep step = { NULL, 0 };
    text = parse_step (text, path->len == 0, &step);
    g_array_append_val (path, step);
  }
  return text != NULL ? g_steal_pointer (&path) : NULL;
}

void
qn_json_path_append (GString *path, const char *key, gsize index)
{
  if (key == NULL) {
    g_string_append_printf (path, "[%" G_GSIZE_FORMAT "]", index);
    return;
  }
  if (!is_plain (key)) {
    g_string_append_c (path, '[');
    qn_json_append_string (path, key);
    g_string_append_c (path, ']');
    return;
  }
  if (path->len > 0)
    g_string_append_c (path, '.');
  g_string_append (path, key);
}

char *
qn_json_path_dup_text (const GArray *steps)
{
  GString *path = g_string_new (NULL);
  for (guint i = 0; i < steps->len; i++) {
    const QnJsonStep *step = &g_array_index (steps, QnJsonStep, i);
    qn_json_path_append (path, step->key, step->index);
  }
  return g_string_free (path, FALSE);
}

gboolean
qn_json_path_is_within (const char *path, const char *ancestor)
{
  gsize length = strlen (ancestor);
  return strncmp (path, ancestor, length) == 0
         && (length == 0 || path[length] == '\0' || path[length] == '.'
             || path[length] == '[');
}

/* Moves from the place of one offset to that of a later one. */
static void
advance (const char *text, gsize from, gsize to, QnJsonPlace *place)
{
  for (const char *c; (c = memchr (text + from, '\n', to - from)) != NULL;) {
    from = (gsize) (c - text) + 1;
    *place = (QnJsonPlace){ place->line + 1, 1 };
  }
  for (; from < to; from++)
    place->column += ((guchar) text[from] & 0xc0) != 0x80; /* not inside a character */
}

QnJsonPlace
qn_json_position (const char *text, gsize offset)
{
  QnJsonPlace place = { 1, 1 };
  advance (text, 0, offset, &place);
  return place;
}

/* The element of an array that was found last, of each of the first steps of a path: what follows it is
 * not searched from the first. */
#define REMEMBERED_STEPS 8

typedef struct Found {
  const cJSON *array, *element;
  gsize index;
} Found;

static const cJSON *
find_element (const cJSON *array, gsize index, Found *found)
{
  if (!cJSON_IsArray (array))
    return NULL;
  if (found->element == NULL || found->array != array || found->index > index)
    *found = (Found){ array, array->child, 0 };
  for (; found->element != NULL && found->index < index; found->index++)
    found->element = found->element->next;
  return found->element;
}

/* The value that a path leads to, or the last one on its way. */
static const cJSON *
follow (const cJSON *value, const char *path, Found *found)
{
  g_autoptr (GArray) steps = qn_json_path_parse (path);
  for (guint i = 0; steps != NULL && i < steps->len; i++) {
    const QnJsonStep *step = &g_array_index (steps, QnJsonStep, i);
    const cJSON *next =
      step->key != NULL
        ? cJSON_GetObjectItemCaseSensitive (value, step->key)
        : find_element (value, step->index, &found[MIN (i, REMEMBERED_STEPS - 1)]);
    if (next == NULL)
      break;
    value = next;
  }
  return value;
}

typedef struct Wanted {
  gsize offset;
  guint path;
} Wanted;

static int
compare_offsets (const void *a, const void *b)
{
  const Wanted *v = a, *w = b;
  return (v->offset > w->offset) - (v->offset < w->offset);
}

QnJsonPlace *
qn_json_locate_all (const char *text, gsize length, const GPtrArray *paths)
{
  Found found[REMEMBERED_STEPS] = { 0 };
  cJSON *root = qn_json_parse (text, length, "", NULL);
  g_autofree Wanted *wanted = g_new (Wanted, paths->len + 1);
  for (guint i = 0; i < paths->len; i++) {
    const cJSON *value = root != NULL ? follow (root, paths->pdata[i], found) : NULL;
    wanted[i] = (Wanted){ value != NULL ? (gsize) value->valueint : 0, i };
  }
  cJSON_Delete (root);
  qsort (wanted, paths->len, sizeof *wanted, compare_offsets);

  QnJsonPlace *places = g_new (QnJsonPlace, paths->len + 1), place = { 1, 1 };
  for (guint i = 0; i < paths->len; i++) {
    advance (text, i > 0 ? wanted[i - 1].offset : 0, wanted[i].offset, &place);
    places[wanted[i].path] = place;
  }
  return places;
}

QnJsonPlace
qn_json_locate (const char *text, gsize length, const char *path)
{
  gpointer items[] = { (gpointer) path };
  const GPtrArray paths = { items, 1 };
  g_autofree QnJsonPlace *places = qn_json_locate_all (text, length, &paths);
  return places[0];
}
