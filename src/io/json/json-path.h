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

/* The one spelling of the steps of a path, as messages and the append functions write it. Free with
 * g_free(). */
char *qn_json_path_dup_text (const GArray *steps);

/* Append one step in that spelling. */
void qn_json_path_append_key (GString *path, const char *key);
void qn_json_path_append_index (GString *path, gsize index);

/* Whether `path` is `ancestor` or leads to something inside it; both as written by the
 * append functions. */
gboolean qn_json_path_is_within (const char *path, const char *ancestor);
