#include "io/text/text-decode.h"

#include <string.h>

static gboolean
begins (const char *bytes, gsize size, const char *mark, gsize length)
{
  return size >= length && memcmp (bytes, mark, length) == 0;
}

/* "\r\n" and "\r" become "\n". */
static gsize
unify_line_ends (char *text, gsize length)
{
  gsize kept = 0;
  for (gsize i = 0; i < length; i++)
    if (text[i] != '\r')
      text[kept++] = text[i];
    else if (text[i + 1] != '\n')
      text[kept++] = '\n';
  text[kept] = '\0';
  return kept;
}

char *
qn_text_decode (const char *bytes, gsize size, const char *charset, gsize *length)
{
  gsize mark = begins (bytes, size, "\xef\xbb\xbf", 3) ? 3 : 0;
  const char *from = begins (bytes, size, "\xff\xfe", 2)   ? "UTF-16LE"
                     : begins (bytes, size, "\xfe\xff", 2) ? "UTF-16BE"
                                                           : NULL;
  if (from != NULL)
    mark = 2;
  else if (!g_utf8_validate_len (bytes + mark, size - mark, NULL))
    from = charset != NULL ? charset : "WINDOWS-1252";
  bytes += mark;
  size -= mark;
  char *text = from != NULL
                 ? g_convert (bytes, (gssize) size, "UTF-8", from, NULL, length, NULL)
                 : NULL;
  if (text == NULL) {
    text = g_utf8_make_valid (bytes, (gssize) size);
    *length = strlen (text);
  }
  *length = unify_line_ends (text, *length);
  return text;
}
