/* JSON text to a cJSON tree, strictly: what json-tokens.h accepts, no key twice in one object.
 *
 * The parser of cJSON reports no lines, does not distinguish lack of memory from bad input, and
 * reads numbers in the locale of the process. So only its tree is used.
 */
#pragma once

#include <cjson/cJSON.h>
#include <glib.h>

/* `text` is NUL-terminated behind `length` bytes. NULL on failure with an error of the file `name`:
 * "wall.quoin:3:9: laws[0]: …" (QN_IO_ERROR). Free the tree with cJSON_Delete(). Numbers beyond the
 * range of a double are infinite. */
cJSON *qn_json_parse (const char *text, gsize length, const char *name, GError **error);
