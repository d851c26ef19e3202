#include "io/json/json-value.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Objects with more members than this find duplicate keys by a table. */
#define MANY_MEMBERS 32

/* Trees are of the memory of GLib, which has all it is asked for or ends the program. */
static void __attribute__ ((constructor)) take_memory_of_glib (void)
{
  cJSON_InitHooks (&(cJSON_Hooks){ g_malloc, g_free });
}

/* Each function takes the place where something begins and returns the place behind it, NULL with the
 * error of the reader set where it is not right. No byte of the text is NUL: the one behind it ends every
 * look ahead. */

static const char *
fail (const QnJsonValue *value, const char *at, const char *problem)
{
  qn_json_value_fail_at (value, (gsize) (at - value->reader->text), problem);
  return NULL;
}

static const char *
skip_space (const char *c)
{
  while (*c == ' ' || *c == '\n' || *c == '\t' || *c == '\r')
    c++;
  return c;
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

static const char *
scan_string (const QnJsonValue *value, const char *quoted, char **text)
{
  const char *end;
  const char *problem = string_problem (quoted, &end);
  if (problem != NULL)
    return fail (value, end, problem);
  *text = qn_json_unescape (quoted);
  return end + 1;
}

static const char *
skip_digits (const char *c)
{
  while (g_ascii_isdigit (*c))
    c++;
  return c;
}

static const char *
scan_number (const QnJsonValue *value, const char *start, cJSON **json)
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
    return fail (value, start, _ ("this is not a number as JSON writes it"));
  *json = cJSON_CreateNumber (g_ascii_strtod (start, NULL));
  return c;
}

static const char *
scan_word (const QnJsonValue *value, const char *start, cJSON **json)
{
  static const struct {
    const char *word;
    int type;
  } words[] = { { "true", cJSON_True },
                { "false", cJSON_False },
                { "null", cJSON_NULL } };
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++) {
    gsize length = strlen (words[i].word);
    if (strncmp (start, words[i].word, length) == 0 && !g_ascii_isalnum (start[length])) {
      *json = cJSON_CreateNull ();
      (*json)->type = words[i].type;
      return start + length;
    }
  }
  if (g_ascii_strncasecmp (start, "nan", 3) == 0
      || g_ascii_strncasecmp (start, "inf", 3) == 0)
    return fail (value, start, _ ("number is not finite"));
  return fail (value, start,
               *start == '/' ? _ ("JSON has no comments")
                             : _ ("this is not a JSON value"));
}

/* The key of a member and its colon. */
static const char *
scan_key (const QnJsonValue *object, const char *c, char **key)
{
  if (*c == '\0')
    return fail (object, c, _ ("text ends inside an object"));
  if (*c != '"')
    return fail (object, c,
                 *c == '/' || *c == '#' ? _ ("JSON has no comments")
                                        : _ ("expected a key in quotes"));
  c = scan_string (object, c, key);
  if (c == NULL || *(c = skip_space (c)) == ':')
    return c != NULL ? c + 1 : NULL;
  return fail (object, c, _ ("expected a colon after the key"));
}

/* What parts an item from the one before it. */
static const char *
scan_comma (const QnJsonValue *item, const char *c, gboolean object)
{
  if (*c == ',')
    return skip_space (c + 1);
  if (object)
    return fail (item->parent, c,
                 *c == '\0' ? _ ("text ends inside an object")
                            : _ ("expected a comma or }"));
  return fail (
    item, c, *c == '\0' ? _ ("text ends inside an array") : _ ("expected a comma or ]"));
}

/* Whether an object has a key; of many members `keys` is made a table. */
static gboolean
has_key (const cJSON *object, gsize count, char *key, GHashTable **keys)
{
  if (count < MANY_MEMBERS)
    return cJSON_GetObjectItemCaseSensitive (object, key) != NULL;
  if (*keys == NULL) {
    *keys = g_hash_table_new (g_str_hash, g_str_equal);
    for (const cJSON *member = object->child; member != NULL; member = member->next)
      g_hash_table_add (*keys, member->string);
  }
  return !g_hash_table_add (*keys, key);
}

static const char *scan_value (const QnJsonValue *value, const char *c, guint depth,
                               cJSON **json);

static const char *
scan_container (const QnJsonValue *value, const char *c, guint depth, cJSON **json)
{
  const gboolean object = *c == '{';
  if (depth == QN_JSON_MAX_DEPTH)
    return fail (value, c, _ ("values are nested too deeply"));
  QnJsonValue item = { .reader = value->reader, .parent = value };
  g_autoptr (GHashTable) keys = NULL;
  *json = object ? cJSON_CreateObject () : cJSON_CreateArray ();
  for (c = skip_space (c + 1); *c != (object ? '}' : ']'); item.index++) {
    cJSON *read = NULL;
    char *key = NULL;
    const char *start = c = item.index > 0 ? scan_comma (&item, c, object) : c;
    if (c != NULL && object)
      c = scan_key (value, c, &key);
    item.key = key;
    if (c != NULL && object && has_key (*json, item.index, key, &keys))
      c = fail (&item, start, _ ("key is given twice"));
    c = c != NULL ? scan_value (&item, c, depth + 1, &read) : NULL;
    if (c == NULL) {
      g_free (key);
      g_clear_pointer (json, cJSON_Delete);
      return NULL;
    }
    read->string = key;
    cJSON_AddItemToArray (*json, read); /* an object is a list, too */
    item.key = NULL;
    c = skip_space (c);
  }
  return c + 1;
}

static const char *
scan_value (const QnJsonValue *value, const char *c, guint depth, cJSON **json)
{
  const char *start = c = skip_space (c);
  char *text = NULL;
  if (*c == '-' || g_ascii_isdigit (*c)) {
    c = scan_number (value, c, json);
  } else if (*c == '{' || *c == '[') {
    c = scan_container (value, c, depth, json);
  } else if (*c == '"') {
    c = scan_string (value, c, &text);
    *json = cJSON_CreateNull ();
    (*json)->type = cJSON_String;
    (*json)->valuestring = text;
  } else if (*c == '\0') {
    c =
      fail (value, c,
            depth > 0 ? _ ("text ends where a value is expected") : _ ("file is empty"));
  } else {
    c = scan_word (value, c, json);
  }
  if (c == NULL)
    g_clear_pointer (json, cJSON_Delete);
  else
    (*json)->valueint = (int) (start - value->reader->text);
  return c;
}

cJSON *
qn_json_parse (const char *text, gsize length, const char *name, GError **error)
{
  QnReader reader = { .name = name, .text = text, .length = length };
  const QnJsonValue root = qn_json_value_root (&reader, NULL);
  cJSON *json = NULL;
  const char *c = text;
  if (!g_utf8_validate_len (text, length, &c))
    c = fail (&root, c,
              *c != '\0' ? _ ("text is not UTF-8") : _ ("this is not a JSON value"));
  else
    c = scan_value (&root, g_str_has_prefix (text, "\xef\xbb\xbf") ? text + 3 : text, 0,
                    &json);
  if (c != NULL && *(c = skip_space (c)) != '\0') {
    fail (&root, c, _ ("text after the end of the document"));
    g_clear_pointer (&json, cJSON_Delete);
  }
  if (json == NULL)
    g_propagate_error (error, reader.error);
  return json;
}
