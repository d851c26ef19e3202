#include "support/table.h"

#include <math.h>
#include <string.h>

/* One field, with *at moved behind it, and whether it stood in quotes. */
static char *
read_field (const char **at, gboolean *quoted)
{
  GString *field = g_string_new (NULL);
  const char *c = *at;
  *quoted = *c == '"';
  if (*quoted) {
    for (c++; *c != '"' || c[1] == '"'; c++) {
      g_assert_cmpint (*c, !=, '\0');
      g_string_append_c (field, *c);
      c += *c == '"';
    }
    c++;
  } else {
    gsize length = strcspn (c, ",\r\n");
    g_string_append_len (field, c, (gssize) length);
    c += length;
  }
  g_assert_nonnull (strchr (",\r\n", *c)); /* the end of the text too */
  *at = c;
  return g_string_free (field, FALSE);
}

/* Words that programs write where they have no number. */
static void
check_field (const char *field)
{
  static const char *const words[] = { "nan",      "-nan",      "inf", "-inf",  "null",
                                       "infinity", "-infinity", "-",   "(null)" };
  for (gsize i = 0; i < G_N_ELEMENTS (words); i++)
    if (g_ascii_strcasecmp (field, words[i]) == 0)
      g_error ("a field says %s", field);
  char *end;
  double number = g_ascii_strtod (field, &end);
  g_assert_true (*end != '\0' || isfinite (number));
}

GPtrArray *
test_table_read (const char *text)
{
  GPtrArray *table = g_ptr_array_new_with_free_func ((GDestroyNotify) g_strfreev);
  while (*text != '\0') {
    GPtrArray *row = g_ptr_array_new ();
    for (gboolean more = TRUE; more;) {
      gboolean quoted;
      char *field = read_field (&text, &quoted);
      if (!quoted)
        check_field (field);
      g_ptr_array_add (row, field);
      more = *text == ',';
      text += more;
    }
    text += strspn (text, "\r\n");
    g_ptr_array_add (row, NULL);
    if (table->len > 0)
      g_assert_cmpuint (row->len - 1, ==, g_strv_length (g_ptr_array_index (table, 0)));
    g_ptr_array_add (table, g_ptr_array_free (row, FALSE));
  }
  g_assert_cmpuint (table->len, >, 0);
  return table;
}

const char *
test_table_field (const GPtrArray *table, guint row, const char *heading)
{
  char **headings = g_ptr_array_index (table, 0);
  guint column = 0;
  while (headings[column] != NULL && !g_str_equal (headings[column], heading))
    column++;
  if (headings[column] == NULL)
    g_error ("no column is called %s", heading);
  g_assert_cmpuint (row, <, table->len);
  return ((char **) g_ptr_array_index (table, row))[column];
}

double
test_table_number (const GPtrArray *table, guint row, const char *heading)
{
  const char *field = test_table_field (table, row, heading);
  char *end;
  double number = g_ascii_strtod (field, &end);
  g_assert_true (end != field && *end == '\0');
  return number;
}
