/* Where in a JSON text something stands. */
#pragma once

#include <glib.h>

/* Line and column of a byte offset, both from 1; the column counts characters. */
void qn_json_position (const char *text, gsize offset, gsize *line, gsize *column);

typedef struct QnJsonPlace {
  gsize line, column;
} QnJsonPlace;

/* Places of the values that these paths (char *, see json-path.h) lead to. Where a path leads to
 * nothing, that of the innermost value on the way that does exist: a missing key is reported at its
 * object. The text must be well-formed and NUL-terminated. One for each path; free with g_free(). */
QnJsonPlace *qn_json_locate_all (const char *text, gsize length, const GPtrArray *paths);

/* The same for one path. */
QnJsonPlace qn_json_locate (const char *text, gsize length, const char *path);
