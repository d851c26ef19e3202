/* Taking values out of a JSON tree with errors that name the place.
 *
 * A QnPlace is a value together with the way that leads to it. Places live on the stack of the
 * functions that read, each pointing to the one it was reached from; the path is spelled out
 * and its line and column looked up only when something is wrong.
 */
#ifndef QN_IO_JSON_VALUE_H
#define QN_IO_JSON_VALUE_H

#include "core/base/status.h"

#include <cjson/cJSON.h>
#include <glib.h>

/* One reading of a document. */
typedef struct QnReader {
  const char *name; /* what messages call the file */
  const char *text; /* nullable: no lines and columns then */
  gsize length;
  const char *const *overrides; /* nullable */
  GPtrArray *warnings;          /* of char * */
  guint dropped_warnings;       /* beyond QN_READER_MAX_WARNINGS */
  GError *error;                /* the first one; domain QN_IO_ERROR */
  gboolean keeps_unknown;       /* puts unknown members aside: */
  cJSON *
    unknown; /* copies of them, an object by the path of their owner; the caller's to free */
} QnReader;

#define QN_READER_MAX_WARNINGS 100

typedef struct QnPlace {
  QnReader *reader;
  const struct QnPlace *parent; /* NULL: the document */
  const char *key;              /* NULL: element `index` of an array */
  gsize index;
  const cJSON *value; /* NULL where the file has none */
} QnPlace;

typedef enum { QN_OPTIONAL, QN_REQUIRED } QnNeed;
typedef enum { QN_RANGE_FINITE, QN_RANGE_NOT_NEGATIVE, QN_RANGE_POSITIVE } QnRange;

/* Name of the value of an enumeration, as the file spells it. */
typedef const char *(*QnNameFunc) (int value);

/* The document; a member of an object (value NULL where it is not there); an element of an array.
 * They borrow what they come from, which must outlive them. */
QnPlace qn_place_root (QnReader *reader, const cJSON *value);
QnPlace qn_place_member (const QnPlace *object, const char *key);
QnPlace qn_place_element (const QnPlace *array, gsize index, const cJSON *value);

/* "wall.quoin:12:7: blocks[3].vertices: message"; with "(set by …)" instead of line and column
 * where an override put the value there. Free with g_free(). */
char *qn_reader_dup_line (const QnReader *reader, const char *path, const char *message);

/* Records the error of a place; returns FALSE. The first form takes ownership of nothing, the
 * second formats. */
gboolean qn_place_fail (const QnPlace *place, const char *message);
gboolean qn_place_failf (const QnPlace *place, const char *format, ...)
  G_GNUC_PRINTF (2, 3);
gboolean qn_place_no_memory (const QnPlace *place);

/* Adds a warning of a place to those of the reader. */
void qn_place_warn (const QnPlace *place, const char *message);

/* A warning for every member of an object that is not among `keys`; it is kept in the reader's
 * `unknown`. */
void qn_place_warn_unknown (const QnPlace *object, const char *const *keys, gsize count);

/* Puts a copy of one member aside in the reader's `unknown`. */
void qn_place_keep_unknown (const QnPlace *object, const cJSON *member);

/* Values of a place. Each returns FALSE with the error recorded where the value is missing, of
 * another type or out of range. Strings are borrowed from the tree. */
gboolean qn_place_object (const QnPlace *place);
gboolean qn_place_array (const QnPlace *place);
gboolean qn_place_number (const QnPlace *place, QnRange range, double *number);
gboolean qn_place_vec2 (const QnPlace *place, QnVec2 *vector);

/* The same for a member of an object; an optional one that is not there changes nothing. */
gboolean qn_member_number (const QnPlace *object, const char *key, QnNeed need,
                           QnRange range, double *number);
gboolean qn_member_count (const QnPlace *object, const char *key, QnNeed need,
                          int32_t max,
                          int32_t *count); /* a whole number from 1 to `max` */
gboolean qn_member_bool (const QnPlace *object, const char *key, QnNeed need, bool *flag);
gboolean qn_member_vec2 (const QnPlace *object, const char *key, QnNeed need,
                         QnVec2 *vector);
gboolean qn_member_string (const QnPlace *object, const char *key, QnNeed need,
                           const char **string);
gboolean qn_member_choice (const QnPlace *object, const char *key, QnNeed need,
                           QnNameFunc name, int count, int *choice);

#endif
