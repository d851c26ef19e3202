/* Sparse matrix patterns in compressed columns. */
#pragma once

#include "core/base/memory.h"

/* Collects entries, repeated or not, of an n x n pattern. */
typedef struct QnSparsePattern {
  int32_t n;
  int32_t *rows, *columns; /* one allocation */
  size_t count, most;
  QnPool *pool; /* of the compressed pattern; lack of memory is told by it alone */
} QnSparsePattern;

/* An empty pattern with room for `most` entries, repeated ones included. */
void qn_sparse_pattern_init (QnSparsePattern *pattern, int32_t n, size_t most,
                             QnPool *pool);

/* Adds all entries between the given unknowns, skipping those that are QN_NONE. */
void qn_sparse_pattern_add_clique (QnSparsePattern *pattern, const int32_t *unknowns,
                                   int count);

/* Column pointers (n + 1) and sorted, unique row indices. Clears the pattern. */
void qn_sparse_pattern_compress (QnSparsePattern *pattern, int32_t **ap, int32_t **ai);

/* Position of entry (row, column) in the arrays of a compressed pattern, or QN_NONE where
 * either is QN_NONE or the entry is not in the pattern. */
int32_t qn_sparse_find (const int32_t *ap, const int32_t *ai, int32_t row,
                        int32_t column);

/* mirror[k]: where the transpose of entry k of a symmetric pattern stands. `next`: scratch of length n. */
void qn_sparse_mirror (int32_t n, const int32_t *ap, const int32_t *ai, int32_t *next,
                       int32_t *mirror);
