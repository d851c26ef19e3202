#include "doc/document/history.h"

#include "core/base/integer.h"
#include "io/json/json-value.h"
#include "io/text/json-text.h"

#include <string.h>

/* One run of bytes that differs. Offsets count in the text after the step. */
typedef struct QnHunk {
  gsize offset;
  char *removed;  /* owned */
  char *inserted; /* owned */
} QnHunk;

typedef struct QnEditStep {
  char *name;
  char *key;
  GArray *hunks; /* of QnHunk, by offset */
} QnEditStep;

static void
hunk_clear (gpointer data)
{
  QnHunk *hunk = data;
  g_free (hunk->removed);
  g_free (hunk->inserted);
}

static GArray *
hunks_new (void)
{
  GArray *hunks = g_array_new (FALSE, FALSE, sizeof (QnHunk));
  g_array_set_clear_func (hunks, hunk_clear);
  return hunks;
}

static void
step_free (gpointer data)
{
  QnEditStep *step = data;
  g_free (step->name);
  g_free (step->key);
  g_array_unref (step->hunks);
  g_free (step);
}

static void
add_hunk (GArray *hunks, const char *before, gsize before_length, const char *after,
          gsize after_length, gsize offset)
{
  QnHunk hunk = { offset, g_strndup (before, before_length),
                  g_strndup (after, after_length) };
  g_array_append_val (hunks, hunk);
}

static gsize
count_lines (const char *text, gsize length)
{
  gsize count = 0;
  for (gsize i = 0; i < length; i++)
    count += text[i] == '\n';
  return count;
}

static gsize
line_length (const char *line, const char *end)
{
  const char *newline = memchr (line, '\n', (gsize) (end - line));
  return (gsize) ((newline != NULL ? newline + 1 : end) - line);
}

/* Runs of differing lines of two texts with equally many lines. */
static void
diff_line_by_line (GArray *hunks, const char *before, gsize before_length,
                   const char *after, gsize after_length, gsize offset)
{
  const char *before_end = before + before_length, *after_end = after + after_length;
  const char *before_run = before, *after_run = after, *after_start = after;
  while (before < before_end || after < after_end) {
    gsize nb = line_length (before, before_end), na = line_length (after, after_end);
    gboolean same = nb == na && memcmp (before, after, nb) == 0;
    if (same && (before > before_run || after > after_run))
      add_hunk (hunks, before_run, (gsize) (before - before_run), after_run,
                (gsize) (after - after_run), offset + (gsize) (after_run - after_start));
    before += nb;
    after += na;
    if (same) {
      before_run = before;
      after_run = after;
    }
  }
  if (before > before_run || after > after_run)
    add_hunk (hunks, before_run, (gsize) (before - before_run), after_run,
              (gsize) (after - after_run), offset + (gsize) (after_run - after_start));
}

static GArray *
diff (const char *before, const char *after)
{
  GArray *hunks = hunks_new ();

  gsize nb = strlen (before), na = strlen (after), head = 0, tail = 0;
  while (head < nb && head < na && before[head] == after[head])
    head++;
  /* Whole lines only, so that the runs below compare line with line. */
  while (head > 0 && before[head - 1] != '\n')
    head--;
  while (tail < nb - head && tail < na - head
         && before[nb - 1 - tail] == after[na - 1 - tail])
    tail++;
  while (tail > 0 && tail < nb - head && tail < na - head
         && (before[nb - 1 - tail] != '\n' || after[na - 1 - tail] != '\n'))
    tail--;

  gsize middle_b = nb - head - tail, middle_a = na - head - tail;
  if (middle_b == 0 && middle_a == 0)
    return hunks;
  if (count_lines (before + head, middle_b) == count_lines (after + head, middle_a))
    diff_line_by_line (hunks, before + head, middle_b, after + head, middle_a, head);
  else
    add_hunk (hunks, before + head, middle_b, after + head, middle_a, head);
  return hunks;
}

/* The text on the other side of a step; NULL where the step does not fit to this one. */
static char *
apply (const QnEditStep *step, const char *at, gboolean forward)
{
  g_autoptr (GString) text = g_string_new (NULL);
  const gsize length = strlen (at);
  gsize read = 0;
  for (guint i = 0; i < step->hunks->len; i++) {
    const QnHunk *hunk = &g_array_index (step->hunks, QnHunk, i);
    const char *gone = forward ? hunk->removed : hunk->inserted;
    const gsize behind = forward ? text->len : read; /* a place after the edit */
    if (hunk->offset < behind || hunk->offset - behind > length - read)
      return NULL;
    const gsize kept = hunk->offset - behind;
    if (!g_str_has_prefix (at + read + kept, gone))
      return NULL;
    g_string_append_len (text, at + read, (gssize) kept);
    g_string_append (text, forward ? hunk->inserted : hunk->removed);
    read += kept + strlen (gone);
  }
  g_string_append (text, at + read);
  return g_string_free (g_steal_pointer (&text), FALSE);
}

