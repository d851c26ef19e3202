#include "core/linalg/sparse.h"

#include <cholmod.h>
#include <stdlib.h>
#include <string.h>

void
qn_sparse_pattern_init (QnSparsePattern *pattern, int32_t n, size_t most, QnPool *pool)
{
  *pattern = (QnSparsePattern){ .n = n, .most = most, .pool = pool };
  pattern->rows = qn_alloc (most, 2 * sizeof *pattern->rows);
  pattern->columns = pattern->rows != NULL ? pattern->rows + most : NULL;
  pool->failed |= pattern->rows == NULL;
}

void
qn_sparse_pattern_add_clique (QnSparsePattern *pattern, const int32_t *unknowns,
                              int count)
{
  for (int j = 0; j < count && !pattern->pool->failed; j++)
    for (int i = 0; i < count; i++)
      if (unknowns[i] != QN_NONE && unknowns[j] != QN_NONE) {
        QN_ASSERT (pattern->count < pattern->most);
        pattern->rows[pattern->count] = unknowns[i];
        pattern->columns[pattern->count++] = unknowns[j];
      }
}

void
qn_sparse_pattern_compress (QnSparsePattern *pattern, int32_t **ap, int32_t **ai)
{
  size_t n = (size_t) pattern->n;
  cholmod_common common;
  cholmod_triplet entries = { .nrow = n,
                              .ncol = n,
                              .nzmax = pattern->count,
                              .nnz = pattern->count,
                              .i = pattern->rows,
                              .j = pattern->columns,
                              .itype = CHOLMOD_INT,
                              .xtype = CHOLMOD_PATTERN };
  cholmod_sparse *sorted = NULL;

  cholmod_start (&common);
  common.print = 0;
  if (!pattern->pool->failed && pattern->count <= INT32_MAX)
    sorted = cholmod_triplet_to_sparse (&entries, 0, &common);
  *ap = sorted != NULL ? qn_pool_add (pattern->pool, sorted->p) : NULL;
  *ai = sorted != NULL ? qn_pool_add (pattern->pool, sorted->i) : NULL;
  pattern->pool->failed |= sorted == NULL;
  if (sorted != NULL)
    sorted->p = sorted->i = NULL;
  cholmod_free_sparse (&sorted, &common);
  cholmod_finish (&common);
  free (pattern->rows);
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
