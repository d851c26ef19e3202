#include "bench/csv-table.h"

#include <math.h>

static char **
split_line (const char *line)
{
  GPtrArray *fields = g_ptr_array_new ();
  g_autoptr (GString) field = g_string_new (NULL);
  gboolean quoted = FALSE;
  for (; *line != '\0'; line++) {
    if (*line == '"') {
      quoted = !quoted;
    } else if (*line == ',' && !quoted) {
      g_ptr_array_add (fields, g_strdup (field->str));
      g_string_truncate (field, 0);
    } else {
      g_string_append_c (field, *line);
    }
  }
  g_ptr_array_add (fields, g_strdup (field->str));
  g_ptr_array_add (fields, NULL);
  return (char **) g_ptr_array_free (fields, FALSE);
}

gboolean
csv_table_read (CsvTable *table, const char *folder, const char *name, GError **error)
{
  g_autofree char *file = g_strconcat (name, ".csv", NULL);
  g_autofree char *path = g_build_filename (folder, file, NULL);
  g_autofree char *text = NULL;
  *table = (CsvTable){ 0 };
  if (!g_file_get_contents (path, &text, NULL, error))
    return FALSE;
  if (*g_strchomp (text) == '\0') {
    g_set_error (error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s: no table", path);
    return FALSE;
  }
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  table->rows = g_ptr_array_new_with_free_func ((GDestroyNotify) g_strfreev);
  for (char **line = lines; *line != NULL; line++)
    g_ptr_array_add (table->rows, split_line (*line));
  return TRUE;
}

void
csv_table_clear (CsvTable *table)
{
  g_clear_pointer (&table->rows, g_ptr_array_unref);
}

char **
csv_table_get_row (const CsvTable *table, guint index)
{
  return g_ptr_array_index (table->rows, index);
}

int
csv_table_find_column (const CsvTable *table, const char *heading)
{
  char **headings = csv_table_get_row (table, 0);
  for (int i = 0; headings[i] != NULL; i++)
    if (g_str_equal (headings[i], heading))
      return i;
  return -1;
}

const char *
csv_field (char **row, int column)
{
  return column >= 0 && column < (int) g_strv_length (row) ? row[column] : "";
}

double
csv_number (char **row, int column)
{
  const char *text = csv_field (row, column);
  char *end;
  double value = g_ascii_strtod (text, &end);
  return end != text && *end == '\0' ? value : NAN;
}
