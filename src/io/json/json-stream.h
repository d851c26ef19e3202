/* Reading JSON straight into structs and arrays, without a tree: for files whose tree would not
 * fit into memory.
 *
 * What an object may hold is a table of QnJsonMember; each reader below takes the value that
 * the scanner stands at and stores it behind `target`. Unknown keys are skipped. The first
 * error is kept with file, line, column and path.
 */
#ifndef QN_IO_JSON_STREAM_H
#define QN_IO_JSON_STREAM_H

#include "io/json/json-scan.h"

#define QN_JSON_STREAM_DEPTH 16

typedef struct QnJsonStream {
  QnJsonScanner scanner;
  const char *name; /* of the file */
  GError *error;    /* domain QN_IO_ERROR */

  struct {
    const char *key; /* NULL: element `index` */
    gsize index;
  } steps[QN_JSON_STREAM_DEPTH];
  guint depth;
} QnJsonStream;

/* Reads the value at the scanner into *target; FALSE with the stream's error set. */
typedef gboolean (*QnJsonReadFunc) (QnJsonStream *stream, gpointer target);

/* QN_JSON_EACH: the value is an array, of which `read` takes every element. */
typedef enum {
  QN_JSON_OPTIONAL = 0,
  QN_JSON_REQUIRED = 1,
  QN_JSON_EACH = 2
} QnJsonMemberFlags;

typedef struct QnJsonMember {
  const char *key;
  QnJsonReadFunc read;
  gsize offset; /* of the member's place behind the target of the object */
  QnJsonMemberFlags flags;
} QnJsonMember;

/* `text` must have a NUL byte behind its last byte and outlive the stream. */
void qn_json_stream_init (QnJsonStream *stream, const char *text, gsize length,
                          const char *name);

/* Reads the one value of the text with `read`. */
gboolean qn_json_stream_document (QnJsonStream *stream, QnJsonReadFunc read,
                                  gpointer target);

/* Reads an object, its members in any order: at most 64 in the table, those given twice and
 * required ones that are missing are errors. */
gboolean qn_json_stream_object (QnJsonStream *stream, const QnJsonMember *members,
                                guint count, gpointer target);

/* Calls `read` for every element, always with the same target. */
gboolean qn_json_stream_array (QnJsonStream *stream, QnJsonReadFunc read,
                               gpointer target);

/* Reads an array of exactly `count` numbers. */
gboolean qn_json_stream_numbers (QnJsonStream *stream, double *numbers, gsize count);

/* Readers of one value: target is a finite double *, an int32_t * that is not negative, an
 * int64_t * that is not negative, and a char ** that is freed before it is replaced. */
gboolean qn_json_stream_number (QnJsonStream *stream, gpointer target);
gboolean qn_json_stream_int32 (QnJsonStream *stream, gpointer target);
gboolean qn_json_stream_int64 (QnJsonStream *stream, gpointer target);
gboolean qn_json_stream_string (QnJsonStream *stream, gpointer target);

/* Records an error at the current value, or at a path; returns FALSE. */
gboolean qn_json_stream_fail (QnJsonStream *stream, const char *message);
gboolean qn_json_stream_fail_at (QnJsonStream *stream, const char *path,
                                 const char *message);
gboolean qn_json_stream_no_memory (QnJsonStream *stream);

#endif
