#include "bench/compare.h"

#include <math.h>
#include <string.h>

/* Digits that an exact multiplier must keep. */
#define EXACT 1e-6

/* The tables that are compared, and how many columns on the left say which row it is. */
static const struct {
  const char *name;
  int keys;
} tables[] = { { "walls", 6 },    { "members", 4 },      { "joints", 4 },
               { "contacts", 2 }, { "render", 2 },       { "scaling", 2 },
               { "paths", 3 },    { "scaling-bars", 2 }, { "contacts-bars", 2 } };

typedef enum {
  OTHER,
  OUTCOME,
  COUNT,
  MULTIPLIER,
  EXACT_MULTIPLIER,
  ERROR,
  TIME,
  MET
} Kind;

/* One CSV file: lines of fields. */
typedef struct Table {
  GPtrArray *rows; /* of char **; the first one has the headings */
  int keys;
} Table;

/* What is being compared. */
typedef struct Comparison {
  const char *name;
  Table before, after;
  const CompareMargins *margins;
  FILE *out;
  CompareVerdict verdict;
  double time_logarithms;
  int times;
  long counts_before, counts_after;
} Comparison;

CompareMargins
compare_margins_default (void)
{
  return (CompareMargins){
    .time = 1.6, .mean_time = 1.25, .short_time = 0.3, .multiplier = 1e-3
  };
}

/* The fields of a line; quotes keep commas together. */
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

