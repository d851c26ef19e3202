#include "core/interior-point-schur.h"

#include "core/clock.h"
#include "core/memory.h"

#include <stdlib.h>
#include <string.h>

/* Entries of the lower half of a 6 x 6 matrix. */
#define GROUP_ENTRIES (QN_IP_GROUP_ROWS * (QN_IP_GROUP_ROWS + 1) / 2)

/* Rows from which nested dissection is tried besides minimum degree: below, the search for the
 * order takes longer than it saves. */
#define LEAST_DISSECTED 3000

/* Operations per entry of the factor from which the supernodal factorisation is the faster one,
 * measured with the reference BLAS on walls of 1,800 (87) to 50,000 blocks. */
#define SUPERNODAL_SWITCH 250.0

static void
ignore_message (int status, const char *file, int line, const char *message)
{
  (void) status;
  (void) file;
  (void) line;
  (void) message;
}

static int
compare_keys (const void *a, const void *b)
{
  int64_t x = *(const int64_t *) a, y = *(const int64_t *) b;
  return (x > y) - (x < y);
}

/* Key of the entry of M that rows r and s share, column by column, rows ascending. */
static int64_t
entry_key (int32_t r, int32_t s, int32_t row_count)
{
  return r > s ? (int64_t) s * row_count + r : (int64_t) r * row_count + s;
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
      for (int j = 0; j < i; j++)
        if (rows[i] >= 0 && rows[j] >= 0)
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
  int *columns = schur->matrix->p, *rows = schur->matrix->i;

  for (size_t e = 0; e < count; e++) {
    rows[e] = (int) (keys[e] % p->row_count);
    columns[keys[e] / p->row_count + 1] = (int) e + 1;
  }
  columns[0] = 0;
  for (int32_t r = 0; r < p->row_count; r++)
    schur->diagonal[r] = columns[r];
  for (int32_t g = 0; g < p->group_count; g++) {
    const int32_t *at = p->groups[g].rows;
    int32_t *slots = schur->slots + (size_t) g * GROUP_ENTRIES;
    for (int i = 0, e = 0; i < QN_IP_GROUP_ROWS; i++)
      for (int j = 0; j <= i; j++, e++)
        slots[e] = at[i] < 0 || at[j] < 0
                     ? -1
                     : find_entry (keys, count, entry_key (at[i], at[j], p->row_count));
  }
}

/* The candidates for the order of elimination; CHOLMOD keeps the one with the least fill. */
static void
choose_methods (cholmod_common *c, int32_t row_count)
{
  c->nmethods = row_count >= LEAST_DISSECTED ? 2 : 1;
  c->method[0].ordering = CHOLMOD_AMD;
  c->method[1].ordering = CHOLMOD_NESDIS;
  c->supernodal = CHOLMOD_AUTO;
  c->supernodal_switch = SUPERNODAL_SWITCH;
  c->quick_return_if_not_posdef = 1;
}

static QnStatus
analyze (QnIpSchur *schur, QnDiag *diag)
{
  const QnIpProblem *p = schur->problem;
  cholmod_common *c = &schur->common;
  size_t count;
  int64_t *keys = list_entries (p, &count);

  if (!keys)
    return qn_diag_no_memory (diag);
  schur->matrix = cholmod_allocate_sparse ((size_t) p->row_count, (size_t) p->row_count,
                                           count, 1, 1, -1, CHOLMOD_REAL, c);
  schur->right = cholmod_zeros ((size_t) p->row_count, 1, CHOLMOD_REAL, c);
  if (schur->matrix && schur->right) {
    fill_pattern (schur, keys, count);
    schur->factor = cholmod_analyze (schur->matrix, c);
  }
  free (keys);
  return schur->factor ? QN_OK : qn_diag_no_memory (diag);
}

