#include "study/report/table.h"

#include "io/text/file-writer.h"
#include "study/cases/folder.h"
#include "study/cases/shape.h"

#include <glib/gi18n-lib.h>
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
