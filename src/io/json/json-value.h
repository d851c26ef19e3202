/* Reading values from a JSON tree, with errors that name the line, the column and the key.
 *
 * A QnJsonValue is a value together with the path to it. Such values live on the stack of the
 * functions that read; each points to the one that it was reached from. The text of the path, and
 * the line and column, are made only when something is wrong.
 */
#pragma once

#include "core/base/numbers.h"
#include "core/base/status.h"
#include "io/json/json-path.h"

#include <cjson/cJSON.h>
#include <glib.h>

/* One reading of a document. */
typedef struct QnReader {
  const char *name; /* what messages call the file */
  const char *text; /* nullable: no lines and columns then */
  gsize length;
  gboolean any_size;            /* numbers may be larger than those of a project */
  const char *const *overrides; /* nullable */
  GPtrArray *warnings;          /* of char *; NULL: not collected */
  guint dropped_warnings;       /* beyond QN_READER_MAX_WARNINGS */
  GError *error;                /* the first one; domain QN_IO_ERROR */
  gboolean refuses_unknown;     /* unknown members are errors; or */
  gboolean keeps_unknown;       /* they are put aside: */
  cJSON *unknown; /* copies of them, an object by the path of each owner, and */
  GHashTable *
    owners; /* those objects by the owner's value in the tree; both the caller's to free */
  int32_t notes; /* that callers have given to owners */
} QnReader;

#define QN_READER_MAX_WARNINGS 100

typedef struct QnJsonValue {
  QnReader *reader;
  const struct QnJsonValue *parent; /* NULL: the document */
  const char *key;                  /* NULL: element `index` of an array */
  gsize index;
  const cJSON *json; /* NULL where the file has none */
} QnJsonValue;

typedef enum { QN_OPTIONAL, QN_REQUIRED } QnNeed;

/* The document; a member of an object (json NULL where it is not there), or one at hand that need
 * not be searched for; an element of an array.
 * They borrow what they come from, which must outlive them. */
QnJsonValue qn_json_value_root (QnReader *reader, const cJSON *value);
QnJsonValue qn_json_value_member (const QnJsonValue *object, const char *key);
QnJsonValue qn_json_value_child (const QnJsonValue *object, const cJSON *member);
QnJsonValue qn_json_value_element (const QnJsonValue *array, gsize index,
                                   const cJSON *value);

/* Steps to the next element of an array; to the first one where `element` is zeroed. FALSE behind
 * the last one, and where there is no array. */
gboolean qn_json_value_next (const QnJsonValue *array, QnJsonValue *element);

/* "wall.quoin:12:7: blocks[3].vertices: message"; with "(set by …)" instead of line and column
 * where an override put the value there. `known` (nullable): the place in the text, which is looked for
 * else. Free with g_free(). */
char *qn_reader_dup_line (const QnReader *reader, const char *path,
                          const QnJsonPlace *known, const char *message);

/* The path to a value; free with g_free(). */
char *qn_json_value_dup_path (const QnJsonValue *place);

/* Records the error of a place, the second of a byte of the text; returns FALSE. */
gboolean qn_json_value_fail (const QnJsonValue *place, const char *message);
gboolean qn_json_value_fail_at (const QnJsonValue *place, gsize at, const char *message);
gboolean qn_json_value_failf (const QnJsonValue *place, const char *format, ...)
  G_GNUC_PRINTF (2, 3);
gboolean qn_json_value_no_memory (const QnJsonValue *place);

/* Adds a warning of a place to those of the reader. */
void qn_json_value_warn (const QnJsonValue *place, const char *message);

/* Reports a value without effect: a warning; an error (QN_IO_ERROR_OVERRIDE, FALSE) if an override set it,
 * because its effect was asked for. The second form is for a member whose key is none of `keys`, and names
 * the nearest of them. */
gboolean qn_json_value_idle (const QnJsonValue *place, const char *message);
gboolean qn_json_value_unknown (const QnJsonValue *member, const char *const *keys,
                                gsize count);

/* The same for every member of an object that is not among `keys`; the reader keeps them in `unknown`. What
 * is no object has none. */
gboolean qn_json_value_check_keys (const QnJsonValue *object, const char *const *keys,
                                   gsize count);

/* Values of a place. Each returns FALSE with the error recorded where the value is missing, of
 * another type or out of range. Strings are borrowed from the tree. */
gboolean qn_json_value_object (const QnJsonValue *place);
gboolean qn_json_value_array (const QnJsonValue *place);
gboolean qn_json_value_number (const QnJsonValue *place, QnRange range, double *number);
gboolean qn_json_value_vec2 (const QnJsonValue *place, QnVec2 *vector);

/* All numbers of an array, `stride` apart, into room for them. */
gboolean qn_json_value_numbers (const QnJsonValue *list, QnRange range, gsize stride,
                                double *numbers);

/* The same for a member of an object; an optional one that is not there changes nothing. */
gboolean qn_member_number (const QnJsonValue *object, const char *key, QnNeed need,
                           QnRange range, double *number);
gboolean qn_member_count (const QnJsonValue *object, const char *key, QnNeed need,
                          int32_t max,
                          int32_t *count); /* a whole number from 1 to `max` */
gboolean qn_member_bool (const QnJsonValue *object, const char *key, QnNeed need,
                         bool *flag);
gboolean qn_member_vec2 (const QnJsonValue *object, const char *key, QnNeed need,
                         QnVec2 *vector);
gboolean qn_member_string (const QnJsonValue *object, const char *key, QnNeed need,
                           const char **string);
gboolean qn_member_array (const QnJsonValue *object, const char *key, QnNeed need,
                          QnJsonValue *array);
/* An array of at most so many rows of `width` numbers, such as points. */
gboolean qn_member_rows (const QnJsonValue *object, const char *key, QnNeed need,
                         int width, int most, double *rows, int32_t *count);
/* One of `names`; choice: an enumeration whose values are their places. */
gboolean qn_member_choice (const QnJsonValue *object, const char *key, QnNeed need,
                           const char *const *names, int count, void *choice);

/* ---- json-parse.c: a JSON text (RFC 8259), strictly, as a tree ---- */

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

/* ---- words and overrides ---- */

/* The one of `words` nearest to `word` by the number of typing errors: a letter added, missing, wrong, or
 * two exchanged (optimal string alignment, F. J. Damerau, Communications of the ACM 7 (1964) 171-176;
 * bytes, not characters). NULL if it has two errors or more, and more than a third of the longer word. */
const char *qn_nearest_word (const char *word, const char *const *words, gsize count);

/* Replaces or adds one value of `root`, whose members and elements keep their order. The part
 * behind the first "=" is JSON, or else taken as a plain string. Missing objects on the way
 * are added; elements of arrays must be there. Errors: QN_IO_ERROR (_OVERRIDE where the path
 * leads nowhere), their messages starting with the override. */
gboolean qn_json_override (cJSON *root, const char *override, GError **error);

/* The path part of a well-formed override as qn_json_path_append() writes it, or NULL; free with
 * g_free(). */
char *qn_json_override_dup_path (const char *override);
