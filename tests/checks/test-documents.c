/* Documents: lines that fit a page, links that lead somewhere, and plain English, which comments of
 * the source are held to as well. */
#include "source-tree.h"
#include "support/room.h"

#include <string.h>

enum { LONGEST_LINE = 100 };

/* Figures of speech and idioms, with the plain term. Put together at run time, so that this file
 * does not contain what it looks for. */
static const char *const idioms[][3] = {
  { "made up ", "its mind", "decided" },
  { "made up ", "their minds", "decided" },
  { "make up ", "their minds", "are decided" },
  { "changed ", "their minds", "changed state" },
  { "changed ", "its mind", "changed state" },
  { "slip of ", "the pen", "input error" },
  { "wish to ", "stop", "cancellation" },
  { "may ", "strike", "may happen" },
  { "can ", "strike", "can happen" },
  { "goes ", "astray", "diverges" },
  { "go ", "astray", "diverge" },
  { "loses ", "its way", "diverges" },
  { "lost ", "their way", "diverged" },
  { "runs ", "back", "snaps back" },
  { "run ", "back", "snap back" },
  { "in ", "circles", "in a cycle" },
  { "by ", "a hair", "just" },
  { "of second ", "hand", "from a secondary source" },
  { "neither here ", "nor there", "undecided" },
  { "nearly as ", "dear", "nearly as expensive" },
  { "is ", "dear", "is expensive" },
  { "are ", "dear", "are expensive" },
  { "dear", "er ", "more expensive" },
  { "dear", "est", "most expensive" },
  { "knows ", "nothing of", "does not depend on" },
  { "a", "sleep", "inactive" },
  { "a", "wake", "active" },
};

static char *
join (const char *const parts[3])
{
  return g_strconcat (parts[0], parts[1], NULL);
}

static void
check_words (const char *path, const char *text, GString *complaints)
{
  g_autofree char *lower = g_ascii_strdown (text, -1);
  /* A phrase may be broken by the end of a line. */
  g_auto (GStrv) words = g_strsplit_set (lower, " \n\t*", -1);
  g_autoptr (GString) plain = g_string_new (" ");
  for (int i = 0; words[i] != NULL; i++)
    if (words[i][0] != '\0')
      g_string_append_printf (plain, "%s ", words[i]);

  for (size_t i = 0; i < G_N_ELEMENTS (idioms); i++) {
    g_autofree char *idiom = join (idioms[i]);
    g_autofree char *whole = g_strconcat (" ", idiom, NULL);
    if (strstr (plain->str, whole) != NULL)
      complain (complaints, "%s: '%s': say '%s'", path, idiom, idioms[i][2]);
  }
}

/* Tables and the marks of generated ones cannot be broken. */
static void
check_lengths (const char *path, char **lines, GString *complaints)
{
  for (int i = 0; lines[i] != NULL; i++)
    if (g_utf8_strlen (lines[i], -1) > LONGEST_LINE && lines[i][0] != '|'
        && !g_str_has_prefix (lines[i], "<!--"))
      complain (complaints, "%s:%d: line of %ld characters", path, i + 1,
                g_utf8_strlen (lines[i], -1));
}

/* What a heading is called in a link: lower case, hyphens for blanks, nothing else but letters,
 * digits and underscores. */
static char *
anchor_of (const char *heading)
{
  GString *anchor = g_string_new (NULL);
  while (*heading == '#' || *heading == ' ')
    heading++;
  for (; *heading != '\0'; heading = g_utf8_next_char (heading)) {
    gunichar c = g_unichar_tolower (g_utf8_get_char (heading));
    if (c == ' ' || c == '-')
      g_string_append_c (anchor, '-');
    else if (g_unichar_isalnum (c) || c == '_')
      g_string_append_unichar (anchor, c);
  }
  return g_string_free (anchor, FALSE);
}

static gboolean
has_anchor (const char *path, const char *anchor)
{
  g_auto (GStrv) lines = source_tree_lines (path);
  for (int i = 0; lines[i] != NULL; i++) {
    g_autofree char *own = lines[i][0] == '#' ? anchor_of (lines[i]) : NULL;
    if (g_strcmp0 (own, anchor) == 0)
      return TRUE;
  }
  return FALSE;
}

static void
check_link (const char *path, const char *target, GString *complaints)
{
  g_auto (GStrv) parts = g_strsplit (target, "#", 2);
  g_autofree char *folder = g_path_get_dirname (path);
  g_autofree char *file = parts[0] == NULL || parts[0][0] == '\0'
                            ? g_strdup (path)
                            : g_build_filename (folder, parts[0], NULL);
  g_autofree char *full = g_build_filename (source_tree_root (), file, NULL);

  if (strstr (target, "://") != NULL || g_str_has_prefix (target, "mailto:"))
    return;
  if (!g_file_test (full, G_FILE_TEST_EXISTS))
    complain (complaints, "%s: link to %s, which does not exist", path, target);
  else if (g_strv_length (parts) == 2 && g_str_has_suffix (file, ".md")
           && !has_anchor (file, parts[1]))
    complain (complaints, "%s: link to %s, but there is no such heading", path, target);
}

