#include "io/text/json-text.h"

#include "io/text/text-format.h"

#include <cjson/cJSON.h>

/* Longest array or object that is kept on one line. */
#define ONE_LINE 80

void
qn_json_append_string (GString *json, const char *text)
{
  g_string_append_c (json, '"');
  for (const char *c = text; *c != '\0'; c++) {
    gunichar wide = (guchar) *c >= 0x80 ? g_utf8_get_char_validated (c, -1) : 0;
    if (*c == '"' || *c == '\\')
      g_string_append_c (json, '\\');
    if (wide != 0 && !qn_is_plain_character (wide)) {
      g_string_append_printf (json, "\\u%04x", wide);
      c += g_unichar_to_utf8 (wide, NULL) - 1;
    } else if ((guchar) *c >= 0x20 && *c != 0x7f)
      g_string_append_c (json, *c);
    else if (*c == '\n')
      g_string_append (json, "\\n");
    else if (*c == '\t')
      g_string_append (json, "\\t");
    else
      g_string_append_printf (json, "\\u%04x", (guint) *c);
  }
  g_string_append_c (json, '"');
}

void
qn_json_append_number (GString *json, double number)
{
  char text[QN_NUMBER_TEXT_SIZE];
  g_string_append (json, qn_number_text (number, text));
}

static void
append_key (GString *json, const cJSON *member)
{
  if (member->string == NULL)
    return;
  qn_json_append_string (json, member->string);
  g_string_append (json, ": ");
}

/* Appends on one line; FALSE as soon as the line is longer than `limit` bytes. */
static gboolean
append_one_line (GString *json, const cJSON *value, gsize limit)
{
  if (!cJSON_IsArray (value) && !cJSON_IsObject (value)) {
    if (cJSON_IsString (value))
      qn_json_append_string (json, value->valuestring);
    else if (cJSON_IsNumber (value))
      qn_json_append_number (json, value->valuedouble);
    else if (cJSON_IsBool (value))
      g_string_append (json, cJSON_IsTrue (value) ? "true" : "false");
    else
      g_string_append (json, "null");
    return json->len <= limit;
  }
  gboolean object = cJSON_IsObject (value);
  g_string_append (json, object ? (value->child != NULL ? "{ " : "{") : "[");
  for (const cJSON *child = value->child; child != NULL; child = child->next) {
    if (child != value->child)
      g_string_append (json, ", ");
    if (object)
      append_key (json, child);
    if (!append_one_line (json, child, limit))
      return FALSE;
  }
  g_string_append (json, object ? (value->child != NULL ? " }" : "}") : "]");
  return json->len <= limit;
}

static void
append_line_break (GString *json, guint indent)
{
  g_string_append_c (json, '\n');
  for (guint i = 0; i < indent; i++)
    g_string_append_c (json, ' ');
}

void
qn_json_append_value (GString *json, const cJSON *value, guint indent)
{
  gsize start = json->len;
  gboolean container = cJSON_IsArray (value) || cJSON_IsObject (value);
  if (append_one_line (json, value, container ? start + ONE_LINE : G_MAXSIZE))
    return;

  g_string_truncate (json, start);
  gboolean object = cJSON_IsObject (value);
  g_string_append_c (json, object ? '{' : '[');
  for (const cJSON *child = value->child; child != NULL; child = child->next) {
    if (child != value->child)
      g_string_append_c (json, ',');
    append_line_break (json, indent + 2);
    if (object)
      append_key (json, child);
    qn_json_append_value (json, child, indent + 2);
  }
  append_line_break (json, indent);
  g_string_append_c (json, object ? '}' : ']');
}

void
qn_json_begin_member (GString *json, const char *key)
{
  char last = json->str[json->len - 1];
  g_string_append (json, last == '{' ? " " : last == ' ' ? "" : ", ");
  qn_json_append_string (json, key);
  g_string_append (json, ": ");
}

void
qn_json_put_string (GString *json, const char *key, const char *text)
{
  qn_json_begin_member (json, key);
  qn_json_append_string (json, text);
}

void
qn_json_put_number (GString *json, const char *key, double number)
{
  qn_json_begin_member (json, key);
  qn_json_append_number (json, number);
}
