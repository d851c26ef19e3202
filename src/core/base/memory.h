/* Memory: thin, checked wrappers around the C allocator.
 *
 * Every function may fail and returns NULL or false then. The core never aborts when memory is
 * exhausted. Blocks are released with free().
 */
#pragma once

#include "core/base/base.h"

/* Zeroed memory for `count` items of `size` bytes; NULL on overflow or failure. A count of 0
 * gives a block that may be freed. */
void *qn_alloc (size_t count, size_t size);

/* The same, not zeroed, aligned to a cache line: no
 * SIMD vector lies in two lines. */
void *qn_alloc_lines (size_t count, size_t size);

/* Copy of a string, or NULL; NULL stays NULL. */
char *qn_strdup (const char *text);

/* Makes room in an array for at least `need` items of `size` bytes; `*capacity` is the number of
 * items it has room for and is updated. `array` is the address of the pointer to the items, which
 * may be NULL while *capacity is 0. New items are zeroed. False with nothing changed where there is
 * no memory.
 *
 *   if (!qn_array_reserve (&v->items, &v->capacity, n, sizeof *v->items))
 */
bool qn_array_reserve (void *array, size_t *capacity, size_t need, size_t size);

/* Appends a value to an array of `count` items; false with nothing changed where there is no memory. */
#define QN_ARRAY_PUSH(items, count, capacity, ...)                                       \
  (((count) < (capacity)                                                                 \
    || qn_array_reserve (&(items), &(capacity), (count) + 1, sizeof *(items)))           \
   && ((items)[(count)++] = __VA_ARGS__, true))

/* Allocations of one owner, freed together. A failed one sets `failed`: check it once, before their first
 * use. A zeroed pool is empty; a copy is the same pool. */
typedef struct QnPool {
  void **blocks;
  size_t count, capacity;
  bool failed;
} QnPool;

/* Adds an allocated block (NULL: the allocation failed), and returns it. */
void *qn_pool_add (QnPool *pool, void *block);

/* qn_alloc() and qn_alloc_lines() from a pool. */
void *qn_pool_alloc (QnPool *pool, size_t count, size_t size);
void *qn_pool_lines (QnPool *pool, size_t count, size_t size);

void qn_pool_clear (QnPool *pool);