static void
check_links (const char *path, const char *text, GString *complaints)
{
  g_autoptr (GRegex) link = g_regex_new ("\\]\\(([^)\\s]+)\\)", 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  for (g_regex_match (link, text, 0, &match); g_match_info_matches (match);
       g_match_info_next (match, NULL)) {
    g_autofree char *target = g_match_info_fetch (match, 1);
    check_link (path, target, complaints);
  }
}

/* The text of a source file without code: comments and strings. Enough of the language is known to
 * tell them apart from code where a line begins with neither. */
static char *
comments_of (const char *text)
{
  GString *comments = g_string_new (NULL);
  for (const char *at = text; (at = strstr (at, "/*")) != NULL;) {
    const char *end = strstr (at, "*/");
    if (end == NULL)
      break;
    g_string_append_len (comments, at + 2, end - at - 2);
    g_string_append (comments, " . ");
    at = end + 2;
  }
  return g_string_free (comments, FALSE);
}

/* All documents: below the folders that hold sources and data, and those at the root itself. */
static GPtrArray *
documents (void)
{
  static const char *const suffixes[] = { ".md", NULL };
  static const char *const folders[] = { "data", "docs", "examples", "src", "tests" };
  static const char *const single[] = { "README.md", "CONTRIBUTING.md", "CHANGELOG.md" };
  GPtrArray *files = g_ptr_array_new_with_free_func (g_free);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++)
    g_ptr_array_extend_and_steal (files, source_tree_files (folders[i], suffixes));
  for (size_t i = 0; i < G_N_ELEMENTS (single); i++) {
    g_autofree char *full = g_build_filename (source_tree_root (), single[i], NULL);
    if (g_file_test (full, G_FILE_TEST_EXISTS))
      g_ptr_array_add (files, g_strdup (single[i]));
  }
  return files;
}

static void
test_documents (void)
{
  GString *complaints = g_string_new (NULL);
  g_autoptr (GPtrArray) files = documents ();
  g_assert_cmpint (files->len, >, 10);
  for (guint i = 0; i < files->len; i++) {
    const char *path = g_ptr_array_index (files, i);
    g_autofree char *text = source_tree_read (path);
    g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
    check_lengths (path, lines, complaints);
    check_links (path, text, complaints);
    check_words (path, text, complaints);
  }
  assert_no_complaints (complaints);
}

static void
test_comments (void)
{
  static const char *const suffixes[] = { ".c", ".h", NULL };
  static const char *const folders[] = { "src", "tests" };
  GString *complaints = g_string_new (NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (folders); i++) {
    g_autoptr (GPtrArray) files = source_tree_files (folders[i], suffixes);
    for (guint k = 0; k < files->len; k++) {
      const char *path = g_ptr_array_index (files, k);
      g_autofree char *text = source_tree_read (path);
      g_autofree char *comments = comments_of (text);
      check_words (path, comments, complaints);
    }
  }
  assert_no_complaints (complaints);
}

static void
test_check_can_fail (void)
{
  for (size_t i = 0; i < G_N_ELEMENTS (idioms); i++) {
    g_autofree char *idiom = join (idioms[i]);
    g_autofree char *text = g_strdup_printf ("It %s indeed.", idiom);
    g_autofree char *broken = g_strdelimit (g_strdup (text), " ", '\n');
    GString *plain = g_string_new (NULL), *over_lines = g_string_new (NULL);
    check_words ("a.md", text, plain);
    assert_complaint (plain, idioms[i][2]);
    check_words ("a.md", broken, over_lines);
    assert_complaint (over_lines, idioms[i][2]);
  }

  g_autofree char *line = g_strnfill (LONGEST_LINE, 'x');
  g_autofree char *longer = g_strconcat (line, "x", NULL);
  g_autofree char *row = g_strconcat ("|", line, NULL);
  char *fit[] = { line, row, NULL }, *too_long[] = { longer, NULL };
  GString *content = g_string_new (NULL), *lengths = g_string_new (NULL);
  check_lengths ("a.md", fit, content);
  assert_no_complaints (content);
  check_lengths ("a.md", too_long, lengths);
  assert_complaint (lengths, "line of 101");

  GString *good = g_string_new (NULL), *nowhere = g_string_new (NULL),
          *heading = g_string_new (NULL);
  check_links ("docs/README.md",
               "[a](../README.md) [b](../tests/README.md#tests) [c](https://gnu.org/)",
               good);
  assert_no_complaints (good);
  check_links ("README.md", "[a](docs/none.md)", nowhere);
  assert_complaint (nowhere, "does not exist");
  check_links ("README.md", "[a](tests/README.md#none)", heading);
  assert_complaint (heading, "no such heading");

  g_autofree char *comments = comments_of ("int a; /* one */ /* two\n * three */ b");
  g_assert_cmpstr (comments, ==, " one  .  two\n * three  . ");
}

QN_TESTS
{
  g_test_add_func ("/checks/documents/tree", test_documents);
  g_test_add_func ("/checks/documents/comments", test_comments);
  g_test_add_func ("/checks/documents/can-fail", test_check_can_fail);
}