QnStatus
qn_ip_schur_init (QnIpSchur *schur, const QnIpProblem *problem, QnDiag *diag)
{
  *schur = (QnIpSchur){ .problem = problem };
  cholmod_start (&schur->common);
  schur->started = true;
  schur->common.print = 0;
  schur->common.error_handler = ignore_message;
  choose_methods (&schur->common, problem->row_count);
  schur->slots =
    qn_alloc ((size_t) problem->group_count * GROUP_ENTRIES, sizeof (int32_t));
  schur->diagonal = qn_alloc ((size_t) problem->row_count, sizeof (int32_t));
  if (!schur->slots || !schur->diagonal)
    return qn_diag_no_memory (diag);
  return analyze (schur, diag);
}

static void
scatter_group (QnIpSchur *schur, const double *compliance, int32_t g)
{
  const QnIpGroup *group = &schur->problem->groups[g];
  const int32_t *slots = schur->slots + (size_t) g * GROUP_ENTRIES;
  double sum[GROUP_ENTRIES] = { 0 };
  double *values = schur->matrix->x;

  for (int32_t c = group->first_cell; c < group->first_cell + group->cell_count; c++) {
    const double (*map)[2] = schur->problem->cells[c].map;
    const double *inverse = compliance + 3 * c;

    for (int i = 0, e = 0; i < QN_IP_GROUP_ROWS; i++) {
      double n = map[i][0] * inverse[0] + map[i][1] * inverse[1];
      double t = map[i][0] * inverse[1] + map[i][1] * inverse[2];
      for (int j = 0; j <= i; j++, e++)
        sum[e] += n * map[j][0] + t * map[j][1];
    }
  }
  for (int e = 0; e < GROUP_ENTRIES; e++)
    if (slots[e] >= 0)
      values[slots[e]] += sum[e];
}

QnStatus
qn_ip_schur_factorize (QnIpSchur *schur, const double *compliance, double regularization,
                       bool *ok, QnDiag *diag)
{
  double *values = schur->matrix->x, start = qn_clock_seconds ();

  memset (values, 0, schur->matrix->nzmax * sizeof (double));
  for (int32_t r = 0; r < schur->problem->row_count; r++)
    values[schur->diagonal[r]] = regularization;
  for (int32_t g = 0; g < schur->problem->group_count; g++)
    scatter_group (schur, compliance, g);
  cholmod_factorize (schur->matrix, schur->factor, &schur->common);
  schur->factorizations++;
  schur->seconds += qn_clock_seconds () - start;
  if (schur->common.status == CHOLMOD_OUT_OF_MEMORY)
    return qn_diag_no_memory (diag);
  *ok = schur->common.status == CHOLMOD_OK && schur->factor->minor == schur->factor->n;
  return QN_OK;
}

double *
qn_ip_schur_get_right (QnIpSchur *schur)
{
  return schur->right->x;
}

QnStatus
qn_ip_schur_solve (QnIpSchur *schur, const double **solution, QnDiag *diag)
{
  double start = qn_clock_seconds ();
  bool ok =
    cholmod_solve2 (CHOLMOD_A, schur->factor, schur->right, NULL, &schur->solution, NULL,
                    &schur->work_y, &schur->work_e, &schur->common);

  schur->seconds += qn_clock_seconds () - start;
  if (!ok)
    return qn_diag_no_memory (diag);
  *solution = schur->solution->x;
  return QN_OK;
}

void
qn_ip_schur_clear (QnIpSchur *schur)
{
  if (schur->started) {
    cholmod_free_dense (&schur->work_e, &schur->common);
    cholmod_free_dense (&schur->work_y, &schur->common);
    cholmod_free_dense (&schur->solution, &schur->common);
    cholmod_free_dense (&schur->right, &schur->common);
    cholmod_free_factor (&schur->factor, &schur->common);
    cholmod_free_sparse (&schur->matrix, &schur->common);
    cholmod_finish (&schur->common);
  }
  free (schur->slots);
  free (schur->diagonal);
  *schur = (QnIpSchur){ 0 };
}