/* Appends a step without hunks behind all others; does not move the position. */
static QnEditStep *
add_step (QnEditHistory *history, const char *name)
{
  QnEditStep *step = g_new0 (QnEditStep, 1);
  step->name = g_strdup (name);
  step->hunks = hunks_new ();
  g_ptr_array_add (history->steps, step);
  return step;
}

QnEditHistory *
qn_history_new (void)
{
  QnEditHistory *history = g_new0 (QnEditHistory, 1);
  history->steps = g_ptr_array_new_with_free_func (step_free);
  return history;
}

void
qn_history_free (QnEditHistory *history)
{
  if (history == NULL)
    return;
  g_ptr_array_unref (history->steps);
  g_free (history);
}

static gboolean
continues_gesture (const QnEditHistory *history, const char *key)
{
  if (key == NULL || history->broken || history->position == 0
      || history->position != history->steps->len
      || history->clean == (gint64) history->position)
    return FALSE;
  const QnEditStep *last = g_ptr_array_index (history->steps, history->position - 1);
  return g_strcmp0 (last->key, key) == 0;
}

void
qn_history_record (QnEditHistory *history, const char *name, const char *key,
                   const char *before, const char *after)
{
  if (history->position < history->steps->len) {
    if (history->clean > (gint64) history->position)
      history->clean = -1;
    g_ptr_array_set_size (history->steps, (int) history->position);
  }

  if (continues_gesture (history, key)) {
    QnEditStep *last = g_ptr_array_index (history->steps, history->position - 1);
    g_autofree char *first = apply (last, before, FALSE);
    g_array_unref (last->hunks);
    last->hunks = diff (first, after);
    return;
  }

  QnEditStep *step = add_step (history, name);
  step->key = g_strdup (key);
  g_array_unref (step->hunks);
  step->hunks = diff (before, after);
  history->position++;
  history->broken = FALSE;
}

void
qn_history_break (QnEditHistory *history)
{
  history->broken = TRUE;
}

char *
qn_history_go_to (QnEditHistory *history, const char *text, guint position)
{
  if (position > history->steps->len)
    return NULL;
  char *state = g_strdup (text);
  history->broken = TRUE;
  while (state != NULL && history->position != position) {
    const gboolean back = history->position > position;
    char *next =
      apply (history->steps->pdata[history->position - (back ? 1 : 0)], state, !back);
    g_free (state);
    state = next;
    history->position += back ? -1 : 1;
  }
  return state;
}

const char *
qn_history_get_name (const QnEditHistory *history, guint step)
{
  g_return_val_if_fail (step < history->steps->len, NULL);
  return ((const QnEditStep *) g_ptr_array_index (history->steps, step))->name;
}

/* ---- in a file: `history` in data/project-format.md ---- */

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
    for (guint k = 0; k < step->hunks->len; k++) {
      const QnHunk *hunk = &g_array_index (step->hunks, QnHunk, k);
      g_string_append (json, k > 0 ? ", [" : "[");
      qn_json_append_number (json, (double) hunk->offset);
      g_string_append (json, ", ");
      qn_json_append_string (json, hunk->removed);
      g_string_append (json, ", ");
      qn_json_append_string (json, hunk->inserted);
      g_string_append_c (json, ']');
    }
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
    QnEditStep *step = add_step (history, name->valuestring);
    cJSON_ArrayForEach (element, hunks)
    {
      if (!read_hunk (element, step))
        return FALSE;
    }
  }
  return TRUE;
}

/* Walks to both ends of the history to see that every step can be taken. */
static gboolean
try_steps (QnEditHistory *history, const char *text)
{
  const guint position = history->position, ends[] = { 0, history->steps->len };
  gboolean fit = TRUE;
  for (int i = 0; i < 2 && fit; i++) {
    g_autofree char *end = qn_history_go_to (history, text, ends[i]);
    fit = end != NULL;
    history->position = position;
  }
  return fit;
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
  history->clean = history->position;
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
