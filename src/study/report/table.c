#include "study/report/table.h"

#include "core/base/word.h"
#include "core/result/mechanism.h"
#include "io/text/file-writer.h"
#include "io/text/outcome-text.h"
#include "render/scene/motion.h"
#include "study/cases/case.h"
#include "study/cases/folder.h"

#include <glib/gi18n-lib.h>
#include <gsl/gsl_sort.h>
#include <math.h>
#include <string.h>

typedef struct Reading {
  QnTable *table;
  GArray *numbers;   /* of double */
  GPtrArray *shapes; /* the first of every group, owned */
  GArray *sizes;     /* of gsize: cases of every group */
} Reading;

static void
clear_row (gpointer data)
{
  QnRow *row = data;
  g_free (row->outcome);
  g_free (row->reason);
  g_free (row->mechanism);
}

/* The group of a shape, from 1; a new one where it is like none. */
static guint
group_of (Reading *reading, const char *shape)
{
  const gsize one = 1;
  if (shape == NULL)
    return 0;
  for (guint i = 0; i < reading->shapes->len; i++)
    if (qn_shape_cosine (shape, g_ptr_array_index (reading->shapes, i))
        >= QN_SHAPE_ALIKE) {
      g_array_index (reading->sizes, gsize, i)++;
      return i + 1;
    }
  g_ptr_array_add (reading->shapes, g_strdup (shape));
  g_array_append_val (reading->sizes, one);
  return reading->shapes->len;
}

static int
compare_sizes (gconstpointer a, gconstpointer b, gpointer data)
{
  const gsize *sizes = data;
  guint x = *(const guint *) a, y = *(const guint *) b;
  if (sizes[x] != sizes[y])
    return sizes[x] < sizes[y] ? 1 : -1;
  return (x > y) - (x < y);
}

/* Numbers the groups anew, the most frequent first, and puts the numbers into their column. */
static void
order_groups (Reading *reading)
{
  QnTable *table = reading->table;
  int column = qn_table_find (table, qn_study_output_names[QN_STUDY_MECHANISM_SHAPE]);
  guint count = reading->shapes->len;
  g_autofree guint *order = g_new (guint, count + 1), *number = g_new (guint, count + 1);
  for (guint i = 0; i < count; i++)
    order[i] = i;
  qsort_r (order, count, sizeof *order, compare_sizes, reading->sizes->data);
  number[0] = 0;
  for (guint i = 0; i < count; i++)
    number[order[i] + 1] = i + 1;
  for (guint i = 0; column >= 0 && i < table->rows->len; i++) {
    QnRow *row = &g_array_index (table->rows, QnRow, i);
    row->shape = number[row->shape];
    table->numbers[i * table->width + (gsize) column] = row->shape > 0 ? row->shape : NAN;
  }
}

static gboolean
take_row (gsize index, const double *values, const QnCaseResult *result, gpointer data)
{
  Reading *reading = data;
  const QnStudy *study = reading->table->study;
  QnRow row = { .index = index,
                .failed = result->failed,
                .outcome = g_strdup (result->outcome),
                .reason = g_strdup (result->reason),
                .mechanism = g_strdup (result->mechanism),
                .shape = group_of (reading, result->shape) };
  g_array_append_val (reading->table->rows, row);
  g_array_append_vals (reading->numbers, values, study->parameters->len);
  for (guint i = 0; i < study->outputs->len; i++)
    g_array_append_val (reading->numbers, result->numbers[qn_study_output (study, i)]);
  return TRUE;
}

gboolean
qn_table_read (QnTable *table, const QnStudy *study, const char *folder, GError **error)
{
  g_autofree char *path = qn_folder_dup_database (folder, (QnShard){ 0, 1 });
  Reading reading = { table, g_array_new (FALSE, FALSE, sizeof (double)),
                      g_ptr_array_new_with_free_func (g_free),
                      g_array_new (FALSE, FALSE, sizeof (gsize)) };
  *table = (QnTable){ .study = study,
                      .rows = g_array_new (FALSE, FALSE, sizeof (QnRow)),
                      .parameters = study->parameters->len,
                      .width = study->parameters->len + study->outputs->len };
  g_array_set_clear_func (table->rows, clear_row);
  QnStore *store = qn_store_open (path, study, FALSE, error);
  gboolean ok = store != NULL && qn_store_read (store, take_row, &reading, error);
  qn_store_close (store);
  table->numbers = (double *) (void *) g_array_free (reading.numbers, FALSE);
  if (ok)
    order_groups (&reading);
  else
    qn_table_clear (table);
  g_ptr_array_unref (reading.shapes);
  g_array_unref (reading.sizes);
  return ok;
}

void
qn_table_clear (QnTable *table)
{
  g_clear_pointer (&table->rows, g_array_unref);
  g_free (table->numbers);
  *table = (QnTable){ 0 };
}

const char *
qn_table_column_name (const QnTable *table, gsize column)
{
  return column < table->parameters ? qn_study_parameter (table->study, column)->name
                                    : qn_study_output_names[(int) qn_study_output (
                                      table->study, column - table->parameters)];
}

