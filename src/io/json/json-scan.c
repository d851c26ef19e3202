#include "io/json/json-scan.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* What may come next. */
enum {
  EXPECT_VALUE,         /* after a colon, or at the start */
  EXPECT_FIRST_ELEMENT, /* after [: a value or ] */
  EXPECT_ELEMENT,       /* after a comma in an array */
  EXPECT_FIRST_KEY,     /* after {: a key or } */
  EXPECT_KEY,           /* after a comma in an object */
  EXPECT_SEPARATOR,     /* after a value inside a container: comma or its end */
  EXPECT_NOTHING        /* after the one value of the document */
};

static QnJsonToken
fail (QnJsonScanner *scanner, gsize offset, const char *problem)
{
  scanner->start = MIN (offset, scanner->length);
  scanner->end = scanner->start;
  scanner->problem = problem;
  return scanner->token = QN_JSON_ERROR;
}

void
qn_json_scanner_init (QnJsonScanner *scanner, const char *text, gsize length)
{
  *scanner = (QnJsonScanner){ .text = text, .length = length, .expect = EXPECT_VALUE };

  const char *invalid;
  if (!g_utf8_validate_len (text, length, &invalid))
    fail (scanner, (gsize) (invalid - text), _ ("text is not UTF-8"));
  else if (length >= 3 && memcmp (text, "\xef\xbb\xbf", 3) == 0)
    scanner->offset = 3;
}

static void
skip_space (QnJsonScanner *scanner)
{
  const char *text = scanner->text;
  gsize i = scanner->offset;
  while (i < scanner->length
         && (text[i] == ' ' || text[i] == '\n' || text[i] == '\t' || text[i] == '\r'))
    i++;
  scanner->offset = i;
}

/* What follows a complete value. */
static void
after_value (QnJsonScanner *scanner)
{
  scanner->expect = scanner->depth > 0 ? EXPECT_SEPARATOR : EXPECT_NOTHING;
}

static QnJsonToken
accept (QnJsonScanner *scanner, QnJsonToken token, gsize length)
{
  scanner->start = scanner->offset;
  scanner->end = scanner->offset += length;
  return scanner->token = token;
}

static QnJsonToken
begin_container (QnJsonScanner *scanner, gboolean object)
{
  if (scanner->depth == QN_JSON_MAX_DEPTH)
    return fail (scanner, scanner->offset, _ ("values are nested too deeply"));
  scanner->in_object[scanner->depth++] = object;
  scanner->expect = object ? EXPECT_FIRST_KEY : EXPECT_FIRST_ELEMENT;
  return accept (scanner, object ? QN_JSON_BEGIN_OBJECT : QN_JSON_BEGIN_ARRAY, 1);
}

static QnJsonToken
end_container (QnJsonScanner *scanner)
{
  gboolean object = scanner->in_object[--scanner->depth];
  after_value (scanner);
  return accept (scanner, object ? QN_JSON_END_OBJECT : QN_JSON_END_ARRAY, 1);
}

/* Four hexadecimal digits at `digits`, or -1. */
static int
hex4 (const char *digits)
{
  int value = 0;
  for (int i = 0; i < 4; i++) {
    int digit = g_ascii_xdigit_value (digits[i]);
    if (digit < 0)
      return -1;
    value = value * 16 + digit;
  }
  return value;
}

/* The character of the escape \uXXXX at `escape` (a pair of them outside the basic plane), with
 * the bytes it takes; 0 where it is none. NUL is none: no string of ours could hold it. */
static gunichar
unicode_escape (const char *escape, gsize *length)
{
  int high = hex4 (escape + 2);
  *length = 6;
  if (high <= 0 || (high >= 0xdc00 && high <= 0xdfff))
    return 0;
  if (high < 0xd800 || high > 0xdbff)
    return (gunichar) high;

  if (escape[6] != '\\' || escape[7] != 'u')
    return 0;
  int low = hex4 (escape + 8);
  *length = 12;
  if (low < 0xdc00 || low > 0xdfff)
    return 0;
  return 0x10000 + (((gunichar) high - 0xd800) << 10) + ((gunichar) low - 0xdc00);
}

/* Byte behind the string whose opening quote is at `offset`, or 0 with the error set. The NUL
 * behind the text ends every look ahead. */
