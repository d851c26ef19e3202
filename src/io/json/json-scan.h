/* A strict JSON tokenizer (RFC 8259) that knows where it is.
 *
 * It walks a text in memory without copying anything, so that large files can be read straight
 * into arrays. The text must be valid UTF-8 (qn_json_scanner_init() sees to it) and have a NUL
 * byte behind its last byte.
 *
 *   while (qn_json_next (&scanner) != QN_JSON_END)
 *     if (scanner.token == QN_JSON_ERROR) … scanner.problem at scanner.start …
 */
#ifndef QN_IO_JSON_SCAN_H
#define QN_IO_JSON_SCAN_H

#include <glib.h>

/* Deepest nesting of arrays and objects: ten times what our formats use, small enough for code
 * that follows the nesting by recursion. */
#define QN_JSON_MAX_DEPTH 100

typedef enum {
  QN_JSON_BEGIN_OBJECT,
  QN_JSON_END_OBJECT,
  QN_JSON_BEGIN_ARRAY,
  QN_JSON_END_ARRAY,
  QN_JSON_KEY, /* with its colon */
  QN_JSON_STRING,
  QN_JSON_NUMBER,
  QN_JSON_TRUE,
  QN_JSON_FALSE,
  QN_JSON_NULL,
  QN_JSON_END,  /* the text holds nothing after its one value */
  QN_JSON_ERROR /* stays so: see `problem` */
} QnJsonToken;

typedef struct QnJsonScanner {
  const char *text; /* borrowed */
  gsize length;

  QnJsonToken token;
  gsize start, end;    /* bytes of the token; of strings and keys including the quotes */
  const char *problem; /* why token is ERROR: a translated sentence; start is the place */

  /* Private. */
  gsize offset;
  guint expect;
  guint depth;
  guint8 in_object[QN_JSON_MAX_DEPTH];
} QnJsonScanner;

/* `text` must outlive the scanner. A byte order mark at its start is skipped. */
void qn_json_scanner_init (QnJsonScanner *scanner, const char *text, gsize length);

/* Goes to the next token and returns it. */
QnJsonToken qn_json_next (QnJsonScanner *scanner);

/* Skips the rest of the value that the current token begins; FALSE on an error. */
gboolean qn_json_skip (QnJsonScanner *scanner);

/* Value of the current NUMBER token: infinite where the text says more than a double holds. */
double qn_json_number (const QnJsonScanner *scanner);

/* Text of the current STRING or KEY token with escapes resolved; free with g_free(). */
char *qn_json_dup_string (const QnJsonScanner *scanner);

/* Whether the current STRING or KEY token reads `text`. */
gboolean qn_json_string_is (const QnJsonScanner *scanner, const char *text);

#endif
