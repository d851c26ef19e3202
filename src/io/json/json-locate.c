#include "io/json/json-locate.h"

#include "io/json/json-path.h"
#include "io/json/json-scan.h"

#include <string.h>

/* From the beginning of a container to the beginning of the value that `step` names in it. */
static gboolean
enter (QnJsonScanner *scanner, const QnJsonStep *step)
{
  QnJsonToken wanted = step->key != NULL ? QN_JSON_BEGIN_OBJECT : QN_JSON_BEGIN_ARRAY;
  if (scanner->token != wanted)
    return FALSE;

  for (gsize index = 0;; index++) {
    QnJsonToken token = qn_json_next (scanner);
    if (token == QN_JSON_END_OBJECT || token == QN_JSON_END_ARRAY
        || token == QN_JSON_ERROR)
      return FALSE;
    gboolean found = index == step->index;
    if (step->key != NULL) {
      found = qn_json_string_is (scanner, step->key);
      qn_json_next (scanner);
    }
    if (found)
      return scanner->token != QN_JSON_ERROR;
    if (!qn_json_skip (scanner))
      return FALSE;
  }
}

/* Goes to the value that a path leads to, or as far as there is one: *offset is where that value
 * begins. FALSE where the path leads further. */
static gboolean
follow (QnJsonScanner *scanner, const char *path, gsize *offset)
{
  qn_json_next (scanner);
  *offset = scanner->start;

  GArray *steps = qn_json_path_parse (path);
  gboolean there = steps != NULL;
  for (guint i = 0; there && i < steps->len; i++) {
    there = enter (scanner, &g_array_index (steps, QnJsonStep, i));
    if (there)
      *offset = scanner->start;
  }
  if (steps != NULL)
    g_array_unref (steps);
  return there;
}

gsize
qn_json_locate (const char *text, gsize length, const char *path)
{
  QnJsonScanner scanner;
  gsize offset;
  qn_json_scanner_init (&scanner, text, length);
  follow (&scanner, path, &offset);
  return offset;
}

/* Moves from the place of one offset to that of a later one. */
static void
advance (const char *text, gsize from, gsize to, QnJsonPlace *place)
{
  for (const char *c; (c = memchr (text + from, '\n', to - from)) != NULL;) {
    from = (gsize) (c - text) + 1;
    *place = (QnJsonPlace){ place->line + 1, 1 };
  }
  for (; from < to; from++)
    place->column += ((guchar) text[from] & 0xc0) != 0x80; /* not inside a character */
}

void
qn_json_position (const char *text, gsize offset, gsize *line, gsize *column)
{
  QnJsonPlace place = { 1, 1 };
  advance (text, 0, offset, &place);
  *line = place.line;
  *column = place.column;
}

GArray *
qn_json_locate_elements (const char *text, gsize length, const char *path)
{
  GArray *places = g_array_new (FALSE, FALSE, sizeof (QnJsonPlace));
  QnJsonScanner scanner;
  QnJsonPlace place = { 1, 1 };
  gsize offset, known = 0;
  qn_json_scanner_init (&scanner, text, length);
  if (!follow (&scanner, path, &offset) || scanner.token != QN_JSON_BEGIN_ARRAY)
    return places;
  for (;;) {
    QnJsonToken token = qn_json_next (&scanner);
    if (token == QN_JSON_END_ARRAY || token == QN_JSON_ERROR)
      return places;
    advance (text, known, scanner.start, &place);
    known = scanner.start;
    g_array_append_val (places, place);
    if (!qn_json_skip (&scanner))
      return places;
  }
}