static gsize
string_end (QnJsonScanner *scanner, gsize offset)
{
  const char *text = scanner->text;
  gsize i = offset + 1;
  while (i < scanner->length && text[i] != '"') {
    gsize length = 1;
    if ((guchar) text[i] < 0x20) {
      fail (scanner, i, _ ("line break or control character inside a string"));
      return 0;
    }
    if (text[i] == '\\') {
      length = 2;
      gboolean valid =
        text[i + 1] == 'u'
          ? unicode_escape (text + i, &length) != 0
          : text[i + 1] != '\0' && strchr ("\"\\/bfnrt", text[i + 1]) != NULL;
      if (!valid) {
        fail (scanner, i, _ ("this escape is not valid in a JSON string"));
        return 0;
      }
    }
    i += length;
  }
  if (i >= scanner->length) {
    fail (scanner, offset, _ ("string has no end"));
    return 0;
  }
  return i + 1;
}

static QnJsonToken
scan_string (QnJsonScanner *scanner)
{
  gsize end = string_end (scanner, scanner->offset);
  if (end == 0)
    return QN_JSON_ERROR;
  after_value (scanner);
  return accept (scanner, QN_JSON_STRING, end - scanner->offset);
}

static QnJsonToken
scan_key (QnJsonScanner *scanner)
{
  gsize start = scanner->offset;
  if (start >= scanner->length)
    return fail (scanner, start, _ ("text ends inside an object"));
  if (scanner->text[start] != '"')
    return fail (scanner, start,
                 scanner->text[start] == '/' || scanner->text[start] == '#'
                   ? _ ("JSON has no comments")
                   : _ ("expected a key in quotes"));
  gsize end = string_end (scanner, start);
  if (end == 0)
    return QN_JSON_ERROR;

  scanner->offset = end;
  skip_space (scanner);
  if (scanner->offset >= scanner->length || scanner->text[scanner->offset] != ':')
    return fail (scanner, scanner->offset, _ ("expected a colon after the key"));
  scanner->offset++;
  scanner->expect = EXPECT_VALUE;
  scanner->start = start;
  scanner->end = end;
  return scanner->token = QN_JSON_KEY;
}

static gsize
skip_digits (const char *text, gsize i)
{
  while (g_ascii_isdigit (text[i]))
    i++;
  return i;
}

static QnJsonToken
scan_number (QnJsonScanner *scanner)
{
  const char *text = scanner->text;
  gsize start = scanner->offset;
  gsize i = start + (text[start] == '-');
  gsize digits = i;
  i = skip_digits (text, i);
  gboolean valid = i > digits && (text[digits] != '0' || i == digits + 1);
  if (text[i] == '.') {
    digits = ++i;
    i = skip_digits (text, i);
    valid = valid && i > digits;
  }
  if (text[i] == 'e' || text[i] == 'E') {
    i++;
    i += text[i] == '+' || text[i] == '-';
    digits = i;
    i = skip_digits (text, i);
    valid = valid && i > digits;
  }
  if (!valid || g_ascii_isalnum (text[i]) || text[i] == '.')
    return fail (scanner, start, _ ("this is not a number as JSON writes it"));
  after_value (scanner);
  return accept (scanner, QN_JSON_NUMBER, i - start);
}

static QnJsonToken
scan_word (QnJsonScanner *scanner)
{
  static const struct {
    const char *word;
    QnJsonToken token;
  } words[] = { { "true", QN_JSON_TRUE },
                { "false", QN_JSON_FALSE },
                { "null", QN_JSON_NULL } };
  const char *here = scanner->text + scanner->offset;

  for (gsize i = 0; i < G_N_ELEMENTS (words); i++) {
    gsize length = strlen (words[i].word);
    if (strncmp (here, words[i].word, length) == 0 && !g_ascii_isalnum (here[length])) {
      after_value (scanner);
      return accept (scanner, words[i].token, length);
    }
  }
  if (g_ascii_strncasecmp (here, "nan", 3) == 0
      || g_ascii_strncasecmp (here, "inf", 3) == 0)
    return fail (scanner, scanner->offset, _ ("number is not finite"));
  return fail (scanner, scanner->offset,
               scanner->text[scanner->offset] == '/' ? _ ("JSON has no comments")
                                                     : _ ("this is not a JSON value"));
}