const char *
qn_table_column_text (const QnTable *table, gsize column)
{
  return column < table->parameters ? qn_table_column_name (table, column)
                                    : qn_study_output_text (qn_study_output (
                                      table->study, column - table->parameters));
}

const char *
qn_table_fragility_text (const QnTable *table, gsize column)
{
  QnStudyOutput output = column >= table->parameters
                           ? qn_study_output (table->study, column - table->parameters)
                           : QN_STUDY_OUTPUT_COUNT;
  return output == QN_STUDY_COLLAPSE_MULTIPLIER ? _ ("Share that has collapsed")
         : output == QN_STUDY_ASSOCIATIVE_MULTIPLIER
           ? _ ("Least share that has collapsed")
           : NULL;
}

int
qn_table_find (const QnTable *table, const char *name)
{
  for (gsize i = 0; i < table->width; i++)
    if (strcmp (qn_table_column_name (table, i), name) == 0)
      return (int) i;
  return -1;
}

static const char *
text_of (const char *text)
{
  return text != NULL ? text : "";
}

gboolean
qn_table_write (const QnTable *table, const char *path, GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path);
  qn_file_writer_puts (writer, "case");
  for (gsize i = 0; i < table->width; i++)
    qn_file_writer_csv (writer, ",%s", qn_table_column_name (table, i));
  qn_file_writer_puts (writer, ",status,outcome,reason\n");
  for (gsize i = 0; i < table->rows->len && !qn_file_writer_failed (writer); i++) {
    const QnRow *row = &g_array_index (table->rows, QnRow, i);
    qn_file_writer_csv (writer, "%zu", row->index + 1);
    for (gsize k = 0; k < table->width; k++) {
      const double number = qn_table_number (table, i, k);
      const gsize output = k - table->parameters;
      const QnCombination *of =
        k < table->parameters ? qn_study_combination (table->study, k, number) : NULL;
      if (of != NULL)
        qn_file_writer_csv (writer, ",%s", of->name);
      else if (k >= table->parameters
               && qn_study_output (table->study, output) == QN_STUDY_MECHANISM_KIND)
        qn_file_writer_csv (writer, ",%s", text_of (row->mechanism));
      else if (!isnan (number))
        qn_file_writer_csv (writer, ",%g", number);
      else
        qn_file_writer_puts (writer, ",");
    }
    qn_file_writer_csv (writer, ",%s,%s,%s\n", row->failed ? "failed" : "done",
                        text_of (row->outcome), text_of (row->reason));
  }
  return qn_file_writer_commit (writer, error);
}

/* ---- columns, as statistics take them ---- */

gboolean
qn_table_is_sample (const QnTable *table)
{
  return !qn_plan_is_by_levels (table->study->plan);
}

/* Of a plan "sobol" the points a and b are independent, the others are mixed from them. */
static gboolean
is_independent (const QnTable *table, gsize row)
{
  return table->study->plan != QN_PLAN_SOBOL
         || g_array_index (table->rows, QnRow, row).index % (table->parameters + 2) < 2;
}

double *
qn_table_dup_sorted (const QnTable *table, gsize column, gsize *count)
{
  double *sorted = g_new (double, table->rows->len);
  *count = 0;
  for (gsize i = 0; i < table->rows->len; i++) {
    double number = qn_table_number (table, i, column);
    if (isfinite (number) && is_independent (table, i))
      sorted[(*count)++] = number;
  }
  gsl_sort (sorted, 1, *count);
  return sorted;
}

gsize
qn_table_dup_pairs (const QnTable *table, gsize x, gsize y, double **xs, double **ys)
{
  gsize count = 0;
  *xs = g_new (double, table->rows->len);
  *ys = g_new (double, table->rows->len);
  for (gsize i = 0; i < table->rows->len; i++) {
    double a = qn_table_number (table, i, x), b = qn_table_number (table, i, y);
    if (!isfinite (a) || !isfinite (b) || !is_independent (table, i))
      continue;
    (*xs)[count] = a;
    (*ys)[count++] = b;
  }
  return count;
}

gboolean
qn_table_sobol (const QnTable *table, gsize column, QnSobolIndex *indices)
{
  if (table->study->plan != QN_PLAN_SOBOL)
    return FALSE;
  gsize cases = qn_study_case_count (table->study);
  g_autofree double *values = g_new (double, cases);
  for (gsize i = 0; i < cases; i++)
    values[i] = NAN;
  for (gsize i = 0; i < table->rows->len; i++)
    values[g_array_index (table->rows, QnRow, i).index] =
      qn_table_number (table, i, column);
  return qn_sobol_indices (values, cases / (table->parameters + 2), table->parameters,
                           indices);
}

