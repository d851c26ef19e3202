/* Paths to values inside a JSON document: blocks[3].vertices[0].
 *
 * A key that holds a separator or a line break is written in brackets as JSON: ["a.b"].
 */
#pragma once

#include <glib.h>

typedef struct QnJsonStep {
  char *key;   /* member of an object, or NULL: */
  gsize index; /* element of an array */
} QnJsonStep;

/* Array of QnJsonStep, or NULL where the text is no path. The empty text is the path of the
 * document itself. Free with g_array_unref(). */
GArray *qn_json_path_parse (const char *text);

/* The one spelling of the steps of a path, as messages and qn_json_path_append() write it. Free
 * with g_free(). */
char *qn_json_path_dup_text (const GArray *steps);

/* Appends one step in that spelling: a key or, where it is NULL, an index. */
void qn_json_path_append (GString *path, const char *key, gsize index);

/* Whether `path` is `ancestor` or leads to something inside it; both as
 * qn_json_path_append() writes them. */
gboolean qn_json_path_is_within (const char *path, const char *ancestor);

/* Both from 1; the column counts characters. */
typedef struct QnJsonPlace {
  gsize line, column;
} QnJsonPlace;

/* The place of a byte offset. */
QnJsonPlace qn_json_position (const char *text, gsize offset);

/* Places of the values that these paths (char *, see json-path.h) lead to. Where a path leads to
 * nothing, that of the innermost value on the way that does exist: a missing key is reported at its
 * object. The text must be well-formed and NUL-terminated. One for each path; free with g_free(). */
QnJsonPlace *qn_json_locate_all (const char *text, gsize length, const GPtrArray *paths);

/* The same for one path. */
QnJsonPlace qn_json_locate (const char *text, gsize length, const char *path);
