#include "doc/document/history.h"
#include "support/room.h"

#include <string.h>

/* Takes a step and moves on to the new text. */
static void
record (QnEditHistory *history, const char *name, const char *key, char **text,
        const char *next)
{
  qn_history_record (history, name, key, *text, next);
  g_free (*text);
  *text = g_strdup (next);
}

static void
walk (QnEditHistory *history, gboolean back, char **text)
{
  const guint position = history->position;
  char *next = qn_history_go_to (history, *text, back ? position - 1 : position + 1);
  g_assert_nonnull (next);
  g_free (*text);
  *text = next;
}

static void
test_texts_come_back (void)
{
  static const char *const states[] = { "",
                                        "a\nb\nc\n",
                                        "a\nB\nc\n",
                                        "a\nB\nc\nd\n",
                                        "X\nB\nc\nY\n",
                                        "",
                                        "no line end",
                                        "no line end\nbut here\n",
                                        "ü\nß\n",
                                        "ü\nÜ\nß\n",
                                        "\n\n\n",
                                        "\n\n" };
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup (states[0]);
  for (gsize i = 1; i < G_N_ELEMENTS (states); i++)
    record (history, "step", NULL, &text, states[i]);
  for (int round = 0; round < 3; round++) {
    for (gsize i = G_N_ELEMENTS (states) - 1; i > 0; i--) {
      g_assert_cmpstr (text, ==, states[i]);
      walk (history, TRUE, &text);
    }
    g_assert_cmpstr (text, ==, states[0]);
    g_assert_false (history->position > 0);
    g_assert_null (qn_history_go_to (history, text, G_N_ELEMENTS (states)));
    for (gsize i = 1; i < G_N_ELEMENTS (states); i++) {
      walk (history, FALSE, &text);
      g_assert_cmpstr (text, ==, states[i]);
    }
    g_assert_false (history->position < history->steps->len);
  }
  qn_history_free (history);
}

/* Random edits of a text of lines, so that every kind of difference is met. */
static char *
mutate (GRand *rand, const char *text)
{
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  guint count = g_strv_length (lines);
  GString *made = g_string_new (NULL);
  for (guint i = 0; i < count; i++) {
    int dice = g_rand_int_range (rand, 0, 20);
    if (dice == 0)
      continue;
    if (dice == 1)
      g_string_append_printf (made, "%u\n", g_rand_int (rand));
    if (dice == 2)
      g_string_append_printf (made, "%s!", lines[i]);
    else
      g_string_append (made, lines[i]);
    if (i + 1 < count)
      g_string_append_c (made, '\n');
  }
  return g_string_free (made, FALSE);
}

static void
test_random_edits (void)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (42);
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup ("one\ntwo\nthree\nfour\nfive\nsix\nseven\neight\n");
  g_autoptr (GPtrArray) states = g_ptr_array_new_with_free_func (g_free);
  g_ptr_array_add (states, g_strdup (text));
  for (int i = 0; i < 500; i++) {
    g_autofree char *next = mutate (rand, text);
    record (history, "step", NULL, &text, next);
    g_ptr_array_add (states, g_strdup (next));
  }
  for (guint i = states->len - 1; i > 0; i--) {
    walk (history, TRUE, &text);
    g_assert_cmpstr (text, ==, g_ptr_array_index (states, i - 1));
  }
  for (guint i = 1; i < states->len; i++) {
    walk (history, FALSE, &text);
    g_assert_cmpstr (text, ==, g_ptr_array_index (states, i));
  }
  qn_history_free (history);
}

static void
test_new_step_forgets_undone_ones (void)
{
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup ("0\n");
  record (history, "first", NULL, &text, "1\n");
  record (history, "second", NULL, &text, "2\n");
  walk (history, TRUE, &text);
  record (history, "other", NULL, &text, "3\n");
  g_assert_cmpuint (history->steps->len, ==, 2);
  g_assert_cmpstr (qn_history_get_name (history, 1), ==, "other");
  g_assert_false (history->position < history->steps->len);
  qn_history_free (history);
}

static void
test_gesture_is_one_step (void)
{
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup ("0\n");
  record (history, "Nudge", "nudge", &text, "1\n");
  record (history, "Nudge", "nudge", &text, "2\n");
  record (history, "Nudge", "nudge", &text, "3\n");
  g_assert_cmpuint (history->steps->len, ==, 1);
  qn_history_break (history);
  record (history, "Nudge", "nudge", &text, "4\n");
  g_assert_cmpuint (history->steps->len, ==, 2);
  walk (history, TRUE, &text);
  walk (history, TRUE, &text);
  g_assert_cmpstr (text, ==, "0\n");
  qn_history_free (history);
}

static void
test_clean_state (void)
{
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup ("0\n");
  g_assert_true (history->clean == history->position);
  record (history, "a", "key", &text, "1\n");
  g_assert_false (history->clean == history->position);
  history->clean = history->position;
  /* A gesture does not continue across a save. */
  record (history, "a", "key", &text, "2\n");
  g_assert_cmpuint (history->steps->len, ==, 2);
  g_assert_false (history->clean == history->position);
  walk (history, TRUE, &text);
  g_assert_true (history->clean == history->position);
  walk (history, TRUE, &text);
  g_assert_false (history->clean == history->position);
  /* The clean state is forgotten with the steps that led to it. */
  record (history, "b", NULL, &text, "7\n");
  g_assert_false (history->clean == history->position);
  walk (history, TRUE, &text);
  g_assert_false (history->clean == history->position);
  qn_history_free (history);
}

/* A step costs what it changed, not the size of the project. */
static void
test_size (void)
{
  g_autoptr (GString) long_text = g_string_new (NULL);
  for (int i = 0; i < 10000; i++)
    g_string_append_printf (long_text, "block %d\n", i);
  QnEditHistory *history = qn_history_new ();
  g_autofree char *text = g_strdup (long_text->str);
  for (int i = 0; i < 100; i++) {
    /* Two far places at once. */
    g_autoptr (GString) next = g_string_new (text);
    g_string_overwrite (next, 6, i % 2 == 0 ? "x" : "y");
    g_string_overwrite (next, next->len - 2, i % 2 == 0 ? "x" : "y");
    record (history, "two places", NULL, &text, next->str);
  }
  g_autofree char *json = qn_history_to_json (history, text);
  g_assert_cmpuint (strlen (json), <, 100 * 400);
  for (int i = 0; i < 100; i++)
    walk (history, TRUE, &text);
  g_assert_cmpstr (text, ==, long_text->str);
  qn_history_free (history);
}

QN_TESTS
{
  g_test_add_func ("/doc/history/texts-come-back", test_texts_come_back);
  g_test_add_func ("/doc/history/random-edits", test_random_edits);
  g_test_add_func ("/doc/history/new-step-forgets", test_new_step_forgets_undone_ones);
  g_test_add_func ("/doc/history/gesture", test_gesture_is_one_step);
  g_test_add_func ("/doc/history/clean", test_clean_state);
  g_test_add_func ("/doc/history/size", test_size);
}
