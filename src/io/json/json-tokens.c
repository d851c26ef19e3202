#include "io/json/json-tokens.h"

#include "core/base/memory.h"
#include "io/json/json-path.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

/* ---- errors ---- */

/* Appends the path of the value at a token, or of the one that would come next where the text is wrong. */
static void
append_path (const QnJson *json, gsize at, GString *path)
{
  const QnJsonToken *tokens = json->tokens;
  gboolean inside = json->count > 0 && (tokens[0].next == 0 || at < tokens[0].next);
  for (gsize outer = 0; inside && outer < at;) {
    gboolean object = tokens[outer].type == QN_JSON_OBJECT;
    gsize item = outer + 1, index = 0;
    for (; item < json->count && tokens[item].next != 0 && tokens[item].next <= at;
         index++)
      item = tokens[item].next;
    inside = !object || item < json->count; /* else: where a key would stand */
    if (inside) {
      g_autofree char *key = object ? qn_json_dup_string (json, item) : NULL;
      qn_json_path_append (path, key, index);
    }
    outer = object ? item + 1 : item;
  }
}

char *
qn_json_dup_path (const QnJson *json, gsize at)
{
  GString *path = g_string_new (NULL);
  append_path (json, at, path);
  return g_string_free (path, FALSE);
}

/* Keeps the error of a member that the value at `at` does not have; NULL: of that value itself. */
static gboolean
fail_inside (QnJson *json, gsize at, const char *key, const char *message)
{
  if (json->error != NULL)
    return FALSE;
  g_autoptr (GString) path = g_string_new (NULL);
  append_path (json, at, path);
  if (key != NULL)
    qn_json_path_append (path, key, 0);
  const QnJsonPlace place = qn_json_position (
    json->text, at < json->count ? json->tokens[at].start : json->trouble);
  json->error =
    g_error_new (QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 "%s:%" G_GSIZE_FORMAT ":%" G_GSIZE_FORMAT ": %s%s%s", json->name,
                 place.line, place.column, path->str, path->len > 0 ? ": " : "", message);
  return FALSE;
}

gboolean
qn_json_fail (QnJson *json, gsize at, const char *message)
{
  return fail_inside (json, at, NULL, message);
}

gboolean
qn_json_fail_missing (QnJson *json, gsize at, const char *key)
{
  return fail_inside (json, at, key, _ ("required key is missing"));
}

gboolean
qn_json_failf (QnJson *json, gsize at, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  g_autofree char *message = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  return qn_json_fail (json, at, message);
}

gboolean
qn_json_no_memory (QnJson *json)
{
  if (json->error == NULL)
    json->error = g_error_new (QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", json->name,
                               _ ("not enough memory"));
  return FALSE;
}

/* ---- scanning ----
 *
 * Each function takes the place where something begins and returns the place behind it, NULL with the
 * error set where it is not right. No byte of the text is NUL: the one behind it ends every look ahead. */

static const char *
fail (QnJson *json, const char *place, const char *problem)
{
  json->trouble = (gsize) (place - json->text);
  qn_json_fail (json, json->count, problem);
  return NULL;
}

static const char *
skip_space (const char *c)
{
  while (*c == ' ' || *c == '\n' || *c == '\t' || *c == '\r')
    c++;
  return c;
}

