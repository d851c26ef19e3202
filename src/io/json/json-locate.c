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

gsize
qn_json_locate (const char *text, gsize length, const char *path)
{
  QnJsonScanner scanner;
  qn_json_scanner_init (&scanner, text, length);
  qn_json_next (&scanner);
  gsize offset = scanner.start;

  GArray *steps = qn_json_path_parse (path);
  for (guint i = 0; steps != NULL && i < steps->len; i++) {
    if (!enter (&scanner, &g_array_index (steps, QnJsonStep, i)))
      break;
    offset = scanner.start;
  }
  if (steps != NULL)
    g_array_unref (steps);
  return offset;
}

void
qn_json_position (const char *text, gsize offset, gsize *line, gsize *column)
{
  gsize line_start = 0;
  *line = 1;
  for (const char *c;
       (c = memchr (text + line_start, '\n', offset - line_start)) != NULL;) {
    line_start = (gsize) (c - text) + 1;
    ++*line;
  }
  *column = 1;
  for (gsize i = line_start; i < offset; i++)
    *column += ((guchar) text[i] & 0xc0) != 0x80; /* not inside a character */
}