gboolean
qn_table_effect (const QnTable *table, gsize parameter, gsize column, double *base,
                 QnInterval *effect)
{
  gsize first = 1;
  *base = NAN;
  *effect = (QnInterval){ INFINITY, -INFINITY };
  if (table->study->plan != QN_PLAN_ONE_AT_A_TIME)
    return FALSE;
  for (gsize i = 0; i < parameter; i++)
    first += qn_parameter_level_count (qn_study_parameter (table->study, i));
  gsize end =
    first + qn_parameter_level_count (qn_study_parameter (table->study, parameter));
  for (gsize i = 0; i < table->rows->len; i++) {
    gsize index = g_array_index (table->rows, QnRow, i).index;
    double number = qn_table_number (table, i, column);
    if (index == 0)
      *base = number;
    if (isfinite (number) && index >= first && index < end) {
      effect->low = fmin (effect->low, number);
      effect->high = fmax (effect->high, number);
    }
  }
  if (!(effect->low <= effect->high))
    return FALSE;
  effect->low = fmin (effect->low, *base);
  effect->high = fmax (effect->high, *base);
  return TRUE;
}

typedef struct Case {
  double multiplier;
  gsize row;
} Case;

/* Cases without a multiplier come last. */
static int
compare_cases (gconstpointer a, gconstpointer b)
{
  const Case *x = a, *y = b;
  if (isnan (x->multiplier) || isnan (y->multiplier))
    return isnan (x->multiplier) - isnan (y->multiplier);
  return (x->multiplier > y->multiplier) - (x->multiplier < y->multiplier);
}

static int
compare_shares (gconstpointer a, gconstpointer b)
{
  const QnMechanismShare *x = a, *y = b;
  if (x->count != y->count)
    return x->count < y->count ? 1 : -1;
  if (x->shape != y->shape)
    return x->shape < y->shape ? -1 : 1;
  return g_strcmp0 (x->kind, y->kind);
}

static const QnRow *
row_of (const QnTable *table, gsize i)
{
  return &g_array_index (table->rows, QnRow, i);
}

/* The cases that have the mechanism of `like`, by their multiplier. */
static QnMechanismShare
describe_group (const QnTable *table, const QnRow *like, int column)
{
  g_autoptr (GArray) cases = g_array_new (FALSE, FALSE, sizeof (Case));
  gsize known = 0;
  for (gsize i = 0; i < table->rows->len; i++) {
    const QnRow *row = row_of (table, i);
    if (like->shape > 0
          ? row->shape != like->shape
          : row->shape > 0 || g_strcmp0 (row->mechanism, like->mechanism) != 0)
      continue;
    Case one = { column >= 0 ? qn_table_number (table, i, (gsize) column) : NAN, i };
    known += !isnan (one.multiplier);
    g_array_append_val (cases, one);
  }
  g_array_sort (cases, compare_cases);
  const Case *first = (const Case *) (void *) cases->data;
  gsize typical = first[known > 0 ? known / 2 : cases->len / 2].row;
  return (QnMechanismShare){
    .shape = like->shape,
    .kind = row_of (table, typical)->mechanism,
    .count = cases->len,
    .column = column,
    .range = { known > 0 ? first[0].multiplier : NAN,
               known > 0 ? first[known - 1].multiplier : NAN },
    .row = typical,
  };
}

const char *
qn_study_word (const char *name)
{
  QnOutcome outcome;
  QnMechanismKind kind;
  if (qn_find_word (name, qn_outcome_names, QN_OUTCOME_COUNT, &outcome))
    return qn_outcome_text (outcome, FALSE);
  if (qn_find_word (name, qn_mechanism_kind_names, QN_MECHANISM_KIND_COUNT, &kind))
    return qn_mechanism_kind_text (kind);
  return name;
}

char *
qn_mechanism_share_dup_name (const QnMechanismShare *share)
{
  const char *kind = qn_study_word (share->kind);
  if (share->shape == 0)
    return g_strdup (kind);
  if (kind == NULL)
    return g_strdup_printf (_ ("shape %u"), share->shape);
  return g_strdup_printf (_ ("shape %u, %s"), share->shape, kind);
}

GArray *
qn_table_dup_mechanisms (const QnTable *table, gsize *whole)
{
  GArray *shares = g_array_new (FALSE, FALSE, sizeof (QnMechanismShare));
  g_autoptr (GHashTable) kinds = g_hash_table_new (g_str_hash, g_str_equal);
  g_autoptr (GHashTable) shapes = g_hash_table_new (NULL, NULL);
  int column = qn_table_find (table, qn_study_output_names[QN_STUDY_COLLAPSE_MULTIPLIER]);
  if (column < 0)
    column =
      qn_table_find (table, qn_study_output_names[QN_STUDY_ASSOCIATIVE_MULTIPLIER]);
  *whole = 0;
  for (gsize i = 0; i < table->rows->len; i++) {
    const QnRow *row = row_of (table, i);
    if (row->mechanism == NULL && row->shape == 0)
      continue;
    (*whole)++;
    if (!(row->shape > 0 ? g_hash_table_add (shapes, GUINT_TO_POINTER (row->shape))
                         : g_hash_table_add (kinds, row->mechanism)))
      continue;
    QnMechanismShare share = describe_group (table, row, column);
    g_array_append_val (shares, share);
  }
  g_array_sort (shares, compare_shares);
  return shares;
}
