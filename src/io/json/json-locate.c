#include "io/json/json-locate.h"

#include "io/json/json-path.h"
#include "io/json/json-scan.h"

#include <string.h>

/* From the beginning of a container to the beginning of the value that `step` names in it. */
static gboolean
enter (QnJsonScanner *scanner, const QnJsonStep *step)
{
  QnJsonToken wanted = step->key != NULL ? QN_JSON_BEGIN_OBJECT : QN_JSON_BEGIN_ARRAY;
  if (scanner->token != wanted)
    return FALSE;

  for (gsize index = 0;; index++) {
    QnJsonToken token = qn_json_next (scanner);
    if (token == QN_JSON_END_OBJECT || token == QN_JSON_END_ARRAY
        || token == QN_JSON_ERROR)
      return FALSE;
    gboolean found = index == step->index;
    if (step->key != NULL) {
      found = qn_json_string_is (scanner, step->key);
      qn_json_next (scanner);
    }
    if (found)
      return scanner->token != QN_JSON_ERROR;
    if (!qn_json_skip (scanner))
      return FALSE;
  }
}

/* Goes to the value that a path leads to, or as far as there is one: *offset is where that value
 * begins. FALSE where the path leads further. */
static gboolean
follow (QnJsonScanner *scanner, const char *path, gsize *offset)
{
  qn_json_next (scanner);
  *offset = scanner->start;

  GArray *steps = qn_json_path_parse (path);
  gboolean there = steps != NULL;
  for (guint i = 0; there && i < steps->len; i++) {
    there = enter (scanner, &g_array_index (steps, QnJsonStep, i));
    if (there)
      *offset = scanner->start;
  }
  if (steps != NULL)
    g_array_unref (steps);
  return there;
}

gsize
qn_json_locate (const char *text, gsize length, const char *path)
{
  QnJsonScanner scanner;
  gsize offset;
  qn_json_scanner_init (&scanner, text, length);
  follow (&scanner, path, &offset);
  return offset;
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

void
qn_json_position (const char *text, gsize offset, gsize *line, gsize *column)
{
  QnJsonPlace place = { 1, 1 };
  advance (text, 0, offset, &place);
  *line = place.line;
  *column = place.column;
}

/* One pass through a text: `path` is where it is, `wanted` has the paths that are looked for and
 * those on the way to them, each with its QnJsonPlace once that is known. */
typedef struct Pass {
  QnJsonScanner scanner;
  GString *path;
  GHashTable *wanted;
  gsize known; /* offset of `place` */
  QnJsonPlace place;
} Pass;

/* Notes the value that the current token begins, and those in it where any of them is wanted. */
static gboolean
note_value (Pass *pass)
{
  QnJsonScanner *scanner = &pass->scanner;
  gpointer key;
  if (!g_hash_table_lookup_extended (pass->wanted, pass->path->str, &key, NULL))
    return qn_json_skip (scanner);
  advance (scanner->text, pass->known, scanner->start, &pass->place);
  pass->known = scanner->start;
  g_hash_table_replace (pass->wanted, g_strdup (key),
                        g_memdup2 (&pass->place, sizeof pass->place));
  if (scanner->token != QN_JSON_BEGIN_OBJECT && scanner->token != QN_JSON_BEGIN_ARRAY)
    return scanner->token != QN_JSON_ERROR;
  for (gsize index = 0, length = pass->path->len;; index++) {
    QnJsonToken token = qn_json_next (scanner);
    if (token == QN_JSON_END_OBJECT || token == QN_JSON_END_ARRAY)
      return TRUE;
    if (token == QN_JSON_KEY) {
      g_autofree char *name = qn_json_dup_string (scanner);
      qn_json_path_append_key (pass->path, name);
      qn_json_next (scanner);
    } else {
      qn_json_path_append_index (pass->path, index);
    }
    if (scanner->token == QN_JSON_ERROR || !note_value (pass))
      return FALSE;
    g_string_truncate (pass->path, length);
  }
}

/* Cuts the last step off a path; FALSE where there is none. */
static gboolean
leave (char *path)
{
  GArray *steps = qn_json_path_parse (path);
  gboolean deeper = steps != NULL && steps->len > 0;
  if (deeper) {
    g_array_set_size (steps, steps->len - 1);
    g_autofree char *parent = qn_json_path_dup_text (steps);
    strcpy (path, parent);
  }
  if (steps != NULL)
    g_array_unref (steps);
  return deeper;
}

QnJsonPlace *
qn_json_locate_all (const char *text, gsize length, const GPtrArray *paths)
{
  Pass pass = { .path = g_string_new (NULL), .place = { 1, 1 } };
  pass.wanted = g_hash_table_new_full (g_str_hash, g_str_equal, g_free, g_free);
  for (guint i = 0; i < paths->len; i++) {
    g_autofree char *path = g_strdup (paths->pdata[i]);
    do
      if (!g_hash_table_insert (pass.wanted, g_strdup (path), NULL))
        break;
    while (leave (path));
  }
  qn_json_scanner_init (&pass.scanner, text, length);
  qn_json_next (&pass.scanner);
  note_value (&pass);

  QnJsonPlace *places = g_new (QnJsonPlace, paths->len + 1);
  for (guint i = 0; i < paths->len; i++) {
    g_autofree char *path = g_strdup (paths->pdata[i]);
    const QnJsonPlace *place;
    while ((place = g_hash_table_lookup (pass.wanted, path)) == NULL && leave (path))
      ;
    places[i] = place != NULL ? *place : (QnJsonPlace){ 1, 1 };
  }
  g_hash_table_unref (pass.wanted);
  g_string_free (pass.path, TRUE);
  return places;
}
