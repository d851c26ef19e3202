#include "io/json-text.h"

void
qn_json_append_string (GString *json, const char *text)
{
  g_string_append_c (json, '"');
  for (const char *c = text; *c != '\0'; c++) {
    if (*c == '"' || *c == '\\')
      g_string_append_c (json, '\\');
    if ((guchar) *c >= 0x20)
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
