/* A history beside the text that it belongs to:
 *
 *   { "position": 1, "steps": [ { "name": "Draw Wall", "hunks": [ [120, "before", "after"] ] } ] }
 *
 * A hunk is the place in the text after the step, what the step took away there and what it put
 * in its place. */
#include "core/base/integer.h"
#include "doc/document/history-private.h"

#include "io/json/json-value.h"
#include "io/text/json-text.h"

#include <string.h>

/* ---- writing ---- */

static void
append_hunks (GString *json, const QnEditStep *step)
{
  for (guint i = 0; i < step->hunks->len; i++) {
    const QnHunk *hunk = &g_array_index (step->hunks, QnHunk, i);
    g_string_append (json, i > 0 ? ", [" : "[");
    qn_json_append_number (json, (double) hunk->offset);
    g_string_append (json, ", ");
    qn_json_append_string (json, hunk->removed);
    g_string_append (json, ", ");
    qn_json_append_string (json, hunk->inserted);
    g_string_append_c (json, ']');
  }
}

char *
qn_history_to_json (const QnEditHistory *history, const char *text)
{
  GString *json = g_string_new ("{");
  g_autofree char *digest = g_compute_checksum_for_string (G_CHECKSUM_SHA256, text, -1);
  qn_json_put_string (json, "text_sha256", digest);
  qn_json_put_number (json, "position", history->position);
  qn_json_begin_member (json, "steps");
  g_string_append_c (json, '[');
  for (guint i = 0; i < history->steps->len; i++) {
    const QnEditStep *step = g_ptr_array_index (history->steps, i);
    g_string_append (json, i > 0 ? ", {" : "{");
    qn_json_put_string (json, "name", step->name);
    qn_json_begin_member (json, "hunks");
    g_string_append_c (json, '[');
    append_hunks (json, step);
    g_string_append (json, "]}");
  }
  g_string_append (json, "]}");
  return g_string_free (json, FALSE);
}

/* ---- reading ---- */

static gboolean
read_hunk (const cJSON *value, QnEditStep *step)
{
  const cJSON *offset = cJSON_GetArrayItem (value, 0);
  const cJSON *removed = cJSON_GetArrayItem (value, 1);
  const cJSON *inserted = cJSON_GetArrayItem (value, 2);
  if (!cJSON_IsNumber (offset) || !(offset->valuedouble >= 0.0)
      || offset->valuedouble > (double) G_MAXINT32 || !cJSON_IsString (removed)
      || !cJSON_IsString (inserted))
    return FALSE;
  QnHunk hunk = { (gsize) qn_to_integer (offset->valuedouble, 0, G_MAXINT32),
                  g_strdup (removed->valuestring), g_strdup (inserted->valuestring) };
  g_array_append_val (step->hunks, hunk);
  return TRUE;
}

static gboolean
read_steps (const cJSON *steps, QnEditHistory *history)
{
  const cJSON *value, *element;
  cJSON_ArrayForEach (value, steps)
  {
    const cJSON *name = cJSON_GetObjectItemCaseSensitive (value, "name");
    const cJSON *hunks = cJSON_GetObjectItemCaseSensitive (value, "hunks");
    if (!cJSON_IsString (name) || !cJSON_IsArray (hunks))
      return FALSE;
    QnEditStep *step = qn_history_add_step (history, name->valuestring);
    cJSON_ArrayForEach (element, hunks)
    {
      if (!read_hunk (element, step))
        return FALSE;
    }
  }
  return TRUE;
}

/* Whether the hunks, one behind the other, are what stands in the text: `after` tells which of
 * their two sides, whose places are counted in the text after the step. */
static gboolean
fits (const QnEditStep *step, const char *text, gboolean after)
{
  gsize length = strlen (text), at = 0;
  gssize shift = 0;
  for (guint i = 0; i < step->hunks->len; i++) {
    const QnHunk *hunk = &g_array_index (step->hunks, QnHunk, i);
    const char *expected = after ? hunk->inserted : hunk->removed;
    gssize place = (gssize) hunk->offset + (after ? 0 : shift);
    gsize expected_length = strlen (expected);
    if (place < (gssize) at || (gsize) place > length
        || expected_length > length - (gsize) place
        || memcmp (text + place, expected, expected_length) != 0)
      return FALSE;
    at = (gsize) place + expected_length;
    shift += (gssize) strlen (hunk->removed) - (gssize) strlen (hunk->inserted);
  }
  return TRUE;
}

/* Walks to one end of the history and back to see that every step can be taken. */
static gboolean
try_steps (QnEditHistory *history, const char *text)
{
  guint position = history->position;
  for (int back = 1; back >= 0; back--) {
    g_autofree char *state = g_strdup (text);
    while (back ? qn_history_can_undo (history) : qn_history_can_redo (history)) {
      guint next = back ? history->position - 1 : history->position;
      if (!fits (g_ptr_array_index (history->steps, next), state, back))
        return FALSE;
      char *other =
        back ? qn_history_undo (history, state) : qn_history_redo (history, state);
      g_free (state);
      state = other;
    }
    history->position = position;
  }
  return TRUE;
}

static gboolean
read_history (const cJSON *root, const char *text, QnEditHistory *history)
{
  const cJSON *digest = cJSON_GetObjectItemCaseSensitive (root, "text_sha256");
  const cJSON *position = cJSON_GetObjectItemCaseSensitive (root, "position");
  const cJSON *steps = cJSON_GetObjectItemCaseSensitive (root, "steps");
  g_autofree char *expected = g_compute_checksum_for_string (G_CHECKSUM_SHA256, text, -1);
  if (!cJSON_IsString (digest) || strcmp (digest->valuestring, expected) != 0
      || !cJSON_IsNumber (position) || !cJSON_IsArray (steps)
      || !read_steps (steps, history))
    return FALSE;
  if (!(position->valuedouble >= 0.0)
      || position->valuedouble > (double) history->steps->len)
    return FALSE;
  history->position =
    (guint) qn_to_integer (position->valuedouble, 0, history->steps->len);
  if (!try_steps (history, text))
    return FALSE;
  history->broken = TRUE;
  qn_history_mark_clean (history);
  return TRUE;
}

QnEditHistory *
qn_history_from_json (const char *json, const char *text)
{
  cJSON *root = qn_json_parse (json, strlen (json), "", NULL);
  QnEditHistory *history = qn_history_new ();
  if (root == NULL || !read_history (root, text, history))
    g_clear_pointer (&history, qn_history_free);
  cJSON_Delete (root);
  return history;
}
