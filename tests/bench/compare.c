#include "bench/compare.h"

#include "bench/csv-table.h"

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

/* What is being compared. */
typedef struct Comparison {
  const char *name;
  CsvTable before, after;
  int keys;
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

static gboolean
same_key (char **a, char **b, int keys)
{
  for (int i = 0; i < keys; i++)
    if (!g_str_equal (csv_field (a, i), csv_field (b, i)))
      return FALSE;
  return TRUE;
}

static char **
find_row (const CsvTable *table, char **key, int keys)
{
  for (guint i = 1; i < table->rows->len; i++)
    if (same_key (csv_table_get_row (table, i), key, keys))
      return csv_table_get_row (table, i);
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
outcome_of (const CsvTable *table, char **row, const char *heading)
{
  g_autofree char *first = g_strndup (heading, strcspn (heading, " /"));
  g_autofree char *own = g_strconcat (first, " outcome", NULL);
  int column = csv_table_find_column (table, own);
  if (column < 0)
    column = csv_table_find_column (table, "outcome");
  return column >= 0 ? csv_field (row, column) : NULL;
}

static void
note (Comparison *c, char **row, const char *heading, const char *before,
      const char *after, gboolean worse)
{
  g_autoptr (GString) key = g_string_new (c->name);
  for (int i = 0; i < c->keys; i++)
    if (*csv_field (row, i) != '\0')
      g_string_append_printf (key, " %s", csv_field (row, i));
  fprintf (c->out, "  %s  %s: %s %s -> %s\n", worse ? "WORSE " : "better", key->str,
           heading, before, after);
  if (worse)
    c->verdict.worse++;
  else
    c->verdict.better++;
}

/* How far a multiplier of this row may differ, relative. */
static double
multiplier_margin (const Comparison *c, char **row)
{
  double tolerance = csv_number (row, csv_table_find_column (&c->before, "tolerance"));
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
has_error (const CsvTable *table, char **row)
{
  char **headings = csv_table_get_row (table, 0);
  for (int i = 0; headings[i] != NULL; i++)
    if (kind_of (headings[i]) == ERROR && !isnan (csv_number (row, i)))
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
  const char *heading = csv_table_get_row (&c->before, 0)[column];
  int other = csv_table_find_column (&c->after, heading), verdict;
  Kind kind = kind_of (heading);
  const char *old = csv_field (before, column), *new = csv_field (after, other);

  if (kind == OTHER || other < 0
      || (kind == MULTIPLIER && has_error (&c->before, before)))
    return;
  if (kind == OUTCOME || kind == MET) {
    verdict = compare_texts (kind, old, new);
  } else {
    const char *outcome = outcome_of (&c->before, before, heading);
    const char *new_outcome = outcome_of (&c->after, after, heading);
    double a = csv_number (before, column), b = csv_number (after, other);
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
  int columns = (int) g_strv_length (csv_table_get_row (&c->before, 0));
  for (guint i = 1; i < c->before.rows->len; i++) {
    char **before = csv_table_get_row (&c->before, i),
         **after = find_row (&c->after, before, c->keys);
    if (after == NULL && !partial) {
      note (c, before, "row", "there", "missing", TRUE);
      c->verdict.worse--;
      c->verdict.missing++;
    }
    for (int column = c->keys; after != NULL && column < columns; column++)
      compare_field (c, before, after, column);
  }
  for (guint i = 1; i < c->after.rows->len; i++)
    c->verdict.added +=
      find_row (&c->before, csv_table_get_row (&c->after, i), c->keys) == NULL;
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
compare_table (Comparison *c, const char *baseline, const char *fresh, gboolean partial,
               CompareVerdict *verdict, GError **error)
{
  if (!csv_table_read (&c->before, baseline, c->name, error))
    return FALSE;
  gboolean ok = csv_table_read (&c->after, fresh, c->name, error);
  if (ok) {
    compare_rows (c, partial);
    sum_up (c, verdict);
    csv_table_clear (&c->after);
  }
  csv_table_clear (&c->before);
  return ok;
}

gboolean
compare_folders (const char *baseline, const char *fresh, const CompareMargins *margins,
                 gboolean partial, FILE *out, CompareVerdict *verdict, GError **error)
{
  int found = 0;
  *verdict = (CompareVerdict){ 0 };
  for (gsize i = 0; i < G_N_ELEMENTS (tables); i++) {
    Comparison c = {
      .name = tables[i].name, .keys = tables[i].keys, .margins = margins, .out = out
    };
    if (!has_table (baseline, c.name) || (partial && !has_table (fresh, c.name)))
      continue;
    found++;
    if (!compare_table (&c, baseline, fresh, partial, verdict, error))
      return FALSE;
  }
  if (found > 0)
    return TRUE;
  g_set_error (error, G_FILE_ERROR, G_FILE_ERROR_NOENT, "%s, %s: no table in both",
               baseline, fresh);
  return FALSE;
}