static gboolean
table_read (Table *table, const char *folder, const char *name, int keys, GError **error)
{
  g_autofree char *file = g_strconcat (name, ".csv", NULL);
  g_autofree char *path = g_build_filename (folder, file, NULL);
  g_autofree char *text = NULL;
  *table = (Table){ .keys = keys };
  if (!g_file_get_contents (path, &text, NULL, error))
    return FALSE;
  g_auto (GStrv) lines = g_strsplit (g_strchomp (text), "\n", -1);
  table->rows = g_ptr_array_new_with_free_func ((GDestroyNotify) g_strfreev);
  for (char **line = lines; *line != NULL; line++)
    g_ptr_array_add (table->rows, split_line (*line));
  if (table->rows->len > 0
      && (int) g_strv_length (g_ptr_array_index (table->rows, 0)) > keys)
    return TRUE;
  g_set_error (error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s: no table", path);
  g_clear_pointer (&table->rows, g_ptr_array_unref);
  return FALSE;
}

static char **
row_of (const Table *table, guint index)
{
  return g_ptr_array_index (table->rows, index);
}

static int
find_column (const Table *table, const char *heading)
{
  char **headings = row_of (table, 0);
  for (int i = 0; headings[i] != NULL; i++)
    if (g_str_equal (headings[i], heading))
      return i;
  return -1;
}

/* A field, "" where the line is too short. */
static const char *
field (char **row, int column)
{
  return column >= 0 && column < (int) g_strv_length (row) ? row[column] : "";
}

static double
number (char **row, int column)
{
  const char *text = field (row, column);
  char *end;
  double value = g_ascii_strtod (text, &end);
  return end != text && *end == '\0' ? value : NAN;
}

static gboolean
same_key (char **a, char **b, int keys)
{
  for (int i = 0; i < keys; i++)
    if (!g_str_equal (field (a, i), field (b, i)))
      return FALSE;
  return TRUE;
}

static char **
find_row (const Table *table, char **key)
{
  for (guint i = 1; i < table->rows->len; i++)
    if (same_key (row_of (table, i), key, table->keys))
      return row_of (table, i);
  return NULL;
}

static Kind
kind_of (const char *heading)
{
  if (g_str_has_suffix (heading, "outcome"))
    return OUTCOME;
  if (g_str_has_suffix (heading, "factorisations"))
    return COUNT;
  if (g_str_equal (heading, "limit multiplier"))
    return EXACT_MULTIPLIER;
  if (g_str_has_suffix (heading, "multiplier"))
    return MULTIPLIER;
  if (g_str_has_prefix (heading, "error"))
    return ERROR;
  if (g_str_has_suffix (heading, "/kernel"))
    return TIME;
  return g_str_equal (heading, "met") ? MET : OTHER;
}

/* An answer, not the end of somebody's patience. */
static gboolean
is_answer (const char *outcome)
{
  return *outcome != '\0' && !g_str_equal (outcome, "cancelled")
         && !g_str_equal (outcome, "not-converged");
}

/* The outcome that belongs to a column: "path outcome" to "path factorisations", or the
 * table's only one. */
static const char *
outcome_of (const Table *table, char **row, const char *heading)
{
  g_autofree char *first = g_strndup (heading, strcspn (heading, " /"));
  g_autofree char *own = g_strconcat (first, " outcome", NULL);
  int column = find_column (table, own);
  if (column < 0)
    column = find_column (table, "outcome");
  return column >= 0 ? field (row, column) : NULL;
}

static void
note (Comparison *c, char **row, const char *heading, const char *before,
      const char *after, gboolean worse)
{
  g_autoptr (GString) key = g_string_new (c->name);
  for (int i = 0; i < c->before.keys; i++)
    if (*field (row, i) != '\0')
      g_string_append_printf (key, " %s", field (row, i));
  fprintf (c->out, "  %s  %s: %s %s -> %s\n", worse ? "WORSE " : "better", key->str,
           heading, before, after);
  if (worse)
    c->verdict.worse++;
  else
    c->verdict.better++;
}

/* How far a multiplier of this row may go astray, relative. */
static double
multiplier_margin (const Comparison *c, char **row)
{
  double tolerance = number (row, find_column (&c->before, "tolerance"));
  return isnan (tolerance) ? c->margins->multiplier
                           : fmax (c->margins->multiplier, 2 * tolerance);
}

/* 1: worse, -1: better, 0: as good. */
static int
compare_texts (Kind kind, const char *before, const char *after)
{
  if (g_str_equal (before, after))
    return 0;
  if (kind == MET)
    return g_str_equal (after, "yes") ? -1 : g_str_equal (before, "yes") ? 1 : 0;
  return is_answer (before) || !is_answer (after) ? 1 : -1;
}

/* Where the right answer is known, the error says what a multiplier is worth. */
static gboolean
has_error (const Table *table, char **row)
{
  char **headings = row_of (table, 0);
  for (int i = 0; headings[i] != NULL; i++)
    if (kind_of (headings[i]) == ERROR && !isnan (number (row, i)))
      return TRUE;
  return FALSE;
}

static int
compare_numbers (Comparison *c, Kind kind, double before, double after, double margin)
{
  double worse = after, limit = before;
  switch (kind) {
  case COUNT:
    c->counts_before += (long) before;
    c->counts_after += (long) after;
    return (after > before) - (after < before);
  case TIME:
    if (fmax (before, after) < c->margins->short_time)
      return 0;
    before = fmax (before, c->margins->short_time);
    after = fmax (after, c->margins->short_time);
    c->time_logarithms += log (after / before);
    c->times++;
    return (after > c->margins->time * before) - (before > c->margins->time * after);
  case EXACT_MULTIPLIER:
    return fabs (after - before) > EXACT * (1 + fabs (before));
  case MULTIPLIER:
    worse = before;
    limit = after;
    margin *= fabs (before);
    break;
  case ERROR:
    worse = fabs (after);
    limit = fabs (before);
    margin *= 100;
    break;
  case OTHER:
  case OUTCOME:
  case MET:
    break;
  }
  return (worse > limit + margin) - (limit > worse + margin);
}

static void
compare_field (Comparison *c, char **before, char **after, int column)
{
  const char *heading = row_of (&c->before, 0)[column];
  int other = find_column (&c->after, heading), verdict;
  Kind kind = kind_of (heading);
  const char *old = field (before, column), *new = field (after, other);

  if (kind == OTHER || other < 0
      || (kind == MULTIPLIER && has_error (&c->before, before)))
    return;
  if (kind == OUTCOME || kind == MET) {
    verdict = compare_texts (kind, old, new);
  } else {
    const char *outcome = outcome_of (&c->before, before, heading);
    const char *new_outcome = outcome_of (&c->after, after, heading);
    double a = number (before, column), b = number (after, other);
    if ((outcome != NULL && !is_answer (outcome))
        || (new_outcome != NULL && !is_answer (new_outcome)) || isnan (a))
      return;
    verdict =
      isnan (b) ? 1 : compare_numbers (c, kind, a, b, multiplier_margin (c, before));
  }
  c->verdict.compared++;
  if (verdict != 0)
    note (c, before, heading, old, new, verdict > 0);
}

static void
compare_rows (Comparison *c, gboolean partial)
{
  int columns = (int) g_strv_length (row_of (&c->before, 0));
  for (guint i = 1; i < c->before.rows->len; i++) {
    char **before = row_of (&c->before, i), **after = find_row (&c->after, before);
    if (after == NULL && !partial) {
      note (c, before, "row", "there", "missing", TRUE);
      c->verdict.worse--;
      c->verdict.missing++;
    }
    for (int column = c->before.keys; after != NULL && column < columns; column++)
      compare_field (c, before, after, column);
  }
  for (guint i = 1; i < c->after.rows->len; i++)
    c->verdict.added += find_row (&c->before, row_of (&c->after, i)) == NULL;
}

static void
sum_up (Comparison *c, CompareVerdict *verdict)
{
  double mean = c->times > 0 ? exp (c->time_logarithms / c->times) : 1;
  gboolean slower = c->times > 1 && mean > c->margins->mean_time;
  c->verdict.worse += slower;
  fprintf (c->out,
           "%-18s %5d figures, factorisations %ld -> %ld, times x %.2f%s, %d worse, %d "
           "better, %d missing, %d new\n",
           c->name, c->verdict.compared, c->counts_before, c->counts_after, mean,
           slower ? " (WORSE)" : "", c->verdict.worse, c->verdict.better,
           c->verdict.missing, c->verdict.added);
  verdict->compared += c->verdict.compared;
  verdict->worse += c->verdict.worse;
  verdict->better += c->verdict.better;
  verdict->missing += c->verdict.missing;
  verdict->added += c->verdict.added;
}

static gboolean
has_table (const char *folder, const char *name)
{
  g_autofree char *file = g_strconcat (name, ".csv", NULL);
  g_autofree char *path = g_build_filename (folder, file, NULL);
  return g_file_test (path, G_FILE_TEST_EXISTS);
}

static gboolean
compare_table (Comparison *c, int keys, const char *baseline, const char *fresh,
               gboolean partial, CompareVerdict *verdict, GError **error)
{
  if (!table_read (&c->before, baseline, c->name, keys, error))
    return FALSE;
  gboolean ok = table_read (&c->after, fresh, c->name, keys, error);
  if (ok) {
    compare_rows (c, partial);
    sum_up (c, verdict);
    g_ptr_array_unref (c->after.rows);
  }
  g_ptr_array_unref (c->before.rows);
  return ok;
}

gboolean
compare_folders (const char *baseline, const char *fresh, const CompareMargins *margins,
                 gboolean partial, FILE *out, CompareVerdict *verdict, GError **error)
{
  int found = 0;
  *verdict = (CompareVerdict){ 0 };
  for (gsize i = 0; i < G_N_ELEMENTS (tables); i++) {
    Comparison c = { .name = tables[i].name, .margins = margins, .out = out };
    if (!has_table (baseline, c.name) || (partial && !has_table (fresh, c.name)))
      continue;
    found++;
    if (!compare_table (&c, tables[i].keys, baseline, fresh, partial, verdict, error))
      return FALSE;
  }
  if (found > 0)
    return TRUE;
  g_set_error (error, G_FILE_ERROR, G_FILE_ERROR_NOENT, "%s, %s: no table in both",
               baseline, fresh);
  return FALSE;
}
