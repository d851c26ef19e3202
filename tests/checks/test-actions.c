/* Every action that menus, buttons, sources and tests name is one of the program or its windows. */
#include "source-tree.h"
#include "support/room.h"

/* Names of actions in a text, without their parameters, each after a character that no name has. */
static void
collect_names (const char *text, GHashTable *names)
{
  g_autoptr (GRegex) regex =
    g_regex_new ("[\">'](app|win)\\.[a-z][a-z-]*", G_REGEX_DEFAULT, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  for (g_regex_match (regex, text, 0, &match); g_match_info_matches (match);
       g_match_info_next (match, NULL)) {
    g_autofree char *found = g_match_info_fetch (match, 0);
    g_hash_table_add (names, g_strdup (found + 1));
  }
}

static void
check_text (GHashTable *known, const char *path, const char *text, GString *complaints)
{
  g_autoptr (GHashTable) names =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  collect_names (text, names);
  GHashTableIter iter;
  gpointer name;
  g_hash_table_iter_init (&iter, names);
  while (g_hash_table_iter_next (&iter, &name, NULL))
    if (!g_hash_table_contains (known, name))
      complain (complaints, "%s names the unknown action %s", path, (char *) name);
}

/* Words that begin the rows of arrays, and rows that are words alone. */
static void
collect_rows (const char *text, const char *prefix, GHashTable *names)
{
  g_autoptr (GRegex) array =
    g_regex_new ("\\[\\] = \\{(.*?)\n?\\};", G_REGEX_DOTALL, 0, NULL);
  g_autoptr (GRegex) word =
    g_regex_new ("[{,]\\s*(?:\\.name = )?\"([a-z][a-z-]+)\"", 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  for (g_regex_match (array, text, 0, &match); g_match_info_matches (match);
       g_match_info_next (match, NULL)) {
    g_autofree char *rows = g_match_info_fetch (match, 0);
    g_autoptr (GMatchInfo) inner = NULL;
    for (g_regex_match (word, rows, 0, &inner); g_match_info_matches (inner);
         g_match_info_next (inner, NULL)) {
      g_autofree char *name = g_match_info_fetch (inner, 1);
      g_hash_table_add (names, g_strconcat (prefix, name, NULL));
    }
  }
}

/* Those of windows, of the program, and GTK's that have keys. */
static GHashTable *
known_actions (void)
{
  static const char *const suffixes[] = { ".c", NULL };
  GHashTable *known = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  g_autoptr (GPtrArray) files = source_tree_files ("src/app/window", suffixes);
  for (guint i = 0; i < files->len; i++) {
    g_autofree char *text = source_tree_read (files->pdata[i]);
    if (g_str_has_suffix (files->pdata[i], "action-table.c"))
      collect_names (text, known);
    else
      collect_rows (text, strstr (files->pdata[i], "application") ? "app." : "win.",
                    known);
  }
  return known;
}

static void
test_actions (void)
{
  static const char *const suffixes[] = { ".c", ".h", ".ui", NULL };
  static const char *const folders[] = { "src/app", "ui", "tests/app" };
  g_autoptr (GHashTable) known = known_actions ();
  g_assert_cmpuint (g_hash_table_size (known), >, 50);
  GString *complaints = g_string_new (NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++) {
    g_autoptr (GPtrArray) files = source_tree_files (folders[i], suffixes);
    for (guint k = 0; k < files->len; k++) {
      const char *path = g_ptr_array_index (files, k);
      g_autofree char *text = source_tree_read (path);
      check_text (known, path, text, complaints);
    }
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  g_autoptr (GHashTable) known = known_actions ();
  GString *complaints = g_string_new (NULL);
  check_text (known, "a.ui", "<property name=\"action-name\">win.sav</property>",
              complaints);
  assert_complaint (complaints, "unknown action win.sav");

  complaints = g_string_new (NULL);
  check_text (known, "a.c", "activate (\"win.view::model\"); f (\"app.quit\")",
              complaints);
  assert_no_complaints (complaints);
}

QN_TESTS
{
  g_test_add_func ("/checks/actions/known", test_actions);
  g_test_add_func ("/checks/actions/can-fail", test_check_can_fail);
}
