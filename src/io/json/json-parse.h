/* A JSON text (RFC 8259), strictly, as a tree. */
#pragma once

#include <cjson/cJSON.h>
#include <glib.h>

/* Deepest nesting of arrays and objects: ten times that of our formats, small enough for recursion. */
#define QN_JSON_MAX_DEPTH 100

/* `text` is NUL-terminated behind `length` bytes; a byte order mark at its start is skipped. NULL on failure
 * with an error of the file `name`: "wall.quoin:3:9: laws[0]: …" (QN_IO_ERROR). Free the tree with
 * cJSON_Delete(). Numbers beyond the range of a double are infinite. `valueint` of every value is the byte where
 * it begins in the text. */
cJSON *qn_json_parse (const char *text, gsize length, const char *name, GError **error);

/* Of any text: length in bytes, with its quotes, of the string that begins at `quoted`; 0: no string.
 * And its value with escapes resolved; free with g_free(). */
gsize qn_json_string_length (const char *quoted);
char *qn_json_unescape (const char *quoted);
