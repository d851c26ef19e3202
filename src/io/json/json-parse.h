/* JSON text to a cJSON tree, strictly: what json-scan.h accepts, no key twice in one object.
 *
 * The parser of cJSON reports no lines, does not distinguish lack of memory from bad input, and
 * reads numbers in the locale of the process. So only its tree is used.
 */
#ifndef QN_IO_JSON_PARSE_H
#define QN_IO_JSON_PARSE_H

#include <cjson/cJSON.h>
#include <glib.h>

typedef struct QnJsonProblem {
  gboolean no_memory;  /* an allocation failed; nothing else is set */
  const char *message; /* a translated sentence */
  gsize offset;        /* byte where */
  char *path;          /* of the innermost value concerned; free with g_free() */
} QnJsonProblem;

/* `text` is NUL-terminated behind `length` bytes. NULL with *problem filled on failure; free
 * the tree with cJSON_Delete(). Numbers beyond the range of a double are infinite. */
cJSON *qn_json_parse (const char *text, gsize length, QnJsonProblem *problem);

/* A problem as an error of the file `name`: "wall.quoin:3:9: laws[0]: …". */
GError *qn_json_problem_to_error (const QnJsonProblem *problem, const char *name,
                                  const char *text);

#endif