/* Adds a token; a key and a container are open until their last item is there. */
static gboolean
add (QnJson *json, QnJsonType type, const char *start)
{
  const guint32 next = type <= QN_JSON_KEY ? 0 : (guint32) json->count + 1;
  return (json->count < G_MAXUINT32 - 1
          && QN_ARRAY_PUSH (json->tokens, json->count, json->capacity,
                            (QnJsonToken){ (gsize) (start - json->text), next, type }))
         || qn_json_no_memory (json);
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

/* Error of a string, at *place; NULL: none, *place is the closing quote. */
static const char *
string_problem (const char *quoted, const char **place)
{
  const char *c = quoted + 1;
  while (*c != '"') {
    gsize length = 1;
    if ((guchar) *c < 0x20) {
      *place = *c != '\0' ? c : quoted;
      return *c != '\0' ? _ ("line break or control character inside a string")
                        : _ ("string has no end");
    }
    if (*c == '\\') {
      length = 2;
      if (c[1] == 'u' ? unicode_escape (c, &length) == 0
                      : c[1] == '\0' || strchr ("\"\\/bfnrt", c[1]) == NULL) {
        *place = c;
        return _ ("this escape is not valid in a JSON string");
      }
    }
    c += length;
  }
  *place = c;
  return NULL;
}

static const char *
scan_string (QnJson *json, const char *quoted)
{
  const char *place;
  const char *problem = string_problem (quoted, &place);
  return problem == NULL ? place + 1 : fail (json, place, problem);
}

static const char *
skip_digits (const char *c)
{
  while (g_ascii_isdigit (*c))
    c++;
  return c;
}

static const char *
scan_number (QnJson *json, const char *start)
{
  const char *digits = start + (*start == '-');
  const char *c = skip_digits (digits);
  gboolean valid = c > digits && (*digits != '0' || c == digits + 1);
  if (*c == '.') {
    digits = ++c;
    c = skip_digits (c);
    valid = valid && c > digits;
  }
  if (*c == 'e' || *c == 'E') {
    c++;
    digits = c += *c == '+' || *c == '-';
    c = skip_digits (c);
    valid = valid && c > digits;
  }
  if (!valid || g_ascii_isalnum (*c) || *c == '.')
    return fail (json, start, _ ("this is not a number as JSON writes it"));
  return add (json, QN_JSON_NUMBER, start) ? c : NULL;
}

static const char *
scan_word (QnJson *json, const char *start)
{
  static const struct {
    const char *word;
    QnJsonType type;
  } words[] = { { "true", QN_JSON_TRUE },
                { "false", QN_JSON_FALSE },
                { "null", QN_JSON_NULL } };
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++) {
    gsize length = strlen (words[i].word);
    if (strncmp (start, words[i].word, length) == 0 && !g_ascii_isalnum (start[length]))
      return add (json, words[i].type, start) ? start + length : NULL;
  }
  if (g_ascii_strncasecmp (start, "nan", 3) == 0
      || g_ascii_strncasecmp (start, "inf", 3) == 0)
    return fail (json, start, _ ("number is not finite"));
  return fail (json, start,
               *start == '/' ? _ ("JSON has no comments")
                             : _ ("this is not a JSON value"));
}

static const char *scan_value (QnJson *json, const char *c, guint depth);

static const char *
scan_member (QnJson *json, const char *c, guint depth)
{
  if (*c == '\0')
    return fail (json, c, _ ("text ends inside an object"));
  if (*c != '"')
    return fail (json, c,
                 *c == '/' || *c == '#' ? _ ("JSON has no comments")
                                        : _ ("expected a key in quotes"));
  const char *end = scan_string (json, c);
  if (end == NULL)
    return NULL;
  end = skip_space (end);
  if (*end != ':')
    return fail (json, end, _ ("expected a colon after the key"));
  const gsize key = json->count;
  end = add (json, QN_JSON_KEY, c) ? scan_value (json, end + 1, depth) : NULL;
  if (end != NULL)
    json->tokens[key].next = (guint32) json->count;
  return end;
}