static QnJsonToken
scan_value (QnJsonScanner *scanner)
{
  if (scanner->offset >= scanner->length)
    return fail (scanner, scanner->offset,
                 scanner->depth > 0 ? _ ("text ends where a value is expected")
                                    : _ ("file is empty"));
  char c = scanner->text[scanner->offset];
  if (c == '{' || c == '[')
    return begin_container (scanner, c == '{');
  if (c == '"')
    return scan_string (scanner);
  if (c == '-' || g_ascii_isdigit (c))
    return scan_number (scanner);
  return scan_word (scanner);
}

/* Between the values of a container: the comma and what follows it, or the container's end. */
static QnJsonToken
scan_separator (QnJsonScanner *scanner)
{
  gboolean object = scanner->in_object[scanner->depth - 1];
  if (scanner->offset >= scanner->length)
    return fail (scanner, scanner->offset,
                 object ? _ ("text ends inside an object")
                        : _ ("text ends inside an array"));
  char c = scanner->text[scanner->offset];
  if (c == (object ? '}' : ']'))
    return end_container (scanner);
  if (c != ',')
    return fail (scanner, scanner->offset,
                 object ? _ ("expected a comma or }") : _ ("expected a comma or ]"));
  scanner->offset++;
  skip_space (scanner);
  return object ? scan_key (scanner) : scan_value (scanner);
}

QnJsonToken
qn_json_next (QnJsonScanner *scanner)
{
  if (scanner->token == QN_JSON_ERROR)
    return QN_JSON_ERROR;

  skip_space (scanner);
  gboolean more = scanner->offset < scanner->length;
  char c = scanner->text[scanner->offset];
  switch (scanner->expect) {
  case EXPECT_FIRST_ELEMENT:
    return more && c == ']' ? end_container (scanner) : scan_value (scanner);
  case EXPECT_FIRST_KEY:
    return more && c == '}' ? end_container (scanner) : scan_key (scanner);
  case EXPECT_SEPARATOR:
    return scan_separator (scanner);
  case EXPECT_NOTHING:
    if (more)
      return fail (scanner, scanner->offset, _ ("text after the end of the document"));
    return accept (scanner, QN_JSON_END, 0);
  default:
    return scan_value (scanner);
  }
}

gboolean
qn_json_skip (QnJsonScanner *scanner)
{
  if (scanner->token != QN_JSON_BEGIN_OBJECT && scanner->token != QN_JSON_BEGIN_ARRAY)
    return scanner->token != QN_JSON_ERROR;
  guint outer = scanner->depth - 1;
  while (scanner->depth > outer)
    if (qn_json_next (scanner) == QN_JSON_ERROR)
      return FALSE;
  return TRUE;
}

double
qn_json_number (const QnJsonScanner *scanner)
{
  return g_ascii_strtod (scanner->text + scanner->start, NULL);
}

/* Appends the character of the escape at `escape`; returns the bytes it takes. */
static gsize
append_escape (GString *string, const char *escape)
{
  static const char letters[] = "bfnrt", controls[] = "\b\f\n\r\t";
  gsize length = 2;
  if (escape[1] == 'u') {
    g_string_append_unichar (string, unicode_escape (escape, &length));
  } else {
    const char *letter = strchr (letters, escape[1]);
    g_string_append_c (string, letter != NULL ? controls[letter - letters] : escape[1]);
  }
  return length;
}

char *
qn_json_dup_string (const QnJsonScanner *scanner)
{
  const char *c = scanner->text + scanner->start + 1;
  const char *end = scanner->text + scanner->end - 1;
  if (memchr (c, '\\', (gsize) (end - c)) == NULL)
    return g_strndup (c, (gsize) (end - c));

  GString *string = g_string_sized_new ((gsize) (end - c));
  while (c < end) {
    if (*c == '\\')
      c += append_escape (string, c);
    else
      g_string_append_c (string, *c++);
  }
  return g_string_free (string, FALSE);
}

gboolean
qn_json_string_is (const QnJsonScanner *scanner, const char *text)
{
  const char *c = scanner->text + scanner->start + 1;
  gsize length = scanner->end - scanner->start - 2;
  if (memchr (c, '\\', length) == NULL)
    return strlen (text) == length && memcmp (c, text, length) == 0;

  char *string = qn_json_dup_string (scanner);
  gboolean equal = strcmp (string, text) == 0;
  g_free (string);
  return equal;
}
