#include "core/limit/interior-point-schur.h"

#include "core/base/clock.h"
#include "core/base/memory.h"

#include <stdlib.h>
#include <string.h>

/* Entries of a 6 x 6 matrix. */
#define GROUP_ENTRIES (QN_IP_GROUP_ROWS * QN_IP_GROUP_ROWS)

static int
compare_keys (const void *a, const void *b)
{
  int64_t x = *(const int64_t *) a, y = *(const int64_t *) b;
  return (x > y) - (x < y);
}

/* Key of an entry of M: column by column, rows ascending. */
static int64_t
entry_key (int32_t row, int32_t column, int32_t row_count)
{
  return (int64_t) column * row_count + row;
}

/* All entries of M in storage order, without duplicates. */
static int64_t *
list_entries (const QnIpProblem *p, size_t *count)
{
  size_t most = (size_t) p->group_count * GROUP_ENTRIES + (size_t) p->row_count;
  int64_t *keys = qn_alloc (most, sizeof *keys);
  size_t n = 0, unique = 0;

  if (!keys)
    return NULL;
  for (int32_t r = 0; r < p->row_count; r++)
    keys[n++] = entry_key (r, r, p->row_count);
  for (int32_t g = 0; g < p->group_count; g++) {
    const int32_t *rows = p->groups[g].rows;
    for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < QN_IP_GROUP_ROWS; j++)
        if (i != j && rows[i] >= 0 && rows[j] >= 0)
          keys[n++] = entry_key (rows[i], rows[j], p->row_count);
  }
  qsort (keys, n, sizeof *keys, compare_keys);
  for (size_t i = 0; i < n; i++)
    if (unique == 0 || keys[i] != keys[unique - 1])
      keys[unique++] = keys[i];
  *count = unique;
  return keys;
}

static int32_t
find_entry (const int64_t *keys, size_t count, int64_t key)
{
  const int64_t *found = bsearch (&key, keys, count, sizeof *keys, compare_keys);
  return (int32_t) (found - keys);
}

static void
fill_pattern (QnIpSchur *schur, const int64_t *keys, size_t count)
{
  const QnIpProblem *p = schur->problem;
  int32_t n = p->row_count;

  for (size_t e = 0; e < count; e++) {
    schur->rows[e] = (int32_t) (keys[e] % n);
    schur->columns[keys[e] / n + 1] = (int32_t) e + 1;
  }
  schur->columns[0] = 0;
  for (int32_t r = 0; r < n; r++)
    schur->diagonal[r] = find_entry (keys, count, entry_key (r, r, n));
  for (int32_t g = 0; g < p->group_count; g++) {
    const int32_t *at = p->groups[g].rows;
    int32_t *slots = schur->slots + (size_t) g * GROUP_ENTRIES;
    for (int i = 0, e = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j < QN_IP_GROUP_ROWS; j++, e++)
        slots[e] = at[i] < 0 || at[j] < 0
                     ? -1
                     : find_entry (keys, count, entry_key (at[i], at[j], n));
  }
}

QnStatus
qn_ip_schur_init (QnIpSchur *schur, const QnIpProblem *problem, QnDiag *diag)
{
  size_t n = (size_t) problem->row_count, count;

  *schur = (QnIpSchur){ .problem = problem };
  int64_t *keys = list_entries (problem, &count);
  if (keys == NULL)
    return qn_diag_no_memory (diag);
  schur->slots =
    qn_alloc ((size_t) problem->group_count * GROUP_ENTRIES, sizeof *schur->slots);
  schur->diagonal = qn_alloc (n, sizeof *schur->diagonal);
  schur->columns = qn_alloc (n + 1, sizeof *schur->columns);
  schur->rows = qn_alloc (count, sizeof *schur->rows);
  schur->values = qn_alloc (count, sizeof *schur->values);
  schur->right = qn_alloc (n, sizeof *schur->right);
  schur->solution = qn_alloc (n, sizeof *schur->solution);
  if (schur->slots && schur->diagonal && schur->columns && schur->rows && schur->values
      && schur->right && schur->solution) {
    fill_pattern (schur, keys, count);
    schur->lu = qn_block_lu_new (problem->row_count, schur->columns, schur->rows, NULL);
  }
  free (keys);
  return schur->lu != NULL ? QN_OK : qn_diag_no_memory (diag);
}

static void
scatter_group (QnIpSchur *schur, const double *compliance, int32_t g)
{
  const QnIpGroup *group = &schur->problem->groups[g];
  const int32_t *slots = schur->slots + (size_t) g * GROUP_ENTRIES;
  double sum[QN_IP_GROUP_ROWS][QN_IP_GROUP_ROWS] = { { 0 } };

  for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
    const double (*map)[2] = schur->problem->cells[c].map;
    const double *inverse = compliance + 3 * c;

    for (int i = 0; i < QN_IP_GROUP_ROWS; i++) {
      double n = map[i][0] * inverse[0] + map[i][1] * inverse[1];
      double t = map[i][0] * inverse[1] + map[i][1] * inverse[2];
      for (int j = 0; j <= i; j++)
        sum[i][j] += n * map[j][0] + t * map[j][1];
    }
  }
  for (int i = 0; i < QN_IP_GROUP_ROWS; i++)
    for (int j = 0; j < QN_IP_GROUP_ROWS; j++)
      if (slots[QN_IP_GROUP_ROWS * i + j] >= 0)
        schur->values[slots[QN_IP_GROUP_ROWS * i + j]] += i > j ? sum[i][j] : sum[j][i];
}

QnStatus
qn_ip_schur_factorize (QnIpSchur *schur, const double *compliance, double regularization,
                       bool *ok, QnDiag *diag)
{
  double start = qn_clock_seconds ();

  (void) diag;
  memset (schur->values, 0,
          (size_t) schur->columns[schur->problem->row_count] * sizeof *schur->values);
  for (int32_t r = 0; r < schur->problem->row_count; r++)
    schur->values[schur->diagonal[r]] = regularization;
  for (int32_t g = 0; g < schur->problem->group_count; g++)
    scatter_group (schur, compliance, g);
  *ok = qn_block_lu_factor (schur->lu, schur->values) > 0;
  schur->factorizations++;
  schur->seconds += qn_clock_seconds () - start;
  return QN_OK;
}

double *
qn_ip_schur_get_right (QnIpSchur *schur)
{
  return schur->right;
}

QnStatus
qn_ip_schur_solve (QnIpSchur *schur, const double **solution, QnDiag *diag)
{
  double start = qn_clock_seconds ();

  (void) diag;
  memcpy (schur->solution, schur->right,
          (size_t) schur->problem->row_count * sizeof *schur->solution);
  qn_block_lu_solve (schur->lu, schur->solution);
  schur->seconds += qn_clock_seconds () - start;
  *solution = schur->solution;
  return QN_OK;
}

void
qn_ip_schur_clear (QnIpSchur *schur)
{
  qn_block_lu_free (schur->lu);
  free (schur->columns);
  free (schur->rows);
  free (schur->values);
  free (schur->right);
  free (schur->solution);
  free (schur->slots);
  free (schur->diagonal);
  *schur = (QnIpSchur){ 0 };
}
