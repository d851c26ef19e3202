#include "doc/document/history-private.h"

#include <string.h>

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

static char *
apply (const QnEditStep *step, const char *at, gboolean forward)
{
  GString *text = g_string_new (NULL);
  gsize read = 0;
  for (guint i = 0; i < step->hunks->len; i++) {
    const QnHunk *hunk = &g_array_index (step->hunks, QnHunk, i);
    gsize kept = hunk->offset - (forward ? text->len : read); /* a place after the edit */
    g_string_append_len (text, at + read, (gssize) kept);
    g_string_append (text, forward ? hunk->inserted : hunk->removed);
    read += kept + strlen (forward ? hunk->removed : hunk->inserted);
  }
  g_string_append (text, at + read);
  return g_string_free (text, FALSE);
}

QnEditStep *
qn_history_add_step (QnEditHistory *history, const char *name)
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

  QnEditStep *step = qn_history_add_step (history, name);
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

gboolean
qn_history_can_undo (const QnEditHistory *history)
{
  return history->position > 0;
}

gboolean
qn_history_can_redo (const QnEditHistory *history)
{
  return history->position < history->steps->len;
}

char *
qn_history_undo (QnEditHistory *history, const char *text)
{
  if (!qn_history_can_undo (history))
    return NULL;
  history->broken = TRUE;
  return apply (g_ptr_array_index (history->steps, --history->position), text, FALSE);
}

char *
qn_history_redo (QnEditHistory *history, const char *text)
{
  if (!qn_history_can_redo (history))
    return NULL;
  history->broken = TRUE;
  return apply (g_ptr_array_index (history->steps, history->position++), text, TRUE);
}

guint
qn_history_get_count (const QnEditHistory *history)
{
  return history->steps->len;
}

guint
qn_history_get_position (const QnEditHistory *history)
{
  return history->position;
}

const char *
qn_history_get_name (const QnEditHistory *history, guint step)
{
  g_return_val_if_fail (step < history->steps->len, NULL);
  return ((const QnEditStep *) g_ptr_array_index (history->steps, step))->name;
}

void
qn_history_mark_clean (QnEditHistory *history)
{
  history->clean = history->position;
}

gboolean
qn_history_is_clean (const QnEditHistory *history)
{
  return history->clean == (gint64) history->position;
}
