#include "core/linalg/sparse.h"

#include <stdlib.h>
#include <string.h>

void
qn_sparse_pattern_init (QnSparsePattern *pattern, int32_t n, size_t expected,
                        QnPool *pool)
{
  *pattern = (QnSparsePattern){ .n = n, .capacity = expected, .pool = pool };
  pattern->entries = qn_alloc (expected, sizeof *pattern->entries);
  pool->failed |= pattern->entries == NULL;
}

void
qn_sparse_pattern_add_clique (QnSparsePattern *pattern, const int32_t *unknowns,
                              int count)
{
  size_t need = pattern->count + (size_t) (count * count);
  pattern->pool->failed |= !qn_array_reserve (&pattern->entries, &pattern->capacity, need,
                                              sizeof *pattern->entries);
  if (pattern->pool->failed)
    return;
  uint64_t *entries = pattern->entries;
  for (int j = 0; j < count; j++)
    for (int i = 0; i < count; i++)
      if (unknowns[i] != QN_NONE && unknowns[j] != QN_NONE)
        entries[pattern->count++] = (uint64_t) unknowns[j] << 32 | (uint64_t) unknowns[i];
}

/* Rows of one column are gathered by a counting sort over rows, then over columns, so that
 * the whole takes linear time: transposing twice sorts. */
static void
counting_sort (const uint64_t *in, uint64_t *out, size_t count, int shift,
               int32_t *starts, int32_t n)
{
  for (int32_t i = 0; i <= n; i++)
    starts[i] = 0;
  for (size_t k = 0; k < count; k++)
    starts[((in[k] >> shift) & UINT32_MAX) + 1]++;
  for (int32_t i = 0; i < n; i++)
    starts[i + 1] += starts[i];
  for (size_t k = 0; k < count; k++)
    out[starts[(in[k] >> shift) & UINT32_MAX]++] = in[k];
}

/* The sorted entries, each once, as columns. */
static void
take_columns (const QnSparsePattern *pattern, uint64_t *scratch, int32_t **ap,
              int32_t **ai)
{
  size_t n = (size_t) pattern->n, unique = 0;

  counting_sort (pattern->entries, scratch, pattern->count, 0, *ap, pattern->n);
  counting_sort (scratch, pattern->entries, pattern->count, 32, *ap, pattern->n);
  for (size_t k = 0; k < pattern->count; k++)
    if (k == 0 || pattern->entries[k] != pattern->entries[k - 1])
      pattern->entries[unique++] = pattern->entries[k];
  *ai = qn_pool_alloc (pattern->pool, unique, sizeof **ai);
  if (*ai == NULL)
    return;
  for (size_t i = 0; i <= n; i++)
    (*ap)[i] = 0;
  for (size_t k = 0; k < unique; k++) {
    (*ai)[k] = (int32_t) (pattern->entries[k] & UINT32_MAX);
    (*ap)[(pattern->entries[k] >> 32) + 1]++;
  }
  for (size_t i = 0; i < n; i++)
    (*ap)[i + 1] += (*ap)[i];
}

void
qn_sparse_pattern_compress (QnSparsePattern *pattern, int32_t **ap, int32_t **ai)
{
  uint64_t *scratch = qn_alloc (pattern->count, sizeof *scratch);

  *ap = qn_pool_alloc (pattern->pool, (size_t) pattern->n + 1, sizeof **ap);
  pattern->pool->failed |= scratch == NULL || pattern->count > INT32_MAX;
  if (!pattern->pool->failed)
    take_columns (pattern, scratch, ap, ai);
  free (scratch);
  free (pattern->entries);
}

int32_t
qn_sparse_find (const int32_t *ap, const int32_t *ai, int32_t row, int32_t column)
{
  if (row == QN_NONE || column == QN_NONE)
    return QN_NONE;

  int32_t low = ap[column], high = ap[column + 1];
  while (low < high) {
    int32_t middle = low + (high - low) / 2;
    if (ai[middle] < row)
      low = middle + 1;
    else
      high = middle;
  }
  return low < ap[column + 1] && ai[low] == row ? low : QN_NONE;
}

/* Columns are visited in order, and so are the entries of their rows. */
void
qn_sparse_mirror (int32_t n, const int32_t *ap, const int32_t *ai, int32_t *next,
                  int32_t *mirror)
{
  memcpy (next, ap, (size_t) n * sizeof *next);
  for (int32_t j = 0; j < n; j++)
    for (int32_t k = ap[j]; k < ap[j + 1]; k++)
      mirror[k] = next[ai[k]]++;
}