static const char *
scan_container (QnJson *json, const char *c, guint depth)
{
  const gboolean object = *c == '{';
  const gsize at = json->count;
  if (depth == QN_JSON_MAX_DEPTH)
    return fail (json, c, _ ("values are nested too deeply"));
  if (!add (json, object ? QN_JSON_OBJECT : QN_JSON_ARRAY, c))
    return NULL;
  c = skip_space (c + 1);
  for (gboolean first = TRUE; *c != (object ? '}' : ']'); first = FALSE) {
    if (!first && *c == '\0')
      return fail (json, c,
                   object ? _ ("text ends inside an object")
                          : _ ("text ends inside an array"));
    if (!first && *c != ',')
      return fail (json, c,
                   object ? _ ("expected a comma or }") : _ ("expected a comma or ]"));
    if (!first)
      c = skip_space (c + 1);
    c = object ? scan_member (json, c, depth + 1) : scan_value (json, c, depth + 1);
    if (c == NULL)
      return NULL;
    c = skip_space (c);
  }
  json->tokens[at].next = (guint32) json->count;
  return c + 1;
}

static const char *
scan_value (QnJson *json, const char *c, guint depth)
{
  c = skip_space (c);
  if (*c == '-' || g_ascii_isdigit (*c))
    return scan_number (json, c);
  if (*c == '{' || *c == '[')
    return scan_container (json, c, depth);
  if (*c == '"') {
    const char *end = scan_string (json, c);
    return end != NULL && add (json, QN_JSON_STRING, c) ? end : NULL;
  }
  if (*c == '\0')
    return fail (json, c,
                 depth > 0 ? _ ("text ends where a value is expected")
                           : _ ("file is empty"));
  return scan_word (json, c);
}

gboolean
qn_json_scan (QnJson *json, const char *text, gsize length, const char *name)
{
  *json = (QnJson){ .text = text, .name = name };
  const char *c = text;
  if (!g_utf8_validate_len (text, length, &c))
    return fail (json, c,
                 *c != '\0' ? _ ("text is not UTF-8") : _ ("this is not a JSON value"))
           != NULL;
  c = scan_value (json, g_str_has_prefix (text, "\xef\xbb\xbf") ? text + 3 : text, 0);
  if (c != NULL && *(c = skip_space (c)) != '\0')
    c = fail (json, c, _ ("text after the end of the document"));
  return c != NULL;
}

void
qn_json_clear (QnJson *json)
{
  free (json->tokens);
  g_clear_error (&json->error);
  *json = (QnJson){ 0 };
}

/* ---- values ---- */

gsize
qn_json_member (const QnJson *json, gsize at, const char *key)
{
  const QnJsonToken *tokens = json->tokens;
  for (gsize i = at + 1; i < tokens[at].next; i = tokens[i].next)
    if (tokens[i].type == QN_JSON_KEY && qn_json_string_is (json, i, key))
      return i + 1;
  return 0;
}

gsize
qn_json_count (const QnJson *json, gsize at)
{
  gsize count = 0;
  for (gsize i = at + 1; i < json->tokens[at].next; i = json->tokens[i].next)
    count++;
  return count;
}

double
qn_json_number (const QnJson *json, gsize at)
{
  return g_ascii_strtod (json->text + json->tokens[at].start, NULL);
}

gsize
qn_json_string_length (const char *quoted)
{
  const char *end;
  return string_problem (quoted, &end) == NULL ? (gsize) (end + 1 - quoted) : 0;
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
qn_json_unescape (const char *quoted)
{
  const char *c = quoted + 1;
  gsize plain = strcspn (c, "\"\\");
  GString *string = g_string_new_len (c, (gssize) plain);
  for (c += plain; *c != '"';)
    if (*c == '\\')
      c += append_escape (string, c);
    else
      g_string_append_c (string, *c++);
  return g_string_free (string, FALSE);
}

char *
qn_json_dup_string (const QnJson *json, gsize at)
{
  return qn_json_unescape (json->text + json->tokens[at].start);
}

gboolean
qn_json_string_is (const QnJson *json, gsize at, const char *text)
{
  const char *c = json->text + json->tokens[at].start + 1, *rest = text;
  for (; *c != '"' && *c != '\\' && *c == *rest; c++)
    rest++;
  if (*c != '\\')
    return *c == '"' && *rest == '\0';
  g_autofree char *string = qn_json_dup_string (json, at);
  return strcmp (string, text) == 0;
}
