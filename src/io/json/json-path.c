#include "io/json/json-path.h"

#include "io/json/json-tokens.h"
#include "io/text/json-text.h"

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
  GArray *path = g_array_new (FALSE, FALSE, sizeof (QnJsonStep));
  g_array_set_clear_func (path, clear_step);
  while (text != NULL && *text != '\0') {
    QnJsonStep step = { NULL, 0 };
    text = parse_step (text, path->len == 0, &step);
    g_array_append_val (path, step);
  }
  if (text != NULL)
    return path;
  g_array_unref (path);
  return NULL;
}

void
qn_json_path_append_key (GString *path, const char *key)
{
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

void
qn_json_path_append_index (GString *path, gsize index)
{
  g_string_append_printf (path, "[%" G_GSIZE_FORMAT "]", index);
}

char *
qn_json_path_dup_text (const GArray *steps)
{
  GString *path = g_string_new (NULL);
  for (guint i = 0; i < steps->len; i++) {
    const QnJsonStep *step = &g_array_index (steps, QnJsonStep, i);
    if (step->key != NULL)
      qn_json_path_append_key (path, step->key);
    else
      qn_json_path_append_index (path, step->index);
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
