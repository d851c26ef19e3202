/* The tokens of a JSON text (RFC 8259), strictly, in one array, for all readers of JSON.
 *
 * The text is not copied: large files are read straight into arrays. Token 0 is the value of the text;
 * the items of a container follow it, and `next` of each is the item behind it:
 *
 *   for (gsize i = at + 1; i < json.tokens[at].next; i = json.tokens[i].next)
 *     … element i of an array, or key i of an object, whose value is token i + 1 …
 */
#pragma once

#include <glib.h>

/* Deepest nesting of arrays and objects: ten times that of our formats, small enough for recursion. */
#define QN_JSON_MAX_DEPTH 100

typedef enum {
  QN_JSON_OBJECT,
  QN_JSON_ARRAY,
  QN_JSON_KEY,
  QN_JSON_STRING,
  QN_JSON_NUMBER,
  QN_JSON_TRUE,
  QN_JSON_FALSE,
  QN_JSON_NULL
} QnJsonType;

typedef struct QnJsonToken {
  gsize start;  /* byte; of strings and keys that of the quote */
  guint32 next; /* token behind this one and all in it; 0: the text is wrong inside it */
  QnJsonType type;
} QnJsonToken;

typedef struct QnJson {
  const char *text; /* borrowed */
  const char *name; /* of the file, for messages; borrowed */
  QnJsonToken *tokens;
  gsize count, capacity;
  gsize trouble; /* byte where the text is wrong */
  GError *error; /* the first one; domain QN_IO_ERROR. qn_json_clear() frees it */
} QnJson;

/* `text` must have a NUL byte behind its last byte and outlive the tokens. A byte order mark at its
 * start is skipped. FALSE with json->error where it is not JSON; always to be cleared. */
gboolean qn_json_scan (QnJson *json, const char *text, gsize length, const char *name);
void qn_json_clear (QnJson *json);

/* Token of a member's value; 0 where there is none. */
gsize qn_json_member (const QnJson *json, gsize at, const char *key);

/* Number of elements or members of a container. */
gsize qn_json_count (const QnJson *json, gsize at);

/* Value of a NUMBER; infinite beyond the range of a double. */
double qn_json_number (const QnJson *json, gsize at);

/* Text of a STRING or KEY with escapes resolved, free with g_free(); whether it equals `text`. */
char *qn_json_dup_string (const QnJson *json, gsize at);
gboolean qn_json_string_is (const QnJson *json, gsize at, const char *text);

/* Of any text: length in bytes, with its quotes, of the string that begins at `quoted`; 0: no string.
 * And its value; free with g_free(). */
gsize qn_json_string_length (const char *quoted);
char *qn_json_unescape (const char *quoted);

/* The path of the value at a token (see json-path.h); free with g_free(). */
char *qn_json_dup_path (const QnJson *json, gsize at);

/* Keeps an error at a token, "wall.quoin:3:9: laws[0]: …", unless there is one already; returns FALSE.
 * The next is for a member that an object does not have, the last for lack of memory. */
gboolean qn_json_fail (QnJson *json, gsize at, const char *message);
gboolean qn_json_failf (QnJson *json, gsize at, const char *format, ...)
  G_GNUC_PRINTF (3, 4);
gboolean qn_json_fail_missing (QnJson *json, gsize at, const char *key);
gboolean qn_json_no_memory (QnJson *json);
