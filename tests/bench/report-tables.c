#include "bench/report-tables.h"

#include "bench/csv-table.h"

#include <string.h>

#define BEGIN "<!-- table "
#define CLOSE " -->\n"
#define END   "<!-- end -->"

/* What the first comment asks for. */
typedef struct Request {
  char *name;
  char **conditions; /* "heading is value" */
  char **columns;    /* "heading" or "heading = title" */
} Request;

static void
request_clear (Request *request)
{
  g_free (request->name);
  g_strfreev (request->conditions);
  g_strfreev (request->columns);
}

static gboolean
complain (GError **error, const char *what, const char *where)
{
  g_set_error (error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s: %s", what, where);
  return FALSE;
}

static gboolean
request_parse (Request *request, const char *comment, GError **error)
{
  g_auto (GStrv) halves = g_strsplit (comment, ": ", 2);
  *request = (Request){ 0 };
  if (g_strv_length (halves) != 2)
    return complain (error, "no columns", comment);
  g_auto (GStrv) parts = g_strsplit (halves[0], " where ", 2);
  request->name = g_strdup (parts[0]);
  request->conditions = g_strsplit (parts[1] != NULL ? parts[1] : "", ", ", -1);
  request->columns = g_strsplit (halves[1], " | ", -1);
  return TRUE;
}

/* The two sides of "one SEPARATOR other"; the other is that of `one` where there is none. */
static char **
split_pair (const char *text, const char *separator)
{
  char **pair = g_strsplit (text, separator, 2);
  if (pair[1] != NULL)
    return pair;
  g_strfreev (pair);
  char *both[] = { (char *) text, (char *) text, NULL };
  return g_strdupv (both);
}

static gboolean
find (const CsvTable *table, const Request *request, const char *heading, int *column,
      GError **error)
{
  *column = csv_table_find_column (table, heading);
  return *column >= 0 || complain (error, request->name, heading);
}

static gboolean
is_wanted (const CsvTable *table, const Request *request, char **row, gboolean *wanted,
           GError **error)
{
  *wanted = TRUE;
  for (char **condition = request->conditions; *condition != NULL; condition++) {
    g_auto (GStrv) pair = split_pair (*condition, " is ");
    int column;
    if (!find (table, request, pair[0], &column, error))
      return FALSE;
    *wanted = *wanted && g_str_equal (csv_field (row, column), pair[1]);
  }
  return TRUE;
}

/* One row, titles where it is the first. */
static gboolean
append_row (GString *out, const CsvTable *table, const Request *request, guint index,
            GError **error)
{
  for (char **wanted = request->columns; *wanted != NULL; wanted++) {
    g_auto (GStrv) pair = split_pair (*wanted, " = ");
    int column;
    if (!find (table, request, pair[0], &column, error))
      return FALSE;
    const char *value = csv_field (csv_table_get_row (table, index), column);
    if (g_str_equal (value, "nan") || g_str_equal (value, "+nan"))
      value = "–";
    g_string_append_printf (out, "| %s ", index == 0 ? pair[1] : value);
  }
  g_string_append (out, "|\n");
  for (char **column = request->columns; index == 0 && *column != NULL; column++)
    g_string_append (out, column[1] != NULL ? "| --- " : "| --- |\n");
  return TRUE;
}

static gboolean
append_table (GString *out, const Request *request, const char *folder, GError **error)
{
  CsvTable table;
  if (!csv_table_read (&table, folder, request->name, error))
    return FALSE;
  gboolean ok = append_row (out, &table, request, 0, error), wanted;
  for (guint i = 1; ok && i < table.rows->len; i++) {
    ok = is_wanted (&table, request, csv_table_get_row (&table, i), &wanted, error);
    if (ok && wanted)
      ok = append_row (out, &table, request, i, error);
  }
  csv_table_clear (&table);
  return ok;
}

char *
report_tables_dup (const char *text, const char *folder, GError **error)
{
  g_autoptr (GString) out = g_string_new (NULL);
  const char *begin;

  while ((begin = strstr (text, BEGIN)) != NULL) {
    const char *close = strstr (begin, CLOSE), *end = strstr (begin, END);
    Request request;
    if (close == NULL || end == NULL || end < close) {
      complain (error, "a table without end", begin);
      return NULL;
    }
    g_autofree char *comment =
      g_strndup (begin + strlen (BEGIN), (gsize) (close - begin) - strlen (BEGIN));
    g_string_append_len (out, text, close + strlen (CLOSE) - text);
    gboolean ok = request_parse (&request, comment, error)
                  && append_table (out, &request, folder, error);
    request_clear (&request);
    if (!ok)
      return NULL;
    g_string_append (out, END);
    text = end + strlen (END);
  }
  g_string_append (out, text);
  return g_strdup (out->str);
}
